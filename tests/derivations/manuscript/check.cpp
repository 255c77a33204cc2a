// Manuscripts: right ones of which nothing is called wrong, planted slips, and single displays with what is
// found.
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <toml++/toml.h>

#include <derivations/manuscript/check.hpp>
#include <derivations/program/bad_input.hpp>
#include <filesystem>
#include <fstream>
#include <tests/cases.hpp>
#include <tests/run_program.hpp>

namespace fs = std::filesystem;
using namespace rederive::manuscript;
using Text = std::string;

namespace {

const fs::path folder = fs::path(REDERIVE_SOURCE) / "tests/manuscripts";

std::set<std::size_t> lines_with(const Report& report, Finding finding) {
  std::set<std::size_t> lines;
  for (const JudgedDisplay& display : report.displays)
    for (const Link& link : display.links)
      if (link.finding == finding) lines.insert(link.place.line);
  return lines;
}

Report report_of(const fs::path& file) { return check(Manuscript(file), {}, false); }
Report report_of_text(const Text& text) { return check(Manuscript(text, "text.tex"), {}, false); }

/// What is found about each link: "proved wrong".
Text findings_of(const Text& text) {
  Text words;
  const Report report = report_of_text(text);
  for (const JudgedDisplay& display : report.displays)
    for (const Link& link : display.links) words += (words.empty() ? "" : " ") + to_string(link.finding);
  return words;
}

/// The lines of a file that say "wrong:" in a comment.
std::set<std::size_t> marked_lines(const fs::path& file) {
  std::set<std::size_t> lines;
  std::ifstream stream(file);
  Text line;
  for (std::size_t number = 1; std::getline(stream, line); ++number)
    if (line.find("% wrong: ") != Text::npos) lines.insert(number);
  return lines;
}

std::vector<fs::path> manuscripts() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const Text extension = entry.path().extension();
    const bool is_one = extension == ".tex" || extension == ".ipynb" || extension == ".md";
    if (is_one && entry.path().filename() != "README.md" && entry.path().filename() != "paper.tex")
      files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

}  // namespace

TEST_CASE("nothing in right manuscripts is called wrong, and most of it is read") {
  std::size_t read = 0, unread = 0, proved = 0;
  REQUIRE(manuscripts().size() >= 60);
  for (const fs::path& file : manuscripts()) {
    const Report report = report_of(file);
    CHECK_MESSAGE(lines_with(report, Finding::wrong).empty(), file.filename().string());
    unread += report.count(Finding::not_read);
    proved += report.count(Finding::proved);
    read += report.count(Finding::proved) + report.count(Finding::undecided) + report.count(Finding::assumed);
  }
  CHECK(proved > 500);
  CHECK(10 * read >= 9 * (read + unread));  // a tenth is meant to be left unread
}

TEST_CASE("in the paper written as steps, those that are refuted are wrong, and no others") {
  const Report report = report_of(folder / "paper.tex");
  const std::set<std::size_t> marked = marked_lines(folder / "paper.tex");
  CHECK(marked.size() == 14);
  CHECK(lines_with(report, Finding::wrong) == marked);
  CHECK(report.count(Finding::proved) > 70);
}

TEST_CASE("of planted slips, at least 85 % are called wrong at their line") {
  const toml::table table = toml::parse_file((folder / "slips.toml").string());
  const toml::array& slips = *table["slip"].as_array();
  CHECK(slips.size() >= 240);
  std::size_t found = 0;
  Text missed;
  for (const auto& node : slips) {
    const toml::table& slip = *node.as_table();
    const Text file = slip["file"].value_or(Text()), find = slip["find"].value_or(Text());
    const auto line = static_cast<std::size_t>(slip["line"].value_or(0));
    std::ifstream stream(folder / file);
    Text text, one;
    for (std::size_t number = 1; std::getline(stream, one); ++number) {
      const std::size_t at = number == line ? one.find(find) : Text::npos;
      if (number == line) REQUIRE_MESSAGE(at != Text::npos, file, ":", line, ": ", find);
      if (at != Text::npos) one.replace(at, find.size(), slip["replace"].value_or(Text()));
      text += one + "\n";
    }
    const TemporaryFolder place;
    const fs::path changed = place.path / ("slip" + fs::path(file).extension().string());
    std::ofstream(changed) << text;
    for (const auto& entry : fs::directory_iterator(folder))  // what it inputs
      if (entry.path().filename() == "circuits_macros.tex")
        fs::copy(entry.path(), place.path / "circuits_macros.tex");
    const bool is_found = lines_with(report_of(changed), Finding::wrong).contains(line);
    found += is_found ? 1 : 0;
    if (!is_found) missed += fmt::format("{}:{} ", file, line);
  }
  CHECK_MESSAGE(100 * found >= 85 * slips.size(), found, " of ", slips.size(), ", not ", missed);
}

