#include <sys/eventfd.h>

#include <cerrno>
#include <condition_variable>
#include <deque>
#include <lessons/exercises/http_desk.hpp>
#include <mutex>
#include <system_error>

namespace rederive::classroom {

HttpResponse refusal(int status, const std::string& why) {
  return {status, "text/plain; charset=utf-8", why + "\n"};
}

struct HttpDesk::Shared {
  std::function<HttpResponse(const HttpRequest&)> answer;
  OwnedDescriptor answered{::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)};
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
      return refusal(refused.status, refused.what());
    } catch (const std::exception& error) {
      return refusal(500, error.what());
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

HttpDesk::HttpDesk(std::function<HttpResponse(const HttpRequest&)> answer)
    : shared_(std::make_shared<Shared>()) {
  shared_->answer = std::move(answer);
  if (shared_->answered.get() < 0) throw std::system_error(errno, std::generic_category(), "eventfd");
  thread_ = std::thread([shared = shared_] { shared->answer_all(); });
}

HttpDesk::~HttpDesk() { (void)end(); }

int HttpDesk::descriptor() const { return shared_->answered.get(); }

void HttpDesk::ask(unsigned long number, HttpRequest request) {
  const std::lock_guard lock(shared_->mutex);
  shared_->requests.emplace_back(number, std::move(request));
  shared_->asked.notify_one();
  ++count_;
}

std::vector<std::pair<unsigned long, HttpResponse>> HttpDesk::responses() {
  eventfd_t ignored = 0;
  ::eventfd_read(shared_->answered.get(), &ignored);
  const std::lock_guard lock(shared_->mutex);
  count_ -= shared_->responses.size();
  return std::exchange(shared_->responses, {});
}

bool HttpDesk::end() {
  std::unique_lock lock(shared_->mutex);
  shared_->is_closed = true;
  shared_->asked.notify_all();
  const bool is_busy = shared_->is_busy;
  lock.unlock();
  if (thread_.joinable()) is_busy ? thread_.detach() : thread_.join();
  return !is_busy;
}

}  // namespace rederive::classroom
