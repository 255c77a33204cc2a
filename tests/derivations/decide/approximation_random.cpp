// Random expressions, and the same with something small added to them: what `ledger prove --small x` says of
// the two, or of two equations that say that z is one of them, is compared with their values, to 1000 bits,
// where x is as small as 10^-24 and all side conditions hold. REDERIVE_SEED and REDERIVE_PAIRS choose
// another run.
#include <doctest/doctest.h>

#include <derivations/language/syntax.hpp>
#include <derivations/numbers/evaluate.hpp>
#include <derivations/paper/prove_bounded.hpp>
#include <derivations/program/program.hpp>
#include <tests/block.hpp>
#include <tests/cases.hpp>
#include <tests/random.hpp>

using namespace rederive::language;
using namespace rederive::numbers;
using namespace rederive::decide;
using namespace rederive::program;
using namespace rederive::paper;
using namespace rederive::rocking_block;
using namespace rederive::test;

namespace {

class Generator : public Choices {
 public:
  using Choices::Choices;
  using Choices::pick;
  std::string pick(const char* section) { return pick(words_.at(section)); }

  std::string expression(int depth) {
    if (depth == 0) return pick("atoms");
    const std::size_t kind = below(25);
    const std::string one = expression(depth - 1);
    if (kind < 7) return "(" + one + "+" + expression(depth - 1) + ")";
    if (kind < 9) return "(" + one + "-" + expression(depth - 1) + ")";
    if (kind < 14) return one + "*" + expression(depth - 1);
    if (kind < 18) return one + "/(" + expression(depth - 1) + ")";
    if (kind < 20) return "(" + one + ")^" + pick("exponents");
    if (kind < 21) return "(" + one + ")^(" + expression(depth - 1) + ")";
    return pick("functions") + "(" + one + ")";
  }

  /// The same with something of a higher order than `order`, or just not.
  std::string changed(const std::string& text, int order) {
    const std::string little = "x^" + std::to_string(below(5) > 0 ? order + 1 : std::max(order, 1));
    std::vector<std::size_t> places;
    for (std::size_t k = text.find('x'); k != std::string::npos; k = text.find('x', k + 1))
      if (text.compare(k, 2, "xp") != 0) places.push_back(k);
    const std::size_t kind = below(4);
    if (kind == 0 && !places.empty())
      return std::string(text).replace(pick(places), 1, pick(Cells{"0", "sin(x)", "(x+" + little + "*a)"}));
    if (kind == 1) return "(" + text + ")*(1+" + little + ")";
    return text + "+" + little + (kind == 2 ? "*" + expression(2) : "");
  }

  /// Of a and y, with those among them where something may vanish.
  cln::cl_RA value() {
    static const std::vector<cln::cl_RA> special{0, 1, -1, 2, -2, 3, cln::cl_RA(1) / 2, -cln::cl_RA(1) / 2};
    return below(10) < 7 ? pick(special) : (cln::cl_RA(static_cast<long>(below(601))) - 300) / 77;
  }

