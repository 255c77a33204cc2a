// Serves requests of HTTP/1.1 within limits that no client can pass. One thread owns all connections and
// waits for none; another one answers. A connection has one request.
//
// Debian's cpp-httplib cannot take its place: its version 0.11 keeps 60 MB of header lines, and behind 300
// silent or slow connections no page comes, because each of them has a thread until it is silent for the
// time-out.
#pragma once

#include <chrono>
#include <functional>
#include <lessons/exercises/http_message.hpp>

namespace rederive::classroom {

/// The limits of time and number. Those of size are in http_message.hpp.
struct HttpCeilings {
  std::chrono::milliseconds request{5000};    ///< from the connection to the last byte of the request
  std::chrono::milliseconds response{10000};  ///< until the client has taken the response
  std::chrono::milliseconds rest{1000};       ///< how long more is thrown away that a client sends after it
  std::chrono::milliseconds grace{1000};      ///< to finish what has been asked, once the server is to end
  std::size_t of_client = 128;                ///< connections from one address
  std::size_t connections = 256;
  std::size_t requests = 8;  ///< that wait for their answer, the one at work included
};

struct HttpHandlers {
  /// Looks at the head of a request before its body is read, and may throw HttpRefusal. The thread that owns
  /// the connections calls it, so it must not wait.
  std::function<void(const HttpRequest&)> guard;
  /// Answers a request, and may throw HttpRefusal. The other thread calls it, one request at a time.
  std::function<HttpResponse(const HttpRequest&)> answer;
};

/// Serves the connections to `listener`, which it closes, until the descriptor `end` can be read. Neither may
/// block. If there are too many connections, the client that has most loses its oldest one that has not sent
/// its request. Returns false if `answer` is still at work after the time of grace: its thread goes on, and
/// the caller must end the program. Throws std::system_error if the system has no thread or no descriptor.
bool serve_http(int listener, int end, const HttpHandlers& handlers, const HttpCeilings& ceilings = {});

}  // namespace rederive::classroom
