// A proof that somebody else can check: everything that the engine chose, so that only polynomials are left.
#pragma once

#include <derivations/algebra/phases.hpp>
#include <derivations/algebra/prove.hpp>
#include <nlohmann/json.hpp>

namespace rederive {

/// The certificate of a statement that has been proved:
///   left, right   the statement: sides and the operators between them
///   given         what names in it stand for
///   divisors      everything that it divides by, but for numbers: must not vanish
///   never zero    what was declared so, "x - y" for x != y
///   parts of divisors  of which factors are made, each with what it is times to be one of those; or with
///                 which of them it is the `square of`, or a half or a quarter of that, and `more` that is
///                 not negative
///   slopes        expressions whose range does not show their sign: its `sign`, `in` one name, whatever the
///                 others are, and `how` it is seen: not of the other sign at the low (or high) end, with a
///                 `slope` that grows or falls from there; at both ends, with a `bend`, the slope of the
///                 slope; inside the range as it stands, or in another form that is then its `slope`, and at
///                 the ends. With other names, what it is `at low` and `at high`; `by` is positive, and the
///                 last slope is taken times that. Of a layer "of" it has no sign itself, but `grows`, or
///                 falls for a sign of -1
///   ranges        where the other names live; what `declared` has beside them, neither statement holds in,
///                 or one has no value there
///   cut           the names x whose range is cut at x = 0, mostly none: |x| stands there
///   pieces        of the domain, in the order x < 0, x > 0 (the last name turns first), each with
///     steps       what every function is in generators: powers of e, roots and function values with names of
///                 their own, "$z3" (certificate_steps.hpp)
///     links       why the two say the same: for two expressions one; for relations as many as it takes to
///                 have every link of both statements in one
/// A link has (certificate_links.hpp)
///   left, right   the `links` of that statement that are taken together, one mostly, by their numbers, and
///                 the `layers` taken off their sides, the outermost first: functions that grow, or `falls`,
///                 where function(left) and function(right) are the sides; "of", where it is a text in one
///                 name, over the range of which it grows, at two names within that range; "even of", where
///                 it is the same for x and -x: then it grows with the squares of names, of which the sizes
///                 are within that range; "*", where the sides differ by factor·(left - right) of a `factor`
///                 like the one below; of two inequalities a positive `sum`: one of them holds; the
///                 expression, or the `residual` of what is left, as a quotient of polynomials in generators
///   factor        of parts that are never 0, with their exponents; `more` of a part that is 0 only where one
///                 of the residuals is; `bounds`, where `times` the part is that `residual`, not negative,
///                 and `more`; so is one that `divides` it, with what it is times;
///                 so is one that is 0 only where some names are what its `zeros` say, for it is share·
///                 (name - at)^power + more, or is 0 there and grows, and one of the residuals is 0 there
///   cofactor      not 0 itself: left·cofactor = factor·right·cofactor modulo the relations of the generators
/// or, of a link that follows from those of the other side, left or right alone and what it
///   follows       from: times·residual = Σ factor·(product of the residuals of links) + more, where terms
///                 without an equation and more are not negative; or with minus the square of the residual;
///                 of an equation times may be a `product` of parts that are never 0, as in a factor
/// or, of a link that always holds, or never: left or right alone, with its residual in a `form` that shows
/// it, or as a product of `parts` of which each shows its own sign, with their exponents; or of which a^2 -
/// (a - residual)^2 is the form, for a = `roots`, not negative, one after another; and `holds`. One of each
/// side that never holds is enough. Or of a statement in one name, `in` which the whole `range` is cut
/// into cells: each has an open range, and a certificate over it; or none, where neither statement holds, or
/// one has no value. All is text in our own syntax. What was assumed is not in it, but what that was taken
/// to say: `given`, `ranges`, `never zero` and the cases. Throws Undecidable where the statement is not
/// proved, or where nothing like this is found.
nlohmann::ordered_json certificate(const Relation& left, const Relation& right, const Symbols& symbols,
                                   const std::vector<Given>& given);

/// Of a statement that was proved under one of several assumptions each, of which one holds: its `left`,
/// `right` and `cases`, a certificate for each, in which `given` is another.
nlohmann::ordered_json certificate_of_cases(const std::vector<nlohmann::ordered_json>& cases);

}  // namespace rederive
