// exercises serve: the lessons with their exercises in a browser on this machine, and for nobody else.
// Whoever asks must know the token, must have come by our own address (no other name may lead here), and from
// no page but ours.
#include <fmt/format.h>
#include <httplib.h>
#include <signal.h>

#include <derivations/emit/command_line.hpp>
#include <iterator>
#include <lessons/exercises/in_page.hpp>
#include <nlohmann/json.hpp>
#include <random>
#include <semaphore>

namespace rederive::classroom {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_bytes = 64 * 1024;  // of a request, as of an answer's file
constexpr int most_waiting = 8;                // requests that want to be judged

std::string random_token() {
  std::random_device random;
  return fmt::format("{:08x}{:08x}{:08x}{:08x}", random(), random(), random(), random());
}

/// A page of a lesson, as its program writes it.
std::string written_by(const fs::path& lesson) {
  std::string command = "'", text;
  for (char c : lesson.string()) command += c == '\'' ? std::string("'\\''") : std::string(1, c);
  std::FILE* pipe = ::popen((command + "' --format html").c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("no process to be had");
  char buffer[65536];
  for (std::size_t n; (n = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;) text.append(buffer, n);
  if (::pclose(pipe) != 0) throw std::runtime_error(lesson.filename().string() + " failed");
  return text;
}

class Desk {
 public:
  explicit Desk(const Classroom& room) : room_(room) {
    const fs::path programs = fs::read_symlink("/proc/self/exe").parent_path();
    for (const auto& file : fs::directory_iterator(programs))
      if (file.path().filename().string().starts_with("lesson-") && !file.path().has_extension())
        lessons_.push_back(file.path().filename());
    std::sort(lessons_.begin(), lessons_.end());
    programs_ = programs;
  }

  /// A page by its name; nothing if there is none.
  std::string page(const std::string& name) {
    const std::lock_guard lock(one_at_a_time_);
    if (name.empty() || name == "index.html" || name == "exercises.html")
      return page_of_exercises(room_, lessons_);
    if (name == "workbench.html") {
      std::ifstream file(REDERIVE_WORKBENCH_PAGE, std::ios::binary);
      return {std::istreambuf_iterator<char>(file), {}};
    }
    for (const auto& lesson : lessons_) {
      if (name != lesson + ".html") continue;
      std::string& text = pages_[lesson];
      if (text.empty()) text = written_by(programs_ / lesson);
      return with_exercises(room_, text);
    }
    return "";
  }

  Reply answer(const std::string& id, const std::string& what, const std::string& body) {
    const auto json = nlohmann::json::parse(body, nullptr, false);
    if (!json.is_object() || !json.contains("answer") || !json["answer"].is_string())
      throw BadInput("wanted is JSON in UTF-8 like {\"answer\": \"2*x\"}");
    const std::string text = CLI::detail::trim_copy(json["answer"].get<std::string>());
    const std::lock_guard lock(one_at_a_time_);
    return reply(room_, find_exercise(room_, id), what, text);
  }

 private:
  const Classroom& room_;
  fs::path programs_;
  std::vector<std::string> lessons_;
  std::map<std::string, std::string> pages_;
  std::mutex one_at_a_time_;  ///< GiNaC is not made for threads
};

void refuse(httplib::Response& response, int status, const std::string& why) {
  response.status = status;
  response.set_content(why + "\n", "text/plain; charset=utf-8");
}

/// What no handler is asked about.
void guard(httplib::Server& server, const std::string& host, const std::string& root) {
  server.set_default_headers(
      {{"Content-Security-Policy",
        "default-src 'none'; script-src 'unsafe-inline' blob:; worker-src blob:; style-src 'unsafe-inline'; "
        "img-src data:; font-src data:; connect-src 'self'; base-uri 'none'; form-action 'none'; "
        "frame-ancestors 'none'"},
       {"X-Content-Type-Options", "nosniff"},
       {"Referrer-Policy", "same-origin"},
       {"Cross-Origin-Resource-Policy", "same-origin"},
       {"Cache-Control", "no-store"}});
  server.set_pre_routing_handler([=](const httplib::Request& request, httplib::Response& response) {
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
  });
  server.set_exception_handler(
      [](const auto&, httplib::Response& response, const std::exception_ptr& thrown) {
        try {
          std::rethrow_exception(thrown);
        } catch (const BadInput& error) {
          refuse(response, 400, printable(error.what()));
        } catch (const std::exception& error) {
          refuse(response, 500, printable(error.what()));
        }
      });
  server.set_payload_max_length(most_bytes);
  server.set_keep_alive_timeout(1);
  server.new_task_queue = [] { return new httplib::ThreadPool(2 * most_waiting); };
}

}  // namespace

int serve(const Classroom& room, int port) {
  Desk desk(room);
  std::counting_semaphore seats(most_waiting);
  httplib::Server server;
  if (port == 0)
    port = server.bind_to_any_port("127.0.0.1");
  else if (!server.bind_to_port("127.0.0.1", port))
    throw BadInput(
        fmt::format("port {} cannot be had: another program has it, or the system keeps it. Without "
                    "--port a free one is taken",
                    port));
  if (port < 0) throw std::runtime_error("no port to be had");
  const std::string host = fmt::format("127.0.0.1:{}", port), root = "/" + random_token() + "/";
  guard(server, host, root);
  server.Get(root + "([a-z0-9.-]*)", [&](const httplib::Request& request, httplib::Response& response) {
    const std::string text = desk.page(request.matches[1]);
    if (text.empty()) return refuse(response, 404, "There is no such page.");
    response.set_content(text, "text/html; charset=utf-8");
  });
  server.Post(root + "exercise/([a-z0-9-]+)/([a-z_]+)", [&](const httplib::Request& request,
                                                            httplib::Response& response) {
    if (!seats.try_acquire()) return refuse(response, 503, "Too many ask at a time.");
    struct Seat {
      std::counting_semaphore<>& seats;
      ~Seat() { seats.release(); }
    } const seat{seats};
    const Reply reply = desk.answer(request.matches[1], request.matches[2], request.body);
    response.set_content(nlohmann::json{{"says", reply.says}, {"standing", reply.standing}}.dump(),
                         "application/json");
  });
  sigset_t endings;
  sigemptyset(&endings);
  sigaddset(&endings, SIGINT), sigaddset(&endings, SIGTERM);
  ::pthread_sigmask(SIG_BLOCK, &endings, nullptr);  // in the threads to come, too
  std::thread listening([&] { server.listen_after_bind(); });
  std::printf("http://%s%s\nOpen this address in a browser; Ctrl-C ends it.\n", host.c_str(), root.c_str());
  std::fflush(stdout);
  int signal = 0;
  ::sigwait(&endings, &signal);
  server.stop();
  listening.join();
  return as_expected;
}

}  // namespace rederive::classroom
