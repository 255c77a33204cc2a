// What the lemmas for Coq say: the same as the paper and the derivation, about points that there are.
#include <doctest/doctest.h>

#include <algorithm>
#include <derivations/decide/points.hpp>
#include <derivations/kernel/lemma.hpp>
#include <derivations/kernel/row_text.hpp>
#include <derivations/kernel/scripts.hpp>
#include <derivations/language/print.hpp>
#include <lessons/ledger/steps.hpp>
#include <lessons/rocking_block/claims.hpp>
#include <regex>
#include <tests/block.hpp>
#include <tests/run_program.hpp>

using namespace rederive::language;
using namespace rederive::numbers;
using namespace rederive::decide;
using namespace rederive::paper;
using namespace rederive::kernel;
using namespace rederive::rocking_block;
using namespace rederive::ledger;
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

TEST_CASE("a lemma says what is printed, and what is derived") {
  int compared = 0;
  for (const Entry& entry : entries()) {
    const auto found = lemma_of(entry);
    if (!found || found->kind != Lemma::Kind::row) continue;
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
  std::vector<Lemma> lemmas =
      steps_of(rederive::rocking_block::paper(), entries(), [](const std::string&) { return true; });
  for (const Entry& entry : entries())
    if (const auto lemma = lemma_of(entry)) lemmas.push_back(*lemma);
  int named = 0;
  for (const Lemma& lemma : lemmas) {
    if (lemma.kind == Lemma::Kind::refutation) continue;  // it names its point itself
    const auto entry = std::find_if(entries().begin(), entries().end(),
                                    [&](const Entry& e) { return e.row.id == lemma.id; });
    const auto point = point_of(hypotheses_in(lemma.text, symbols_in(entry->row.domain)));
    CHECK_MESSAGE(point, lemma.text);
    if (point) MESSAGE(lemma.name << " at" << *point);
    named += point ? 1 : 0;
  }
  CHECK(named >= 240);
}

TEST_CASE("the list of theorems has those of the files, and says from what each derivation follows") {
  std::set<std::string> known, listed, written;
  for (const Entry& entry : entries()) known.insert(entry.row.id);
  for (const auto& [name, sentence] : theorems().assumptions) known.insert(name);
  for (const Lemma& theorem : theorems().lemmas) {
    CHECK_MESSAGE(listed.insert(theorem.file + " " + theorem.name).second, theorem.name, " is listed twice");
    CHECK_MESSAGE((theorem.kind != Lemma::Kind::derivation || !theorem.from.empty()), theorem.name);
    for (const std::string& from : theorem.from)
      CHECK_MESSAGE(known.contains(from), theorem.name, " from ", from);
    for (const std::string& row : theorem.derives) CHECK_MESSAGE(known.contains(row), theorem.name);
  }
  static const std::regex theorem("\nTheorem (\\w+)");
  for (const std::string& file : theorems().files) {
    const std::string text = shipped(file);
    for (std::sregex_iterator at(text.begin(), text.end(), theorem), end; at != end; ++at)
      written.insert(file + " " + (*at)[1].str());
  }
  CHECK(listed == written);
  CHECK(written.size() >= 190);
}

namespace {

/// The statement of each theorem, with the names of rows in it.
std::map<std::string, std::string> statements() {
  static const std::regex theorem("\nTheorem (\\w+)([^]*?)\nProof");
  std::map<std::string, std::string> result;
  for (const std::string& file : theorems().files) {
    const std::string text = shipped(file);
    for (std::sregex_iterator at(text.begin(), text.end(), theorem), end; at != end; ++at)
      result[(*at)[1]] = (*at)[2];
  }
  return result;
}

/// The rows that a statement names.
std::set<std::string> rows_in(const std::string& statement) {
  static const std::regex row("(?:row|left|right)\\{(\\w+)");
  std::set<std::string> rows;
  for (std::sregex_iterator at(statement.begin(), statement.end(), row), end; at != end; ++at)
    rows.insert((*at)[1]);
  return rows;
}

/// Rows that a theorem derives, but says in its own words, and why.
const std::map<std::string, std::string> in_other_words{
    {"1", "Lagrange's equation is the definition of `lagrange`, and the theorem compares it with Newton's"},
    {"43a", "it is about the wrong row, as it is printed"},
    {"r12", "it says how far from the row the block may be"},
    {"r14", "the row is cos(pi - psi) = -cos(psi); the theorem is what it is for: when the block is pushed"},
    {"u11", "it is the same as u17, with another name for the acceleration of the ground"},
    {"u19a", "it is the same as 60b, on the other side"}};

/// Theorems with premises that are equations, but neither rows nor about rest, a side or a moment.
const std::map<std::string, std::string> other_premises{
    {"derivation_42a", "R' is half the diagonal"},
    {"derivation_31", "(28a) with (28b) put in"},
    {"derivation_u10a", "(25) calls the acceleration of the ground at the start lambda a_p"},
    {"derivation_53b", "(25) calls the acceleration of the ground at the start lambda a_p"},
    {"derivation_u27b", "(25) calls the acceleration of the ground at the start lambda a_p"},
    {"derivation_25a", "(47a), on either side"},
    {"derivation_u9a", "(47a), on either side"},
    {"derivation_1", "Newton's laws"},
    {"derivation_27", "(25b) and (26b) with the lengths put in"},
    {"derivation_r16", "an impulse, and the speeds (4b) and (15b) at the impact"},
    {"derivation_40a", "y of the point at r and phi, as (u15) is its x"},
    {"derivation_u12a", "(6) and (16b) at theta = 0"},
    {"derivation_50a_r1_r3", "(47a) on the side on which it is not printed"},
    {"derivation_r15", "the motion until the pulse ends"},
    {"derivation_r12", "(89a) and (89b) at the impact"},
    {"derivation_u21", "(53b) with (u11)"},
    {"derivation_u29", "(u27b) with (u11)"}};

/// The parts of a statement before the arrows that are not in parentheses.
std::vector<std::string> premises_in(const std::string& statement) {
  std::vector<std::string> parts(1);
  int depth = 0;
  for (std::size_t k = 0; k < statement.size(); ++k) {
    depth += statement[k] == '(' ? 1 : statement[k] == ')' ? -1 : 0;
    const bool is_arrow = depth == 0 && statement.compare(k, 2, "->") == 0 && statement[k - 1] != '<';
    if (is_arrow) parts.emplace_back();
    if (is_arrow) ++k;
    if (!is_arrow) parts.back() += statement[k];
  }
  parts.pop_back();
  return parts;
}

}  // namespace

TEST_CASE("hypotheses of theorems that are called by a row are that row") {
  static const std::regex hypothesis("equation_(\\w+) : ([^:]*)");
  int found = 0;
  for (const std::string& file : theorems().files) {
    const std::string text = shipped(file);
    for (std::sregex_iterator at(text.begin(), text.end(), hypothesis), end; at != end; ++at, ++found)
      CHECK_MESSAGE(((*at)[1] == "21" || (*at)[2].str().find("row{" + (*at)[1].str()) != std::string::npos),
                    file, ": ", at->str());  // (21) is on both sides of the block
  }
  CHECK(found >= 30);
}

TEST_CASE("a theorem that derives rows has them in its statement, and starts from rows or what is listed") {
  const auto all = statements();
  std::map<std::string, const Entry*> by_id;
  for (const Entry& entry : entries()) by_id[entry.row.id] = &entry;
  std::set<std::string> said;
  int rows = 0;
  for (const Lemma& theorem : theorems().lemmas) {
    if (theorem.kind != Lemma::Kind::derivation) continue;
    const std::string& statement = all.at(theorem.name);
    std::set<std::string> known(theorem.derives.begin(), theorem.derives.end()), found = rows_in(statement);
    for (const std::string& id : theorem.derives) {
      CHECK_MESSAGE(found.contains(id) != in_other_words.contains(id), theorem.name, " and row ", id);
      rows += found.contains(id) ? 1 : 0;
    }
    for (const std::string& id : theorem.from) {
      known.insert(id);
      if (const auto entry = by_id.find(id); entry != by_id.end())
        known.insert(entry->second->row.follows_from.begin(), entry->second->row.follows_from.end());
    }
    for (const std::string& id : found)
      CHECK_MESSAGE(known.contains(id), theorem.name, " names the row ", id,
                    ", from which it does not follow");
    static const std::regex row("(row|left|right)\\{[^}]*\\}"),
        choice("[^]*(\\w+ (t|0|t_i)|a_p) = 0\\s*|[^]*side = -?1\\s*|[^]*t_o = T_ex\\s*");
    for (const std::string& premise : premises_in(statement.substr(statement.find(':')))) {
      const std::string by_hand = std::regex_replace(premise, row, "");
      if (by_hand.find(" = ") != std::string::npos && !std::regex_match(premise, choice))
        CHECK_MESSAGE(other_premises.contains(theorem.name), theorem.name, " starts from ", premise);
    }
  }
  CHECK(rows >= 175);
}

TEST_CASE("a placeholder writes a row as Coq reads it, and says what is wrong with it") {
  const auto right_row = [](const std::string& id) {
    return right_form(rederive::rocking_block::paper(), id);
  };
  const auto written = [&](const std::string& text) {
    return with_rows(paper_symbols(), right_row, {"theta"}, text);
  };
  CHECK(written("a -> row{71}.") ==
        "a -> cos psi - omega_p / p * sin psi = exp (-(2 * PI - psi) / (omega_p / p)).");
  CHECK(written("row{71, omega_p/p := w}") == "cos psi - w * sin psi = exp (-(2 * PI - psi) / w)");
  CHECK(written("row{70b, omega_p/p := w}") == "A_2 = alpha * w ^ 2 / (1 + w ^ 2)");
  CHECK(written("right{78, omega_p/p := w, psi := x}") == "exp (-(2 * PI - x) / w)");
  CHECK(written("left{78, omega_p/p := w}") == "(w + 2 / w) * sin psi + cos psi");
  CHECK(written("row{66b, theta_ex := theta T_ex}") == "Abar_2 = (theta T_ex) + alpha");
  CHECK(written("right{2b at t}") == "b - R' * sin (alpha + (theta t))");
  CHECK(written("row{60c}") == "theta_star = -alpha");  // as it should read
  for (const char* wrong :
       {"row{no-such-row}", "row{1000}", "row{71, omega_p := }", "row{71, alpha := 1}", "row{71"})
    CHECK_THROWS_AS(written(wrong), std::runtime_error);
}

TEST_CASE("the theorems that claims quote are there, and about the claim that quotes them") {
  std::set<std::string> names;
  for (const Lemma& theorem : theorems().lemmas) names.insert(theorem.name);
  static const std::regex quoted_name("claim_c\\w+");
  int found = 0;
  for (const Claim& claim : read_claims(rederive::rocking_block::claims()))
    for (const auto& [verdict, words] : claim.meaning)  // with those taken over from other claims
      for (std::sregex_iterator at(words.begin(), words.end(), quoted_name), end; at != end; ++at, ++found) {
        CHECK_MESSAGE(names.contains(at->str()), at->str());
        CHECK_MESSAGE(at->str().starts_with("claim_" + claim.id + "_"), claim.id, " quotes ", at->str());
      }
  CHECK(found >= 6);
}

TEST_CASE("a folder with all rows says what rests on what, and draws it") {
  const TemporaryFolder folder;
  const auto scripts = folder.path / "proofs";
  REQUIRE(run_program("ledger", {"certify", scripts}).exit_code == 0);
  const std::string page = read_file(scripts / "README.md"), drawing = read_file(scripts / "rests.svg");
  for (const char* row :
       {"| (71) | `derivation_71` | 68, 69a, 69b, 70a, 70b, u20 | yes |",
        "| (u11) | `derivation_u11_u17` | 28a | yes |", "| (88), corrected |", "- newton: "})
    CHECK_MESSAGE(page.find(row) != std::string::npos, row);
  CHECK(page.find("- (52) `") != std::string::npos);  // assumed
  CHECK(drawing.find(">92a</text>") != std::string::npos);
  CHECK(drawing.find("</svg>") != std::string::npos);
}
