// The angles at which a sine, a cosine, a tangent or a cotangent grows or falls.
#pragma once

#include <derivations/rocking_block/paper_symbols.hpp>
#include <optional>
#include <string>

namespace rederive {

/// "sin", "cos", "tan" or "cot".
bool is_angular(const std::string& kind);

/// sin x, tan x = sin x/cos x …
GiNaC::ex value_at(const std::string& kind, const GiNaC::ex& angle);

/// A function of angles, and an angle on [-π/2, π/2] for sin, [0, π] for cos, (-π/2, π/2) for tan, (0, π) for
/// cot.
struct Branch {
  std::string kind;
  GiNaC::ex angle;
};

/// The same value as that of such an angle: of x, x ± 2π … or, for sines, π - x; a cosine of -x or |x|, too;
/// and a sine that both grows and falls is the cosine of |x - π/2|. Nothing where x is on none of them for
/// all values in the declared ranges.
std::optional<Branch> on_one_branch(const std::string& kind, const GiNaC::ex& x, const Symbols& symbols);

/// The angle there whose sine … is a constant: a multiple of π/12 as such. Nothing where there is none.
std::optional<GiNaC::ex> arc_of(const std::string& kind, const GiNaC::ex& value, const Symbols& symbols);

}  // namespace rederive
