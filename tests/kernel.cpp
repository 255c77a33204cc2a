// Coq's kernel on every row of the ledger; and that what the lemmas say is what the paper says.
#include <doctest/doctest.h>

#include <algorithm>
#include <derivations/kernel/coq_text.hpp>
#include <derivations/kernel/lemma.hpp>
#include <derivations/kernel/scripts.hpp>
#include <derivations/language/print.hpp>
#include <derivations/paper/mutate.hpp>
#include <nlohmann/json.hpp>
#include <regex>
#include <tests/run_program.hpp>

using namespace rederive;

namespace {

const std::vector<Entry>& entries() {
  static const std::vector<Entry> all = [] {
    std::vector<Entry> result;
    const auto rows = read_rows(equations_file());
    for (const Row& row : rows) result.push_back(judge(row, rows));
    return result;
  }();
  return all;
}

Result coq(const std::filesystem::path& folder, const std::string& program, const std::string& arguments) {
  return run_program("/bin/sh",
                     {"-c", "cd " + quoted(folder) + " && " + program + " -R . Rederive " + arguments});
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

/// A small reader of Coq's text: in our syntax.
std::string in_our_syntax(std::string text) {
  for (const auto& [coq, ours] :
       {std::pair{"\\bPI\\b", "pi"}, std::pair{"R'", "R"}, std::pair{"\\bln\\(", "log("}})
    text = std::regex_replace(text, std::regex(coq), ours);
  return text;
}

/// Whether two relations have sides of the same values wherever they are asked, sides perhaps exchanged.
bool say_the_same(const Relation& a, const Relation& b, const Symbols& symbols) {
  if (a.sides.size() != b.sides.size()) return false;
  std::set<std::string> names = names_of(a);
  names.merge(names_of(b));
  int seed = 1, compared = 0;
  for (int k = 0; k < 50; ++k) {
    Point point;
    for (const std::string& name : names) {
      const Interval range = parse_range(symbols.find(name)->range);
      const auto inside = [&](const cln::cl_RA& q) { return range.contains({q}); };
      cln::cl_RA q = cln::cl_RA((seed = seed * 37 % 9973) % 211 - 80) / 97;
      if (!inside(q)) q = -q;
      point.emplace(name, Number(inside(q) ? q : cln::cl_RA(1) / (seed % 7 + 2)));
    }
    for (std::size_t side = 0; side < a.sides.size(); ++side) {
      const bool is_turned = a.operators[side == 0 ? 0 : side - 1] != b.operators[side == 0 ? 0 : side - 1];
      const Tree& other = b.sides[is_turned ? b.sides.size() - 1 - side : side];
      const Value x = value_at(a.sides[side], point, 200), y = value_at(other, point, 200);
      if (x.is != Value::Is::certain || y.is != Value::Is::certain) continue;
      if (((x - y).sign().value_or(0)) != 0) return false;
      ++compared;
    }
  }
  return compared >= 50;
}

/// "a = b /\ b < c", as links.
std::vector<std::string> links_in(const std::string& text) {
  std::vector<std::string> links;
  for (std::size_t start = 0, end; start <= text.size(); start = end + 4) {
    end = std::min(text.find(" /\\ ", start), text.size());
    links.push_back(text.substr(start, end - start));
  }
  return links;
}

}  // namespace

TEST_CASE("every row passes Coq's kernel, and assumes the real numbers alone") {
  if (!has_tool("coqc")) return;
  const Result r = run_program("ledger", {"certify", "--check", "--json"});
  CHECK(r.exit_code == 0);
  const auto json = nlohmann::json::parse(r.out);
  CHECK(json["counts"]["rows"] == 207);
  CHECK(json["counts"]["refutations"] == 14);
  CHECK(json["counts"]["derivations"] >= 50);
  CHECK(json["counts"]["failed"] == 0);
  const std::set<std::string> reals{
      "ClassicalDedekindReals.sig_not_dec", "ClassicalDedekindReals.sig_forall_dec",
      "FunctionalExtensionality.functional_extensionality_dep", "Classical_Prop.classic"};
  for (const auto& lemma : json["lemmas"]) {
    CHECK_MESSAGE(lemma["passed"] == true, lemma["name"]);
    for (const std::string axiom : lemma["axioms"]) CHECK_MESSAGE(reals.contains(axiom), axiom);
  }
}

TEST_CASE("the written scripts compile by themselves, and coqchk takes them") {
  if (!has_tool("coqchk")) return;
  const TemporaryFolder folder;
  const auto scripts = folder.path / "proofs";
  REQUIRE(run_program("ledger", {"certify", scripts, "71", "17b", "r5"}).exit_code == 0);
  const Result made = run_program("/usr/bin/make", {"-C", scripts});
  CHECK_MESSAGE(made.exit_code == 0, made.err);
  const Result checked =
      coq(scripts, "coqchk", "-norec Rederive.Rederive -norec Rederive.Ledger -admit Rederive.Bounds");
  CHECK_MESSAGE(checked.exit_code == 0, checked.err);
  for (const auto& file : std::filesystem::directory_iterator(scripts)) {
    if (file.path().extension() != ".v") continue;
    for (const char* word : {"Admitted", "Axiom", "Parameter", "admit", "Hypothesis"})
      CHECK_MESSAGE(read_file(file.path()).find(word) == std::string::npos, word);
  }
}

TEST_CASE("no spoiled row passes Coq") {
  if (!has_tool("coqc")) return;
  const TemporaryFolder folder;
  std::string text = imports;
  int spoiled = 0;
  for (std::size_t k = 0; k < entries().size() && spoiled < 24; k += 5) {
    const Entry& entry = entries()[k];
    if (entry.proof.verdict != Verdict::proved) continue;
    const Symbols symbols = symbols_in(entry.row.domain);
    const Relation printed = parse_statement(entry.row.claim(), symbols);
    const auto slips = mutants(printed, symbols);
    if (slips.empty()) continue;
    const Relation& slip = slips[k % slips.size()].relation;
    std::set<std::string> known = names_of(printed), names = names_of(slip);
    const bool is_closed = std::includes(known.begin(), known.end(), names.begin(), names.end());
    if (!is_closed || compare(slip, *entry.derivation, symbols).verdict != Verdict::refuted) continue;
    std::string lemma = lemma_of(entry)->text.substr(lemma_of(entry)->text.find("Lemma "));
    const std::string right = "(" + coq_text(printed) + " <->";
    const auto at = lemma.find(right);
    REQUIRE(at != std::string::npos);
    if (spoiled % 8 == 0) text += one_tactic(lemma, "assert_succeeds");  // the right one in the same form
    text += one_tactic(lemma.replace(at, right.size(), "(" + coq_text(slip) + " <->"), "assert_fails"),
        ++spoiled;
  }
  CHECK(spoiled >= 20);
  for (const char* name : {"Rederive.v", "Bounds.v"}) {
    std::ofstream(folder.path / name) << shipped(name);
    REQUIRE(coq(folder.path, "coqc", name).exit_code == 0);
  }
  std::ofstream(folder.path / "Spoiled.v") << text;
  const Result r = coq(folder.path, "coqc", "Spoiled.v");
  CHECK_MESSAGE(r.exit_code == 0, r.err);
}

TEST_CASE("a lemma says what is printed, and what is derived") {
  int compared = 0;
  for (const Entry& entry : entries()) {
    const auto found = lemma_of(entry);
    if (!found || found->kind != "row") continue;
    const Symbols symbols = symbols_in(entry.row.domain);
    const std::string text = found->text.substr(0, found->text.find("\nProof."));
    const auto start = text.rfind("\n  ("), middle = text.find(" <->\n   ", start);
    REQUIRE(middle != std::string::npos);
    const std::string left = text.substr(start + 4, middle - start - 4),
                      right = text.substr(middle + 8, text.size() - middle - 10);
    const auto check_links = [&](const std::string& coq_links, const Relation& statement) {
      const auto links = links_of(statement);
      const auto texts = links_in(coq_links);
      REQUIRE(links.size() == texts.size());
      for (std::size_t k = 0; k < links.size(); ++k)
        CHECK_MESSAGE(say_the_same(parse_relation(in_our_syntax(texts[k]), symbols), links[k], symbols),
                      texts[k]);
    };
    check_links(left, parse_statement(entry.row.claim(), symbols));
    check_links(right, derived_relation(*entry.derivation));
    ++compared;
  }
  CHECK(compared == 207);
}

TEST_CASE("ledger prove writes a certificate where it has a script, and says so where it has none") {
  const TemporaryFolder folder;
  const std::string file = folder.path / "proof.v";
  CHECK(run_program("ledger", {"prove", "sin(2*x)", "2*sin(x)*cos(x)", "--certificate", file}).exit_code ==
        0);
  if (has_tool("coqc")) CHECK(coq(folder.path, "coqc", "proof.v").exit_code == 0);
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
  CHECK(run_program("ledger", {"show", "71", "--coq"}).out.find("Lemma equation_71 :") != std::string::npos);
}
