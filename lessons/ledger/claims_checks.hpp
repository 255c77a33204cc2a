// The checks, by part of the paper: name in claims.toml → function.
#pragma once

#include <lessons/ledger/claims.hpp>

namespace rederive {

using Checks = std::map<std::string, Check>;

Checks checks_of_symbols();       ///< decided by algebra alone
Checks checks_of_rows();          ///< decided by the verdicts of the ledger's rows
Checks checks_of_start();         ///< section 1: how it starts, its modes, friction
Checks checks_of_impact();        ///< section 2: restitution and reactions
Checks checks_of_linear_model();  ///< section 3: thresholds of the one-sine pulse
Checks checks_of_one_impact();    ///< section 3: after one impact
Checks checks_of_cosine();        ///< section 3 and Fig. 14: the cosine pulse, initial conditions
Checks checks_of_figures();       ///< section 4: printed numbers and captions
Checks checks_of_minima();        ///< section 4: which mode is least, where, and how much
Checks checks_of_spectra();       ///< section 4 and conclusion 9: periods and Eurocode 8

}  // namespace rederive
