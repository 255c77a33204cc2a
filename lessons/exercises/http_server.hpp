// Requests of HTTP/1.1 within ceilings that no client can pass: one thread owns all connections and waits for
// none, another answers. A connection has one request.
#pragma once

#include <chrono>
#include <functional>
#include <lessons/exercises/http_message.hpp>

namespace rederive::classroom {

/// What clients can take of the server beside the sizes of a request.
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
  /// Looks at the head of a request before its body is read; throws HttpRefusal if nothing is to come of it.
  /// It must not wait: it is called by the thread that owns the connections.
  std::function<void(const HttpRequest&)> guard;
  /// Answers a request; called by one other thread, one request at a time. It may throw HttpRefusal.
  std::function<HttpResponse(const HttpRequest&)> answer;
};

/// Serves those who connect to `listener`, which it closes, until the descriptor `end` can be read; both must
/// not block. Where there are too many connections, the oldest of those whose request is not complete ends,
/// of the client that has most. False if `answer` was still at work after the time of grace: its thread goes
/// on, and the caller must end the program. Throws std::system_error if the system gives no thread, no
/// descriptor or no memory to begin with.
bool serve_http(int listener, int end, const HttpHandlers& handlers, const HttpCeilings& ceilings = {});

}  // namespace rederive::classroom
