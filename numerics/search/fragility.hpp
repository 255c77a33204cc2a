// How likely a block overturns as ground motions grow: J. W. Baker, Efficient analytical fragility function
// fitting using dynamic structural analysis, Earthquake Spectra 31 (2015) 579-599.
#pragma once

#include <numerics/records/record.hpp>
#include <optional>
#include <string>
#include <vector>

namespace rederive::numerics {

/// What a record is scaled by: its largest |acceleration|, in g, or |velocity|, in m/s.
enum class Peak { acceleration, velocity };

/// The velocity is that of ground at rest before the record, whose samples are joined by straight lines.
double peak_of(const Record& record, Peak peak);

/// Whether the record overturns the block when it is scaled to each of these peaks.
/// Throws std::invalid_argument for a record of a peak that cannot be scaled: 0.
std::vector<char> overturned_at(const Block& block, Model model, const Record& record, Peak peak,
                                const std::vector<double>& peaks);

/// An estimate, and the 95 % interval about it.
struct Estimate {
  double value, low, high;
};

/// The symmetric matrix ((aa ab) (ab bb)) of an intercept a and a slope b.
struct LineCovariance {
  double aa = 0, ab = 0, bb = 0;
};

/// The probability of overturning Phi((ln x - ln median)/beta) at a peak x.
class LognormalCurve {
 public:
  /// Phi(intercept + slope ln x). Intervals reach so many standard deviations.
  LognormalCurve(double intercept, double slope, const LineCovariance& covariance, double reach);

  Estimate median() const;
  Estimate beta() const;
  Estimate at(double peak) const;

 private:
  /// Of what has these derivatives by intercept and slope.
  double width(double by_intercept, double by_slope) const;

  double intercept_, slope_;
  LineCovariance covariance_;
  double reach_;
};

struct LognormalFit {
  std::optional<LognormalCurve> curve;
  std::string why_none;  ///< where the likelihood has no maximum, or that of no fragility
};

/// Fits outcomes[record][level] at increasing positive `peaks` by maximum likelihood, eq (11) of Baker. One
/// record is there at all levels, so that its outcomes are not independent, as they are taken to be there:
/// that does not bias the curve, but its intervals have to come from the scatter between records. They are
/// those of Student's t by the jackknife: what one Newton step changes when a record is left out (R. G.
/// Miller, Biometrika 61 (1974) 1-15; S. R. Lipsitz et al., Biometrics 50 (1994) 842-846).
LognormalFit lognormal_fit(const std::vector<double>& peaks, const std::vector<std::vector<char>>& outcomes);

}  // namespace rederive::numerics
