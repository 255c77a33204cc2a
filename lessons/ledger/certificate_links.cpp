#include <algorithm>
#include <derivations/algebra/conjunction.hpp>
#include <derivations/algebra/elimination.hpp>
#include <derivations/algebra/in_square.hpp>
#include <derivations/algebra/print.hpp>
#include <derivations/algebra/quotient.hpp>
#include <derivations/algebra/rearrange.hpp>
#include <derivations/algebra/solutions.hpp>
#include <derivations/algebra/vanish.hpp>
#include <lessons/ledger/certificate_forms.hpp>

namespace rederive {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

namespace {

/// With exp(log(x)), or sqrt(x)^2, for every x whose range the domain narrows so.
Tree with_functions(const Tree& tree, const Symbols& symbols, const Symbols& domain) {
  if (tree->kind == Node::Kind::symbol) {
    const Symbol *whole = symbols.find(tree->text), *narrow = domain.find(tree->text);
    if (whole == nullptr || whole->range == narrow->range) return tree;
    const bool is_log = narrow->range[0] == '(';
    return parse((is_log ? "exp(log(" : "(sqrt(") + tree->text + (is_log ? "))" : ")^2)"), symbols);
  }
  auto copy = std::make_shared<Node>(*tree);
  for (Tree& child : copy->children) child = with_functions(child, symbols, domain);
  return copy;
}

/// Whether it divides by anything but numbers, under a root, say.
bool divides(const ex& e) {
  return std::any_of(e.preorder_begin(), e.preorder_end(), [](const ex& part) {
    return is_a<GiNaC::power>(part) && part.op(1).info(GiNaC::info_flags::negative) && has_symbol(part.op(0));
  });
}

/// Finds what makes one link hold.
struct Finder : Forms {
  using Forms::shows_sign;
  const std::vector<CertifiedDivisor>& divisors;
  const Question question{q.left, q.right, q.symbols, q.given};

  /// Of one side alone; `op` as residuals have it.
  std::optional<CertifiedLink> settle(CertifiedSide side, const std::string& op, bool is_left) const {
    const auto holds = settled(side.residual, claim_of(op), q.symbols);
    if (!holds) return std::nullopt;
    const auto form = *holds && op == "=" ? ex(0) : form_of_one_sign(side.residual);
    const auto parts = form ? CertifiedFactor{} : parts_of_one_sign(side.residual);
    const auto square = form || parts || !*holds ? std::nullopt : shown_in_square(side.residual, q.symbols);
    if (!form && !parts && !square) return std::nullopt;
    if (square) {
      for (const ex& root : square->roots) side.roots.push_back(tree(root));
      side.form = tree(form_of_one_sign(square->rest).value_or(square->rest));
    }
    if (form) side.form = sign_by_slope(*form, q.symbols) ? to_tree(*form, q.symbols) : tree(*form);
    if (parts) side.parts = *parts;
    CertifiedLink link;
    (is_left ? link.left : link.right) = side, link.holds = holds;
    return link;
  }

  // ---- factors

