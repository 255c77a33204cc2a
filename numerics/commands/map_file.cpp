#include <numerics/commands/map_file.hpp>
#include <stdexcept>

#ifdef REDERIVE_HDF5

#include <fmt/format.h>
#include <hdf5.h>
#include <hdf5_hl.h>
#include <unistd.h>

#include <algorithm>
#include <derivations/emit/program.hpp>
#include <limits>

namespace rederive::inline numeric {
namespace {

namespace fs = std::filesystem;

constexpr int not_yet = std::numeric_limits<int>::min();

/// What HDF5 gave us, closed when it goes.
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

std::variant<std::string, double> read_attribute(hid_t where, const std::string& name) {
  const Handle attribute(H5Aopen(where, name.c_str(), H5P_DEFAULT), H5Aclose),
      type(H5Aget_type(attribute), H5Tclose), text = text_type();
  if (H5Tget_class(type) == H5T_STRING) {
    char* words = nullptr;
    check(H5Aread(attribute, text, &words));
    const std::string value = words == nullptr ? "" : words;
    H5free_memory(words);
    return value;
  }
  double value = 0;
  check(H5Aread(attribute, H5T_NATIVE_DOUBLE, &value));
  return value;
}

/// A dataset that lies ready in the file, so that filling it changes nothing else there.
Handle create_dataset(hid_t file, const char* name, hid_t type, const std::vector<hsize_t>& sizes,
                      const std::vector<hsize_t>& chunk, const std::string& meaning) {
  const int rank = static_cast<int>(sizes.size());
  const Handle space(H5Screate_simple(rank, sizes.data(), nullptr), H5Sclose),
      properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  check(H5Pset_obj_track_times(properties, false));
  check(H5Pset_alloc_time(properties, H5D_ALLOC_TIME_EARLY));
  if (!chunk.empty()) {
    check(H5Pset_chunk(properties, rank, chunk.data()));
    check(H5Pset_fill_value(properties, H5T_NATIVE_INT, &not_yet));
  }
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

void create(const fs::path& path, const Attributes& attributes, const std::vector<double>& ratios,
            const std::vector<double>& amplitudes) {
  const Handle file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
  for (const auto& [name, value] : attributes) write_attribute(file, name, value);
  const Handle x = create_axis(file, "omega_ratio", ratios, "frequency of the pulse omega_p/p"),
               y = create_axis(file, "amplitude", amplitudes, "amplitude of the pulse a_p/(alpha g)");
  const hsize_t columns = ratios.size(), rows = amplitudes.size(), cells = 16384;
  const Handle code = create_dataset(
      file, "code", H5T_STD_I32LE, {columns, rows},
      {std::clamp<hsize_t>(cells / rows, 1, columns), std::min(rows, cells)},
      "side * (impacts + 1) where the block overturns, to theta < 0 or > 0; 0 where it is safe");
  check(H5DSattach_scale(code, x, 0));
  check(H5DSattach_scale(code, y, 1));
}

std::vector<double> axis_of(hid_t file, const char* name) {
  const Handle set(H5Dopen2(file, name, H5P_DEFAULT), H5Dclose), space(H5Dget_space(set), H5Sclose);
  std::vector<double> values(
      static_cast<std::size_t>(std::max<hssize_t>(0, H5Sget_simple_extent_npoints(space))));
  check(H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
  return values;
}

std::string shown(const std::variant<std::string, double>& value) {
  return value.index() == 0 ? std::get<0>(value) : fmt::format("{}", std::get<1>(value));
}

}  // namespace

struct MapFile::Open {
  fs::path target, part;
  std::size_t columns, rows;
  Handle file, code;

  std::invalid_argument refusal(const std::string& why) const {
    return std::invalid_argument(fmt::format("cannot write '{}': {}", target.string(), why));
  }

  /// What is unlike in the file that is there; empty if it can be taken up.
  std::string difference(const Attributes& attributes, const std::vector<double>& ratios,
                         const std::vector<double>& amplitudes) const {
    for (const auto& [name, value] : attributes)
      if (const auto there = read_attribute(file, name); there != value)
        return fmt::format("{} is {} there, and {} here", name, shown(there), shown(value));
    if (axis_of(file, "omega_ratio") != ratios) return "--omega is another there";
    if (axis_of(file, "amplitude") != amplitudes) return "--amplitude is another there";
    return "";
  }
};

MapFile::MapFile(const fs::path& file, const Attributes& attributes, const std::vector<double>& omega_ratios,
                 const std::vector<double>& amplitudes)
    : open_(std::make_unique<Open>()) {
  H5dont_atexit();  // what could not be written would be tried once more there, and crash
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // its failures come out as ours
  std::error_code error;
  open_->target = fs::is_symlink(fs::symlink_status(file, error)) ? fs::weakly_canonical(file, error) : file;
  open_->part = open_->target.string() + ".part";
  open_->columns = omega_ratios.size(), open_->rows = amplitudes.size();
  if (const auto status = fs::status(open_->target, error);
      fs::exists(status) && !fs::is_regular_file(status))
    throw open_->refusal("it is no regular file");
  if (!fs::exists(open_->part, error)) {
    const fs::path begun = open_->part.string() + std::to_string(::getpid());
    const Uninterrupted whole;
    try {
      create(begun, attributes, omega_ratios, amplitudes);
      fs::rename(begun, open_->part);
    } catch (const std::runtime_error&) {
      fs::remove(begun, error);
      throw open_->refusal("the file cannot be created there");
    }
  }
  std::string unlike;
  try {
    open_->file = Handle(H5Fopen(open_->part.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
    unlike = open_->difference(attributes, omega_ratios, amplitudes);
    open_->code = Handle(H5Dopen2(open_->file, "code", H5P_DEFAULT), H5Dclose);
  } catch (const std::runtime_error&) {
    throw open_->refusal(fmt::format(
        "'{}' is no map that a run of this program left, or in use by another run", open_->part.string()));
  }
  if (!unlike.empty())
    throw open_->refusal(
        fmt::format("'{}' was left by a run for another map: {}. Finish that, or remove the file",
                    open_->part.string(), unlike));
}

MapFile::~MapFile() = default;

std::vector<std::vector<int>> MapFile::known() const {
  std::vector<int> all(open_->columns * open_->rows);
  const Handle space(H5Dget_space(open_->code), H5Sclose);
  hsize_t sizes[2] = {0, 0};
  if (H5Sget_simple_extent_ndims(space) != 2 || H5Sget_simple_extent_dims(space, sizes, nullptr) != 2 ||
      sizes[0] != open_->columns || sizes[1] != open_->rows ||
      H5Dread(open_->code, H5T_NATIVE_INT, H5S_ALL, H5S_ALL, H5P_DEFAULT, all.data()) < 0)
    throw open_->refusal(fmt::format("'{}' is damaged: remove it", open_->part.string()));
  std::vector<std::vector<int>> codes(open_->columns);
  for (std::size_t i = 0; i < codes.size(); ++i) {
    const auto from = all.begin() + static_cast<std::ptrdiff_t>(i * open_->rows),
               to = from + static_cast<std::ptrdiff_t>(open_->rows);
    if (std::find(from, to, not_yet) == to) codes[i].assign(from, to);
  }
  return codes;
}

void MapFile::keep(const OutcomeMap& map, std::size_t first, std::size_t last) {
  std::vector<int> codes;
  for (std::size_t i = first; i < last; ++i)
    codes.insert(codes.end(), map.codes[i].begin(), map.codes[i].end());
  const hsize_t start[2] = {first, 0}, size[2] = {last - first, open_->rows};
  const Handle there(H5Dget_space(open_->code), H5Sclose), here(H5Screate_simple(2, size, nullptr), H5Sclose);
  if (H5Sselect_hyperslab(there, H5S_SELECT_SET, start, nullptr, size, nullptr) < 0 ||
      H5Dwrite(open_->code, H5T_NATIVE_INT, here, there, H5P_DEFAULT, codes.data()) < 0 ||
      H5Fflush(open_->file, H5F_SCOPE_LOCAL) < 0)
    throw open_->refusal("the disk takes no more");
}

void MapFile::finish() {
  open_->code = Handle(), open_->file = Handle();
  std::error_code error;
  fs::rename(open_->part, open_->target, error);
  if (error) throw open_->refusal(error.message());
}

std::filesystem::path MapFile::part() const { return open_->part; }

}  // namespace rederive::inline numeric

#else

namespace rederive::inline numeric {

struct MapFile::Open {};
MapFile::MapFile(const std::filesystem::path&, const Attributes&, const std::vector<double>&,
                 const std::vector<double>&) {
  throw std::invalid_argument("--hdf5: this program was built where there is no HDF5 (Debian: libhdf5-dev)");
}
MapFile::~MapFile() = default;
std::vector<std::vector<int>> MapFile::known() const { return {}; }
void MapFile::keep(const OutcomeMap&, std::size_t, std::size_t) {}
void MapFile::finish() {}
std::filesystem::path MapFile::part() const { return {}; }

}  // namespace rederive::inline numeric

#endif
