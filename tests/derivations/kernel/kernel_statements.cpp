// What the lemmas for Coq say: the same as the paper and the derivation, about points that there are.
#include <doctest/doctest.h>

#include <algorithm>
#include <derivations/decide/points.hpp>
#include <derivations/kernel/lemma.hpp>
#include <derivations/kernel/scripts.hpp>
#include <derivations/language/print.hpp>
#include <lessons/ledger/steps.hpp>
#include <lessons/rocking_block/claims.hpp>
#include <regex>
#include <tests/block.hpp>
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
  std::vector<Lemma> lemmas =
      steps_of(rocking_block::paper(), entries(), [](const std::string&) { return true; });
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

TEST_CASE("before each derivation stands from what: rows, and what is assumed") {
  std::set<std::string> known{"newton", "euler", "rotation", "linearised", "rest", "criterion"};
  for (const Entry& entry : entries()) known.insert(entry.row.id);
  static const std::regex theorem("\n(\\(\\* from ([^*]*) \\*\\)\n)?Theorem (derivation_\\w+)"),
      word("[^, ]+");
  int found = 0;
  for (const std::string& file : theorem_files()) {
    const std::string text = shipped(file);
    for (std::sregex_iterator at(text.begin(), text.end(), theorem), end; at != end; ++at, ++found) {
      CHECK_MESSAGE((*at)[1].matched, (*at)[3].str());
      const std::string from = (*at)[2];
      for (std::sregex_iterator of(from.begin(), from.end(), word); of != end; ++of)
        CHECK_MESSAGE(known.contains(of->str()), (*at)[3].str(), " from ", of->str());
    }
  }
  CHECK(found >= 150);
}

TEST_CASE("the theorems that claims quote are there, and about the claim that quotes them") {
  std::set<std::string> names;
  for (const Lemma& theorem : shipped_theorems()) names.insert(theorem.name);
  static const std::regex quoted_name("claim_c\\w+");
  int found = 0;
  for (const Claim& claim : read_claims(rocking_block::claims()))
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
