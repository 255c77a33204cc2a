#include <derivations/program/data_folder.hpp>
#include <derivations/rocking_block/emission.hpp>
#include <derivations/rocking_block/energy.hpp>
#include <derivations/rocking_block/impact.hpp>
#include <derivations/rocking_block/initial_conditions.hpp>
#include <derivations/rocking_block/initiation.hpp>
#include <derivations/rocking_block/overturning_after_one_impact.hpp>
#include <derivations/rocking_block/paper.hpp>
#include <derivations/rocking_block/sliding.hpp>
#include <emitted/rocking_block_symbols.hpp>

namespace rederive::rocking_block {
using namespace program;
using namespace paper;

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

Paper make_paper() {
  Paper paper{.title = title,
              .equations = data_folder() / "equations.toml",
              .derivations = all_derivations(),
              .look_alikes = look_alikes,
              .has_names_in_words = true,
              .theorems = "theorems.toml",
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
