// Coq's kernel checks every lemma and refuses lemmas that are spoiled. kernel_statements.cpp tests what the
// lemmas say, kernel_theorems.cpp the theorems that are written by hand.
#include <doctest/doctest.h>

#include <algorithm>
#include <derivations/kernel/coq_text.hpp>
#include <derivations/kernel/lemma.hpp>
#include <derivations/kernel/scripts.hpp>
#include <derivations/paper/mutate.hpp>
#include <future>
#include <nlohmann/json.hpp>
#include <regex>
#include <tests/block.hpp>
#include <tests/derivations/kernel/compiled.hpp>

using namespace rederive::language;
using namespace rederive::numbers;
using namespace rederive::decide;
using namespace rederive::program;
using namespace rederive::paper;
using namespace rederive::kernel;
using namespace rederive::rocking_block;
using namespace rederive::test;

namespace {

const std::vector<Entry>& entries() {
  static const std::vector<Entry> all = [] {
    std::vector<Entry> result;
    const auto rows = read_rows(equations_file());
    for (const Row& row : rows) result.push_back(judge(row));
    return result;
  }();
  return all;
}

}  // namespace

TEST_CASE("the scripts of all rows and theorems compile" * doctest::skip()) {
  if (has_tool("coqc")) compile_scripts();
}

TEST_CASE("ledger certify --check says lemma by lemma what passes, and what is assumed") {
  if (!has_tool("coqc")) return;
  const TemporaryFolder folder;
  const Result r =
      run_program("ledger", {"certify", folder.path / "x", "71", "17b", "r5", "--check", "--json"});
  CHECK(r.exit_code == 0);
  const auto json = nlohmann::json::parse(r.out);
  CHECK(json["counts"]["rows"] == 2);
  CHECK(json["counts"]["refutations"] == 1);
  CHECK(json["counts"]["derivations"] == 3);  // two steps, and (17b) as it should read
  CHECK(json["counts"]["passed"] == 6);
  CHECK(json["counts"]["failed"] == 0);
  for (const auto& lemma : json["lemmas"]) {
    CHECK_MESSAGE(lemma["passed"] == true, lemma["name"]);
    CHECK_FALSE(lemma["axioms"].empty());
  }
}

TEST_CASE("everything passes Coq's kernel, coqchk takes it, and it assumes the real numbers alone") {
  if (!has_tool("coqc") || !has_tool("coqchk")) return;
  compile_scripts();
  static const std::regex lemma("\n(?:Theorem|Lemma (?=equation|step|instance)) ?([a-z]+)(\\w*)");
  std::map<std::string, std::string> names;  // of each file
  std::map<std::string, int> kinds;
  for (const auto& file : std::filesystem::directory_iterator(scripts)) {
    if (file.path().extension() != ".v") continue;
    const std::string text = read_file(file.path());
    for (const char* word : {"Admitted", "Axiom", "Parameter", "admit"})
      CHECK_MESSAGE(text.find(word) == std::string::npos, word);
    std::string& all = names[file.path().stem()];
    for (std::sregex_iterator at(text.begin(), text.end(), lemma), end; at != end; ++at) {
      all += " let _ := " + (*at)[1].str() + (*at)[2].str() + " in";
      ++kinds[(*at)[1]];
    }
  }
  CHECK(kinds["equation"] == 207 + 14 + 14);  // rows, refutations, and these as they should read
  CHECK(kinds["step"] >= 45);
  CHECK(kinds["derivation"] >= 150);
  CHECK(kinds["instance"] >= 10);

  const std::set<std::string> reals{
      "ClassicalDedekindReals.sig_not_dec", "ClassicalDedekindReals.sig_forall_dec",
      "FunctionalExtensionality.functional_extensionality_dep", "Classical_Prop.classic"};
  static const std::regex axiom("(^|\n)([A-Za-z_][\\w.']*)(?= :|\n)");
  std::string files, imported, all;
  for (const auto& [file, theirs] : names) {
    // Intervals.v has no proof of ours, and coqchk does not come to an end with the library's
    // exp_fast_correct.
    if (file != "Intervals") files += " -norec Rederive." + file;
    imported += " " + file;
    all += theirs;
  }
  const TemporaryFolder folder;
  std::ofstream(folder.path / "Assumed.v")
      << "From Rederive Require Import" << imported << ".\nDefinition all :=" << all
      << " tt.\nPrint Assumptions all.\n";
  auto checking = std::async(std::launch::async, [&] {  // beside coqc, which takes as long
    return coq(folder.path, "coqchk", "-silent -bytecode-compiler yes" + files);
  });
  const Result assumed = coq(folder.path, "coqc", "Assumed.v");
  CHECK_MESSAGE(assumed.exit_code == 0, assumed.err);
  int axioms = 0;
  for (std::sregex_iterator at(assumed.out.begin(), assumed.out.end(), axiom), end; at != end; ++at, ++axioms)
    CHECK_MESSAGE(((*at)[2] == "Axioms:" || reals.contains((*at)[2])), (*at)[2].str());
  CHECK(axioms >= 3);
  const Result checked = checking.get();
  CHECK_MESSAGE(checked.exit_code == 0, checked.err);
}

