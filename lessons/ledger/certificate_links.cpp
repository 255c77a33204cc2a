#include <algorithm>
#include <array>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/quotient.hpp>
#include <derivations/algebra/vanish.hpp>
#include <lessons/ledger/certificate_links.hpp>

namespace rederive {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

namespace {

void collect_divisors(const Tree& tree, const CertifiedStatement& q, std::vector<CertifiedDivisor>& found) {
  const auto add = [&](const Tree& divisor) {
    found.push_back({put_in(lower(divisor, q.symbols), q.given), divisor});
  };
  for (const Tree& child : tree->children) collect_divisors(child, q, found);
  if (tree->kind == Node::Kind::product)
    for (std::size_t k = 0; k < tree->children.size(); ++k)
      if (tree->inverse[k] && !q.rational(tree->children[k])) add(tree->children[k]);
  if (tree->kind == Node::Kind::power && !q.is_root(tree) && q.rational(tree->children[1])->is_negative())
    add(tree->children[0]);
  if (tree->kind != Node::Kind::call) return;
  for (const auto& [divisor, names] : {std::pair{"cos", std::array{"tan", "sec"}},
                                       {"sin", {"cot", "csc"}},
                                       {"sinh", {"coth", "csch"}},
                                       {"cosh", {"tanh", "sech"}}})
    if (tree->text == names[0] || tree->text == names[1]) add(call(divisor, tree->children[0]));
}

/// Finds what makes one link hold.
struct Finder {
  const CertifiedStatement& q;
  const std::vector<CertifiedDivisor>& divisors;

  Tree tree(const ex& e) const { return to_tree(e, q.symbols); }

  // ---- forms that show a sign

  /// Whether the range of the terms as they stand shows one sign.
  bool shows_sign(const ex& e) const {
    const Interval i = interval_of(e, q.symbols);
    try {
      return (i.low.infinite == 0 && compare(i.low.value, 0) >= 0) ||
             (i.high.infinite == 0 && compare(i.high.value, 0) <= 0);
    } catch (const std::domain_error&) {  // too close to tell
      return false;
    }
  }
  /// An expression of one sign so written that it shows: with a square completed, if need be.
  ex form(const ex& e) const {
    const auto quadratic = as_quadratic(e);
    if (shows_sign(e) || !quadratic || quadratic->b.is_zero()) return e;
    return quadratic->a * GiNaC::pow(quadratic->x + quadratic->b / (2 * quadratic->a), 2) +
           form((quadratic->discriminant() / (4 * quadratic->a)).normal());
  }
  std::optional<ex> form_of_one_sign(const ex& e) const {
    if (e.is_zero() || is_nonnegative(e, q.symbols) || is_nonnegative(-e, q.symbols)) return form(e);
    const auto parts = checked_quotient(e, 1, q.symbols);
    if (!parts) return std::nullopt;
    ex product = 1;
    for (const auto& [part, n] : *parts) {
      const bool seen = n.is_even() || is_nonnegative(part, q.symbols) || is_nonnegative(-part, q.symbols);
      if (!seen) return std::nullopt;
      product *= GiNaC::pow(form(part), n);
    }
    return product;
  }
  /// Whether a relation always holds, or never.
  std::optional<bool> settled(const ex& residual, const std::string& op) const {
    const bool weak = op.ends_with('=');
    if (vanishes(residual, q.symbols)) return weak;
    const auto parts = checked_quotient(residual, 1, q.symbols);
    if (!parts) return std::nullopt;
    const Quotient product = assess(*parts, {}, q.symbols);
    const bool never_zero = product.zeros.empty(), holds = op != "=" && product.sign > 0;
    if (op != "=" && product.sign == 0) return std::nullopt;
    const bool zero_fits = op != "=" && holds == weak;  // 0 does not matter then
    return zero_fits || never_zero ? std::optional(holds) : std::nullopt;
  }
  bool settle(CertifiedLink& link, const std::string& op, const std::string& other) const {
    const auto left = settled(link.left, op), right = settled(link.right, other);
    if (!left || left != right) return false;
    const auto left_form = form_of_one_sign(link.left), right_form = form_of_one_sign(link.right);
    if (!left_form || !right_form) return false;
    link.holds = left, link.left_form = tree(*left_form), link.right_form = tree(*right_form);
    return true;
  }

  // ---- factors