  /// With sin(x)^6 as sin(x) six times, and sqrt(1/u) to the power -n in place of sqrt(u) to the power n,
  /// where u divides by what the statement does not divide by.
  std::vector<Part> tidy(std::vector<Part> parts) const {
    const auto is_allowed = [&](const ex& below) {
      const auto is_it = [&](const CertifiedDivisor& d) { return !has_symbol((d.value / below).normal()); };
      return sign_of(below, q.symbols) != 0 || std::any_of(divisors.begin(), divisors.end(), is_it);
    };
    for (auto& [part, n] : parts) {
      if (!is_a<GiNaC::power>(part) || !part.op(1).info(GiNaC::info_flags::rational)) continue;
      const numeric k = ex_to<numeric>(part.op(1));
      if (k.is_integer() && sign_of(part.op(0), q.symbols) == 0)
        part = part.op(0), n = n * k;
      else if (k.is_negative())
        part = 1 / part, n = -n;
      if (!k.is_integer() && !is_allowed(part.op(0).denom()))
        part = GiNaC::pow(1 / part.op(0), part.op(1)), n = -n;
    }
    return parts;
  }
  /// Every part is a number, has one sign, or is what the statement divides by; what is none of these may be
  /// that all together, or 0 with one of the residuals of the link, if there is one.
  bool put_down(const std::vector<Part>& parts, CertifiedFactor& factor, CertifiedLink* link) const {
    numeric number = 1;
    ex rest = 1;
    const auto is_put_down = [&](const ex& part, int n) {
      return put_down_divisor(part, n, number, factor) || put_down_square(part, n, factor) ||
             (link != nullptr && put_down_sum(part, n, *link));
    };
    for (const auto& [part, n] : tidy(parts))
      if (is_a<numeric>(part))
        number *= ex_to<numeric>(part).power(n);
      else if (sign_of(part, q.symbols) != 0)
        factor.emplace_back(tree(form(part)), n.to_int());
      else if (const auto slope = sign_by_slope(part, q.symbols); slope && slope->is_strict)
        factor.emplace_back(to_tree(part, q.symbols), n.to_int());
      else if (!is_put_down(part, n.to_int()))
        rest *= GiNaC::pow(part, n);
    if (!rest.is_equal(1) && !is_put_down(rest, 1)) return false;
    if (number != 1) factor.emplace_back(tree(number), 1);
    return true;
  }
  /// part^n, if the part is 0 only where right (or left, for n < 0) is, for its square is that one's, or it
  /// is that square, or a quarter of it, and more; or that one is the part times something.
  bool put_down_sum(const ex& part, int n, CertifiedLink& link) const {
    if (has_symbol(part.denom())) return false;
    const ex square = GiNaC::pow(n > 0 ? link.right.residual : link.left.residual, 2);
    const Tree written = tree(is_nonnegative(part, q.symbols) ? form(part) : part);
    if ((GiNaC::pow(part, 2) - square).expand().is_zero()) return link.factor.emplace_back(written, n), true;
    for (const int share : {1, 4}) {
      const ex more = (part - square / share).expand();
      if (!is_nonnegative(more, q.symbols)) continue;
      link.factor.emplace_back(written, n), link.more.emplace_back(written, tree(form(more)));
      return true;
    }
    if (put_down_bound(part, n, link) || put_down_zero(part, n, link)) return true;
    const auto other = other_factor(part, n > 0 ? link.right.residual : link.left.residual, divisors);
    if (!other) return false;
    link.factor.emplace_back(written, n), link.divides.emplace_back(written, tree(*other));
    return true;
  }
  /// part^n, if the part is 0 only where right (or left) is, or what the statement divides by, for some
  /// symbols have certain values there.
  bool put_down_zero(const ex& part, int n, CertifiedLink& link) const {
    std::vector<ex> others{n > 0 ? link.right.residual : link.left.residual};
    for (const CertifiedDivisor& d : divisors) others.push_back(d.value);
    const auto is_zero_there = [&](const GiNaC::exmap& zero) {
      return std::any_of(others.begin(), others.end(), [&](const ex& other) {
        try {
          return vanishes(other.subs(zero), q.symbols);
        } catch (const std::exception&) {  // it has no value there, or is outside of the class
          return false;
        }
      });
    };
    if (const auto place = zero_of_growth(part); place && is_zero_there({*place})) {
      const auto& [symbol, at] = *place;
      const Tree written = to_tree(part, q.symbols);
      link.factor.emplace_back(written, n);
      link.zeros.push_back({written, {{ex_to<GiNaC::symbol>(symbol).get_name(), to_tree(at, q.symbols)}}});
      return true;
    }
    const auto zero = only_zero(part, q.symbols);
    if (!zero || !is_zero_there(*zero)) return false;
    CertifiedZero found{to_tree(part, q.symbols), {}};
    for (const auto& [symbol, at] : *zero) {
      const ex size = is_a<GiNaC::function>(part) ? GiNaC::pow(part, 2).expand() : part;  // of fabs(x)
      const auto power = part.is_equal(symbol) ? std::optional(EvenPower{1, 1, 0})
                                               : even_power_in(size, symbol, at, q.symbols);
      if (!power) return false;
      const ex more = power->more.is_zero() ? power->more : form(power->more);
      found.places.push_back({ex_to<GiNaC::symbol>(symbol).get_name(), to_tree(at, q.symbols),
                              power->exponent, to_tree(power->share, q.symbols), tree(more)});
    }
    std::sort(found.places.begin(), found.places.end(),
              [](const auto& a, const auto& b) { return a.name < b.name; });
    link.factor.emplace_back(found.part, n), link.zeros.push_back(found);
    return true;
  }
  /// Where a part of one symbol is 0, if it grows or falls with that all over its range.
  std::optional<std::pair<ex, ex>> zero_of_growth(const ex& part) const {
    const auto names = names_in(part);
    if (names.size() != 1 || is_a<GiNaC::symbol>(part)) return std::nullopt;
    const ex& symbol = q.symbols[*names.begin()];
    const auto values = solutions(part, q.symbols);
    if (!values || values->size() != 1 || !growth_by_slope(part, symbol, q.symbols)) return std::nullopt;
    return std::pair{symbol, values->front()};
  }
  /// part^n, if a few times the part are not less than right (or left), and that is not negative.
  bool put_down_bound(const ex& part, int n, CertifiedLink& link) const {
    const ex residual = n > 0 ? link.right.residual : link.left.residual;
    if (has_symbol(residual.denom()) || !is_nonnegative(residual, q.symbols)) return false;
    for (const int times : {1, 2, 3, 4, 8}) {
      const ex more = (times * part - residual).expand();
      if (!more.is_zero() && !is_nonnegative(more, q.symbols)) continue;
      link.factor.emplace_back(tree(form(part)), n);
      link.bounds.push_back({link.factor.back().part, times, tree(form(residual)), tree(form(more))});
      return true;
    }
    return false;
  }
  /// part^n, if that is a divisor or has the same square as one, but for parts of one sign.
  bool put_down_divisor(const ex& part, int n, numeric& number, CertifiedFactor& factor) const {
    const auto names = names_in(part);  // what has more of them is 0 elsewhere, too
    const auto has_them = [&](const CertifiedDivisor& d) {
      const auto others = names_in(d.value);
      return std::includes(others.begin(), others.end(), names.begin(), names.end());
    };
    if (std::none_of(divisors.begin(), divisors.end(), has_them)) return false;
    const bool has_sign = is_nonnegative(part, q.symbols) || is_nonnegative(-part, q.symbols);
    const Tree written = tree(has_sign ? form(part) : part);
    for (const CertifiedDivisor& d : divisors)
      for (const int exponent : {1, -1}) {
        if (vanishes(GiNaC::pow(part, 2) - GiNaC::pow(d.value, 2), q.symbols))
          return factor.emplace_back(written, n), true;
        const auto parts = quotient(part, GiNaC::pow(d.value, exponent), q.symbols, Way::real_denominator);
        const auto is_clear = [&](const Part& p) {
          return is_a<numeric>(p.first) || sign_of(p.first, q.symbols) != 0;
        };
        if (!parts || !std::all_of(parts->begin(), parts->end(), is_clear)) continue;
        factor.emplace_back(d.tree, n * exponent);
        for (const auto& [other, k] : *parts)
          if (is_a<numeric>(other))
            number *= ex_to<numeric>(other).power(k * n);
          else
            factor.emplace_back(tree(form(other)), k.to_int() * n);
        return true;
      }
    for (const CertifiedDivisor& d : divisors)
      if (const auto other = other_factor(part, d.value, divisors))
        return factor.emplace_back(written, n, tree(*other)), true;
    return false;
  }
  /// part^n, if it is the square of something that the statement divides by, or that is assumed not to be 0,
  /// or a half or a quarter of that square, and more that is not negative.
  bool put_down_square(const ex& part, int n, CertifiedFactor& factor) const {
    for (const CertifiedDivisor& d : divisors)
      for (const int share : {1, 2, 4}) {
        const ex more = (part - GiNaC::pow(d.value, 2) / share).expand();
        if (!is_nonnegative(more, q.symbols)) continue;
        factor.push_back({tree(form(part)), n, nullptr, d.tree, tree(form(more))});
        return true;
      }
    return false;
  }
  /// value/part, if that divides by nothing but what is allowed.
  std::optional<ex> other_factor(const ex& part, const ex& value,
                                 const std::vector<CertifiedDivisor>& allowed) const {
    if (has_symbol(part.denom())) return std::nullopt;
    const ex simple = (value / part).normal();
    if (!divides(simple)) return simple;
    if (is_a<GiNaC::power>(part) && part.op(1).info(GiNaC::info_flags::positive))  // of a root of the value
      if (const ex rest = (value / part.op(0)).normal(); !divides(rest))
        return rest * GiNaC::pow(part.op(0), 1 - part.op(1));
    const auto parts = checked_quotient(value, part, q.symbols);
    if (!parts) return std::nullopt;
    ex product = 1;
    for (const auto& [p, k] : *parts) {
      const auto is_it = [&, square = GiNaC::pow(p, 2)](const CertifiedDivisor& d) {
        return !has_symbol((d.value / p).normal()) || vanishes(square - GiNaC::pow(d.value, 2), q.symbols);
      };
      if (k.is_negative() && !is_a<numeric>(p) && std::none_of(allowed.begin(), allowed.end(), is_it))
        return std::nullopt;
      product *= GiNaC::pow(p, k);
    }
    return product;
  }
  /// Of all that is not squared.
  bool shows_sign(const CertifiedFactor& factor) const {
    return std::all_of(factor.begin(), factor.end(), [&](const CertifiedPart& p) {
      const ex value = put_in(lower(p.part, q.symbols), q.given);
      return p.exponent % 2 == 0 || sign_of(value, q.symbols) != 0 || shows_sign(value) ||
             sign_by_slope(value, q.symbols);
    });
  }
  static void forget(CertifiedLink& link) {
    link.factor.clear(), link.more.clear(), link.bounds.clear(), link.divides.clear(), link.zeros.clear();
  }
  bool find_factor(CertifiedLink& link, const std::string& op) const {
    std::vector<ex> values;
    for (const CertifiedDivisor& d : divisors) values.push_back(d.value);
    const ex &left = link.left.residual, &right = link.right.residual;
    for (const Way way : all_ways) {
      try {
        const auto parts = quotient(left, right, q.symbols, way);
        if (!parts) continue;
        const Quotient factor = assess(*parts, values, q.symbols);
        forget(link);
        const bool fits = !factor.value.is_zero() && (op == "=" || factor.sign > 0);
        if (fits && vanishes(left - factor.value * right, q.symbols) &&
            put_down(*parts, link.factor, &link) && (op == "=" || shows_sign(link.factor)))
          return true;
      } catch (const Undecidable&) {  // then another way
      }
    }
    forget(link);
    const numeric number = number_between(left, right, q.symbols).value_or(1);
    if (number != 1) link.factor.emplace_back(tree(number), 1);
    return (op == "=" || number.is_positive()) && vanishes(left - number * right, q.symbols);
  }

