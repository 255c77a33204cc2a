// The web pages in a browser: nothing is asked of the network, no glyph is missing, nothing is wider than a
// telephone.
#include <doctest/doctest.h>

#include <map>
#include <regex>
#include <tests/run_program.hpp>

namespace {

/// The pages that lessons/run writes, written once; false where it would write those of another build.
bool are_written(std::filesystem::path& folder) {
  const std::filesystem::path source = REDERIVE_SOURCE;
  if (!std::filesystem::equivalent(REDERIVE_PROGRAMS, source / "build" / "bin")) {
    skip("lessons/run writes what stands in build/bin");
    return false;
  }
  static const TemporaryFolder temporary;
  static const Result written =
      run_program((source / "lessons" / "run").string(), {"--html", (temporary.path / "pages").string()});
  REQUIRE_MESSAGE(written.exit_code == 0, written.err);
  folder = temporary.path / "pages";
  return true;
}

/// Page after page in a frame as wide as a telephone (and its scroll bar); a script of the test measures each
/// and writes into its own document.
constexpr auto probe = R"(<!doctype html><meta charset="utf-8"><body><pre id="out"></pre>
<iframe id="f" width="375" height="3000"></iframe><script>
const names = [%PAGES%], frame = document.getElementById('f'), out = document.getElementById('out');
frame.onload = function () {
  const d = this.contentDocument, w = [], name = names.shift();
  for (const e of d.querySelectorAll('body *')) {
    const inside = e.closest('.formula>div,.ledger,.wide,pre,.workbench option');
    if (!inside && e.getBoundingClientRect().right > 361) w.push(e.tagName);
  }
  out.textContent += name + ': width ' + d.documentElement.scrollWidth + ' wide [' + w.join() + '] math ' +
    d.querySelectorAll('math').length + ' flat ' + [...d.querySelectorAll('math')].filter(m => m.getBoundingClientRect().height < 5).length +
    ' requests ' + this.contentWindow.performance.getEntriesByType('resource').filter(r => !/^(data|blob):/.test(r.name)).length + ' end\n';
  if (names.length) this.src = 'pages/' + names[0];
};
frame.src = 'pages/' + names[0];</script>)";

/// What the probe wrote, of all the lessons' pages.
std::string probed(const std::filesystem::path& folder) {
  std::string names, page = probe;
  for (const std::string& lesson : lesson_programs()) names += "'" + lesson + ".html',";
  std::ofstream(folder / "probe.html") << page.replace(page.find("%PAGES%"), 7, names);
  const std::string command =
      "cd " + quoted(folder.string()) +
      " && timeout 3000 chromium --headless --no-sandbox --disable-gpu --disable-quic --no-first-run"
      " --disable-background-networking --disable-component-update --disable-sync "
      "--allow-file-access-from-files"
      " --virtual-time-budget=60000 --user-data-dir=" +
      quoted((folder / "profile").string()) + " --dump-dom " +
      quoted("file://" + (folder / "probe.html").string()) + " >dom 2>browser.log";
  if (std::system(command.c_str()) != 0) return "the browser failed: " + read_file(folder / "browser.log");
  const std::string dom = read_file(folder / "dom");
  const auto from = dom.find("<pre id=\"out\">"), to = dom.find("</pre>");
  return from == std::string::npos ? dom : dom.substr(from + 14, to - from - 14);
}

}  // namespace

TEST_CASE("a lesson fits a telephone and fetches nothing") {
  std::filesystem::path pages;
  if (!has_tool("chromium") || !are_written(pages)) return;
  const std::string found = probed(pages.parent_path());
  CAPTURE(found);
  static const std::regex fits("width 360 wide \\[\\] math [1-9]\\d* flat 0 requests 0 end");
  int fitting = 0;
  for (const std::string& lesson : lesson_programs()) {
    CAPTURE(lesson);
    const auto at = found.find(lesson + ".html: ");
    REQUIRE(at != std::string::npos);
    const std::string line = found.substr(at, found.find('\n', at) - at);
    CHECK_MESSAGE(std::regex_match(line.substr(lesson.size() + 7), fits), line);
    ++fitting;
  }
  CHECK(fitting >= 12);
}

TEST_CASE("lessons/run --html writes all pages, every link leads somewhere, and nothing is fetched") {
  std::filesystem::path folder;
  if (!are_written(folder)) return;
  std::map<std::string, std::string> pages;
  for (const auto& file : std::filesystem::directory_iterator(folder))
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
