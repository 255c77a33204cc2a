// rocking map --hdf5: what others read, and what an interrupted run leaves.
#include <doctest/doctest.h>

#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <tests/run_program.hpp>

namespace fs = std::filesystem;

namespace {

using Arguments = std::vector<std::string>;

const Arguments small{"map", "--omega", "1:5:8", "--amplitude", "1:3:5", "--threads", "1"};

Result map_with(const Arguments& more, const Arguments& call = small) {
  Arguments all = call;
  all.insert(all.end(), more.begin(), more.end());
  return run_program("rocking", all);
}

/// Whether the program was built with HDF5; if not, --hdf5 is refused, and the test is skipped.
bool has_hdf5() {
#ifdef REDERIVE_HDF5
  return true;
#else
  const TemporaryFolder folder;
  CHECK(map_with({"--hdf5", folder.path / "map.h5"}).exit_code == 2);
  skip("built without HDF5");
  return false;
#endif
}

void write_bytes(const fs::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

template <class Value>
std::string as_bytes(const Value& value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

std::uint32_t crc_of(const std::string& bytes) {
  std::uint32_t crc = ~0U;
  for (const unsigned char byte : bytes) {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ (crc % 2 == 1 ? 0xEDB88320U : 0U);
  }
  return ~crc;
}

/// Leaves FILE.part with all columns: the HDF5 file, which is larger, may not be written.
std::string left_part(const fs::path& file, const Arguments& call = small) {
  std::string command = "ulimit -f 4 && " + quoted(std::string(REDERIVE_PROGRAMS) + "/rocking");
  for (const auto& word : call) command += " " + quoted(word);
  const Result result = run_program("/bin/bash", {"-c", command + " --hdf5 " + quoted(file)});
  REQUIRE_MESSAGE(result.exit_code == 2, result.err);
  REQUIRE(!fs::exists(file));
  return read_file(file.string() + ".part");
}

/// A column of FILE.part: a mark, a checksum, codes.
std::string column_in_part(std::uint32_t checksum_of_head, std::uint64_t column, const std::string& codes) {
  return "done" + as_bytes(crc_of(as_bytes(checksum_of_head) + as_bytes(column) + codes)) + codes;
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

TEST_CASE("a run goes on from the columns that an interrupted one left, and computes the others") {
  if (!has_hdf5()) return;
  const TemporaryFolder folder;
  const fs::path file = folder.path / "map.h5", part = file.string() + ".part";
  const Result whole = map_with({"--hdf5", file, "--json"});
  REQUIRE(whole.exit_code == 0);
  CHECK(!fs::exists(part));
  const std::string bytes = read_file(file);
  auto expected = nlohmann::json::parse(whole.out)["codes"].get<std::vector<std::vector<int>>>();
  fs::remove(file);

  std::string left = left_part(file);  // column 2 tells by a code of its own that it was not computed again
  constexpr std::size_t sizes = std::string_view("rederive map 1\n").size(), place = 8 + 5 * sizeof(int);
  std::uint64_t size = 0;
  std::uint32_t checksum = 0;
  std::memcpy(&size, left.data() + sizes, sizeof size);
  std::memcpy(&checksum, left.data() + sizes + sizeof size, sizeof checksum);
  const std::size_t head = sizes + sizeof size + sizeof checksum + size;
  REQUIRE(left.size() == head + 8 * place);
  REQUIRE(checksum == crc_of(left.substr(head - size, size)));
  std::string codes, strange;
  for (int j = 0; j < 5; ++j) codes += as_bytes(expected[2][j]), strange += as_bytes(77);
  REQUIRE(left.substr(head + 2 * place, place) == column_in_part(checksum, 2, codes));
  left.replace(head + 2 * place, place, column_in_part(checksum, 2, strange));
  left.replace(head + 3 * place, place, column_in_part(checksum, 2, strange));  // in another's place
  left.replace(head + 5 * place, 3 * place, std::string(3 * place, '\0'));
  write_bytes(part, left);
  const Result resumed = map_with({"--hdf5", file, "--json"});
  REQUIRE_MESSAGE(resumed.exit_code == 0, resumed.err);
  expected[2].assign(5, 77);
  CHECK(nlohmann::json::parse(resumed.out)["codes"] == nlohmann::json(expected));
  CHECK(!fs::exists(part));
  CHECK(read_file(file) != bytes);
}

TEST_CASE("whatever byte of FILE.part is damaged or missing, the map is the same, or it is refused") {
  if (!has_hdf5()) return;
  const TemporaryFolder folder;
  const fs::path file = folder.path / "map.h5", part = file.string() + ".part";
  REQUIRE(map_with({"--hdf5", file}).exit_code == 0);
  const std::string whole = read_file(file);
  fs::remove(file);
  const std::string left = left_part(file);
  int refused = 0, same = 0;
  const auto check = [&](const std::string& damaged, std::size_t at) {
    write_bytes(part, damaged);
    fs::remove(file);
    const Result result = map_with({"--hdf5", file});
    INFO("byte " << at << ": " << result.err);
    CHECK((result.exit_code == 0 || result.exit_code == 2));
    if (result.exit_code == 0) CHECK(read_file(file) == whole);
    if (result.exit_code == 2) CHECK(read_file(part) == damaged);
    ++(result.exit_code == 0 ? same : refused);
  };
  for (std::size_t at = 0; at < left.size(); at += 7) {
    std::string damaged = left;
    damaged[at] = static_cast<char>(damaged[at] ^ (1 << at % 8));
    check(damaged, at);
  }
  for (std::size_t at = 0; at < left.size(); at += 50) check(left.substr(0, at), at);
  CHECK(refused > 20);
  CHECK(same > 20);
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
  const std::string file = folder.path / "map.h5", part = file + ".part", bytes = left_part(file);
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
  check_refused({"--hdf5", ""}, "the name of the file is empty");
  write_bytes(part, bytes);
  fs::create_hard_link(part, folder.path / "of another name");
  check_refused({"--hdf5", file}, "is not an ordinary file of yours alone");
}
