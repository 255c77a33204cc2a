// The exercises over HTTP: the same judge and the same progress file as in the terminal, for one student on
// this machine and nobody else.
#include <doctest/doctest.h>
#include <httplib.h>
#include <ifaddrs.h>

#include <future>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

#include "server.hpp"

namespace {

using Json = nlohmann::json;

struct Asked {
  int status;
  std::string body;
};

/// A request as our own page sends it, but for what a test changes.
struct Request {
  std::string method = "POST", path = {}, body = {}, host = {}, origin = {}, type = "application/json";
};

Asked ask(const Server& server, const Request& request) {
  httplib::Client client("127.0.0.1", server.port);
  client.set_read_timeout(3600);
  httplib::Request sent;
  sent.method = request.method;
  sent.path = request.path;
  sent.body = request.body;
  sent.set_header("Host", request.host.empty() ? "127.0.0.1:" + std::to_string(server.port) : request.host);
  if (!request.origin.empty()) sent.set_header("Origin", request.origin);
  if (request.method == "POST") sent.set_header("Content-Type", request.type);
  const auto result = client.send(sent);
  REQUIRE_MESSAGE(result, httplib::to_string(result.error()));
  return {result->status, result->body};
}

Asked page(const Server& server, const std::string& name) {
  return ask(server, {.method = "GET", .path = "/" + server.token + "/" + name});
}

std::string path_to(const Server& server, const std::string& exercise, const std::string& what) {
  return "/" + server.token + "/exercise/" + exercise + "/" + what;
}

Json told(const Server& server, const std::string& exercise, const std::string& what,
          const std::string& answer = "") {
  const Asked asked =
      ask(server, {.path = path_to(server, exercise, what), .body = Json{{"answer", answer}}.dump()});
  REQUIRE_MESSAGE(asked.status == 200, asked.body);
  return Json::parse(asked.body);
}

std::string says(const Server& server, const std::string& exercise, const std::string& what,
                 const std::string& answer = "") {
  return told(server, exercise, what, answer)["says"];
}

}  // namespace

TEST_CASE("a lesson is the page that its program writes, with the exercises in their places") {
  const Server server;
  const std::string lesson = "lesson-06-reading-a-printed-equation",
                    file = run_program(lesson, {"--format", "html"}).out,
                    served = page(server, lesson + ".html").body;
  CHECK(contains(file, "exercises serve"));
  const std::size_t first = file.find("<aside class=\"exercise\"");
  REQUIRE(first != std::string::npos);
  CHECK(served.substr(0, first) == file.substr(0, first));
  CHECK_FALSE(contains(served, "<aside"));
  for (const std::string id : {"wrong-sign-in-47", "vertical-reaction", "reaction-at-start"}) {
    const std::size_t at = served.find(" id=\"" + id + "\"");
    REQUIRE(at != std::string::npos);
    CHECK(served.find(" id=\"" + id + "\"", at + 1) == std::string::npos);
  }
  CHECK(contains(served, "<label for=\"answer-vertical-reaction\">"));
}

TEST_CASE("every exercise stands in its lesson and in the index") {
  const Server server;
  const Json list = Json::parse(run_program("exercises", {"list", "--json"}).out)["exercises"];
  const std::vector<std::string> lessons = lesson_programs();
  const std::string index = page(server, "").body;
  std::map<int, std::string> pages;
  for (const Json& exercise : list) {
    const int lesson = exercise["lesson"];
    if (!pages.contains(lesson))
      pages[lesson] = page(server, lessons.at(static_cast<std::size_t>(lesson) - 1) + ".html").body;
    const std::string element =
        "<details class=\"exercise\" id=\"" + exercise["id"].get<std::string>() + "\"";
    CAPTURE(element);
    CHECK(contains(pages[lesson], element));
    CHECK(contains(index, element));
  }
  CHECK(list.size() == 42);
  CHECK(page(server, "workbench.html").status == 200);
  CHECK(page(server, "lesson-13.html").status == 404);
}

TEST_CASE("what is typed is echoed as it is read, and what cannot be read is explained, at no cost") {
  const Server server;
  const auto read = [&](const std::string& text) { return says(server, "height-of-centre", "read", text); };
  CHECK(contains(read("R*cos(alpha - theta)/2"), "<mfrac>"));
  CHECK(contains(read("R*cos(alpha"), "this parenthesis is never closed\n  R*cos(alpha\n"));
  CHECK(contains(read("R*x"), "is not among the symbols of this exercise"));
  CHECK(read("") == "");
  CHECK(contains(says(server, "frequency-of-a-bookcase", "read", "p = 2.69 1/s"), "2.69 1/s"));
  CHECK_FALSE(std::filesystem::exists(server.progress));
}

