// A site that is written for a test, and those who open it: a telephone and Firefox.
#pragma once

#include <httplib.h>

#include <future>
#include <memory>
#include <tests/lessons/exercises/browser.hpp>
#include <thread>

/// The site of the built-in paper or of one in a folder, with the judge that is in a folder.
class WrittenSite {
 public:
  explicit WrittenSite(const std::filesystem::path& judge, const std::string& paper = "") {
    std::vector<std::string> options{folder(), "--judge", judge, "--scorm"};
    if (!paper.empty()) options.insert(options.begin(), {paper, "site"});
    const Result written = run_program(paper.empty() ? "write_site" : "rederive", options);
    if (written.exit_code != 0) throw std::runtime_error(written.err);
  }
  std::filesystem::path folder() const { return temporary_->path / "pages"; }
  std::string url(const std::string& page) const { return "file://" + (folder() / page).string(); }

 private:
  std::unique_ptr<TemporaryFolder> temporary_ = std::make_unique<TemporaryFolder>();
};

/// Chromium, as wide as a telephone.
struct Telephone : Browser {
  Telephone() {
    call("Emulation.setDeviceMetricsOverride",
         {{"width", 360}, {"height", 800}, {"deviceScaleFactor", 1}, {"mobile", false}});
  }
  void open(const std::string& url) {
    call("Page.navigate", {{"url", url}});
    wait_for("document.querySelector('h1')");
  }
};

/// Opens the exercises of a site in Firefox, as a file, and checks an answer to one. Returns what the page
/// says.
inline std::string said_in_firefox(const WrittenSite& site, const std::string& exercise,
                                   const std::string& answer) {
  httplib::Server server;
  std::promise<std::string> found;
  server.Post("/found",
              [&](const httplib::Request& request, httplib::Response&) { found.set_value(request.body); });
  const std::string address =
      "http://127.0.0.1:" + std::to_string(server.bind_to_any_port("127.0.0.1")) + "/found";
  std::thread listening([&] { server.listen_after_bind(); });
  std::string page = read_file(site.folder() / "exercises.html");
  const std::string probe = R"js(
const wait = (test) => new Promise((done) => {
  const look = () => test() ? done(test()) : setTimeout(look, 50);
  look();
});
addEventListener("load", async () => {
  const box = document.getElementById(exercise);
  box.open = true;
  box.querySelector("input").value = answer;
  box.querySelector("button[value=check]").click();
  const said = await wait(() => box.querySelector(".reply .said"));
  fetch(address, {method: "POST", mode: "no-cors", body: said.textContent});
});
)js";
  page.insert(page.rfind("</body>"), "<script>{const exercise = " + Json(exercise).dump() +
                                         ", answer = " + Json(answer).dump() +
                                         ", address = " + Json(address).dump() + ";" + probe + "}</script>");
  const TemporaryFolder profile;
  write_file(site.folder() / "probe.html", page);
  const pid_t firefox = start_program(
      {"firefox-esr", "--headless", "--no-remote", "--profile", profile.path, site.url("probe.html")},
      {{::open((profile.path / "log").c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0600), 2}});
  const std::string said = found.get_future().get();
  ::kill(firefox, SIGTERM);
  ::waitpid(firefox, nullptr, 0);
  std::filesystem::remove(site.folder() / "probe.html");
  server.stop();
  listening.join();
  return said;
}
