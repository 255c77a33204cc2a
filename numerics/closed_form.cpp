#include <numerics/closed_form.hpp>

#include <numerics/closed_form_residuals.hpp>
#include <numerics/motion_check.hpp>
#include <numerics/roots.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <mutex>
#include <numbers>
#include <stdexcept>

namespace rederive::inline numeric {
namespace {

constexpr Real pi = std::numbers::pi_v<Real>;

/// A pulse longer than this magnifies rounding so much that an impact's roots are sought with all digits.
constexpr Real long_pulse = 25;

Real real(Real value) { return value; }
Real real(const Digits& value) { return value.to_real(); }

/// A number of which no digit that counts is left.
bool is_nothing(const Digits& change, const Digits& beside) {
  static const Digits smallest = Digits::parse(fmt::format("1e-{}", Digits::working_digits - 30));
  return !(abs(change) > smallest * abs(beside));
}

struct Correction {
  Digits psi, tau;
};

Correction newton_step(Form form, const Inputs<Digits>& in, const Digits& psi, const Digits& tau) {
  if (std::abs(code_of(form)) == 1) {
    const auto at = residual_of_psi(form, in, psi);
    return {at.value / at.d_psi, 0};
  }
  const auto at = residuals_with_impact(form, in, psi, tau);
  const Digits determinant = at.d_psi[0] * at.d_tau[1] - at.d_tau[0] * at.d_psi[1];
  return {(at.value[0] * at.d_tau[1] - at.d_tau[0] * at.value[1]) / determinant,
          (at.d_psi[0] * at.value[1] - at.value[0] * at.d_psi[1]) / determinant};
}

class Search {
 public:
  Search(Pulse pulse, const ExactCase& exact)
      : pulse_(pulse),
        exact_(exact),
        all_digits_{exact.omega_ratio, exact.restitution, exact.angle + exact.velocity},
        rounded_{real(all_digits_.omega_ratio), real(all_digits_.restitution), real(all_digits_.push)},
        longest_(2 * pi / rounded_.omega_ratio) {}

  void without_impact(Form form) {
    const auto residual = [&](Real psi) { return residual_of_psi(form, rounded_, psi).value; };
    const Real shift = form == Form::eq103 ? pi / 2 : 0, margin = 1e-9L;
    for (const Bracket& root : roots_between(residual, margin - shift, pi - margin - shift, 2000))
      add(form, Digits(root.high), 0);
  }

  void impact_during_pulse() { longest_ < long_pulse ? impact_during(rounded_) : impact_during(all_digits_); }
  void impact_after_pulse() { longest_ < long_pulse ? impact_after(rounded_) : impact_after(all_digits_); }

  std::vector<ClosedForm> roots() && { return std::move(all_); }

 private:
  /// (86) is linear in cos(psi), sin(psi): the phase in (0, pi) for which theta = 0 at tau_i.
  template <class T>
  static T phase_of_impact(const Inputs<T>& in, const T& tau) {
    using std::atan2;
    const T zero = 0, quarter = emitted::pi<T>() / T(2);
    const T psi = atan2(-emitted::impact_during_pulse(in.omega_ratio, zero, tau),
                        emitted::impact_during_pulse(in.omega_ratio, quarter, tau));
    return psi > T(0) ? psi : psi + emitted::pi<T>();
  }

  template <class T>
  void impact_during(const Inputs<T>& in) {
    const auto residual = [&](Real at) {
      const T tau(at);
      return real(emitted::overturning_impact_during_pulse(in.omega_ratio, phase_of_impact(in, tau), tau,
                                                           in.restitution));
    };
    const auto phase = [&](Real tau) { return real(phase_of_impact(in, T(tau))); };
    const Real last = std::min(3 * longest_, longest_ + 10);
    for (const Bracket& root : roots_between(residual, 1e-4L * longest_, last, 6000))
      if (std::abs(phase(root.high) - phase(root.high * (1 - 1e-9L))) <
          0.1L)  // else psi jumps between 0 and pi
        add(Form::eq86_88, phase_of_impact(all_digits_, Digits(root.high)), Digits(root.high));
  }

  /// Vanishes where the free motion after the pulse comes to upright so fast that e times its velocity just
  /// reaches theta = alpha on the other side.
  template <class T>
  static T beyond_threshold(const Inputs<T>& in, const T& psi) {
    const T one = 1, zero = 0, amplitude = emitted::amplitude_of_sine_pulse(one, psi);
    const auto end = emitted::linear_response_negative_with_derivatives(
        one, one, in.omega_ratio, amplitude, psi, zero, zero,
        emitted::end_of_sine_pulse(in.omega_ratio, psi));
    const T needed = emitted::linear_critical_velocity_positive(zero) / in.restitution;
    return emitted::linear_impact_velocity_squared_negative(end.value, end.d_t) - needed * needed;
  }

