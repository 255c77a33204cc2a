// The paper's closed forms for the least amplitude: their names, and what they depend on.
#pragma once

#include <derivations/numbers/ball.hpp>
#include <numerics/motion/overturning.hpp>
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

/// What the closed forms depend on, with all known digits: omega_p/p, e, theta_0/alpha and
/// thetadot_0/(alpha p).
struct ExactCase {
  Ball omega_ratio, restitution, angle, velocity;
};

/// Returns the values of `asked` as exact numbers.
ExactCase exact_case_of(const PulseCase& asked);

/// A root of a form: amplitude = 1/sin(psi), for (103) 1/cos(psi), in units of alpha g; the times are p t;
/// impact_time is 0 for a form without impact.
struct ExactRoot {
  Ball amplitude, psi, impact_time, pulse_end;
};

/// Thrown where balls with more bits are needed for a certain answer.
struct NotCertain : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace rederive::numerics
