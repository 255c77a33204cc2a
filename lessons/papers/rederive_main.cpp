// rederive: a paper in a folder.
//
// Sample runs:  rederive new rod            a folder to begin with
//               rederive rod                the ledger: a row an equation
//               rederive rod show 3         all about one row
//               rederive rod lesson 1
//               rederive rod test           all checks of the folder
//               rederive check notes.tex    which line of a manuscript does not follow
#include <derivations/emit/run_emit.hpp>
#include <derivations/program/program.hpp>
#include <lessons/check/run_check.hpp>
#include <lessons/exercises/run_exercises.hpp>
#include <lessons/ledger/run_ledger.hpp>
#include <lessons/page/prose.hpp>
#include <lessons/page/run_lesson.hpp>
#include <lessons/papers/new_paper.hpp>
#include <lessons/papers/paper_folder.hpp>
#include <lessons/papers/solve.hpp>
#include <lessons/papers/test_paper.hpp>
#include <lessons/site/site.hpp>
#include <optional>

using namespace rederive;
using namespace rederive::program;
using namespace rederive::papers;
namespace fs = std::filesystem;

namespace {

constexpr auto help =
    R"(A paper in a folder: judges what it prints, and makes code, lessons and exercises of it.

Usage: rederive DIR [COMMAND] [OPTIONS]
       rederive new DIR [--from rod|oscillator|empty] [--python|--cpp]
       rederive check FILE… [OPTIONS]   judges the formulas of LaTeX, Markdown or notebooks

Commands:
  (none)                    List every equation with its verdict.
  show ID                   Show everything about one equation.
  errata, claims, mutate, graph, prove, certify
                            As of the program ledger, for this paper.
  build                     Compile derive.cpp, or run derive.py, and keep the derivations.
  emit …                    Write the functions of functions.toml as code.
  solve --row ID …          Integrate an equation of motion, with events, CSV and plot.
  lesson N …                Show a lesson, lesson-0N.md.
  exercises …, grade …      Set and judge the exercises of exercises.toml.
  site OUT                  Write everything as one static site.
  watch                     Judge again what has changed, at each save.
  test                      Run all checks of the paper, for continuous integration.

'rederive DIR COMMAND --help' explains a command. A paper is a folder with paper.toml and
equations.toml; 'rederive new DIR' writes one to begin with.

Exit code: 0 if everything is as expected; 1 if a verdict or an answer is not as expected; 2 for bad
usage, bad input, or output that cannot be written; 3 if something is undecided or fails internally.
)";

/// The folder, which is read when it is first asked for.
class LatePaper {
 public:
  LatePaper(fs::path folder, Stale stale) : folder_(std::move(folder)), stale_(stale) {}
  const PaperFolder& operator()() {
    if (!paper_) paper_.emplace(folder_, stale_);
    return *paper_;
  }

 private:
  fs::path folder_;
  Stale stale_;
  std::optional<PaperFolder> paper_;
};

int complain(const std::string& what) {
  std::fprintf(stderr, "rederive: %s\nTry 'rederive --help'.\n", printable(what).c_str());
  return bad_input;
}

/// Runs `lesson N …`. Without N, lists the lessons.
int run_lesson_of(LatePaper& folder, int argc, char** argv) {
  try {
    const std::vector<page::Lesson> lessons = folder().lessons();
    if (argc < 2 || std::string_view(argv[1]).find_first_not_of("0123456789") != std::string_view::npos) {
      if (argc >= 2 && std::string(argv[1]) != "--list" && std::string(argv[1]) != "--help")
        return complain("lesson needs the number of a lesson");
      for (const page::Lesson& lesson : lessons)
        std::printf("%3d  %s\n", lesson.number, lesson.title.c_str());
      return as_expected;
    }
    const std::size_t number = std::string_view(argv[1]).size() > 3 ? 0 : std::stoul(argv[1]);
    if (number < 1 || number > lessons.size())
      return complain("there is no lesson " + std::string(argv[1]) + "; there are " +
                      page::counted(lessons.size(), "lesson"));
    std::string name = std::string(argv[0]) + " " + argv[1];
    argv[1] = name.data();
    return page::run_lesson(
        folder().paper(), lessons[number - 1], [&] { return folder().series(); }, argc - 1, argv + 1);
  } catch (const BadInput& error) {
    return complain(error.what());
  }
}

int run(const fs::path& path, const std::string& command, int argc, char** argv) {
  const bool is_classroom = command == "exercises" || command == "grade";
  LatePaper folder(path, is_classroom ? Stale::refuse : Stale::derive_again);
  const auto paper = [&]() -> const PaperFolder& { return folder(); };
  if (command == "build") {
    try {
      build_derivations(path);
      return as_expected;
    } catch (const BadInput& error) {
      return complain(error.what());
    }
  }
  if (command == "emit") return emit::run_emit([&] { return folder().paper().emission(); }, argc, argv);
  if (command == "solve") return run_solve(paper, argc, argv);
  if (command == "lesson") return run_lesson_of(folder, argc, argv);
  if (is_classroom)
    return classroom::run_exercises([&]() -> const classroom::Course& { return folder().course(); },
                                    "the paper", argc, argv);
  if (command == "site")
    return site::run_site([&]() -> const classroom::Course& { return folder().course(); }, false, argc, argv);
  if (command == "watch") return run_watch(path, argc, argv);
  if (command == "test") return run_test(paper, argc, argv);
  return ledger::run_ledger([&] { return folder().paper(); }, argc, argv,
                            [&] { return ledger::claims_in_folder(folder().paper()); });
}

}  // namespace

int main(int argc, char** argv) {
  const std::string first = argc > 1 ? argv[1] : "--help";
  if (first == "--help" || first == "-h") return std::fputs(help, stdout) < 0 ? bad_input : as_expected;
  if (first == "--version") return std::puts("Rederive " REDERIVE_VERSION) < 0 ? bad_input : as_expected;
  if (first == "new") return run_new(argc - 1, argv + 1);
  if (first == "check") {
    std::string name = "rederive check";
    argv[1] = name.data();
    return check::run_check(argc - 1, argv + 1);
  }
  if (!fs::is_directory(first)) return complain("there is no folder '" + printable_name(first) + "'");
  const std::string command = argc > 2 ? argv[2] : "";
  // Commands of their own programs begin behind their names; those of the ledger are its subcommands.
  static const std::vector<std::string> own{"build",     "emit", "solve", "lesson",
                                            "exercises", "site", "watch", "test"};
  const bool is_own = std::find(own.begin(), own.end(), command) != own.end();
  const int skipped = is_own ? 2 : 1;
  std::string name =
      "rederive " + fs::path(first).lexically_normal().filename().string() + (is_own ? " " + command : "");
  argv[skipped] = name.data();
  return run(first, command, argc - skipped, argv + skipped);
}
