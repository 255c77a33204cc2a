// exercises serve: the lessons with their exercises in a browser on this machine, and for nobody else.
// Whoever asks must know the token, must have come by our own address (no other name may lead here), and from
// no page but ours.
#include <fmt/format.h>
#include <httplib.h>
#include <signal.h>

#include <derivations/emit/data_folder.hpp>
#include <derivations/emit/program.hpp>
#include <lessons/exercises/in_page.hpp>
#include <lessons/render.hpp>
#include <lessons/run_lesson.hpp>
#include <nlohmann/json.hpp>
#include <random>

namespace rederive::classroom {
namespace {

using httplib::Request, httplib::Response;

constexpr std::size_t most_bytes = 64 * 1024;  // of a request, as of an answer's file
constexpr int most_waiting = 8;  // that want something of the judge; more are told to come again

/// What a lesson's program writes.
std::string written_by(const std::string& lesson, const std::string& options) {
  const Said said = said_by(in_quotes(loaded_from().parent_path() / lesson) + options);
  if (said.status != 0) throw std::runtime_error(lesson + " failed");
  return said.text;
}

/// A page by its name. What lessons write is kept.
std::string page(const Classroom& room, const std::string& name) {
  static std::map<std::string, std::string> pages, contents;
  for (const auto& lesson : all_lessons()) {
    if (contents[lesson].empty()) contents[lesson] = written_by(lesson, " --list");
    if (name != lesson + ".html") continue;
    if (pages[lesson].empty()) pages[lesson] = written_by(lesson, " --format html");
    return with_exercises(room, pages[lesson]);
  }
  if (name == "workbench.html") return whole_file(data_folder() / "workbench.html");
  if (name.empty() || name == "index.html" || name == "exercises.html")
    return page_of_exercises(room, contents);
  throw BadInput("there is no such page");
}

void refuse(Response& response, int status, const std::string& why) {
  response.status = status;
  response.set_content(why + "\n", "text/plain; charset=utf-8");
}

/// Before anything of a request but its head is read.
httplib::Server::HandlerResponse guard(const Request& request, Response& response, const std::string& host,
                                       const std::string& root) {
  const std::string type = request.get_header_value("Content-Type");
  if (request.get_header_value_count("Host") != 1 || request.get_header_value("Host") != host)
    refuse(response, 403, "This server answers at " + host + " only.");
  else if (request.has_header("Origin") && request.get_header_value("Origin") != "http://" + host)
    refuse(response, 403, "This server answers to its own pages only.");
  else if (!request.path.starts_with(root))
    refuse(response, 403, "Open the address that exercises serve has printed, all of it.");
  else if (request.method == "POST" && type.substr(0, type.find(';')) != "application/json")
    refuse(response, 415, "Content-Type: application/json is wanted.");
  else
    return httplib::Server::HandlerResponse::Unhandled;
  return httplib::Server::HandlerResponse::Handled;
}

void set_limits(httplib::Server& server) {
  server.set_default_headers(
      {{"Content-Security-Policy",
        "default-src 'none'; script-src 'unsafe-inline' blob:; worker-src blob:; style-src 'unsafe-inline'; "
        "img-src data:; font-src data:; connect-src 'self'; base-uri 'none'; form-action 'none'; "
        "frame-ancestors 'none'"},
       {"X-Content-Type-Options", "nosniff"},
       {"Referrer-Policy", "same-origin"},
       {"Cross-Origin-Resource-Policy", "same-origin"},
       {"Cache-Control", "no-store"}});
  server.set_payload_max_length(most_bytes);
  server.set_keep_alive_timeout(1);
  server.new_task_queue = [] { return new httplib::ThreadPool(2 * most_waiting); };
}

}  // namespace

int serve(const Classroom& room, int port) {
  httplib::Server server;
  set_limits(server);
  socket_t listener = -1;
  server.set_socket_options([&](socket_t socket) {  // the library's own would share a port that is taken
    const int yes = 1;
    ::setsockopt(listener = socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  });
  if (port != 0 && !server.bind_to_port("127.0.0.1", port))
    throw BadInput(
        fmt::format("port {} cannot be had: another program has it, or the system keeps it; without "
                    "--port a free one is taken",
                    port));
  if (port == 0) port = server.bind_to_any_port("127.0.0.1");
  if (port < 0 || ::listen(listener, 8 * most_waiting) != 0) throw std::runtime_error("no port to be had");
  std::random_device random;
  const std::string host = fmt::format("127.0.0.1:{}", port),
                    root = fmt::format("/{:08x}{:08x}{:08x}{:08x}/", random(), random(), random(), random());
  server.set_pre_routing_handler(
      [&](const Request& request, Response& response) { return guard(request, response, host, root); });
  std::mutex judge;  // GiNaC is not made for threads
  std::atomic<int> waiting = 0;
  const auto handle = [&](Response& response, const std::string& type,
                          const std::function<std::string()>& work) {
    try {
      if (++waiting > most_waiting)
        refuse(response, 503, "Too many ask at a time.");
      else if (const std::lock_guard lock(judge); true)
        response.set_content(work(), type);
    } catch (const nlohmann::json::exception&) {
      refuse(response, 400, "JSON in UTF-8 is wanted, such as {\"answer\": \"2*x\"}");
    } catch (const BadInput& error) {
      refuse(response, 404, printable(error.what()));
    } catch (const std::exception& error) {
      refuse(response, 500, printable(error.what()));
    }
    --waiting;
  };
  server.Get(root + "([a-z0-9.-]*)", [&](const Request& request, Response& response) {
    handle(response, "text/html; charset=utf-8", [&] { return page(room, request.matches[1]); });
  });
  server.Post(root + "exercise/([a-z0-9-]+)/([a-z_]+)", [&](const Request& request, Response& response) {
    handle(response, "application/json", [&] {
      const Exercise& exercise = find_exercise(room, request.matches[1]);
      const std::string answer = nlohmann::json::parse(request.body).at("answer");
      const Reply told = reply(room, exercise, request.matches[2], trimmed(answer));
      return nlohmann::json{{"says", told.says}, {"standing", told.standing}}.dump(
          -1, ' ', false, nlohmann::json::error_handler_t::replace);
    });
  });
  sigset_t endings;
  sigemptyset(&endings), sigaddset(&endings, SIGINT), sigaddset(&endings, SIGTERM);
  ::pthread_sigmask(SIG_BLOCK, &endings, nullptr);  // in the threads to come, too
  std::printf("http://%s%s\nOpen this address in a browser; Ctrl-C ends it.\n", host.c_str(), root.c_str());
  if (std::fflush(stdout) != 0) throw std::runtime_error("standard output could not be written");
  std::thread listening([&] { server.listen_after_bind(); });  // who comes before waits
  int signal = 0;
  ::sigwait(&endings, &signal);
  server.stop();
  listening.join();
  return as_expected;
}

}  // namespace rederive::classroom
