// Ground accelerations: one-sine and one-cosine pulses, and records; in units of alpha g against tau = p t.
#pragma once

#include <numerics/motion/block.hpp>
#include <optional>
#include <string>
#include <vector>

namespace rederive::numerics {

enum class Pulse { sine, cosine };

/// One smooth stretch of ground acceleration, from <= tau <= to: the line value + slope (tau - from), or the
/// sine amplitude sin(omega (tau - from) + phase), then without a line.
struct Piece {
  Real from = 0, to = 0;
  Real value = 0, slope = 0;
  Real amplitude = 0, omega = 1, phase = 0;
};

/// Stretches one after the other from tau = 0; the ground is still after the last.
using GroundMotion = std::vector<Piece>;

/// The pulse from the instant when rocking can start, `amplitude` = a_p/(alpha g) >= `level` = start_level:
/// sine a sin(w tau + psi) with a sin(psi) = level until tau = (2 pi - psi)/w, eq (52);
/// cosine a cos(w tau + psi) with a cos(psi) = level until tau = (3 pi/2 - psi)/w, section 3.
/// Throws std::invalid_argument for values out of range.
GroundMotion pulse_motion(Pulse pulse, Real omega_ratio, Real amplitude, Real level);

/// The phase psi of that pulse, and when it ends.
Real pulse_phase(Pulse pulse, Real amplitude, Real level);
Real pulse_end(Pulse pulse, Real omega_ratio, Real psi);

Real ground_at(const Piece& piece, Real time);

struct Range {
  Real low, high;
};
/// Bounds of the ground acceleration over [from, to] inside the piece.
Range ground_range(const Piece& piece, Real from, Real to);
/// The greatest size of the ground acceleration over [from, to] inside the piece, in double precision.
double most_ground(const Piece& piece, Real from, Real to);

/// A stretch of time in which |ground| is above the level, and the side to which it drives the block.
struct Push {
  Real from, to;
  int side;
};
/// The pushes in the piece, in order: a positive ground acceleration drives the block to theta < 0.
std::vector<Push> pushes(const Piece& piece, Real level);

/// A recorded acceleration: (seconds, value in g).
struct Record {
  std::vector<double> time, acceleration;
  bool is_headed = false;  ///< step and unit stood in the file's header
};

enum class RecordUnit { g, metres_per_second_squared, gal };

struct RecordOptions {
  std::optional<RecordUnit> unit = {};  ///< of columns; where it is not given, g, but not above 10 g
  double step = 0;                      ///< seconds between the values of a file without times
  bool interpolate = false;             ///< what is missing is taken from its neighbours, and not refused
  std::optional<double> accept = {};    ///< a value that looks like a filling, and is meant
};

/// Reads two columns "time value", values alone with a `step`, or a file whose header gives step, count and
/// unit
/// (`unit` and `step` then do not matter): PEER AT2 (five columns of 15 characters, which may run together),
/// K-NET and KiK-net ASCII (the mean is taken off, for their counts stand about an unknown level), ESM ASCII,
/// SMC, or COSMOS. Lines of columns that begin with # or % are comments. Throws std::invalid_argument with
/// file and line for what cannot be read, among it a header of another quantity than acceleration, or with
/// another count than the file has values, values that stand for none, and times between which samples are
/// missing.
Record read_record(const std::string& file, const RecordOptions& options = {});
inline Record read_record(const std::string& file, RecordUnit unit, double step = 0) {
  return read_record(file, RecordOptions{.unit = unit, .step = step});
}

/// The record interpolated linearly, for a block with this alpha and p.
GroundMotion record_motion(const Record& record, const Block& block, double scale = 1);

}  // namespace rederive::numerics
