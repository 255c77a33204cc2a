#include <array>
#include <cctype>
#include <derivations/kernel/lemma.hpp>
#include <derivations/kernel/row_text.hpp>
#include <derivations/kernel/scripts.hpp>
#include <derivations/paper/prove.hpp>
#include <derivations/program/data_folder.hpp>
#include <derivations/program/program.hpp>
#include <derivations/program/toml_table.hpp>

namespace rederive::kernel {
using namespace language;
using namespace identity;
using namespace decide;
using namespace program;
using namespace paper;

namespace {

/// Returns the comment before a lemma. No text of ours may end the comment.
std::string comment(const Entry& entry) {
  const Row& row = entry.row;
  std::string text = "(* (" + row.id + ")" + (row.domain.empty() ? "" : " " + row.domain) + " " +
                     (row.kind == RowKind::result ? "Stated: " : "Printed: ") + row.claim() +
                     "\n   Verdict: " + to_string(entry.proof.verdict);
  if (entry.derivation && !entry.derivation->assumption.empty())
    text += ". Assumed: " + entry.derivation->assumption;
  if (entry.proof.verdict == Verdict::refuted) text += ". Right is: " + entry.derived;
  for (std::size_t end; (end = text.find("*)", 2)) != std::string::npos;) text.insert(end + 1, " ");
  return text + ". *)\n";
}

/// Returns the theorems of one file of the list.
std::vector<Lemma> read_theorems(TomlTable& table, const std::string& file) {
  std::vector<Lemma> result;
  for (TomlTable& one : table.tables("theorems")) {
    Lemma theorem{.id = "", .file = file, .name = one.needed_line("name"), .ships = true};
    one.call_it("theorem " + theorem.name);
    std::vector<std::string> about;
    for (const Lemma::Kind kind :
         {Lemma::Kind::derivation, Lemma::Kind::instance, Lemma::Kind::threshold, Lemma::Kind::claim})
      if (const auto ids = one.lines(to_string(kind)); !ids.empty()) theorem.kind = kind, about = ids;
    theorem.from = one.lines("from");
    one.done();
    if (about.empty()) one.fail("one of 'derivation', 'instance', 'threshold' and 'claim' must name a row");
    theorem.id = about[0];
    if (theorem.kind == Lemma::Kind::derivation) theorem.derives = about;
    result.push_back(std::move(theorem));
  }
  return result;
}

/// Returns the place of a theorem in the text of its file: the newline before it. Throws std::runtime_error.
std::size_t place_of(const Lemma& theorem, const std::string& text) {
  const std::string start = "\nTheorem " + theorem.name;
  for (std::size_t at = text.find(start); at != std::string::npos; at = text.find(start, at + 1))
    if (const char next = text[at + start.size()]; next == ' ' || next == '\n') return at;
  throw std::runtime_error(theorem.file + " does not contain the theorem " + theorem.name);
}

constexpr const char* makefile =
    "all: CoqMakefile ; $(MAKE) -f CoqMakefile\n"
    "CoqMakefile: _CoqProject ; coq_makefile -f _CoqProject -o CoqMakefile\n"
    ".PHONY: all\n";

}  // namespace

std::string to_string(Lemma::Kind kind) {
  static constexpr std::array names{"row", "refutation", "derivation", "instance", "threshold", "claim"};
  return names.at(static_cast<std::size_t>(kind));
}

std::string lemma_name(const std::string& kind, std::string id) {
  for (char& c : id)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  return kind + "_" + id;
}

std::optional<Lemma> lemma_of(const Paper& paper, const Entry& entry) {
  const bool is_error = entry.proof.verdict == Verdict::error;
  if ((!entry.derivation && !is_error) || entry.proof.verdict == Verdict::definition) return std::nullopt;
  const bool is_refuted = entry.proof.verdict == Verdict::refuted;
  Lemma result{.id = entry.row.id, .file = "Ledger.v", .name = lemma_name("equation", entry.row.id)};
  if (is_refuted) result.name += "_refuted", result.kind = Lemma::Kind::refutation;
  try {
    if (is_error) throw Undecidable(entry.proof.reason);
    const Symbols symbols = symbols_in(paper, entry.row.domain);
    const Relation claim = parse_statement(entry.row.claim(), symbols);
    const Question question{claim, derived_relation(*entry.derivation, symbols), symbols,
                            entry.derivation->given,
                            conditions_of(paper, entry.row, claim, *entry.derivation, symbols)};
    if (entry.proof.verdict == Verdict::undecided) throw Undecidable("the verdict is undecided");
    result.text = comment(entry) + (is_refuted ? refutation : lemma)(result.name, question, entry.proof);
  } catch (const Undecidable& error) {
    result.why = error.what();
  }
  return result;
}

std::string shipped(const std::string& name) {
  if (auto text = read_if_there(data_folder() / "kernel" / name)) return std::move(*text);
  throw std::runtime_error("a file that ships with the project is missing: " + name +
                           "; XDG_DATA_DIRS may name the folder share of an installation");
}

Theorems theorems_of(const Paper& paper) {
  Theorems result;
  if (paper.theorems.empty()) return result;
  TomlTable list(data_folder() / "kernel" / paper.theorems);
  result.prelude = list.lines("prelude");
  result.functions_of_time = list.lines("functions_of_time");
  result.assumptions = list.named_texts("assumptions");
  for (TomlTable& table : list.tables("file")) {
    const std::string& file = result.files.emplace_back(table.needed_line("name"));
    for (Lemma& theorem : read_theorems(table, file)) result.lemmas.push_back(std::move(theorem));
    table.done();
  }
  list.done();
  return result;
}

std::string theorem_file(const Paper& paper, const std::string& file) {
  const Theorems theorems = theorems_of(paper);
  const auto relation_of = [&](const std::string& id) { return right_form(paper, id); };
  std::string text = with_rows(paper.symbols, relation_of, theorems.functions_of_time, shipped(file));
  for (const Lemma& theorem : theorems.lemmas)
    if (theorem.file == file && !theorem.from.empty())
      text.insert(place_of(theorem, text), fmt::format("\n(* from {} *)", fmt::join(theorem.from, ", ")));
  return text;
}

std::string text_of(const Paper& paper, const Lemma& theorem) {
  const std::string text = theorem_file(paper, theorem.file);
  const auto at = place_of(theorem, text), before = text.rfind("Qed.\n", at),
             start = text.find_first_not_of('\n', before == std::string::npos ? 0 : before + 5);
  return text.substr(start, text.find("Qed.\n", at) + 5 - start);
}

std::map<std::string, std::string> files_of(const Paper& paper, const std::vector<Lemma>& lemmas) {
  std::map<std::string, std::string> files;
  std::string project = "-R . Rederive\n";
  std::vector<std::string> needed(prelude.begin(), prelude.end());
  for (const std::string& name : theorems_of(paper).prelude) needed.push_back(name);
  for (const std::string& name : needed) files[name] = shipped(name), project += name + "\n";
  for (const Lemma& lemma : lemmas) {
    if (!files.contains(lemma.file)) {
      files[lemma.file] = lemma.ships ? theorem_file(paper, lemma.file) : imports;
      project += lemma.file + "\n";
    }
    if (!lemma.text.empty()) files[lemma.file] += "\n" + lemma.text;
  }
  files["_CoqProject"] = project, files["Makefile"] = makefile;
  return files;
}

void write_scripts(const Paper& paper, const std::filesystem::path& folder, const std::vector<Lemma>& lemmas,
                   const std::map<std::string, std::string>& more) {
  make_output_folder(folder);
  std::vector<std::pair<std::filesystem::path, std::string>> files;
  for (const auto& [name, text] : files_of(paper, lemmas)) files.emplace_back(folder / name, text);
  for (const auto& [name, text] : more) files.emplace_back(folder / name, text);
  write_together(files);
}

}  // namespace rederive::kernel
