// How to add an equation, a target of emission, a lesson, an exercise, and a paper of your own: the examples
// in the READMEs, followed to the letter.
#include <doctest/doctest.h>

#include <cmath>
#include <tests/installed.hpp>

namespace {

/// The source of a room with `text` put before the first `place` after `mark`.
std::string with(const std::string& file, const std::string& mark, const std::string& place,
                 const std::string& text) {
  std::string all = read_file(source + "/" + file);
  const auto from = all.find(mark);
  REQUIRE(from != std::string::npos);
  const auto at = all.find(place, from);
  REQUIRE(at != std::string::npos);
  return all.insert(at, text);
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  REQUIRE(contains(text, from));
  return text.replace(text.find(from), from.size(), to);
}

/// What three guides change in the rooms, built on the installed tree: as `ledger`, `emit` and a lesson in
/// its bin.
const fs::path& changed_programs() {
  static const fs::path programs = [] {
    const std::string kinematics = "derivations/rocking_block/kinematics.cpp",
                      dialect = "derivations/emit/dialect";
    const auto equation = [](const char* language, int n) {
      return block("derivations/paper/README.md", "## Add an equation", language, n);
    };
    const auto target = [](int n) {
      return block("derivations/emit/README.md", "## Add a target of emission", "cpp", n);
    };
    const TemporaryFolder folder;
    write_file(folder.path / "kinematics.cpp",
               with(kinematics, "void derive_kinematics(Derivations& rows) {", "\n}\n", equation("cpp", 0)));
    fs::create_directories(folder.path / "derivations/emit");
    const std::string header = read_file(source + "/" + dialect + ".hpp");
    const auto names = header.find("enum class Target {");
    REQUIRE(names != std::string::npos);
    write_file(folder.path / "derivations/emit/dialect.hpp",
               replaced(header, header.substr(names, header.find('\n', names) + 1 - names), target(0)));
    const std::string class_of = "/// Returns the only dialect of a language.";
    write_file(folder.path / "dialect.cpp",
               replaced(with(dialect + ".cpp", "target_languages() {", "  };\n", target(2)), class_of,
                        target(1) + "\n" + class_of));
    write_file(folder.path / "lesson-13-the-size-of-the-block.cpp",
               block("lessons/README.md", "## Add a lesson", "cpp"));
    make_project(folder.path,
                 "find_package(Rederive 1.0 REQUIRED COMPONENTS rocking_block_lessons)\n"
                 "include_directories(" +
                     source +
                     ")\n"  // with the headers that are not installed
                     "add_executable(ledger kinematics.cpp " REDERIVE_LEDGER_MAIN
                     ")\n"
                     "target_link_libraries(ledger PRIVATE rederive::rocking_block_lessons)\n"
                     "add_executable(emit dialect.cpp " REDERIVE_EMIT_MAIN
                     ")\n"
                     "target_include_directories(emit BEFORE PRIVATE .)\n"
                     "target_link_libraries(emit PRIVATE rederive::rocking_block)\n"
                     "add_executable(lesson-13-the-size-of-the-block lesson-13-the-size-of-the-block.cpp)\n"
                     "target_link_libraries(lesson-13-the-size-of-the-block PRIVATE rederive::lessons "
                     "rederive::rocking_block)\n");
    said(folder.path, "cp b/ledger b/emit b/lesson-13* " + quoted(prefix() / "bin"));
    return prefix() / "bin";
  }();
  return programs;
}

void append(const fs::path& file, const std::string& text) {
  std::ofstream(file, std::ios::app) << "\n" << text;
}

}  // namespace

TEST_CASE("an equation is added to the ledger as the README of the paper says") {
  const TemporaryFolder folder;
  const fs::path equations = folder.path / "equations.toml";
  write_file(equations, read_file(prefix() / "share/rederive/equations.toml"));
  append(equations, block("derivations/paper/README.md", "## Add an equation", "toml"));
  const std::vector<std::string> show{"--equations", equations, "show", "w1", "--json"};
  const Result shown = run_program(changed_programs() / "ledger", show);
  CHECK(shown.exit_code == 0);
  CHECK(nlohmann::json::parse(shown.out)["verdict"] == "proved");

  // and the new row can turn red like any other
  write_file(equations, replaced(read_file(equations), "R*(1 - cos(alpha))", "R*(1 - sin(alpha))"));
  const Result spoiled = run_program(changed_programs() / "ledger", show);
  CHECK(spoiled.exit_code == 1);
  CHECK(nlohmann::json::parse(spoiled.out)["verdict"] == "refuted");
}

