#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <lessons/exercises/http_desk.hpp>
#include <lessons/exercises/http_server.hpp>
#include <memory>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace rederive::classroom {
namespace {

using Clock = std::chrono::steady_clock;
using ConnectionNumber = unsigned long;

enum class Stage {
  request,   ///< bytes of the request are awaited
  answer,    ///< the request is complete and waits for its answer
  response,  ///< the response is being sent
  rest       ///< it has been sent; what the client still sends is thrown away, or it might lose the response
};

struct Connection {
  OwnedDescriptor socket;
  in_addr_t client;
  Clock::time_point deadline;  ///< of the stage; none for an answer
  Stage stage = Stage::request;
  std::string received = {};
  std::optional<HttpRequest> request = {};  ///< once its head is there
  std::string response = {};
  std::size_t sent = 0;
};

class Connections {
 public:
  Connections(int listener, int end, const HttpHandlers& handlers, const HttpCeilings& ceilings)
      : listener_(listener), end_(end), handlers_(handlers), ceilings_(ceilings) {
    desk_->answer = handlers.answer;
    if (desk_->answered.get() < 0) throw std::system_error(errno, std::generic_category(), "eventfd");
    thread_ = std::thread([desk = desk_] { desk->answer_all(); });
  }
  ~Connections() { (void)close_desk(); }

  bool serve() {
    while (!is_over()) wait_and_go_on();
    return close_desk();
  }

 private:
  /// Ends the thread that answers. Returns false if it is at work: then it goes on, and ends with the
  /// program.
  bool close_desk() {
    std::unique_lock lock(desk_->mutex);
    desk_->is_closed = true;
    desk_->asked.notify_all();
    const bool is_busy = desk_->is_busy;
    lock.unlock();
    if (thread_.joinable()) is_busy ? thread_.detach() : thread_.join();
    return !is_busy;
  }

  using Entry = std::map<ConnectionNumber, Connection>::iterator;

  bool is_ending() const { return last_.has_value(); }
  bool is_over() const { return is_ending() && (connections_.empty() || Clock::now() >= *last_); }

  /// Waits until something can be done or a deadline passes, and does what can be done.
  void wait_and_go_on() {
    constexpr short in = POLLIN, out = POLLOUT;
    std::vector<pollfd> descriptors{{is_ending() ? -1 : end_, in, 0},
                                    {desk_->answered.get(), in, 0},
                                    {Clock::now() < accept_from_ ? -1 : listener_.get(), in, 0}};
    std::vector<ConnectionNumber> numbers;
    for (const auto& [number, connection] : connections_) {
      const bool waits = connection.stage == Stage::answer;
      descriptors.push_back(
          {waits ? -1 : connection.socket.get(), connection.stage == Stage::response ? out : in, 0});
      numbers.push_back(number);
    }
    ::poll(descriptors.data(), descriptors.size(), milliseconds_to_deadline());
    if (descriptors[0].revents != 0) begin_to_end();
    if (descriptors[1].revents != 0) take_responses();
    for (std::size_t i = 0; i < numbers.size(); ++i)
      if (const Entry entry = connections_.find(numbers[i]); entry != connections_.end())
        if (descriptors[i + 3].revents != 0) go_on(entry);
    end_the_late();
    if (descriptors[2].revents != 0 && !is_ending()) accept_some();
  }

  int milliseconds_to_deadline() const {
    auto first = last_.value_or(Clock::now() + std::chrono::hours(1));
    if (accept_from_ > Clock::now()) first = std::min(first, accept_from_);
    for (const auto& [number, connection] : connections_)
      if (connection.stage != Stage::answer) first = std::min(first, connection.deadline);
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(first - Clock::now()).count();
    return static_cast<int>(std::max<decltype(left)>(left, 0));
  }

  void begin_to_end() {
    last_ = Clock::now() + ceilings_.grace;
    listener_.close();
    std::erase_if(connections_, [](const auto& entry) { return entry.second.stage == Stage::request; });
  }

  /// Accepts a few connections. Between two calls, those that were accepted before are read.
  void accept_some() {
    for (int i = 0; i < 16; ++i) {
      sockaddr_in from{};
      socklen_t size = sizeof from;
      OwnedDescriptor socket(::accept4(listener_.get(), reinterpret_cast<sockaddr*>(&from), &size,
                                       SOCK_NONBLOCK | SOCK_CLOEXEC));
      if (socket.get() < 0 && (errno == EAGAIN || errno == ECONNABORTED || errno == EINTR)) return;
      if (socket.get() < 0) {  // no descriptor, no memory
        end_one_of(client_with_most());
        accept_from_ = Clock::now() + std::chrono::milliseconds(20);
        return;
      }
      const in_addr_t client = from.sin_addr.s_addr;
      if (connections_of(client) >= ceilings_.of_client && !end_one_of(client)) continue;
      if (connections_.size() >= ceilings_.connections && !end_one_of(client_with_most())) continue;
      const auto [entry, is_new] = connections_.emplace(
          ++newest_, Connection{std::move(socket), client, Clock::now() + ceilings_.request});
      read_request(entry);  // its first bytes are often there already
    }
  }

  std::size_t connections_of(in_addr_t client) const {
    return static_cast<std::size_t>(std::ranges::count_if(
        connections_, [&](const auto& entry) { return entry.second.client == client; }));
  }

  in_addr_t client_with_most() const {
    std::map<in_addr_t, std::size_t> counts;
    for (const auto& [number, connection] : connections_) ++counts[connection.client];
    const auto most = std::ranges::max_element(
        counts, [](const auto& one, const auto& other) { return one.second < other.second; });
    return most == counts.end() ? 0 : most->first;
  }