  // ---- relations

  /// The factor of "*", so written that it is seen never to be 0.
  std::optional<CertifiedFactor> put_down(const ex& value) const {
    CertifiedFactor factor;
    const auto parts = checked_quotient(value, 1, q.symbols);
    if (parts && put_down(*parts, factor, nullptr)) return factor;
    if (sign_of(value, q.symbols) == 0) return std::nullopt;
    return CertifiedFactor{{tree(form(value)), 1}};
  }
  /// What was taken off such sides. That x is positive beside log(x) is seen of exp(log(x)).
  std::optional<std::vector<CertifiedLayer>> put_down(const std::vector<Layer>& layers, Sides sides) const {
    std::vector<CertifiedLayer> result;
    for (const Layer& layer : layers) {
      const Symbols domain = narrowed_by_functions(sides, q.symbols);
      const CertifiedStatement there{q.left, q.right, domain, q.given, q.equal, q.ranges};
      auto factor = layer.function == "*" ? Finder{Forms(there), divisors}.put_down(layer.factor)
                                          : std::optional(CertifiedFactor{});
      if (!factor) return std::nullopt;
      for (CertifiedPart& p : *factor) p.part = with_functions(p.part, q.symbols, domain);
      result.push_back({layer, *factor});
      sides = {layer.left, "", layer.right};
    }
    return result;
  }

