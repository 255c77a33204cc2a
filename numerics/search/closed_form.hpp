// The paper's closed forms for the least amplitude: their roots, each proven and checked against the motion.
#pragma once

#include <derivations/numbers/ball.hpp>
#include <numerics/motion/ground_motion.hpp>
#include <numerics/motion/overturning.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace rederive::numerics {

/// The closed forms of the linear model: (71), (78): from rest, without impact; (86)&(88): from rest, one
/// impact before the pulse ends; (92a)&(96): from rest, one impact after it; (103): cosine pulse, to
/// theta > 0; (104): sine pulse with initial conditions, to theta < 0.
enum class Form { eq71, eq78, eq86_88, eq92a_96, eq103, eq104 };

/// Returns the code side*(impacts+1) of the overturning that begins or ends at a root of the form.
int code_of(Form form);

/// Returns the numbers of the equations that make up the form: {"86", "88"}.
std::vector<std::string> equations_of(Form form);

/// The numbers on which the closed forms depend, with all known digits: omega_p/p, e, theta_0/alpha and
/// thetadot_0/(alpha p).
struct ExactCase {
  numbers::Ball omega_ratio, restitution, angle, velocity;
};

/// Returns the values of `asked` as exact numbers.
ExactCase exact_case_of(const PulseCase& asked);

/// A root of a form: amplitude = 1/sin(psi), for (103) 1/cos(psi), in units of alpha g; the times are p t;
/// impact_time is 0 for a form without impact.
struct ExactRoot {
  numbers::Ball amplitude, psi, impact_time, pulse_end;
};

/// Thrown if a certain answer needs balls with more bits.
struct NotCertain : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The reason for which a root of a closed form is not a least amplitude. Times are p t.
struct Objection {
  enum class Kind {
    crest_comes_later,              ///< the phase of (103) asks for a cosine pulse that has passed its crest
    falls_from_start,               ///< the pulse falls from the start, and a block at rest does not move
    falls_from_start_or_goes_left,  ///< (78): the same, and a pulse that rises turns the block to theta < 0
    impact_too_late,                ///< (86)&(88): the impact, at `time`, is after the pulse ends, at `other`
    impact_too_early,    ///< (92a)&(96): the impact, at `time`, is before the pulse ends, at `other`
    stays_at_rest,       ///< the ground acceleration falls at once, and the block stays at rest
    starts_to_left,      ///< the motion starts with theta < 0, and the form assumes theta > 0
    starts_to_right,     ///< the other way round
    other_first_impact,  ///< the first impact is at `time`, not at `other`
    changes_sign,        ///< an impact at `time`, before the pulse ends; the form assumes none
    second_impact,       ///< a second impact at `time`, before the pulse ends
    upper_edge           ///< the block moves so, but overturns below the amplitude and not above
  };
  Kind kind;
  Real time = 0, other = 0;
};

/// The words for an objection: what is wrong, and further detail, which may be empty.
struct ObjectionWords {
  std::string brief, detail;

  /// Returns "brief: detail", or `brief` if `detail` is empty.
  std::string in_full() const;
};
ObjectionWords words_for(const Objection& objection);

/// Returns why the block does not move as `form` says at `root`, or nothing if it does. The linear motion is
/// followed in balls. Throws NotCertain if their bits are too few.
std::optional<Objection> objection_to(Form form, Pulse pulse, const ExactCase& exact, const ExactRoot& root);

/// A root of a closed form of the linear model, as the nearest doubles and as balls. The amplitude is in
/// units of alpha g, psi in rad, the times are p t.
struct ClosedForm {
  Form form;
  double amplitude, psi;
  std::optional<double> impact_time;  ///< of a form with an impact
  double pulse_end;
  ExactRoot exact;                   ///< contains the root, and is narrow enough for 60 digits and more
  std::optional<Objection> why_not;  ///< why it is not a least amplitude; empty if it is

  /// Returns whether the block moves as the form says.
  bool real() const { return !why_not || why_not->kind == Objection::Kind::upper_edge; }
  /// Returns whether it moves so, and overturns just above the amplitude and not below.
  bool admissible() const { return !why_not; }
};

/// Returns every root of the forms that apply to the pulse and the initial conditions, of all or of those in
/// `wanted`, with psi in (0, pi), for (103) in (-pi/2, pi/2), and impact times up to three times the length
/// of the pulse but at most 10 beyond it; 0.01 <= omega_p/p.
///
/// Each root is proven: a continuous function, evaluated in balls, has certain and opposite signs at the ends
/// of a ball. Whether it is admissible is found by following the motion that it describes. The number of bits
/// grows until everything is certain; throws NotCertain if Ball::most_bits are too few.
std::vector<ClosedForm> closed_forms(Pulse pulse, const ExactCase& exact,
                                     const std::vector<Form>& wanted = {});
/// The same for the pulse, block and initial conditions of `asked`, taken as exact.
std::vector<ClosedForm> closed_forms(const PulseCase& asked, const std::vector<Form>& wanted = {});

}  // namespace rederive::numerics
