// A mass on a spring with a damper: free, damped and forced.
#include <rederive/derivations/mechanics/time_derivative.hpp>
#include <rederive/derivations/paper/run_derive.hpp>
#include <stdexcept>

using namespace rederive::mechanics;
using namespace rederive::paper;
using GiNaC::ex;
using GiNaC::lst;

namespace {

/// Returns the coefficients of cos(phase) and of sin(phase) in a sum of such terms.
std::pair<ex, ex> parts(const ex& sum, const ex& phase) {
  return {sum.coeff(cos(phase)), sum.coeff(sin(phase))};
}

void derive(const rederive::language::Symbols& symbols, Derivations& rows) {
  const auto &m = symbols["m"], &k = symbols["k"], &c = symbols["c"], &zeta = symbols["zeta"],
             &omega_0 = symbols["omega_0"], &omega_d = symbols["omega_d"], &Omega = symbols["Omega"],
             &t = symbols["t"], &x = symbols["x"], &xdot = symbols["xdot"], &xddot = symbols["xddot"],
             &x_0 = symbols["x_0"], &v_0 = symbols["v_0"], &delta = symbols["delta"], &F_0 = symbols["F_0"],
             &r = symbols["r"], &V = symbols["V"];
  const GiNaC::realsymbol A("A"), B("B"), decay("decay"), period("T");  // of trial solutions

  // The acceleration by Lagrange's equation, with Rayleigh's function for the damper.
  const auto motion = [=](const ex& damping, const ex& force) {
    const ex kinetic = m * pow(xdot, 2) / 2, potential = k * pow(x, 2) / 2, lost = damping * pow(xdot, 2) / 2;
    const Rates rates{{x, xdot}, {xdot, xddot}};
    const ex sum =
        lagrange_terms(kinetic, potential, {x, xdot, xddot}, rates).sum() + diff(lost, xdot) - force;
    const lst of_ratio{k == m * pow(omega_0, 2), c == 2 * zeta * m * omega_0};
    return ex(lsolve(sum.expand() == 0, xddot).subs(of_ratio).expand());
  };
  // What is left if a trial solution is put into an equation of motion: 0 if it is a solution.
  const auto left_over = [=](const ex& trial, const ex& acceleration) {
    const ex velocity = diff(trial, t);
    return ex((diff(velocity, t) - acceleration.subs(lst{x == trial, xdot == velocity})).expand());
  };
  const auto swing = [=](const ex& phase) { return ex(A * cos(phase) + B * sin(phase)); };
  // The trial solution with the constants A and B that give x_0 and v_0 at the time 0.
  const auto from_start = [=](const ex& trial) {
    const lst start{trial.subs(t == 0) == x_0, diff(trial, t).subs(t == 0) == v_0};
    return ex(trial.subs(lsolve(start, lst{A, B})));
  };
  const Step amplitudes = in_words("Choose the two amplitudes so that $x = x_0$ and $xdot = v_0$ at $t = 0$");

  const ex undamped = motion(0, 0), damped = motion(c, 0);
  rows.add("1", [=] {
    return derived(
        xddot, undamped,
        {in_words("Write Lagrange's equation of $x$, with the energies $m*xdot^2/2$ and $k*x^2/2$"),
         in_words("Put in $k = m*omega_0^2$")});
  });
  rows.add("2", [=] {
    const ex trial = swing(omega_0 * t);
    if (!left_over(trial, undamped).is_zero()) throw std::logic_error("a sine and a cosine do not solve (1)");
    return derived(x, from_start(trial),
                   {from("1", "A sum of a cosine and a sine of $omega_0*t$ solves #"), amplitudes});
  });

  rows.add("3", [=] {
    return derived(xddot, damped,
                   {in_words("Add to Lagrange's equation Rayleigh's function of the damper, $c*xdot^2/2$"),
                    in_words("Put in $k = m*omega_0^2$ and $c = 2*zeta*m*omega_0$")});
  });
  const ex trial = exp(-decay * t) * swing(omega_d * t);
  const auto [of_cosine, of_sine] =
      parts(left_over(trial, damped).coeff(exp(-decay * t)).expand(), omega_d * t);
  const ex rate = lsolve(of_cosine.coeff(B) == 0, decay);
  const ex rest = of_cosine.coeff(A).subs(decay == rate).expand();
  const ex square =
      pow(omega_0, 2) * (rest.coeff(omega_d, 0) / pow(omega_0, 2)).expand() / -rest.coeff(omega_d, 2);
  const ex frequency = omega_0 * sqrt(square / pow(omega_0, 2));
  rows.add("4", [=] {
    return derived(
        omega_d, frequency,
        {from("3", "Put an exponential function times a sum of a cosine and a sine of $omega_d*t$ into #"),
         in_words("The cosine with the amplitude of the sine vanishes if the first factor is "
                  "$exp(-zeta*omega_0*t)$"),
         {"All other terms vanish if", pow(omega_d, 2), square}});
  });
  rows.add("5", [=] {
    if (!of_sine.subs(decay == rate).subs(pow(omega_d, 2) == square).expand().is_zero())
      throw std::logic_error("the sine is left over");
    return derived(x, from_start(trial.subs(decay == rate)),
                   {from("4", "Take the decaying cosine and sine of the frequency of #"), amplitudes},
                   {{omega_d, frequency}});
  });
  rows.add("6", [=] {
    const ex swing_time = lsolve(omega_d * period == 2 * GiNaC::Pi, period);
    const ex logarithm = (rate * (t + swing_time) - rate * t).expand();
    return derived(
        delta, logarithm.subs(omega_d == frequency),
        {from("5", "Divide # by what it is after the time $2*pi/omega_d$"),
         {"The cosine and the sine are the same as before; the logarithm of the rest is", delta, logarithm},
         from("4", "Put in #")});
  });

  const auto [in_phase, across] =
      parts(left_over(swing(Omega * t), motion(c, F_0 * cos(Omega * t))), Omega * t);
  const ex forced = lsolve(lst{in_phase == 0, across == 0}, lst{A, B});
  const ex in_proportion = (pow(A, 2) + pow(B, 2)) * pow(m * pow(omega_0, 2) / F_0, 2);
  const ex below = (1 / in_proportion.subs(forced).subs(Omega == r * omega_0).normal()).normal().expand();
  rows.add("7", [=] {
    return derived(
        V, 1 / sqrt(below),
        {from("3", "Add the force $F_0*cos(Omega*t)/m$ to the right side of #"),
         in_words("Put a cosine and a sine of $Omega*t$ in for $x$, and solve for the two amplitudes"),
         {"The sum of their squares, in proportion to $(F_0/k)^2$, with $Omega = r*omega_0$", pow(V, 2),
          1 / below}});
  });
  rows.add("8", [=] {
    const ex slope = diff(below, r).expand();
    return derived(r, sqrt(-slope.coeff(r, 1) / slope.coeff(r, 3)).expand(),
                   {from("7", "The amplitude is largest where the sum under the root of # is least"),
                    {"There its derivative by $r$ is 0", slope, 0}});
  });
}

}  // namespace

int main(int argc, char** argv) { return run_derive(derive, argc, argv); }