  template <class T>
  void impact_after(const Inputs<T>& in) {
    const auto residual = [&](Real psi) { return real(beyond_threshold(in, T(psi))); };
    for (const Bracket& root : roots_between(residual, 1e-6L, pi - 1e-6L, 4000)) {
      const Digits psi = between(root);
      const Digits& w = all_digits_.omega_ratio;
      const Real growth = real(emitted::growth_to_critical_impact(w, psi, all_digits_.restitution));
      if (growth > 0) add(Form::eq92a_96, psi, emitted::end_of_sine_pulse(w, psi) + Digits(std::log(growth)));
    }
  }

  /// The root of beyond_threshold, which is all but straight there, by the secant.
  Digits between(const Bracket& root) const {
    Digits last(root.low), next(root.high), last_value = beyond_threshold(all_digits_, last);
    for (int i = 0; i < 50 && !is_nothing(next - last, next); ++i) {
      const Digits value = beyond_threshold(all_digits_, next), change = value - last_value;
      if (change == 0) break;
      const Digits step = value * (next - last) / change;
      last = next, last_value = value;
      next -= step;
    }
    return next;
  }

  /// Newton's iteration to all digits, and the root's place in the list.
  void add(Form form, Digits psi, Digits tau) {
    for (int i = 0;; ++i) {
      const Correction step = newton_step(form, all_digits_, psi, tau);
      psi -= step.psi;
      tau -= step.tau;
      if (is_nothing(step.psi, psi)) break;
      if (i == 200)
        throw std::runtime_error(
            fmt::format("a root near psi = {} at omega_p/p = {} cannot be found to all digits",
                        psi.to_double(), all_digits_.omega_ratio.text(6)));
    }
    const bool cosine = pulse_ == Pulse::cosine, with_impact = std::abs(code_of(form)) == 2;
    const Digits one = 1, &w = all_digits_.omega_ratio;
    ExactRoot root{
        cosine ? emitted::amplitude_of_cosine_pulse(one, psi) : emitted::amplitude_of_sine_pulse(one, psi),
        psi, tau, cosine ? emitted::end_of_cosine_pulse(w, psi) : emitted::end_of_sine_pulse(w, psi)};
    const Motion motion = motion_at(form, pulse_, exact_, root);
    const auto impact_time = with_impact ? std::optional(tau.to_double()) : std::nullopt;
    all_.push_back({form, root.amplitude.to_double(), psi.to_double(), impact_time,
                    root.pulse_end.to_double(), root, motion.real, motion.why_not.empty(), motion.why_not});
  }

  Pulse pulse_;
  ExactCase exact_;
  Inputs<Digits> all_digits_;
  Inputs<Real> rounded_;
  Real longest_;  ///< bound of T_ex
  std::vector<ClosedForm> all_;
};

}  // namespace

int code_of(Form form) {
  switch (form) {
    case Form::eq71:
    case Form::eq104:
      return -1;
    case Form::eq78:
    case Form::eq103:
      return 1;
    case Form::eq86_88:
    case Form::eq92a_96:
      return 2;
  }
  return 0;
}

std::vector<std::string> ClosedForm::equations() const {
  switch (form) {
    case Form::eq71:
      return {"71"};
    case Form::eq78:
      return {"78"};
    case Form::eq86_88:
      return {"86", "88"};
    case Form::eq92a_96:
      return {"92a", "96"};
    case Form::eq103:
      return {"103"};
    case Form::eq104:
      return {"104"};
  }
  return {};
}

ExactCase exact_case_of(const PulseCase& asked) {
  return {Digits(asked.omega_ratio), Digits(asked.block.restitution), Digits(asked.initial.angle),
          Digits(asked.initial.velocity)};
}

namespace {

/// CLN counts the references to its numbers, and keeps constants between calls, without regard to threads.
std::mutex& one_at_a_time() {
  static std::mutex mutex;
  return mutex;
}

std::vector<ClosedForm> all_roots(Pulse pulse, const ExactCase& exact) {
  Search search(pulse, exact);
  if (pulse == Pulse::cosine) {
    search.without_impact(Form::eq103);
  } else if (exact.angle == 0 && exact.velocity == 0) {
    search.without_impact(Form::eq71);
    search.without_impact(Form::eq78);
    search.impact_during_pulse();
    search.impact_after_pulse();
  } else {
    search.without_impact(Form::eq104);
  }
  return std::move(search).roots();
}

}  // namespace

std::vector<ClosedForm> closed_forms(Pulse pulse, const ExactCase& exact) {
  const std::lock_guard lock(one_at_a_time());
  return all_roots(pulse, exact);
}

std::vector<ClosedForm> closed_forms(const PulseCase& asked) {
  const std::lock_guard lock(one_at_a_time());
  return all_roots(asked.pulse, exact_case_of(asked));
}

}  // namespace rederive::numeric
