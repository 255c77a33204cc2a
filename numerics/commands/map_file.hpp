// A map in an HDF5 file, and what an interrupted run leaves.
#pragma once

#include <filesystem>
#include <memory>
#include <numerics/search/map.hpp>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace rederive::numerics::commands {

/// Names and values that belong to a map: what it was computed from.
using Attributes = std::vector<std::pair<std::string, std::variant<std::string, double>>>;

/// A map that becomes an HDF5 file once all codes are there: datasets omega_ratio(omega_ratio),
/// amplitude(amplitude), which are dimension scales, and code(omega_ratio, amplitude); the attributes at the
/// root. Until then the columns that are done are kept in FILE.part (MapPart), so that a run that was killed
/// leaves nothing that misleads.
class MapFile {
 public:
  /// Begins FILE.part, or takes up one that holds the same attributes and axes. Throws BadInput if there is
  /// one with others or FILE cannot be written, std::invalid_argument if this program was built without HDF5.
  MapFile(const std::filesystem::path& file, const Attributes& attributes,
          const std::vector<double>& omega_ratios, const std::vector<double>& amplitudes);
  ~MapFile();

  /// The codes that an earlier run left: empty where it had none.
  std::vector<std::vector<int>> known() const;
  /// Columns first <= i < last of the map.
  void keep(const OutcomeMap& map, std::size_t first, std::size_t last);
  /// Writes FILE, all codes being there, and removes FILE.part.
  void finish(const OutcomeMap& map);
  std::filesystem::path part() const;

 private:
  struct Open;
  std::unique_ptr<Open> open_;
};

}  // namespace rederive::numerics::commands
