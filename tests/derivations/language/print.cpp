#include <doctest/doctest.h>

#include <cstdio>
#include <derivations/numbers/evaluate.hpp>
#include <derivations/paper/ledger.hpp>
#include <random>
#include <tests/block.hpp>
#include <tests/run_program.hpp>

using namespace rederive;
using GiNaC::ex;
using GiNaC::numeric;

namespace {

constexpr unsigned seed = 1'687;

std::string canonical(const std::string& text, Notation notation = Notation::plain) {
  return print(lower(parse(text)), notation);
}

bool same(const Tree& a, const Tree& b) {
  const bool here = a->kind == b->kind && a->text == b->text && a->inverse == b->inverse &&
                    a->children.size() == b->children.size();
  for (std::size_t i = 0; here && i < a->children.size(); ++i) {
    if (!same(a->children[i], b->children[i])) return false;
  }
  return here;
}

/// Random expressions over a few symbols of the paper: the same ones for the same seed.
class RandomExpressions {
 public:
  ex next() {
    while (true) {
      try {
        const ex e = expression(pick(5));
        if (!is_modest(e)) continue;
        lower(to_tree(e), paper_symbols(), generous());
        return e;
      } catch (const SyntaxError& error) {  // sqrt(sin(1)*cos(2)) is not real
        if (error.note != "undefined") throw;
      } catch (
          const std::exception&) {  // 1/0 and its relatives; |x^atan(pi)|, which GiNaC makes a real part of
      }
    }
  }

  static Limits generous() {
    Limits limits;
    limits.exponent = 1'000;
    return limits;
  }

 private:
  int pick(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }

  /// Real, and without giant numbers.
  static bool is_modest(const ex& e) {
    for (auto part = e.preorder_begin(); part != e.preorder_end(); ++part) {
      const bool root = GiNaC::is_a<GiNaC::power>(*part) && !part->op(1).info(GiNaC::info_flags::integer);
      if (root && (-part->op(0)).info(GiNaC::info_flags::positive)) return false;
      if (!GiNaC::is_a<numeric>(*part)) continue;
      const numeric number = GiNaC::ex_to<numeric>(*part);
      if (!number.is_rational() || number.numer().int_length() + number.denom().int_length() > 100)
        return false;
    }
    return true;
  }

  ex leaf() {
    static const char* names[] = {"m", "R", "alpha", "theta", "thetadot", "x", "y", "psi"};
    if (pick(3) > 0) return paper_symbols()[names[pick(8)]];
    return pick(4) > 0 ? ex(numeric(pick(13) - 6, pick(4) + 1)) : ex(GiNaC::Pi);
  }

  ex function(const ex& x) {
    switch (pick(7)) {
      case 0:
        return GiNaC::sin(x);
      case 1:
        return GiNaC::cos(x);
      case 2:
        return GiNaC::exp(x);
      case 3:
        return GiNaC::sinh(x);
      case 4:
        return GiNaC::sqrt(x);
      case 5:
        return GiNaC::abs(x);
      default:
        return GiNaC::atan(x);
    }
  }

  ex expression(int depth) {
    if (depth == 0) return leaf();
    const ex a = expression(depth - 1);
    switch (pick(9)) {
      case 0:
      case 1:
        return a + expression(depth - 1);
      case 2:
        return a - expression(depth - 1);
      case 3:
      case 4:
        return a * expression(depth - 1);
      case 5:
        return a / expression(depth - 1);
      case 6:
        return GiNaC::pow(a, numeric(pick(9) - 4, pick(4) == 0 ? 2 : 1));
      case 7:
        return pick(3) > 0 ? function(a) : GiNaC::pow(a, expression(depth - 1));
      default:
        return function(a);
    }
  }

  std::mt19937 random_{seed};
};

/// Structures that GiNaC keeps apart may be one value: sqrt(1/x) and 1/sqrt(x).
bool same_value(const ex& a, const ex& b) {
  const Point point = {
      {"m", cln::cl_RA(2)},          {"R", cln::cl_RA(7) / 3},        {"alpha", cln::cl_RA(1) / 5},
      {"theta", cln::cl_RA(-1) / 7}, {"thetadot", cln::cl_RA(3) / 4}, {"x", cln::cl_RA(11) / 9},
      {"y", cln::cl_RA(-13) / 8},    {"psi", cln::cl_RA(1) / 2}};
  return digits_at(to_tree(a), point, 18) == digits_at(to_tree(b), point, 18);
}

}  // namespace

