// rocking map --hdf5: what others read, and what an interrupted run leaves.
#include <doctest/doctest.h>

#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>

#include "run_program.hpp"

namespace fs = std::filesystem;

namespace {

using Arguments = std::vector<std::string>;

const Arguments small{"map", "--omega", "1:5:8", "--amplitude", "1:3:5", "--threads", "1"};

Result map_with(const Arguments& more, const Arguments& call = small) {
  Arguments all = call;
  all.insert(all.end(), more.begin(), more.end());
  return run_program("rocking", all);
}

/// Whether the program was built with HDF5; if not, the test is skipped.
bool has_hdf5() {
  const TemporaryFolder folder;
  const Result result = map_with({"--hdf5", folder.path / "map.h5"});
  if (result.err.find("no HDF5") == std::string::npos) return true;
  CHECK(result.exit_code == 2);
  skip("built without HDF5");
  return false;
}

void write_bytes(const fs::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

std::string as_bytes(const std::vector<int>& codes) {
  return {reinterpret_cast<const char*>(codes.data()), codes.size() * sizeof(int)};
}

void check_refused(const Arguments& more, const std::string& names) {
  const Result result = map_with(more);
  CHECK(result.exit_code == 2);
  CHECK(result.out.empty());
  CHECK_MESSAGE(result.err.find(names) != std::string::npos, result.err);
}

}  // namespace

TEST_CASE("h5py and xarray open a map with its axes, and what it was computed from") {
  if (!has_hdf5() || !has_tool("/usr/bin/python3")) return;
  if (run_program("/usr/bin/python3", {"-c", "import h5py, xarray, h5netcdf"}).exit_code != 0) {
    skip("h5py, xarray or h5netcdf is not installed");
    return;
  }
  const TemporaryFolder folder;
  const std::string file = folder.path / "map.h5";
  const Result written = map_with({"--hdf5", file, "--json", "--model", "nonlinear"});
  REQUIRE_MESSAGE(written.exit_code == 0, written.err);
  const Result read = run_program("/usr/bin/python3", {"-c", R"(
import sys, json, h5py, xarray
map = xarray.open_dataset(sys.argv[1], engine="h5netcdf")
with h5py.File(sys.argv[1]) as file:
    print(json.dumps({
        "dims": map.code.dims, "integers": map.code.dtype == "int32", "codes": map.code.values.tolist(),
        "omega_ratios": map.omega_ratio.values.tolist(), "amplitudes": map.amplitude.values.tolist(),
        "chunked": file["code"].chunks is not None, "scales": [file["code"].dims[k].keys() for k in (0, 1)],
        "units": [file[name].attrs["units"] for name in ("omega_ratio", "amplitude", "code")],
        "attributes": {name: value if isinstance(value, str) else float(value)
                       for name, value in file.attrs.items()}}))
)",
                                                       file});
  REQUIRE_MESSAGE(read.exit_code == 0, read.err);
  const auto found = nlohmann::json::parse(read.out), asked = nlohmann::json::parse(written.out);
  CHECK(found["dims"] == nlohmann::json{"omega_ratio", "amplitude"});
  CHECK(found["scales"] == nlohmann::json{{"omega_ratio"}, {"amplitude"}});
  CHECK(found["integers"] == true);
  CHECK(found["chunked"] == true);
  for (const char* name : {"codes", "omega_ratios", "amplitudes"}) CHECK(found[name] == asked[name]);
  const auto& attributes = found["attributes"];
  CHECK(attributes["model"] == "nonlinear");
  CHECK(attributes["pulse"] == "one-sine");
  CHECK(attributes["alpha"] == 0.25);
  CHECK(attributes["unit"] == asked["unit"]);
  CHECK(("Rederive " + attributes["version"].get<std::string>() + "\n") ==
        run_program("rocking", {"--version"}).out);
}

