#include <algorithm>
#include <derivations/decide/expansion.hpp>
#include <derivations/identity/zero_test.hpp>
#include <derivations/language/lower.hpp>
#include <derivations/language/print.hpp>

namespace rederive {

using GiNaC::ex;

namespace {

/// Σ c[k]·size^(low + k), known up to the last of them.
struct Series {
  int low = 0;
  std::vector<ex> c;

  int known() const { return low + static_cast<int>(c.size()); }  ///< the first power that is not known
  ex coefficient(int power) const {
    return power < low || power >= known() ? ex(0) : c[static_cast<std::size_t>(power - low)];
  }
};

class Expansion {
 public:
  Expansion(const GiNaC::symbol& size, int terms, const Symbols& symbols,
            const std::vector<std::string>& small)
      : size_(size), terms_(terms), symbols_(symbols), small_(small) {}

  /// Throws Undecidable where there is no series.
  Series of(const ex& e) {
    if (!e.has(size_)) return constant(e);
    if (e.is_equal(size_)) return truncated({1, {1}});
    const bool is_sum = GiNaC::is_a<GiNaC::add>(e);
    if (is_sum || GiNaC::is_a<GiNaC::mul>(e)) {
      Series result = of(e.op(0));
      for (std::size_t k = 1; k < e.nops(); ++k)
        result = is_sum ? plus(result, of(e.op(k))) : times(result, of(e.op(k)));
      return result;
    }
    if (GiNaC::is_a<GiNaC::power>(e) && e.op(1).info(GiNaC::info_flags::integer))
      return power(of(e.op(0)), GiNaC::ex_to<GiNaC::numeric>(e.op(1)).to_int());
    if (GiNaC::is_a<GiNaC::power>(e) && !e.op(1).has(size_)) {
      const GiNaC::symbol x("x");
      return composed(GiNaC::pow(x, e.op(1)), x, of(e.op(0)));
    }
    if (GiNaC::is_a<GiNaC::power>(e)) {
      if (!e.op(0).has(size_)) require(e.op(0), Signs::positive(), " > 0");
      return of(GiNaC::exp(e.op(1) * GiNaC::log(e.op(0))));
    }
    if (!GiNaC::is_a<GiNaC::function>(e) || e.nops() != 1)
      throw Undecidable("there is no series of this form");
    const std::string name = GiNaC::ex_to<GiNaC::function>(e).get_name();
    if (name == "tan" || name == "tanh") {
      const ex x = e.op(0);
      return of(name == "tan" ? GiNaC::sin(x) / GiNaC::cos(x) : GiNaC::sinh(x) / GiNaC::cosh(x));
    }
    if (name == "abs") throw Undecidable("there is no series of what stands between bars");
    const GiNaC::symbol x("x");
    return composed(GiNaC::function(GiNaC::ex_to<GiNaC::function>(e).get_serial(), x), x, of(e.op(0)));
  }

  /// What must not be 0: the lowest terms of divisors.
  std::vector<std::string> conditions;

