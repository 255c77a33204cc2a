#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <numbers>
#include <numerics/search/ball_functions.hpp>
#include <numerics/search/closed_form.hpp>
#include <numerics/search/roots.hpp>
#include <stdexcept>

namespace rederive::numerics {
using namespace numbers;
namespace {

/// The facts about a closed form beside its residual.
struct FormFacts {
  int code;
  std::vector<std::string> equations;
};

/// Returns the facts about a form. The form is an index into the table.
const FormFacts& facts_of(Form form) {
  static const std::vector<FormFacts> table{{-1, {"71"}},       {1, {"78"}},  {2, {"86", "88"}},
                                            {2, {"92a", "96"}}, {1, {"103"}}, {-1, {"104"}}};
  return table.at(static_cast<std::size_t>(form));
}

/// Pulses longer than this magnify rounding errors so much that the roots with an impact are searched for in
/// balls.
constexpr Real long_pulse = 25;

/// Returns the number of bits to begin with. A pulse magnifies a rounding error by e^T_ex at most, once on
/// the way to the root and once in the motion from there; sixty digits must be right.
long first_bits(Real longest) { return std::min(Ball::most_bits, 512 + static_cast<long>(2.9L * longest)); }

/// The numbers on which the equations depend.
template <class T>
struct Inputs {
  T omega_ratio, restitution, push;
};

/// Returns an upper bound of T_ex.
Real longest_pulse(const Ball& omega_ratio) { return 2 * std::numbers::pi_v<Real> / omega_ratio.to_real(); }

/// Returns the phase in (0, pi) at which theta = 0 at tau_i: (86) is A sin(psi) + B cos(psi) = 0. At psi = 0
/// the value is B and the derivative is A.
template <class T>
T phase_of_impact(const Inputs<T>& in, const T& tau) {
  using std::atan2;
  const auto at_zero = emitted::impact_during_pulse_with_derivatives(in.omega_ratio, T(0), tau);
  const T psi = atan2(-at_zero.value, at_zero.d_psi);
  return psi > T(0) ? psi : psi + emitted::pi<T>();
}

/// Is positive where the free motion after the pulse comes to upright so fast that e times its velocity more
/// than reaches theta = alpha on the other side.
template <class T>
T beyond_threshold(const Inputs<T>& in, const T& psi) {
  const T one(1), zero(0);
  const auto end = emitted::linear_response_negative_with_derivatives(
      one, one, in.omega_ratio, emitted::amplitude_of_sine_pulse(one, psi), psi, zero, zero,
      emitted::end_of_sine_pulse(in.omega_ratio, psi));
  const T needed = emitted::linear_critical_velocity_positive(zero) / in.restitution;
  return emitted::linear_impact_velocity_squared_negative(end.value, end.d_t) - needed * needed;
}

/// Returns the residual of a form, which is 0 at a root and positive where the block overturns. The unknown x
/// is psi; for (86)&(88) it is the impact time.
template <class T>
T residual(Form form, const Inputs<T>& in, const T& x) {
  const T &w = in.omega_ratio, &e = in.restitution;
  switch (form) {
    case Form::eq71:
      return emitted::overturning_without_impact_negative(w, x);
    case Form::eq78:
      return -emitted::overturning_without_impact_positive(w, x);
    case Form::eq86_88:
      return -emitted::overturning_impact_during_pulse(w, phase_of_impact(in, x), x, e);
    case Form::eq92a_96:
      return beyond_threshold(in, x);
    case Form::eq103:
      return -emitted::overturning_cosine_pulse(w, x, in.push);
    case Form::eq104:
      return emitted::overturning_sine_pulse(w, x, in.push);
  }
  return T(0);
}

/// The range of the unknown, and the number of points at which the residual is evaluated first. Eight times
/// as many points (four times without impact) found no other root in 3,000 random cases.
struct Range {
  double low, high;
  int count;
};

Range range_of(Form form, double longest) {
  constexpr double pi = std::numbers::pi, shift = pi / 2;
  if (form == Form::eq86_88) return {1e-4 * longest, std::min(3 * longest, longest + 10), 750};
  if (form == Form::eq92a_96) return {1e-6, pi - 1e-6, 500};
  if (form == Form::eq103) return {1e-9 - shift, pi - 1e-9 - shift, 500};
  return {1e-9, pi - 1e-9, 500};
}

/// Returns neighbouring doubles with a root between them, from rounded values of the residual.
std::vector<Change> brackets(Form form, const Inputs<Ball>& in) {
  const Inputs<Real> rounded{in.omega_ratio.to_real(), in.restitution.to_real(), in.push.to_real()};
  const Inputs<double> coarse{in.omega_ratio.to_double(), in.restitution.to_double(), in.push.to_double()};
  const Real longest = longest_pulse(in.omega_ratio);
  const bool with_impact = std::abs(code_of(form)) == 2, in_balls = with_impact && longest > long_pulse;
  const auto value = [&](double x) {
    // Without impact nothing grows: what rounding leaves in doubt is below 1e-13 of the terms.
    const double glance = with_impact ? 0 : residual<double>(form, coarse, x);
    if (std::isfinite(glance) && std::abs(glance) > 1e-9 * (1 + std::abs(coarse.push))) return glance;
    return static_cast<double>(in_balls ? residual(form, in, Ball(x, in.omega_ratio.bits())).to_real()
                                        : residual<Real>(form, rounded, x));
  };
  const Range range = range_of(form, static_cast<double>(longest));
  return sign_changes(value, range.low, range.high, range.count);
}

struct ProvenRoot {
  Ball x;
  bool rises;  ///< the residual, with x
};

/// Improves a bracket by secants from its ends, until rounding hides the difference of two values; then
/// proves it by the intermediate value theorem.
ProvenRoot proven_root(const std::function<Ball(const Ball&)>& f, const Change& bracket, long bits) {
  Ball last(bracket.inside, bits), next(bracket.outside, bits), last_value = f(last);
  for (int i = 0; i < 100; ++i) {
    const Ball value = f(next), change = value - last_value;
    if (change.contains_zero()) break;
    const Ball step = value * (next - last) / change;
    last = next, last_value = value;
    next = (next - step).middle();
  }
  const Ball x = next.widened(-bits / 2 - 64), low = f(x.lower()), high = f(x.upper());
  const bool rises = low.is_negative() && high.is_positive();
  if (!rises && !(low.is_positive() && high.is_negative()))
    throw NotCertain(fmt::format("a root near {} cannot be proven", next.to_double()));
  return {x, rises};
}

ExactRoot root_at(Form form, const Inputs<Ball>& in, const Ball& x) {
  const Ball one(1), zero(0), &w = in.omega_ratio;
  if (form == Form::eq103)
    return {emitted::amplitude_of_cosine_pulse(one, x), x, zero, emitted::end_of_cosine_pulse(w, x)};
  const Ball psi = form == Form::eq86_88 ? phase_of_impact(in, x) : x,
             end = emitted::end_of_sine_pulse(w, psi);
  if (!psi.is_positive() || !(psi < Ball::pi()))  // where it jumps: the residual is not continuous
    throw NotCertain(fmt::format("the phase of the impact at {} cannot be told", x.to_double()));
  const Ball time = form == Form::eq86_88 ? x
                    : form == Form::eq92a_96
                        ? end + log(emitted::growth_to_critical_impact(w, psi, in.restitution))
                        : zero;
  return {emitted::amplitude_of_sine_pulse(one, psi), psi, time, end};
}

/// Returns false where the residual changes its sign without a root: where the phase in (86) jumps from 0 to
/// pi, and where the velocity at the impact after the pulse is not towards upright.
bool is_root(Form form, const Inputs<Ball>& in, const Change& bracket) {
  const long bits = in.omega_ratio.bits();
  const Ball low(bracket.inside, bits), high(bracket.outside, bits);
  if (form == Form::eq86_88)
    return std::abs((phase_of_impact(in, high) - phase_of_impact(in, low)).to_double()) < 0.1;
  return form != Form::eq92a_96 ||
         emitted::growth_to_critical_impact(in.omega_ratio, high, in.restitution).is_positive();
}

/// Returns whether amplitudes just above a root overturn the block and those just below do not, or the other
/// way round. The amplitude falls with psi in a sine pulse, and grows with it in a cosine pulse.
bool overturns_above(Form form, const Inputs<Ball>& in, const ExactRoot& at, bool residual_rises) {
  if (form == Form::eq103) return residual_rises;
  if (form != Form::eq86_88) return !residual_rises;
  const auto impact = emitted::impact_during_pulse_with_derivatives(in.omega_ratio, at.psi, at.impact_time);
  const bool psi_falls_with_time = (impact.d_tau_i * impact.d_psi).is_positive();  // along impact.value = 0
  return residual_rises == psi_falls_with_time;
}

void add_roots(Form form, Pulse pulse, const ExactCase& exact, std::vector<ClosedForm>& all) {
  const Inputs<Ball> in{exact.omega_ratio, exact.restitution, exact.angle + exact.velocity};
  for (const Change& bracket : brackets(form, in)) {
    if (!is_root(form, in, bracket)) continue;
    const ProvenRoot found =
        proven_root([&](const Ball& x) { return residual(form, in, x); }, bracket, in.omega_ratio.bits());
    const ExactRoot root = root_at(form, in, found.x);
    std::optional<Objection> why_not = objection_to(form, pulse, exact, root);
    if (!why_not && !overturns_above(form, in, root, found.rises))
      why_not = Objection{Objection::Kind::upper_edge};
    const bool with_impact = std::abs(code_of(form)) == 2;
    all.push_back({.form = form,
                   .amplitude = root.amplitude.to_double(),
                   .psi = root.psi.to_double(),
                   .impact_time = with_impact ? std::optional(root.impact_time.to_double()) : std::nullopt,
                   .pulse_end = root.pulse_end.to_double(),
                   .exact = root,
                   .why_not = why_not});
  }
}

std::vector<Form> forms_for(Pulse pulse, const ExactCase& exact) {
  if (pulse == Pulse::cosine) return {Form::eq103};
  if (!exact.angle.is_zero() || !exact.velocity.is_zero()) return {Form::eq104};
  return {Form::eq71, Form::eq78, Form::eq86_88, Form::eq92a_96};
}

}  // namespace

int code_of(Form form) { return facts_of(form).code; }

std::vector<std::string> equations_of(Form form) { return facts_of(form).equations; }

ExactCase exact_case_of(const PulseCase& asked) {
  return {.omega_ratio = Ball(asked.omega_ratio),
          .restitution = Ball(asked.block.restitution),
          .angle = Ball(asked.initial.angle),
          .velocity = Ball(asked.initial.velocity)};
}

std::vector<ClosedForm> closed_forms(Pulse pulse, const ExactCase& exact, const std::vector<Form>& wanted) {
  for (long bits = first_bits(longest_pulse(exact.omega_ratio));; bits = std::min(2 * bits, Ball::most_bits))
    try {
      const ExactCase rounded{exact.omega_ratio.at(bits), exact.restitution.at(bits), exact.angle.at(bits),
                              exact.velocity.at(bits)};
      std::vector<ClosedForm> all;
      for (const Form form : forms_for(pulse, exact))
        if (wanted.empty() || std::ranges::count(wanted, form) > 0) add_roots(form, pulse, rounded, all);
      return all;
    } catch (const NotCertain&) {
      if (bits == Ball::most_bits) throw;
    }
}

std::vector<ClosedForm> closed_forms(const PulseCase& asked, const std::vector<Form>& wanted) {
  return closed_forms(asked.pulse, exact_case_of(asked), wanted);
}

}  // namespace rederive::numerics
