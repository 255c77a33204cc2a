// TOML files that others write: what cannot be used is refused with file, line and what would be right.
#include <doctest/doctest.h>

#include <derivations/paper/ledger.hpp>
#include <derivations/program/toml_table.hpp>
#include <lessons/exercises/exercise.hpp>
#include <lessons/exercises/prepared.hpp>
#include <lessons/ledger/claims.hpp>
#include <lessons/ledger/prove_table.hpp>
#include <lessons/rocking_block/claims.hpp>
#include <lessons/rocking_block/course.hpp>
#include <tests/block.hpp>
#include <tests/cases.hpp>
#include <tests/random.hpp>
#include <tests/run_program.hpp>

using namespace rederive::decide;
using namespace rederive::program;
using namespace rederive::paper;
using namespace rederive::rocking_block;
using namespace rederive::ledger;
using namespace rederive::classroom;
using namespace rederive::test;
namespace fs = std::filesystem;
using Text = std::string;

namespace {

/// Returns the text of a table in full.
Text in_full(const Text& text) {
  static const std::map<Text, Text> abbreviations = [] {
    std::map<Text, Text> result;
    for (const Cells& row : cases("abbreviations")) result[row[0]] = row[1];
    return result;
  }();
  return filled(text, abbreviations);
}

/// A file of one name in a folder of its own, written anew for each text.
struct TomlFile {
  const TomlFile& with(const Text& text) const {
    write_file(path(), text);
    return *this;
  }
  fs::path path() const { return folder.path / "file.toml"; }

  TemporaryFolder folder;
};

std::vector<Claim> claims_in(const TomlFile& file) {
  return read_claims({.file = file.path(), .checks = rederive::rocking_block::claims().checks});
}

std::vector<rederive::classroom::Exercise> exercises_in(const TomlFile& file) {
  return rederive::classroom::read_exercises(rederive::rocking_block::course(), file.folder.path);
}

void read_tables(const TomlFile& file) { (void)tables_of(file.path(), "row"); }
void read_ledger(const TomlFile& file) { (void)read_rows(file.path()); }

/// Checks that reading the text is refused with a complaint that begins with the file and these words.
template <class Read>
void check_refused(const Text& text, const Text& complaint, const Read& read) {
  const TomlFile file;
  const Text expected = file.path().string() + ":" + complaint;
  try {
    read(file.with(text));
    FAIL_CHECK("it is accepted");
  } catch (const BadInput& error) {
    CHECK(Text(error.what()).substr(0, expected.size()) == expected);
  }
}

template <class Read>
void check_section(const char* section, const Read& read) {
  each_case(section, [&](Text text, Text complaint) { check_refused(in_full(text), complaint, read); });
}

}  // namespace

TEST_CASE("what is not TOML, or nests without end, is refused with its line") {
  check_section("not_TOML", read_tables);
  Text deep = "a", deeper = "a = ";
  for (int k = 0; k < 4900; ++k) deep += ".a", deeper += "[";
  check_refused("a = \"\xff\"\n", "1: ", read_tables);
  check_refused(deeper + "\n", "1: ", read_tables);
  check_refused(deep + " = 1\n", "1: there is no key 'a' here", read_tables);
  check_refused("\na = \"" + Text(10'000, 'x') + "\"\n", "2: a line has more than 10000 bytes", read_tables);
  const TomlFile file;
  CHECK_THROWS_AS(read_tables(file), BadInput);
  CHECK_THROWS_AS(tables_of(file.folder.path, "row"), BadInput);
  CHECK_THROWS_AS(read_tables(file.with(Text(2'000'001, '\n'))), BadInput);
}

TEST_CASE("a file is refused with the line of what it should not have: keys, types, words, cycles") {
  check_section("ledger", read_ledger);
  check_section("ledger_cycles", read_ledger);
  check_section("claims", [](const TomlFile& file) { (void)claims_in(file); });
  check_section("judged_claims", [](const TomlFile& file) {
    for (const Claim& one : claims_in(file)) (void)judge(one, rederive::rocking_block::claims());
  });
  check_section("statements", [](const TomlFile& file) { (void)read_table(file.path()); });
  check_section("exercises", [](const TomlFile& file) { (void)exercises_in(file); });
  check_section("varying_exercises", [](const TomlFile& file) { (void)exercises_in(file); });
  check_section("prepared_exercises", [](const TomlFile& file) {
    for (const auto& one : exercises_in(file)) (void)rederive::classroom::prepare(one);
  });
}

TEST_CASE("rows that follow from others in ways that meet are not a cycle, and long ways need no stack") {
  Text text = in_full("$row(0) from ()$; ");
  for (int k = 1; k < 5000; ++k)
    text += in_full(
        fmt::format("$row({}) from (\"{}\", \"{}\")$; ", k, std::to_string(k - 1), std::to_string(k / 2)));
  const TomlFile file;
  CHECK(read_rows(file.with(text).path()).size() == 5000);
}

TEST_CASE("data that ship: lessons, cells of notebooks and words of slips are read strictly, too") {
  const TemporaryFolder prefix;
  const fs::path bin = prefix.path / "bin", data = prefix.path / "share/rederive", built = REDERIVE_PROGRAMS;
  fs::create_directories(bin);
  fs::create_directories(data.parent_path());
  fs::create_directories(prefix.path / "lib/python3/rederive");  // as if the module were installed
  write_file(prefix.path / "lib/python3/rederive/_numbers.test.so", "");
  const Text lesson = lesson_programs().at(0);
  for (const Text& program : {lesson, Text("exercises")}) fs::copy(built / program, bin / program);
  fs::copy(built.parent_path() / "share/rederive", data,
           fs::copy_options::recursive | fs::copy_options::copy_symlinks);
  const std::map<Text, Cells> commands{
      {"text", {lesson}},
      {"notebook", {lesson, "--format", "notebook"}},
      {"slip",
       {"exercises", "--progress", prefix.path / "progress", "check", "height-of-centre", "R*sin(theta)"}}};
  each_case("shipped", [&](Text name, Text more, Text command, Text complaint) {
    const Text before = read_file(data / name);
    fs::remove(data / name);  // a link
    write_file(data / name, before + more);
    const Cells& words = commands.at(command);
    const Result r = run_program(bin / words[0], rest(words, 1));
    CHECK(r.exit_code == 2);
    const auto line = std::count(before.begin(), before.end(), '\n') + 1;
    CHECK(contains(r.err, fmt::format("{}:{}: {}", fs::path(name).filename().string(), line, complaint)));
    write_file(data / name, before);
  });
}
