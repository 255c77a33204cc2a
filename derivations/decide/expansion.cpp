// Compares statements by their series in small symbols.
#include <algorithm>
#include <derivations/decide/comparison.hpp>
#include <derivations/decide/decide.hpp>
#include <derivations/identity/translator.hpp>
#include <derivations/language/lower.hpp>
#include <derivations/language/print.hpp>

namespace rederive::decide {
using namespace language;
using namespace identity;
using namespace sign;

using GiNaC::ex;

namespace {
/// A series as a Laurent polynomial in the size, known below a power.
struct Series {
  ex terms;
  int known;  ///< the first power that is not known
};

/// Returns the tree with e^{y log b} for b^y, if y has symbols.
Tree with_exponentials(const Tree& tree) {
  std::vector<Tree> parts;
  for (const Tree& child : tree->children) parts.push_back(with_exponentials(child));
  if (tree->kind != Node::Kind::power || names_of(parts[1]).empty())
    return make_tree(tree->kind, tree->text, parts, tree->inverse);
  const Tree log = make_tree(Node::Kind::call, "log", {parts[0]});
  const Tree exponent = make_tree(Node::Kind::product, "", {parts[1], log}, {false, false});
  return make_tree(Node::Kind::call, "exp", {exponent});
}

class Expansion {
 public:
  /// Keeps references, which must live longer; `known` holds the assumptions.
  Expansion(const GiNaC::symbol& size, int terms, const Symbols& symbols,
            const std::vector<std::string>& small, Comparison& known)
      : size_(size), terms_(terms), symbols_(symbols), small_(small), known_(known) {
    for (const std::string& name : small) scaled_[symbols[name]] = size * symbols[name];
  }

  /// Returns the series of a tree in the size of the small symbols, and adds the conditions for values near 0
  /// to `conditions`. Throws Undecidable if there is no series.
  Series of(const Tree& tree) {
    std::vector<Atom> found;
    (void)known_.translator(with_exponentials(tree), found);
    for (const Atom& c : found)
      require(of(lower(c.tree, symbols_)), c.signs == Signs::nonnegative() ? Signs::positive() : c.signs);
    return of(lower(tree, symbols_));
  }
  Series of(const ex& e) { return of_scaled(e.subs(scaled_, GiNaC::subs_options::no_pattern)); }

  /// Returns whether it contains the logarithm of a small symbol, which grows as the symbol goes to 0.
  bool has_log_of_small(const ex& e) const {
    if (GiNaC::is_a<GiNaC::function>(e) && GiNaC::ex_to<GiNaC::function>(e).get_name() == "log")
      return std::ranges::any_of(small_, [&](auto& name) { return e.has(symbols_[name]); });
    return std::ranges::any_of(e, [&](const ex& part) { return has_log_of_small(part); });
  }

  /// The conditions that do not follow from the assumptions.
  std::vector<Atom> conditions;

  /// Returns the polynomial up to a power, at size 1.
  ex polynomial(const Series& series, int order) const {
    if (series.known <= order + 1) throw Undecidable("a pole is of too high an order");
    if (has_log_of_small(coefficient(series, order + 1)))
      throw Undecidable("the remainder is larger than the next power, by a logarithm");
    return truncated(series.terms, order + 1).terms.subs(size_ == 1);
  }

  /// Requires that the lowest term has these signs, so that values near 0 have them. Returns the known signs.
  Signs require(const Series& series, Signs signs) {
    const Series rest = from_its_lowest_term(series);
    const Tree lowest = to_tree(coefficient(rest, low(rest)), symbols_);
    std::vector<Atom> unused;
    const Fraction f = known_.translator(lowest, unused);
    const Signs known = known_.ring.signs_of(f);
    if ((known & signs).is_none()) throw Undecidable("an argument has no value");
    if (!prove_signs(known_.ring, f, signs)) conditions.push_back({f, signs, lowest});
    return known;
  }

 private:
  Series of_scaled(const ex& e) {
    if (!e.has(size_) || e.is_equal(size_)) return {e, terms_};
    const bool is_sum = GiNaC::is_a<GiNaC::add>(e);
    if (is_sum || GiNaC::is_a<GiNaC::mul>(e)) {
      Series result{is_sum ? 0 : 1, terms_};
      for (const ex& part : e)
        result = is_sum ? plus(result, of_scaled(part)) : times(result, of_scaled(part));
      return result;
    }
    const GiNaC::symbol x("x");
    if (GiNaC::is_a<GiNaC::power>(e)) {
      if (e.op(1).info(GiNaC::info_flags::integer))
        return power(of_scaled(e.op(0)), GiNaC::ex_to<GiNaC::numeric>(e.op(1)).to_int());
      if (!e.op(1).has(size_)) return composed(GiNaC::pow(x, e.op(1)), x, of_scaled(e.op(0)));
      return of_scaled(GiNaC::exp(e.op(1) * GiNaC::log(e.op(0))));
    }
    if (!GiNaC::is_a<GiNaC::function>(e) || e.nops() != 1)
      throw Undecidable("there is no series of this form");
    const std::string name = GiNaC::ex_to<GiNaC::function>(e).get_name();
    if (name == "tan") return of_scaled(GiNaC::sin(e.op(0)) / GiNaC::cos(e.op(0)));
    if (name == "abs") throw Undecidable("there is no series of an absolute value");
    Series inside = of_scaled(e.op(0));
    if (name == "log") {  // log(size^m (c + ...)) = m log(size) + log(c + ...), and the size is 1 in the end
      inside = from_its_lowest_term(inside);
      inside = shifted(inside, -low(inside));
    }
    return composed(GiNaC::function(GiNaC::ex_to<GiNaC::function>(e).get_serial(), x), x, inside);
  }