 private:
  Series constant(const ex& e) const { return truncated({0, {e}}); }
  Series truncated(Series s) const {
    s.c.resize(static_cast<std::size_t>(std::max(0, terms_ - s.low)), 0);
    return s;
  }
  static Series plus(const Series& a, const Series& b) {
    Series result{std::min(a.low, b.low), {}};
    for (int k = result.low; k < std::min(a.known(), b.known()); ++k)
      result.c.push_back(a.coefficient(k) + b.coefficient(k));
    return result;
  }
  static Series times(const Series& a, const Series& b) {
    Series result{a.low + b.low, {}};
    const std::size_t length = std::min(a.c.size(), b.c.size());
    for (std::size_t k = 0; k < length; ++k) {
      ex sum = 0;
      for (std::size_t j = 0; j <= k; ++j) sum += a.c[j] * b.c[k - j];
      result.c.push_back(sum.expand());
    }
    return result;
  }
  bool is_zero(const ex& e) const {
    if (e.expand().is_zero()) return true;
    Ring ring;
    Translator translator(ring, symbols_);
    std::vector<DomainCondition> unused;
    return vanishes(translator(to_tree(e, symbols_), unused), ring, translator);
  }
  /// Without the lowest terms that are 0; the first one that is left must not be 0.
  Series from_its_lowest_term(Series s) {
    while (!s.c.empty() && is_zero(s.c[0])) s.c.erase(s.c.begin()), ++s.low;
    if (s.c.empty()) throw Undecidable("a divisor that is 0 to all orders that were looked at");
    for (const std::string& name : small_)
      if (small_.size() > 1 && s.c[0].has(symbols_[name]))
        throw Undecidable("a divisor whose lowest terms may be smaller than the rest");
    require(s.c[0], Signs::nonzero(), " != 0");
    return s;
  }
  /// A condition, where the ranges do not grant it. Throws Undecidable where they exclude it.
  void require(const ex& value, Signs signs, const std::string& text) {
    Ring ring;
    Translator translator(ring, symbols_);
    std::vector<DomainCondition> unused;
    const Fraction f = translator(to_tree(value, symbols_), unused);
    const Signs known = ring.signs_of(f);
    if ((known & signs).is_none()) throw Undecidable("there is no series of what has no value");
    const Fraction said = signs == Signs::nonzero() ? Fraction(f.numerator) : f;
    if (!known.within(signs))
      conditions.push_back(print(ring.meaning_of(said), Notation::plain, symbols_) + text);
  }
  /// Of a negative exponent: (c·sizeᵐ(1 + …))ⁿ = sizeᵐⁿ·(c + …)ⁿ.
  Series power(Series base, int n) {
    Series result = constant(1);
    for (int k = 0; k < n; ++k) result = times(result, base);
    if (n >= 0) return result;
    base = from_its_lowest_term(std::move(base));
    const GiNaC::symbol x("x");
    const int low = std::exchange(base.low, 0);
    result = composed(GiNaC::pow(x, n), x, base);
    result.low = low * n;
    return result;
  }
  /// f(a + δ) = Σ f⁽ᵏ⁾(a) δᵏ/k!, where f is analytic at a.
  Series composed(const ex& f, const GiNaC::symbol& x, const Series& inside) {
    if (inside.low < 0 && !is_zero(inside.coefficient(-1)))
      throw Undecidable("there is no series of a function of what is infinite");
    const ex a = inside.coefficient(0);
    Series delta = inside, power = constant(1);
    if (delta.low <= 0 && delta.known() > 0) delta.c[static_cast<std::size_t>(-delta.low)] = 0;
    if (delta.low < 0) throw Undecidable("there is no series of a function of what is infinite");
    const bool is_root = GiNaC::is_a<GiNaC::power>(f) && !f.op(1).info(GiNaC::info_flags::integer);
    if (is_root || f.is_equal(GiNaC::log(x))) {
      if (is_zero(a)) throw Undecidable("there is no series of a root or a logarithm of what is small");
      require(a, Signs::positive(), " > 0");
    }
    Series sum{0, std::vector<ex>(inside.c.size() + static_cast<std::size_t>(inside.low), 0)};
    ex derivative = f;
    for (int k = 0; k < terms_; ++k) {
      try {
        sum = plus(sum, times(constant(derivative.subs(x == a) / GiNaC::factorial(k)), power));
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
};

/// What an equation says of a symbol: y of c·y + d = 0.
std::optional<ex> said_of(const Relation& equation, const ex& y, const Symbols& symbols) {
  const ex residual = (lower(equation.sides[0], symbols) - lower(equation.sides[1], symbols)).expand();
  if (!residual.is_polynomial(y) || residual.degree(y) != 1 || residual.coeff(y, 1).has(y))
    return std::nullopt;
  return -residual.coeff(y, 0) / residual.coeff(y, 1);
}

std::vector<std::string> symbols_to_solve_for(const Relation& left, const Relation& right) {
  std::vector<std::string> alone, others;
  for (const Relation* relation : {&left, &right})
    for (const Tree& side : relation->sides)
      if (side->kind == Node::Kind::symbol && side->text != "pi") alone.push_back(side->text);
  for (const std::string& name : names_of(left)) others.push_back(name);
  alone.insert(alone.end(), others.begin(), others.end());
  return alone;
}

/// An equation that could not be put in, with what is small in it.
bool ties(const std::vector<Relation>& assumptions, const std::vector<std::string>& small) {
  return std::any_of(assumptions.begin(), assumptions.end(), [&](const Relation& a) {
    const auto names = names_of(a);
    return a.operators[0] == "=" &&
           std::any_of(small.begin(), small.end(), [&](auto& s) { return names.contains(s); });
  });
}

std::pair<ex, ex> compared(const Relation& left, const Relation& right, const std::vector<std::string>& small,
                           const Symbols& symbols) {
  if (left.operators.empty()) return {lower(left.sides[0], symbols), lower(right.sides[0], symbols)};
  const std::vector<std::string> equation{"="};
  if (left.operators != equation || right.operators != equation)
    throw Undecidable("of relations, the series of two equations are compared");
  const auto is_other = [](const Tree& a, const Tree& b) {
    return a->kind == Node::Kind::symbol && b->kind == Node::Kind::symbol && a->text != b->text;
  };
  if (is_other(left.sides[0], right.sides[0]))
    throw Undecidable("the two equations say what different symbols are, and the order may differ");
  for (const std::string& name : symbols_to_solve_for(left, right)) {
    if (std::find(small.begin(), small.end(), name) != small.end()) continue;
    const auto a = said_of(left, symbols[name], symbols), b = said_of(right, symbols[name], symbols);
    if (a && b) return {*a, *b};
  }
  throw Undecidable("there is no symbol for which both equations can be solved");
}

}  // namespace

Proof decide_to_order(const Relation& left, const Relation& right, const std::vector<std::string>& small,
                      int order, const Symbols& symbols, const std::vector<Given>& given,
                      const std::vector<Relation>& assumptions) {
  Proof proof;
  try {
    const Problem problem = with_values({left, right, assumptions, symbols}, given);
    const GiNaC::symbol size("size");
    GiNaC::exmap scaled;
    for (const std::string& name : small) scaled[symbols[name]] = size * symbols[name];
    Expansion expansion(size, order + 6, symbols, small);
    const auto series_of = [&](const ex& e) {
      const Series series = expansion.of(e.subs(scaled, GiNaC::subs_options::no_pattern));
      if (series.known() <= order) throw Undecidable("poles that are too deep for this order");
      ex sum = 0;
      for (int k = series.low; k <= order; ++k) sum += series.coefficient(k);
      return Relation{{to_tree(sum, symbols)}, {}};
    };
    const auto [a, b] = compared(problem.left, problem.right, small, symbols);
    proof = decide(series_of(a), series_of(b), symbols, {}, problem.assumptions);
    if (proof.verdict == Verdict::proved || proof.verdict == Verdict::proved_under) {
      proof.verdict = Verdict::approximation, proof.by = "expansion";
      proof.reason = "the series in the small symbols are the same up to this order";
      for (const std::string& condition : expansion.conditions)
        if (std::find(proof.side_conditions.begin(), proof.side_conditions.end(), condition) ==
            proof.side_conditions.end())
          proof.side_conditions.push_back(condition);
    } else if (proof.verdict == Verdict::refuted && ties(problem.assumptions, small)) {
      proof = Proof{};
      proof.reason =
          "the series would differ, but an assumption ties what is small to other symbols; say what changes";
    } else if (proof.verdict == Verdict::refuted) {
      proof.by = "expansion", proof.reason = "the series differ at the witness, which shows their values";
    }
  } catch (const SyntaxError& error) {
    proof.reason = error.what();
  } catch (const Undecidable& error) {
    proof.reason = error.what();
  }
  return proof;
}

}  // namespace rederive
