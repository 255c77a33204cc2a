// Recorded ground accelerations, read from files.
#pragma once

#include <numerics/motion/ground_motion.hpp>
#include <optional>
#include <string>
#include <vector>

namespace rederive::numerics {

/// A recorded ground acceleration: the value `acceleration[i]`, in g, at `time[i]`, in seconds. Times
/// increase.
struct Record {
  std::vector<double> time, acceleration;
  bool is_headed = false;  ///< whether the header of the file gave the time step and the unit
};

/// Units of acceleration; 1 gal = 0.01 m/s^2.
enum class RecordUnit { g, metres_per_second_squared, gal };

/// How `read_record` reads a file without a header, and what it does about missing values.
struct RecordOptions {
  std::optional<RecordUnit> unit = {};  ///< of columns; without one, g, and values above 10 g are refused
  double step = 0;                      ///< seconds between the values of a file without times
  bool interpolate = false;             ///< draw a straight line across missing values instead of refusing
  std::optional<double> accept = {};    ///< a value that looks like a mark for "missing" but is a measurement
};

/// Returns the record in a file.
///
/// The file has two columns "time value", or values alone with `options.step`, or a header that gives step,
/// count and unit, in which case `options.unit` and `options.step` have no effect: PEER AT2 (five columns of
/// 15 characters, which may run together), K-NET and KiK-net ASCII (the mean is subtracted, because their
/// counts have an unknown zero level), ESM ASCII, SMC, or COSMOS. Among columns, lines that begin with # or %
/// are comments.
///
/// Throws std::invalid_argument with file and line if the file cannot be read, if its header describes
/// another quantity than acceleration or another number of values than the file has, if a value is missing or
/// marked as missing, or if samples are missing between two times.
Record read_record(const std::string& file, const RecordOptions& options = {});

/// Returns the record, multiplied by `scale` and interpolated linearly, as the ground motion of a block with
/// the alpha and p of `block`.
GroundMotion record_motion(const Record& record, const Block& block, double scale = 1);

}  // namespace rederive::numerics