namespace {

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

std::string statement_and_proof(const Lemma& lemma) { return lemma.text.substr(lemma.text.find("Lemma ")); }

/// A slip of the row in the place of what is printed, if there is one that says something else.
std::optional<std::string> with_a_slip(const Entry& entry, std::size_t k) {
  const Symbols symbols = symbols_in(entry.row.domain);
  const Relation printed = parse_statement(entry.row.claim(), symbols);
  const auto slips = mutants(printed);
  for (std::size_t tried = 0; tried < std::min<std::size_t>(slips.size(), 4); ++tried) {
    const Relation& slip = slips[(k + tried) % slips.size()].relation;
    std::set<std::string> known = names_of(printed), names = names_of(slip);
    const bool is_closed = std::includes(known.begin(), known.end(), names.begin(), names.end());
    if (!is_closed || compare(slip, *entry.derivation, symbols).verdict != Verdict::refuted) continue;
    return replaced(statement_and_proof(*lemma_of(entry)), "(" + coq_text(printed) + " <->",
                    "(" + coq_text(slip) + " <->");
  }
  return std::nullopt;
}

/// Without the conditions that the proof reports.
std::optional<std::string> without_conditions(Entry entry) {
  if (entry.proof.side_conditions.empty()) return std::nullopt;
  entry.proof.side_conditions.clear();
  const auto found = lemma_of(entry);
  return found->text.empty() ? std::nullopt : std::optional(statement_and_proof(*found));
}

}  // namespace

TEST_CASE("nothing that is spoiled passes Coq") {
  if (!has_tool("coqtop")) return;
  compile_scripts();
  std::array<std::string, 2> halves{imports, imports};
  std::size_t all = 0, slips = 0, factors = 0, conditions = 0, right_ones = 0;
  const auto add = [&](const std::string& lemma, const std::string& kind, std::size_t& count) {
    const std::string name = kind + std::to_string(++count);
    halves[all++ % 2] += watched(name, "Lemma " + name + lemma.substr(lemma.find(" :")));
  };
  for (std::size_t k = 0; k < entries().size(); ++k) {
    const Entry& entry = entries()[k];
    const auto right = lemma_of(entry);
    if (!right || right->kind != Lemma::Kind::row) continue;
    if (k % 6 == 0)
      if (const auto lemma = with_a_slip(entry, k)) add(*lemma, "slip", slips);
    if (const auto lemma = without_conditions(entry)) add(*lemma, "condition", conditions);
    if (k % 8 == 0 && right->text.find("eq_by (") != std::string::npos)
      add(replaced(statement_and_proof(*right), "eq_by (", "eq_by (2 + "), "factor", factors);
    if (k % 16 == 0) add(statement_and_proof(*right), "right", right_ones);
  }
  CHECK(slips >= 30);  // kernel_theorems.cpp has more, in theorems written by hand
  CHECK(factors >= 20);
  CHECK(conditions >= 20);
  const std::set<std::string> said = said_about(halves);
  for (const std::string& words : said)
    CHECK_MESSAGE((words.starts_with("stated") || words.starts_with("proved right")), words);
  CHECK(said.size() == all + right_ones);
}

TEST_CASE("no spoiled enclosure passes Coq") {
  if (!has_tool("coqtop")) return;
  compile_scripts();
  const std::string text = theorem_file("Thresholds.v");
  std::string right =
                  "From Rederive Require Import Rederive Bounds Solutions Limits Thresholds.\n"
                  "From Coquelicot Require Import Coquelicot.\n",
              moved = right;  // both ends of psi by two units, in the statement and in the proof
  static const std::regex theorem("Theorem threshold_at_(\\d) [^]*?Qed\\."),
      end_of_psi("\\b(\\d{16,17})(?=/10\\^17)");
  int enclosures = 0;
  for (std::sregex_iterator at(text.begin(), text.end(), theorem), end; at != end; ++at, ++enclosures) {
    const std::string name = "enclosure_" + (*at)[1].str(),
                      whole = watched(name, "Theorem " + name + at->str().substr(at->str().find(" :")));
    right += whole;
    std::size_t done = 0;
    for (std::sregex_iterator number(whole.begin(), whole.end(), end_of_psi), none; number != none;
         ++number) {
      const auto place = static_cast<std::size_t>(number->position());
      moved += whole.substr(done, place - done) + std::to_string(std::stoll(number->str()) + 2);
      done = place + number->str().size();
    }
    CHECK(done > 0);
    moved += whole.substr(done);
  }
  CHECK(enclosures == 4);
  CHECK(said_about(right).size() == 8);
  CHECK(said_about(moved) == std::set<std::string>{"stated enclosure_1", "stated enclosure_2",
                                                   "stated enclosure_3", "stated enclosure_4"});
}

