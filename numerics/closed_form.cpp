#include <numerics/closed_form.hpp>

#include <numerics/closed_form_residuals.hpp>
#include <numerics/motion_check.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <stdexcept>

namespace rederive::inline numeric {
namespace {

constexpr Real pi = std::numbers::pi_v<Real>;
using Function = std::function<Real(Real)>;

/// The root between two arguments where f has different signs, bisected to the last bit.
Real bisected(const Function& f, Real low, Real high) {
  const bool sign = f(low) < 0;
  for (Real m = std::midpoint(low, high); low < m && m < high; m = std::midpoint(low, high))
    ((f(m) < 0) == sign ? low : high) = m;
  return high;
}

/// Where |f| is least between two arguments, by golden sections.
Real least_between(const Function& f, Real low, Real high) {
  for (int i = 0; i < 80; ++i) {
    const Real left = std::lerp(low, high, 0.382L), right = std::lerp(low, high, 0.618L);
    (std::abs(f(left)) < std::abs(f(right)) ? high : low) =
        std::abs(f(left)) < std::abs(f(right)) ? right : left;
  }
  return std::midpoint(low, high);
}

/// Roots by sign changes between `count` points, and by dips of |f| that pass through zero in between.
std::vector<Real> roots_between(const Function& f, Real low, Real high, int count) {
  std::vector<Real> roots, at, value;
  for (int i = 0; i <= count; ++i) {
    at.push_back(std::lerp(low, high, static_cast<Real>(i) / count));
    value.push_back(f(at.back()));
  }
  const auto differ = [](Real a, Real b) { return (a < 0) != (b < 0); };
  for (std::size_t i = 0; i + 1 < at.size(); ++i) {
    if (differ(value[i], value[i + 1])) {
      roots.push_back(bisected(f, at[i], at[i + 1]));
      continue;
    }
    const bool dips = i > 0 && !differ(value[i - 1], value[i]) &&
                      std::abs(value[i]) <= std::abs(value[i - 1]) &&
                      std::abs(value[i]) < std::abs(value[i + 1]);
    if (!dips) continue;
    const Real least = least_between(f, at[i - 1], at[i + 1]);
    if (!differ(f(least), value[i])) continue;
    roots.push_back(bisected(f, at[i - 1], least));
    roots.push_back(bisected(f, least, at[i + 1]));
  }
  return roots;
}

Inputs<Real> inputs_of(const PulseCase& asked) {
  return {asked.omega_ratio, asked.block.restitution, asked.initial.angle + asked.initial.velocity};
}

ClosedForm root_at(const PulseCase& asked, Form form, Real psi, std::optional<Real> impact_time) {
  const bool cosine = form == Form::eq103;
  const Root root{form, 1 / (cosine ? std::cos(psi) : std::sin(psi)), psi, impact_time,
                  ((cosine ? 1.5L : 2) * pi - psi) / asked.omega_ratio};
  const std::string reason = why_not(asked, root);
  const auto rounded = [](Real value) { return static_cast<double>(value); };
  return {form,
          rounded(root.amplitude),
          rounded(psi),
          impact_time ? std::optional(rounded(*impact_time)) : std::nullopt,
          rounded(root.pulse_end),
          reason.empty(),
          reason};
}

void add_without_impact(const PulseCase& asked, Form form, std::vector<ClosedForm>& all) {
  const auto residual = [&](Real psi) { return residual_of_psi(form, inputs_of(asked), psi).value; };
  const Real shift = form == Form::eq103 ? pi / 2 : 0, margin = 1e-9L;
  for (Real psi : roots_between(residual, margin - shift, pi - margin - shift, 2000))
    all.push_back(root_at(asked, form, psi, {}));
}

/// (86) is linear in cos(psi), sin(psi): the phase in (0, pi) for which theta = 0 at tau_i.
Real phase_of_impact(const Inputs<Real>& in, Real tau) {
  const Real zero = 0;
  const Real of_cos = residuals_with_impact(Form::eq86_88, in, zero, tau).value[0];
  const Real of_sin = residuals_with_impact(Form::eq86_88, in, pi / 2, tau).value[0];
  const Real psi = std::atan2(-of_cos, of_sin);
  return psi > 0 ? psi : psi + pi;
}

void add_impact_during_pulse(const PulseCase& asked, std::vector<ClosedForm>& all) {
  const Inputs<Real> in = inputs_of(asked);
  const auto residual = [&](Real tau) {
    return residuals_with_impact(Form::eq86_88, in, phase_of_impact(in, tau), tau).value[1];
  };
  const Real longest = 2 * pi / in.omega_ratio;
  for (Real tau : roots_between(residual, 1e-4L * longest, 3 * longest, 6000)) {
    const Real psi = phase_of_impact(in, tau);
    if (std::abs(psi - phase_of_impact(in, tau * (1 - 1e-9L))) < 0.1L)  // else psi jumps between 0 and pi
      all.push_back(root_at(asked, Form::eq86_88, psi, tau));
  }
}

/// The free motion after the pulse reaches upright where (theta + alpha) cosh + thetadot sinh = alpha: with
/// z = e^(tau_i - T_ex) a quadratic, whose root with impact velocity `speed` is (1 + speed)/(theta + alpha +
/// thetadot).
struct EndOfPulse {
  Real time, height, velocity;  ///< (theta + alpha)/alpha and thetadot/(alpha p)
};

EndOfPulse end_of_pulse(Real w, Real psi) {
  const Real one = 1, zero = 0, time = (2 * pi - psi) / w;
  const auto at = emitted::linear_response_negative_with_derivatives(one, one, w, 1 / std::sin(psi), psi,
                                                                     zero, zero, time);
  return {time, at.value + 1, at.d_t};
}

void add_impact_after_pulse(const PulseCase& asked, std::vector<ClosedForm>& all) {
  const Inputs<Real> in = inputs_of(asked);
  const Real speed = 1 / in.restitution;
  const auto residual = [&](Real psi) {
    const EndOfPulse end = end_of_pulse(in.omega_ratio, psi);
    return 1 + (end.velocity - end.height) * (end.velocity + end.height) - speed * speed;
  };
  for (Real psi : roots_between(residual, 1e-6L, pi - 1e-6L, 4000)) {
    const EndOfPulse end = end_of_pulse(in.omega_ratio, psi);
    const Real z = (1 + speed) / (end.height + end.velocity);
    if (z > 0) all.push_back(root_at(asked, Form::eq92a_96, psi, end.time + std::log(z)));
  }
}

struct Correction {
  Digits psi, tau;
};

Correction newton_step(Form form, const Inputs<Digits>& in, const Digits& psi, const Digits& tau) {
  if (form != Form::eq86_88 && form != Form::eq92a_96) {
    const auto at = residual_of_psi(form, in, psi);
    return {at.value / at.d_psi, 0};
  }
  const auto at = residuals_with_impact(form, in, psi, tau);
  const Digits determinant = at.d_psi[0] * at.d_tau[1] - at.d_tau[0] * at.d_psi[1];
  return {(at.value[0] * at.d_tau[1] - at.d_tau[0] * at.value[1]) / determinant,
          (at.d_psi[0] * at.value[1] - at.value[0] * at.d_psi[1]) / determinant};
}

/// Newton's iteration from the root in double, at the digits of the type.
void polish(Form form, const Inputs<Digits>& in, Digits& psi, Digits& tau, int digits) {
  const Digits enough = Digits::parse(fmt::format("1e-{}", digits + 10)) * abs(psi);
  for (int i = 0; i < 40; ++i) {
    const Correction step = newton_step(form, in, psi, tau);
    psi -= step.psi;
    tau -= step.tau;
    if (abs(step.psi) < enough) return;
  }
  throw std::runtime_error(
      fmt::format("{} digits cannot be reached at omega_p/p = {}", digits, in.omega_ratio.text(6)));
}

}  // namespace

std::vector<std::string> ClosedForm::equations() const {
  switch (form) {
    case Form::eq71: return {"71"};
    case Form::eq78: return {"78"};
    case Form::eq86_88: return {"86", "88"};
    case Form::eq92a_96: return {"92a", "96"};
    case Form::eq103: return {"103"};
    case Form::eq104: return {"104"};
  }
  return {};
}

std::vector<ClosedForm> closed_forms(const PulseCase& asked) {
  PulseCase linear = asked;
  linear.model = Model::linear;
  std::vector<ClosedForm> all;
  const bool from_rest = asked.initial.angle == 0 && asked.initial.velocity == 0;
  if (asked.pulse == Pulse::cosine) {
    add_without_impact(linear, Form::eq103, all);
  } else if (from_rest) {
    add_without_impact(linear, Form::eq71, all);
    add_without_impact(linear, Form::eq78, all);
    add_impact_during_pulse(linear, all);
    add_impact_after_pulse(linear, all);
  } else {
    add_without_impact(linear, Form::eq104, all);
  }
  return all;
}

ExactRoot exact_root(const ClosedForm& root, const ExactCase& exact, int digits) {
  Digits psi(root.psi), tau(root.impact_time.value_or(0));
  const Inputs<Digits> in{exact.omega_ratio, exact.restitution, exact.push};
  polish(root.form, in, psi, tau, digits);
  const bool cosine = root.form == Form::eq103;
  const Digits whole = cosine ? Digits(3) * Digits::pi() / Digits(2) : Digits(2) * Digits::pi();
  return {Digits(1) / (cosine ? cos(psi) : sin(psi)), psi, tau, (whole - psi) / exact.omega_ratio};
}

}  // namespace rederive::numeric