  /// Ends the oldest connection of a client that has not sent its request, else one that has, or is getting,
  /// its response. Returns false if all wait for their answers.
  bool end_one_of(in_addr_t client) {
    for (const Stage stage : {Stage::request, Stage::rest, Stage::response})
      for (auto entry = connections_.begin(); entry != connections_.end(); ++entry)
        if (entry->second.client == client && entry->second.stage == stage) return drop(entry), true;
    return false;
  }

  void drop(Entry entry) {
    ::shutdown(entry->second.socket.get(), SHUT_RDWR);  // for the client, although a child may share it
    connections_.erase(entry);
  }

  void end_the_late() {
    const auto now = Clock::now();
    for (auto next = connections_.begin(); next != connections_.end();) {
      const Entry entry = next++;
      const Connection& connection = entry->second;
      if (connection.stage == Stage::answer || now < connection.deadline) continue;
      if (connection.stage == Stage::request && !connection.received.empty())
        respond(entry, refusal({408, "The request took too long."}));
      else
        drop(entry);
    }
  }

  void go_on(Entry entry) {
    switch (entry->second.stage) {
      case Stage::request:
        return read_request(entry);
      case Stage::answer:
        return;
      case Stage::response:
        return send_response(entry);
      case Stage::rest:
        return throw_away(entry);
    }
  }

  void read_request(Entry entry) {
    Connection& connection = entry->second;
    char some[4096];
    const ssize_t count = ::recv(connection.socket.get(), some, sizeof some, 0);
    if (count < 0 && (errno == EAGAIN || errno == EINTR)) return;
    if (count <= 0) return drop(entry);
    const std::size_t before = connection.received.size();
    connection.received.append(some, static_cast<std::size_t>(count));
    try {
      if (!connection.request) read_head(connection, before);
      if (connection.request) ask_when_complete(entry);
    } catch (const HttpRefusal& refused) {
      respond(entry, refusal(refused));
    }
  }

  void read_head(Connection& connection, std::size_t before) {
    connection.request = head_of(connection.received, before);
    if (!connection.request) return;
    const HttpRequest& request = *connection.request;
    handlers_.guard(request);
    if (!request.headers.contains("expect")) return;
    constexpr std::string_view go_on = "HTTP/1.1 100 Continue\r\n\r\n";
    if (request.only("expect") != "100-continue")
      throw HttpRefusal(417, "Only Expect: 100-continue is accepted.");
    if (connection.received.size() < request.head_bytes + request.body_bytes)
      (void)::send(connection.socket.get(), go_on.data(), go_on.size(), MSG_NOSIGNAL);
  }

  /// Passes the request on once its body is there. What follows the body is not read.
  void ask_when_complete(Entry entry) {
    Connection& connection = entry->second;
    HttpRequest& request = *connection.request;
    if (connection.received.size() < request.head_bytes + request.body_bytes) return;
    if (waiting_ >= ceilings_.requests) throw HttpRefusal(503, "There are too many requests at the moment.");
    request.body = connection.received.substr(request.head_bytes, request.body_bytes);
    connection.received = std::string();
    connection.stage = Stage::answer;
    ++waiting_;
    const std::lock_guard lock(desk_->mutex);
    desk_->requests.emplace_back(entry->first, request);
    desk_->asked.notify_one();
  }

  void take_responses() {
    eventfd_t ignored = 0;
    ::eventfd_read(desk_->answered.get(), &ignored);
    std::unique_lock lock(desk_->mutex);
    const auto responses = std::exchange(desk_->responses, {});
    lock.unlock();
    waiting_ -= responses.size();
    for (const auto& [number, response] : responses)
      if (const Entry entry = connections_.find(number); entry != connections_.end())
        respond(entry, response);
  }

  void respond(Entry entry, const HttpResponse& response) {
    Connection& connection = entry->second;
    connection.response = text_of(response, connection.request ? connection.request->method : "");
    connection.stage = Stage::response;
    connection.deadline = Clock::now() + ceilings_.response;
    send_response(entry);
  }

  void send_response(Entry entry) {
    Connection& connection = entry->second;
    while (connection.sent < connection.response.size()) {
      const ssize_t count = ::send(connection.socket.get(), connection.response.data() + connection.sent,
                                   connection.response.size() - connection.sent, MSG_NOSIGNAL);
      if (count < 0 && errno == EINTR) continue;
      if (count < 0 && errno == EAGAIN) return;
      if (count < 0) return drop(entry);
      connection.sent += static_cast<std::size_t>(count);
    }
    ::shutdown(connection.socket.get(), SHUT_WR);
    connection.response = std::string();
    connection.stage = Stage::rest;
    connection.deadline = Clock::now() + ceilings_.rest;
    throw_away(entry);
  }

  void throw_away(Entry entry) {
    char some[65536];
    const ssize_t count = ::recv(entry->second.socket.get(), some, sizeof some, 0);
    if (count == 0 || (count < 0 && errno != EAGAIN && errno != EINTR)) drop(entry);
  }

  OwnedDescriptor listener_;
  int end_;
  const HttpHandlers& handlers_;
  HttpCeilings ceilings_;
  std::shared_ptr<HttpDesk> desk_ = std::make_shared<HttpDesk>();
  std::thread thread_;
  std::size_t waiting_ = 0;  // requests without an answer, the one at work included
  std::map<ConnectionNumber, Connection> connections_;  // the oldest first
  ConnectionNumber newest_ = 0;
  Clock::time_point accept_from_{};
  std::optional<Clock::time_point> last_;  // of an end that has begun: when it is over
};

}  // namespace

bool serve_http(int listener, int end, const HttpHandlers& handlers, const HttpCeilings& ceilings) {
  return Connections(listener, end, handlers, ceilings).serve();
}

}  // namespace rederive::classroom
