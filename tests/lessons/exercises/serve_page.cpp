// A student in a browser: types an answer beside the lesson, sees what is read of it, and what the judge
// says.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "server.hpp"

namespace {

using Json = nlohmann::json;

/// Chromium with one page, by the DevTools protocol over a pair of pipes.
class Browser {
 public:
  Browser() {
    int in[2], out[2];
    if (::pipe2(in, O_CLOEXEC) != 0 || ::pipe2(out, O_CLOEXEC) != 0)
      throw std::runtime_error("no pipe to be had");
    for (int* end : {&in[0], &out[1]})  // 3 and 4 are the browser's
      *end = ::fcntl(*end, F_DUPFD_CLOEXEC, 10);
    process_ = start_program(
        {"chromium", "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
         "--disable-background-networking", "--disable-component-update", "--disable-sync",
         "--remote-debugging-pipe", "--user-data-dir=" + (profile_.path / "profile").string()},
        {{in[0], 3},
         {out[1], 4},
         {::open((profile_.path / "log").c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0600), 2}});
    ::close(in[0]), ::close(out[1]);
    to_ = in[1], from_ = out[0];
    const Json target = call("Target.createTarget", {{"url", "about:blank"}})["targetId"];
    session_ = call("Target.attachToTarget", {{"targetId", target}, {"flatten", true}})["sessionId"];
  }
  ~Browser() {
    ::close(to_), ::close(from_);
    ::kill(process_, SIGTERM);
    ::waitpid(process_, nullptr, 0);
  }

  Json call(const std::string& method, const Json& parameters) {
    Json message{{"id", ++count_}, {"method", method}, {"params", parameters}};
    if (!session_.empty()) message["sessionId"] = session_;
    const std::string text = message.dump();
    if (::write(to_, text.c_str(), text.size() + 1) < 0) throw std::runtime_error("the browser is gone");
    for (;;) {
      std::string answer;
      for (char c = 1; c != 0 && ::read(from_, &c, 1) == 1;)
        if (c != 0) answer += c;
      if (answer.empty()) throw std::runtime_error("the browser says nothing");
      const Json json = Json::parse(answer);
      if (json.value("id", 0) != count_) continue;  // an event
      if (json.contains("error")) throw std::runtime_error(json.dump());
      return json["result"];
    }
  }
  /// The value of an expression, as soon as it is one.
  Json wait_for(const std::string& expression) {
    return call("Runtime.evaluate",
                {{"expression",
                  "new Promise((done) => { const look = () => { const value = document.readyState === "
                  "'complete' && (" +
                      expression + "); value ? done(value) : setTimeout(look, 20); }; look(); })"},
                 {"awaitPromise", true},
                 {"returnByValue", true}})["result"]["value"];
  }
  void type(const std::string& text) { call("Input.insertText", {{"text", text}}); }
  void press_enter() {
    for (const char* type : {"keyDown", "keyUp"})
      call("Input.dispatchKeyEvent", {{"type", type},
                                      {"key", "Enter"},
                                      {"code", "Enter"},
                                      {"text", "\r"},
                                      {"windowsVirtualKeyCode", 13}});
  }

 private:
  TemporaryFolder profile_;
  pid_t process_ = -1;
  int to_ = -1, from_ = -1, count_ = 0;
  std::string session_;
};

}  // namespace

TEST_CASE("an answer is typed beside the lesson: the echo, the verdict, a hint, the standing") {
  if (!has_tool("chromium")) return;
  const Server server;
  Browser browser;
  browser.call("Emulation.setDeviceMetricsOverride",
               {{"width", 360}, {"height", 800}, {"deviceScaleFactor", 1}, {"mobile", false}});
  browser.call("Page.navigate", {{"url", server.url + "lesson-06-reading-a-printed-equation.html"}});
  const std::string box = "document.getElementById('vertical-reaction')", within = box + "?.querySelector";
  browser.wait_for("typeof workbenches !== 'undefined' || " + within + "('input') !== null");
  browser.wait_for("(" + within + "('input').focus(), document.activeElement.name === 'answer')");
  browser.type("g - R*thetadot^2/(2");
  CHECK(browser.wait_for(within + "('output pre')?.textContent") ==
        "this parenthesis is never closed\n  g - R*thetadot^2/(2\n                   ^\n");
  browser.type(")");
  CHECK(browser.wait_for("!" + within + "('output pre') && " + within + "('output mfrac')?.textContent") ==
        "Rθ˙22");
  browser.press_enter();
  CHECK(browser.wait_for(within + "('.said.wrong b')?.textContent") == "Not right yet.");
  CHECK(browser.wait_for(within + "('.standing').textContent") == "(tried, 1 attempt)");
  browser.wait_for("(" + within + "('button[value=hint]').click(), true)");
  CHECK(browser.wait_for(
            within +
            "('.said:not(.wrong) b')?.textContent.startsWith('A hint for your last answer') && 'hint'") ==
        "hint");
  browser.wait_for("(" + within + "('button[value=solution]').click(), true)");
  browser.wait_for("(" + within + "('button[value=give_up]')?.click(), " + within +
                   "('.standing').textContent === '(given up, 1 attempt)')");
  CHECK(browser.wait_for(
            "String(document.documentElement.scrollWidth <= document.documentElement.clientWidth)") ==
        "true");
  CHECK(browser.wait_for("JSON.stringify(performance.getEntriesByType('resource').map((one) => one.name)"
                         ".filter((name) => !/^(data|blob):/.test(name) && !name.startsWith('" +
                         server.url + "')))") == "[]");
  CHECK(
      read_file(server.progress).find("vertical-reaction\tgiven_up\t1\t0\tg - R*thetadot^2/(2)\thinted\n") !=
      std::string::npos);
}

TEST_CASE("a link to an exercise opens it, a choice is made by a radio button, and a dead server is named") {
  if (!has_tool("chromium")) return;
  Server server;
  Browser browser;
  browser.call("Page.navigate", {{"url", server.url + "exercises.html#misprint-in-17"}});
  CHECK(browser.wait_for("[...document.querySelectorAll('.exercise[open]')].map((one) => one.id).join()") ==
        "misprint-in-17");
  const std::string within = "document.getElementById('misprint-in-17').querySelector";
  const Json solution = run_program("exercises", {"--progress", server.folder.path / "other.txt", "solution",
                                                  "--json", "--give-up", "misprint-in-17"})
                            .out;
  const std::string answer = Json::parse(solution.get<std::string>())["answer"];
  browser.wait_for("(" + within + "('[value=\"" + answer + "\"]').click(), true)");
  browser.wait_for("(" + within + "('button[value=check]').click(), true)");
  CHECK(browser.wait_for(within + "('.said.correct b')?.textContent") == "Correct.");
  server.end(SIGTERM);
  browser.wait_for("(" + within + "('button[value=hint]').click(), true)");
  CHECK(browser.wait_for(within + "('.reply').textContent.includes('exercises serve') && 'named'") ==
        "named");
}
