// The README's worked example, done as it says: a row, a function, a line in the list of its section.
#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <tests/run_program.hpp>

namespace {

const std::string root = REDERIVE_SOURCE;

/// The n-th block fenced as ```language after `heading`.
std::string block(const std::string& heading, const std::string& language, int n) {
  const std::string readme = read_file(root + "/README.md");
  std::size_t place = readme.find(heading);
  REQUIRE(place != std::string::npos);
  const std::string fence = "```" + language + "\n";
  for (int k = 0; k <= n; ++k) {
    place = readme.find(fence, place);
    REQUIRE(place != std::string::npos);
    place += fence.size();
  }
  return readme.substr(place, readme.find("```", place) - place);
}

void write(const std::filesystem::path& file, const std::string& text) { std::ofstream(file) << text; }

}  // namespace

TEST_CASE("adding an equation works as the README says") {
  const TemporaryFolder folder;
  const auto equations = folder.path / "equations.toml";
  write(equations, read_file(root + "/derivations/paper/equations.toml") + "\n" + block("## Add an equation", "toml", 0));

  std::string section = read_file(root + "/derivations/rocking_block/kinematics.cpp");
  const auto list = section.find("Derivations derivations_of_kinematics() {");
  REQUIRE(list != std::string::npos);
  const auto end = section.find("  };\n", list);
  REQUIRE(end != std::string::npos);
  section.insert(end, block("## Add an equation", "cpp", 1));
  section.insert(list, block("## Add an equation", "cpp", 0) + "\n");
  write(folder.path / "kinematics.cpp", section);

  const std::string built = REDERIVE_BINARY;
  const std::string ledger = (folder.path / "ledger").string();
  const Result made = run_program("/bin/bash", {"-c", "cd '" + folder.path.string() + "' && c++ -std=c++20 -O0 -I'" + root + "' -I'" + built +
                                                         "' kinematics.cpp " REDERIVE_LEDGER_OBJECTS " -o ledger"});
  REQUIRE_MESSAGE(made.exit_code == 0, made.err);
  const Result shown = run_program(ledger, {"--equations", equations.string(), "show", "w1", "--json"});
  CHECK(shown.exit_code == 0);
  CHECK(nlohmann::json::parse(shown.out)["verdict"] == "proved");

  // and the new row can turn red like any other
  std::string wrong = read_file(equations);
  wrong.replace(wrong.find("R*(1 - cos(alpha))"), 18, "R*(1 - sin(alpha))");
  write(equations, wrong);
  const Result spoiled = run_program(ledger, {"--equations", equations.string(), "show", "w1", "--json"});
  CHECK(spoiled.exit_code == 1);
  CHECK(nlohmann::json::parse(spoiled.out)["verdict"] == "refuted");
}

TEST_CASE("the library can be used from another CMake project as the README says") {
  const TemporaryFolder folder;
  write(folder.path / "main.cpp", block("## In your own project", "cpp", 0));
  std::filesystem::create_directory_symlink(root, folder.path / "rederive");
  write(folder.path / "CMakeLists.txt", "cmake_minimum_required(VERSION 3.22)\nproject(mine CXX)\nset(CMAKE_CXX_STANDARD 20)\nset(CMAKE_BUILD_TYPE Release)\n"
                                        "add_executable(my_program main.cpp)\n" + block("## In your own project", "cmake", 0));
  const Result made = run_program("/bin/bash", {"-c", "cd '" + folder.path.string() + "' && cmake -G Ninja -DCMAKE_UNITY_BUILD=ON -DCMAKE_CXX_FLAGS_RELEASE=-O0 -B b . && cmake --build b -j1 --target my_program"});
  REQUIRE_MESSAGE(made.exit_code == 0, made.out, made.err);
  CHECK(std::stod(run_program((folder.path / "b/my_program").string(), {}).out) == doctest::Approx(1 - 1.5 * std::pow(std::sin(0.25), 2)).epsilon(1e-14));
}
