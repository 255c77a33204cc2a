// What connections can do to a server, and what they cannot. No check here is by the clock: where a ceiling
// is a time, it is an hour in the tests in which it must not be met, and short where the end is waited for.
#include <arpa/inet.h>
#include <doctest/doctest.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <future>
#include <lessons/exercises/http_server.hpp>
#include <list>
#include <tests/run_program.hpp>

using namespace rederive::classroom;
using namespace std::chrono_literals;

namespace {

HttpCeilings for_hours() { return {.request = 1h, .response = 1h, .rest = 1h, .grace = 1h}; }

/// A server in this process. Its answers are "METHOD PATH BODY"; paths that begin with /no are not let in.
class LocalServer {
 public:
  explicit LocalServer(const HttpCeilings& ceilings, std::function<void()> work = {}) {
    REQUIRE(::pipe2(ends_, O_CLOEXEC | O_NONBLOCK) == 0);
    const int listener = ::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    address_.sin_family = AF_INET;
    address_.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address_;
    const auto at = reinterpret_cast<sockaddr*>(&address_);
    REQUIRE(::bind(listener, at, size) == 0);
    REQUIRE(::getsockname(listener, at, &size) == 0);
    REQUIRE(::listen(listener, SOMAXCONN) == 0);
    handlers_.guard = [](const HttpRequest& request) {
      if (request.path.starts_with("/no")) throw HttpRefusal(403, "not here");
    };
    handlers_.answer = [work = std::move(work)](const HttpRequest& request) {
      if (work) work();
      if (request.path == "/large") return HttpResponse{200, "text/plain", std::string(20'000'000, 'x')};
      return HttpResponse{200, "text/plain", request.method + " " + request.path + " " + request.body};
    };
    ended_ = std::async(std::launch::async, [this, listener, ceilings] {
      return serve_http(listener, ends_[0], handlers_, ceilings);
    });
  }
  ~LocalServer() {
    tell_to_end();
    ended_.wait();
    for (const int end : ends_) ::close(end);
  }
  void tell_to_end() { (void)!::write(ends_[1], "x", 1); }
  bool has_ended() const { return ended_.wait_for(0s) == std::future_status::ready; }
  bool end() {
    tell_to_end();
    ended_.wait();
    return ended_.get();
  }
  const sockaddr_in& address() const { return address_; }

 private:
  HttpHandlers handlers_;
  sockaddr_in address_{};
  int ends_[2];
  std::shared_future<bool> ended_;
};

class Client {
 public:
  explicit Client(const LocalServer& server, const std::string& text = "", const char* from = "127.0.0.1") {
    socket_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in here{};
    here.sin_family = AF_INET;
    ::inet_pton(AF_INET, from, &here.sin_addr);
    REQUIRE(::bind(socket_, reinterpret_cast<sockaddr*>(&here), sizeof here) == 0);
    REQUIRE(::connect(socket_, reinterpret_cast<const sockaddr*>(&server.address()), sizeof(sockaddr_in)) ==
            0);
    say(text);
  }
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;
  ~Client() { ::close(socket_); }

  bool say(const std::string& text) {
    for (std::size_t sent = 0; sent < text.size();) {
      const ssize_t n = ::send(socket_, text.data() + sent, text.size() - sent, MSG_NOSIGNAL);
      if (n <= 0) return false;
      sent += static_cast<std::size_t>(n);
    }
    return true;
  }
  void say_no_more() { ::shutdown(socket_, SHUT_WR); }
  /// All that comes until the server ends the connection, or has said `until`.
  std::string hear(const std::string& until = "") {
    std::string text;
    char some[65536];
    for (ssize_t n;
         (until.empty() || !contains(text, until)) && (n = ::recv(socket_, some, sizeof some, 0)) > 0;)
      text.append(some, static_cast<std::size_t>(n));
    return text;
  }
  /// Whether the server has neither said anything nor ended the connection.
  bool is_waiting() const {
    pollfd ready{socket_, POLLIN, 0};
    return ::poll(&ready, 1, 0) == 0;
  }
  void receive_little() {
    const int small = 4096;
    ::setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, &small, sizeof small);
  }

 private:
  int socket_;
};

std::string get(const std::string& path) { return "GET " + path + " HTTP/1.1\r\nHost: here\r\n\r\n"; }

int status_of(const std::string& response) {
  return response.starts_with("HTTP/1.1 ") ? std::stoi(response.substr(9, 3)) : 0;
}

}  // namespace

