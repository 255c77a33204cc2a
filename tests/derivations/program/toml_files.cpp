// TOML files that others write: what cannot be used is refused with file, line and what would be right.
#include <doctest/doctest.h>

#include <derivations/paper/ledger.hpp>
#include <derivations/program/toml_table.hpp>
#include <lessons/exercises/exercise.hpp>
#include <lessons/exercises/judge.hpp>
#include <lessons/ledger/claims.hpp>
#include <lessons/ledger/prove_table.hpp>
#include <lessons/rocking_block/claims.hpp>
#include <lessons/rocking_block/course.hpp>
#include <tests/block.hpp>
#include <tests/run_program.hpp>

using namespace rederive;
namespace fs = std::filesystem;

namespace {

/// A file of one name in a folder of its own, written anew for each text.
class TomlFile {
 public:
  fs::path with(const std::string& text) const {
    std::ofstream(path(), std::ios::binary) << text;
    return path();
  }
  fs::path path() const { return folder_.path / "file.toml"; }
  fs::path folder() const { return folder_.path; }

 private:
  TemporaryFolder folder_;
};

/// A text that is refused, and the end of "FOLDER/file.toml:…", with which the complaint begins.
struct Refusal {
  std::string text, complaint;
};

template <class Read>
void check_refusals(const std::vector<Refusal>& refusals, const Read& read) {
  const TomlFile file;
  for (const auto& [text, complaint] : refusals) {
    CAPTURE(text);
    const std::string expected = file.path().string() + ":" + complaint;
    (void)file.with(text);
    try {
      read(file);
      FAIL_CHECK("it is accepted");
    } catch (const BadInput& error) {
      CHECK(std::string(error.what()).substr(0, expected.size()) == expected);
    }
  }
}

/// A row of equations.toml on six lines, with another id and more lines behind.
std::string row(const std::string& id, const std::string& follows_from = "", const std::string& more = "") {
  return "[[equation]]\nid = \"" + id + "\"\nkind = \"equation\"\nprinted = \"y_c = R\"\nfollows_from = [" +
         follows_from + "]\nexpected = \"proved\"\n" + more;
}

const std::string claim =
    "[[claim]]\nid = \"a\"\nwhere = \"1\"\nstatement = \"S\"\nexpected = \"confirmed\"\n"
    "check = \"all_cases_covered\"\nmethod = \"M\"\n";

/// An exercise without its last line, on seven lines.
const std::string exercise =
    "[[exercise]]\nid = \"mine\"\nlesson = 1\ntitle = \"T\"\nstatement = \"S\"\nkind = \"number\"\n"
    "answer = { function = \"least_amplitude\", arguments = { omega = \"2\" } }\n";
const std::string formula =
    "[[exercise]]\nid = \"mine\"\ntitle = \"T\"\nstatement = \"S\"\nkind = \"expression\"\n"
    "symbols = [\"R\", \"alpha\"]\n";

std::vector<Claim> claims_in(const TomlFile& file) {
  return read_claims({.file = file.path(), .checks = rocking_block::claims().checks});
}

void prepare_all(const TomlFile& file) {
  for (const auto& one : classroom::read_exercises(rocking_block::course(), file.folder()))
    (void)classroom::prepare(one);
}

}  // namespace

