// What the thread of http_server.cpp that owns the connections shares with the one that answers.
#pragma once

#include <sys/eventfd.h>
#include <unistd.h>

#include <condition_variable>
#include <deque>
#include <functional>
#include <lessons/exercises/http_message.hpp>
#include <mutex>
#include <utility>
#include <vector>

namespace rederive::classroom {

/// A descriptor that is closed with its owner.
class OwnedDescriptor {
 public:
  explicit OwnedDescriptor(int descriptor) : descriptor_(descriptor) {}
  OwnedDescriptor(OwnedDescriptor&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
  OwnedDescriptor& operator=(OwnedDescriptor&&) = delete;
  ~OwnedDescriptor() { close(); }

  int get() const { return descriptor_; }
  void close() {
    if (descriptor_ >= 0) ::close(descriptor_);
    descriptor_ = -1;
  }

 private:
  int descriptor_;
};

/// Returns the response that says in a line of text why there is no other.
inline HttpResponse refusal(const HttpRefusal& refused) {
  return {refused.status, "text/plain; charset=utf-8", refused.what() + std::string("\n")};
}

/// Requests that wait for their answer, and the answers. Shared by the thread that owns the connections and
/// by the one that answers, which may outlive it.
struct HttpDesk {
  std::function<HttpResponse(const HttpRequest&)> answer;
  OwnedDescriptor answered{::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)};  ///< can be read if there are responses
  std::mutex mutex;
  std::condition_variable asked;
  std::deque<std::pair<unsigned long, HttpRequest>> requests;
  std::vector<std::pair<unsigned long, HttpResponse>> responses;
  bool is_busy = false;    ///< a request is at work
  bool is_closed = false;  ///< no request is taken any more

  HttpResponse response_to(const HttpRequest& request) const {
    try {
      return answer(request);
    } catch (const HttpRefusal& refused) {
      return refusal(refused);
    } catch (const std::exception& error) {
      return refusal({500, error.what()});
    }
  }

  void answer_all() {
    std::unique_lock lock(mutex);
    for (;;) {
      asked.wait(lock, [&] { return is_closed || !requests.empty(); });
      if (is_closed) return;
      const auto [number, request] = std::move(requests.front());
      requests.pop_front();
      is_busy = true;
      lock.unlock();
      HttpResponse response = response_to(request);
      lock.lock();
      is_busy = false;
      responses.emplace_back(number, std::move(response));
      ::eventfd_write(answered.get(), 1);
    }
  }
};

}  // namespace rederive::classroom
