// The two frequencies at which overturning after one impact changes, to six digits and quickly.
#pragma once

#include <functional>
#include <numerics/overturning.hpp>
#include <optional>

namespace rederive {

/// omega_p/p at which the critical impact comes exactly when the pulse ends; `threshold` gives the least
/// amplitude after one impact. Empty if there is none between 3 and 12. numerics/special.hpp finds it to the
/// last bit.
std::optional<double> ratio_of_handover(
    const PulseCase& asked, const std::function<std::optional<double>(const PulseCase&)>& threshold);
/// omega_p/p at which no amplitude overturns after one impact any more: the best margin of a motion that
/// strikes after the pulse is 0. Empty if there is none between 3 and 12.
std::optional<double> ratio_of_end(const PulseCase& asked);

}  // namespace rederive
