// What of HTTP is read, and what is refused: by the head of a request alone.
#include <doctest/doctest.h>

#include <lessons/exercises/http_message.hpp>
#include <random>

using namespace rederive::classroom;

namespace {

/// The status with which a head is refused; 0 if it is read, 1 if it is not complete.
int status_of(const std::string& received) {
  try {
    return head_of(received, 0) ? 0 : 1;
  } catch (const HttpRefusal& refusal) {
    CHECK_FALSE(std::string(refusal.what()).empty());
    return refusal.status;
  }
}

/// The status for a head with these lines between the first and the empty one.
int with(const std::string& lines) {
  return status_of("POST /a HTTP/1.1\r\nHost: here\r\n" + lines + "\r\n");
}

}  // namespace

TEST_CASE("a head is read once it is complete, and the body is left alone") {
  const std::string head =
      "POST /a/b?c=d HTTP/1.1\r\nHOST: here:80\r\nx-y: \t one \t\r\nX-Y:two\r\nEmpty:\r\nContent-Length: "
      "3\r\n\r\n";
  for (std::size_t n = 0; n < head.size(); ++n) CHECK(status_of(head.substr(0, n)) == 1);
  const auto request = head_of(head + "abcdef", 0);
  REQUIRE(request);
  CHECK(request->method == "POST");
  CHECK(request->path == "/a/b");
  CHECK(request->only("host") == "here:80");
  CHECK(request->only("x-y") == "");
  CHECK(request->headers.count("x-y") == 2);
  CHECK(request->headers.find("x-y")->second == "one");
  CHECK(request->only("empty") == "");
  CHECK(request->head_bytes == head.size());
  CHECK(request->body_bytes == 3);
  CHECK(request->body.empty());
}

TEST_CASE("a head that comes in pieces is the same head, whatever the pieces") {
  const std::string head = "GET / HTTP/1.0\r\nHost: here\r\n\r\n";
  for (std::size_t size = 1; size <= head.size(); ++size) {
    std::string received;
    std::optional<HttpRequest> request;
    for (std::size_t from = 0; from < head.size(); from = received.size()) {
      CHECK_FALSE(request);
      received += head.substr(from, size);
      request = head_of(received, from);
    }
    REQUIRE(request);
    CHECK(request->only("host") == "here");
  }
}

TEST_CASE("a head has 16 kB at most, in one line or in many, complete or not") {
  const std::string first = "GET / HTTP/1.1\r\n", name = "x: ";
  const auto padded = [&](std::size_t bytes) {
    return first + name + std::string(bytes - first.size() - name.size() - 4, 'a') + "\r\n\r\n";
  };
  CHECK(padded(most_head_bytes).size() == most_head_bytes);
  CHECK(status_of(padded(most_head_bytes)) == 0);
  CHECK(status_of(padded(most_head_bytes + 1)) == 431);
  CHECK(status_of(padded(most_head_bytes + 1).substr(0, most_head_bytes)) == 1);
  CHECK(status_of(std::string(most_head_bytes + 1, 'a')) == 431);
  std::string many = first;
  while (many.size() <= most_head_bytes) many += "a:\r\n";
  CHECK(status_of(many) == 431);
  CHECK(status_of(many + "\r\n") == 431);
}

TEST_CASE("a body has 64 kB at most, one length, and no encoding") {
  CHECK(with("Content-Length: 65536\r\n") == 0);
  CHECK(with("Content-Length: 65537\r\n") == 413);
  CHECK(with("Content-Length: 99999999999999999999999999\r\n") == 413);
  for (const std::string length : {"-1", "+1", "1e3", "0x10", "1 2", "3, 3", "", "1;", "\xb2"})
    CHECK_MESSAGE(with("Content-Length: " + length + "\r\n") == 400, length);
  CHECK(with("Content-Length: 3\r\nContent-Length: 3\r\n") == 400);
  for (const std::string coding : {"chunked", "identity", "gzip, chunked", "", "xchunked"}) {
    CHECK(with("Transfer-Encoding: " + coding + "\r\n") == 411);
    CHECK(with("transfer-encoding:" + coding + "\r\nContent-Length: 3\r\n") == 411);
    CHECK(with("Content-Encoding: " + coding + "\r\n") == 415);
  }
}

