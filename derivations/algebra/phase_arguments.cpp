// Arguments of sin, cos, exp … as rational combinations of phases.
#include <algorithm>
#include <derivations/algebra/phases.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>

namespace rederive {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

const GiNaC::symbol& pi_symbol() {
  static const GiNaC::symbol pi("pi");
  return pi;
}

namespace {

/// Number and monomial of a term of an expanded polynomial.
std::pair<numeric, ex> split(const ex& term) {
  if (is_a<numeric>(term)) return {ex_to<numeric>(term), 1};
  if (!is_a<GiNaC::mul>(term)) return {1, term};
  numeric number = 1;
  ex monomial = 1;
  for (const ex& factor : term) {
    if (is_a<numeric>(factor))
      number *= ex_to<numeric>(factor);
    else
      monomial *= factor;
  }
  return {number, monomial};
}

std::vector<ex> terms(const ex& polynomial) {
  const ex expanded = polynomial.expand();
  if (!is_a<GiNaC::add>(expanded)) return {expanded};
  return {expanded.begin(), expanded.end()};
}

}  // namespace

/// The one that all arguments share; numbers stay with the coefficients.
void Phases::find_denominator() {
  for (const auto& [argument, circular] : arguments_) {
    const ex denominator = rational(argument).denom();
    denominator_ = GiNaC::lcm(denominator_, (denominator / denominator.integer_content()).expand()).expand();
  }
  if (is_a<GiNaC::add>(denominator_)) make_bases();
}

/// An argument as a rational function, with stand-ins for functions and for π.
ex Phases::rational(const ex& argument) const {
  return argument.subs(GiNaC::Pi == pi_symbol()).to_rational(atoms_).normal();
}

Monomials Phases::monomials_of(const ex& numerator) const {
  Monomials result;
  for (const ex& term : terms(numerator)) {
    const auto [number, monomial] = split(term);
    if (number.is_zero()) continue;
    if (!number.is_rational()) throw Undecidable("a coefficient that is no rational number");
    result[monomial] += number;
  }
  return result;
}

/// The terms of all arguments over their own denominators: first those that have none, then by their text.
void Phases::make_bases() {
  for (const bool circular : {false, true}) {
    PhaseBasis& basis = bases_[circular];
    std::map<std::pair<std::size_t, std::string>, std::pair<ex, ex>> found;  // phase, numerator
    for (const auto& [argument, is_circular] : arguments_) {
      if (is_circular != circular) continue;
      const ex parts = rational(argument).numer_denom();
      for (const auto& [monomial, number] : monomials_of(parts.op(0))) {
        const ex below = parts.op(1) / parts.op(1).integer_content(),
                 phase = (monomial / below.expand())
                             .subs(atoms_, GiNaC::subs_options::no_pattern)
                             .subs(pi_symbol() == GiNaC::Pi);
        const std::size_t length = is_a<GiNaC::add>(parts.op(1)) ? parts.op(1).nops() : 1;
        found[{length, print(phase, Notation::plain, symbols_)}] = {
            phase, (monomial / below * denominator_).normal().expand()};
      }
    }
    if (circular) basis.add(GiNaC::Pi, monomials_of((pi_symbol() * denominator_).expand()));
    for (const auto& [key, value] : found) basis.add(value.first, monomials_of(value.second));
  }
}

Phases::Argument Phases::in_basis(const ex& numerator, bool circular) const {
  Argument result;
  const PhaseBasis& basis = bases_[circular];
  try {
    const std::vector<numeric> numbers = basis.coefficients(monomials_of(numerator));
    for (std::size_t k = 0; k < numbers.size(); ++k)
      if (circular && k == 0)
        result.pi = numbers[k];
      else if (!numbers[k].is_zero())
        result.parts[basis.phases()[k]] = numbers[k];
  } catch (const std::out_of_range&) {
    throw Undecidable("an argument that was not seen before");
  }
  return result;
}

/// argument = Σ coefficient·phase + q·π, over the denominator that all arguments share.
Phases::Argument Phases::take_apart(const ex& argument, bool circular) const {
  const ex numerator = (rational(argument) * denominator_).normal().expand();
  if (is_a<GiNaC::add>(denominator_)) return in_units(in_basis(numerator, circular), circular);
  Argument result;
  ex rest = numerator;
  const ex of_pi = numerator.coeff(pi_symbol(), 1);
  if (circular && !of_pi.is_zero() &&
      numerator.degree(pi_symbol()) == 1) {  // how many whole denominators stand beside π?
    const auto [lead, monomial] = split(terms(denominator_).front());
    for (const ex& term : terms(of_pi)) {
      const auto [number, other] = split(term);
      if (other.is_equal(monomial)) result.pi = number / lead;
    }
    rest = (numerator - result.pi * denominator_ * pi_symbol()).expand();
  }
  for (const auto& [monomial, number] : monomials_of(rest)) {
    const ex phase = (monomial / denominator_).subs(atoms_, GiNaC::subs_options::no_pattern);
    result.parts[phase.subs(pi_symbol() == GiNaC::Pi)] += number;
  }
  return in_units(result, circular);
}

/// The greatest common part of the multiples of a phase, where they or their denominator are large: 2469/2000
/// in 1.2345·x and 2.469·x. A phase that is a function is tied to what stands in it, and left whole.
void Phases::find_units() {
  constexpr long large = 60;
  std::map<ex, numeric, GiNaC::ex_is_less> above[2], below[2], largest[2];
  for (const auto& [argument, circular] : arguments_)
    for (const auto& [phase, number] : take_apart(argument, circular).parts) {
      if (!name_of(phase).empty()) continue;
      numeric &a = above[circular][phase], &b = below[circular].try_emplace(phase, 1).first->second;
      a = GiNaC::gcd(a, number.numer()), b = GiNaC::lcm(b, number.denom());
      numeric& most = largest[circular][phase];
      most = std::max(most, GiNaC::abs(number));
    }
  for (const bool circular : {false, true})
    for (const auto& [phase, a] : above[circular])
      if (const numeric& b = below[circular].at(phase);
          !a.is_zero() && (b > large || largest[circular].at(phase) * b > large))
        units_[circular][phase] = a / b;
}

Phases::Argument Phases::in_units(const Argument& taken, bool circular) const {
  Argument result{{}, taken.pi};
  for (const auto& [phase, number] : taken.parts) {
    const auto found = units_[circular].find(phase);
    const numeric unit = found == units_[circular].end() ? 1 : found->second;
    result.parts[unit * phase] += number / unit;
  }
  return result;
}

}  // namespace rederive
