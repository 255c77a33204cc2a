// Compiled only with HDF5.
#include <H5Cpp.h>
#include <hdf5_hl.h>

#include <algorithm>
#include <numerics/commands/map_file.hpp>
#include <stdexcept>

namespace rederive::numerics::commands {
namespace {

void check(herr_t status) {
  if (status < 0) throw H5::Exception();
}

void write_attribute(H5::H5Object& of, const std::string& name,
                     const std::variant<std::string, double>& value) {
  H5::StrType text(H5::PredType::C_S1, H5T_VARIABLE);
  text.setCset(H5T_CSET_UTF8);
  if (const auto* words = std::get_if<std::string>(&value))
    of.createAttribute(name, text, H5::DataSpace()).write(text, *words);
  else
    of.createAttribute(name, H5::PredType::IEEE_F64LE, H5::DataSpace())
        .write(H5::PredType::NATIVE_DOUBLE, &std::get<double>(value));
}

H5::DataSet create_dataset(H5::H5File& file, const char* name, const H5::PredType& type,
                           const std::vector<hsize_t>& sizes, const std::vector<hsize_t>& chunk,
                           const std::string& meaning) {
  const int rank = static_cast<int>(sizes.size());
  H5::DSetCreatPropList properties;
  check(H5Pset_obj_track_times(properties.getId(), false));
  if (!chunk.empty()) properties.setChunk(rank, chunk.data());
  H5::DataSet set = file.createDataSet(name, type, H5::DataSpace(rank, sizes.data()), properties);
  write_attribute(set, "long_name", meaning);
  write_attribute(set, "units", "1");
  return set;
}

H5::DataSet create_axis(H5::H5File& file, const char* name, const std::vector<double>& values,
                        const std::string& meaning) {
  H5::DataSet axis = create_dataset(file, name, H5::PredType::IEEE_F64LE, {values.size()}, {}, meaning);
  axis.write(values.data(), H5::PredType::NATIVE_DOUBLE);
  check(H5DSset_scale(axis.getId(), name));
  return axis;
}

/// Fills an empty file with the map, its axes, and what it was computed from.
void fill(H5::H5File& file, const Attributes& attributes, const OutcomeMap& map) {
  for (const auto& [name, value] : attributes) write_attribute(file, name, value);
  const H5::DataSet x = create_axis(file, "omega_ratio", map.omega_ratios,
                                    "frequency of the pulse omega_p/p"),
                    y = create_axis(file, "amplitude", map.amplitudes,
                                    "amplitude of the pulse a_p/(alpha g)");
  const hsize_t columns = map.omega_ratios.size(), rows = map.amplitudes.size(), cells = 16384;
  const H5::DataSet code = create_dataset(
      file, "code", H5::PredType::STD_I32LE, {columns, rows},
      {std::clamp<hsize_t>(cells / rows, 1, columns), std::min(rows, cells)},
      "side * (impacts + 1) where the block overturns, to theta < 0 or > 0; 0 where it is safe");
  check(H5DSattach_scale(code.getId(), x.getId(), 0));
  check(H5DSattach_scale(code.getId(), y.getId(), 1));
  std::vector<int> codes;
  codes.reserve(columns * rows);
  for (const auto& column : map.codes) codes.insert(codes.end(), column.begin(), column.end());
  code.write(codes.data(), H5::PredType::NATIVE_INT);
}

}  // namespace

std::string hdf5_of(const Attributes& attributes, const OutcomeMap& map) try {
  H5::H5Library::dontAtExit();  // what could not be written would be tried once more there, and crash
  H5::Exception::dontPrint();
  H5::FileAccPropList in_memory;
  in_memory.setCore(1 << 20, false);
  // HDF5 looks whether there is a file of the name, even so: there is none of this one.
  H5::H5File file("/dev/null/map", H5F_ACC_TRUNC, H5::FileCreatPropList::DEFAULT, in_memory);
  fill(file, attributes, map);
  file.flush(H5F_SCOPE_LOCAL);
  std::string image(
      static_cast<std::size_t>(std::max<ssize_t>(H5Fget_file_image(file.getId(), nullptr, 0), 0)), '\0');
  if (image.empty() || H5Fget_file_image(file.getId(), image.data(), image.size()) < 0) throw H5::Exception();
  return image;
} catch (const H5::Exception&) {
  throw std::runtime_error("HDF5 cannot make a file of the map");
}

}  // namespace rederive::numerics::commands
