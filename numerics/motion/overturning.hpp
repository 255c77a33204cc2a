// Overturned or safe: decided by energy when the ground has come to rest. Overturning with and without an
// impact: N. Makris and Y. Roussos, Geotechnique 50 (2000) 243-262; J. Zhang and N. Makris, J. Eng. Mech. 127
// (2001) 473-483.
#pragma once

#include <array>
#include <numerics/motion/response.hpp>
#include <string>
#include <string_view>

namespace rederive::numerics {

/// The distances of the free motion after the ground motion from each way of overturning; positive: it
/// overturns.
struct Margins {
  Real outward;    ///< without a further impact: velocity above that which just reaches theta = alpha, (68),
                   ///< (75)
  Real returning;  ///< after one more impact: e times the impact velocity above that which reaches theta =
                   ///< alpha, (94)
};

/// Returns the margins of the free motion from `at` on `side`. Energy is conserved between impacts, (22), and
/// multiplied by e^2 at each. A block that has once come back below the barrier can never pass it, so one
/// more impact decides.
Margins free_motion_margins(const Block& block, Model model, int side, const Point& at);

/// The outcome of a motion. The code is side*(impacts+1), or 0 = safe; impacts are counted since the block
/// last left rest.
struct Outcome {
  int code = 0;
  int impacts = 0;  ///< until it overturns, or during the ground motion if safe; 0 if that leaves it at rest
  int rests = 0;
  int side = 0;       ///< on which side the ground motion leaves it
  bool lies = false;  ///< fell flat during the ground motion (nonlinear)
  Margins margins{-1,
                  -1};  ///< brought back to the last launch by the rate of the separatrix, e^-(tau - launch)
};

/// The parts of words_for: {} stands for the side and the impacts, or for the number of impacts.
inline constexpr const char* words_of_overturning = "overturns to {} {}";
inline constexpr std::array words_of_sides{"theta < 0", "theta > 0"},
    words_of_directions{"the left", "the right"};
inline constexpr std::array words_of_impacts{"without impact", "after one impact", "after {} impacts"};

/// A motion that the ground motion leaves, seen on the side theta > 0; T is double or Real.
template <class T>
struct FreeMotion {
  int side = 1;               ///< on which the block is
  T angle = 0, velocity = 0;  ///< theta/alpha and thetadot/(alpha p), mirrored if side < 0
  T since_launch = 0;         ///< time since the last start or impact
  int impacts = 0, rests = 0;
  bool lies = false;
};

/// Returns the outcome of free motion: energy decides.
Outcome outcome_of_free_motion(const Block& block, Model model, const FreeMotion<Real>& from);
Outcome outcome_of_free_motion(const Block& block, Model model, const FreeMotion<double>& from);

/// The names of the sides in the words for an overturning: "theta < 0" and "theta > 0", or "the left" and
/// "the right".
enum class SideNames { signs, directions };

/// Returns the words for a code side*(impacts+1): "safe", "overturns to theta < 0 after one impact".
std::string words_for(int code, SideNames names = SideNames::signs);

/// Returns the name of the outcome with this code: "safe" or "overturned".
std::string_view outcome_name(int code);

/// Returns the outcome of a ground motion, followed by the kernel.
Outcome outcome_of(const Block& block, Model model, const GroundMotion& motion, const InitialState& initial);

/// Returns the outcome of a response that stops with the ground motion: after it, energy decides.
Outcome outcome_at_end(const Block& block, Model model, const Response& response);

/// A pulse and a block: everything that an outcome depends on except the amplitude.
struct PulseCase {
  Block block;
  Model model = Model::linear;
  Pulse pulse = Pulse::sine;
  double omega_ratio = 1;
  InitialState initial;
  double tolerance = default_tolerance;
  Engine engine = Engine::taylor;
};

/// Returns the outcome of a pulse of this amplitude in units of alpha g by the second method, whatever
/// `asked.engine` is: closed forms of the linear model, GSL's integrator for the nonlinear one. Below
/// start_level a block at rest is safe; with initial conditions the pulse has no first instant there, and
/// std::invalid_argument is thrown.
Outcome outcome_at(const PulseCase& asked, Real amplitude);

}  // namespace rederive::numerics
