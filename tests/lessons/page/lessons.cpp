// The lessons as a reader meets them. Their texts, numbers rounded, are kept in tests/golden; after a
// change that is meant, write them anew with  REDERIVE_UPDATE_GOLDEN=1 build/tests/test_lessons  and look at
// the difference.
#include <doctest/doctest.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <regex>
#include <tests/run_program.hpp>

namespace fs = std::filesystem;

namespace {

/// Numbers with a point to four significant digits; paths of pictures to their names.
std::string rounded(const std::string& text) {
  static const std::regex number(R"(\d+\.\d+(e[-+]?\d+)?)"), path(R"(\([^()]*/([a-z0-9-]+\.svg)\))");
  const std::string named = std::regex_replace(text, path, "($1)");
  std::string result;
  auto at = named.cbegin();
  for (std::sregex_iterator match(named.cbegin(), named.cend(), number), end; match != end; ++match) {
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, "%.4g", std::stod(match->str()));
    result.append(at, named.cbegin() + match->position());
    result += buffer;
    at = named.cbegin() + match->position() + match->length();
  }
  return result.append(at, named.cend());
}

}  // namespace

TEST_CASE("each is as it was when it was last looked at") {
  REQUIRE(lesson_programs().size() >= 12);
  const bool update = std::getenv("REDERIVE_UPDATE_GOLDEN") != nullptr;
  for (const auto& lesson : lesson_programs()) {
    CAPTURE(lesson);
    TemporaryFolder folder;
    const auto out = folder.path / "lesson.md";
    const Result result = run_program(lesson, {"--format", "markdown", "--out", out.string()});
    CHECK(result.exit_code == 0);
    CHECK(result.err == "");
    const fs::path golden = fs::path(REDERIVE_SOURCE) / "tests" / "golden" / (lesson + ".md");
    const std::string text = rounded(read_file(out));
    if (update) {
      fs::create_directories(golden.parent_path());
      std::ofstream(golden, std::ios::binary) << text;
    }
    const bool same = text == read_file(golden);
    CHECK_MESSAGE(same, "the lesson has changed: see the head of tests/lessons/page/lessons.cpp");
  }
}

TEST_CASE("every verdict of every lesson is as expected") {
  for (const auto& lesson : lesson_programs()) {
    CAPTURE(lesson);
    const Result result = run_program(lesson, {"--quiet"});
    CHECK(result.exit_code == 0);
    CHECK(result.out.find("not as expected") == std::string::npos);
    CHECK(result.out.find("): ") != std::string::npos);
  }
}

TEST_CASE("each has a contents, steps, and a last step that leads to the exercises") {
  const std::string known = run_program("exercises", {"list"}).out;
  for (const auto& lesson : lesson_programs()) {
    CAPTURE(lesson);
    const std::string contents = run_program(lesson, {"--list"}).out;
    CHECK(contents.find("Lesson ") == 0);
    const auto steps = std::count(contents.begin(), contents.end(), '\n') - 1;
    CHECK(steps >= 3);
    const Result last = run_program(lesson, {"--step", std::to_string(steps)});
    CHECK(last.out.find("Try it") != std::string::npos);
    static const std::regex shown("exercises show ([a-z0-9-]+)");
    std::smatch match;
    REQUIRE(std::regex_search(last.out, match, shown));
    CHECK(known.find(match[1].str() + " ") != std::string::npos);
    CHECK(run_program(lesson, {"--step", std::to_string(steps + 1)}).exit_code == 2);
  }
}

TEST_CASE("two runs say the same") {
  for (const auto& lesson : {lesson_programs().at(0), lesson_programs().at(4)})
    CHECK(run_program(lesson, {}).out == run_program(lesson, {}).out);
}

TEST_CASE("pictures are described, derivations are sentences, and no mark is left in the text") {
  static const std::regex fragment(R"((^|\n)(And|Takes|Put|Into|Where|With the half diagonal R):\n)"),
      name(R"(!\[lesson-[^\]]*\])");
  for (const auto& lesson : lesson_programs()) {
    CAPTURE(lesson);
    const std::string text = run_program(lesson, {"--format", "markdown"}).out;
    CHECK(!std::regex_search(text, fragment));
    CHECK(!std::regex_search(text, name));
    CHECK(text.find("t·") == std::string::npos);
  }
}

TEST_CASE("a web page holds all that it shows") {
  TemporaryFolder folder;
  const auto page = folder.path / "page.html";
  REQUIRE(run_program(lesson_programs().at(0), {"--format", "html", "--out", page.string()}).exit_code == 0);
  const std::string text = read_file(page);
  CHECK(text.find("<math") != std::string::npos);
  CHECK(text.find("data:image/svg+xml;base64,") != std::string::npos);
  for (const auto* fetched :
       {"src=\"http", "href=\"http", "<script src", "fetch(", "@import", "url(http", "url(/", "url(\""})
    CHECK_MESSAGE(text.find(fetched) == std::string::npos, fetched);
  CHECK(text.find("@font-face") != std::string::npos);
  CHECK(text.find("alt=\"lesson-") == std::string::npos);
  CHECK(text.size() < 400'000);
  CHECK(std::distance(fs::directory_iterator(folder.path), fs::directory_iterator()) == 1);
}

TEST_CASE("bad usage is told") {
  const std::string lesson = lesson_programs().at(0);
  CHECK(run_program(lesson, {"--step", "0"}).exit_code == 2);
  for (const char* whole : {"--list", "--quiet"})
    CHECK(run_program(lesson, {"--step", "1", whole}).err.find("--step") != std::string::npos);
  CHECK(run_program(lesson, {"--step", "99"}).err.find("99") != std::string::npos);
  CHECK(run_program(lesson, {"--format", "papyrus"}).exit_code == 2);
  CHECK(run_program(lesson, {"--out", "/nowhere/at/all.md"}).exit_code == 2);
  CHECK(run_program(lesson, {"surplus"}).exit_code == 2);
}
