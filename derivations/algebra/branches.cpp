#include <cmath>
#include <derivations/algebra/branches.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/vanish.hpp>

namespace rederive {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

std::optional<Branch> on_one_branch(const std::string& kind, const ex& x, const Symbols& symbols) {
  const ex &pi = GiNaC::Pi, half = pi / 2;
  const auto weakly = [&](const ex& angle, const ex& low, const ex& high) {
    return is_nonnegative(angle - low, symbols) && is_nonnegative(high - angle, symbols);
  };
  const auto strictly = [&](const ex& angle, const ex& low, const ex& high) {
    return sign_of(angle - low, symbols) > 0 && sign_of(high - angle, symbols) > 0;
  };
  const int half_turns = kind == "sin" || kind == "cos" ? 2 : 1;
  for (const int k : {0, 1, -1, 2, -2}) {
    const ex near = x - k * half_turns * pi;
    if (kind == "sin")
      for (const ex& angle : {near, pi - near})
        if (weakly(angle, -half, half)) return Branch{kind, angle};
    if ((kind == "tan" && strictly(near, -half, half)) || (kind == "cot" && strictly(near, 0, pi)))
      return Branch{kind, near};
    const ex turned = kind == "sin" ? near - half : near;  // sin x = cos(x - π/2)
    if (half_turns == 1 || !weakly(turned, -pi, pi)) continue;
    const bool right = is_nonnegative(turned, symbols), left = is_nonnegative(-turned, symbols);
    return Branch{"cos", right ? turned : left ? -turned : ex(GiNaC::abs(turned))};
  }
  return std::nullopt;
}

bool is_angular(const std::string& kind) {
  return kind == "sin" || kind == "cos" || kind == "tan" || kind == "cot";
}

ex value_at(const std::string& kind, const ex& angle) {
  const ex sine = GiNaC::sin(angle), cosine = GiNaC::cos(angle);
  return kind == "sin" ? sine : kind == "cos" ? cosine : kind == "tan" ? sine / cosine : cosine / sine;
}

std::optional<ex> arc_of(const std::string& kind, const ex& value, const Symbols& symbols) {
  const bool bounded = kind == "sin" || kind == "cos";
  if (bounded && !(is_nonnegative(1 - value, symbols) && is_nonnegative(value + 1, symbols)))
    return std::nullopt;
  const ex arc = kind == "sin"                 ? GiNaC::asin(value)
                 : kind == "cos"               ? GiNaC::acos(value)
                 : kind == "tan"               ? GiNaC::atan(value)
                 : sign_of(value, symbols) > 0 ? GiNaC::atan(1 / value)
                                               : GiNaC::Pi / 2 - GiNaC::atan(value);
  const ex twelfths = (12 * arc / GiNaC::Pi).evalf();
  if (!is_a<numeric>(twelfths) || !ex_to<numeric>(twelfths).is_real()) return std::nullopt;
  const double turns = ex_to<numeric>(twelfths).to_double();
  const ex near = static_cast<int>(std::lround(turns)) * GiNaC::Pi / 12;
  try {
    if (std::fabs(turns - std::round(turns)) < 1e-9 && vanishes(value_at(kind, near) - value, symbols))
      return near;
  } catch (const std::exception&) {  // outside of the class, or near a pole: it stays as it is
  }
  return arc;
}

}  // namespace rederive
