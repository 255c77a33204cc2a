#include <derivations/mechanics/linear_motion.hpp>
#include <stdexcept>

namespace rederive::mechanics {
using namespace language;

using GiNaC::ex;
using GiNaC::lst;
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

using Functions = GiNaC::exmap;  // a function of time → its symbol

bool is_function_of(const ex& e, const SymbolExpression& time) {
  return (GiNaC::is_the_function<GiNaC::sin_SERIAL>(e) || GiNaC::is_the_function<GiNaC::cos_SERIAL>(e)) &&
         e.has(time);
}

// sin and cos of the same phase come together, because each is the derivative of the other.
void collect_functions(const ex& e, const SymbolExpression& time, Functions& found) {
  if (!is_function_of(e, time)) {
    for (const ex& part : e) collect_functions(part, time, found);
    return;
  }
  const ex phase = e.op(0);
  if (phase.diff(time, 2) != 0)
    throw std::invalid_argument("particular_solution: a phase is not linear in time");
  for (const ex& f : {ex(sin(phase)), ex(cos(phase))})
    if (!found.count(f)) found[f] = symbol("f" + std::to_string(found.size()));
}

}  // namespace

ex particular_solution(const LinearEquation& equation) {
  Functions functions;
  collect_functions(equation.forcing, equation.time, functions);
  const symbol constant("C");
  ex ansatz = constant;
  lst unknowns{constant};
  for (const auto& [function, name] : functions) {
    const symbol coefficient("C" + std::to_string(unknowns.nops()));
    unknowns.append(coefficient);
    ansatz += coefficient * function;
  }
  const ex bare = equation.forcing.subs(functions, GiNaC::subs_options::no_pattern);
  if (bare.has(equation.time)) {
    const symbol coefficient("C" + std::to_string(unknowns.nops()));
    unknowns.append(coefficient);
    ansatz += coefficient * equation.time;
  }
  // Both sides are equal for all t: the coefficient of every function vanishes, and so does the rest.
  const ex residual = (ansatz.diff(equation.time, 2) - pow(equation.k, 2) * ansatz - equation.forcing)
                          .expand()
                          .subs(functions, GiNaC::subs_options::no_pattern)
                          .expand();
  const ex with_time = residual.coeff(equation.time, 1);
  bool closed = residual.degree(equation.time) <= 1 && !with_time.has(equation.time);
  for (const auto& [function, name] : functions) closed = closed && !with_time.has(name);
  if (!closed) throw std::invalid_argument("particular_solution: there is no ansatz for this forcing");
  lst conditions;
  if (!with_time.is_zero()) conditions.append(with_time == 0);
  ex rest = residual.coeff(equation.time, 0);
  for (const auto& [function, name] : functions) {
    conditions.append(residual.coeff(name, 1) == 0);
    rest = rest.subs(name == 0);
  }
  conditions.append(rest == 0);
  return ansatz.subs(GiNaC::lsolve(conditions, unknowns));
}

ex general_solution(const LinearEquation& equation, const ex& start, const ex& C, const ex& D) {
  const ex phase = equation.k * (equation.time - start);
  return C * sinh(phase) + D * cosh(phase) + particular_solution(equation);
}

Constants constants_from_start(const LinearEquation& equation, const ex& start, const ex& angle,
                               const ex& rate) {
  const symbol C("C"), D("D");
  const ex motion = general_solution(equation, start, C, D);
  const ex found = GiNaC::lsolve(lst{motion.subs(equation.time == start) == angle,
                                     motion.diff(equation.time).subs(equation.time == start) == rate},
                                 lst{C, D});
  return {ex(C).subs(found), ex(D).subs(found)};
}

ex solution_from(const LinearEquation& equation, const ex& start, const ex& angle, const ex& rate) {
  const Constants c = constants_from_start(equation, start, angle, rate);
  return general_solution(equation, start, c.C, c.D);
}

}  // namespace rederive::mechanics