TEST_CASE("one request is answered, and what comes behind it is not") {
  LocalServer server(for_hours());
  CHECK(Client(server, get("/a")).hear().ends_with("\r\n\r\nGET /a "));
  CHECK(Client(server, "GET /a HTTP/1.0\r\n\r\n").hear().ends_with("\r\n\r\nGET /a "));
  CHECK(Client(server, "HEAD /a HTTP/1.1\r\n\r\n").hear().ends_with("\r\n\r\n"));
  const std::string post = "POST /a HTTP/1.1\r\nContent-Length: 3\r\n\r\n";
  CHECK(Client(server, post + "abcdef").hear().ends_with("\r\n\r\nPOST /a abc"));
  CHECK(Client(server, get("/a") + get("/b") + get("/c")).hear().ends_with("\r\n\r\nGET /a "));
  CHECK(Client(server, "GET /a HTTP/1.1\r\nConnection: keep-alive\r\n\r\n").hear().ends_with("GET /a "));
  Client by_bytes(server);
  for (const char c : post + "abc") CHECK(by_bytes.say(std::string(1, c)));
  CHECK(by_bytes.hear().ends_with("POST /a abc"));
}

TEST_CASE("who says no more is answered, if the request is complete") {
  LocalServer server(for_hours());
  Client whole(server, get("/a")), half(server, "GET /a HTTP"), silent(server);
  for (Client* client : {&whole, &half, &silent}) client->say_no_more();
  CHECK(whole.hear().ends_with("GET /a "));
  CHECK(half.hear().empty());
  CHECK(silent.hear().empty());
}

