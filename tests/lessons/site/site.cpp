// The site that judges by itself: its scripts, its package for learning platforms, and a student in a
// browser.
#include <doctest/doctest.h>

#include <regex>
#include <tests/lessons/site/visitors.hpp>

namespace fs = std::filesystem;

namespace {

const fs::path source = REDERIVE_SOURCE;

/// The site of the built-in paper, with something that answers in the place of the judge.
const WrittenSite& site() {
  static const WrittenSite one = [] {
    const TemporaryFolder judge;
    fs::copy(source / "tests/lessons/site/judge.js", judge.path);
    write_file(judge.path / "judge.wasm", "not looked at");
    return WrittenSite(judge.path);
  }();
  return one;
}

/// A page of the site, opened as a file.
struct Page : Telephone {
  explicit Page(const std::string& name) { open(name); }
  void open(const std::string& name) { Telephone::open(site().url(name)); }
};

const std::string box = "document.getElementById('barrier')", within = box + ".querySelector";

/// Types an answer to the exercise `barrier` and presses the button.
std::string typed(const std::string& answer, const std::string& button = "check") {
  return "(" + box + ".open = true, " + within + "('input').value = '" + answer + "', " + within +
         "('button[value=" + button + "]').click(), true)";
}

}  // namespace

TEST_CASE("the scripts of the pages have the types that their comments say") {
  if (!has_tool("tsc")) return;
  std::vector<std::string> arguments{"tsc",       "--noEmit", "--checkJs",
                                     "--allowJs", "--strict", "--target",
                                     "es2022",    "--lib",    "es2022,dom,dom.iterable"};
  for (const char* folder : {"lessons/exercises", "lessons/site"})
    for (const auto& file : fs::directory_iterator(source / folder))
      if (file.path().extension() == ".js") arguments.push_back(file.path());
  arguments.push_back(source / "tests/lessons/site/page.d.ts");
  const Result checked = run_program("/usr/bin/env", arguments);
  CHECK_MESSAGE(checked.exit_code == 0, checked.out);
}

TEST_CASE("a learning platform accepts the package: its manifest is valid and names what is in it") {
  if (!has_tool("xmllint")) return;
  const fs::path manifest = site().folder() / "imsmanifest.xml";
  const Result valid = run_program(
      "/usr/bin/env", {"xmllint", "--noout", "--relaxng", source / "tests/lessons/site/scorm.rng", manifest});
  CHECK_MESSAGE(valid.exit_code == 0, valid.err);
  std::set<std::string> named{"imsmanifest.xml"};
  static const std::regex file("<file href=\"([^\"]*)\"/>");
  const std::string text = read_file(manifest);
  for (std::sregex_iterator match(text.begin(), text.end(), file), end; match != end; ++match)
    named.insert((*match)[1]);
  const Result listed = run_program(
      "/usr/bin/env",
      {"python3", "-c", "import sys, zipfile; print(*zipfile.ZipFile(sys.argv[1]).namelist(), sep='\\n')",
       site().folder() / "scorm.zip"});
  std::istringstream lines(listed.out);
  std::set<std::string> packed;
  for (std::string line; std::getline(lines, line);) packed.insert(line);
  CHECK(packed == named);
  std::set<std::string> written = files_in(site().folder());
  written.erase("scorm.zip"), written.erase("judge.inline.js");
  CHECK(written == named);
}

TEST_CASE("pages that are opened as files judge, and keep answers, standing and progress") {
  if (!has_tool("chromium")) return;
  Page page("exercises.html");
  page.wait_for(typed("wrong"));
  CHECK(page.wait_for(within + "('.reply .said')?.textContent") == "check wrong ");
  CHECK(page.wait_for(within + "('.standing').textContent") == "(barrier wrong)");
  page.wait_for("(" + within + "('input').dispatchEvent(new Event('input', {bubbles: true})), true)");
  CHECK(page.wait_for(within + "('output .said')?.textContent") == "read wrong ");
  page.open("exercises.html#barrier");
  CHECK(page.wait_for(within + "('.standing').textContent.includes('wrong') && " + within +
                      "('input').value") == "wrong");
  CHECK(
      page.wait_for("String(document.documentElement.scrollWidth <= document.documentElement.clientWidth)") ==
      "true");
}