TEST_CASE("what is no TOML, or nests without end, is refused with its line") {
  std::string deep = "a", deeper = "a = ";
  for (int k = 0; k < 4900; ++k) deep += ".a", deeper += "[";
  const std::string long_line = "a = \"" + std::string(10'000, 'x') + "\"\n";
  check_refusals({{"\n[[row]\n", "2: "},
                  {"a = \"\n\"", "1: "},
                  {"a = 1\na = 2\n", "2: "},
                  {"a = \"\xff\"\n", "1: "},
                  {deeper + "\n", "1: "},
                  {deep + " = 1\n", "1: there is no key 'a' here"},
                  {"\n" + long_line, "2: a line has more than 10000 bytes"},
                  {"", "1: there is no [[row]] in this file"}},
                 [](const TomlFile& file) { (void)tables_of(file.path(), "row"); });
  const TomlFile file;
  CHECK_THROWS_AS(tables_of(file.path(), "row"), BadInput);
  CHECK_THROWS_AS(tables_of(file.folder(), "row"), BadInput);
  CHECK_THROWS_AS(tables_of(file.with(std::string(2'000'001, '\n')), "row"), BadInput);
}

TEST_CASE("rows of the ledger: tables, keys, types and words that there are not") {
  check_refusals(
      {{row("1") + "[[equaton]]\nid = \"2\"\n",
        "7: there is no key 'equaton' here: did you mean 'equation'?"},
       {"title = \"x\"\n" + row("1"), "1: there is no key 'title' here; the keys are equation"},
       {"[equation]\nid = \"1\"\n", "1: 'equation' must be a list of tables: [[equation]]"},
       {"equation = 3\n", "1: 'equation' must be a list of tables"},
       {"equation = [3]\n", "1: 'equation' must be a list of tables"},
       {row("1", "", "titel = \"x\"\n"), "7: row 1: there is no key 'titel' here"},
       {row("1", "", "[equation.more]\nx = 1\n"), "7: row 1: there is no key 'more' here"},
       {row("1", "", "note = 3\n"), "7: row 1: 'note' must be a string"},
       {row("1", "", "note = 2020-01-01\n"), "7: row 1: 'note' must be a string"},
       {row("1", "3"), "5: row 1: 'follows_from' must be a list of strings"},
       {row(""), "2: 'id' is missing or empty"},
       {row("1\\n"), "2: 'id' must be one line of printable characters"},
       {"[[equation]]\nid = \"1\"\nkind = \"equation\"\n", "1: row 1: 'expected' is missing or empty"},
       {"[[equation]]\nid = \"1\"\nkind = \"equatoin\"\n",
        "3: row 1: 'kind' cannot be 'equatoin': did you mean 'equation'?; it must be one of equation, "
        "inequality"},
       {"[[equation]]\nid = \"1\"\nkind = \"equation\"\nexpected = \"true\"\n",
        "4: row 1: 'expected' cannot be 'true'; it must be one of proved"},
       {row("1", "", "error = \"banana\"\n"), "7: row 1: 'error' cannot be 'banana'; it must be one of sign"},
       {row("1", "", "error = \"sign and banana\"\n"), "7: row 1: 'error' cannot be 'banana'"},
       {row("1", "", "statement = \"R > 0\"\n"), "7: row 1: a row of kind 'result'"},
       {row("1") + row("1"), "8: row 1: a second row has this id; the first is at "}},
      [](const TomlFile& file) { (void)read_rows(file.path()); });
}

TEST_CASE("rows of the ledger that follow from themselves, near or far, or from no row") {
  check_refusals({{row("1", "\"1\""), "5: row 1: it follows from itself: 1 from 1"},
                  {row("1", "\"2\"") + row("2", "\"3\"") + row("3", "\"1\""),
                   "5: row 1: it follows from itself: 1 from 2 from 3 from 1"},
                  {row("1", "\"2\"") + row("2", "\"3\"") + row("3", "\"2\""),
                   "11: row 2: it follows from itself: 2 from 3 from 2"},
                  {row("11") + row("2", "\"11\", \"12\""),
                   "11: row 2: it follows from '12', which is not a row: did you mean '11'?"}},
                 [](const TomlFile& file) { (void)read_rows(file.path()); });
  const TomlFile file;  // ways that meet are no cycle, and long ones need no stack
  std::string text = row("0");
  for (int k = 1; k < 5000; ++k)
    text += row(std::to_string(k), "\"" + std::to_string(k - 1) + "\", \"" + std::to_string(k / 2) + "\"");
  CHECK(read_rows(file.with(text)).size() == 5000);
}

TEST_CASE("claims: keys, types, checks and numbers that there are not") {
  check_refusals({{claim + "whence = \"x\"\n", "8: claim a: there is no key 'whence' here"},
                  {claim + "[[claims]]\n", "8: there is no key 'claims' here: did you mean 'claim'?"},
                  {claim + claim, "9: claim a: a second claim has this id; the first is at "},
                  {claim + "omega_ratio = \"2\"\n", "8: claim a: 'omega_ratio' must be a number"},
                  {claim + "omega_ratio = nan\n", "8: claim a: 'omega_ratio' must be a finite number"},
                  {claim + "amplitude = -1\n", "8: claim a: 'amplitude' must be above 0"},
                  {claim + "impacts = 2\n", "8: claim a: 'impacts' must be from 0 to 1"},
                  {claim + "impacts = 1.5\n", "8: claim a: 'impacts' must be a whole number"},
                  {"[[claim]]\nid = \"a\"\nexpected = \"true\"\n",
                   "3: claim a: 'expected' cannot be 'true'; it must be one of "},
                  {"[[claim]]\nid = \"a\"\ncheck = \"all_case_covered\"\n",
                   "3: claim a: 'check' cannot be 'all_case_covered': did you mean 'all_cases_covered'?"}},
                 [](const TomlFile& file) { (void)claims_in(file); });
}

TEST_CASE("a claim whose check cannot be made, or whose words do not fit, is refused with its line") {
  const auto with_check = [](const std::string& check, const std::string& more) {
    return "[[claim]]\nid = \"a\"\nwhere = \"1\"\nstatement = \"S\"\nexpected = \"confirmed\"\ncheck = \"" +
           check +
           "\"\nmethod = \"M\"\nconfirmed = \"C\"\nrefuted = \"R\"\nqualified = \"Q\"\nundecided = \"U\"\n" +
           more;
  };
  check_refusals({{with_check("beyond_the_rows", "found = \"{}\"\nrows = [\"no such row\"]\n"),
                   "1: claim a: the check 'beyond_the_rows' cannot use"},
                  {with_check("angle_of_stockiness", "found = \"{\"\n"), "1: claim a: its words do not fit"},
                  {with_check("angle_of_stockiness", ""), "1: claim a is qualified, but it has no words"}},
                 [](const TomlFile& file) {
                   for (const Claim& one : claims_in(file)) (void)judge(one, rocking_block::claims());
                 });
}

TEST_CASE("statements for the prover: keys, types and words that there are not") {
  const std::string start = "[[row]]\ngroup = \"g\"\nleft = \"x\"\nright = \"x\"\nexpected = \"proved\"\n";
  check_refusals(
      {{start + "assumes = [\"x > 0\"]\n", "6: there is no key 'assumes' here: did you mean 'assume'?"},
       {start + "assume = \"x > 0\"\n", "6: 'assume' must be a list of strings"},
       {start + "limit = 1\n", "6: 'limit' must be true or false"},
       {start + "order = 13\n", "6: 'order' must be from 0 to 12"},
       {start + "why = \"a\\u001b[2Jb\"\n", "6: 'why' must be one line of printable characters"},
       {"[[row]]\nleft = 1\n", "2: 'left' must be a string"},
       {"[[row]]\nexpected = \"prooved\"\n", "2: 'expected' cannot be 'prooved': did you mean 'proved'?"},
       {"[[row]]\nleft = \"x\"\n", "1: 'group' is missing or empty"},
       {"row = [[1]]\n", "1: 'row' must be a list of tables"}},
      [](const TomlFile& file) { (void)read_table(file.path()); });
}

TEST_CASE("exercises: keys, types, words, symbols, functions and derivations that there are not") {
  const auto answer = [](const std::string& text) { return formula + "answer = { " + text + " }\n"; };
  const std::string right = "answer = { derivation = \"13\" }\n";
  check_refusals(
      {{exercise + "hint = [\"x\"]\n",
        "8: exercise mine: there is no key 'hint' here: did you mean 'hints'?"},
       {exercise + "[[exercises]]\n", "8: there is no key 'exercises' here: did you mean 'exercise'?"},
       {exercise + exercise, "9: exercise mine: a second exercise has this id; the first is at "},
       {exercise + "digits = 100\n", "8: exercise mine: 'digits' must be from 1 to 17"},
       {exercise + "hints = \"x\"\n", "8: exercise mine: 'hints' must be a list of strings"},
       {exercise + "unit = \"smoot\"\n", "8: exercise mine: 'smoot' must be a unit"},
       {exercise + "bound = \"!=\"\nname = \"g\"\n", "8: exercise mine: 'bound' cannot be '!='"},
       {exercise + "bound = \">=\"\n", "8: exercise mine: 'bound' needs a 'name'"},
       {exercise + "name = \"2*\"\n", "8: exercise mine: '2*' in 'name': "},
       {exercise + "statements = \"x\"\n", "8: exercise mine: there is no key 'statements' here"},
       {exercise + "[[exercise.slips]]\n",
        "8: exercise mine: there is no key 'slips' here: did you mean 'slip'?"},
       {exercise + "[exercise.slip]\n", "8: exercise mine: 'slip' must be a list of tables: [[slip]]"},
       {exercise + "[[exercise.slip]]\nnote = \"sign\"\n", "8: exercise mine: 'says' is missing or empty"},
       {exercise + "[[exercise.slip]]\nnote = \"sign\"\nsays = \"s\"\nhint = \"h\"\n",
        "8: exercise mine: exactly one of 'road' and 'typed' is needed"},
       {exercise + "[[exercise.option]]\ntext = \"t\"\nclaim = \"1 = 1\"\n",
        "8: exercise mine: options belong to exercises of the kind 'choice'"},
       {"[[exercise]]\nid = \"a/b\"\n", "2: exercise a/b: an id must not contain"},
       {"[[exercise]]\nid = \"mine\"\nkind = \"nombre\"\n", "3: exercise mine: 'kind' cannot be 'nombre'"},
       {formula, "1: exercise mine: 'answer' is missing"},
       {answer("derivation = \"1333\""), "7: exercise mine: 'derivation' cannot be '1333'"},
       {answer("row = \"nowhere\""), "7: exercise mine: 'row' cannot be 'nowhere'"},
       {answer("row = \"17b\""), "7: exercise mine: 'row' belongs to exercises of the kinds"},
       {answer("function = \"least_amplitud\""),
        "7: exercise mine: 'function' cannot be 'least_amplitud': did you mean 'least_amplitude'?"},
       {answer("function = \"least_amplitude\""), "7: exercise mine: the argument omega is missing"},
       {answer("function = \"least_amplitude\", arguments = { omega = \"nan\" }"),
        "7: exercise mine: 'nan' in 'arguments' must be a number"},
       {answer("function = \"least_amplitude\", arguments = { omega = \"1e-9\" }"),
        "7: exercise mine: the argument omega must be from 0.01 to 1000"},
       {answer("function = \"least_amplitude\", arguments = { omga = \"1\" }"),
        "7: exercise mine: 'arguments' cannot be 'omga': did you mean 'omega'?"},
       {answer("derivation = \"13\", sides = \"left\""), "7: exercise mine: there is no key 'sides' here"},
       {answer("derivation = \"13\", side = \"top\""), "7: exercise mine: 'side' cannot be 'top'"},
       {answer("derivation = \"13\", side = \"whole\""), "7: exercise mine: side = \"whole\" is an equation"},
       {answer("derivation = \"13\", row = \"13\""),
        "7: exercise mine: exactly one of 'derivation', 'row' and 'function'"},
       {answer("derivation = \"13\", put = { thta = \"0\" }"),
        "7: exercise mine: 'put' cannot be 'thta': did you mean 'theta'?"},
       {answer("derivation = \"13\", put = { theta = \"2*\" }"), "7: exercise mine: '2*' in 'put': "},
       {answer("derivation = \"13\", put = { theta = \"1/0\" }"), "7: exercise mine: '1/0' in 'put': "},
       {answer("derivation = \"13\", put = { theta = 0 }"),
        "7: exercise mine: 'theta' in 'put' must be a string"},
       {answer("derivation = \"13\", solve_for = \"q\""), "7: exercise mine: 'solve_for' cannot be 'q'"},
       {answer("derivation = \"13\", differentiate = \"q\""),
        "7: exercise mine: 'differentiate' cannot be 'q'"},
       {formula + right + "pivot = \"q\"\n", "8: exercise mine: 'pivot' cannot be 'q'"},
       {formula + right + "given = [\"alpha > \"]\n", "8: exercise mine: 'alpha > ' in 'given': an operand"},
       {formula + right + "given = [\"alpha\"]\n",
        "8: exercise mine: 'alpha' in 'given': a relation is expected"},
       {formula + right + "range = { theta = \"(0, 1)\" }\n",
        "8: exercise mine: there is no key 'range' here"},
       {"[[exercise]]\nid = \"mine\"\ntitle = \"T\"\nstatement = \"S\"\nkind = \"expression\"\nsymbols = "
        "[\"Q\"]\n" +
            right,
        "6: exercise mine: 'symbols' cannot be 'Q'"}},
      [](const TomlFile& file) { (void)classroom::read_exercises(rocking_block::course(), file.folder()); });
}

TEST_CASE("exercises: what varies, and what stands in braces") {
  const auto with = [](const std::string& vary, const std::string& example) {
    return exercise + "vary = { " + vary + " }\nexample = \"" + example + "\"\n";
  };
  check_refusals(
      {{with("h = []", "{h}"), "8: exercise mine: 'h' in 'vary': the list is empty"},
       {with("h = 3", "{h}"), "8: exercise mine: 'h' must be a list of strings, or of tables"},
       {with("h = [3]", "{h}"), "8: exercise mine: 'h' must be a list of strings, or of tables"},
       {with("h = [{ h = 3 }]", "{h}"), "8: exercise mine: 'h' in 'h' must be a string"},
       {with("h = [\"2:1:0.1\"]", "{h}"), "8: exercise mine: 'h' in 'vary': '2:1:0.1' must be FROM:TO:STEP"},
       {with("h = [{ a = \"1:2:1\", b = \"1:3:1\" }]", "{a}"),
        "8: exercise mine: 'h' in 'vary': only one name"},
       {with("h = [{ a = \"1\" }, { b = \"1\" }]", "{a}"),
        "8: exercise mine: 'h' in 'vary': all tables of a list"},
       {with("h = [\"1\"], b = [{ h = \"2\" }]", "{h}"),
        "8: exercise mine: 'h' in 'vary': another list also has the name"},
       {with("b = [\"1\"]", "{h}"), "9: exercise mine: {h}: 'h' does not vary"},
       {exercise + "example = \"{h}\"\n", "8: exercise mine: {h}: 'h' does not vary"},
       {with("h = [\"{b}\"], b = [\"1\"]", "{h}"),
        "8: exercise mine: 'h' in 'vary': '{b}' must be a text without braces"},
       {with("h = [\"1\"]", "h}"), "9: exercise mine: a closing brace has no opening brace: h}"},
       {with("h = [\"1\"]", "{h"), "9: exercise mine: an opening brace has no closing brace: {h"},
       {with("h = [\"r\"]", "{asin(1/h)}"),
        "9: exercise mine: {asin(1/h)}: 'h' is 'r' here, which is not a number"},
       {with("h = [\"0\"]", "{1/h}"), "9: exercise mine: {1/h} has no value here"},
       {with("h = [\"0.5\"]", "{asin(1/h)}"), "9: exercise mine: {asin(1/h)} has no value here"},
       {with("h = [\"9\"]", "{exp(exp(h))}"), "9: exercise mine: {exp(exp(h))} has no value here"}},
      [](const TomlFile& file) { (void)classroom::read_exercises(rocking_block::course(), file.folder()); });
}

TEST_CASE("an exercise whose data do not hold together is refused with its line once it is made ready") {
  const auto number = [](const std::string& answer, const std::string& more) {
    return "\n[[exercise]]\nid = \"mine\"\ntitle = \"T\"\nstatement = \"S\"\nkind = \"number\"\nanswer = { " +
           answer + " }\n" + more;
  };
  const std::string slip = "[[exercise.slip]]\nnote = \"sign\"\nsays = \"s\"\nhint = \"h\"\ntyped = ";
  check_refusals({{number("derivation = \"13\"", ""), "2: exercise mine: a number"},
                  {number("derivation = \"13\", solve_for = \"theta\"", ""),
                   "2: exercise mine: the equation is not linear in theta"},
                  {number("derivation = \"u5\", put = { g = \"9\", R = \"1\" }", slip + "\"R\"\n"),
                   "2: exercise mine: "}},
                 prepare_all);
}

TEST_CASE("data that ship: lessons, cells of notebooks and words of slips are read strictly, too") {
  const TemporaryFolder prefix;
  const fs::path bin = prefix.path / "bin", data = prefix.path / "share/rederive", built = REDERIVE_PROGRAMS;
  fs::create_directories(bin);
  fs::create_directories(data.parent_path());
  fs::create_directories(prefix.path / "lib/python3/rederive");  // as if the module were installed
  std::ofstream(prefix.path / "lib/python3/rederive/_numbers.test.so");
  const std::string lesson = lesson_programs().at(0);
  for (const std::string& program : {lesson, std::string("exercises")})
    fs::copy(built / program, bin / program);
  fs::copy(built.parent_path() / "share/rederive", data, fs::copy_options::recursive);
  const auto check = [&](const fs::path& name, const std::string& more,
                         const std::vector<std::string>& command, const std::string& complaint) {
    CAPTURE(more);
    const std::string before = read_file(data / name);
    fs::remove(data / name);  // a link
    std::ofstream(data / name) << before << more;
    const Result r = run_program(bin / command[0], {command.begin() + 1, command.end()});
    CHECK(r.exit_code == 2);
    const auto line = std::count(before.begin(), before.end(), '\n') + 1;
    CHECK(r.err.find(fmt::format("{}:{}: {}", name.filename().string(), line, complaint)) !=
          std::string::npos);
    std::ofstream(data / name) << before;
  };
  const std::vector<std::string> text{lesson}, notebook{lesson, "--format", "notebook"};
  check("equations_of_lessons.toml", "[[lessons]]\n", text, "there is no key 'lessons' here");
  check("equations_of_lessons.toml", "[[lesson]]\n", text, "'number' is missing");
  check("notebook_cells.toml", "[[rules]]\n", notebook, "there is no key 'rules' here");
  const std::vector<std::string> wrong{"exercises", "--progress",       prefix.path / "progress",
                                       "check",     "height-of-centre", "R*sin(theta)"};
  check("exercises/slips.toml", "[hints]\n", wrong, "there is no key 'hints' here");
  check("exercises/slips.toml", "sign2 = 3\n", wrong, "'sign2' in 'hint' must be a string");
}
