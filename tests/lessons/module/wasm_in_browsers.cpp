// The site with the module: students solve exercises in browsers, from a server and from files.
#include <doctest/doctest.h>

#include <tests/lessons/module/built.hpp>
#include <tests/lessons/site/visitors.hpp>

namespace {

const WrittenSite& site() {
  static const WrittenSite one(folder_of_module());
  return one;
}

/// Returns a right answer to each exercise.
const Json& right_answers() {
  static const Json all = Json::parse(
      run_program("/usr/bin/env", {REDERIVE_PROGRAMS "/../lessons/judge_lines"}, R"({"show": "exercises"})")
          .out);
  return all;
}

/// The pages of the site on a server, as long as this object lives.
class Served {
 public:
  Served() {
    server_.set_mount_point("/", site().folder());
    port_ = server_.bind_to_any_port("127.0.0.1");
    listening_ = std::thread([this] { server_.listen_after_bind(); });
  }
  ~Served() {
    server_.stop();
    listening_.join();
  }
  std::string url(const std::string& page) const {
    return "http://127.0.0.1:" + std::to_string(port_) + "/" + page;
  }

 private:
  httplib::Server server_;
  int port_ = 0;
  std::thread listening_;
};

/// Types or chooses an answer, checks it, and returns the class of what is said: "said correct".
std::string said_of(Telephone& page, const std::string& exercise, const std::string& answer) {
  const std::string box = "document.getElementById('" + exercise + "')", within = box + ".querySelector";
  const std::string text = Json(answer).dump();
  page.wait_for("(" + box + ".open = true, [..." + box +
                ".querySelectorAll('[type=radio]')].forEach((one) => one.checked = one.value === " + text +
                "), " + within + "('input:not([type])') && (" + within +
                "('input:not([type])').value = " + text + "), " + within + "('.reply').textContent = '', " +
                within + "('button[value=check]').click(), true)");
  return page.wait_for(within + "('.reply .said')?.className");
}

const std::string is_narrow =
    "String(document.documentElement.scrollWidth <= document.documentElement.clientWidth)";

}  // namespace

TEST_CASE("on a telephone all exercises are solved, from a server") {
  if (!is_module_built() || !has_tool("chromium")) return;
  const Served served;
  Telephone page;
  page.open(served.url("exercises.html"));
  for (const auto& [exercise, answer] : right_answers().items()) {
    CAPTURE(exercise);
    CHECK(said_of(page, exercise, answer) == "said correct");
    CHECK(page.wait_for(is_narrow) == "true");
  }
  CHECK(page.wait_for("String(Object.values(JSON.parse(Object.values(localStorage)[0]).scores).every((score) "
                      "=> score === 1))") == "true");
}

TEST_CASE("on a telephone an exercise is solved, from files") {
  if (!is_module_built() || !has_tool("chromium")) return;
  Telephone page;
  page.open(site().url("exercises.html"));
  CHECK(said_of(page, "barrier", "m*g*R") == "said wrong");
  CHECK(said_of(page, "barrier", right_answers()["barrier"]) == "said correct");
}

TEST_CASE("the site of a paper in a folder judges the exercises of that paper") {
  if (!is_module_built() || !has_tool("chromium")) return;
  const WrittenSite rod(folder_of_module(), REDERIVE_SOURCE "/lessons/papers/rod");
  Telephone page;
  page.open(rod.url("exercises.html"));
  CHECK(said_of(page, "inertia", "m*L^2/12") == "said wrong");
  CHECK(said_of(page, "inertia", "m*L^2/3") == "said correct");
  page.open(rod.url("lesson-01.html"));
  CHECK(said_of(page, "inertia", "m*L*L/3") == "said correct");
}

TEST_CASE("an answer that is larger than memory is undecided, and the next one is judged") {
  if (!is_module_built() || !has_tool("chromium")) return;
  Telephone page;
  page.open(site().url("exercises.html"));
  for (const char* hostile :
       {"10^(10^9)", "2^2^2^2^2^2", "((((1+R)^64+g)^64+m)^64+alpha)^64", "m*g*R*(1+1/3^(3^(3^3)))"}) {
    CAPTURE(hostile);
    CHECK(said_of(page, "barrier", hostile) != "said correct");
    CHECK(said_of(page, "barrier", right_answers()["barrier"]) == "said correct");
  }
}

TEST_CASE("Firefox opens the site as files and solves an exercise") {
  if (!is_module_built() || !has_tool("firefox-esr")) return;
  CHECK(said_in_firefox(site(), "barrier", right_answers()["barrier"]).starts_with("Correct."));
}
