// Lets Coq check the scripts.
#pragma once

#include <derivations/kernel/scripts.hpp>
#include <functional>

namespace rederive::ledger {

/// What coqc says about a lemma.
struct Checked {
  bool passed = false;
  std::string error;                ///< the message of coqc if it has not passed
  std::vector<std::string> axioms;  ///< the axioms of all lemmas that passed, by Print Assumptions
};

/// Returns whether coqc is installed.
bool has_coq();

/// Compiles the scripts in a temporary folder and returns a result for each lemma. A lemma that does not pass
/// is left out, and the others are tried again. Calls `progress` with the name of each file. Throws
/// std::runtime_error if the prelude does not compile.
std::vector<Checked> check(const paper::Paper& paper, const std::vector<kernel::Lemma>& lemmas,
                           const std::function<void(const std::string&)>& progress);

}  // namespace rederive::ledger
