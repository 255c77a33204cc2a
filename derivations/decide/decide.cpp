#include <cln/exception.h>

#include <algorithm>
#include <derivations/decide/compare.hpp>
#include <derivations/decide/decide.hpp>
#include <derivations/decide/domain.hpp>
#include <derivations/decide/points.hpp>
#include <derivations/language/print.hpp>

namespace rederive {

std::string to_string(Verdict verdict) {
  constexpr const char* words[] = {"proved",  "proved_under", "approximation",
                                   "refuted", "definition",   "undecided"};
  return words[static_cast<int>(verdict)];
}

namespace {

constexpr Effort few{6, 200, false}, some{4, 200, true}, many{220, 1800, true};

Proof undecided(std::string reason) {
  Proof proof;
  proof.reason = std::move(reason);
  return proof;
}

Proof refuted(const Witness& witness) {
  Proof proof;
  proof.verdict = Verdict::refuted, proof.witness = witness;
  proof.reason = "the two sides differ at the witness", proof.by = "points";
  return proof;
}

std::string text_of(const Polynomial& p, const Ring& ring, const Symbols& symbols) {
  return print(ring.meaning_of(Fraction(p)), Notation::plain, symbols);
}

Grounds grounds_of(const Comparison& setting, const Certificate& certificate, const Symbols& symbols) {
  Grounds grounds;
  for (const Generator& g : setting.ring.generators())
    if (g.kind != Generator::Kind::symbol && g.kind != Generator::Kind::pi)
      grounds.phases.push_back(print(g.meaning, Notation::plain, symbols));
  for (const Translated* side : {&setting.left, &setting.right})
    for (std::string& divisor : in_words(side->conditions, setting.ring, symbols))
      grounds.divisors.push_back(std::move(divisor));
  for (const Certificate::Part& part : certificate.parts) {
    std::string text = print(GiNaC::ex(GiNaC::numeric(part.coefficient)), Notation::plain, symbols);
    for (const Polynomial& f : part.factors) text += " * (" + text_of(f, setting.ring, symbols) + ")";
    grounds.certificate.push_back(std::move(text));
  }
  return grounds;
}

Proof proved(const Comparison& setting, const Sameness& found, const Symbols& symbols) {
  Proof proof;
  proof.verdict = Verdict::proved, proof.by = found.by;
  const bool is_expression = setting.left.expression.has_value();
  if (found.has_factor) proof.factor = print(setting.ring.meaning_of(found.factor), Notation::plain, symbols);
  if (is_expression && found.by == "identity") proof.factor = "1";
  proof.side_conditions = setting.in_words;
  proof.grounds = grounds_of(setting, found.certificate, symbols);
  proof.reason = found.by == "sign"    ? "each follows from the other one by the signs of products"
                 : is_expression       ? "the numerator of the difference vanishes identically"
                 : proof.factor == "1" ? "the two are the same, identically"
                 : found.has_factor    ? "the two differ by a factor that is neither 0 nor infinite"
                                       : "the two hold at the same points";
  return proof;
}

/// The innermost u of a part fabs(u) that has symbols.
Tree between_bars(const Tree& tree) {
  for (const Tree& child : tree->children)
    if (Tree found = between_bars(child)) return found;
  return tree->kind == Node::Kind::call && tree->text == "fabs" && !names_of(tree).empty() ? tree->children[0]
                                                                                           : nullptr;
}

Tree between_bars(const Problem& problem) {
  for (const Relation* relation : {&problem.left, &problem.right})
    for (const Tree& side : relation->sides)
      if (Tree found = between_bars(side)) return found;
  return nullptr;
}

/// The problem where u has a sign, without the bars around it.
Problem without_bars(Problem problem, const Tree& u, bool is_negative) {
  const Tree size = is_negative ? make_tree(Node::Kind::negative, "", {u}) : u;
  const Tree bars = make_tree(Node::Kind::call, "fabs", {u});
  for (Relation* relation : {&problem.left, &problem.right})
    for (Tree& side : relation->sides) side = put_in(side, bars, size);
  problem.assumptions.push_back({{u, zero()}, {is_negative ? "<=" : ">="}});
  return problem;
}

std::optional<Sameness> same_in_cases(const Problem& problem, Comparison& setting, int depth) {
  if (auto found = same(setting)) return found;
  const Tree u = depth > 0 ? between_bars(problem) : nullptr;
  if (!u) return std::nullopt;
  Sameness both{"identity"};
  for (const bool is_negative : {false, true}) {
    const Problem part = without_bars(problem, u, is_negative);
    Comparison of_part(part.symbols);
    try {
      of_part.is_thorough = setting.is_thorough;
      translate(of_part, part);
      const auto found = same_in_cases(part, of_part, depth - 1);
      if (!found) return std::nullopt;
      if (found->by == "sign") both.by = "sign";
    } catch (const NoValue&) {  // no point belongs to this part
    }
  }
  return both;
}

/// Proved if points agree; refuted by the first that does not.
Proof confirmed(const Problem& problem, const Comparison& setting, const Sameness& found) {
  Search tried = search(problem, few);
  if (tried.agreed == 0 && !tried.witness) tried = search(problem, many);
  if (tried.witness) return refuted(*tried.witness);
  if (tried.agreed == 0) return undecided("no point was found at which both sides have a value");
  if (!setting.left.expression && hides_a_solution(setting))
    return undecided("a divisor of one side vanishes where the other side holds");
  return proved(setting, found, problem.symbols);
}

/// Identity, then points, then signs, then more points. `by_points`: whether points are asked at all.
Proof decide_problem(const Problem& problem, bool by_points) {
  Proof open = undecided(
      "the sides agree wherever they were compared, but neither the difference vanishes identically nor a "
      "certificate of "
      "signs was found");
  try {
    Comparison setting(problem.symbols);
    translate(setting, problem);
    if (const auto found = same(setting)) return confirmed(problem, setting, *found);
    if (by_points)
      if (const Search tried = search(problem, some); tried.witness) return refuted(*tried.witness);
    setting.is_thorough = true;
    translate_statements(setting, problem);
    if (const auto found = same_in_cases(problem, setting, 3)) return confirmed(problem, setting, *found);
  } catch (const Undecidable& error) {
    open = undecided(error.what());
  }
  if (!by_points) return open;
  const Search tried = search(problem, many);
  if (tried.witness) return refuted(*tried.witness);
  return tried.agreed > 0 ? open : undecided("no point was found at which both sides have a value");
}

}  // namespace

Proof decide(const Relation& left, const Relation& right, const Symbols& symbols,
             const std::vector<Given>& given, const std::vector<Relation>& assumptions) {
  if (left.operators.empty() != right.operators.empty())
    return undecided("an expression cannot be compared with a relation");
  const auto is_equation = [](const Relation& a) {
    return std::find(a.operators.begin(), a.operators.end(), "=") != a.operators.end();
  };
  try {
    const Problem problem = with_values({left, right, assumptions, symbols}, given);
    if (std::none_of(assumptions.begin(), assumptions.end(), is_equation))
      return decide_problem(problem, true);
    std::vector<Relation> others;  // it may hold without the equations
    std::remove_copy_if(assumptions.begin(), assumptions.end(), std::back_inserter(others), is_equation);
    Proof proof = decide_problem(with_values({left, right, others, symbols}, given), false);
    if (proof.verdict == Verdict::proved && search(problem, few).agreed > 0) return proof;
    proof = decide_problem(problem, true);
    if (proof.verdict == Verdict::proved) proof.verdict = Verdict::proved_under;
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
    return "on the way to a decision something has no value: a division by 0, or a pole of a function";
  if (dynamic_cast<const cln::runtime_exception*>(&error) != nullptr ||
      dynamic_cast<const std::overflow_error*>(&error) != nullptr)
    return "numbers or exponents grow too large on the way to a decision";
  return "on the way to a decision it turns into something that is not in the class";
}

bool contradict(const std::vector<Relation>& assumptions, const Symbols& symbols) {
  const Tree one = make_tree(Node::Kind::number, "1");
  try {
    const Problem problem = with_values({{{one}, {}}, {{one}, {}}, assumptions, symbols}, {});
    Comparison setting(problem.symbols);
    translate(setting, problem);
    for (const Generator& g : setting.ring.generators())
      if (g.range.is_empty()) return true;
    for (const Fact& f : setting.facts)
      if ((setting.ring.signs_of(f.value) & f.signs).is_none()) return true;
    return prove_signs(setting.ring, setting.facts, 0, Signs::zero() & Signs::positive()).has_value();
  } catch (const NoValue&) {
    return true;
  } catch (const Undecidable&) {
    return false;
  }
}

}  // namespace rederive