TEST_CASE("a request is refused by its head, before its body is there") {
  LocalServer server(for_hours());
  const auto status = [&](const std::string& head) {
    return status_of(Client(server, "POST " + head + "\r\n\r\n").hear());
  };
  CHECK(status("/no HTTP/1.1\r\nContent-Length: 10") == 403);
  CHECK(status("/ HTTP/1.1\r\nContent-Length: 65537") == 413);
  CHECK(status("/ HTTP/1.1\r\nTransfer-Encoding: chunked") == 411);
  CHECK(status("/ HTTP/1.1\r\nContent-Encoding: gzip\r\nContent-Length: 10") == 415);
  CHECK(status("/ HTTP/1.1\r\nExpect: a-wonder\r\nContent-Length: 10") == 417);
  CHECK(status_of(Client(server, std::string(20'000, 'a')).hear()) == 431);
  CHECK(status_of(Client(server, "GET / HTTP/1.1\n").hear()) == 400);
}

TEST_CASE("who asks before the body is told to go on") {
  LocalServer server(for_hours());
  Client client(server, "POST /a HTTP/1.1\r\nExpect: 100-continue\r\nContent-Length: 3\r\n\r\n");
  CHECK(client.hear("\r\n\r\n") == "HTTP/1.1 100 Continue\r\n\r\n");
  client.say("abc");
  CHECK(client.hear().ends_with("POST /a abc"));
}

TEST_CASE("a client hears the refusal although it goes on sending, and cannot send for ever") {
  LocalServer server({.request = 1h, .response = 1h, .rest = 200ms});
  CHECK(status_of(Client(server, "POST / HTTP/1.1\r\nContent-Length: 70000\r\n\r\n" + std::string(70000, 'x'))
                      .hear()) == 413);
  Client endless(server, "GET / HTTP/1.1\r\n");
  const std::string line = "x: " + std::string(100'000, 'a') + "\r\n";
  while (endless.say(line)) continue;  // until the server has had enough
}

TEST_CASE("silent and dripping connections end with the time for a request, and keep nobody waiting") {
  LocalServer server({.request = 300ms});
  Client silent(server), dripping(server, "GET");
  CHECK(silent.hear().empty());
  CHECK(status_of(dripping.hear()) == 408);
  Client body(server, "POST / HTTP/1.1\r\nContent-Length: 10\r\n\r\nabc");
  CHECK(status_of(body.hear()) == 408);
}

TEST_CASE("300 silent or dripping connections: a page comes, and the oldest of them have ended") {
  HttpCeilings ceilings = for_hours();
  ceilings.of_client = 64;
  LocalServer server(ceilings);
  std::list<Client> slow;
  for (int k = 0; k < 300; ++k) slow.emplace_back(server, k % 2 == 0 ? "" : "GET /sl");
  for (int k = 0; k < 20; ++k) CHECK(Client(server, get("/a")).hear().ends_with("GET /a "));
  CHECK(slow.back().is_waiting());
  CHECK(slow.front().hear().empty());
  CHECK(std::count_if(slow.begin(), slow.end(), [](const Client& client) { return client.is_waiting(); }) <=
        64);
}

TEST_CASE("one client cannot have another's connections ended") {
  HttpCeilings ceilings = for_hours();
  ceilings.of_client = 20, ceilings.connections = 30;
  LocalServer server(ceilings);
  Client other(server, "GET /oth", "127.0.0.2");
  std::list<Client> many;
  for (int k = 0; k < 100; ++k) many.emplace_back(server, "GET");
  for (int k = 0; k < 15; ++k) many.emplace_back(server, "GET", "127.0.0.3");
  CHECK(Client(server, get("/a")).hear().ends_with("GET /a "));
  other.say("er HTTP/1.1\r\n\r\n");
  CHECK(other.hear().ends_with("GET /other "));
}

TEST_CASE("who does not take the response does not keep others waiting, and is given up") {
  HttpCeilings ceilings = for_hours();
  SUBCASE("others are served") {
    LocalServer server(ceilings);
    Client slow(server);
    slow.receive_little();
    slow.say(get("/large"));
    CHECK(contains(slow.hear("HTTP"), "HTTP"));
    CHECK(Client(server, get("/a")).hear().ends_with("GET /a "));
  }
  SUBCASE("it is given up: else the server would not end") {
    ceilings.response = 100ms;
    LocalServer server(ceilings);
    Client slow(server);
    slow.receive_little();
    slow.say(get("/large"));
    CHECK(contains(slow.hear("HTTP"), "HTTP"));
    CHECK(server.end());
  }
}

TEST_CASE(
    "as many requests wait as may, others are told to come again, and the guard's refusals do not count") {
  std::promise<void> gate;
  const std::shared_future<void> opened = gate.get_future().share();
  HttpCeilings ceilings = for_hours();
  ceilings.requests = 3;
  LocalServer server(ceilings, [opened] { opened.wait(); });
  std::list<Client> waiting;
  for (int k = 0; k < 3; ++k) waiting.emplace_back(server, get("/a"));
  CHECK(status_of(Client(server, get("/no")).hear()) == 403);
  CHECK(status_of(Client(server, get("/b")).hear()) == 503);
  gate.set_value();
  for (Client& client : waiting) CHECK(client.hear().ends_with("GET /a "));
  CHECK(Client(server, get("/b")).hear().ends_with("GET /b "));
}

TEST_CASE("told to end, it finishes what was asked, and waits for nobody who has not asked") {
  std::promise<void> gate, begun;
  const std::shared_future<void> opened = gate.get_future().share();
  LocalServer server(for_hours(), [&begun, opened] {
    begun.set_value();
    opened.wait();
  });
  Client silent(server), dripping(server, "GET /a"), asked(server, get("/a"));
  begun.get_future().wait();
  server.tell_to_end();
  CHECK(silent.hear().empty());
  CHECK(dripping.hear().empty());
  CHECK_FALSE(server.has_ended());
  gate.set_value();
  CHECK(asked.hear().ends_with("GET /a "));
  asked.say_no_more();
  CHECK(server.end());
}

TEST_CASE("after the time of grace it ends, whatever is at work or is not taken") {
  HttpCeilings ceilings = for_hours();
  ceilings.grace = 50ms;
  SUBCASE("an answer is at work") {
    auto gate = std::make_shared<std::promise<void>>(), done = std::make_shared<std::promise<void>>();
    auto begun = std::make_shared<std::promise<void>>();
    {
      LocalServer server(ceilings, [gate, begun, done] {
        begun->set_value();
        gate->get_future().wait();
        done->set_value();
      });
      Client asked(server, get("/a"));
      begun->get_future().wait();
      CHECK_FALSE(server.end());
      CHECK(asked.hear().empty());
      gate->set_value();
      done->get_future().wait();
    }
  }
  SUBCASE("a response is not taken") {
    LocalServer server(ceilings);
    Client slow(server);
    slow.receive_little();
    slow.say(get("/large"));
    CHECK(contains(slow.hear("HTTP"), "HTTP"));
    CHECK(server.end());
  }
}