TEST_CASE("a target of emission is added as the README of emit says, and computes what the others do") {
  const TemporaryFolder folder;
  const std::string path = "export PATH=" + quoted(changed_programs()) + ":$PATH; ";
  const std::string value =
      said(folder.path, path + replaced(block("derivations/emit/README.md", "## Add a target", "sh"),
                                        "gnuplot -e", "gnuplot 2>&1 -e"));
  CHECK(contains(read_file(source + "/derivations/emit/README.md"), value.substr(0, value.find('\n'))));
  CHECK(contains(said(folder.path, path + "emit --help"), "gnuplot"));

  said(
      folder.path,
      path + "emit --list --json >list && emit --target python >emitted.py && emit --target gnuplot >all.gp");
  write_file(folder.path / "driver.py", R"py(
import emitted, json
def both(text, value):
    print(f'print sprintf("%.17g {value!r}", {text})')
print('set print "-"; load "all.gp"')
for function in json.load(open("list"))["functions"]:
    name, at = function["name"], [0.3 + 0.1 * k for k in range(len(function["arguments"]))]
    given = "(" + ", ".join(map(repr, at)) + ")"
    try:
        both(name + given, getattr(emitted, name)(*at))
        for part in function["derivatives"]:
            every = getattr(emitted, name + "_with_derivatives")(*at)
            both(f"{name}_with_derivatives_d_{part}{given}", getattr(every, "d_" + part))
    except ValueError:  # has no value there
        pass
)py");
  std::istringstream pairs(said(folder.path, "/usr/bin/python3 driver.py >all && gnuplot all"));
  int count = 0;
  for (double plotted = 0, expected = 0; pairs >> plotted >> expected; ++count)
    CHECK(std::fabs(plotted - expected) <= 1e-12 * std::fabs(expected));
  CHECK(count > 40);
  // linked anew, in another folder, it still writes the header of the build to the byte
  CHECK(said(folder.path, path + "emit --target cpp") == read_file(build + "/emitted/rocking_block.hpp"));
}

TEST_CASE("a lesson is added as the README of the lessons says, and is there in every format") {
  append(prefix() / "share/rederive/equations_of_lessons.toml",
         block("lessons/README.md", "## Add a lesson", "toml"));
  const std::string lesson = changed_programs() / "lesson-13-the-size-of-the-block";
  CHECK(run_program(lesson, {"--quiet"}).out == "(13): proved\n");
  for (const char* format : {"unicode", "plain", "latex", "markdown", "notebook", "html"}) {
    CAPTURE(format);
    const Result whole = run_program(lesson, {"--format", format});
    CHECK(whole.exit_code == 0);
    CHECK(whole.err == "");
    CHECK(contains(whole.out, "twice as high"));
  }
  CHECK(contains(run_program(lesson, {"--step", "2", "--format", "plain"}).out, "y_c = R - R*cos(alpha)"));
  const std::string before = prefix() / "bin/lesson-12-is-the-monument-safe";
  CHECK(contains(run_program(before, {"--format", "html"}).out, "lesson-13-the-size-of-the-block.html"));
}

TEST_CASE("an exercise is added as the README of the classroom says") {
  const fs::path exercises = prefix() / "share/rederive/exercises/lesson-03.toml";
  const auto run = [](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"--progress", prefix() / "progress"});
    return run_program(prefix() / "bin/exercises", arguments);
  };
  CHECK(run({"show", "worked-example"}).exit_code == 2);
  append(exercises, block("lessons/exercises/README.md", "## Add an exercise", "toml"));
  CHECK(run({"check", "worked-example", "y_c = R*(1 - cos(alpha))"}).exit_code == 0);
  const Result slip = run({"check", "worked-example", "R*(1 - sin(alpha))"});
  CHECK(slip.exit_code == 1);
  CHECK(contains(slip.out, "Which side of the triangle"));
}