  ex coefficient(const Series& s, int power) const { return s.terms.coeff(size_, power); }
  int low(const Series& s) const { return s.terms.is_zero() ? s.known : s.terms.ldegree(size_); }
  Series truncated(const ex& e, int known) const {
    const ex all = e.expand();
    ex sum = 0;
    for (int k = all.ldegree(size_); k < known; ++k) sum += all.coeff(size_, k) * pow(size_, k);
    return {sum.expand(), known};
  }
  Series shifted(const Series& s, int by) const {
    return {(s.terms * pow(size_, by)).expand(), s.known + by};
  }
  Series plus(const Series& a, const Series& b) const {
    return truncated(a.terms + b.terms, std::min(a.known, b.known));
  }
  Series times(const Series& a, const Series& b) const {
    return truncated(a.terms * b.terms, std::min(a.known + low(b), b.known + low(a)));
  }
  bool is_zero(const ex& e) {
    if (e.expand().is_zero()) return true;
    std::vector<Atom> unused;
    const Fraction f = known_.translator(to_tree(e, symbols_), unused);
    return vanishes(f, known_.ring, known_.translator);
  }
  /// Returns the series without lowest terms that are 0, up to the power `most`.
  Series without_zeros(Series s, int most) {
    while (low(s) < std::min(most, s.known) && is_zero(coefficient(s, low(s))))
      s.terms = (s.terms - coefficient(s, low(s)) * pow(size_, low(s))).expand();
    return s;
  }
  Series from_its_lowest_term(const Series& series) {
    const Series s = without_zeros(series, series.known);
    if (s.terms.is_zero()) throw Undecidable("a divisor is 0 to all orders that were tried");
    for (const std::string& name : small_)
      if (small_.size() > 1 && coefficient(s, low(s)).has(symbols_[name]))
        throw Undecidable("the lowest terms of a divisor may be the smaller ones");
    return s;
  }
  /// Returns a power; for negative exponents (c·sizeᵐ(1 + …))ⁿ = sizeᵐⁿ·(c + …)ⁿ.
  Series power(const Series& base, int n) {
    Series result{1, terms_};
    for (int k = 0; k < n; ++k) result = times(result, base);
    if (n >= 0) return result;
    const Series rest = from_its_lowest_term(base);
    const GiNaC::symbol x("x");
    return shifted(composed(pow(x, n), x, shifted(rest, -low(rest))), low(rest) * n);
  }
  /// Returns f(a + δ) = Σ f⁽ᵏ⁾(a) δᵏ/k! for an f that is analytic at a.
  Series composed(const ex& f, const GiNaC::symbol& x, const Series& argument) {
    Series delta = without_zeros(argument, 0);
    const ex a = coefficient(delta, 0);
    if (low(delta) < 0 || has_log_of_small(a))
      throw Undecidable("there is no series of a function at infinity");
    if (GiNaC::is_a<GiNaC::power>(f) && !f.op(1).info(GiNaC::info_flags::integer) && is_zero(a))
      throw Undecidable("there is no series of a root at 0");
    delta.terms -= a;
    Series sum{0, delta.known}, power{1, terms_};
    ex derivative = f;
    for (int k = 0; k < terms_; ++k) {
      try {
        sum = plus(sum, times({derivative.subs(x == a) / GiNaC::factorial(k), terms_}, power));
      } catch (const std::domain_error&) {  // GiNaC's pole_error among them
        throw Undecidable("there is no series where a function has a pole or a branch point");
      }
      power = times(power, delta), derivative = derivative.diff(x);
    }
    return sum;
  }