TEST_CASE("a run goes on from the rows that an interrupted one left, and computes the others") {
  if (!has_hdf5()) return;
  const TemporaryFolder folder;
  const std::string file = folder.path / "map.h5", part = file + ".part";
  const Result whole = map_with({"--hdf5", file, "--json"});
  REQUIRE(whole.exit_code == 0);
  CHECK(!fs::exists(part));
  const auto codes = nlohmann::json::parse(whole.out)["codes"].get<std::vector<std::vector<int>>>();
  std::vector<int> all;
  for (const auto& column : codes) all.insert(all.end(), column.begin(), column.end());
  const std::string bytes = read_file(file);
  const std::size_t at = bytes.find(as_bytes(all));
  REQUIRE(at != std::string::npos);

  std::vector<int> left = all;  // row 2 tells by a code of its own that it was not computed again
  std::fill(left.begin() + 10, left.begin() + 15, 77);
  std::fill(left.begin() + 17, left.end(), std::numeric_limits<int>::min());
  write_bytes(part, std::string(bytes).replace(at, left.size() * sizeof(int), as_bytes(left)));
  fs::remove(file);
  const Result resumed = map_with({"--hdf5", file, "--json"});
  REQUIRE_MESSAGE(resumed.exit_code == 0, resumed.err);
  auto expected = codes;
  expected[2].assign(5, 77);
  CHECK(nlohmann::json::parse(resumed.out)["codes"] == nlohmann::json(expected));
  CHECK(!fs::exists(part));
  std::fill(all.begin() + 10, all.begin() + 15, 77);
  CHECK(read_file(file) == std::string(bytes).replace(at, all.size() * sizeof(int), as_bytes(all)));
}

TEST_CASE("a run that was killed leaves what the next one takes up, to the same bytes") {
  if (!has_hdf5()) return;
  const TemporaryFolder folder;
  const Arguments large{"map",       "--omega", "0.2:10:300", "--amplitude", "1:12:300",
                        "--threads", "1",       "--model",    "nonlinear"};
  const std::string whole = folder.path / "whole.h5", file = folder.path / "map.h5";
  REQUIRE(map_with({"--hdf5", whole}, large).exit_code == 0);
  std::string call = quoted(std::string(REDERIVE_PROGRAMS) + "/rocking");
  for (const auto& word : large) call += " " + quoted(word);
  run_program("/bin/sh", {"-c", call + " --hdf5 " + quoted(file) + " & run=$!\n" + "while [ ! -e " +
                                    quoted(file + ".part") + " ] && kill -0 $run; do sleep 0.01; done\n" +
                                    "kill -9 $run; wait $run"});
  if (!fs::exists(file)) CHECK(fs::exists(file + ".part"));
  REQUIRE(map_with({"--hdf5", file}, large).exit_code == 0);
  CHECK(read_file(file) == read_file(whole));
  CHECK(std::distance(fs::directory_iterator(folder.path), fs::directory_iterator()) == 2);
}

TEST_CASE("what another map, or something else, left is refused and kept") {
  if (!has_hdf5()) return;
  const TemporaryFolder folder;
  const std::string file = folder.path / "map.h5", part = file + ".part";
  REQUIRE(map_with({"--hdf5", part}).exit_code == 0);  // all rows are there
  const std::string bytes = read_file(part);
  check_refused({"--hdf5", file, "--alpha", "0.3"}, "alpha is 0.25 there, and 0.3 here");
  check_refused({"--hdf5", file, "--model", "nonlinear"}, "model is linear there, and nonlinear here");
  check_refused({"--hdf5", file, "--tolerance", "1e-9"}, "tolerance");
  check_refused({"--hdf5", file, "--engine", "gsl"}, "engine");
  check_refused({"--hdf5", file, "--pulse", "cosine"}, "pulse");
  check_refused({"--hdf5", file, "--thetadot0", "0.01"}, "thetadot0");
  const Result other =
      run_program("rocking", {"map", "--omega", "1:6:8", "--amplitude", "1:3:5", "--hdf5", file});
  CHECK(other.exit_code == 2);
  CHECK(other.err.find("--omega is another there") != std::string::npos);
  CHECK(read_file(part) == bytes);
  CHECK(!fs::exists(file));
  write_bytes(part, "no map");
  check_refused({"--hdf5", file}, "map.h5.part");
  CHECK(read_file(part) == "no map");
  fs::remove(part);
  check_refused({"--hdf5", folder.path / "no" / "map.h5"}, "no/map.h5");
  check_refused({"--hdf5", folder.path}, folder.path);
  check_refused({"--hdf5", "/dev/null"}, "/dev/null");
  check_refused({"--hdf5", ""}, "a file needs a name");
}