namespace {

constexpr auto papers_guide = "lessons/papers/README.md";

/// Runs a script with the installed programs on the PATH.
std::string said_with_programs(const fs::path& folder, const std::string& script) {
  return said(folder, "PATH=" + quoted(prefix() / "bin") + ":$PATH; XDG_STATE_HOME=" +
                          quoted(folder / "state") + "; export XDG_STATE_HOME; " + script);
}

/// Follows the guide from its first file on, with the derivations in one language.
void follow_guide_to_papers(const std::string& language, const std::string& before) {
  const TemporaryFolder folder;
  const fs::path rod = folder.path / "rod";
  fs::create_directory(rod);
  const auto part = [](const char* kind, int n = 0) {
    return block(papers_guide, "## A paper in an afternoon", kind, n);
  };
  write_file(rod / "paper.toml", part("toml"));
  write_file(rod / "equations.toml", part("toml", 1));
  write_file(rod / ("derive." + language), part(language == "py" ? "python" : "cpp"));
  const std::string found = said_with_programs(folder.path, before + part("sh"));
  for (const char* line :
       {"3 rows: 2 proved, 1 refuted", "kind of error    factor", "   0 survived", "All checks pass."})
    CHECK_MESSAGE(contains(found, line), found);
  CHECK(nlohmann::json::parse(said_with_programs(folder.path, "rederive rod --json"))["paper"] ==
        "On a rod that swings on a hinge");

  write_file(rod / "functions.toml", part("toml", 2));
  const std::string numbers = said_with_programs(folder.path, part("sh", 1));
  CHECK_MESSAGE(contains(numbers, "def frequency(g, L):"), numbers);
  CHECK_MESSAGE(contains(numbers, "t = 0.4159780463"), numbers);
  CHECK(read_file(folder.path / "swing.csv").starts_with("t,theta,thetadot\n0,0.5,0\n"));

  for (const char* file : {"claims.toml", "lesson-01.md", "exercises.toml"})
    fs::copy_file(source + "/lessons/papers/rod/" + file, rod / file);
  fs::create_directories(folder.path / "CLASS/ada");
  write_file(folder.path / "CLASS/ada/period.txt", "sqrt(3*g/(2*L))\n");
  const std::string taught = said_with_programs(folder.path, part("sh", 2));
  CHECK_MESSAGE(contains(taught, "Lesson 1. A rod on its hinge"), taught);
  CHECK_MESSAGE(contains(taught, "ada,period,correct"), taught);
  CHECK(contains(read_file(folder.path / "pages/ledger.html"), "refuted"));

  // the slip mended is a verdict that was not expected
  write_file(rod / "equations.toml", replaced(part("toml", 1), "sqrt(2*g/(3*L))", "sqrt(3*g/(2*L))"));
  said_with_programs(folder.path, "! rederive rod show 3");
}

}  // namespace

TEST_CASE("a paper of one's own in C++ goes from its equations to a class as the guide says") {
  follow_guide_to_papers("cpp", "rederive rod build\n");
}

TEST_CASE("a paper of one's own in Python goes from its equations to a class as the guide says") {
  if (run_program("/usr/bin/python3", {"-c", "import sympy"}).exit_code != 0 ||
      !fs::exists(build + "/python/rederive"))
    return skip("Python's module sympy or the module rederive is not there");
  follow_guide_to_papers("py", "");
}

TEST_CASE("a project builds the derivations of a paper by rederive_paper") {
  const TemporaryFolder folder;
  for (const char* file : {"paper.toml", "equations.toml", "derive.cpp"})
    fs::copy_file(source + "/lessons/papers/rod/" + file, folder.path / file);
  make_project(folder.path, "find_package(Rederive REQUIRED COMPONENTS paper)\nrederive_paper(rod)\n");
  CHECK(read_file(folder.path / "derivations.json") ==
        read_file(source + "/lessons/papers/rod/derivations.json"));
}
