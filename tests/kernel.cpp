// Coq's kernel on every row of the ledger; and that what the lemmas say is what the paper says.
#include <doctest/doctest.h>

#include <algorithm>
#include <derivations/decide/points.hpp>
#include <derivations/kernel/coq_text.hpp>
#include <derivations/kernel/lemma.hpp>
#include <derivations/kernel/scripts.hpp>
#include <derivations/language/print.hpp>
#include <derivations/paper/mutate.hpp>
#include <future>
#include <lessons/certify/steps.hpp>
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

/// A folder with what lemmas are proved with, compiled once.
const TemporaryFolder& compiled_prelude() {
  static const TemporaryFolder folder;
  static const bool is_compiled = [] {
    for (const char* name : prelude) {
      std::ofstream(folder.path / name) << shipped(name);
      if (coq(folder.path, "coqc", name).exit_code != 0) return false;
    }
    return true;
  }();
  REQUIRE(is_compiled);
  return folder;
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
  const TemporaryFolder folder;
  const auto scripts = folder.path / "proofs";
  REQUIRE(run_program("ledger", {"certify", scripts}).exit_code == 0);
  static const std::regex lemma(
      "\n(Lemma|Theorem) (equation|step|derivation|claim|threshold|one_impact)(\\w+)");
  std::map<std::string, std::string> names;  // of each file
  std::map<std::string, int> kinds;
  for (const auto& file : std::filesystem::directory_iterator(scripts)) {
    if (file.path().extension() != ".v") continue;
    const std::string text = read_file(file.path());
    for (const char* word : {"Admitted", "Axiom", "Parameter", "admit", "Hypothesis :"})
      CHECK_MESSAGE(text.find(word) == std::string::npos, word);
    std::string& all = names[file.path().stem()];
    for (std::sregex_iterator at(text.begin(), text.end(), lemma), end; at != end; ++at) {
      all += (all.empty() ? "" : ", ") + (*at)[2].str() + (*at)[3].str();
      ++kinds[(*at)[2]];
    }
  }
  CHECK(kinds["equation"] == 207 + 14 + 14);  // rows, refutations, and these as they should read
  CHECK(kinds["step"] >= 45);
  CHECK(kinds["derivation"] >= 120);
  const Result made = run_program("/usr/bin/make", {"-j2", "-C", scripts});
  CHECK_MESSAGE(made.exit_code == 0, made.err);

  const std::set<std::string> reals{
      "ClassicalDedekindReals.sig_not_dec", "ClassicalDedekindReals.sig_forall_dec",
      "FunctionalExtensionality.functional_extensionality_dep", "Classical_Prop.classic"};
  static const std::regex axiom("(^|\n)([A-Za-z_][\\w.']*)(?= :|\n)");
  std::string files, imported, all;
  for (const auto& [file, theirs] : names) {
    // Bounds.v and what it proves is not for coqchk, which has no virtual machine to compute with.
    if (file != "Bounds" && file != "Thresholds" && file != "OneImpact") files += " -norec Rederive." + file;
    imported += " " + file;
    if (!theirs.empty()) all += (all.empty() ? "" : ", ") + theirs;
  }
  std::ofstream(scripts / "Assumed.v") << "From Rederive Require Import" << imported
                                       << ".\nDefinition all := (" << all << ").\nPrint Assumptions all.\n";
  const Result assumed = coq(scripts, "coqc", "Assumed.v");
  CHECK_MESSAGE(assumed.exit_code == 0, assumed.err);
  int axioms = 0;
  for (std::sregex_iterator at(assumed.out.begin(), assumed.out.end(), axiom), end; at != end; ++at, ++axioms)
    CHECK_MESSAGE(((*at)[2] == "Axioms:" || reals.contains((*at)[2])), (*at)[2].str());
  CHECK(axioms >= 3);
  const Result checked = coq(scripts, "coqchk", "-silent" + files);
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
  const auto slips = mutants(printed, symbols);
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
  const TemporaryFolder& folder = compiled_prelude();
  std::vector<std::string> halves(2, imports);
  int slips = 0, factors = 0, conditions = 0;
  const auto must_fail = [&](const std::string& lemma) {
    halves[(slips + factors + conditions) % 2] += one_tactic(lemma, "assert_fails");
  };
  for (std::size_t k = 0; k < entries().size(); ++k) {
    const Entry& entry = entries()[k];
    const auto right = lemma_of(entry);
    if (!right || right->kind != "row") continue;
    if (const auto lemma = with_a_slip(entry, k)) must_fail(*lemma), ++slips;
    if (const auto lemma = without_conditions(entry)) must_fail(*lemma), ++conditions;
    if (k % 8 == 0 && right->text.find("eq_by (") != std::string::npos)
      must_fail(replaced(statement_and_proof(*right), "eq_by (", "eq_by (2 + ")), ++factors;
    if (k % 16 == 0)  // the right one in the same form
      halves[k / 16 % 2] += one_tactic(statement_and_proof(*right), "assert_succeeds");
  }
  INFO(slips << " slips, " << factors << " factors, " << conditions << " conditions");
  CHECK(slips >= 200);
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
  const TemporaryFolder& folder = compiled_prelude();
  const std::string text = shipped("Thresholds.v");
  const std::size_t start = text.find("Theorem threshold_at_1");
  std::string goals = text.substr(0, start);
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

namespace {

/// The hypotheses of a lemma, in our syntax.
std::vector<Relation> hypotheses_in(const std::string& lemma, const Symbols& symbols) {
  static const std::regex line("\n  ([^\n]*) ->(?=\n  )");
  const std::string head = lemma.substr(0, lemma.find("\nProof."));
  std::vector<Relation> result;
  for (std::sregex_iterator at(head.begin(), head.end(), line), end; at != end; ++at)
    for (const std::string& link : links_in(in_our_syntax((*at)[1].str()))) {
      const auto differs = link.find(" <> ");
      result.push_back(differs == std::string::npos ? parse_relation(link, symbols)
                                                    : Relation{{parse(link.substr(0, differs), symbols),
                                                                parse(link.substr(differs + 4), symbols)},
                                                               {"!="}});
    }
  return result;
}

/// A point at which all of them hold: numbers of two digits, and what the equations among them say; as text.
std::optional<std::string> point_of(const std::vector<Relation>& hypotheses) {
  std::set<std::string> names, defined;
  for (const Relation& h : hypotheses) {
    names.merge(names_of(h));
    if (is_equation(h) && is_symbol(h.sides[0])) defined.insert(h.sides[0]->text);
  }
  int seed = 1;
  for (int tried = 0; tried < 3000; ++tried) {
    std::map<std::string, Tree> at;
    std::string text;
    const auto give = [&](const std::string& name) {
      seed = seed * 37 % 9973;
      const cln::cl_RA q =
          cln::cl_RA(seed % 41 - (tried % 3 == 0 ? 20 : 0)) / (seed % 5 + 1 + 20 * (tried % 2));
      at[name] = tree_of({q});
      text += " " + name + " = " + print(at[name], Notation::plain, Symbols());
    };
    for (const std::string& name : names)
      if (!defined.contains(name)) give(name);
    for (auto left = defined; !left.empty();) {
      const std::size_t before = left.size();
      for (const Relation& h : hypotheses) {
        if (!is_equation(h) || !is_symbol(h.sides[0]) || !left.contains(h.sides[0]->text)) continue;
        Tree value = h.sides[1];
        for (const auto& [name, other] : at) value = put_in(value, name, other);
        if (names_of(value).empty()) at[h.sides[0]->text] = value, left.erase(h.sides[0]->text);
      }
      if (left.size() == before)
        give(*left.rbegin()), left.erase(std::prev(left.end()));  // they say it of each other
    }
    Point point;
    for (const auto& [name, value] : at) point.emplace(name, Number(value));
    const auto holds = [&](const Relation& h) {  // roots are told apart, but not seen to be equal
      const Truth truth = truth_at(h, point);
      return truth == Truth::holds || (is_equation(h) && truth != Truth::fails);
    };
    if (std::all_of(hypotheses.begin(), hypotheses.end(), holds)) return text;
  }
  return std::nullopt;
}

}  // namespace

TEST_CASE("the hypotheses of each lemma hold at some point") {
  std::vector<Lemma> lemmas = steps_of(entries());
  for (const Entry& entry : entries())
    if (const auto lemma = lemma_of(entry)) lemmas.push_back(*lemma);
  int named = 0;
  for (const Lemma& lemma : lemmas) {
    if (lemma.kind == "refutation") continue;  // it names its point itself
    const auto entry = std::find_if(entries().begin(), entries().end(),
                                    [&](const Entry& e) { return e.row.id == lemma.id; });
    const auto point = point_of(hypotheses_in(lemma.text, symbols_in(entry->row.domain)));
    CHECK_MESSAGE(point, lemma.text);
    if (point) MESSAGE(lemma.name << " at" << *point);
    named += point ? 1 : 0;
  }
  CHECK(named >= 240);
}

TEST_CASE("the theorems that claims quote are there") {
  std::set<std::string> names;
  for (const Lemma& theorem : shipped_theorems()) names.insert(theorem.name);
  const std::string claims = read_file(std::string(REDERIVE_SOURCE) + "/derivations/paper/claims.toml");
  static const std::regex quoted_name("claim_c\\w+");
  int found = 0;
  for (std::sregex_iterator at(claims.begin(), claims.end(), quoted_name), end; at != end; ++at, ++found)
    CHECK_MESSAGE(names.contains(at->str()), at->str());
  CHECK(found >= 4);
}

TEST_CASE("a folder with all rows says what rests on what, and draws it") {
  const TemporaryFolder folder;
  const auto scripts = folder.path / "proofs";
  REQUIRE(run_program("ledger", {"certify", scripts}).exit_code == 0);
  const std::string page = read_file(scripts / "README.md"), drawing = read_file(scripts / "rests.svg");
  CHECK(page.find("| (71) | `step_71` | (68), (69a), (69b), (70a), (70b), (u20) | yes |") !=
        std::string::npos);
  CHECK(page.find("- (52) `") != std::string::npos);  // assumed
  CHECK(drawing.find(">92a</text>") != std::string::npos);
  CHECK(drawing.find("</svg>") != std::string::npos);
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