TEST_CASE(
    "each refuted row of the papers that ship passes Coq, but not with another function at the witness") {
  if (!has_tool("coqtop")) return;
  compile_scripts();
  static const std::regex refuted("Lemma (\\w+_refuted)( :[^]*?Qed\\.)");
  std::string text = imports;
  std::set<std::string> expected;
  for (const auto& paper : std::filesystem::directory_iterator(REDERIVE_SOURCE "/lessons/papers")) {
    if (!std::filesystem::exists(paper.path() / "paper.toml")) continue;
    const TemporaryFolder folder;
    REQUIRE(run_program("rederive", {paper.path(), "certify", folder.path}).exit_code == 0);
    const std::string all = read_file(folder.path / "Ledger.v");
    for (std::sregex_iterator at(all.begin(), all.end(), refuted), end; at != end; ++at) {
      const std::string lemma = (*at)[2],
                        name = lemma_name("of", paper.path().filename().string() + "_" + (*at)[1].str());
      text += watched(name, "Lemma " + name + lemma);
      expected.insert({"stated " + name, "proved " + name});
      if (lemma.find("psi = asin(") == std::string::npos) continue;
      text += watched("not_" + name, "Lemma not_" + name + replaced(lemma, "psi = asin(", "psi = acos("));
      expected.insert("stated not_" + name);
    }
  }
  CHECK(expected.contains("stated not_of_housner_1963_equation_20_refuted"));
  CHECK(said_about(text) == expected);
}

TEST_CASE("ledger prove writes a certificate where it has a script, and says so where it has none") {
  const TemporaryFolder folder;
  const std::string file = folder.path / "proof.v", library = shipped("Rederive.v");
  std::string all = library;  // and every lemma in a module of its own
  for (const auto& [its_left, right] : {std::pair{"sin(2*x)", "2*sin(x)*cos(x)"},
                                        {"1/(x-1) - 1/(x+1)", "2/(x^2-1)"},
                                        {"x/(x^2+1)", "1/(x+1/x)"},
                                        {"1/(x^2-y^2)", "1/((x-y)*(x+y))"},
                                        {"x/(x+y) - y/(x-y)", "(x^2-2*x*y-y^2)/(x^2-y^2)"},
                                        {"1/(1-tan(x)^2)", "cos(x)^2/cos(2*x)"}}) {
    const auto& left = its_left;
    const Result r = run_program("ledger", {"prove", left, right, "--certificate", file, "--json"});
    CHECK(r.exit_code == 0);
    CHECK(nlohmann::json::parse(r.out)["verdict"] == "proved");
    const std::string text = read_file(file);
    REQUIRE(text.starts_with(library));
    const std::string module = "M" + std::to_string(all.size());
    all += "Module " + module + "." + text.substr(library.size()) + "End " + module + ".\n";
  }
  if (has_tool("coqc")) {
    std::ofstream(folder.path / "all.v") << all;
    CHECK(coq(folder.path, "coqc", "all.v").exit_code == 0);
    CHECK(coq(folder.path, "coqc", "proof.v").exit_code == 0);  // it needs no other file
  }
  const Result by_sign =
      run_program("ledger", {"prove", "x^2 + y^2 >= 2*x*y", "0 < 1", "--certificate", folder.path / "no.v"});
  CHECK(by_sign.exit_code == 3);
  CHECK_FALSE(std::filesystem::exists(folder.path / "no.v"));
  const Result wrong = run_program("ledger", {"prove", "x", "x + 1", "--certificate", folder.path / "no.v"});
  CHECK(wrong.exit_code == 3);
  CHECK(wrong.err.find("refuted") != std::string::npos);
}

TEST_CASE("ledger certify refuses what it cannot do") {
  CHECK(run_program("ledger", {"certify"}).exit_code == 2);
  const TemporaryFolder folder;
  CHECK(run_program("ledger", {"certify", folder.path / "x", "no-such-row"}).exit_code == 2);
  CHECK_FALSE(std::filesystem::exists(folder.path / "x"));
  CHECK(run_program("ledger", {"certify", "--check", "24b"}).exit_code == 2);
  CHECK_FALSE(std::filesystem::exists("24b"));
  CHECK(run_program("ledger", {"show", "71", "--coq"}).out.find("Lemma equation_71 :") != std::string::npos);
}
