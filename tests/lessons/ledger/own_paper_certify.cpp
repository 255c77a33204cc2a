// Papers of one's own in Coq: what has a script passes, what has none is skipped and named.
#include <doctest/doctest.h>

#include <derivations/mechanics/linear_motion.hpp>
#include <derivations/mechanics/plane.hpp>
#include <nlohmann/json.hpp>
#include <tests/derivations/paper/own_paper.hpp>

using namespace rederive::language;
using namespace rederive::mechanics;
using namespace rederive::paper;
using namespace rederive::rocking_block;
using GiNaC::ex;
using Json = nlohmann::json;

namespace {

ex inertia() {
  const ex L = symbol("L");
  return integral(pow(rederive::rocking_block::x, 2) * rederive::rocking_block::m / L,
                  rederive::rocking_block::x, 0, L);
}

ex acceleration() {
  using namespace rederive::rocking_block;
  const ex kinetic = inertia() / 2 * pow(thetadot, 2), potential = m * g * symbol("L") / 2 * (1 - cos(theta));
  const Rates rates{{theta, thetadot}, {thetadot, thetaddot}};
  const ex motion = lagrange_terms(kinetic, potential, {theta, thetadot, thetaddot}, rates).sum().expand();
  return -motion.coeff(thetaddot, 0) / motion.coeff(thetaddot, 1);
}

/// The rod of the guide, with more rows.
PaperOfATest rod() {
  const auto frequency = []() -> Derivation {
    const ex linear = taylor(acceleration(), {rederive::rocking_block::theta}, 1);
    return derived(symbol("omega_0"), sqrt(-linear.coeff(rederive::rocking_block::theta, 1)), {});
  };
  return {[] {
            declare("L", "(0, inf)", "m"), declare("J", "(0, inf)", "kg*m^2");
            declare("omega_0", "(0, inf)", "1/s"), declare("n"), declare("theta_e", "(0, alpha)");
            declare("in", "(0, 1)");
          },
          row("1", "J = m*L^2/3") + row("2", "thetaddot = -3*g/(2*L)*sin(theta)") +
              row("3", "omega_0 = sqrt(2*g/(3*L))", "", "refuted") + row("4", "x = r^n") +
              row("5", "x = acosh(1 + r^2)", "", "refuted") + row("6", "x = r^n", "", "refuted") +
              row("7.1", "x + cos(x) = 2*y", "", "refuted") + row("8", "x = alpha - theta_e") +
              row("9", "in = sin(y)^2") + row("10", "x = cos(x)/2", "", "refuted") +
              row("11", "x*exp(x) = 2", "", "refuted") + row("12", "sqrt(b) = 2*cos(b)", "", "refuted") +
              row("13", "log(b) = -2*b", "", "refuted") + row("14", "in*tan(in) = 1/2", "", "refuted") +
              row("15", "b*(1 - sqrt(2/3)) = sqrt(h/6)", "", "refuted") +
              row("16", "x = fabs(y)", "", "refuted") + row("17", "sqrt(1 + b^2) = 2/b", "", "refuted") +
              row("18", "cosh(x)/(1 + x^2) = 2*x", "", "refuted") +
              row("19", "omega_0 = sqrt(2*g/(3*L))", "", "refuted") + row("20", "x = sqrt((2 - sqrt(2))*b)") +
              row("21", "x = cos(y*sqrt(1 - in^2))") + row("22", "asin(in) = 5*in/4", "", "refuted") +
              row("23", "acos(in) = in", "", "refuted") + row("24", "asinh(b) = b/2", "", "refuted"),
          {{"1", [] { return derived(symbol("J"), inertia(), {}); }},
           {"2", [] { return derived(symbol("thetaddot"), acceleration(), {}); }},
           {"3", frequency},
           {"4", [] { return derived(symbol("x"), pow(symbol("r"), symbol("n")), {}); }},
           {"5", [] { return derived(symbol("x"), acosh(1 + 2 * pow(symbol("r"), 2)), {}); }},
           {"6", [] { return derived(symbol("x"), 2 * pow(symbol("r"), symbol("n")), {}); }},
           {"7.1", [] { return derived(symbol("x") + cos(symbol("x")), symbol("y"), {}); }},
           {"8", [] { return derived(symbol("x"), abs(symbol("alpha") - symbol("theta_e")), {}); }},
           {"9", [] { return derived(symbol("in"), 1 - pow(cos(symbol("y")), 2), {}); }},
           {"10", [] { return derived(symbol("x"), cos(symbol("x")), {}); }},
           {"11", [] { return derived(symbol("x") * exp(symbol("x")), 1, {}); }},
           {"12", [] { return derived(sqrt(symbol("b")), cos(symbol("b")), {}); }},
           {"13", [] { return derived(log(symbol("b")), -symbol("b"), {}); }},
           {"14", [] { return derived(symbol("in") * tan(symbol("in")), ex(1) / 3, {}); }},
           {"15", [] { return derived(symbol("b"), sqrt(symbol("h") / 6), {}); }},
           {"16", [] { return derived(symbol("x"), 2 * abs(symbol("y")), {}); }},
           {"17", [] { return derived(sqrt(1 + pow(symbol("b"), 2)), 3 / symbol("b"), {}); }},
           {"18", [] { return derived(cosh(symbol("x")) / (1 + pow(symbol("x"), 2)), symbol("x"), {}); }},
           {"19",  // the root of L is that of 1 at the witness
            [] { return derived(symbol("omega_0"), sqrt(6 * symbol("g")) / (2 * sqrt(symbol("L"))), {}); }},
           {"20", [] { return derived(symbol("x"), sqrt(2 * symbol("b") - sqrt(ex(2)) * symbol("b")), {}); }},
           {"21", [] { return derived(symbol("x"), cos(sqrt(1 - pow(symbol("in"), 2)) * symbol("y")), {}); }},
           {"22", [] { return derived(asin(symbol("in")), 11 * symbol("in") / 10, {}); }},
           {"23", [] { return derived(acos(symbol("in")), 2 * symbol("in"), {}); }},
           {"24", [] { return derived(asinh(symbol("b")), symbol("b") / 3, {}); }}}};
}

}  // namespace

TEST_CASE("rows without a script are skipped and named, and the others are written") {
  const TemporaryFolder folder;
  const Result r = run_paper(rod(), {"certify", "proofs"}, folder.path);
  CHECK_MESSAGE(r.exit_code == 0, r.err);
  for (const char* name : {"equation_20:", "equation_21:", "equation_4:", "equation_5_refuted:",
                           "equation_5_corrected:", "equation_6_refuted:"})
    CHECK_MESSAGE(r.err.find(name) != std::string::npos, r.err);
  const std::string written = read_file(folder.path / "proofs/Ledger.v");
  for (const char* lemma : {"equation_1 ", "equation_2 ", "equation_3_refuted ", "equation_7_1_refuted "})
    CHECK(written.find(std::string("Lemma ") + lemma) != std::string::npos);
  CHECK(written.find("equation_4") == std::string::npos);
}

TEST_CASE("coqc takes every lemma of the guide's rod, and of rows like those of users") {
  if (!has_tool("coqc")) return;
  const Result r = run_paper(rod(), {"certify", "--check", "--json"});
  CHECK_MESSAGE(r.exit_code == 0, r.out, r.err);
  for (const Json& lemma : Json::parse(r.out)["lemmas"]) {
    CAPTURE(lemma);
    CHECK(lemma["passed"] == !lemma.contains("skipped"));
  }
}
