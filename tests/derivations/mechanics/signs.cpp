// What can be proved about expressions without numbers: signs, zeros and roots.
#include <doctest/doctest.h>

#include <derivations/mechanics/signs.hpp>
#include <tests/derivations/mechanics/letters.hpp>

using namespace rederive::language;
using namespace rederive::mechanics;
using namespace rederive::test;
using GiNaC::ex;

namespace {

const SymbolExpression m = letter("m"), k = letter("k"), c = letter("c"), zeta = letter("zeta"),
                       x = letter("x", "(-inf, inf)"), y = letter("y", "(-inf, inf)"), L = letter("L"),
                       alpha = letter("alpha", "(0, pi/2)"), a = letter("a", "(0, L)");

}  // namespace

TEST_CASE("signs that follow from positive symbols") {
  CHECK(sign(k / m) == 1);
  CHECK(sign(-k * pow(x, 2) - m) == -1);
  CHECK(sign(pow(k + m, 2) - pow(k - m, 2)) == 1);
  CHECK(sign(pow(x - y, 2) + c) == 1);
  CHECK(sign(exp(x) + cosh(y)) == 1);
  CHECK(sign(sqrt(ex(3)) - 2) == -1);
  CHECK(sign(m + k - m * pow(cos(x), 2)) == 1);
  CHECK(sign(m * pow(sin(x), 2) + m * pow(cos(x), 2) - m) == 0);
}

TEST_CASE("a sign that changes, or that a square hides, is not claimed") {
  const std::vector<ex> unknown{x, k - m, x * y, pow(x, 2), pow(k - m, 2), alpha - 1, sin(x), x / m, sinh(x)};
  for (const ex& e : unknown) {
    CAPTURE(text_of(e));
    CHECK_FALSE(sign(e).has_value());
  }
}

TEST_CASE("declared relations decide") {
  CHECK(sign(pow(zeta, 2) - 1, {zeta < 1}) == -1);
  CHECK(sign(pow(zeta, 2) - 1, {zeta > 1}) == 1);
  CHECK(sign(pow(zeta, 2) - 1, {zeta == 1}) == 0);
  CHECK(sign(pow(c, 2) - 4 * k * m, {c == 2 * sqrt(k * m)}) == 0);
  CHECK(sign(x, {x <= 0}) == std::nullopt);
  CHECK(sign(x - 1, {x <= 0}) == -1);
  CHECK(sign(2 * L - x - y, {x < L, y < L}) == 1);
  CHECK(sign(x - y, {x - y}) == 1);
  CHECK_FALSE(sign(zeta - 1, {zeta < 2}).has_value());
  CHECK_FALSE(sign(x, {x != 0}).has_value());
}

TEST_CASE("declared ranges decide") {
  const Relations known = relations_of_ranges(letters());
  CHECK(sign(cos(alpha), known) == 1);
  CHECK(sign(sin(alpha), known) == 1);
  CHECK(sign(tan(alpha), known) == 1);
  CHECK(sign(pow(a, 2) - pow(L, 2), known) == -1);
  CHECK_FALSE(sign(cos(2 * alpha), known).has_value());
}

TEST_CASE("zeros are found behind roots, and behind sines and cosines") {
  const ex d = k * k + m;
  CHECK(vanishes(pow(k + sqrt(d), 2) - 2 * k * (k + sqrt(d)) - m));
  CHECK(vanishes(pow(sin(x), 4) - pow(cos(x), 4) + 2 * pow(cos(x), 2) - 1));
  CHECK(vanishes(pow(cosh(x), 2) - pow(sinh(x), 2) - 1));
  CHECK_FALSE(vanishes(x - y));
  CHECK(vanishes(x - y, {x == y}));
}

TEST_CASE("roots leave squares outside, by the sign of their bases") {
  CHECK(root_of(pow(k, 2) * (1 - pow(zeta, 2))).is_equal(k * sqrt(1 - pow(zeta, 2))));
  CHECK(root_of(pow(zeta - 1, 2), {zeta < 1}).is_equal(1 - zeta));
  CHECK(root_of(pow(x, 2)).is_equal(abs(x)));
  CHECK(root_of(k / m).is_equal(sqrt(k / m)));
  CHECK(root_of(ex(9) / 4).is_equal(ex(3) / 2));
  for (const ex& square : {4 * k / pow(m, 3), pow(k, 4) / 3, k + m, pow(k + m, 3) * pow(L, 2)})
    CHECK(same(pow(root_of(square), 2), square));
}
