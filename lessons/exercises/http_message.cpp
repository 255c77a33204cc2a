#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <lessons/exercises/http_message.hpp>
#include <string_view>
#include <vector>

namespace rederive::classroom {
namespace {

/// Returns whether a character may be in the name of a method or a header (RFC 9110, 5.6.2).
bool is_token_character(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
         std::string_view("!#$%&'*+-.^_`|~").find(c) != std::string_view::npos;
}

bool is_token(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), is_token_character);
}

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return result;
}

/// Returns the end of the head, after its empty line; nothing if that has not come yet.
std::optional<std::size_t> end_of_head(const std::string& received, std::size_t from) {
  for (std::size_t at = received.find('\n', from); at != std::string::npos;
       at = received.find('\n', at + 1)) {
    if (at == 0 || received[at - 1] != '\r') throw HttpRefusal(400, "A line must end with CR and LF.");
    if (at + 1 > most_head_bytes) break;
    if (at >= 3 && received.compare(at - 3, 4, "\r\n\r\n") == 0) return at + 1;
  }
  if (received.size() > most_head_bytes)
    throw HttpRefusal(431, fmt::format("The head of a request may have at most {} bytes.", most_head_bytes));
  return std::nullopt;
}

std::vector<std::string_view> lines_of_head(std::string_view head) {
  std::vector<std::string_view> lines;
  for (std::size_t end = 0; (end = head.find("\r\n")) != std::string_view::npos && end > 0;
       head.remove_prefix(end + 2))
    lines.push_back(head.substr(0, end));
  return lines;
}

/// Returns the path of a target as servers get it, "/a?b", or as proxies do, "http://host/a?b". That host
/// must be the one in the header, which the guard compares with its own.
std::string path_of(std::string_view target, const HttpRequest& request) {
  constexpr std::string_view scheme = "http://";
  const bool is_printable =
      std::all_of(target.begin(), target.end(), [](char c) { return c > ' ' && c < '\x7f'; });
  if (lower(target.substr(0, scheme.size())) == scheme) {
    target.remove_prefix(scheme.size());
    const std::string_view host = target.substr(0, target.find_first_of("/?"));
    if (host != request.only("host"))
      throw HttpRefusal(400, "The target and the header Host name different hosts.");
    target.remove_prefix(host.size());
  }
  if (!is_printable || !target.starts_with('/'))
    throw HttpRefusal(400, "The target must begin with a slash.");
  return std::string(target.substr(0, target.find('?')));
}

void add_header(std::string_view line, HttpRequest& request) {
  const std::size_t colon = line.find(':');
  const std::string_view name = line.substr(0, colon);
  if (colon == std::string_view::npos || !is_token(name))
    throw HttpRefusal(400, "A line of the head must have the form Name: value.");
  std::string_view value = line.substr(colon + 1);
  for (const char c : value)
    if ((c >= 0 && c < ' ' && c != '\t') || c == '\x7f')
      throw HttpRefusal(400, "A header must not contain control characters.");
  while (value.starts_with(' ') || value.starts_with('\t')) value.remove_prefix(1);
  while (value.ends_with(' ') || value.ends_with('\t')) value.remove_suffix(1);
  request.headers.emplace(lower(name), value);
}

std::size_t length_of_body(const HttpRequest& request) {
  if (request.headers.contains("transfer-encoding"))
    throw HttpRefusal(411, "A request must have a Content-Length instead of a Transfer-Encoding.");
  if (request.headers.contains("content-encoding"))
    throw HttpRefusal(415, "The body of a request must not be encoded.");
  const auto count = request.headers.count("content-length");
  if (count == 0) return 0;
  const std::string text = request.only("content-length");
  if (text.empty() || text.find_first_not_of("0123456789") != std::string::npos)
    throw HttpRefusal(400, "There must be one Content-Length, and it must be a whole number.");
  std::size_t bytes = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), bytes);
  if (read.ec != std::errc() || bytes > most_body_bytes)
    throw HttpRefusal(413, fmt::format("The body of a request may have at most {} bytes.", most_body_bytes));
  return bytes;
}

const char* reason_of(int status) {
  static const std::map<int, const char*> reasons{{200, "OK"},
                                                  {400, "Bad Request"},
                                                  {403, "Forbidden"},
                                                  {404, "Not Found"},
                                                  {405, "Method Not Allowed"},
                                                  {408, "Request Timeout"},
                                                  {411, "Length Required"},
                                                  {413, "Content Too Large"},
                                                  {415, "Unsupported Media Type"},
                                                  {417, "Expectation Failed"},
                                                  {431, "Request Header Fields Too Large"},
                                                  {500, "Internal Server Error"},
                                                  {503, "Service Unavailable"},
                                                  {505, "HTTP Version Not Supported"}};
  const auto found = reasons.find(status);
  return found == reasons.end() ? "" : found->second;
}

}  // namespace

std::string HttpRequest::only(const std::string& name) const {
  return headers.count(name) == 1 ? headers.find(name)->second : "";
}

std::optional<HttpRequest> head_of(const std::string& received, std::size_t from) {
  const auto end = end_of_head(received, from);
  if (!end) return std::nullopt;
  const auto lines = lines_of_head(std::string_view(received).substr(0, *end));
  if (lines.empty()) throw HttpRefusal(400, "A request must begin with its method.");
  const std::string_view first = lines.front();
  const std::size_t blank = first.find(' '), last = first.rfind(' ');
  if (blank == last || !is_token(first.substr(0, blank)))
    throw HttpRefusal(400, "A request must begin with a line like GET / HTTP/1.1.");
  const std::string_view version = first.substr(last + 1);
  if (version != "HTTP/1.1" && version != "HTTP/1.0")
    throw HttpRefusal(version.starts_with("HTTP/") ? 505 : 400, "The version must be HTTP/1.1 or HTTP/1.0.");
  HttpRequest request;
  request.method = first.substr(0, blank);
  request.head_bytes = *end;
  for (std::size_t i = 1; i < lines.size(); ++i) add_header(lines[i], request);
  request.path = path_of(first.substr(blank + 1, last - blank - 1), request);
  request.body_bytes = length_of_body(request);
  return request;
}

std::string text_of(const HttpResponse& response, const std::string& method) {
  std::string text = fmt::format(
      "HTTP/1.1 {} {}\r\n"
      "Content-Type: {}\r\n"
      "Content-Length: {}\r\n"
      "Connection: close\r\n",
      response.status, reason_of(response.status), response.type, response.body.size());
  if (response.status == 405) text += "Allow: GET, HEAD, POST\r\n";
  text +=
      "Content-Security-Policy: default-src 'none'; script-src 'unsafe-inline' blob:; worker-src blob:; "
      "style-src 'unsafe-inline'; img-src data:; font-src data:; connect-src 'self'; base-uri 'none'; "
      "form-action 'none'; frame-ancestors 'none'\r\n"
      "X-Content-Type-Options: nosniff\r\n"
      "Referrer-Policy: same-origin\r\n"
      "Cross-Origin-Resource-Policy: same-origin\r\n"
      "Cache-Control: no-store\r\n\r\n";
  return method == "HEAD" ? text : text + response.body;
}

}  // namespace rederive::classroom