TEST_CASE("the judge and the progress file are those of the terminal") {
  const Server server;
  const std::vector<std::pair<std::string, std::string>> answers{
      {"height-of-centre", "R*(cos(alpha-theta)+cos(alpha))"},
      {"height-of-centre", "R*("},
      {"height-of-centre", " R*(cos(alpha-theta)-cos(alpha)) "},
      {"frequency-of-a-bookcase", "2.69"},
      {"restitution", "cos(2*alpha)"},
      {"misprint-in-17", "1"}};
  TemporaryFolder desk;
  const std::string terminal = desk.path / "progress.txt";
  for (const auto& [exercise, answer] : answers) {
    const Json here = told(server, exercise, "check", answer);
    const Json there = Json::parse(
        run_program("exercises", {"--progress", terminal, "check", "--json", exercise, "--", answer}).out);
    CAPTURE(here.dump());
    CHECK(contains(here["says"], "<div class=\"said " + there["verdict"].get<std::string>() + "\">"));
  }
  CHECK(read_file(server.progress) == read_file(terminal));
  CHECK(told(server, "height-of-centre", "read")["standing"] == "(solved, 2 attempts)");
  CHECK(contains(page(server, "").body, "2 of 42 solved."));
  says(server, "restitution", "hint"), says(server, "restitution", "hint");
  for (int k = 0; k < 2; ++k) run_program("exercises", {"--progress", terminal, "hint", "restitution"});
  CHECK(read_file(server.progress) == read_file(terminal));
  CHECK(contains(says(server, "restitution", "solution"), "give up"));
  CHECK(read_file(server.progress) == read_file(terminal));
  CHECK(contains(says(server, "restitution", "give_up"), "<math"));
  run_program("exercises", {"--progress", terminal, "solution", "--give-up", "restitution"});
  CHECK(read_file(server.progress) == read_file(terminal));
}

TEST_CASE("it listens where other machines cannot reach it") {
  const Server server;
  const auto answers_at = [&](const std::string& address) {
    httplib::Client client(address, server.port);
    return static_cast<bool>(client.Get("/"));
  };
  CHECK(answers_at("127.0.0.1"));
  std::set<std::string> others{"127.0.0.2", "::1"};
  ifaddrs* interfaces = nullptr;
  REQUIRE(::getifaddrs(&interfaces) == 0);
  for (const ifaddrs* at = interfaces; at != nullptr; at = at->ifa_next) {
    char name[NI_MAXHOST];
    const int family = at->ifa_addr == nullptr ? AF_UNSPEC : at->ifa_addr->sa_family;
    const socklen_t size = family == AF_INET ? sizeof(sockaddr_in) : sizeof(sockaddr_in6);
    if ((family == AF_INET || family == AF_INET6) &&
        ::getnameinfo(at->ifa_addr, size, name, sizeof name, nullptr, 0, NI_NUMERICHOST) == 0)
      others.insert(name);
  }
  ::freeifaddrs(interfaces);
  others.erase("127.0.0.1");
  for (const std::string& address : others) CHECK_MESSAGE(!answers_at(address), address);
}

TEST_CASE("nobody else is served: no other host, no other page, no token, no form") {
  const Server server;
  const std::string path = path_to(server, "height-of-centre", "check"), body = R"({"answer": "R"})";
  const std::string ours = "http://127.0.0.1:" + std::to_string(server.port);
  CHECK(ask(server, {.path = path, .body = body, .origin = ours}).status == 200);
  const std::string before = read_file(server.progress);
  for (const std::string host : {"evil.example", "localhost", "127.0.0.1", "127.0.0.1:1", "evil.example:80"})
    CHECK_MESSAGE(ask(server, {.path = path, .body = body, .host = host}).status == 403, host);
  for (const std::string origin : {"http://evil.example", "null", "https://127.0.0.1", "http://127.0.0.1:1"})
    CHECK_MESSAGE(ask(server, {.path = path, .body = body, .origin = origin}).status == 403, origin);
  CHECK(ask(server, {.method = "GET", .path = "/" + server.token + "/", .origin = "http://evil.example"})
            .status == 403);
  for (const std::string& root : std::vector<std::string>{
           "", server.token.substr(1), "0" + server.token.substr(1) + "0", "../" + server.token})
    for (const std::string rest : {"/exercise/height-of-centre/check", "/"})
      CHECK_MESSAGE(ask(server, {.path = "/" + root + rest, .body = body}).status == 403, root);
  for (const std::string type :
       {"text/plain", "application/x-www-form-urlencoded", "multipart/form-data; boundary=x", ""})
    CHECK_MESSAGE(ask(server, {.path = path, .body = body, .type = type}).status == 415, type);
  CHECK(read_file(server.progress) == before);
  CHECK(Server().token != server.token);
}

TEST_CASE("bad requests are refused in words, and the server lives on") {
  const Server server;
  const auto status = [&](const std::string& path, const std::string& body) {
    const Asked asked = ask(server, {.path = path, .body = body});
    CHECK_FALSE(asked.body.empty());
    return asked.status;
  };
  const std::string path = path_to(server, "height-of-centre", "check");
  for (const std::string body : {"", "R", "[]", "{}", "{\"answer\": 3}", "{\"answer\": \"\xff\"}", "null"})
    CHECK_MESSAGE(status(path, body) == 400, body);
  CHECK(status(path, std::string(60000, '[')) == 400);
  CHECK(ask(server, {.path = path, .body = Json{{"answer", std::string(70000, 'x')}}.dump()}).status == 413);
  CHECK(status(path_to(server, "nothing", "check"), R"({"answer": ""})") == 404);
  CHECK(status(path_to(server, "height-of-centre", "frame"), R"({"answer": ""})") == 404);
  CHECK_FALSE(contains(read_file(server.progress), "height-of-centre"));
  CHECK(contains(says(server, "height-of-centre", "check", std::string(60000, 'x')), "could not be read"));
}