  GiNaC::symbol size_;
  int terms_;
  const Symbols& symbols_;
  const std::vector<std::string>& small_;
  Comparison& known_;
  GiNaC::exmap scaled_;
};

/// A relation c·y + d op 0 solved for the symbol y: y op value.
struct SolvedFor {
  ex value, coefficient;
};
std::optional<SolvedFor> said_of(const Relation& relation, const ex& y, const Symbols& symbols) {
  const ex residual = (lower(relation.sides[0], symbols) - lower(relation.sides[1], symbols)).expand();
  if (!residual.is_polynomial(y) || residual.degree(y) != 1 || residual.coeff(y, 1).has(y))
    return std::nullopt;
  return SolvedFor{-residual.coeff(y, 0) / residual.coeff(y, 1), residual.coeff(y, 1)};
}

/// Returns the symbols for which both may be solved; those alone on a side come first.
std::vector<std::string> symbols_to_solve_for(const Relation& left, const Relation& right) {
  std::vector<std::string> names;
  for (const Relation* relation : {&left, &right})
    for (const Tree& side : relation->sides)
      if (is_symbol(side)) names.push_back(side->text);
  for (const std::string& name : names_of(left)) names.push_back(name);
  return names;
}

/// Returns whether an equation that was not substituted contains a small symbol.
bool ties(const std::vector<Relation>& assumptions, const std::vector<std::string>& small) {
  return std::ranges::any_of(assumptions, [&](const Relation& a) {
    const auto names = names_of(a);
    return a.operators[0] == "=" && std::ranges::any_of(small, [&](auto& s) { return names.contains(s); });
  });
}

/// Returns both statements to an order: polynomials of expressions, or relations solved for one symbol.
std::pair<Relation, Relation> to_order(const Problem& problem, const std::vector<std::string>& small,
                                       int order, Expansion& expansion) {
  const Relation &left = problem.left, &right = problem.right;
  const Symbols& symbols = problem.symbols;
  const auto polynomial = [&](const auto& of) {
    return to_tree(expansion.polynomial(expansion.of(of), order), symbols);
  };
  if (left.operators.empty()) return {{{polynomial(left.sides[0])}, {}}, {{polynomial(right.sides[0])}, {}}};
  if (left.operators.size() != 1 || right.operators.size() != 1 || is_equation(left) != is_equation(right))
    throw Undecidable("the series of an equation and an inequality cannot be compared");
  if (is_symbol(left.sides[0]) && is_symbol(right.sides[0]) && left.sides[0]->text != right.sides[0]->text)
    throw Undecidable("the two are about different symbols, and their orders may differ");
  for (const std::string& name : symbols_to_solve_for(left, right)) {
    if (std::ranges::find(small, name) != small.end()) continue;
    const auto a = said_of(left, symbols[name], symbols), b = said_of(right, symbols[name], symbols);
    if (!a || !b) continue;
    const auto says = [&](const Relation& relation, const SolvedFor& said) {
      for (const Tree& side : relation.sides) (void)expansion.of(side);  // for its conditions
      std::string op = relation.operators[0];
      const Signs signs = expansion.require(expansion.of(said.coefficient), Signs::nonzero());
      if (op != "=" && signs == Signs::negative()) op[0] = op[0] == '<' ? '>' : '<';
      if (op != "=" && signs != Signs::positive() && signs != Signs::negative())
        throw Undecidable("the sign of a factor of " + name + " is not known");
      return Relation{{to_tree(symbols[name], symbols), polynomial(said.value)}, {op}};
    };
    return {says(left, *a), says(right, *b)};
  }
  throw Undecidable("there is no symbol for which both can be solved");
}

}  // namespace

Proof decide_to_order(const Relation& left, const Relation& right, const std::vector<std::string>& small,
                      int order, const Symbols& symbols, const std::vector<Given>& given,
                      const std::vector<Relation>& assumptions) {
  Proof proof;
  try {
    const Problem problem = with_values({left, right, assumptions, symbols}, given);
    Comparison known(symbols);
    std::optional<Expansion> expansion;
    const auto [a, b] = known.translator.with_basis([&] {
      translate(known, {{{zero()}, {}}, {{zero()}, {}}, problem.assumptions, symbols, problem.values});
      expansion.emplace(GiNaC::symbol("size"), order + 6, symbols, small, known);
      return to_order(problem, small, order, *expansion);
    });
    std::vector<Relation> holds = problem.assumptions;
    for (const Atom& c : expansion->conditions)
      holds.push_back({{c.tree, zero()}, {c.signs == Signs::nonzero() ? "!=" : ">"}});
    proof = decide(a, b, symbols, {}, holds);
    if (proof.verdict == Verdict::proved || proof.verdict == Verdict::proved_under) {
      proof.verdict = Verdict::approximation, proof.by = By::expansion;
      proof.reason = "the series in the small symbols are the same up to this order";
      for (Relation& condition : relations_of(expansion->conditions, known.ring, symbols))
        proof.side_conditions.push_back(std::move(condition));
    } else if (proof.verdict == Verdict::refuted && ties(problem.assumptions, small)) {
      proof = {.reason =
                   "the series would differ, but an assumption ties what is small to other symbols; say "
                   "what changes"};
    } else if (proof.verdict == Verdict::refuted) {
      proof.by = By::expansion, proof.reason = "the series differ at the witness, which shows their values";
    }
  } catch (const std::exception& error) {
    proof.reason = in_plain_words(error);
  }
  return proof;
}

}  // namespace rederive::decide