  /// Every part is a number, has one sign, or is what the statement divides by; what is none of these may be
  /// that all together.
  bool put_down(const std::vector<Part>& parts, CertifiedLink& link) const {
    numeric number = 1;
    ex rest = 1;
    for (const auto& [part, n] : parts)
      if (is_a<numeric>(part))
        number *= ex_to<numeric>(part).power(n);
      else if (sign_of(part, q.symbols) != 0)
        link.factor.emplace_back(tree(form(part)), n.to_int());
      else if (!put_down_divisor(part, n.to_int(), number, link) && !put_down_sum(part, n.to_int(), link))
        rest *= GiNaC::pow(part, n);
    if (!rest.is_equal(1) && !put_down_divisor(rest, 1, number, link) && !put_down_sum(rest, 1, link))
      return false;
    if (number != 1) link.factor.emplace_back(tree(number), 1);
    return true;
  }
  /// part^n, if the part is 0 only where right (or left, for n < 0) is, for its square is that one's, or it
  /// is that square and more.
  bool put_down_sum(const ex& part, int n, CertifiedLink& link) const {
    const ex square = GiNaC::pow(n > 0 ? link.right : link.left, 2), more = (part - square).expand();
    const bool is_same = (GiNaC::pow(part, 2) - square).expand().is_zero();
    if (!is_same && !is_nonnegative(more, q.symbols)) return false;
    link.factor.emplace_back(tree(part), n);
    if (!is_same) link.more.emplace_back(tree(part), tree(form(more)));
    return true;
  }
  /// part^n, if that is a divisor or has the same square as one, but for parts of one sign.
  bool put_down_divisor(const ex& part, int n, numeric& number, CertifiedLink& link) const {
    for (const CertifiedDivisor& d : divisors)
      for (const int exponent : {1, -1}) {
        if (vanishes(GiNaC::pow(part, 2) - GiNaC::pow(d.value, 2), q.symbols))
          return link.factor.emplace_back(tree(part), n), true;
        const auto parts = quotient(part, GiNaC::pow(d.value, exponent), q.symbols, Way::real_denominator);
        const auto is_clear = [&](const Part& p) {
          return is_a<numeric>(p.first) || sign_of(p.first, q.symbols) != 0;
        };
        if (!parts || !std::all_of(parts->begin(), parts->end(), is_clear)) continue;
        link.factor.emplace_back(d.tree, n * exponent);
        for (const auto& [other, k] : *parts)
          if (is_a<numeric>(other))
            number *= ex_to<numeric>(other).power(k * n);
          else
            link.factor.emplace_back(tree(form(other)), k.to_int() * n);
        return true;
      }
    return false;
  }
  bool find_factor(CertifiedLink& link, const std::string& op) const {
    std::vector<ex> values;
    for (const CertifiedDivisor& d : divisors) values.push_back(d.value);
    const ex &left = link.left, &right = link.right;
    for (const Way way : all_ways) {
      try {
        const auto parts = quotient(left, right, q.symbols, way);
        if (!parts) continue;
        const Quotient factor = assess(*parts, values, q.symbols);
        link.factor.clear(), link.more.clear();
        const bool fits =
            !factor.value.is_zero() && (factor.zeros.empty() || op == "=") && (op == "=" || factor.sign > 0);
        if (fits && vanishes(left - factor.value * right, q.symbols) && put_down(*parts, link)) return true;
      } catch (const Undecidable&) {  // then another way
      }
    }
    return false;
  }

  // ---- relations

  static ex residual(const Sides& s) { return s.op[0] == '<' ? s.right - s.left : s.left - s.right; }
  Sides sides(const Relation& relation) const {
    return {put_in(lower(relation.sides[0], q.symbols), q.given), relation.operators[0],
            put_in(lower(relation.sides[1], q.symbols), q.given)};
  }
  static std::string kind(const std::string& op) { return op[0] == '<' ? ">" + op.substr(1) : op; }

  CertifiedLink find(const Relation& left, const Relation& right) const {
    const Sides l = sides(left), r = sides(right);
    const std::string op = kind(l.op), other = kind(r.op);
    CertifiedLink plain, inner;
    plain.left = residual(l), plain.right = residual(r);
    inner.left = residual(unwrapped(l, q.symbols, &inner.left_layers));
    inner.right = residual(unwrapped(r, q.symbols, &inner.right_layers));
    for (CertifiedLink link : {inner, plain}) {
      if (op == other && find_factor(link, op)) return link;
      if (settle(link, op, other)) return link;
    }
    throw Undecidable("no factor without zeros was found");
  }
};

/// The k-th link of a chain: K = a = b says K = b, too.
Relation link_of(const Relation& chain, std::size_t k) {
  const bool is_first = chain.operators[0] == "=" && chain.operators[k] == "=";
  return {{chain.sides[is_first ? 0 : k], chain.sides[k + 1]}, {chain.operators[k]}};
}

}  // namespace

std::vector<CertifiedDivisor> divisors_of(const CertifiedStatement& q) {
  std::vector<CertifiedDivisor> found, different;
  for (const Relation* relation : {&q.left, &q.right})
    for (const Tree& side : relation->sides) collect_divisors(side, q, found);
  for (const Given& g : q.given) collect_divisors(to_tree(g.value, q.symbols), q, found);
  for (const CertifiedDivisor& d : found)
    if (std::none_of(different.begin(), different.end(),
                     [&](const CertifiedDivisor& e) { return e.value.is_equal(d.value); }))
      different.push_back(d);
  return different;
}

std::vector<CertifiedLink> links_of(const CertifiedStatement& q) {
  if (prove(q.left, q.right, q.symbols, q.given).verdict != Verdict::proved) throw Undecidable("not proved");
  if (q.left.operators.empty()) {
    CertifiedLink link;
    link.left = put_in(lower(q.left.sides[0], q.symbols), q.given);
    link.right = put_in(lower(q.right.sides[0], q.symbols), q.given);
    return {link};
  }
  const std::vector<CertifiedDivisor> divisors = divisors_of(q);
  std::vector<CertifiedLink> links;
  for (std::size_t k = 0; k < q.left.operators.size(); ++k)
    links.push_back(Finder{q, divisors}.find(link_of(q.left, k), q.right));
  return links;
}

}  // namespace rederive