TEST_CASE("the order is the one of the paper") {
  CHECK(canonical("R*g*m*(cos(theta+alpha) - cos(alpha))") == "m*g*R*(cos(alpha + theta) - cos(alpha))");
  CHECK(canonical("p^2*(cos(alpha+theta)*u_gddot/g - sin(theta+alpha)) + thetaddot") ==
        "thetaddot + p^2*(u_gddot*cos(alpha + theta)/g - sin(alpha + theta))");
  CHECK(canonical("psi + t*omega_p") == "omega_p*t + psi");
  CHECK(canonical("1 + x + x^2 + 1/x") == "x^2 + x + 1 + 1/x");
  CHECK(canonical("-3/2*sin(alpha)^2 + 1") == "1 - 3/2*sin(alpha)^2");
  CHECK(canonical("exp(-p*(2*pi - psi)/omega_p)") == "exp(-p*(2*pi - psi)/omega_p)");
}

TEST_CASE("signs and fractions are a person's") {
  CHECK(canonical("-1*x + y") == "y - x");
  CHECK(canonical("-x*(y - r)") == "x*(r - y)");
  CHECK(canonical("-x - y") == "-x - y");
  CHECK(canonical("x^(-1)") == "1/x");
  CHECK(canonical("3*g/4/R") == "3*g/(4*R)");
  CHECK(canonical("m*R^2/3") == "1/3*m*R^2");
  CHECK(canonical("3*pi/4") == "3*pi/4");
  CHECK(canonical("x^(1/2) + x^(3/2) + x^(-1/2)") == "x^(3/2) + sqrt(x) + 1/sqrt(x)");
  CHECK(canonical("1/(x - y) - 1/(y - x)") == "2/(x - y)");
  CHECK(canonical("1/(1 - x^2)") == "1/(1 - x^2)");
  CHECK(canonical("sqrt(3*g/R)/2") == "1/2*sqrt(3*g/R)");
}

TEST_CASE("a tree is printed in the form it has") {
  for (const char* text : {"x + x",   "(x + y) + r", "x - (y - r)",   "-(-x)",   "x*(-y)",      "(-x)^2",
                           "x^(-1)",  "(x^2)^3",     "x^(y^2)",       "x/(y/r)", "x/(y*r)",     "(x/y)/r",
                           "x*(y/r)", "-x*y",        "-(x + y)",      "(-x)*y",  "0.50 + 1e-3", "2/4",
                           "sin(-x)", "fabs(x - y)", "(x + y)^(1/2)", "2^(-1)"}) {
    CAPTURE(text);
    const std::string minimal = print(parse(text));
    CHECK(same(parse(minimal), parse(text)));
    CHECK(print(parse(minimal)) == minimal);
  }
  CHECK(print(parse("((x))*(y^2)")) == "x*y^2");
  CHECK(print(parse_relation("K=a_p<=x>=y")) == "K = a_p <= x >= y");
}

TEST_CASE("Unicode") {
  CHECK(canonical("thetaddot*x^2 - 1/thetadot_0", Notation::unicode) == "θ̈·x² − 1/θ̇₀");
  CHECK(canonical("sin(alpha)^2*sqrt(2*pi)", Notation::unicode) == "√(2·π)·sin²(α)");
  CHECK(print(parse("x^(-1) + sin(x)^(-2)"), Notation::unicode) == "x⁻¹ + sin(x)⁻²");
  CHECK(print(parse("x/dK_dtheta"), Notation::unicode) == "x/(∂K/∂θ)");
  CHECK(print(parse_relation("a_p >= g*tan(alpha)"), Notation::unicode) == "α_p ≥ g·tan(α)");
}

