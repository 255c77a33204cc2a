// A map in an HDF5 file that grows while it is computed.
#pragma once

#include <filesystem>
#include <memory>
#include <numerics/map.hpp>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace rederive::inline numeric {

/// Names and values that belong to a map: what it was computed from.
using Attributes = std::vector<std::pair<std::string, std::variant<std::string, double>>>;

/// FILE.part until all codes are in it, then FILE. Datasets omega_ratio(omega_ratio), amplitude(amplitude),
/// which are dimension scales, and code(omega_ratio, amplitude); the attributes at the root.
/// All that has no code yet holds the least int: so a run that was killed leaves nothing that misleads.
class MapFile {
 public:
  /// Begins FILE.part, or takes up one that holds the same attributes and axes. Throws std::invalid_argument
  /// if there is one with others, if it cannot be written, or if this program was built without HDF5.
  MapFile(const std::filesystem::path& file, const Attributes& attributes,
          const std::vector<double>& omega_ratios, const std::vector<double>& amplitudes);
  ~MapFile();

  /// The codes that an earlier run left: empty where it had none.
  std::vector<std::vector<int>> known() const;
  /// Columns first <= i < last of the map.
  void keep(const OutcomeMap& map, std::size_t first, std::size_t last);
  /// Gives the file its name.
  void finish();
  std::filesystem::path part() const;

 private:
  struct Open;
  std::unique_ptr<Open> open_;
};

}  // namespace rederive::inline numeric
