// The built-in paper: "On the Overturning Instability of a Rectangular Rigid Block Under Ground Excitation".
#pragma once

#include <derivations/paper/paper.hpp>

namespace rederive::rocking_block {

/// The paper, built on the first call.
const paper::Paper& paper();

}  // namespace rederive::rocking_block
