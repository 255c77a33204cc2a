// A thread that answers requests, one after another, while another waits for more.
#pragma once

#include <unistd.h>

#include <functional>
#include <lessons/exercises/http_message.hpp>
#include <memory>
#include <thread>
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

/// The response that says in a line of text why there is no other.
HttpResponse refusal(int status, const std::string& why);

class HttpDesk {
 public:
  /// Starts the thread, in which `answer` is called; what it throws becomes a refusal. Throws
  /// std::system_error if the system has no thread or no descriptor.
  explicit HttpDesk(std::function<HttpResponse(const HttpRequest&)> answer);
  ~HttpDesk();

  /// Requests that wait for their responses, the one at work included.
  std::size_t count() const { return count_; }
  void ask(unsigned long number, HttpRequest request);
  /// Can be read when there are responses.
  int descriptor() const;
  /// The responses that are there, each with the number of its request.
  std::vector<std::pair<unsigned long, HttpResponse>> responses();
  /// Ends the thread. False if it is at work: it goes on, and ends with the program.
  bool end();

 private:
  struct Shared;  // with the thread, which may outlive this
  std::shared_ptr<Shared> shared_;
  std::thread thread_;
  std::size_t count_ = 0;
};

}  // namespace rederive::classroom
