#include <derivations/program/data_folder.hpp>
#include <derivations/rocking_block/emission.hpp>
#include <derivations/rocking_block/energy.hpp>
#include <derivations/rocking_block/impact.hpp>
#include <derivations/rocking_block/initial_conditions.hpp>
#include <derivations/rocking_block/initiation.hpp>
#include <derivations/rocking_block/overturning_after_one_impact.hpp>
#include <derivations/rocking_block/paper.hpp>
#include <derivations/rocking_block/sliding.hpp>

namespace rederive::rocking_block {

namespace {

Derivations all_derivations() {
  Derivations rows;
  derive_kinematics(rows);
  derive_equation_of_motion(rows);
  derive_energy(rows);
  derive_initiation(rows);
  derive_impact(rows);
  derive_sliding(rows);
  derive_pulse(rows);
  derive_linear_response(rows);
  derive_overturning_without_impact(rows);
  derive_overturning_impact_during_pulse(rows);
  derive_overturning_impact_after_pulse(rows);
  derive_initial_conditions(rows);
  return rows;
}

Theorems theorems() {
  return {.prelude = {"Solutions.v", "Limits.v"},
          .files = {{"Initiation.v", "88"},
                    {"Derivations.v", "88"},
                    {"Impact.v", "88"},
                    {"Responses.v", "88"},
                    {"Critical.v", "88"},
                    {"Instances.v", "88"},
                    {"Claims.v", "88"},
                    {"Thresholds.v", "71"},
                    {"ImpactInPulse.v", "88"},
                    {"AfterImpact.v", "88"},
                    {"OneImpact.v", "88"}},
          .assumptions = {
              {"newton", "H and V are what accelerates the centre of mass: H = m ü_c, V - m g = m ÿ_c"},
              {"euler", "the moment of H and V about the centre of mass is J_c θ̈"},
              {"rotation", "the block is rigid, and turns about its corner: the positions of its points"},
              {"linearised",
               "(56), (97), (u21) and (u29) are taken as exact; theorems bound what that leaves out"},
              {"criterion",
               "overturning at the least amplitude: the motion comes to rest at the corner, after all time"},
              {"rest", "before the pulse the block stands: θ = 0, θ̇ = 0"}}};
}

Paper make_paper() {
  Paper paper{.title = "On the Overturning Instability of a Rectangular Rigid Block Under Ground Excitation",
              .equations = data_folder() / "equations.toml",
              .derivations = all_derivations(),
              .look_alikes = {{"b", "h"},
                              {"h", "b"},
                              {"R", "h"},
                              {"J_o", "J_c"},
                              {"J_c", "J_o"},
                              {"p", "omega_p"},
                              {"omega_p", "p"},
                              {"alpha", "theta"},
                              {"psi", "alpha"},
                              {"T_ex", "t_i"},
                              {"t_i", "T_ex"},
                              {"x", "y"},
                              {"y", "x"}},
              .has_names_in_words = true,
              .theorems = theorems(),
              .emission = emission,
              .source = ""};  // its rows are in the data folder; a path here would name the building machine
  paper.declare(all_symbols());
  paper.free_letters = {"t", "r", "d"};
  return paper;
}

}  // namespace

const Paper& paper() {
  static const Paper made = make_paper();
  return made;
}

}  // namespace rederive::rocking_block
