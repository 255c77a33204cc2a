#include <algorithm>
#include <complex>
#include <derivations/algebra/elimination.hpp>
#include <derivations/algebra/factor_form.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/is_real.hpp>
#include <derivations/algebra/vanish.hpp>
#include <derivations/algebra/witness.hpp>
#include <derivations/language/real.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>

namespace rederive {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

namespace {

/// The sign that a rational function keeps over all ranges, factor by factor: 0 if it may change or vanish.
int strict_sign(const ex& e, const Symbols& symbols) {
  if (const int sign = sign_of(e, symbols)) return sign;
  int sign = 1;
  try {
    if (const auto parts = factor_form(prepare(e, symbols), symbols)) {
      for (const auto& [part, exponent] : *parts) {
        const int s = sign_of(part, symbols);
        sign *= exponent.is_even() ? s * s : s;
      }
      return sign;
    }
  } catch (const Undecidable&) {
  }
  GiNaC::exmap atoms;
  const ex parts = e.to_rational(atoms).numer_denom();
  for (const ex& part : parts) {
    const ex product = GiNaC::factor(part).subs(atoms, GiNaC::subs_options::no_pattern);
    if (!is_a<GiNaC::mul>(product))
      sign *= sign_of(product, symbols);
    else
      for (const ex& factor : product) {
        const bool squared = is_a<GiNaC::power>(factor) && factor.op(1).info(GiNaC::info_flags::even);
        const int s = sign_of(squared ? factor.op(0) : factor, symbols);
        sign *= squared ? s * s : s;
      }
  }
  return sign;
}

bool inside_unit(const ex& e, const Symbols& symbols) {
  return strict_sign((1 - GiNaC::pow(e, 2)).normal(), symbols) > 0;
}

/// Analytic on the whole box of declared ranges: no pole, no branch point, no corner. The box is connected.
bool is_analytic(const ex& e, const Symbols& symbols) {
  for (const ex& part : e)
    if (!is_analytic(part, symbols)) return false;
  if (is_a<GiNaC::power>(e)) {
    const ex exponent = e.op(1);
    if (is_a<numeric>(exponent) && ex_to<numeric>(exponent).is_nonneg_integer()) return true;
    if (is_a<numeric>(exponent) && ex_to<numeric>(exponent).is_integer())
      return strict_sign(e.op(0), symbols) != 0;
    return strict_sign(e.op(0), symbols) > 0;
  }
  const std::string name = name_of(e);
  if (name.empty()) return !is_a<GiNaC::function>(e);
  if (name == "log") return strict_sign(e.op(0), symbols) > 0;
  if (name == "acosh") return strict_sign(e.op(0) - 1, symbols) > 0;
  if (name == "abs") return strict_sign(e.op(0), symbols) != 0;
  if (name == "tan") return strict_sign(GiNaC::cos(e.op(0)), symbols) != 0;
  if (name == "asin" || name == "acos" || name == "atanh") return inside_unit(e.op(0), symbols);
  for (const char* entire : {"sin", "cos", "exp", "sinh", "cosh", "tanh", "atan", "asinh"})
    if (name == entire) return true;
  return false;
}

/// Where asin u, acos u or atanh u is defined, u lies in [-1, 1], where acosh u is, in [1, inf): for a symbol
/// u that narrows its range.
Symbols narrowed(const ex& e, Symbols symbols) {
  for (auto part = e.preorder_begin(); part != e.preorder_end(); ++part) {
    const std::string name = name_of(*part);
    const bool arc = name == "asin" || name == "acos" || name == "atanh";
    if ((!arc && name != "acosh") || !is_a<GiNaC::symbol>(part->op(0))) continue;
    const ex& u = part->op(0);
    const Symbol* symbol = symbols.find(u);
    if (symbol == nullptr) continue;
    const Range old = read_range(symbol->range);
    const bool below = !is_nonnegative(u - (arc ? -1 : 1), symbols),
               above = arc && !is_nonnegative(1 - u, symbols);
    const std::string low = below ? (arc ? "(-1" : "(1") : (old.lower_closed ? "[" : "(") + old.lower;
    const std::string high = above ? "1)" : old.upper + (old.upper_closed ? "]" : ")");
    const Interval now = parse_range(low + ", " + high);
    const bool empty =
        now.low.infinite == 0 && now.high.infinite == 0 && compare(now.low.value, now.high.value) >= 0;
    if ((below || above) && !empty) symbols.narrow(symbol->name, low + ", " + high);
  }
  return symbols;
}

Points points_for(const ex& expression, const Symbols& symbols) {
  return Points(names_in(expression), symbols);
}

/// Calculated with 60 digits, so that what is small because it cancels inside has some, too.
std::optional<std::complex<double>> value_at(const ex& e, const Point& point, const Symbols& symbols) {
  GiNaC::exmap values;
  for (const auto& [name, value] : point) values[symbols[name]] = numeric(value);
  const long before = GiNaC::Digits;
  GiNaC::Digits = 60;
  const ex number = e.subs(values, GiNaC::subs_options::no_pattern).evalf();
  GiNaC::Digits = before;
  if (!is_a<numeric>(number)) return std::nullopt;
  const std::complex<double> result(ex_to<numeric>(number.real_part()).to_double(),
                                    ex_to<numeric>(number.imag_part()).to_double());
  return std::isfinite(std::abs(result)) ? std::optional(result) : std::nullopt;
}

/// Whether a polynomial in generators is not 0 at some point of the declared ranges, as far as doubles show
/// it: far above what their rounding leaves of its terms.
bool is_alive(const ex& polynomial, const Phases& phases, const Points& points, const Symbols& symbols) {
  for (int index = 0; index < 12; ++index) {
    std::complex<double> sum = 0;
    double sizes = 0;
    bool defined = true;
    const auto add = [&](const ex& term) {
      const auto value = value_at(phases.meaning_of(term), points.at(index), symbols);
      defined = defined && value;
      if (value) sum += *value, sizes += std::abs(*value);
    };
    if (is_a<GiNaC::add>(polynomial))
      for (const ex& term : polynomial) add(term);
    else
      add(polynomial);
    if (defined && std::abs(sum) > 1e-6 * sizes) return true;
  }
  return false;
}

/// Square roots may satisfy relations that r² = u does not show. Over a connected domain on which u is
/// positive, N(r) and N(-r) are analytic; if their product, which has no r any more, vanishes identically,
/// one of the two does, and it is ours if the other one, the cofactor, is different from zero somewhere.
std::optional<ex> cofactor_on_our_branch(const ex& numerator, const Phases& phases, const Points& points,
                                         const Symbols& symbols, int depth = 0) {
  if (numerator.is_zero()) return 1;
  const Generator* root = nullptr;
  for (const Generator& g : phases.generators()) {
    if (!numerator.has(g.symbol) || g.kind == Generator::Kind::imaginary) continue;
    if (!is_analytic(g.meaning, symbols)) return std::nullopt;
    if (g.kind != Generator::Kind::root) continue;
    if (sign_of(g.meaning, symbols) <= 0) return std::nullopt;
    if (g.degree == 2 && (root == nullptr || g.value.has(root->symbol)))
      root = &g;  // the outer of nested ones first
  }
  if (root == nullptr || depth > 5) return std::nullopt;
  const ex turned = numerator.subs(root->symbol == -root->symbol).expand();
  if ((numerator + turned).expand().is_zero())  // r times something
    return cofactor_on_our_branch((numerator / root->symbol).expand(), phases, points, symbols, depth + 1);
  if (!is_alive(turned, phases, points, symbols)) return std::nullopt;
  const auto rest =
      cofactor_on_our_branch(phases.reduce(numerator * turned), phases, points, symbols, depth + 1);
  return rest ? std::optional(*rest * turned) : std::nullopt;
}

bool vanishes(const ex& expression, const Symbols& symbols, int depth);

/// A sum divided by what the coefficients of its functions have in common: powers of their exponentials are
/// long.
ex with_small_multiples(const ex& sum) {
  numeric common = 0;
  const ex terms = sum.expand();
  for (const ex& term : terms) {
    const ex number = is_a<GiNaC::mul>(term) ? term.op(term.nops() - 1) : ex(1);
    const bool is_rational = number.info(GiNaC::info_flags::rational);
    if (!name_of(is_rational && !number.is_equal(1) ? term / number : term).empty())
      common = common.is_zero() ? abs(ex_to<numeric>(is_rational ? number : 1))
                                : gcd(common, ex_to<numeric>(is_rational ? number : 1));
  }
  return common.is_pos_integer() ? (terms / common).expand() : terms;
}

/// A real sum E of inverse functions and angles: e^E = 1 makes it 0, where it has logarithms and area
/// functions; e^{2iE} = 1 makes it a multiple of π, the same one all over a connected domain, where it has
/// arcs: which one is seen at one point.
bool vanishes_by_its_exponential(const ex& multiple, const Symbols& given, int depth) {
  if (!is_real(multiple)) return false;
  const ex sum = with_small_multiples(multiple);
  const Symbols symbols = narrowed(sum, given);
  bool arcs = false, areas = false;
  for (auto part = sum.preorder_begin(); part != sum.preorder_end(); ++part) {
    const std::string name = name_of(*part);
    arcs = arcs || name == "asin" || name == "atan" || name == "acos";
    if (name == "log" && !is_positive_where_defined(part->op(0), symbols)) return false;
    areas = areas || name == "log" || name == "asinh" || name == "acosh" || name == "atanh";
  }
  if (areas == arcs) return false;
  if (areas && vanishes(GiNaC::exp(sum) - 1, given, depth + 1)) return true;
  if (!is_analytic(sum, symbols)) return false;
  if (areas) return vanishes(GiNaC::exp(sum) - 1, symbols, depth + 1);
  const Points points = points_for(sum, symbols);
  const auto value = value_of(to_tree(sum, symbols), points.at(0));
  if (!value || cln::abs(*value) > cln::cl_RA("1/10")) return false;
  return vanishes(GiNaC::sin((2 * sum).expand()), symbols, depth + 1) &&
         vanishes(GiNaC::cos((2 * sum).expand()) - 1, symbols, depth + 1);
}

/// A symbol of the polynomial that no phase, root or function has: all of its coefficients must vanish.
std::optional<ex> symbol_beside(const ex& polynomial, const Phases& phases, const Symbols& symbols) {
  for (const std::string& name : names_in(polynomial)) {
    const Symbol* symbol = symbols.find(name);
    const auto is_in = [&](const Generator& g) { return symbol == nullptr || g.meaning.has(symbol->ginac); };
    if (std::none_of(phases.generators().begin(), phases.generators().end(), is_in)) return symbol->ginac;
  }
  return std::nullopt;
}

/// A sum of inverse functions that vanishes, in a factor of a polynomial in the generators, or one in each
/// of its coefficients: the first of those. That makes the polynomial 0.
std::optional<ex> vanishing_sum_in(const ex& polynomial, const Phases& phases, const Symbols& symbols,
                                   int depth) {
  const ex product = GiNaC::factor(polynomial);
  const ex factors = is_a<GiNaC::mul>(product) ? product : ex(GiNaC::lst{product});
  for (const ex& f : factors) {
    const ex base = is_a<GiNaC::power>(f) ? f.op(0) : f, sum = phases.meaning_of(base);
    if (!is_a<GiNaC::add>(base)) continue;
    if (vanishes_by_its_exponential(sum, symbols, depth)) return sum;
    const auto symbol = symbol_beside(base, phases, symbols);
    std::optional<ex> found;
    for (int k = 0; symbol && k <= base.degree(*symbol); ++k) {
      const ex coefficient = base.coeff(*symbol, k).expand();
      if (coefficient.is_zero()) continue;
      const auto sum_there = vanishing_sum_in(coefficient, phases, symbols, depth);
      if (!sum_there) break;
      if (!found) found = sum_there;
      if (k == base.degree(*symbol)) return found;
    }
  }
  return std::nullopt;
}

std::optional<ex> vanishing_sum(const ex& expression, const Symbols& symbols, int depth) {
  const Phases phases({expression}, symbols);
  bool has_inverse = false;
  for (const Generator& g : phases.generators())
    has_inverse = has_inverse || (g.kind == Generator::Kind::opaque && name_of(g.meaning) != "abs");
  if (!has_inverse) return std::nullopt;
  return vanishing_sum_in(phases.reduce(phases(expression).normal().numer()), phases, symbols, depth);
}

bool vanishes(const ex& expression, const Symbols& symbols, int depth) {
  if (expression.is_zero()) return true;
  const Phases phases({expression}, symbols);
  if (cofactor(phases.reduce(phases(expression).normal().numer()), phases, symbols)) return true;
  return depth < 2 && vanishing_sum(expression, symbols, depth);
}

/// The names of what stands between bars, each in bars of its own: the x of |x| and |sin x|.
std::set<std::string> names_in_bars(const ex& e) {
  std::set<std::string> names;
  for (auto part = e.preorder_begin(); part != e.preorder_end(); ++part)
    if (const auto inside = names_in(*part); name_of(*part) == "abs" && inside.size() == 1)
      names.insert(*inside.begin());
  return names;
}

/// The box of declared ranges of these names without its edges, cut at x = 0 for some of them; empty if that
/// is no other box.
std::vector<Symbols> open_pieces(const Symbols& box, const std::set<std::string>& names,
                                 const std::set<std::string>& cut) {
  std::vector<Symbols> pieces{box};
  for (const std::string& name : names) {
    const Range range = read_range(box.find(name)->range);
    const bool inside =
        cut.contains(name) && !is_nonnegative(box[name], box) && !is_nonnegative(-box[name], box);
    if (!range.lower_closed && !range.upper_closed && !inside) continue;
    std::vector<std::string> ranges{"(" + range.lower + ", " + range.upper + ")"};
    if (inside) ranges = {"(" + range.lower + ", 0)", "(0, " + range.upper + ")"};
    std::vector<Symbols> finer;
    for (const Symbols& piece : pieces)
      for (const std::string& open : ranges) finer.push_back(piece), finer.back().narrow(name, open);
    pieces = std::move(finer);
  }
  const bool same =
      pieces.size() == 1 && std::all_of(names.begin(), names.end(), [&](const std::string& name) {
        return pieces[0].find(name)->range == box.find(name)->range;
      });
  return same ? std::vector<Symbols>{} : pieces;
}

}  // namespace

std::optional<ex> cofactor(const ex& numerator, const Phases& phases, const Symbols& symbols) {
  if (numerator.is_zero()) return 1;
  const Points points = points_for(phases.meaning_of(numerator), symbols);
  const auto found = cofactor_on_our_branch(numerator, phases, points, symbols);
  return found ? found : cofactor_of_powers(numerator, phases, symbols);
}

std::optional<ex> vanishing_sum(const ex& expression, const Symbols& symbols) {
  return vanishing_sum(expression, symbols, 0);
}

std::vector<Symbols> analytic_pieces(const ex& expression, const Symbols& symbols) {
  const std::set<std::string> cut = names_in_bars(expression);
  if (cut.size() > 3) return {};
  const auto pieces = open_pieces(narrowed(expression, symbols), names_in(expression), cut);
  const bool all_analytic = std::all_of(pieces.begin(), pieces.end(),
                                        [&](const Symbols& piece) { return is_analytic(expression, piece); });
  return all_analytic ? pieces : std::vector<Symbols>{};
}

bool vanishes(const ex& expression, const Symbols& symbols) {
  return remembered(symbols.findings().vanishing, expression, [&] {
    if (vanishes(expression, symbols, 0)) return true;
    const auto pieces = analytic_pieces(expression, symbols);
    return !pieces.empty() && std::all_of(pieces.begin(), pieces.end(), [&](const Symbols& piece) {
      return vanishes(expression, piece, 0);
    });
  });
}

}  // namespace rederive
