// The theorems that are written by hand: their premises hold somewhere, and they need the rows that they
// name.
#include <doctest/doctest.h>

#include <derivations/kernel/row_text.hpp>
#include <derivations/program/toml_table.hpp>
#include <regex>
#include <tests/block.hpp>
#include <tests/derivations/kernel/compiled.hpp>

using namespace rederive::language;
using namespace rederive::kernel;
using namespace rederive::program;
using namespace rederive::rocking_block;
using namespace rederive::test;

namespace {

/// What the proof needs that the premises of one theorem hold.
struct Witness {
  std::map<std::string, std::string> values;  ///< a term of Coq for each name
  std::string first, by;                      ///< tactics before and after the premises become goals
};

/// Returns the witnesses of premises.toml; the one for "" serves all other theorems.
std::map<std::string, Witness> read_witnesses() {
  TomlTable file(REDERIVE_SOURCE "/tests/derivations/kernel/premises.toml");
  const auto common = file.named_texts("values");
  std::map<std::string, Witness> witnesses{{"", {common, "", ""}}};
  for (TomlTable& table : file.tables("theorem")) {
    const auto values = table.named_texts("values");
    const std::string first = table.text("first"), by = table.text("by");
    for (const std::string& name : table.lines("names")) {
      Witness& witness = witnesses.try_emplace(name, Witness{common, "", ""}).first->second;
      for (const auto& [symbol, value] : values) witness.values[symbol] = value;
      if (!first.empty()) witness.first = first;
      if (!by.empty()) witness.by = by;
    }
    table.done();
  }
  file.done();
  return witnesses;
}

/// Returns a sentence of Coq for each value, in an order in which each uses only names before it.
std::string sentences(std::map<std::string, std::string> values) {
  static const std::regex word("[A-Za-z_][\\w']*");
  std::string text;
  std::erase_if(values, [](const auto& value) { return value.second.empty(); });
  while (!values.empty()) {
    const auto next = std::find_if(values.begin(), values.end(), [&](const auto& value) {
      for (std::sregex_iterator at(value.second.begin(), value.second.end(), word), end; at != end; ++at)
        if (at->str() != value.first && values.contains(at->str())) return false;
      return true;
    });
    REQUIRE_MESSAGE(next != values.end(), values.begin()->first, " is given by itself");
    text += "pose (" + next->first + " := " + next->second + ").\n";
    values.erase(next);
  }
  return text;
}

/// Returns a proof that the premises of a theorem hold at a witness.
std::string premises_hold(const std::string& theorem, const Witness& witness) {
  const std::string name = "premises_of_" + theorem;
  return watched(name, "Lemma " + name + " : True.\nProof.\n" + sentences(witness.values) +
                           (witness.first.empty() ? "" : witness.first + ".\n") + "assert (I := " + theorem +
                           "); premises I.\n" +
                           (witness.by.empty() ? "" : "all: try (" + witness.by + ").\n") +
                           "all: separate. all: try define. all: try derive. all: try define. all: guess. "
                           "all: finish.\nUnshelve. all: first [ exact 1 | exact (fun _ => 1) ].\nQed.\n");
}

}  // namespace

TEST_CASE("the premises of a theorem written by hand hold at some point") {
  if (!has_tool("coqtop")) return;
  compile_scripts();
  const auto witnesses = read_witnesses();
  std::string imports;
  for (const std::string& file : theorems().files)
    imports += "From Rederive Require Import " + file.substr(0, file.rfind('.')) + ".\n";
  std::array<std::string, 2> texts;
  texts.fill(read_file(REDERIVE_SOURCE "/tests/derivations/kernel/Premises.v") + imports);
  std::size_t k = 0;
  for (const Lemma& theorem : theorems().lemmas) {
    const auto own = witnesses.find(theorem.name);
    texts[k++ % 2] += premises_hold(theorem.name, own == witnesses.end() ? witnesses.at("") : own->second);
  }
  const std::set<std::string> said = said_about(texts);
  for (const Lemma& theorem : theorems().lemmas)
    CHECK_MESSAGE(said.contains("proved premises_of_" + theorem.name), theorem.name);
  for (const auto& [name, witness] : witnesses)
    CHECK_MESSAGE((name.empty() || said.contains("stated premises_of_" + name)), name, " is not a theorem");
}

