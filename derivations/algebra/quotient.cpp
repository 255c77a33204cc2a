#include <derivations/algebra/quotient.hpp>

namespace rederive {

using GiNaC::ex;

namespace {

bool is_real(const ex& e) {
  for (auto i = e.preorder_begin(); i != e.preorder_end(); ++i)
    if (GiNaC::is_a<GiNaC::numeric>(*i) && !GiNaC::ex_to<GiNaC::numeric>(*i).is_real()) return false;
  return true;
}

/// Cancels what is common over the complex numbers, where a factor i of all terms of one side is a unit.
ex cancelled_with_complex_numbers(const ex& quotient, const Phases& phases) {
  ex complex = quotient;
  for (const Generator& g : phases.generators())
    if (g.kind == Generator::Kind::imaginary) complex = complex.subs(g.symbol == GiNaC::I);
  const ex cancelled = complex.normal();
  return is_real(cancelled) ? cancelled : quotient.normal();
}

/// (P + iQ)/D with a real D, P/D and Q/D each in lowest terms: where i stands below, gcds over the rationals
/// miss what is common, and what they miss depends on the order of the terms.
ex with_real_denominator(const ex& quotient, const Phases& phases) {
  const ex& i = phases.generators().front().symbol;
  const ex parts = quotient.numer_denom();
  ex above = parts.op(0), below = parts.op(1);
  if (below.has(i)) {
    const ex turned = below.subs(i == -i);
    ex scale_above = 1, scale_below = 1;
    above = phases.reduce(above * turned, &scale_above);
    below = phases.reduce(below * turned, &scale_below);
    above *= scale_below, below *= scale_above;
  }
  above = above.expand();
  return (above.coeff(i, 0) / below).normal() + i * (above.coeff(i, 1) / below).normal();
}

/// N/D = NN'/(DN'), where N' has the roots of N turned round: then more may cancel.
ex without_roots_above(const ex& quotient, const Phases& phases) {
  ex above = quotient.numer(), below = quotient.denom();
  for (const Generator& g : phases.generators()) {
    if (g.kind != Generator::Kind::root || g.degree != 2 || !above.has(g.symbol)) continue;
    const ex turned = above.subs(g.symbol == -g.symbol);
    ex scale_above = 1, scale_below = 1;
    above = phases.reduce(above * turned, &scale_above);
    below = phases.reduce(below * turned, &scale_below);
    above *= scale_below, below *= scale_above;
  }
  return above / below;
}

}  // namespace

std::optional<std::vector<Part>> quotient(const ex& left, const ex& right, const Symbols& symbols, Way way) {
  if (right.is_zero()) return std::nullopt;
  const Phases phases({left, right}, symbols);
  const auto whole = [&](const ex& e) {
    const ex parts = phases(e).normal().numer_denom();
    ex scale = 1;
    const ex numerator = phases.reduce(parts.op(0), &scale);
    return numerator / (scale * parts.op(1));
  };
  const ex below = whole(right);
  if (below.is_zero()) return std::nullopt;
  const ex ratio = whole(left) / below;
  if (way == Way::real_denominator) return factor_form(with_real_denominator(ratio, phases), phases);
  const ex cancelled = cancelled_with_complex_numbers(ratio, phases);
  if (way == Way::complex_numbers) return factor_form(cancelled, phases);
  return factor_form(cancelled_with_complex_numbers(without_roots_above(cancelled, phases), phases), phases);
}

}  // namespace rederive