  /// How the sides of a link are taken.
  enum class Taken { as_they_stand, unwrapped, squared };

  /// Links of one statement; and "=", ">" or ">=".
  std::optional<std::pair<CertifiedSide, std::string>> side(const Relation& relation,
                                                            const std::vector<std::size_t>& numbers,
                                                            Taken taken) const {
    CertifiedSide result{numbers, {}, 1};
    std::string op;
    ex sum = 0;
    for (const std::size_t k : numbers) {
      Sides s = sides_of(rederive::links_of(relation)[k], question);
      std::vector<Layer> layers;
      if (taken != Taken::as_they_stand) s = unwrapped(s, q.symbols, &layers);
      const auto squares = taken == Taken::squared ? squared(s, q.symbols, &layers) : s;
      if (!squares) return std::nullopt;
      s = *squares;
      op = s.op[0] == '<' ? ">" + s.op.substr(1) : s.op;
      const auto written = put_down(layers, sides_of(rederive::links_of(relation)[k], question));
      if (!written) return std::nullopt;
      result.layers.push_back(*written);
      result.residual *= residual_of(s), sum += residual_of(s);
    }
    if (numbers.size() > 1) {
      const auto form = form_of_one_sign(sum.expand());
      if (!form) return std::nullopt;
      result.sum = tree(*form);
    }
    return std::pair{result, op};
  }

