// Expression → rational function of independent generators, with true algebraic relations between some of
// them.
//
// Every argument of sin, cos, sinh, cosh, exp … is taken apart into rational multiples of independent phases;
// a circular phase φ becomes z = e^{iφ/n}, a real one x becomes h = e^{x/n}, with n such that only whole
// powers are left. Rational multiples of π become numbers; roots of primes and of what is positive, the
// imaginary unit and inverse functions inside arguments become generators with a relation (i² = -1).
//
// Everything done here is a true identity, so that a numerator which vanishes proves the statement.
#pragma once

#include <array>
#include <derivations/algebra/phase_basis.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>
#include <stdexcept>

namespace rederive {

/// The statement is outside the class; the message says why.
struct Undecidable : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// "sin" of sin(x); empty where the expression is no function of one argument.
inline std::string name_of(const GiNaC::ex& e) {
  const bool is_call = GiNaC::is_a<GiNaC::function>(e) && e.nops() == 1;
  return is_call ? GiNaC::ex_to<GiNaC::function>(e).get_name() : std::string();
}

/// Stands for π in polynomials.
const GiNaC::symbol& pi_symbol();

/// One generator of the ring, and what it stands for.
struct Generator {
  enum class Kind {
    circular,   ///< e^{i meaning/divisor}
    real,       ///< e^{meaning/divisor}
    root,       ///< the positive root meaning^{1/divisor}
    imaginary,  ///< i
    pi,         ///< π
    opaque      ///< a function value that is only equal to itself: meaning
  };
  Kind kind;
  GiNaC::symbol symbol;  ///< "$z3": no name that can be typed
  GiNaC::ex meaning;     ///< in the symbols of the statement
  int divisor = 1;       ///< n in e^{iφ/n}, or the degree of the root
  int degree = 0;        ///< symbol^degree = value holds; 0: no relation
  GiNaC::ex value;       ///< in the generators before it
};

/// The rewriting of a set of expressions that belong together: build it from all of them, then apply it to
/// each.
class Phases {
 public:
  /// Throws Undecidable where an expression is outside the class.
  Phases(const std::vector<GiNaC::ex>& expressions, const Symbols& symbols);

  /// The rational function of generators and plain symbols that an expression is: one of those, or one that
  /// is made of the same phases, roots and functions. Throws Undecidable where it is not.
  GiNaC::ex operator()(const GiNaC::ex& expression) const;
  /// The remainder of a polynomial modulo all relations: 0 iff it is 0 in the ring. It is `scale` times as
  /// large as the polynomial, a product of denominators in the relations.
  GiNaC::ex reduce(const GiNaC::ex& polynomial, GiNaC::ex* scale = nullptr) const;
  /// A rational function back in the symbols of the statement, for a numeric check.
  GiNaC::ex meaning_of(const GiNaC::ex& rational) const;

  /// An argument of sin, cos … (circular) or exp, sinh … as Σ n·(meaning/divisor) + q·π: n by generator, and
  /// q. Throws Undecidable where it is none of those that were seen.
  std::pair<std::vector<std::pair<GiNaC::symbol, GiNaC::numeric>>, GiNaC::numeric> combination(
      const GiNaC::ex& argument, bool circular) const;
  /// e^{i argument} (circular) or e^argument: the product of that. Throws Undecidable.
  GiNaC::ex exponential(const GiNaC::ex& argument, bool circular) const;
  /// e^{iqπ} for a q that `combination` gives.
  GiNaC::ex turn(const GiNaC::numeric& q) const;

  /// i first, then in the order in which their values need each other.
  const std::vector<Generator>& generators() const { return generators_; }

 private:
  struct Argument {
    std::map<GiNaC::ex, GiNaC::numeric, GiNaC::ex_is_less> parts;  ///< phase → rational coefficient
    GiNaC::numeric pi = 0;                                         ///< and so many times π
  };
  void collect(const GiNaC::ex& prepared);
  Argument take_apart(const GiNaC::ex& argument, bool circular) const;
  Argument in_units(const Argument& taken, bool circular) const;
  Argument in_basis(const GiNaC::ex& numerator, bool circular) const;
  Monomials monomials_of(const GiNaC::ex& numerator) const;
  GiNaC::ex rational(const GiNaC::ex& argument) const;
  void find_denominator();
  void find_units();
  void make_bases();
  void make_generators();
  void make_turns(const std::vector<GiNaC::numeric>& turns);
  GiNaC::ex root_of_turns(const GiNaC::ex& base) const;
  void relate_inverse(Generator& generator);
  void join_equal_sizes();
  GiNaC::ex rewrite(const GiNaC::ex& prepared) const;
  GiNaC::ex root(const GiNaC::ex& base, const GiNaC::numeric& exponent) const;
  GiNaC::ex opaque(const GiNaC::ex& value) const;
  const Generator* find(Generator::Kind kind, const GiNaC::ex& meaning) const;

  const Symbols& symbols_;
  GiNaC::exmap prepared_;  ///< expression → what it was rewritten to, once
  std::vector<Generator> generators_;
  GiNaC::ex denominator_ = 1;
  std::array<PhaseBasis, 2> bases_;  ///< of real and of circular phases, where that denominator is a sum
  /// phase → the part of it of which there are small multiples only, where the numbers are large
  std::array<std::map<GiNaC::ex, GiNaC::numeric, GiNaC::ex_is_less>, 2> units_;
  mutable GiNaC::exmap atoms_;  ///< stand-in symbol → function value inside an argument
  std::vector<std::pair<GiNaC::ex, bool>> arguments_;   ///< (argument, circular?)
  std::map<GiNaC::ex, long, GiNaC::ex_is_less> roots_;  ///< base → least common denominator of its exponents
  std::vector<GiNaC::ex> opaques_;
};

/// What stands under the root that ties an inverse function to algebra: 1-u² for asin u; 0 for anything else.
GiNaC::ex under_the_root(const GiNaC::ex& inverse);

/// Whether cos qπ and sin qπ are square roots that GiNaC knows: denominators 1, 2, 3, 4, 6, 12.
bool is_tabled(const GiNaC::numeric& q);

/// The irreducible polynomial of e^{2πi/n} in x.
GiNaC::ex cyclotomic(int n, const GiNaC::symbol& x);

/// Rewrites by identities that need no phases: tan, tanh, symbolic powers, logarithms of products, roots of
/// products, inverse functions of what they invert. Throws Undecidable.
GiNaC::ex prepare(const GiNaC::ex& expression, const Symbols& symbols);

}  // namespace rederive
