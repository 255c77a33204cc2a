// Compiled only with HDF5.
#include <hdf5.h>
#include <hdf5_hl.h>

#include <algorithm>
#include <numerics/commands/map_file.hpp>
#include <stdexcept>

namespace rederive::numerics::commands {
using namespace program;
namespace {

/// An object of HDF5, which the destructor closes. The C++ interface of HDF5 would save 20 lines, but its
/// constants take 1.3 ms whenever the program starts.
class Handle {
 public:
  Handle() = default;
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {
    if (id < 0) throw std::runtime_error("HDF5 refuses");
  }
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_), std::swap(close_, other.close_);
    return *this;
  }
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  operator hid_t() const { return id_; }

 private:
  hid_t id_ = -1;
  herr_t (*close_)(hid_t) = nullptr;
};

void check(herr_t status) {
  if (status < 0) throw std::runtime_error("HDF5 refuses");
}

Handle text_type() {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  check(H5Tset_size(type, H5T_VARIABLE));
  check(H5Tset_cset(type, H5T_CSET_UTF8));
  return type;
}

void write_attribute(hid_t where, const std::string& name, const std::variant<std::string, double>& value) {
  const Handle scalar(H5Screate(H5S_SCALAR), H5Sclose), text = text_type();
  const bool is_text = value.index() == 0;
  const Handle attribute(H5Acreate2(where, name.c_str(), is_text ? hid_t{text} : H5T_IEEE_F64LE, scalar,
                                    H5P_DEFAULT, H5P_DEFAULT),
                         H5Aclose);
  const char* words = is_text ? std::get<0>(value).c_str() : nullptr;
  check(is_text ? H5Awrite(attribute, text, &words)
                : H5Awrite(attribute, H5T_NATIVE_DOUBLE, &std::get<1>(value)));
}

Handle create_dataset(hid_t file, const char* name, hid_t type, const std::vector<hsize_t>& sizes,
                      const std::vector<hsize_t>& chunk, const std::string& meaning) {
  const int rank = static_cast<int>(sizes.size());
  const Handle space(H5Screate_simple(rank, sizes.data(), nullptr), H5Sclose),
      properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  check(H5Pset_obj_track_times(properties, false));
  if (!chunk.empty()) check(H5Pset_chunk(properties, rank, chunk.data()));
  Handle set(H5Dcreate2(file, name, type, space, H5P_DEFAULT, properties, H5P_DEFAULT), H5Dclose);
  write_attribute(set, "long_name", meaning);
  write_attribute(set, "units", "1");
  return set;
}

Handle create_axis(hid_t file, const char* name, const std::vector<double>& values,
                   const std::string& meaning) {
  Handle axis = create_dataset(file, name, H5T_IEEE_F64LE, {values.size()}, {}, meaning);
  check(H5Dwrite(axis, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
  check(H5DSset_scale(axis, name));
  return axis;
}

/// Fills an empty file with the map, its axes, and the settings from which it was computed.
void fill(hid_t file, const Attributes& attributes, const OutcomeMap& map) {
  for (const auto& [name, value] : attributes) write_attribute(file, name, value);
  const Handle x = create_axis(file, "omega_ratio", map.omega_ratios, "frequency of the pulse omega_p/p"),
               y = create_axis(file, "amplitude", map.amplitudes, "amplitude of the pulse a_p/(alpha g)");
  const hsize_t columns = map.omega_ratios.size(), rows = map.amplitudes.size(), cells = 16384;
  const Handle code = create_dataset(
      file, "code", H5T_STD_I32LE, {columns, rows},
      {std::clamp<hsize_t>(cells / rows, 1, columns), std::min(rows, cells)},
      "side * (impacts + 1) where the block overturns, to theta < 0 or > 0; 0 where it is safe");
  check(H5DSattach_scale(code, x, 0));
  check(H5DSattach_scale(code, y, 1));
  std::vector<int> codes;
  codes.reserve(columns * rows);
  for (const auto& column : map.codes) codes.insert(codes.end(), column.begin(), column.end());
  check(H5Dwrite(code, H5T_NATIVE_INT, H5S_ALL, H5S_ALL, H5P_DEFAULT, codes.data()));
}

}  // namespace

std::string hdf5_of(const Attributes& attributes, const OutcomeMap& map) {
  constexpr std::size_t growth = 1 << 20;
  H5dont_atexit();  // what could not be written would be tried once more there, and crash
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // its failures come out as ours
  const Handle in_memory(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  check(H5Pset_fapl_core(in_memory, growth, false));
  // HDF5 looks whether there is a file of the name, even so: there is none of this one.
  const Handle file(H5Fcreate("/dev/null/map", H5F_ACC_TRUNC, H5P_DEFAULT, in_memory), H5Fclose);
  fill(file, attributes, map);
  check(H5Fflush(file, H5F_SCOPE_LOCAL));
  const ssize_t size = H5Fget_file_image(file, nullptr, 0);
  std::string image(static_cast<std::size_t>(std::max<ssize_t>(size, 0)), '\0');
  if (size <= 0 || H5Fget_file_image(file, image.data(), image.size()) != size)
    throw std::runtime_error("HDF5 refuses");
  return image;
}

}  // namespace rederive::numerics::commands