namespace {

Relation right(const std::string& id) { return right_form(rederive::rocking_block::paper(), id); }

/// Returns a text of Coq with the rows in it, and `other` in place of the row `id`.
std::string with_row(const std::string& text, const std::string& id, const Relation& other) {
  const auto relation_of = [&](const std::string& row) { return row == id ? other : right(row); };
  return with_rows(paper_symbols(), relation_of, theorems().functions_of_time, text);
}

/// Returns a theorem with a slip in a row that it names: one that the derivation refutes, and that changes
/// the theorem. Of an inequality, the slip turns the sign round, since others may make it weaker. Returns
/// std::nullopt if there is none.
std::optional<std::string> with_a_slip(const std::string& theorem, const std::string& id) {
  const auto derivation = checked_derivation(id);
  if (!derivation) return std::nullopt;
  const Relation original = right(id);
  const Symbols symbols = symbols_in(rederive::paper::row_of(rederive::rocking_block::paper(), id).domain);
  for (const Mutant& mutant : mutants(original)) {
    const Relation& slip = mutant.relation;
    if (names_of(slip) != names_of(original)) continue;
    if (!is_equation(original) && slip.operators == original.operators) continue;
    if (compare(slip, *derivation, symbols).verdict != Verdict::refuted) continue;
    const std::string text = with_row(theorem, id, slip);
    if (text != with_row(theorem, id, original)) return text;
  }
  return std::nullopt;
}

/// Returns copies of a theorem under names of their own, each spoiled in one way: a row that it derives has a
/// slip, or 1 = 1 is in place of a row among its premises.
std::map<std::string, std::string> spoiled_copies(const Lemma& theorem, const std::string& text) {
  static const std::regex premise("row\\{[^}]*\\}(?= ->)");
  std::map<std::string, std::string> copies;
  const auto add = [&](const std::string& name, std::string copy) {
    copy.replace(copy.find(theorem.name), theorem.name.size(), name);
    copies[name] = watched(name, copy);
  };
  const std::string statement = text.substr(0, text.find("\nProof"));
  for (const std::string& id : theorem.derives)
    if (std::regex_search(statement, std::regex("(row|left|right)\\{" + id + "\\b")))
      if (const auto copy = with_a_slip(text, id)) add("slip_in_" + id + "_" + theorem.name, *copy);
  for (std::sregex_iterator row(statement.begin(), statement.end(), premise), end; row != end; ++row) {
    const auto place = static_cast<std::size_t>(row->position());
    add("without_" + std::to_string(place) + "_" + theorem.name,
        std::string(text).replace(place, row->str().size(), "1 = 1"));
  }
  return copies;
}

}  // namespace

TEST_CASE("a theorem whose row has a slip, or that has lost a row among its premises, does not pass Coq") {
  if (!has_tool("coqtop")) return;
  compile_scripts();
  std::array<std::string, 2> halves;
  std::set<std::string> originals, spoiled;
  for (const std::string& file : theorems().files) {
    const auto is_here = [&](const Lemma& one) { return one.file == file && !one.derives.empty(); };
    if (std::ranges::none_of(theorems().lemmas, is_here)) continue;  // nothing to spoil
    std::string text = shipped(file);
    for (const Lemma& theorem : theorems().lemmas) {
      if (!is_here(theorem)) continue;
      std::smatch start;
      REQUIRE(std::regex_search(text, start, std::regex("\nTheorem " + theorem.name + "[ \n]")));
      const auto at = static_cast<std::size_t>(start.position());
      const std::string original = text.substr(at, text.find("Qed.\n", at) + 5 - at);
      std::string copies;
      for (const auto& [name, copy] : spoiled_copies(theorem, original)) copies += copy, spoiled.insert(name);
      originals.insert(theorem.name);
      text.replace(at, original.size(), copies + watched(theorem.name, original));
    }
    const std::string module = file.substr(0, file.rfind('.')) + "_spoiled.\n";
    std::string& shorter = halves[0].size() < halves[1].size() ? halves[0] : halves[1];
    shorter += "Module " + module + with_row(text, "", {}) + "\nEnd " + module;
  }
  const std::set<std::string> said = said_about(halves);
  for (const std::string& name : originals) CHECK_MESSAGE(said.contains("proved " + name), name);
  for (const std::string& name : spoiled) {
    CHECK_MESSAGE(said.contains("stated " + name), name);
    CHECK_MESSAGE(!said.contains("proved " + name), name);
  }
  CHECK(spoiled.size() >= 230);
}
