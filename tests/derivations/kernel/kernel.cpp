// Coq's kernel on every lemma, and on lemmas that are spoiled. What they say:
// tests/derivations/kernel/kernel_statements.cpp; theorems written by hand:
// tests/derivations/kernel/kernel_theorems.cpp, tests/derivations/kernel/kernel_spoiled.cpp.
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
#include <tests/run_program.hpp>

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

/// Where the scripts of all rows stay compiled.
const std::filesystem::path scripts = REDERIVE_PROGRAMS "/../proofs";

Result coq(const std::filesystem::path& folder, const std::string& program, const std::string& arguments) {
  return run_program("/bin/sh", {"-c", "cd " + quoted(folder) + " && " + program + " -R " + quoted(scripts) +
                                           " Rederive " + arguments});
}

/// Compiles the scripts that say something else than when they were last compiled, and what rests on them.
void compile_scripts() {
  static const Result made = [] {
    const TemporaryFolder folder;
    REQUIRE(run_program("ledger", {"certify", folder.path}).exit_code == 0);
    std::filesystem::create_directories(scripts);
    for (const auto& old : std::filesystem::directory_iterator(scripts))
      if (old.path().extension() == ".v" && !std::filesystem::exists(folder.path / old.path().filename()))
        std::filesystem::remove(old);
    for (const auto& now : std::filesystem::directory_iterator(folder.path)) {
      const std::filesystem::path kept = scripts / now.path().filename();
      if (!std::filesystem::exists(kept) || read_file(kept) != read_file(now.path()))
        std::filesystem::copy_file(now, kept, std::filesystem::copy_options::overwrite_existing);
    }
    return run_program("/usr/bin/make", {"-j2", "-C", scripts});
  }();
  REQUIRE_MESSAGE(made.exit_code == 0, made.err);
}

/// A lemma, its script as one tactic that must succeed, or must fail.
std::string one_tactic(const std::string& lemma, const std::string& must) {
  const auto proof = lemma.find("\nProof.\n  "), end = lemma.find(".\nQed.");
  const auto colon = lemma.find(" :");
  std::string script = lemma.substr(proof + 10, end - proof - 10);
  for (std::size_t at; (at = script.find(".\n")) != std::string::npos;) script.replace(at, 1, ";");
  return "Goal" + lemma.substr(colon + 2, proof - colon - 2) + "\nProof.\n" + must + " (solve [ " + script +
         " ]).\nAbort.\n\n";
}

}  // namespace

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
  if (!has_tool("coqc")) return;
  compile_scripts();
  const TemporaryFolder folder;
  std::vector<std::string> halves(2, imports);
  int slips = 0, factors = 0, conditions = 0;
  const auto must_fail = [&](const std::string& lemma) {
    halves[(slips + factors + conditions) % 2] += one_tactic(lemma, "assert_fails");
  };
  for (std::size_t k = 0; k < entries().size(); ++k) {
    const Entry& entry = entries()[k];
    const auto right = lemma_of(entry);
    if (!right || right->kind != Lemma::Kind::row) continue;
    if (k % 6 == 0)
      if (const auto lemma = with_a_slip(entry, k)) must_fail(*lemma), ++slips;
    if (const auto lemma = without_conditions(entry)) must_fail(*lemma), ++conditions;
    if (k % 8 == 0 && right->text.find("eq_by (") != std::string::npos)
      must_fail(replaced(statement_and_proof(*right), "eq_by (", "eq_by (2 + ")), ++factors;
    if (k % 16 == 0)  // the right one in the same form
      halves[k / 16 % 2] += one_tactic(statement_and_proof(*right), "assert_succeeds");
  }
  INFO(slips << " slips, " << factors << " factors, " << conditions << " conditions");
  CHECK(slips >= 30);  // more are in theorems written by hand: kernel_spoiled.cpp
  CHECK(factors >= 20);
  CHECK(conditions >= 20);
  const auto compiles = [&](const std::string& name, const std::string& text) {
    std::ofstream(folder.path / name) << text;
    return coq(folder.path, "coqc", name);
  };
  auto other = std::async(std::launch::async, compiles, "Spoiled1.v", halves[1]);
  const Result first = compiles("Spoiled0.v", halves[0]), second = other.get();
  CHECK_MESSAGE(first.exit_code == 0, first.err);
  CHECK_MESSAGE(second.exit_code == 0, second.err);
}

TEST_CASE("no spoiled enclosure passes Coq") {
  if (!has_tool("coqc")) return;
  compile_scripts();
  const TemporaryFolder folder;
  const std::string text = theorem_file("Thresholds.v");
  const std::size_t start = text.find("Theorem threshold_at_1");
  std::string goals =
      "From Rederive Require Import Rederive Bounds Solutions Limits Thresholds.\n"
      "From Coquelicot Require Import Coquelicot.\n";
  // "Theorem threshold_at_1 : statement. Proof. tactic. Qed."
  static const std::regex theorem("Theorem threshold_at_(\\d) :([^]*?)Proof\\. ([^]*?)\\. Qed\\."),
      end_of_psi("\\b(\\d{16,17})(?=/10\\^17)");
  int spoiled = 0;
  for (std::sregex_iterator at(text.begin() + static_cast<std::ptrdiff_t>(start), text.end(), theorem), end;
       at != end; ++at, ++spoiled) {
    const std::string goal = "Goal" + (*at)[2].str() + "Proof. ",
                      proof = " (solve [ " + (*at)[3].str() + " ]). Abort.\n";
    goals += goal + "assert_succeeds" + proof;
    std::string moved;  // both ends of psi by two units, in the statement and in the proof
    const std::string whole = goal + "assert_fails" + proof;
    std::size_t done = 0;
    for (std::sregex_iterator number(whole.begin(), whole.end(), end_of_psi), none; number != none;
         ++number) {
      const auto place = static_cast<std::size_t>(number->position());
      moved += whole.substr(done, place - done) + std::to_string(std::stoll(number->str()) + 2);
      done = place + number->str().size();
    }
    CHECK(done > 0);
    goals += moved + whole.substr(done);
  }
  CHECK(spoiled == 4);
  std::ofstream(folder.path / "Enclosures.v") << goals;
  const Result r = coq(folder.path, "coqc", "Enclosures.v");
  CHECK_MESSAGE(r.exit_code == 0, r.err);
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