TEST_CASE("of an answer with two readings the student picks one, which is checked") {
  if (!has_tool("chromium")) return;
  Page page("exercises.html");
  page.wait_for(typed("two"));
  page.wait_for("[..." + box +
                ".querySelectorAll('.reply button')].map((one) => one.textContent).join() === 'one,right'");
  page.wait_for("(" + box + ".querySelectorAll('.reply button')[1].click(), true)");
  CHECK(page.wait_for(within + "('.reply .said')?.textContent.startsWith('check right') && 'checked'") ==
        "checked");
}

TEST_CASE(
    "an answer at which the judge crashes, hangs or runs out of memory is undecided, and the next one is "
    "judged") {
  if (!has_tool("chromium")) return;
  Page page("exercises.html");
  std::string scripts = "const site = {paper: 'x', exercises: [], judge: true, mathlive: false, files: {}};";
  for (const char* file : {"desk_of_server.js", "desk_of_module.js"})
    scripts += read_file(source / "lessons/exercises" / file);
  page.call("Runtime.evaluate", {{"expression", scripts + "const desk = deskOfModule(1000);"}});
  const auto verdict_on = [&](const std::string& answer) {
    return page.wait_for("desk.ask({exercise: 'barrier', button: 'check', answer: '" + answer +
                         "'}).then((reply) => reply.opinion.verdict)");
  };
  for (const char* answer : {"crash", "hang", "memory"}) {
    CAPTURE(answer);
    CHECK(verdict_on(answer) == "undecided");
    CHECK(verdict_on("right") == "correct");
  }
  CHECK(page.wait_for("desk.replaceProgress('nonsense')") == "line 1 is no record");
}

TEST_CASE("a teacher's link sets the seed, and a form in its variant takes the place of the exercise") {
  if (!has_tool("chromium")) return;
  Page page("exercises.html?seed=group-3");
  page.wait_for("(" + box + ".open = true)");
  CHECK(page.wait_for("[...document.querySelectorAll('.said')].map((one) => one.textContent).find((words) => "
                      "words.startsWith('form'))") == "form  group-3");
}

TEST_CASE("the ledger shows the rows that contain the words") {
  if (!has_tool("chromium")) return;
  Page page("ledger.html");
  const std::string rows = "[...document.querySelectorAll('.ledger:not([hidden])')]";
  const auto all = page.wait_for(rows + ".length");
  CHECK(all == nlohmann::json::parse(read_file(site().folder() / "ledger.json"))["equations"].size());
  page.wait_for(
      "(document.querySelector('[type=search]').value = 'refuted 17b', "
      "document.querySelector('[type=search]').dispatchEvent(new Event('input')), true)");
  CHECK(page.wait_for(rows + ".length < " + all.dump() + " && " + rows +
                      ".every((row) => /refuted/.test(row.textContent)) && 'shown'") == "shown");
}

TEST_CASE("Firefox opens the site as files and solves an exercise") {
  if (has_tool("firefox-esr")) CHECK(said_in_firefox(site(), "barrier", "right") == "check right ");
}

TEST_CASE("axe-core finds nothing to complain of in the exercises, the ledger and a lesson") {
  if (!has_tool("chromium") || !has_tool("npm")) return;
  const TemporaryFolder folder;
  const Result fetched = run_program(
      "/bin/bash",
      {"-c", "cd " + quoted(folder.path) +
                 " && npm pack --silent axe-core@4.14.1 >/dev/null && tar -xzf axe-core-4.14.1.tgz"});
  if (fetched.exit_code != 0) return skip("npm cannot fetch axe-core");
  const std::string axe = read_file(folder.path / "package/axe.min.js");
  Page page("index.html");
  for (const char* name : {"index.html", "exercises.html#barrier", "ledger.html", "errata.html",
                           "lesson-03-energy-and-the-barrier.html"}) {
    CAPTURE(name);
    page.open(name);
    page.call("Runtime.evaluate", {{"expression", axe}});
    // Browsers let the keyboard reach what scrolls, and axe-core does not see the letters of MathML.
    CHECK(page.wait_for("axe.run({rules: {'scrollable-region-focusable': {enabled: false}, "
                        "'empty-table-header': {enabled: false}}}).then(({violations}) => "
                        "violations.map((one) => one.id + ': ' + "
                        "one.nodes[0].html.slice(0, 200)).join('; ') || 'none')") == "none");
  }
}