TEST_CASE("what a student types is only ever text") {
  const Server server;
  const std::string script = "<script>alert(1)</script>";
  for (const std::string what : {"read", "check"})
    for (const std::string id :
         {"height-of-centre", "frequency-of-a-bookcase", "which-momentum", "misprint-in-17"})
      if (what == "check" || id.find("momentum") == std::string::npos)
        CHECK_FALSE(contains(says(server, id, what, script), "<script"));
  std::ofstream(server.progress) << "height-of-centre\ttried\t1\t0\tR*theta\xff<script>\n"
                                 << "restitution\ttried\t1\t0\tcos(2*alpha)\n";
  CHECK_FALSE(contains(says(server, "height-of-centre", "hint"), "<script"));
  CHECK(contains(says(server, "restitution", "hint"), "cos(2*alpha)"));
  CHECK(contains(says(server, "restitution", "check", std::string("1\0", 2)), "could not be read"));
}

TEST_CASE("answers that take long are judged in turn, and others wait for it or are told to come again") {
  const Server server;
  std::string sum, turned;  // cubes of sines at whole degrees, once in order and once in the other
  for (int degree = 1; degree < 24; ++degree) {
    const std::string term = "sin(theta + " + std::to_string(degree) + "*pi/180)^3";
    sum += (sum.empty() ? "" : " + ") + term;
    turned = term + (turned.empty() ? "" : " + ") + turned;
  }
  const std::string slow = "R*(cos(alpha-theta)-cos(alpha)) + R*(" + sum + ") - R*(" + turned + ")";
  const Request request{.path = path_to(server, "height-of-centre", "check"),
                        .body = Json{{"answer", slow}}.dump()};
  std::vector<std::future<Asked>> all;
  for (int k = 0; k < 20; ++k)
    all.push_back(std::async(std::launch::async, [&] { return ask(server, request); }));
  int judged = 0, sent_away = 0;
  for (auto& one : all) {
    const Asked asked = one.get();
    judged += asked.status == 200 && contains(asked.body, "Correct.");
    sent_away += asked.status == 503;
  }
  CHECK(judged >= 8);
  CHECK(sent_away > 0);
  CHECK(judged + sent_away == 20);
  CHECK(contains(says(server, "height-of-centre", "check", "R*(cos(alpha-theta)-cos(alpha))"), "Correct."));
}

TEST_CASE("60 MB of header lines are refused, and are not kept") {
  const Server server;
  const auto most_memory = [&] {  // in kB, so far
    const std::string status = read_file("/proc/" + std::to_string(server.process()) + "/status");
    const std::size_t at = status.find("VmHWM:");
    REQUIRE(at != std::string::npos);
    return std::stol(status.substr(at + 6));
  };
  const long before = most_memory();
  httplib::Client client("127.0.0.1", server.port);
  httplib::Headers headers;
  for (int k = 0; k < 600; ++k) headers.emplace("x", std::string(100'000, 'a'));
  const auto result = client.Get("/", headers);
  if (result) CHECK(result->status == 431);
  CHECK(most_memory() - before < 20'000);
}

TEST_CASE("it ends although an answer is at work") {
  const std::string hostile = "(cos(theta)+sin(alpha)+cos(3*alpha)+sin(alpha+theta))^40";
  Server server;
  auto asked = std::async(std::launch::async, [&] {
    httplib::Client client("127.0.0.1", server.port);
    return static_cast<bool>(client.Post(path_to(server, "height-of-centre", "check"),
                                         Json{{"answer", hostile + "-" + hostile + "+R"}}.dump(),
                                         "application/json"));
  });
  const auto is_answered = [&] {
    return asked.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  };
  while (children_of(server.process()).empty() && !is_answered())
    std::this_thread::yield();  // a child judges
  CHECK(server.end(SIGTERM) == 0);
  asked.wait();
}

TEST_CASE("a signal ends it well, a port that is taken is named") {
  for (const int signal : {SIGTERM, SIGINT}) {
    Server server;
    CHECK(server.url.starts_with("http://127.0.0.1:"));
    const Result second = run_program("exercises", {"serve", "--port", std::to_string(server.port)});
    CHECK(second.exit_code == 2);
    CHECK(second.out.empty());
    CHECK(contains(second.err, "port " + std::to_string(server.port) + " cannot be used"));
    CHECK(page(server, "").status == 200);
    CHECK(server.end(signal) == 0);
  }
  for (const std::string port : {"65536", "-1", "x", "80.5"})
    CHECK(run_program("exercises", {"serve", "--port", port}).exit_code == 2);
}
