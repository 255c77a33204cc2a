#include <fmt/format.h>

#include <chrono>
#include <derivations/emit/emit.hpp>
#include <derivations/language/print.hpp>
#include <derivations/numbers/evaluate.hpp>
#include <derivations/numbers/interval.hpp>
#include <derivations/paper/folder.hpp>
#include <derivations/paper/mutate.hpp>
#include <derivations/program/command_line.hpp>
#include <lessons/exercises/exercise.hpp>
#include <lessons/exercises/selftest.hpp>
#include <lessons/ledger/claims.hpp>
#include <lessons/page/prose.hpp>
#include <lessons/page/render.hpp>
#include <lessons/page/run_lesson.hpp>
#include <lessons/papers/test_paper.hpp>
#include <nlohmann/json.hpp>
#include <thread>

namespace rederive::papers {
using namespace language;
using namespace numbers;
using namespace emit;
using namespace program;
using namespace decide;
using namespace paper;
using namespace page;
namespace fs = std::filesystem;

namespace {

/// The checks of a folder. Each says what it found, and how many complaints there are.
class Checks {
 public:
  explicit Checks(const PaperFolder& folder) : folder_(folder), paper_(folder.paper()) {}

  int run() {
    rows();
    mutants();
    claims();
    lessons();
    exercises();
    emitted_code();
    fmt::print("{}\n", complaints_ == 0 ? "All checks pass." : counted(complaints_, "complaint") + ".");
    return complaints_ == 0 ? as_expected : not_as_expected;
  }

 private:
  void complain(const std::string& what) {
    ++complaints_;
    fmt::print("  {}\n", printable(what));
  }

  void rows() {
    fmt::print("rows: {}\n", rows_of(paper_).size());
    for (const Row& row : rows_of(paper_)) {
      const Entry entry = judge(paper_, row);
      if (entry.proof.verdict != row.expected)
        complain(fmt::format("({}) is {}, but {} is expected. {}", row.id, to_string(entry.proof.verdict),
                             to_string(row.expected), entry.proof.reason));
    }
  }

  void mutants() {
    int made = 0;
    for (const Row& row : rows_of(paper_)) {
      const Mutation mutation = mutate(paper_, row, /*seed=*/1);
      made += mutation.mutants;
      if (!mutation.error.empty()) continue;  // rows() complains about it
      for (const std::string& text : mutation.survivors) complain("(" + row.id + ") survived: " + text);
    }
    fmt::print("mutants: {}\n", made);
  }

  void claims() {
    const ledger::Claims all = ledger::claims_in_folder(paper_);
    if (!fs::exists(all.file)) return;
    const auto list = ledger::read_claims(all);
    fmt::print("claims: {}\n", list.size());
    for (const ledger::Claim& claim : list)
      if (const auto judged = ledger::judge(claim, all); !judged.as_expected())
        complain(fmt::format("claim {} is {}, but {} is expected: {}", claim.id, to_string(judged.verdict),
                             to_string(claim.expected), judged.found));
  }

  void lessons() {
    const std::vector<Lesson> all = folder_.lessons();
    if (all.empty()) return;
    fmt::print("lessons: {}\n", all.size());
    for (const Lesson& lesson : all)
      for (const Format format : {Format::unicode, Format::plain, Format::latex, Format::markdown,
                                  Format::notebook, Format::html}) {
        Setting setting{.paper = paper_, .format = format};
        setting.lesson = lesson.number;
        const auto renderer = make_renderer(setting);
        for (const LessonStep& step : lesson.steps) {
          Page page(paper_);
          step.write(page);
          (void)renderer->passages(page.blocks());
        }
      }
  }

  void exercises() {
    if (!folder_.has_exercises()) return;
    const classroom::Course& course = folder_.course();
    fmt::print("exercises: ");
    if (classroom::selftest({course, read_exercises(course, course.exercises), course.progress},
                            /*with_lessons=*/true) != as_expected)
      ++complaints_;
  }

  /// Returns a number inside the range of a symbol, another one for each `trial`.
  static std::string number_in(const Symbol& symbol, int trial, std::size_t place) {
    const Interval range = parse_range(symbol.range);
    const double share = std::fmod(0.37 + 0.618 * trial + 0.271 * static_cast<double>(place), 1);
    const auto end = [](const End& one, double otherwise) {
      return one.infinite != 0 ? otherwise : one.ball(64).to_double();
    };
    const double low = end(range.low, -2), high = end(range.high, low + 4);
    return fmt::format("{:.4f}", low + (high - low) * (0.05 + 0.9 * share));
  }

