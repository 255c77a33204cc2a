// What the checks of the claims share: judged rows, thresholds and motions, each computed once, and words.
#pragma once

#include <fmt/format.h>

#include <derivations/paper/ledger.hpp>
#include <lessons/ledger/claims.hpp>
#include <numerics/search/closed_form.hpp>
#include <numerics/search/windows.hpp>

namespace rederive::rocking_block {

/// One bench serves all claims of one run, and keeps what is expensive.
class Bench {
 public:
  /// A row of equations.toml. Throws std::out_of_range if there is none with that id.
  const Entry& row(const std::string& id);
  Verdict verdict_of(const std::string& id) { return row(id).proof.verdict; }
  /// Whether it is proved, proved_under or approximation.
  bool stands(const std::string& id);
  /// "(24b) proved, (88) refuted: right is …".
  std::string say(const std::vector<std::string>& ids);

  /// All windows up to 12 alpha*g.
  const std::vector<numerics::Window>& windows(const numerics::PulseCase& asked);
  /// The least amplitude that overturns at all, with its code.
  numerics::Window least(const numerics::PulseCase& asked);
  /// The least amplitude without impact, and the least and the largest after one impact, by bisection on the
  /// simulation, in alpha*g; 0 if none up to 20 alpha*g.
  double mode_1(const numerics::PulseCase& asked) { return edge(asked, -1, false); }
  double mode_2(const numerics::PulseCase& asked) { return edge(asked, 2, false); }
  double mode_2_upper(const numerics::PulseCase& asked) { return edge(asked, 2, true); }
  double mode(int impacts, const numerics::PulseCase& asked) {
    return impacts == 0 ? mode_1(asked) : mode_2(asked);
  }
  /// omega_p/p at which the critical impact meets the end of the pulse, and at which mode_2 ends, 0 if at
  /// none; see claims_ratios.hpp.
  double handover_of(const numerics::PulseCase& asked);
  double end_of(const numerics::PulseCase& asked);

 private:
  double edge(const numerics::PulseCase& asked, int code_under_sine, bool upper);

  std::map<std::string, Entry> entries_;
  std::map<std::string, std::vector<numerics::Window>> windows_;
  std::map<std::string, double> edges_, ratios_;
};

/// Decides a claim with what the bench has.
using BenchCheck = Finding (*)(Bench&, const Claim&);
/// The name of a check in claims.toml → the function.
using Checks = std::map<std::string, BenchCheck>;
Checks checks_of_symbols();       ///< decided by derivations and by the verdicts of the rows
Checks checks_of_start();         ///< section 1: how it starts, its modes, friction
Checks checks_of_impact();        ///< section 2: restitution and reactions
Checks checks_of_linear_model();  ///< section 3: one-sine pulse, without and after one impact
Checks checks_of_cosine();        ///< section 3 and Fig. 14: the cosine pulse, initial conditions
Checks checks_of_figures();       ///< section 4: printed numbers and captions
Checks checks_of_spectra();       ///< section 4 and conclusion 9: least amplitudes, periods, Eurocode 8

/// The block of the captions: alpha = 0.25, p = 2.14; without a restitution that of (46).
numerics::Block paper_block(std::optional<double> restitution = {});
/// One-sine or one-cosine pulse on it, from rest.
numerics::PulseCase pulse_case(double omega_ratio, numerics::Model model = numerics::Model::linear,
                               std::optional<double> restitution = {});
numerics::PulseCase cosine_case(double omega_ratio);
/// With theta_0 in rad and thetadot_0 in rad/s.
numerics::PulseCase with_initial(numerics::PulseCase asked, double theta_0, double thetadot_0);
/// The same pulse on a block of another alpha.
numerics::PulseCase with_alpha(numerics::PulseCase asked, double alpha,
                               std::optional<double> restitution = {});

/// The roots of one closed form, and the first of them.
std::vector<numerics::ClosedForm> roots_of(numerics::Form form, const numerics::PulseCase& asked);
numerics::ClosedForm root_of(numerics::Form form, const numerics::PulseCase& asked);
/// Amplitude in units of g*tan(alpha) instead of alpha*g.
double in_tangent(const numerics::PulseCase& asked, double amplitude);
/// Before it overturns.
int impacts_of(const numerics::Window& window);

/// The pulse of a case as ground motion, the motion under it, and 400 states of that until the pulse ends.
numerics::GroundMotion ground_of(const numerics::PulseCase& asked, double amplitude);
numerics::Response motion_at(const numerics::PulseCase& asked, double amplitude);
std::vector<numerics::Sample> samples_at(const numerics::PulseCase& asked, double amplitude);
/// When an event of that kind comes first; 0 if never.
double first_time(const numerics::Response& motion, numerics::EventKind kind);

/// "2.3577": `digits` after the point.
std::string fixed(double value, int digits = 4);
/// Adds an item to a list in words.
void add(std::string& list, const std::string& item, const char* separator = ", ");
/// "1: 1.4183, 2: 2.3499": what is said (text, or a number to four digits) at each number.
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

inline ClaimVerdict decided(bool holds) { return holds ? confirmed : refuted; }
/// Confirmed where it holds of all, refuted where of none, else qualified.
inline ClaimVerdict of_all(int holds, int tried) {
  return holds == tried ? confirmed : holds == 0 ? refuted : qualified;
}

}  // namespace rederive::rocking_block
