#include <cctype>
#include <derivations/kernel/lemma.hpp>
#include <derivations/kernel/scripts.hpp>
#include <derivations/paper/prove.hpp>
#include <derivations/program/data_folder.hpp>
#include <derivations/program/program.hpp>
#include <regex>

namespace rederive {

namespace {

/// Returns the comment before a lemma. No text of ours may end the comment.
std::string comment(const Entry& entry) {
  const Row& row = entry.row;
  std::string text = "(* (" + row.id + ")" + (row.domain.empty() ? "" : " " + row.domain) + " " +
                     (row.kind == "result" ? "Stated: " : "Printed: ") + row.claim() +
                     "\n   Verdict: " + to_string(entry.proof.verdict);
  if (entry.derivation && !entry.derivation->assumption.empty())
    text += ". Assumed: " + entry.derivation->assumption;
  if (entry.proof.verdict == Verdict::refuted) text += ". Right is: " + entry.derived;
  for (std::size_t end; (end = text.find("*)", 2)) != std::string::npos;) text.insert(end + 1, " ");
  return text + ". *)\n";
}

constexpr const char* makefile =
    "all: CoqMakefile ; $(MAKE) -f CoqMakefile\n"
    "CoqMakefile: _CoqProject ; coq_makefile -f _CoqProject -o CoqMakefile\n"
    ".PHONY: all\n";

}  // namespace

std::string lemma_name(const std::string& kind, std::string id) {
  for (char& c : id)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  return kind + "_" + id;
}

std::optional<Lemma> lemma_of(const Paper& paper, const Entry& entry) {
  const bool is_error = entry.proof.verdict == Verdict::error;
  if ((!entry.derivation && !is_error) || entry.proof.verdict == Verdict::definition) return std::nullopt;
  const bool is_refuted = entry.proof.verdict == Verdict::refuted;
  Lemma result{
      .id = entry.row.id, .file = "Ledger.v", .name = lemma_name("equation", entry.row.id), .kind = "row"};
  if (is_refuted) result.name += "_refuted", result.kind = "refutation";
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

std::vector<std::string> prelude_of(const Paper& paper) {
  std::vector<std::string> files{"Rederive.v", "Intervals.v", "Bounds.v"};
  files.insert(files.end(), paper.theorems.prelude.begin(), paper.theorems.prelude.end());
  return files;
}

std::vector<Lemma> shipped_theorems(const Paper& paper) {
  static const std::regex theorem("\nTheorem ((derivation|instance|claim)_([^_ ]+)\\w*|\\w+)");
  std::vector<Lemma> result;
  for (const auto& [file, row] : paper.theorems.files) {
    const std::string text = shipped(file);
    for (std::sregex_iterator found(text.begin(), text.end(), theorem), end; found != end; ++found) {
      const bool has_id = (*found)[2].matched;
      result.push_back({.id = has_id ? (*found)[3].str() : row,
                        .file = file,
                        .name = (*found)[1],
                        .kind = has_id ? (*found)[2].str() : "threshold",
                        .ships = true});
    }
  }
  return result;
}

std::string text_of(const Lemma& theorem) {
  const std::string text = shipped(theorem.file);
  const auto at = text.find("\nTheorem " + theorem.name), before = text.rfind("Qed.\n", at),
             start = text.find_first_not_of('\n', before == std::string::npos ? 0 : before + 5);
  return text.substr(start, text.find("Qed.\n", at) + 5 - start);
}

std::map<std::string, std::string> files_of(const Paper& paper, const std::vector<Lemma>& lemmas) {
  std::map<std::string, std::string> files;
  std::string project = "-R . Rederive\n";
  for (const std::string& name : prelude_of(paper)) files[name] = shipped(name), project += name + "\n";
  for (const Lemma& lemma : lemmas) {
    const auto [place, is_new] = files.try_emplace(lemma.file, lemma.ships ? shipped(lemma.file) : imports);
    if (is_new) project += lemma.file + "\n";
    if (!lemma.text.empty()) place->second += "\n" + lemma.text;
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

}  // namespace rederive