TEST_CASE("displays, with what is found about each step") {
  each_case("displays", [](const Text& text, const Text& findings) { CHECK(findings_of(text) == findings); });
}

TEST_CASE("a wrong step has a witness and its place, and a repair where one change makes it right") {
  const Report report =
      report_of_text("\\begin{align}\n  (x+1)^2 &= x^2 + 2x + 1 \\\\\n    &= x(x+2) + 2\n\\end{align}\n");
  REQUIRE(report.displays.size() == 1);
  const Link& link = report.displays[0].links.at(1);
  CHECK(link.finding == Finding::wrong);
  CHECK(link.place.line == 3);
  CHECK(link.place.column == 6);
  CHECK(link.witness == "at x = 1 the left side is 4, the right side 5");
  CHECK(link.repair == "x*(x + 2) + 1");
}

TEST_CASE("ranges that the text states are taken, and listed") {
  const Report report = report_of_text(
      "Let $0 < \\alpha < \\pi/2$ and $n$ be an integer. For $x > 0$,\n\\[ \\sqrt{x^2} = x = x. \\]");
  CHECK(report.symbols.at("alpha").range == "(0, pi/2)");
  CHECK(report.symbols.at("n").is_integer);
  CHECK(report.symbols.at("x").range == "(0, inf)");
  CHECK(report.symbols.at("x").is_from_text);
}

TEST_CASE("a directive that cannot be read is an error with its place") {
  CHECK_THROWS_WITH_AS(report_of_text("\n% rederive: x is nice\n"),
                       doctest::Contains("text.tex:2:1: 'x is nice'"), rederive::program::BadInput);
  CHECK_THROWS_WITH_AS(report_of_text("% rederive: from eq:none\n\\[ x = 1 \\]"),
                       doctest::Contains("eq:none"), rederive::program::BadInput);
}

TEST_CASE("hostile texts end") {
  for (const char* part :
       {"\\[", "$", "{", "\\begin{align}", "\\frac", "\\[ x^", "\\newcommand{\\a}{\\a\\a}\\[\\a\\]",
        "\\left(", "\\[ \\int \\]", "\\[ \\sum_{k=1}^{60} \\sum_{j=1}^{60}", "|", "\\\\", "&="}) {
    Text text;
    for (int k = 0; k < 1'000; ++k) text += part;
    CHECK_NOTHROW((void)report_of_text(text));
  }
  // Long pieces, which a regular expression would match by recursion, and long lists.
  const Text step = "\\[ x = x = x \\]", letters(300'000, 'a');
  Text list;
  for (int k = 0; k < 20'000; ++k) list += "a=b,";
  for (const Text& text :
       {"for $" + letters + "$" + step, "small " + letters + step, letters + "." + step,
        "# " + Text(300'000, '#') + step, "\\[ \\num{" + Text(300'000, '1') + "} = x \\]" + step,
        "\\[ \\si{" + letters + "} = x \\]" + step, "\\[ " + list + " \\]" + step})
    CHECK(report_of_text(text).count(Finding::proved) == 1);
  CHECK_THROWS_WITH_AS(report_of_text("% rederive: " + letters + "\n"), doctest::Contains("2000 characters"),
                       rederive::program::BadInput);
}
