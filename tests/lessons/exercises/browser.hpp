// Chromium, as tests use it.
#pragma once

#include <nlohmann/json.hpp>

#include "server.hpp"

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
