// The search for windows below an amplitude that overturns, among chains of impacts.
#pragma once

#include <numerics/search/stations.hpp>
#include <vector>

namespace rederive::numerics {

/// Stations below `overturns`, which overturns, down to `lowest`: among them one in each window found there.
///
/// The energy with which the pulse leaves the block is a continuous function of the amplitude. Where a chain
/// of impacts goes on until the last push of the pulse begins, it is a row of hills, one for each two impacts
/// that the chain has more, ever narrower towards the amplitude at which the chain just comes to rest, or, at
/// e = 1, towards that at which nothing moves. Each hill is found by the number of impacts before that push,
/// and climbed; a top that overturns is a window. Downwards the hills become lower; once they have done so
/// over several groups, each of more hills than the one before, the search ends.
std::vector<Station> stations_below(const PulseCase& asked, const WindowSearch& search, double lowest,
                                    const Station& overturns);

}  // namespace rederive::numerics
