// How a check says what it found.
#pragma once

#include <lessons/ledger/claims.hpp>
#include <lessons/ledger/claims_workbench.hpp>

namespace rederive {

/// "2.3577": `digits` after the point.
std::string fixed(double value, int digits = 4);
/// "1: 1.4183, 2: 2.3499": pairs of a number and what belongs to it.
std::string paired(const std::vector<std::pair<double, double>>& pairs, int digits = 4);

Finding confirmed(std::string found, std::string explanation);
Finding refuted(std::string found, std::string explanation);
Finding qualified(std::string found, std::string explanation);
Finding undecided(std::string found, std::string explanation);
/// confirmed where it holds, else refuted.
Finding decided(bool holds, std::string found, std::string if_so, std::string if_not);

/// The verdict of a row of equations.toml, as a word.
std::string row_verdict(Workbench& bench, const std::string& id);
/// Whether all these rows are proved, proved_under or approximation.
bool rows_stand(Workbench& bench, const std::vector<std::string>& ids);
/// "(24b) proved, (88) refuted: right is …".
std::string rows_say(Workbench& bench, const std::vector<std::string>& ids);

}  // namespace rederive
