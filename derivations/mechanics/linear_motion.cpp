#include <algorithm>
#include <derivations/mechanics/linear_motion.hpp>
#include <stdexcept>

namespace rederive::mechanics {
using namespace language;

using GiNaC::ex;
using GiNaC::is_a;
using GiNaC::symbol;

ex taylor(const ex& f, const std::vector<SymbolExpression>& small, int order) {
  const symbol epsilon("epsilon");
  GiNaC::exmap scaled;
  for (const SymbolExpression& s : small) scaled[s] = epsilon * s;
  ex derivative = f.subs(scaled, GiNaC::subs_options::no_pattern), sum = 0;
  for (int n = 0; n <= order; ++n) {
    sum += derivative.subs(epsilon == 0) / GiNaC::factorial(n);
    derivative = derivative.diff(epsilon);
  }
  return sum.expand();
}

namespace {

/// The functions e^{a t} (S(t) sin φ + C(t) cos φ) with polynomials S and C; so are their derivatives.
struct Family {
  ex exponent = 0, phase = 0;  ///< linear in time
  ex sines = 0, cosines = 0;   ///< S and C
  ex value() const { return exp(exponent) * (sines * sin(phase) + cosines * cos(phase)); }
};

Family derivative(const Family& f, const SymbolExpression& t) {
  const ex a = f.exponent.diff(t), b = f.phase.diff(t);
  return {f.exponent, f.phase, f.sines.diff(t) + a * f.sines - b * f.cosines,
          f.cosines.diff(t) + a * f.cosines + b * f.sines};
}

/// Returns one term of a forcing as a family. Throws std::invalid_argument for another term.
Family family_of(const ex& term, const SymbolExpression& t) {
  Family family;
  ex factor = 1;
  bool is_known = true, is_sine = false;
  for (const ex& part : is_a<GiNaC::mul>(term) ? term : ex(GiNaC::lst{term})) {
    const bool is_power = is_a<GiNaC::power>(part);
    const ex base = is_power ? part.op(0) : part, power = is_power ? part.op(1) : 1;
    const bool is_circular =
        GiNaC::is_the_function<GiNaC::sin_SERIAL>(part) || GiNaC::is_the_function<GiNaC::cos_SERIAL>(part);
    if (!part.has(t) || (base.is_equal(t) && power.info(GiNaC::info_flags::posint))) {
      factor *= part;
    } else if (GiNaC::is_the_function<GiNaC::exp_SERIAL>(base)) {
      family.exponent += power * base.op(0);
    } else if (is_circular && family.phase.is_zero()) {
      family.phase = part.op(0);
      is_sine = GiNaC::is_the_function<GiNaC::sin_SERIAL>(part);
    } else {
      is_known = false;
    }
  }
  if (!is_known || !vanishes(family.exponent.diff(t, 2)) || !vanishes(family.phase.diff(t, 2)))
    throw std::invalid_argument("particular_solution: there is no ansatz for the term " + text_of(term) +
                                " of the forcing");
  (is_sine ? family.sines : family.cosines) = factor;
  return family;
}

std::vector<Family> families_of(const ex& forcing, const SymbolExpression& t) {
  const ex any = GiNaC::wild();
  const ex sum =
      forcing
          .subs(GiNaC::lst{sinh(any) == (exp(any) - exp(-any)) / 2, cosh(any) == (exp(any) + exp(-any)) / 2})
          .expand();
  std::vector<Family> families;
  for (const ex& term : is_a<GiNaC::add>(sum) ? sum : ex(GiNaC::lst{sum})) {
    const Family family = family_of(term, t);
    const auto same = std::ranges::find_if(families, [&](const Family& other) {
      return vanishes((other.exponent - family.exponent).diff(t)) && vanishes(other.phase - family.phase);
    });
    if (same == families.end()) {
      families.push_back(family);
      continue;
    }
    const ex factor = exp(family.exponent - same->exponent);
    same->sines += factor * family.sines;
    same->cosines += factor * family.cosines;
  }
  return families;
}

/// Adds the solution for one family to `result`; its coefficients are unknowns with numbers from `first` on.
void add_solution(const LinearEquation& equation, const Family& forcing, Motion& result) {
  const SymbolExpression& t = equation.time;
  const ex a = forcing.exponent.diff(t), b = forcing.phase.diff(t);
  const ex& m = equation.mass;
  // The characteristic polynomial and its derivative at a + i b. It has real coefficients.
  const ex real = m * (a * a - b * b) + equation.damping * a + equation.stiffness;
  const ex slope = 2 * m * a + equation.damping, imaginary = b * slope;
  Relations known = equation.known;
  if (sign(real, known).value_or(0) != 0 || sign(imaginary, known).value_or(0) != 0)
    known.push_back(pow(real, 2) + pow(imaginary, 2));
  const bool is_root = vanishes(real, known) && vanishes(imaginary, known);
  const int resonance = !is_root ? 0 : vanishes(slope, known) && vanishes(b, known) ? 2 : 1;
  const int degree = std::max(forcing.sines.expand().degree(t), forcing.cosines.expand().degree(t));
  std::vector<SymbolExpression> unknowns;
  Family ansatz{forcing.exponent, forcing.phase};
  const auto add_term = [&](ex& sum, int power) {
    unknowns.emplace_back(GiNaC::realsymbol("a_" + std::to_string(unknowns.size() + 1)));
    sum += unknowns.back() * pow(t, power);
  };
  for (int power = resonance; power <= degree + resonance; ++power) {
    if (!forcing.phase.is_zero()) add_term(ansatz.sines, power);
    add_term(ansatz.cosines, power);
  }
  const Family rate = derivative(ansatz, t), second_rate = derivative(rate, t);
  std::vector<ex> equations;
  for (ex Family::*part : {&Family::sines, &Family::cosines}) {
    const ex difference = (m * second_rate.*part + equation.damping * rate.*part +
                           equation.stiffness * ansatz.*part - forcing.*part)
                              .expand();
    for (int power = 0; power <= difference.degree(t); ++power)
      equations.push_back(difference.coeff(t, power));
  }
  const Solution solved = solve(equations, unknowns, known);
  result.steps.push_back({"Try", equation.quantity, ansatz.value()});
  for (const Given& given : solved.values)
    result.steps.push_back({"Equal coefficients on both sides give", given.name, given.value});
  add_conditions(result.conditions, solved.conditions);
  result.value += solved.in(ansatz.value());
}

/// Returns 4 m² times the square of half the difference of the roots.
ex discriminant(const LinearEquation& equation) {
  return simplified(pow(equation.damping, 2) - 4 * equation.mass * equation.stiffness);
}

/// Returns the equation with what the choice of the caller says, if it decides, among what is known.
LinearEquation with_choice(LinearEquation equation) {
  const ex chosen = discriminant(equation);
  if (!equation.roots || sign(chosen, equation.known)) return equation;
  if (*equation.roots == Roots::equal)
    equation.stiffness = pow(equation.damping, 2) / (4 * equation.mass);
  else
    equation.known.push_back(*equation.roots == Roots::real ? chosen : -chosen);
  return equation;
}

}  // namespace

Roots roots_of(const LinearEquation& equation) {
  const auto found = sign(discriminant(equation), equation.known);
  const std::string text = "the discriminant " + text_of(discriminant(equation));
  if (!found && !equation.roots)
    throw std::invalid_argument("roots_of: the sign of " + text +
                                " is not known; declare a relation or choose the roots");
  if (!found) return *equation.roots;
  const Roots roots = *found < 0 ? Roots::complex : *found == 0 ? Roots::equal : Roots::real;
  if (equation.roots && *equation.roots != roots)
    throw std::invalid_argument("roots_of: " + text + " does not have the sign of the chosen roots");
  return roots;
}

Motion particular_solution(const LinearEquation& equation) {
  Motion result;
  for (const Family& family : families_of(equation.forcing, equation.time))
    add_solution(equation, family, result);
  result.steps.push_back({"So one solution is", equation.quantity, result.value});
  return result;
}

Motion general_solution(const LinearEquation& given, const ex& start, const ex& C, const ex& D) {
  const LinearEquation equation = with_choice(given);
  const ex &m = equation.mass, &c = equation.damping, &k = equation.stiffness, tau = equation.time - start;
  const Relations& known = equation.known;
  Motion result{.value = 0, .steps = {}, .conditions = {}, .constants = {C, D}};
  if (vanishes(m, known)) {
    if (vanishes(c, known)) throw std::invalid_argument("general_solution: the equation has no derivative");
    result.value = C * exp(-k / c * tau);
    result.conditions = not_zero(c, known);
  } else {
    const Roots roots = roots_of(equation);
    const char* relation = roots == Roots::complex ? "<" : roots == Roots::equal ? "=" : ">";
    const ex square = pow(c / (2 * m), 2) - k / m, decay = exp(-c / (2 * m) * tau);
    ex sine = tau, cosine = 1;
    if (roots == Roots::complex) {
      const ex phase = root_of(-square, known) * tau;
      sine = sin(phase);
      cosine = cos(phase);
    } else if (roots == Roots::real) {
      const ex phase = root_of(square, known) * tau;
      sine = sinh(phase);
      cosine = cosh(phase);
    }
    result.value = C * decay * sine + D * decay * cosine;
    result.conditions = not_zero(m, known);
    const ex its_discriminant = discriminant(given);
    if (!sign(its_discriminant, given.known))
      result.conditions.push_back({"provided that", its_discriminant, 0, relation});
    result.steps.push_back(
        {"The characteristic polynomial m λ² + c λ + k has the discriminant", its_discriminant, 0, relation});
  }
  result.steps.push_back(
      {"so that without its right side the equation is solved by", equation.quantity, result.value});
  const Motion particular = particular_solution(equation);
  result.value += particular.value;
  if (particular.value.is_zero()) return result;
  result.steps.insert(result.steps.end(), particular.steps.begin(), particular.steps.end());
  add_conditions(result.conditions, particular.conditions);
  result.steps.push_back({"The general solution is the sum", equation.quantity, result.value});
  return result;
}

std::vector<Condition> from_start(const ex& start, const ex& position, const ex& rate) {
  return {{start, position}, {start, rate, 1}};
}

Motion solution(const LinearEquation& equation, const std::vector<Condition>& conditions) {
  std::vector<SymbolExpression> constants{SymbolExpression(GiNaC::realsymbol("C"))};
  if (!vanishes(equation.mass, equation.known)) constants.emplace_back(GiNaC::realsymbol("D"));
  if (conditions.size() != constants.size())
    throw std::invalid_argument("solution: an equation of order " + std::to_string(constants.size()) +
                                " needs as many conditions, not " + std::to_string(conditions.size()));
  Motion motion = general_solution(equation, conditions[0].time, constants.front(), constants.back());
  std::vector<ex> equations;
  for (const Condition& condition : conditions) {
    const ex there =
        motion.value.diff(equation.time, condition.derivative).subs(equation.time == condition.time);
    equations.push_back(there == condition.value);
    motion.steps.push_back({condition.derivative == 0 ? "It has the value" : "Its derivative has the value",
                            condition.value, there});
  }
  const Solution solved = solve(equations, constants, with_choice(equation).known);
  motion.steps.insert(motion.steps.end(), solved.steps.begin(), solved.steps.end());
  add_conditions(motion.conditions, solved.conditions);
  motion.value = solved.in(motion.value);
  motion.constants = {solved.in(motion.constants.C), solved.in(motion.constants.D)};
  motion.steps.push_back({"Hence", equation.quantity, motion.value});
  return motion;
}

}  // namespace rederive::mechanics
