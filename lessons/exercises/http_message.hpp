// Requests and responses of HTTP/1.1 as text, without a connection.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>

namespace rederive::classroom {

/// The largest request that is read.
constexpr std::size_t most_head_bytes = 16 * 1024, most_body_bytes = 64 * 1024;

struct HttpRequest {
  std::string method;
  std::string path;                                 ///< without what follows a question mark
  std::multimap<std::string, std::string> headers;  ///< by name in lower case
  std::size_t head_bytes = 0;                       ///< up to the empty line, with it
  std::size_t body_bytes = 0;                       ///< by Content-Length
  std::string body;

  /// Returns the value of a header that occurs once, else "".
  std::string only(const std::string& name) const;
};

struct HttpResponse {
  int status = 200;
  std::string type;
  std::string body;
};

/// A request that is refused: the status of the response, and its text as the message.
struct HttpRefusal : std::runtime_error {
  HttpRefusal(int status_of, const std::string& why) : std::runtime_error(why), status(status_of) {}
  int status;
};

/// Reads the head of the request with which `received` begins, once it is complete, but not its body. Earlier
/// calls have seen the first `from` bytes. Throws HttpRefusal as soon as it is not HTTP/1.x, the head is
/// longer than most_head_bytes or the body than most_body_bytes, or the body is encoded (RFC 9112).
std::optional<HttpRequest> head_of(const std::string& received, std::size_t from);

/// Returns the text of a response to a request of `method`. The connection ends with it.
std::string text_of(const HttpResponse& response, const std::string& method);

}  // namespace rederive::classroom
