// What the checks of the claims share: judged rows, thresholds and motions, each computed once, and words.
#pragma once

#include <fmt/format.h>

#include <derivations/paper/ledger.hpp>
#include <lessons/ledger/claims.hpp>
#include <numerics/search/closed_form.hpp>
#include <numerics/search/windows.hpp>

namespace rederive::rocking_block {

/// Computes what the checks of claims ask for, and keeps the results for all claims of a run.
class Bench {
 public:
  /// Returns a judged row of equations.toml. Throws std::out_of_range, with the id, if there is no such row.
  const paper::Entry& row(const std::string& id);
  decide::Verdict verdict_of(const std::string& id) { return row(id).proof.verdict; }
  /// Returns whether the verdict of a row is proved, proved_under or approximation.
  bool is_right(const std::string& id);
  /// Returns the verdicts of rows in words: "(24b) proved, (88) refuted: right is …".
  std::string say(const std::vector<std::string>& ids);

  /// Returns all windows of amplitudes that overturn the block, up to 12 alpha*g.
  const std::vector<numerics::Window>& windows(const numerics::PulseCase& asked);
  /// Returns the window with the least amplitude. Throws std::runtime_error if there is none up to 12
  /// alpha*g.
  numerics::Window least(const numerics::PulseCase& asked);
  /// Return the least amplitude that overturns without impact, and the least and the largest that overturn
  /// after one impact, in alpha*g, by bisection on the simulation; 0 if there is none up to 20 alpha*g.
  double mode_1(const numerics::PulseCase& asked) { return edge(asked, -1, false); }
  double mode_2(const numerics::PulseCase& asked) { return edge(asked, 2, false); }
  double mode_2_upper(const numerics::PulseCase& asked) { return edge(asked, 2, true); }
  double mode(int impacts, const numerics::PulseCase& asked) {
    return impacts == 0 ? mode_1(asked) : mode_2(asked);
  }
  /// Return omega_p/p at which the critical impact meets the end of the pulse, and at which mode_2 ends; 0 if
  /// there is none. See claims_ratios.hpp.
  double handover_of(const numerics::PulseCase& asked);
  double end_of(const numerics::PulseCase& asked);

 private:
  double edge(const numerics::PulseCase& asked, int code_under_sine, bool upper);

  std::map<std::string, paper::Entry> entries_;
  std::map<std::string, std::vector<numerics::Window>> windows_;
  std::map<std::string, double> edges_, ratios_;
};

/// A check: decides a claim with what the bench computes.
using BenchCheck = ledger::Finding (*)(Bench&, const ledger::Claim&);
/// The checks by their names in claims.toml.
using Checks = std::map<std::string, BenchCheck>;
Checks checks_of_symbols();       ///< decided by derivations and by the verdicts of the rows
Checks checks_of_start();         ///< section 1: how it starts, its modes, friction
Checks checks_of_impact();        ///< section 2: restitution and reactions
Checks checks_of_linear_model();  ///< section 3: one-sine pulse, without and after one impact
Checks checks_of_cosine();        ///< section 3 and Fig. 14: the cosine pulse, initial conditions
Checks checks_of_figures();       ///< section 4: printed numbers and captions
Checks checks_of_spectra();       ///< section 4 and conclusion 9: least amplitudes, periods, Eurocode 8

/// Returns the block of the captions, alpha = 0.25 and p = 2.14; the restitution is that of (46) if none is
/// given.
numerics::Block paper_block(std::optional<double> restitution = {});
/// Return the one-sine and the one-cosine pulse on that block, from rest.
numerics::PulseCase pulse_case(double omega_ratio, numerics::Model model = numerics::Model::linear,
                               std::optional<double> restitution = {});
numerics::PulseCase cosine_case(double omega_ratio);
/// Returns the case with theta_0 in rad and thetadot_0 in rad/s.
numerics::PulseCase with_initial(numerics::PulseCase asked, double theta_0, double thetadot_0);
/// Returns the same pulse on a block with another alpha, in rad.
numerics::PulseCase with_alpha(numerics::PulseCase asked, double alpha,
                               std::optional<double> restitution = {});

/// Return the roots of one closed form, and the first of them. root_of throws std::out_of_range if there is
/// none.
std::vector<numerics::ClosedForm> roots_of(numerics::Form form, const numerics::PulseCase& asked);
numerics::ClosedForm root_of(numerics::Form form, const numerics::PulseCase& asked);
/// Returns an amplitude in units of g*tan(alpha) that is given in units of alpha*g.
double in_tangent(const numerics::PulseCase& asked, double amplitude);
/// Returns the number of impacts before the block overturns.
int impacts_of(const numerics::Window& window);

/// Return the pulse of a case as ground motion, the motion of the block under it, and 400 states of that
/// motion until the pulse ends. `amplitude` is in alpha*g.
numerics::GroundMotion ground_of(const numerics::PulseCase& asked, double amplitude);
numerics::Response motion_at(const numerics::PulseCase& asked, double amplitude);
std::vector<numerics::Sample> samples_at(const numerics::PulseCase& asked, double amplitude);
/// Returns the time p*t of the first event of that kind; 0 if there is none.
double first_time(const numerics::Response& motion, numerics::EventKind kind);

/// Returns a number with `digits` digits after the point: "2.3577".
std::string fixed(double value, int digits = 4);
/// Adds an item to a list in words.
void add(std::string& list, const std::string& item, const char* separator = ", ");
/// Returns "1: 1.4183, 2: 2.3499": what `say` returns (text, or a number to four digits) for each number.
template <class Say>
std::string each(const std::vector<double>& numbers, Say say, const char* separator = ", ") {
  std::string list;
  for (const double number : numbers)
    if constexpr (std::is_same_v<decltype(say(number)), double>)
      add(list, fmt::format("{:g}: {:.4f}", number, say(number)), separator);
    else
      add(list, fmt::format("{:g}: {}", number, say(number)), separator);
  return list;
}

/// Returns the verdict on a claim that either holds or does not.
inline ledger::ClaimVerdict decided(bool holds) {
  return holds ? ledger::ClaimVerdict::confirmed : ledger::ClaimVerdict::refuted;
}
/// Returns confirmed if the claim holds in all cases, refuted if in none, else qualified.
inline ledger::ClaimVerdict of_all(int holds, int tried) {
  if (holds == tried) return ledger::ClaimVerdict::confirmed;
  return holds == 0 ? ledger::ClaimVerdict::refuted : ledger::ClaimVerdict::qualified;
}

}  // namespace rederive::rocking_block
