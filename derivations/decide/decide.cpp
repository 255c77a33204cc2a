#include <cln/exception.h>

#include <algorithm>
#include <derivations/decide/comparison.hpp>
#include <derivations/decide/decide.hpp>
#include <derivations/decide/points.hpp>

namespace rederive::decide {
using namespace numbers;
using namespace identity;
using namespace sign;

std::string to_string(Verdict verdict) {
  constexpr const char* words[] = {"proved",     "proved_under", "approximation", "refuted",
                                   "definition", "undecided",    "error"};
  return words[static_cast<int>(verdict)];
}

namespace {
constexpr Effort few{6, 1, 200}, many{310, 24, 1800};

Proof undecided(std::string reason) { return {.reason = std::move(reason)}; }

Proof refuted(const Witness& witness, const char* reason, By by) {
  return {.verdict = Verdict::refuted, .witness = witness, .reason = reason, .by = by};
}

Proof proved(const Comparison& setting, const Sameness& found) {
  const bool is_expression = setting.left.atoms.empty();
  Proof proof{.verdict = Verdict::proved, .side_conditions = setting.side_conditions, .by = found.by};
  proof.certificate = found.certificate;
  if (found.factor) proof.factor = setting.text_of(*found.factor);
  if (is_expression && found.by == By::identity) proof.factor = "1";
  proof.reason = found.by == By::sign  ? "each follows from the other by the signs of products"
                 : is_expression       ? "the numerator of the difference vanishes identically"
                 : proof.factor == "1" ? "the two are the same, identically"
                 : found.factor        ? "the two differ by a factor that is neither 0 nor infinite"
                                       : "the two hold at the same points";
  return proof;
}

/// Tries the problem; if that fails, splits by the sign of the first |u|, at most `depth` times.
std::optional<Sameness> same_in_cases(const Problem& problem, Comparison& setting, int depth) {
  const auto& generators = setting.ring.generators();
  const std::size_t known = generators.size();  // those that come later may have no value
  if (auto found = same(setting, problem)) return found;
  const auto end = generators.begin() + known;
  const auto bars = std::ranges::find(generators.begin(), end, "fabs", &Generator::function);
  if (bars == end || depth == 0) return std::nullopt;
  const Tree u = to_tree(setting.ring.meaning_of(bars->of), problem.symbols);
  Sameness both{By::identity};
  for (const char* op : {">=", "<="}) {
    Problem part = problem;
    part.assumptions.push_back({{u, zero()}, {op}});
    Comparison of_part(part.symbols);
    auto found = of_part.translator.with_basis([&]() -> std::optional<Sameness> {
      try {
        translate(of_part, part);
      } catch (const NoValue&) {  // no point belongs to this part
        return both;
      }
      return same_in_cases(part, of_part, depth - 1);
    });
    if (!found) return std::nullopt;
    for (std::string& line : found->certificate)
      line += (line.find("where") == line.npos ? " where " : " and ") + setting.text_of(bars->of) + " " + op +
              " 0";
    both.rest_on(*found);
  }
  return both;
}

/// Returns whether signs prove that no point meets all assumptions and gives both statements a value.
bool is_contradictory(const Problem& problem) try {
  Comparison setting(problem.symbols);
  return setting.translator.with_basis([&] {
    translate(setting, problem);
    for (const Generator& g : setting.ring.generators())
      if (g.range.is_empty()) return true;
    for (const Fact& f : setting.ring.facts)
      if ((setting.ring.signs_of(f.value) & f.signs).is_none()) return true;
    return prove_signs(setting.ring, 0, Signs::zero() & Signs::positive()).has_value();
  });
} catch (const NoValue&) {
  return true;
} catch (const Undecidable&) {
  return false;
}

/// Tries points, then identity and signs, then more points. Without `by_points` it refutes nothing.
Proof decide_problem(const Problem& problem, bool by_points) {
  const bool is_of_numbers =
      !problem.left.operators.empty() && names_of(problem.left).empty() && names_of(problem.right).empty();
  Search tried = search(problem, is_of_numbers ? many : few);
  if (is_of_numbers && tried.agreed > 0)
    return {.verdict = Verdict::proved, .reason = "both are decided in ball arithmetic", .by = By::sign};
  std::optional<Proof> proof;
  std::string missing =
      "the sides agree wherever they were compared, but neither the difference vanishes identically nor a "
      "certificate of signs was found";
  if (!tried.witness) try {
      Comparison setting(problem.symbols);
      const auto found = setting.translator.with_basis([&] {
        translate(setting, problem);
        return same_in_cases(problem, setting, 3);
      });
      if (found)
        proof = hides_a_solution(setting)
                    ? undecided("a divisor of one side vanishes where the other side holds")
                    : proved(setting, *found);
    } catch (const Undecidable& error) {
      missing = error.what();
      if (problem.left.operators == problem.right.operators &&
          std::ranges::equal(problem.left.sides, problem.right.sides, is_same))  // with values together
        proof = {
            .verdict = Verdict::proved, .factor = "1", .reason = "they are the same", .by = By::identity};
    }
  if (!tried.witness && (proof ? tried.agreed == 0 : by_points)) tried = search(problem, many);
  if (tried.witness && !by_points) return undecided("it does not hold everywhere");
  if (tried.witness) return refuted(*tried.witness, "the two sides differ at the witness", By::points);
  if (tried.agreed == 0 && tried.lacking && by_points && is_contradictory(problem))
    return refuted(*tried.lacking, "one side never has a value where the other one has, as at the witness",
                   By::sign);
  if (tried.agreed == 0) return undecided("no point was found at which both sides have a value");
  return proof.value_or(undecided(missing));
}

}  // namespace

Proof decide(const Relation& left, const Relation& right, const Symbols& symbols,
             const std::vector<Given>& given, const std::vector<Relation>& assumptions) {
  if (left.operators.empty() != right.operators.empty())
    return undecided("an expression cannot be compared with a relation");
  const auto is_equation = [](const Relation& a) { return std::ranges::count(a.operators, "=") > 0; };
  try {
    const Problem problem = with_values({left, right, assumptions, symbols}, given);
    std::vector<Relation> others = assumptions;
    const bool has_equations = std::erase_if(others, is_equation) > 0;
    if (has_equations) {  // it may hold without them
      const Proof proof = decide_problem(with_values({left, right, others, symbols}, given), false);
      if (proof.verdict == Verdict::proved && search(problem, few).agreed > 0) return proof;
    }
    Proof proof = decide_problem(problem, true);
    if (has_equations && proof.verdict == Verdict::proved) proof.verdict = Verdict::proved_under;
    return proof;
  } catch (const std::exception& error) {  // of GiNaC, which meets poles while it builds
    return undecided(in_plain_words(error));
  }
}

std::string in_plain_words(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) throw;
  if (dynamic_cast<const Undecidable*>(&error) != nullptr ||
      dynamic_cast<const SyntaxError*>(&error) != nullptr)
    return error.what();
  if (dynamic_cast<const std::domain_error*>(&error) != nullptr)  // GiNaC's pole_error among them
    return "an intermediate expression has no value: it divides by 0, or is a pole of a function";
  if (dynamic_cast<const cln::runtime_exception*>(&error) != nullptr ||
      dynamic_cast<const std::overflow_error*>(&error) != nullptr)
    return "numbers or exponents become too large during the decision";
  return "it turns into an expression that the procedure does not decide";
}

bool contradict(const std::vector<Relation>& assumptions, const Symbols& symbols) {
  return is_contradictory(with_values({{{zero()}, {}}, {{zero()}, {}}, assumptions, symbols}, {}));
}

}  // namespace rederive::decide
