// The sign of an expression over the declared ranges: what its range shows, or that of another form of it.
#include <cstdlib>
#include <derivations/algebra/forms.hpp>
#include <derivations/algebra/quick_value.hpp>
#include <derivations/algebra/rearrange.hpp>
#include <derivations/algebra/sample.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>

namespace rederive {

using GiNaC::ex;

namespace {

/// 2 or -2 for a positive or a negative range, 1 or -1 where 0 may be in it, 0 where nothing is known.
int shown_sign(const Interval& i) {
  try {
    const auto low = i.low.infinite == 0 ? compare(i.low.value, 0) : -1;
    if (low > 0 || (low == 0 && !i.low.closed)) return 2;
    const auto high = i.high.infinite == 0 ? compare(i.high.value, 0) : 1;
    if (high < 0 || (high == 0 && !i.high.closed)) return -2;
    return low == 0 ? 1 : high == 0 ? -1 : 0;
  } catch (const std::exception&) {  // too close to tell
    return 0;
  }
}

/// Of the expression as it stands, with a square completed, or in another form.
int find_sign(const ex& e, const Symbols& symbols);

/// The same, remembered.
int sign(const ex& e, const Symbols& symbols) {
  return remembered(symbols.findings().signs, e, [&] { return find_sign(e, symbols); });
}

/// Whether both signs are seen at some points, as far as double precision tells: then no form shows one.
bool seems_to_change(const ex& e, const Symbols& symbols) {
  constexpr int most = 8;
  const Tree tree = to_tree(e, symbols);
  const Points points = points_for(std::vector<Tree>{tree}, symbols);
  bool is_seen[2] = {false, false};
  for (int k = 0; k < most && !(is_seen[0] && is_seen[1]); ++k)
    if (const auto value = quick_value(tree, points.at(k))) is_seen[*value > 0 ? 1 : 0] = true;
  return is_seen[0] && is_seen[1];
}

int find_sign(const ex& e, const Symbols& symbols) {
  if (!has_symbol(e)) return shown_sign({{e, 0, true}, {e, 0, true}});
  const int plain = shown_sign(interval_of(e, symbols));
  if (std::abs(plain) == 2) return plain;
  if (plain == 0 && seems_to_change(e, symbols)) return 0;
  if (GiNaC::is_a<GiNaC::power>(e) && sign_of(e.op(0), symbols) > 0) return 2;
  const auto quadratic = as_quadratic(e, symbols);
  if (quadratic && !quadratic->b.is_zero()) {
    const int rest = sign(quadratic->discriminant(), symbols), leading = sign_of(quadratic->a, symbols);
    if (rest > 0 && leading != 0) return rest * leading;
  }
  const auto form = form_of_one_sign(e, symbols);
  const int other = form ? shown_sign(interval_of(*form, symbols)) : 0;
  return other != 0 ? other : plain;
}

}  // namespace

int sign_of(const ex& expression, const Symbols& symbols) { return sign(expression, symbols) / 2; }

bool is_nonnegative(const ex& expression, const Symbols& symbols) { return sign(expression, symbols) > 0; }

}  // namespace rederive
