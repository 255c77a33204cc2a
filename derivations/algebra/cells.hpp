// Statements in one symbol, piece by piece: cut where something in them is 0, they may be decided on every
// piece, and at every point between.
#pragma once

#include <derivations/algebra/links.hpp>
#include <derivations/algebra/zeros.hpp>

namespace rederive {

/// The range of one symbol, cut into open pieces and the points between, and those at closed ends.
struct Cells {
  GiNaC::ex symbol;
  std::vector<GiNaC::ex> points;
  std::vector<Symbols> pieces;  ///< with the range of the piece
};

/// Cut where residuals, slopes of residuals, conditions and what stands between bars is exactly 0: at
/// multiples of pi/12, small rationals, powers of sqrt(e), parts of sqrt(2) and sqrt(3), and the zeros of
/// factors up to the second degree. Nothing where the statements have other symbols or givens, or are cut
/// nowhere and the range is open.
std::optional<Cells> cells_of(const Question& question);

/// The same, cut also at rational points on either side of where a residual, or its slope, turns without
/// being 0: between them its range shows its sign, beyond them it grows or falls. Nothing where none turns.
std::optional<Cells> cells_beside_turns(const Question& question);

/// Where two statements may differ, and few other points show it. In one symbol: where they may be cut, at
/// ends of the range, and closely beside these; and far out. In up to four: at small whole numbers, and where
/// all are pi, or a half or a quarter of it; and at more of the points that samples are taken at.
std::vector<Root> places_of(const Question& question);

/// What is known of both statements on one piece.
enum class Cell {
  unknown,
  compared,  ///< both have values all over it
  empty      ///< neither holds, for at least one has no value anywhere on it; or the only one that counts has
             ///< none
};
/// Looks at one of `Cells::pieces`. Throws Undecidable.
Cell look_at(const Question& question, const Symbols& piece);

/// Something that one of two statements in one symbol divides by, and at a zero of which the other one holds:
/// sin(x)/tan(x) = 1 has no solution, cos(x) = 1 has some. Not of strict ones.
std::optional<GiNaC::ex> lost_at_a_zero(const Question& question);

/// Whether at a point both hold, or neither does; or both expressions have one value there, or neither has;
/// or what is assumed excludes the point.
bool agree_at(const GiNaC::ex& point, const Cells& cells, const Question& question);

}  // namespace rederive
