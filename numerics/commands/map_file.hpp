// A map as an HDF5 file, and the file from which an interrupted map continues.
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numerics/search/grid.hpp>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace rederive::numerics::commands {

/// Names and values that belong to a map: what it was computed from.
using Attributes = std::vector<std::pair<std::string, std::variant<std::string, double>>>;

/// Returns the bytes of an HDF5 file: the datasets omega_ratio(omega_ratio) and amplitude(amplitude), which
/// are dimension scales, and code(omega_ratio, amplitude); the attributes are at the root. Only programs that
/// are built with HDF5 have this function.
std::string hdf5_of(const Attributes& attributes, const OutcomeMap& map);

/// The columns of a map in a file FILE.part, written one by one. A column whose checksum is wrong, because
/// the program was killed as it wrote or because the disk has damaged it, counts as not computed.
///
/// The file is a head (a mark, the length and CRC-32 of a JSON text that says what the map is computed from,
/// and that text), and for each column a place of fixed size: a mark, the CRC-32 of the head, the number of
/// the column and its codes, then the codes.
class MapPart {
 public:
  /// Opens the file for a map of `columns` columns of `rows` codes, or begins it, with room for all columns.
  /// `about` is what the map is computed from. Throws BadInput that names `target` if there is no room, or if
  /// the file is in use by another run, belongs to another user, or was left by a run for another map.
  MapPart(std::filesystem::path target, nlohmann::ordered_json about, std::size_t columns, std::size_t rows);
  ~MapPart();
  MapPart(const MapPart&) = delete;
  MapPart& operator=(const MapPart&) = delete;

  /// Returns the codes that the file holds, and an empty column where it holds none.
  std::vector<std::vector<int>> known() const;
  void keep(std::size_t column, const std::vector<int>& codes);
  /// Removes the file, once the map is complete elsewhere.
  void remove();
  const std::filesystem::path& file() const { return file_; }
  const std::filesystem::path& target() const { return target_; }

 private:
  [[noreturn]] void refuse(const std::string& why) const;
  void check_owner() const;
  void begin(const std::string& head);
  void check_head(const nlohmann::ordered_json& about) const;
  std::string read(std::size_t from, std::size_t size) const;
  std::size_t place_of(std::size_t column) const;
  std::uint32_t checksum(std::size_t column, const std::vector<int>& codes) const;

  std::filesystem::path target_, file_;
  std::size_t columns_, rows_;
  std::size_t head_size_ = 0;
  std::uint32_t head_checksum_ = 0;
  int descriptor_ = -1;
};

}  // namespace rederive::numerics::commands
