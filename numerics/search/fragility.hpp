// How likely a block overturns as ground motions grow: J. W. Baker, Efficient analytical fragility function
// fitting using dynamic structural analysis, Earthquake Spectra 31 (2015) 579-599.
#pragma once

#include <numerics/records/record.hpp>
#include <optional>
#include <string>
#include <vector>

namespace rederive::numerics {

/// The quantity by which a record is scaled: its largest |acceleration|, in g, or |velocity|, in m/s.
enum class Peak { acceleration, velocity };

/// Returns the peak of a record. Its samples are joined by straight lines, and the ground is at rest before
/// them.
double peak_of(const Record& record, Peak peak);

/// Returns, for each of `peaks`, 1 if the record scaled to this peak overturns the block, else 0. Throws
/// std::invalid_argument if the peak of the record is 0.
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
  /// Makes the curve Phi(intercept + slope ln x), whose intervals reach `reach` standard deviations to either
  /// side.
  LognormalCurve(double intercept, double slope, const LineCovariance& covariance, double reach);

  Estimate median() const;
  Estimate beta() const;
  Estimate at(double peak) const;

 private:
  /// Returns half the interval of a quantity that has these derivatives by intercept and slope.
  double width(double by_intercept, double by_slope) const;

  double intercept_, slope_;
  LineCovariance covariance_;
  double reach_;
};

/// The reason for which outcomes have no curve: the likelihood has no maximum, or its maximum is not a
/// fragility.
struct NoCurve {
  enum class Kind {
    none_overturns,  ///< up to the peak `low`
    all_overturn,    ///< from the peak `low` on
    one_amplitude,   ///< there is only one peak
    one_record,      ///< there is only one record
    none_between,    ///< none overturns up to `low`, and all do from `high` on
    one_between,     ///< none overturns below `low`, and all do above
    share_falls      ///< the share of the records does not grow with the peak
  };
  Kind kind;
  double low = 0, high = 0;
};

/// Returns the words for it: "none overturns up to 0.5".
std::string words_for(const NoCurve& reason);

struct LognormalFit {
  std::optional<LognormalCurve> curve;
  std::optional<NoCurve> why_none;  ///< if there is no curve
};

/// Returns the curve of greatest likelihood, eq (11) of Baker, for outcomes[record][level] at increasing
/// positive `peaks`. That equation takes all outcomes as independent, but each record is scaled to all
/// levels. This does not bias the curve, but its intervals must come from the scatter between records: they
/// are Student's, by the jackknife, which takes one Newton step with each record left out (R. G. Miller,
/// Biometrika 61 (1974) 1-15; S. R. Lipsitz et al., Biometrics 50 (1994) 842-846).
LognormalFit lognormal_fit(const std::vector<double>& peaks, const std::vector<std::vector<char>>& outcomes);

}  // namespace rederive::numerics
