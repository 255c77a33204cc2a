#include <algorithm>
#include <derivations/algebra/elimination.hpp>
#include <derivations/algebra/forms.hpp>
#include <derivations/algebra/phases.hpp>
#include <derivations/algebra/quotient.hpp>
#include <derivations/algebra/rearrange.hpp>
#include <derivations/algebra/vanish.hpp>
#include <lessons/ledger/certificate_forms.hpp>

namespace rederive {

using GiNaC::ex;
using GiNaC::is_a;

namespace {

/// f(1 - x/y), of which the range shows more than that of f((y - x)/y).
ex with_open_arguments(const ex& e) {
  struct : GiNaC::map_function {
    ex operator()(const ex& part) override {
      const ex inner = part.map(*this);
      return is_a<GiNaC::function>(inner) && has_symbol(inner.op(0).denom())
                 ? GiNaC::function(GiNaC::ex_to<GiNaC::function>(inner).get_serial(), inner.op(0).expand())
                 : inner;
    }
  } open;
  return open(e);
}

/// a (x + b/(2a))², as n (s x + b/(2ns))² for a = n s² where that divides by nothing: (x y - 1/2)².
ex square_in(const Quadratic& quadratic) {
  const auto& [x, a, b, c] = quadratic;
  ex s = 1;
  for (const ex& f : is_a<GiNaC::mul>(a) ? a : ex(GiNaC::lst{a}))
    if (is_a<GiNaC::power>(f) && f.op(1).info(GiNaC::info_flags::even)) s *= GiNaC::pow(f.op(0), f.op(1) / 2);
  const ex n = a / GiNaC::pow(s, 2), rest = (b / (2 * n * s)).normal();
  const bool divides = has_symbol(n) || has_symbol(rest.denom());
  return divides ? a * GiNaC::pow(x + b / (2 * a), 2) : n * GiNaC::pow(s * x + rest, 2);
}

}  // namespace

std::optional<ex> Forms::plain_words(const ex& e) const {
  constexpr std::size_t most = 40;
  std::vector<ex> ways{e};
  for (std::size_t k = 0; k < ways.size(); ++k) {
    for (const ex& way : {with_open_arguments(ways[k]), ways[k]})
      if (shows_sign_in(way, q.ranges)) return way;
    for (const auto& [symbol, words] : q.symbols.otherwise())
      for (const bool expands : {false, true}) {
        ex way = ways[k].subs(symbol == words, GiNaC::subs_options::no_pattern);
        if (expands) way = way.expand();
        const bool is_new =
            std::none_of(ways.begin(), ways.end(), [&](const ex& w) { return w.is_equal(way); });
        if (is_new && ways.size() < most) ways.push_back(way);
      }
  }
  return std::nullopt;
}

Tree Forms::tree(const ex& e) const { return to_tree(words(e), q.symbols); }

ex Forms::words(const ex& e) const {
  if (const auto plain = plain_words(e)) return *plain;
  if (is_a<GiNaC::mul>(e)) {
    ex product = 1;
    for (const ex& f : e) product *= words(f);
    return product;
  }
  return shortest(e);
}

ex Forms::shortest(const ex& e) const {
  ex shorter = e;
  for (const auto& [symbol, words] : q.symbols.otherwise())
    if (const ex other = shorter.subs(symbol == words, GiNaC::subs_options::no_pattern);
        names_in(other).size() < names_in(shorter).size())
      shorter = other;
  return shorter;
}

bool Forms::shows_sign_in(const ex& e, const Symbols& symbols) const {
  const Interval i = interval_of(e, symbols);
  const bool may_be_zero = sign_of(e, q.symbols) == 0;
  const auto is_beyond = [&](const End& end, int side) {
    const int place = end.infinite != 0 ? -1 : side * compare(end.value, 0);
    return place > 0 || (place == 0 && (may_be_zero || !end.closed));
  };
  try {
    return is_beyond(i.low, 1) || is_beyond(i.high, -1);
  } catch (const std::domain_error&) {  // too close to tell
    return false;
  }
}

Symbols Forms::without_ends(const ex& name) const {
  Symbols open = q.symbols;
  const Range range = read_range(open.find(name)->range);
  open.narrow(open.find(name)->name, "(" + range.lower + ", " + range.upper + ")");
  return open;
}

std::optional<ex> Forms::form_inside(const Slope& slope) const {
  const Symbols open = without_ends(slope.in);
  const auto form = rederive::form_of_one_sign(slope.value, open);
  return form && shows_sign_in(*form, open) ? form : std::nullopt;
}

bool Forms::has_terms_of_one_sign(const ex& e) const {
  const auto all = [&](int sign) {
    return std::all_of(e.begin(), e.end(), [&](const ex& t) { return is_nonnegative(sign * t, q.symbols); });
  };
  return is_a<GiNaC::add>(e) && (all(1) || all(-1));
}

ex Forms::form(const ex& e) const {
  if (has_terms_of_one_sign(e) || (!q.symbols.otherwise().empty() && plain_words(e))) return e;
  if (const auto other = rederive::form_of_one_sign(e, q.symbols); other && !is_a<GiNaC::add>(*other))
    return *other;
  if (shows_sign(e)) return e;
  if (is_a<GiNaC::power>(e)) return GiNaC::pow(form(e.op(0)), e.op(1));
  if (is_a<GiNaC::mul>(e)) {
    ex product = 1;
    for (const ex& f : e) product *= form(f);
    return product;
  }
  const auto quadratic = as_quadratic(e, q.symbols);
  if (quadratic && !quadratic->b.is_zero() && is_nonnegative(quadratic->discriminant(), q.symbols))
    return square_in(*quadratic) + form((quadratic->discriminant() / (4 * quadratic->a)).normal());
  return rederive::form_of_one_sign(e, q.symbols).value_or(e);
}

std::optional<ex> Forms::form_of_one_sign(const ex& e) const {
  if (e.is_zero() || is_nonnegative(e, q.symbols) || is_nonnegative(-e, q.symbols)) return form(e);
  if (const ex other = prepare(e, q.symbols); !shows_sign(e) && shows_sign(other)) return other;
  if (const auto slope = sign_by_slope(e, q.symbols)) {
    if (slope->how != Slope::How::range) return with_exponents_together(e);
    for (const ex& way : {e, form(slope->value)})
      if (shows_sign_in(way, without_ends(slope->in))) return way;
    if (form_inside(*slope)) return e;
  }
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

std::optional<CertifiedFactor> Forms::parts_of_one_sign(const ex& e) const {
  const auto parts = checked_quotient(e, 1, q.symbols);
  if (!parts) return std::nullopt;
  CertifiedFactor factor;
  for (const auto& [part, n] : *parts) {
    const bool is_seen = n.is_even() || is_nonnegative(part, q.symbols) || is_nonnegative(-part, q.symbols);
    if (!is_seen && !sign_by_slope(part, q.symbols)) return std::nullopt;
    factor.emplace_back(is_seen ? tree(form(part)) : to_tree(part, q.symbols), n.to_int());
  }
  return factor;
}

void Forms::add_slopes(const Tree& tree, const Slope& why, std::vector<CertifiedSlope>& slopes) const {
  if (why.how == Slope::How::range) return;
  const Slope& slope = why.slope.front();
  const bool is_shown = slope.how == Slope::How::range;
  const Tree shown = is_shown ? this->tree(form(slope.value)) : to_tree(slope.value, q.symbols);
  CertifiedSlope certified{tree, shown, why};
  if (why.how == Slope::How::ends) certified.slope = to_tree(why.between, q.symbols), certified.bend = shown;
  if (!why.by.is_equal(1)) certified.by = this->tree(why.by);
  if (names_in(why.value).size() > 1 && why.how != Slope::How::grows) add_ends(certified, slopes);
  slopes.push_back(certified);
  add_slopes(shown, slope, slopes);
}

void Forms::add_ends(CertifiedSlope& slope, std::vector<CertifiedSlope>& slopes) const {
  const Interval range = parse_range(q.symbols.find(slope.why.in)->range);
  const auto value_at = [&](const End& end) {
    const ex value = slope.why.value.subs(slope.why.in == end.value).expand();
    const ex as_written = lower(slope.value, q.symbols).subs(slope.why.in == end.value);
    slope.put_in.push_back(to_tree(as_written, q.symbols));
    const Tree written = to_tree(vanishes(value, q.symbols) ? ex(0) : form(value), q.symbols);
    add_slopes(written, slopes);
    return written;
  };
  if (slope.why.how != Slope::How::high) slope.at_low = value_at(range.low);
  if (slope.why.how != Slope::How::low) slope.at_high = value_at(range.high);
}

void Forms::add_slopes(const Tree& tree, std::vector<CertifiedSlope>& slopes) const {
  const ex value = tree ? lower(tree, q.symbols) : ex(0);
  if (sign_of(value, q.symbols) != 0) return;
  const auto why = sign_by_slope(value, q.symbols);
  if (why && why->how == Slope::How::range) {
    const auto other = shows_sign_in(value, without_ends(why->in)) ? std::nullopt : form_inside(*why);
    slopes.push_back({tree, other ? to_tree(*other, q.symbols) : tree, *why});
  }
  if (why) add_slopes(tree, *why, slopes);
}

CertifiedLink Forms::with_slopes(CertifiedLink link) const {
  for (const CertifiedPart& p : link.factor) add_slopes(p.part, link.slopes);
  for (const auto& [part, places] : link.zeros)
    for (const auto& place : places)
      if (place.power == 0)
        add_slopes(part, *growth_by_slope(lower(part, q.symbols), q.symbols[place.name], q.symbols),
                   link.slopes);
  const auto add_growth = [&](const Layer& layer) {
    if (layer.function.ends_with("of"))
      add_slopes(to_tree(layer.of, q.symbols), *growth_by_slope(layer.of, layer.in, q.symbols), link.slopes);
  };
  for (const CertifiedSide& side : {link.left, link.right}) {
    add_slopes(side.form, link.slopes);
    for (const CertifiedPart& p : side.parts) add_slopes(p.part, link.slopes);
    for (const auto& layers : side.layers)
      for (const CertifiedLayer& written : layers) {
        add_growth(written.layer);
        for (const CertifiedPart& p : written.factor) add_slopes(p.part, link.slopes);
      }
  }
  return link;
}

}  // namespace rederive
