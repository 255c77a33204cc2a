// Random systems of equations and inequalities with a solution that is known, against 1 = 2: what holds
// somewhere is never proved to be the same as what holds nowhere.
#include <cln/rational_io.h>
#include <doctest/doctest.h>

#include <derivations/decide/comparison.hpp>
#include <derivations/decide/decide.hpp>
#include <derivations/decide/points.hpp>
#include <derivations/language/syntax.hpp>
#include <sstream>
#include <tests/cases.hpp>
#include <tests/random.hpp>

using namespace rederive::language;
using namespace rederive::numbers;
using namespace rederive::identity;
using namespace rederive::decide;
using namespace rederive::test;
using cln::cl_RA;

namespace {

std::string text_of(const cl_RA& number) {
  std::ostringstream text;
  text << "(" << number << ")";
  return text.str();
}

/// A question of which the answer cannot be yes: the statement holds at the point, where all assumptions do.
struct Planted {
  std::string statement;
  std::vector<std::string> assumptions;
  Point solution;
};

class Planter : private Choices {
 public:
  explicit Planter(unsigned seed) : Choices(seed) {
    for (const char* name : {"x", "y", "z", "v", "w"})
      symbols.declare({name, name, name, "1", all_numbers, "", ""});
  }

  Planted next() {
    values_.clear();
    Planted planted;
    for (const std::string& name : symbols.names()) {
      values_.emplace(name, cl_RA(static_cast<long>(below(13)) - 6) / static_cast<long>(1 + below(3)));
      planted.solution.emplace(name, values_.at(name));
    }
    planted.statement = relation(below(4) != 0);
    for (std::size_t k = 1 + below(2); k > 0; --k) planted.assumptions.push_back(relation(below(3) != 0));
    if (below(2) == 0) planted.assumptions.push_back(sign_of(pick(symbols.names())));
    return planted;
  }

  Symbols symbols;

 private:
  std::string expression() {
    std::map<std::string, std::string> names;
    for (const char* place : {"$a", "$b", "$c"}) names[place] = pick(symbols.names());
    return filled(pick(expressions_)[0], names);
  }

  /// What holds at the values: an equation or an inequality.
  std::string relation(bool is_equation) {
    const std::string left = expression();
    const Value value = value_at(parse(left, symbols), Point(values_.begin(), values_.end()), 128);
    if (!value.exact) return relation(is_equation);  // roots that cancel
    if (is_equation) return left + " = " + text_of(*value.exact);
    const cl_RA slack = cl_RA(static_cast<long>(below(5))) / 2;
    return below(2) == 0 ? left + " <= " + text_of(*value.exact + slack)
                         : left + " > " + text_of(*value.exact - slack - 1);
  }

  std::string sign_of(const std::string& name) {
    const cl_RA& value = values_.at(name);
    return name + (cln::zerop(value) ? " >= 0" : cln::plusp(value) ? " > 0" : " < 0");
  }

  std::map<std::string, cl_RA> values_;
  std::vector<Cells> expressions_ = cases("expressions");
};

/// Whether the statement is found to be the same as another one by identities and signs alone. No point is
/// tried, which might tell better.
bool are_found_the_same(const Relation& statement, const Relation& other,
                        const std::vector<Relation>& assumptions, const Symbols& symbols) {
  try {
    const Problem problem = with_values({statement, other, assumptions, symbols}, {});
    Comparison setting(problem.symbols);
    translate(setting, problem);
    return same(setting, problem).has_value();
  } catch (const Undecidable&) {
    return false;
  }
}

}  // namespace

TEST_CASE("systems with a solution: none is 1 = 2, and none is called a contradiction") {
  const long systems = from_environment("REDERIVE_PAIRS", 1'000);
  Planter planter(30);
  const Relation impossible = parse_relation("1 = 2", planter.symbols);
  std::map<std::string, int> verdicts;
  for (long k = 0; k < systems; ++k) {
    const Planted planted = planter.next();
    std::string shown = planted.statement + " under";
    std::vector<Relation> assumptions;
    for (const std::string& text : planted.assumptions) {
      shown += " " + text + ",";
      assumptions.push_back(parse_relation(text, planter.symbols));
      REQUIRE(truth_at(assumptions.back(), planted.solution) == Truth::holds);
    }
    INFO(shown);
    const Relation statement = parse_relation(planted.statement, planter.symbols);
    REQUIRE(truth_at(statement, planted.solution) == Truth::holds);
    CHECK_FALSE(contradict(assumptions, planter.symbols));
    CHECK_FALSE(are_found_the_same(statement, impossible, assumptions, planter.symbols));
    if (k % 20 != 0) continue;  // the search for a witness takes longest
    const Verdict verdict = decide(statement, impossible, planter.symbols, {}, assumptions).verdict;
    CHECK((verdict == Verdict::refuted || verdict == Verdict::undecided));
    ++verdicts[to_string(verdict)];
  }
  for (const auto& [verdict, number] : verdicts) MESSAGE(number << " " << verdict);
  CHECK(verdicts["refuted"] > systems / 33);
}

// y and z are the same except for their signs: this was once found to be a contradiction.
TEST_CASE("y^2 = 1 + v^2 = z^2 says not that y = z") {
  const Planter planter(30);
  std::vector<Relation> assumptions;
  for (const char* text : {"y^2 = 1+v^2", "z^2 = 1+v^2", "x > 0"})
    assumptions.push_back(parse_relation(text, planter.symbols));
  const Relation statement = parse_relation("x*(y-z) = 1", planter.symbols);
  const Relation impossible = parse_relation("1 = 2", planter.symbols);
  CHECK_FALSE(contradict(assumptions, planter.symbols));
  CHECK_FALSE(are_found_the_same(statement, impossible, assumptions, planter.symbols));
}
