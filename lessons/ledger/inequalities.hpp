// Assumptions that are inequalities: what they say of one symbol.
#pragma once

#include <derivations/rocking_block/paper_symbols.hpp>
#include <optional>
#include <vector>

namespace rederive {

/// greater > lesser, or greater >= lesser.
struct Inequality {
  GiNaC::ex greater, lesser;
  bool weak = false;

  GiNaC::ex difference() const { return greater - lesser; }
};

/// One link of a chain, as expressions. Throws SyntaxError.
Inequality inequality(const Relation& link, const Symbols& symbols);

/// symbol > bound or symbol < bound.
struct Bound {
  GiNaC::ex symbol, value;
  bool is_lower;
};

/// The inequality solved for that symbol: linear in it, after what divides has been multiplied by, with
/// factors of a sign that is known over the declared ranges. Nothing where that fails.
std::optional<Bound> solved_for(const GiNaC::ex& symbol, const GiNaC::ex& difference, const Symbols& symbols);

/// The same points as inequalities without bars around anything of unknown sign, that must hold together:
/// |u| < c is u < c and -c < u, and so is u^2 < c^2 for the square of one symbol and numbers. What cannot be
/// said so is left as it is.
std::vector<Inequality> without_bars(const Inequality& inequality, const Symbols& symbols);

/// Where an inequality holds, if it is one of one symbol, and all its zeros are known, and those of what it
/// needs to have a value, as assumptions of which one holds then: "0 < x < pi" of sin(x) > 0 with -pi < x <=
/// pi; or "x > 0" and "x < 0" of x*y > 0, after which that can be solved for y. Nothing where that is not
/// known; an empty list where it never holds.
std::optional<std::vector<std::string>> pieces(const Inequality& inequality, const Symbols& symbols);

}  // namespace rederive
