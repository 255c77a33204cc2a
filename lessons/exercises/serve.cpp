#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <signal.h>
#include <sys/signalfd.h>
#include <sys/socket.h>

#include <derivations/program/data_folder.hpp>
#include <derivations/program/program.hpp>
#include <lessons/exercises/http_server.hpp>
#include <lessons/exercises/in_page.hpp>
#include <lessons/exercises/serve.hpp>
#include <lessons/exercises/show.hpp>
#include <lessons/page/render.hpp>
#include <lessons/page/run_lesson.hpp>
#include <nlohmann/json.hpp>
#include <random>

namespace rederive::classroom {
using namespace language;
using namespace numbers;
using namespace program;
using namespace page;
namespace {

/// Returns the page of a lesson with the forms of its exercises, as its program writes it. The page is kept;
/// its script asks for the student's progress.
std::string page_of_lesson(const Classroom& room, const std::string& lesson) {
  static std::map<std::string, std::string> pages;
  if (const auto known = pages.find(lesson); known != pages.end()) return known->second;
  std::filesystem::path folder = private_folder("forms");
  write_whole(folder / "forms.json", forms_json(room));
  std::string page = room.course.lessons.page(lesson, folder / "forms.json");
  std::filesystem::remove_all(folder);
  return pages[lesson] = page;
}

/// Returns the page of that name. Throws BadInput if there is no such page.
std::string page_named(const Classroom& room, const std::string& name) {
  static const std::map<std::string, std::string> titles = room.course.lessons.titles();
  for (const auto& [lesson, title] : titles)
    if (name == lesson + ".html") return page_of_lesson(room, lesson);
  if (name == "workbench.html" && room.course.lessons.has_workbench)
    return read_whole(data_folder() / "workbench.html");
  if (name.empty() || name == "index.html" || name == "exercises.html")
    return page_of_exercises(room, titles);
  throw BadInput("there is no such page");
}

/// Returns the reply to a button of the form of an exercise, as exercise.js reads it. `place` is "ID/BUTTON".
std::string reply_to_button(const Classroom& room, const std::string& place, const std::string& body) {
  const std::size_t slash = place.find('/');
  const Exercise& exercise = find_exercise(room, place.substr(0, slash));
  const std::string button = slash == std::string::npos ? "" : place.substr(slash + 1);
  const std::string answer = nlohmann::json::parse(body).at("answer");
  const Reply told = reply(room, exercise, button, trimmed(answer));
  return Json{{"says", told.says},
              {"standing", told.standing},
              {"opinion", told.opinion ? report_json(exercise, *told.opinion) : Json()}}
      .dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// Returns the response to a request that the guard accepted; its path begins with `root`.
HttpResponse response_to(const Classroom& room, const HttpRequest& request, const std::string& root) {
  const std::string path = request.path.substr(root.size()), exercise = "exercise/";
  try {
    if (request.method != "POST") return {200, "text/html; charset=utf-8", page_named(room, path)};
    if (!path.starts_with(exercise)) throw BadInput("there is no such page");
    return {200, "application/json", reply_to_button(room, path.substr(exercise.size()), request.body)};
  } catch (const nlohmann::json::exception&) {
    throw HttpRefusal(400, "JSON in UTF-8 is expected, such as {\"answer\": \"2*x\"}");
  } catch (const BadInput& error) {
    throw HttpRefusal(404, printable(error.what()));
  } catch (const std::exception& error) {
    throw HttpRefusal(500, printable(error.what()));
  }
}

/// Refuses a request by its head, unless it knows the token, comes by our own address (no other name may lead
/// here) and from none but our own pages.
void guard(const HttpRequest& request, const std::string& host, const std::string& root) {
  const std::string type = request.only("content-type");
  if (request.only("host") != host) throw HttpRefusal(403, "This server answers only at " + host + ".");
  if (request.headers.contains("origin") && request.only("origin") != "http://" + host)
    throw HttpRefusal(403, "This server answers only its own pages.");
  if (!request.path.starts_with(root))
    throw HttpRefusal(403, "Open the whole address that exercises serve printed.");
  if (request.method != "GET" && request.method != "HEAD" && request.method != "POST")
    throw HttpRefusal(405, "Only GET, HEAD and POST are accepted.");
  if (request.method != "POST") return;
  if (type.substr(0, type.find(';')) != "application/json")
    throw HttpRefusal(415, "The Content-Type must be application/json.");
  if (!request.headers.contains("content-length")) throw HttpRefusal(411, "A Content-Length is required.");
}

/// Returns a socket that listens on this machine alone, and its port: a free one if `port` is 0.
std::pair<int, int> listener_at(int port) {
  const int listener = ::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0), yes = 1;
  sockaddr_in address{};
  socklen_t size = sizeof address;
  const auto at = reinterpret_cast<sockaddr*>(&address);
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  ::setsockopt(listener, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  const bool is_bound = listener >= 0 && ::bind(listener, at, size) == 0;
  if (!is_bound && port != 0)
    throw BadInput(
        fmt::format("port {} cannot be used: another program uses it, or the system reserves it; without "
                    "--port, a free port is chosen",
                    port));
  if (!is_bound || ::listen(listener, SOMAXCONN) != 0 || ::getsockname(listener, at, &size) != 0)
    throw std::runtime_error("the system has no free port");
  return {listener, ntohs(address.sin_port)};
}

/// Returns a descriptor that can be read once a signal tells the program to end. The signals are blocked in
/// this thread and in those that it starts.
int end_by_signal() {
  sigset_t endings;
  ::sigemptyset(&endings);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) ::sigaddset(&endings, signal);
  ::pthread_sigmask(SIG_BLOCK, &endings, nullptr);
  return ::signalfd(-1, &endings, SFD_CLOEXEC | SFD_NONBLOCK);
}

}  // namespace

int serve(const Classroom& room, int port) {
  const auto [listener, at_port] = listener_at(port);
  const int end = end_by_signal();
  if (end < 0) throw std::runtime_error("the system has no free descriptor");
  std::random_device random;
  const std::string host = fmt::format("127.0.0.1:{}", at_port),
                    root = fmt::format("/{:08x}{:08x}{:08x}{:08x}/", random(), random(), random(), random());
  std::printf("http://%s%s\nOpen this address in a browser. Ctrl-C ends the server.\n", host.c_str(),
              root.c_str());
  if (std::fflush(stdout) != 0) throw BadInput("standard output could not be written");
  const HttpHandlers handlers{
      .guard = [&](const HttpRequest& request) { guard(request, host, root); },
      .answer = [&](const HttpRequest& request) { return response_to(room, request, root); }};
  if (serve_http(listener, end, handlers)) return as_expected;
  const ProgressLock nothing_half_written(room.progress);
  std::_Exit(as_expected);
}

}  // namespace rederive::classroom
