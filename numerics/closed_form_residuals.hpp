// The residuals of the closed forms on any number type: emitted functions under one roof.
#pragma once

#include <emitted/rocking_block.hpp>
#include <numerics/closed_form.hpp>

#include <array>

namespace rederive::emitted {
template <>
inline Digits pi<Digits>() {
  return Digits::pi();
}
}  // namespace rederive::emitted

namespace rederive::inline numeric {

template <class T>
struct Inputs {
  T omega_ratio, restitution, push;
};

template <class T>
struct Residual {
  T value, d_psi;
};

/// (71), (78), (103), (104): one unknown, psi.
template <class T>
Residual<T> residual_of_psi(Form form, const Inputs<T>& in, const T& psi) {
  const auto both = [](const auto& at) { return Residual<T>{at.value, at.d_psi}; };
  switch (form) {
    case Form::eq71:
      return both(emitted::overturning_without_impact_negative_with_derivatives(in.omega_ratio, psi));
    case Form::eq78:
      return both(emitted::overturning_without_impact_positive_with_derivatives(in.omega_ratio, psi));
    case Form::eq103:
      return both(emitted::overturning_cosine_pulse_with_derivatives(in.omega_ratio, psi, in.push));
    default: return both(emitted::overturning_sine_pulse_with_derivatives(in.omega_ratio, psi, in.push));
  }
}

/// (86)&(88), (92a)&(96): psi and the impact time; the two residuals and their derivatives.
template <class T>
struct ResidualPair {
  std::array<T, 2> value, d_psi, d_tau;
};

template <class T>
ResidualPair<T> residuals_with_impact(Form form, const Inputs<T>& in, const T& psi, const T& tau) {
  const auto both = [](const auto& a, const auto& b) {
    return ResidualPair<T>{{a.value, b.value}, {a.d_psi, b.d_psi}, {a.d_tau_i, b.d_tau_i}};
  };
  const T &w = in.omega_ratio, &e = in.restitution;
  if (form == Form::eq86_88)
    return both(emitted::impact_during_pulse_with_derivatives(w, psi, tau),
                emitted::overturning_impact_during_pulse_with_derivatives(w, psi, tau, e));
  return both(emitted::impact_after_pulse_with_derivatives(w, psi, tau),
              emitted::overturning_impact_after_pulse_with_derivatives(w, psi, tau, e));
}

}  // namespace rederive::numeric