  /// Runs each function as emitted for Python, at points at which it has a value.
  void emitted_code() {
    const Emission emission = paper_.emission();
    if (emission.functions.empty()) return;
    struct Case {
      std::string call, expected;
    };
    std::vector<Case> cases;
    constexpr int trials = 8, digits = 50;
    for (const EmittedFunction& function : emission.functions) {
      const Tree value = to_tree(function.value, emission.symbols);
      const std::size_t before = cases.size();
      for (int trial = 0; trial < trials; ++trial) {
        Point point;
        std::string arguments;
        for (std::size_t k = 0; k < function.arguments.size(); ++k) {
          const std::string number = number_in(*emission.symbols.find(function.arguments[k]), trial, k);
          point.emplace(name_of(function.arguments[k]), Number(parse(number, emission.symbols)));
          arguments += (k == 0 ? "" : ", ") + number;
        }
        if (const auto found = digits_at(value, point, digits))
          cases.push_back({function.name + "(" + arguments + ")", *found});
      }
      if (cases.size() == before)
        complain("the function " + function.name + " has no value at any point that was tried");
    }
    fmt::print("emitted functions: {}, compared with {} digits at {} points\n", emission.functions.size(),
               digits, cases.size());
    std::string script = emit::emit({emission.symbols, emission.functions}, Target::python);
    for (const Case& one : cases) script += fmt::format("print(repr({}))\n", one.call);
    const fs::path file = private_folder("test") / (hash_of(script) + ".py");
    write_whole(file, script);
    const Said said = said_by("python3 " + in_quotes(file));
    fs::remove(file);
    if (said.status != 0) return complain("the emitted Python fails");
    std::istringstream lines(said.text);
    for (const Case& one : cases) {
      std::string line;
      std::getline(lines, line);
      const double found = std::stod(line), expected = std::stod(one.expected);
      constexpr double tolerance = 1e-11;
      if (std::fabs(found - expected) > tolerance * std::max(std::fabs(expected), 1e-3))
        complain(fmt::format("{} is {} in Python, but {}", one.call, line, one.expected));
    }
  }

  const PaperFolder& folder_;
  const Paper& paper_;
  std::size_t complaints_ = 0;
};

using Times = std::map<fs::path, fs::file_time_type>;

Times times_of(const fs::path& folder) {
  Times times;
  std::error_code error;
  for (const char* name : {"paper.toml", "equations.toml", "derive.py", "derive.cpp", "derivations.json"})
    if (const auto time = fs::last_write_time(folder / name, error); !error) times[name] = time;
  return times;
}

/// Judges the rows of a folder. Keeps the verdicts of those rows whose words and derivation are as before.
class Watch {
 public:
  explicit Watch(fs::path folder) : folder_(std::move(folder)) {}

  void look() {
    try {
      const PaperFolder folder(folder_, Stale::derive_again);
      const Paper& paper = folder.paper();
      const std::string symbols = read_whole(folder_ / "paper.toml");
      if (std::exchange(symbols_, symbols) != symbols) known_.clear();
      std::map<std::string, std::pair<std::string, std::string>> now;
      for (const Row& row : rows_of(paper)) {
        const std::string words = words_of(row, paper);
        const auto before = known_.find(row.id);
        const bool is_known = before != known_.end() && before->second.first == words;
        const std::string line = is_known ? before->second.second : judged_line(paper, row);
        if (!is_known) fmt::print("{}\n", line);
        now[row.id] = {words, line};
      }
      known_ = now;
    } catch (const std::exception& error) {
      fmt::print("{}\n", printable(error.what()));
    }
    std::fflush(stdout);
  }

 private:
  static std::string words_of(const Row& row, const Paper& paper) {
    std::string words = row.claim() + "\n" + row.domain + "\n" + to_string(row.expected) + "\n";
    try {
      if (const auto derivation = derivation_of(paper, row.id))
        words += print(derived_relation(*derivation, paper.symbols)) + derivation->assumption;
    } catch (const std::exception& error) {
      words += error.what();
    }
    return words;
  }

  static std::string judged_line(const Paper& paper, const Row& row) {
    const Entry entry = judge(paper, row);
    const bool is_expected = entry.proof.verdict == row.expected;
    return headline(entry) + (is_expected ? "" : ", but " + to_string(row.expected) + " is expected") +
           (entry.proof.reason.empty() ? "" : ": " + entry.proof.reason);
  }

  fs::path folder_;
  std::string symbols_;
  std::map<std::string, std::pair<std::string, std::string>> known_;  ///< by id: what was judged, the line
};

}  // namespace

int run_test(const std::function<const PaperFolder&()>& folder, int argc, char** argv) {
  CLI::App app{
      "Runs all checks of a paper: expected verdicts of rows and claims, mutants, lessons, exercises, and "
      "the\n"
      "emitted code against values of 50 digits."};
  return run_command(app, argc, argv, [&] { return Checks(folder()).run(); });
}

int run_watch(const fs::path& folder, int argc, char** argv) {
  CLI::App app{"Judges the rows that have changed whenever a file of the paper is saved. Ctrl-C ends it."};
  bool once = false;
  app.add_flag("--once", once, "Look once and stop.");
  return run_command(app, argc, argv, [&] {
    Watch watch(folder);
    for (Times seen; true;) {
      if (Times now = times_of(folder); now != seen) {
        watch.look();
        seen = times_of(folder);  // derivations.json may have been written
      }
      if (once) return as_expected;
      std::this_thread::sleep_for(std::chrono::milliseconds(200));
    }
  });
}

}  // namespace rederive::papers
