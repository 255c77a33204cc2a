// A derivation: a result, and the named steps that lead to it.
#pragma once

#include <derivations/language/symbols.hpp>
#include <functional>
#include <string>
#include <vector>

namespace rederive::mechanics {

/// One line of an argument: a sentence and, if it has one, the formula at which it arrives, left = right.
struct Step {
  std::string says;
  GiNaC::ex left, right;  ///< both 0 if the step has words only
  std::string relation = "=";
  std::string cites = {};  ///< the id of the row of the paper whose result this is, if it is one
};

/// A result with its argument. `left relation right` is the result in the symbols of the paper. It never
/// comes from the printed page.
struct Derivation {
  GiNaC::ex left, right;
  std::string relation = "=";  ///< "=", "<", "<=", ">", ">="
  std::vector<Step> steps;
  std::vector<language::Given>
      given;  ///< what the names stand for: J_o = 4/3 m R², h = R cos α … (put in before comparing)
  /// Holds only under this, which the paper leaves unsaid: a relation, and words behind : or ;. Empty if
  /// always.
  std::string assumption;
  int order = 0;           ///< > 0: a Taylor approximation to this order …
  std::string small;       ///< … in these symbols ("alpha, theta")
  bool is_stated = false;  ///< it has no step of its own: it states its result
};

/// A derivation is a pure function.
using Derive = std::function<Derivation()>;

}  // namespace rederive::mechanics