  bool is_high(const Relation& relation, const std::vector<std::size_t>& numbers) const {
    return std::any_of(numbers.begin(), numbers.end(), [&](std::size_t k) {
      return has_high_power(residual_of(sides_of(rederive::links_of(relation)[k], question)));
    });
  }
  /// Whether a factor has arcs, or logarithms, that the statement has not: atan(u) - atan(v) as one of them.
  bool has_new_arcs(const CertifiedFactor& factor) const {
    std::set<std::string> known;
    for (const Relation* relation : {&q.left, &q.right})
      for (const Tree& side : relation->sides) collect_arcs(side, known);
    std::set<std::string> all = known;
    for (const CertifiedPart& p : factor) collect_arcs(p.part, all);
    return all.size() > known.size();
  }
  void collect_arcs(const Tree& tree, std::set<std::string>& texts) const {
    if (tree->kind == Node::Kind::call && (tree->text[0] == 'a' || tree->text == "log"))
      texts.insert(print(lower(tree, q.symbols), Notation::plain, q.symbols));
    for (const Tree& child : tree->children) collect_arcs(child, texts);
  }
  std::optional<CertifiedLink> find_same(const Match& match) const {
    std::vector<std::pair<Taken, Taken>> ways{{Taken::as_they_stand, Taken::as_they_stand},
                                              {Taken::unwrapped, Taken::unwrapped},
                                              {Taken::squared, Taken::unwrapped},
                                              {Taken::unwrapped, Taken::squared}};
    if (is_high(q.left, match.left) || is_high(q.right, match.right))
      std::rotate(ways.begin(), ways.begin() + 1, ways.end());
    std::optional<CertifiedLink> found;
    for (const auto& [of_left, of_right] : ways) {
      const auto left = side(q.left, match.left, of_left), right = side(q.right, match.right, of_right);
      if (!left || !right || left->second != right->second) continue;
      CertifiedLink link{left->first, right->first, {}, {}, {}};
      if (!find_factor(link, left->second)) continue;
      if (!has_new_arcs(link.factor)) return link;
      if (!found) found = link;
    }
    return found;
  }
  /// A link that always holds, or never.
  CertifiedLink find_settled(const std::vector<std::size_t>& number, bool is_left) const {
    std::optional<CertifiedLink> found;
    for (const Taken taken : {Taken::as_they_stand, Taken::unwrapped}) {
      const auto taken_so = side(is_left ? q.left : q.right, number, taken);
      const auto link = taken_so ? settle(taken_so->first, taken_so->second, is_left) : std::nullopt;
      if (!link) continue;
      const CertifiedSide& shown = is_left ? link->left : link->right;
      if (!shown.form || !has_new_arcs({{shown.form, 1}})) return *link;
      if (!found) found = link;
    }
    if (!found) throw Undecidable("no form shows that a link always holds, or never");
    return *found;
  }
  /// A link that follows from those of the other side.
  CertifiedLink find_consequence(const Match& match) const {
    const auto written = [&](const ex& e) { return tree(form_of_one_sign(e).value_or(e)); };
    CertifiedLink link;
    link.left.links = match.left, link.right.links = match.right;
    const Tree more = written(match.why->more), times = written(match.why->times);
    link.follows = {{}, more, times, match.why->squared};
    if (sign_of(match.why->times, q.symbols) == 0)  // of an inequality it may be 0
      link.follows->product = put_down(match.why->times).value_or(CertifiedFactor{});
    for (const auto& [factor, links] : match.why->terms)
      link.follows->terms.emplace_back(written(factor), links);
    return link;
  }
};

/// One relation against one.
bool is_pair(const CertifiedStatement& q) {
  return q.left.operators.size() == 1 && q.right.operators.size() == 1;
}

}  // namespace

std::vector<CertifiedLink> links_of(const CertifiedStatement& q) {
  if (prove(q.left, q.right, q.symbols, q.given).verdict != Verdict::proved) throw Undecidable("not proved");
  if (q.left.operators.empty()) {
    const auto side = [&](const Relation& expression) {
      return CertifiedSide{{0}, {{}}, put_in(lower(expression.sides[0], q.symbols), q.given)};
    };
    return {{side(q.left), side(q.right), {}, {}, {}}};
  }
  const std::vector<CertifiedDivisor> divisors = divisors_of(q);
  const Finder finder{Forms(q), divisors};
  if (const auto link = is_pair(q) ? finder.find_same({{0}, {0}}) : std::nullopt)
    return {finder.with_slopes(*link)};
  std::vector<CertifiedLink> links;
  for (const Match& match : matches(finder.question).value_or(std::vector<Match>{}))
    if (match.why) {
      links.push_back(finder.find_consequence(match));
    } else if (match.never || match.left.empty() || match.right.empty()) {
      if (!match.left.empty()) links.push_back(finder.find_settled(match.left, true));
      if (!match.right.empty()) links.push_back(finder.find_settled(match.right, false));
    } else {
      const auto link = finder.find_same(match);
      if (!link) throw Undecidable("no factor without zeros was found");
      links.push_back(*link);
    }
  if (links.empty()) throw Undecidable("nothing was found that says it link by link");
  for (CertifiedLink& link : links) link = finder.with_slopes(link);
  return links;
}

}  // namespace rederive