 private:
  std::map<std::string, Cells> words_ = named_cases("words");
};

constexpr long bits = 1000;

/// |a - b| at the point, where it has a value, to a bound far below what is looked at.
std::optional<cln::cl_RA> distance(const Tree& a, const Tree& b, const Point& point) {
  const Value left = value_at(a, point, bits), right = value_at(b, point, bits);
  if (left.is != Value::Is::certain || right.is != Value::Is::certain) return std::nullopt;
  const Ball distance = left.ball() - right.ball();
  if (!distance.is_moderate()) return std::nullopt;
  return cln::abs(cln::cl_RA(distance));
}

/// Whether all that was said holds at the point, clearly.
bool hold(const nlohmann::ordered_json& conditions, const Point& point, const Symbols& symbols) {
  const cln::cl_RA clear = 1 / cln::cl_RA(cln::expt_pos(cln::cl_I(10), 60));
  return std::all_of(conditions.begin(), conditions.end(), [&](const std::string& text) {
    const auto unequal = text.find("!=");
    Relation relation;
    if (unequal == std::string::npos)
      relation = parse_relation(text, symbols);
    else
      relation = {{parse(text.substr(0, unequal), symbols), parse(text.substr(unequal + 2), symbols)},
                  {"!="}};
    for (std::size_t k = 0; k < relation.operators.size(); ++k) {
      const auto size = distance(relation.sides[k], relation.sides[k + 1], point);
      if (!size || *size < clear) return false;
      const Sign sign = sign_at(relation.sides[k], relation.sides[k + 1], point);
      if (relation.operators[k] != "!=" &&
          sign != (relation.operators[k][0] == '<' ? Sign::negative : Sign::positive))
        return false;
    }
    return true;
  });
}

/// Whether the difference is of a higher order, at ±10^-12, 10^-18, 10^-24; nothing where it cannot be seen.
std::optional<bool> is_of_higher_order(const Tree& left, const Tree& right, int order, int sign,
                                       Point point) {
  std::vector<cln::cl_RA> ratios;
  for (const int power : {12, 18, 24}) {
    const cln::cl_RA size = 1 / cln::cl_RA(cln::expt_pos(cln::cl_I(10), power));
    point.insert_or_assign("x", sign * size);
    const auto difference = distance(left, right, point);
    if (!difference) return std::nullopt;
    ratios.push_back(*difference / cln::expt(size, order));
  }
  const cln::cl_RA& last = ratios.back();
  if (last <= ratios[1] / 2 || last < 1 / cln::cl_RA(cln::expt_pos(cln::cl_I(10), 100)))
    return last < cln::cl_RA(1) / 1000 ? std::optional(true) : std::nullopt;
  return last > cln::cl_RA(1) / 30 ? std::optional(false) : std::nullopt;
}

/// How often the difference was seen to be of a higher order, and how often not, where the conditions hold.
struct Seen {
  int higher = 0, not_higher = 0;
};

Seen look(const Tree& left, const Tree& right, int order, const nlohmann::ordered_json& proof,
          const std::vector<int>& signs, const Symbols& symbols, Generator& generator) {
  Seen seen;
  for (int k = 0; k < 14; ++k) {
    Point point{{"a", generator.value()}, {"y", generator.value()}};
    for (const int sign : signs) {
      point.insert_or_assign("x", sign / cln::cl_RA(cln::expt_pos(cln::cl_I(10), 12)));
      if (!hold(proof["side_conditions"], point, symbols)) continue;
      const auto higher = is_of_higher_order(left, right, order, sign, point);
      if (higher) ++(*higher ? seen.higher : seen.not_higher);
    }
  }
  return seen;
}

}  // namespace

TEST_CASE("random approximations hold where x is small, and what is refuted does not") {
  const auto seed = static_cast<unsigned>(from_environment("REDERIVE_SEED", 20261124));
  const long pairs = from_environment("REDERIVE_PAIRS", 1'000);
  Generator generator(seed);
  std::map<std::string, long> verdicts;
  long held_against = 0;
  for (long done = 0; done < pairs;) {
    const int order = static_cast<int>(generator.below(3));
    ProveRequest request;
    const std::string one = generator.expression(2 + static_cast<int>(generator.below(2)));
    const std::string other = generator.changed(one, order);
    request.left = one, request.right = other;
    request.small = {"x"};
    request.order = order;
    if (generator.below(2) == 0) request.assumptions = {"x > 0"};
    if (!request.assumptions.empty() && generator.below(3) == 0) {  // z as one and as the other
      const std::string factor = generator.pick("factors");
      request.left = factor + "*z = " + factor + "*(" + one + ")", request.right = "z = " + other;
    }
    try {
      const Symbols symbols = declared_symbols(request);
      const Tree left = parse(one, symbols), right = parse(other, symbols);
      const auto proof = decide_bounded(request);
      ++done;
      const std::string verdict = proof["verdict"];
      ++verdicts[verdict];
      if (verdict == "undecided") continue;
      const std::vector<int> signs = request.assumptions.empty() ? std::vector{1, -1} : std::vector{1};
      const Seen seen = look(left, right, order, proof, signs, symbols, generator);
      held_against += seen.higher + seen.not_higher > 0 ? 1 : 0;
      INFO("seed " << seed << ", pair " << done << "\n"
                   << request.left << "\n"
                   << request.right << "\norder " << order << " " << proof.dump());
      if (verdict == "refuted")
        CHECK((seen.not_higher > 0 || seen.higher < 5));
      else
        CHECK(seen.not_higher == 0);
    } catch (const BadInput&) {  // a divisor that is 0, a logarithm of it: no statement at all
    }
  }
  for (const auto& [verdict, number] : verdicts) std::cout << number << " " << verdict << ", ";
  std::cout << held_against << " held against values\n";
  CHECK(held_against > pairs / 3);
}
