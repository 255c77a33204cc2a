// sin(x) = 0 for any real x: where everything repeats itself, x may be taken from one period.
#pragma once

#include <derivations/algebra/unwrap.hpp>
#include <lessons/ledger/assumed.hpp>

namespace rederive {

/// Declares symbols over one period, (-pi, pi] mostly, that may be any number, and that stand nowhere but in
/// arguments of circular functions, linear and with rational factors, neither in the statement nor in what is
/// assumed; and in that somewhere. Not those that are small. What holds over the period holds everywhere.
/// Adds those of period 2*pi to what is periodic. Throws BadInput where the statement cannot be read.
void keep_to_one_period(const ProveRequest& request, Context& context);

/// Of sin(x) = sin(y), or with cos and tan, where all is the same for x + 2*pi: "x = y" and "x = pi - y",
/// but for whole turns. Else nothing.
std::vector<std::string> same_turns(const Sides& sides, const Context& context);

}  // namespace rederive