TEST_CASE("LaTeX") {
  const auto latex = [](const char* text) { return print(parse(text), Notation::latex); };
  CHECK(latex("3*g/(4*R)") == "\\frac{3 g}{4 R}");
  CHECK(latex("1/2*J_o*thetadot^2") == "\\frac{1}{2} J_o \\dot\\theta^2");
  CHECK(latex("sin(alpha)^2") == "\\sin^2\\alpha");
  CHECK(latex("sin(alpha)*x") == "\\sin\\left(\\alpha\\right) x");
  CHECK(latex("sin(alpha)*cos(alpha)") == "\\sin\\alpha \\cos\\alpha");
  CHECK(latex("cos(alpha + theta)") == "\\cos\\left(\\alpha + \\theta\\right)");
  CHECK(latex("(x + y)*2") == "\\left(x + y\\right) \\cdot 2");
  CHECK(latex("exp(-p*t)^2") == "\\left(\\mathrm{e}^{-p t}\\right)^2");
  CHECK(latex("sqrt(x)/asin(x)^10") == "\\frac{\\sqrt{x}}{\\arcsin^{10} x}");
  CHECK(latex("t_star^2*x^(-1)") == "{t^*}^2 x^{-1}");
  CHECK(latex("dK_dtheta^2").starts_with("\\left("));
  CHECK(latex("fabs(x)*1e-3") == "\\left|x\\right| \\cdot 1\\cdot 10^{-3}");
  CHECK(print(parse_relation("x <= y"), Notation::latex) == "x \\le y");
}

TEST_CASE("what our syntax cannot say is refused, not garbled") {
  CHECK_THROWS_AS(to_tree(GiNaC::I), std::invalid_argument);
  CHECK_THROWS_AS(to_tree(numeric(0.1)), std::invalid_argument);
  CHECK_THROWS_AS(to_tree(GiNaC::lst{1, 2}), std::invalid_argument);
  CHECK_THROWS_AS(to_tree(paper_symbols()["x"] == 1), std::invalid_argument);
}

TEST_CASE("what is printed reads back as the same: 10 000 random expressions") {
  MESSAGE("seed " << seed);
  RandomExpressions random;
  const Limits limits = RandomExpressions::generous();
  int identical = 0;
  for (int i = 0; i < 10'000; ++i) {
    const ex e = random.next();
    const Tree tree = to_tree(e);
    const std::string text = print(tree);
    CAPTURE(text);
    REQUIRE(same(parse(text, paper_symbols(), limits), tree));
    REQUIRE(same(parse(print(tree, Notation::unicode), paper_symbols(), limits), tree));
    const ex back = lower(tree, paper_symbols(), limits);
    REQUIRE(print(back) == text);
    identical += back.is_equal(e) ? 1 : 0;
    if (!back.is_equal(e)) REQUIRE(same_value(back, e));
  }
  MESSAGE(identical << " of them GiNaC's very structure, the others the same value");
  CHECK(identical > 9'900);
}

TEST_CASE("printed samples" * doctest::skip()) {
  RandomExpressions random;
  for (int i = 0; i < 10'000; ++i) std::puts(print(random.next()).c_str());
}

TEST_CASE("the same bytes wherever the program is loaded") {
  const std::string self = std::filesystem::read_symlink("/proc/self/exe");
  const std::vector<std::string> samples = {"--no-skip", "--test-case=printed samples"};
  const std::string once = run_program(self, samples).out;
  CHECK(once.size() > 100'000);
  for (int i = 0; i < 3; ++i) CHECK(run_program(self, samples).out == once);
  const Result fixed = run_program("/usr/bin/setarch", {"-R", self, samples[0], samples[1]});
  if (fixed.exit_code != 0) {
    skip("this system does not let a program switch off address-space randomisation");
    return;
  }
  CHECK(fixed.out == once);
}

TEST_CASE("every printed row of the ledger reads back as it is printed, and so does what is derived") {
  for (const Row& row : read_rows(equations_file())) {
    CAPTURE(row.id);
    if (row.printed.empty()) continue;  // results of our own
    for (const Tree& side : parse_statement(row.printed).sides) {
      CHECK(same(parse(print(side)), side));
      const Tree tree = to_tree(lower(side));
      CHECK(same(parse(print(tree)), tree));
      CHECK(print(lower(tree)) == print(tree));
    }
  }
  for (const std::string& its_id : rocking_block::paper().derivations.ids()) {
    const auto& id = its_id;
    CAPTURE(id);
    const Derivation derivation = derivation_of(its_id);
    for (const ex& side : {derivation.left, derivation.right}) {
      const std::string text = print(side);
      CHECK(same(parse(text), to_tree(side)));
      CHECK(print(lower(parse(text))) == text);
    }
  }
}