TEST_CASE("what is not HTTP is refused at once") {
  for (const std::string line :
       {"GET /", "GET  HTTP/1.1", "GET HTTP/1.1", " GET / HTTP/1.1", "GET / http/1.1", "GET / HTTP/1.1 ",
        "G\"T / HTTP/1.1", "GET a HTTP/1.1", "GET * HTTP/1.1", "CONNECT a:80 HTTP/1.1", "GET /a b HTTP/1.1",
        "GET /\x01 HTTP/1.1", "GET /\xff HTTP/1.1", "GET https://here/ HTTP/1.1", "", "\x16\x03\x01"})
    CHECK_MESSAGE(status_of(line + "\r\nHost: here\r\n\r\n") == 400, line);
  for (const std::string version : {"HTTP/0.9", "HTTP/2.0", "HTTP/1.2", "HTTP/1.10"})
    CHECK(status_of("GET / " + version + "\r\n\r\n") == 505);
  for (const std::string header :
       {": a", "a : b", "a b: c", " a: b", "\ta: b", "a", "a\xff: b", "a: \x01", "a: b\r", "a: \x7f"})
    CHECK_MESSAGE(with(header + "\r\n") == 400, header);
  CHECK(with("a: b" + std::string(1, '\0') + "\r\n") == 400);
  CHECK(with("Name: \xc3\xa9\r\n") == 0);
  CHECK(status_of("GET / HTTP/1.1\nHost") == 400);
  CHECK(status_of("\n") == 400);
}

TEST_CASE("a target with a host must name the one of the header") {
  const auto target = [](const std::string& text) {
    return head_of("GET " + text + " HTTP/1.1\r\nHost: here:1\r\n\r\n", 0);
  };
  CHECK(target("http://here:1/a?b")->path == "/a");
  CHECK(target("HTTP://here:1/")->path == "/");
  for (const std::string other : {"http://there:1/", "http://here/", "http:///", "http://here:1@there/",
                                  "http://here:1", "http://here:1?/"})
    CHECK_THROWS_AS(target(other), HttpRefusal);
}

TEST_CASE("whatever comes, it is read, refused or not complete") {
  std::mt19937 random(56);
  const std::string whole =
      "POST /a HTTP/1.1\r\nHost: here\r\nContent-Length: 12\r\nExpect: 100-continue\r\n\r\n";
  int read = 0, refused = 0;
  for (int i = 0; i < 20'000; ++i) {
    std::string text = whole;
    for (unsigned k = random() % 4; k > 0; --k) {
      const std::size_t at = random() % text.size();
      const std::string piece = random() % 2 == 0 ? text.substr(random() % text.size(), random() % 9)
                                                  : std::string(1, static_cast<char>(random()));
      text.replace(at, random() % 3, piece);
    }
    const int status = status_of(text);
    CHECK((status == 0 || status == 1 || (status >= 400 && status <= 505)));
    read += status == 0;
    refused += status >= 400;
  }
  CHECK(read > 4000);
  CHECK(refused > 4000);
}

TEST_CASE("a response says how long it is, and that the connection ends; HEAD has no body") {
  const std::string text = text_of({200, "text/html", "<p>"}, "GET");
  CHECK(text.starts_with(
      "HTTP/1.1 200 OK\r\nContent-Type: text/html\r\nContent-Length: 3\r\nConnection: close\r\n"));
  CHECK(text.ends_with("\r\n\r\n<p>"));
  CHECK(text_of({200, "text/html", "<p>"}, "HEAD") == text.substr(0, text.size() - 3));
  CHECK(text_of({405, "text/plain", ""}, "PUT").find("\r\nAllow: GET, HEAD, POST\r\n") != std::string::npos);
}
