#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <climits>
#include <cstdlib>
#include <derivations/program/program.hpp>
#include <lessons/ledger/check.hpp>
#include <lessons/page/prose.hpp>
#include <lessons/page/render.hpp>
#include <regex>
#include <set>
#include <sstream>

namespace rederive::ledger {
using namespace program;
using namespace paper;
using namespace kernel;
using namespace page;

namespace {

std::array<char, PATH_MAX> folder_to_remove{};  // a signal handler can reach nothing else

/// Removes the folder, by what a signal handler may call, and ends as the signal would have done.
void remove_and_end(int signal) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::execl("/bin/rm", "rm", "-rf", "--", folder_to_remove.data(), nullptr);
    ::_exit(127);
  }
  ::waitpid(child, nullptr, 0);
  ::signal(signal, SIG_DFL);
  ::raise(signal);
}

/// A folder that goes with its owner, also where a signal ends the program. There is one at a time.
struct Folder {
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "rederive-XXXXXX").string();
    const Uninterrupted whole;
    if (name.size() >= folder_to_remove.size() || ::mkdtemp(name.data()) == nullptr)
      throw BadInput("cannot create the folder '" + printable_name(name) + "'");
    path = name;
    name.copy(folder_to_remove.data(), name.size());
    for (std::size_t i = 0; i < signals.size(); ++i) {
      before[i] = ::signal(signals[i], remove_and_end);
      if (before[i] == SIG_IGN) ::signal(signals[i], SIG_IGN);  // as nohup has it
    }
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
    for (std::size_t i = 0; i < signals.size(); ++i) ::signal(signals[i], before[i]);
    folder_to_remove = {};
  }
  static constexpr std::array signals{SIGHUP, SIGINT, SIGTERM};
  std::filesystem::path path;
  std::array<sighandler_t, 3> before{};
};

Said compile(const Folder& folder, const std::string& file) {
  return said_by("cd " + in_quotes(folder.path) + " && coqc -q -R . Rederive " + file + " 2>&1");
}

/// The lemma in which a line of a file lies; `line` counts from 1.
const Lemma* lemma_at(int line, const std::string& text, const std::vector<const Lemma*>& lemmas) {
  std::size_t at = 0;
  for (int k = 1; k < line && at != std::string::npos; ++k) at = text.find('\n', at + (k > 1 ? 1 : 0));
  const Lemma* found = nullptr;
  for (const Lemma* lemma : lemmas)
    if (const auto start = text.find(lemma->text); start != std::string::npos && start <= at) found = lemma;
  return found;
}

/// The names that Print Assumptions gives.
std::vector<std::string> axioms_in(const std::string& output) {
  static const std::regex name("^([A-Za-z_][\\w.']*)( :.*)?$");
  std::vector<std::string> result;
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);) {
    std::smatch found;
    if (line != "Axioms:" && std::regex_match(line, found, name)) result.push_back(found[1]);
  }
  return result;
}

/// Returns what lemmas assume, taken together: asked for one by one, each goes through all of Coq's reals; a
/// tuple of them has a type that takes longer than their axioms.
std::vector<std::string> axioms_of(const Folder& folder, const std::vector<const Lemma*>& lemmas) {
  std::set<std::string> files;
  for (const Lemma* lemma : lemmas) files.insert(lemma->file.substr(0, lemma->file.size() - 2));
  write_whole(folder.path / "Assumptions.v",
              "From Rederive Require Import " + joined(files, " ") + ".\nDefinition all :=" +
                  joined(lemmas, "", [](const Lemma* lemma) { return " let _ := " + lemma->name + " in"; }) +
                  " tt.\nPrint Assumptions all.\n");
  const Said run = compile(folder, "Assumptions.v");
  if (run.status != 0)
    throw std::runtime_error("coqc did not list the assumptions of the lemmas: " + run.text);
  return axioms_in(run.text);
}

/// Lemmas of one file that pass together; the errors of the others are kept.
std::vector<const Lemma*> passing(const Folder& folder, const std::string& file,
                                  std::vector<const Lemma*> lemmas,
                                  std::map<const Lemma*, std::string>& errors) {
  static const std::regex place("line (\\d+), characters");
  while (!lemmas.empty()) {
    std::string text = imports;
    for (const Lemma* lemma : lemmas) text += lemma->text + "\n";
    write_whole(folder.path / file, text);
    const Said run = compile(folder, file);
    if (run.status == 0) break;
    std::smatch where;
    const bool is_placed = std::regex_search(run.text, where, place);
    const Lemma* failed = is_placed ? lemma_at(std::stoi(where[1]), text, lemmas) : nullptr;
    if (failed == nullptr) throw std::runtime_error("coqc fails on " + file + ": " + run.text);
    errors[failed] = run.text;
    std::erase(lemmas, failed);
  }
  return lemmas;
}

}  // namespace

bool has_coq() { return said_by("command -v coqc 2>&1").status == 0; }

std::vector<Checked> check(const Paper& paper, const std::vector<Lemma>& lemmas,
                           const std::function<void(const std::string&)>& progress) {
  const Folder folder;
  write_scripts(paper, folder.path, lemmas);
  const Theorems theorems = theorems_of(paper);
  std::vector<std::string> needed(prelude.begin(), prelude.end());
  if (std::ranges::any_of(lemmas, &Lemma::ships))
    needed.insert(needed.end(), theorems.prelude.begin(), theorems.prelude.end());
  for (const std::string& name : needed) {
    progress(name);
    if (const Said run = compile(folder, name); run.status != 0)
      throw std::runtime_error("coqc refuses " + name +
                               " (are libcoq-coquelicot and libcoq-interval installed?): " + run.text);
  }
  std::map<std::string, std::vector<const Lemma*>> by_file;
  std::map<const Lemma*, std::string> errors;
  std::vector<const Lemma*> passed;
  for (const Lemma& lemma : lemmas)
    if (!is_skipped(lemma)) by_file[lemma.file].push_back(&lemma);
  // Theorems may rest on those of the files before theirs.
  std::vector<std::string> files = theorems.files;
  for (const auto& [file, all] : by_file)
    if (!all.front()->ships) files.push_back(file);
  for (const std::string& file : files) {
    const auto& all = by_file[file];
    if (all.empty()) continue;
    progress(file);
    const bool is_shipped = all.front()->ships;
    const Said whole = is_shipped ? compile(folder, file) : Said{0, ""};
    if (whole.status != 0)
      for (const Lemma* lemma : all) errors[lemma] = whole.text;
    const auto good = is_shipped ? (whole.status == 0 ? all : std::vector<const Lemma*>{})
                                 : passing(folder, file, all, errors);
    passed.insert(passed.end(), good.begin(), good.end());
  }
  progress("what they assume");
  const auto axioms = passed.empty() ? std::vector<std::string>{} : axioms_of(folder, passed);
  std::vector<Checked> result;
  for (const Lemma& lemma : lemmas) {
    const bool has_passed = !errors.contains(&lemma) && !is_skipped(lemma);
    result.push_back({has_passed, errors[&lemma], has_passed ? axioms : std::vector<std::string>{}});
  }
  return result;
}

}  // namespace rederive::ledger
