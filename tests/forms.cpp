// Forms that show a sign are the same polynomial, whatever finds them; and what finds them does find them.
#include <doctest/doctest.h>

#include <derivations/algebra/binomial_squares.hpp>
#include <derivations/algebra/elimination.hpp>
#include <derivations/algebra/linear_program.hpp>
#include <derivations/algebra/positive.hpp>
#include <derivations/algebra/quotient.hpp>
#include <random>

using namespace rederive;
using cln::cl_RA;
using GiNaC::ex;

namespace {

Symbols symbols() {
  Symbols result = paper_symbols();
  for (const char* name : {"u", "v"}) result.declare(name, name, name, "1", "(0, inf)", "", "");
  for (const char* name : {"x", "y"}) result.declare(name, name, name, "1", "(-inf, inf)", "", "");
  return result;
}

bool is_same(const ex& form, const ex& polynomial) {
  return (form - polynomial).normal().numer().expand().is_zero();
}

}  // namespace

TEST_CASE("linear programs") {
  const auto solved = [](const std::vector<std::vector<cl_RA>>& columns, const std::vector<cl_RA>& sum,
                         const std::vector<cl_RA>& gains) {
    return largest_solution({columns, sum, gains});
  };
  using Parts = std::vector<cl_RA>;
  // x + y + s = 4, x + 3 y + t = 6: of 3 x + 5 y the largest value is 14, at x = 3, y = 1
  const std::vector<Parts> columns{{1, 1}, {1, 3}, {1, 0}, {0, 1}};
  CHECK(solved(columns, {4, 6}, {3, 5, 0, 0}) == Parts{3, 1, 0, 0});
  CHECK(solved(columns, {4, 6}, {0, 1, 0, 0}) == Parts{0, 2, 2, 0});
  CHECK(solved(columns, {-4, 6}, {1, 0, 0, 0}) == std::nullopt);
  CHECK(solved({{1, 1}}, {2, 2}, {0}) == Parts{2});  // one equation twice
  CHECK(solved({{1, 1}}, {2, 3}, {0}) == std::nullopt);
  CHECK(solved({{2}, {-3}}, {-1}, {0, 0}) == Parts{0, cl_RA(1) / 3});
  CHECK(solved({{1, -1}, {-1, 1}}, {0, 0}, {1, 1}).has_value());  // without bound
}

TEST_CASE("sums of squares of two terms are found, and are what they are said to be") {
  const Symbols all = symbols();
  const ex &u = all["u"], &v = all["v"], &x = all["x"], &y = all["y"];
  std::mt19937 random(20);
  const auto pick = [&](int least, int most) {
    return std::uniform_int_distribution<int>(least, most)(random);
  };
  int found = 0, above = 0;
  for (int round = 0; round < 60; ++round) {
    const bool is_positive = round % 2 == 0;
    const ex &a = is_positive ? u : x, &b = is_positive ? v : y;
    ex sum = pick(0, 1);
    for (int k = 0; k < 2; ++k) {
      const ex m = is_positive ? pow(a, pick(0, 1)) * pow(b, pick(0, 1)) : ex(1);
      sum += pick(1, 3) * m * pow(pow(a, pick(0, 1)) * b - pow(b, pick(0, 1)) * pow(a, pick(1, 2)), 2);
    }
    sum = sum.expand();
    const auto form = form_of_binomial_squares(sum, all);
    if (!GiNaC::is_a<GiNaC::add>(sum) || names_in(sum).size() < 2) continue;
    ++above;
    if (!form) continue;
    ++found;
    INFO(sum);
    INFO(*form);
    CHECK(is_same(*form, sum));
    CHECK(is_nonnegative(*form, all));
    const auto turned = form_of_binomial_squares((-sum).expand(), all);
    CHECK((turned && is_same(*turned, -sum) && is_nonnegative(-*turned, all)));
  }
  CHECK(above > 40);
  CHECK(found == above);
  CHECK_FALSE(form_of_binomial_squares(x * x + y * y - 3 * x * y, all));
  CHECK_FALSE(form_of_binomial_squares(x * x * x + y * y, all));
  CHECK(form_of_binomial_squares(u * u * u + v * v, all));
}

TEST_CASE("polynomials in one variable, with squares, near 0, and in multiples of a root") {
  const GiNaC::realsymbol t("t");
  const auto form = [&](const ex& p, const char* range) {
    return positive_form(p.expand(), t, parse_range(range));
  };
  for (const auto& [p, range] : {std::pair<ex, const char*>{pow(t - ex(1) / 3, 2) * (t + 2), "(-2, 5)"},
                                 {pow(t - ex(1) / 3, 2) * (t + 2) + ex(1) / 1000, "(-1, 1)"},
                                 {pow(t * t - 2, 2) + ex(1) / 100, "(-inf, inf)"},
                                 {pow(t * t - 3, 2), "(-inf, inf)"},
                                 {pow(t - 7, 4) + ex(1) / 100, "[0, inf)"},
                                 {pow(t, 3) - t + 2 / (3 * GiNaC::sqrt(ex(3))), "[0, inf)"},
                                 {1 - t, "(-inf, 1)"}}) {
    INFO(p);
    const auto found = form(p, range);
    REQUIRE(found);
    CHECK(is_same(*found, p));
  }
  CHECK_FALSE(form(pow(t - ex(1) / 3, 2) * (t + 2) - ex(1) / 1000, "(-1, 1)"));
  CHECK_FALSE(form(pow(t, 3) - t + ex(38) / 100, "[0, inf)"));
  CHECK_FALSE(form(1 - t, "(-inf, 2)"));
}

TEST_CASE("a root of a quotient is 0 where that is, and has a pole where what divides it is 0") {
  const Symbols known = symbols();
  const ex x = known["x"], root = GiNaC::sqrt(x / (x - 1));
  const auto exponent_of = [](const Quotient& q, const ex& e) {
    for (const auto& [part, n] : q.zeros)
      if (is_multiple(part, e)) return n.to_int();
    return 0;
  };
  const Quotient open = assess({{root, 1}}, {}, known), divided = assess({{root, 1}}, {x - 1}, known);
  CHECK(exponent_of(open, root) == 1);
  CHECK(exponent_of(open, x - 1) == -1);
  CHECK(exponent_of(divided, x - 1) == 0);
  CHECK(exponent_of(assess({{root, -2}}, {}, known), x - 1) == 2);
}
