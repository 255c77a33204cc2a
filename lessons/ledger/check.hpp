// Coq's word on the scripts.
#pragma once

#include <derivations/kernel/scripts.hpp>
#include <functional>

namespace rederive {

/// What coqc says of a lemma.
struct Checked {
  bool passed = false;
  std::string error;                ///< else what coqc says
  std::vector<std::string> axioms;  ///< what all that passed assume together, by Print Assumptions
};

/// Whether coqc can be run.
bool has_coq();

/// Compiles the scripts in a temporary folder. A lemma that does not pass is left out, and the others are
/// tried again; so each gets its own verdict. `progress` is told the files. Throws std::runtime_error where
/// the prelude itself does not compile.
std::vector<Checked> check(const Paper& paper, const std::vector<Lemma>& lemmas,
                           const std::function<void(const std::string&)>& progress);

}  // namespace rederive
