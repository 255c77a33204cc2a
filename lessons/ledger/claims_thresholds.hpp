// Thresholds of the paper's pulses, each computed once. This header and those of the derivations do not go
// together.
#pragma once

#include <lessons/ledger/claims_verdicts.hpp>
#include <numerics/closed_form.hpp>
#include <numerics/windows.hpp>
#include <optional>

namespace rederive {

/// Keeps what is expensive.
class Thresholds {
 public:
  /// All windows up to 12 alpha*g.
  const std::vector<Window>& windows(const PulseCase& asked);
  /// The least amplitude without impact, and the least and the largest after one impact, by bisection on the
  /// simulation, in alpha*g; empty if none up to 20 alpha*g.
  std::optional<double> mode_1(const PulseCase& asked);
  std::optional<double> mode_2(const PulseCase& asked);
  std::optional<double> mode_2_upper(const PulseCase& asked);
  /// The least amplitude that overturns at all, with its code.
  Window least(const PulseCase& asked);
  /// omega_p/p at which the critical impact meets the end of the pulse, and at which mode_2 ends; see
  /// claims_ratios.hpp.
  std::optional<double> handover_of(const PulseCase& asked);
  std::optional<double> end_of(const PulseCase& asked);

 private:
  std::optional<double> edge(const PulseCase& asked, int code, bool upper);

  std::map<std::string, std::vector<Window>> windows_;
  std::map<std::string, std::optional<double>> edges_;
  std::map<std::string, std::optional<double>> ratios_;
};

/// The block of the captions: alpha = 0.25, p = 2.14; without a restitution that of (46).
Block paper_block(std::optional<double> restitution = {});
/// One-sine or one-cosine pulse on it, from rest.
PulseCase pulse_case(double omega_ratio, Model model = Model::linear, std::optional<double> restitution = {},
                     Pulse pulse = Pulse::sine);
/// With theta_0 in rad and thetadot_0 in rad/s.
PulseCase with_initial(PulseCase asked, double theta_0, double thetadot_0);
/// The same pulse on a block of another alpha.
PulseCase with_alpha(PulseCase asked, double alpha, std::optional<double> restitution = {});

/// The roots of one closed form.
std::vector<ClosedForm> roots_of(Form form, const PulseCase& asked);
/// Amplitude in units of g*tan(alpha) instead of alpha*g.
double in_tangent(const PulseCase& asked, double amplitude);

}  // namespace rederive
