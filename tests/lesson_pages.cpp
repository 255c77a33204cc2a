// The web pages in a browser: nothing is asked of the network, no glyph is missing, nothing is wider than a
// telephone.
#include <doctest/doctest.h>

#include <map>
#include <regex>

#include "run_program.hpp"

namespace {

/// The page in a frame as wide as a telephone (and its scroll bar); a script of the test measures it and
/// writes into its own document.
constexpr auto probe = R"(<!doctype html><meta charset="utf-8"><body><pre id="out">waiting</pre>
<iframe id="f" width="375" height="3000" src="page.html"></iframe><script>
document.getElementById('f').onload = function () {
  const d = this.contentDocument, w = [];
  for (const e of d.querySelectorAll('body *')) {
    const inside = e.closest('.formula>div,.ledger,.wide,pre,.workbench option');
    if (!inside && e.getBoundingClientRect().right > 361) w.push(e.tagName);
  }
  document.getElementById('out').textContent = 'width ' + d.documentElement.scrollWidth + ' wide [' + w.join() + '] math ' +
    d.querySelectorAll('math').length + ' flat ' + [...d.querySelectorAll('math')].filter(m => m.getBoundingClientRect().height < 5).length +
    ' requests ' + this.contentWindow.performance.getEntriesByType('resource').filter(r => !/^(data|blob):/.test(r.name)).length + ' end';
};</script>)";

std::string dump(const std::filesystem::path& folder) {
  const std::string command =
      "cd " + quoted(folder.string()) +
      " && timeout 60 chromium --headless --no-sandbox --disable-gpu --disable-quic --no-first-run"
      " --disable-background-networking --disable-component-update --disable-sync "
      "--allow-file-access-from-files"
      " --virtual-time-budget=8000 --user-data-dir=" +
      quoted((folder / "profile").string()) + " --dump-dom " +
      quoted("file://" + (folder / "probe.html").string()) + " >dom 2>browser.log";
  if (std::system(command.c_str()) != 0) return "the browser failed: " + read_file(folder / "browser.log");
  const std::string dom = read_file(folder / "dom");
  const auto from = dom.find("<pre id=\"out\">"), to = dom.find("</pre>");
  return from == std::string::npos ? dom : dom.substr(from + 14, to - from - 14);
}

}  // namespace

TEST_CASE("a lesson fits a telephone and fetches nothing") {
  if (!has_tool("chromium")) return;
  int pages = 0;
  for (const std::string& lesson : lesson_programs()) {
    ++pages;
    CAPTURE(lesson);
    TemporaryFolder folder;
    REQUIRE(
        run_program(lesson, {"--format", "html", "--out", (folder.path / "page.html").string()}).exit_code ==
        0);
    std::ofstream(folder.path / "probe.html") << probe;
    const std::string found = dump(folder.path);
    CAPTURE(found);
    CHECK(found.find("width 360 ") != std::string::npos);
    CHECK(found.find("wide []") != std::string::npos);
    CHECK(found.find("flat 0 ") != std::string::npos);
    CHECK(found.find("math 0 ") == std::string::npos);
    CHECK(found.find("requests 0 end") != std::string::npos);
  }
  CHECK(pages >= 12);
}

TEST_CASE("lessons/run --html writes all pages, every link leads somewhere, and nothing is fetched") {
  const std::filesystem::path source = REDERIVE_SOURCE;
  if (!std::filesystem::equivalent(REDERIVE_PROGRAMS, source / "build" / "bin")) {
    std::printf("SKIPPED TEST: lessons/run writes what stands in build/bin\n");
    return;
  }
  TemporaryFolder folder;
  const Result written = run_program((source / "lessons" / "run").string(), {"--html", folder.path.string()});
  REQUIRE_MESSAGE(written.exit_code == 0, written.err);
  std::map<std::string, std::string> pages;
  for (const auto& file : std::filesystem::directory_iterator(folder.path))
    pages[file.path().filename()] = read_file(file.path());
  std::vector<std::string> wanted{"exercises.html", "index.html", "workbench.html"};
  for (const std::string& lesson : lesson_programs()) wanted.push_back(lesson + ".html");
  CHECK(wanted.size() == 15);
  CHECK(pages.size() == wanted.size());
  for (const std::string& name : wanted) CHECK_MESSAGE(pages[name].ends_with("</html>\n"), name);
  const std::regex link("href=\"([^\"#]*)(?:#([^\"]*))?\""),
      fetched(R"((src="(?!data:)|url\((?!data:)|@import|srcset=|\bfetch\(|XMLHttpRequest|WebSocket).{0,40})");
  int equations = 0, to_exercises = 0;
  for (const auto& [its_name, text] : pages) {
    const auto& name = its_name;
    CAPTURE(name);
    for (std::sregex_iterator match(text.begin(), text.end(), link), end; match != end; ++match) {
      const std::string page = (*match)[1], place = (*match)[2];
      if (page == "data:,") continue;  // no icon
      CAPTURE(match->str());
      const auto target = pages.find(page.empty() ? name : page);
      REQUIRE(target != pages.end());
      if (place.empty()) continue;
      ++(page == "exercises.html" ? to_exercises : equations);
      CHECK(target->second.find(" id=\"" + place + "\"") != std::string::npos);
    }
    for (std::sregex_iterator match(text.begin(), text.end(), fetched), end; match != end; ++match)
      FAIL_CHECK("this fetches something: " << match->str());
  }
  CHECK(equations > 500);
  CHECK(to_exercises > 10);
  CHECK(pages.begin()->first == "exercises.html");
  CHECK(pages["lesson-01-the-block-and-its-motion.html"].find("data-says=\"(17b): refuted (argument)\"") !=
        std::string::npos);
}
