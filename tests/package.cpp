// What is built is installed, moved and packed, and built upon there as the README says.
#include <doctest/doctest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <tests/run_program.hpp>

namespace {

namespace fs = std::filesystem;

const std::string source = REDERIVE_SOURCE, build = REDERIVE_BINARY;

/// The n-th block fenced as ```language after `heading` of the README, or of that of the paper's room.
std::string block(const std::string& heading, const std::string& language, int n) {
  const std::string readme = read_file(source + "/README.md") + read_file(source + "/derivations/paper/README.md");
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

void write(const fs::path& file, const std::string& text) { std::ofstream(file) << text; }

/// What a script of bash prints. It must succeed.
std::string said(const fs::path& folder, const std::string& script) {
  const Result run = run_program("/bin/bash", {"-c", "cd " + quoted(folder) + " && " + script});
  REQUIRE_MESSAGE(run.exit_code == 0, script, "\n", run.out, run.err);
  return run.out;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// The installed tree, which has been moved since.
const fs::path& prefix() {
  static const TemporaryFolder folder;
  static const fs::path moved = [] {
    said(folder.path, "cmake --install " + quoted(build) + " --prefix here --strip && mv here there");
    return folder.path / "there";
  }();
  return moved;
}

/// A project of one's own, made in `folder`, with what `lists` says after find_package.
void make_project(const fs::path& folder, const std::string& lists) {
  write(folder / "CMakeLists.txt", "cmake_minimum_required(VERSION 3.22)\nproject(mine CXX)\n" + lists);
  said(folder, "cmake -G Ninja -DCMAKE_PREFIX_PATH=" + quoted(prefix()) +
                   " -DCMAKE_CXX_FLAGS='-Wall -Wextra -Werror' -B b . && cmake --build b -j1");
}

const std::string own_project = "## In your own project", add_equation = "## Add an equation";

}  // namespace

TEST_CASE("installed programs print what those of the build print, from their own data") {
  for (const std::string call :
       {"ledger show 17b", "ledger claims c01 --json", "ledger show 71 --coq", "exercises list",
        "exercises show barrier", "rocking threshold --omega 3", "emit --target python", "rocking --version",
        "lesson-01-the-block-and-its-motion --format html"}) {
    INFO(call);
    CHECK(said(prefix() / "bin", "./" + call) == said(build + "/bin", "./" + call));
  }
  CHECK(said(prefix() / "bin", "./ledger --version") == "Rederive 1.0.0\n");
  const std::string page = "rocking response --omega 3 --amplitude 1.41 --page /dev/stdout";
  CHECK(said(prefix() / "bin", "./" + page) == said(build + "/bin", "./" + page));
}

TEST_CASE("what is installed names no folder of the machine on which it was built") {
  for (const char* folder : {"bin", "share", "include", "lib/cmake", "lib/pkgconfig"})
    REQUIRE(fs::is_directory(prefix() / folder));
  CHECK(said(prefix(), "grep -rlF -e " + quoted(source) + " -e " + quoted(build) +
                           " bin share include lib/cmake lib/pkgconfig || [ $? = 1 ]") == "");
}

TEST_CASE("a project finds the numerics, without GiNaC, CLN or Z3") {
  const TemporaryFolder folder;
  write(folder.path / "my_program.cpp", block(own_project, "cpp", 0));
  make_project(
      folder.path,
      "add_executable(my_program my_program.cpp)\n" + block(own_project, "cmake", 0) +
          "if(GINAC_LIBRARY OR CLN_FOUND)\n  message(FATAL_ERROR \"GiNaC was looked for\")\nendif()\n");
  CHECK(said(folder.path, "b/my_program").starts_with("from 1.4000998181532"));
  const std::string linked = said(folder.path, "ldd b/my_program && cat b/build.ninja");
  for (const char* wanted : {"libgsl", "librederive_numerics.a"})
    CHECK_MESSAGE(contains(linked, wanted), wanted);
  for (const char* unwanted : {"ginac", "libcln", "z3"}) CHECK_MESSAGE(!contains(linked, unwanted), unwanted);

  // and so does a compiler without CMake
  const std::string readme = read_file(source + "/README.md"), compiler = "`c++ -std=c++20 my_program.cpp ";
  const std::size_t line = readme.find(compiler) + 1;
  said(folder.path, "export PKG_CONFIG_PATH=" + quoted(prefix() / "lib/pkgconfig") + "; " +
                        readme.substr(line, readme.find('`', line) - line));
  CHECK(said(folder.path, "./a.out") == said(folder.path, "b/my_program"));
}

TEST_CASE("a project proves an identity, and adds an equation to the ledger") {
  const TemporaryFolder folder;
  write(folder.path / "proves.cpp", block(own_project, "cpp", 1));
  std::string section = read_file(source + "/derivations/rocking_block/kinematics.cpp");
  const auto list = section.find("Derivations derivations_of_kinematics() {");
  REQUIRE(list != std::string::npos);
  const auto end = section.find("  };\n", list);
  REQUIRE(end != std::string::npos);
  section.insert(end, block(add_equation, "cpp", 1));
  section.insert(list, block(add_equation, "cpp", 0) + "\n");
  write(folder.path / "kinematics.cpp", section);
  make_project(folder.path,
               "find_package(Rederive 1.0 REQUIRED COMPONENTS decide ledger)\n"
               "add_executable(proves proves.cpp)\ntarget_link_libraries(proves PRIVATE rederive::decide)\n"
               "add_executable(ledger kinematics.cpp " REDERIVE_LEDGER_MAIN
               ")\n"
               "target_link_libraries(ledger PRIVATE rederive::ledger)\n");
  said(folder.path, "b/proves");
  // without CMake
  said(folder.path,
       "export PKG_CONFIG_PATH=" + quoted(prefix() / "lib/pkgconfig") +
           "; c++ b/CMakeFiles/proves.dir/proves.cpp.o $(pkg-config --libs rederive-decide) && ./a.out");

  const fs::path equations = folder.path / "equations.toml";
  write(equations,
        read_file(prefix() / "share/rederive/equations.toml") + "\n" + block(add_equation, "toml", 0));
  const std::vector<std::string> show{"--equations", equations, "show", "w1", "--json"};
  const Result shown = run_program(folder.path / "b/ledger", show);
  CHECK(shown.exit_code == 0);
  CHECK(nlohmann::json::parse(shown.out)["verdict"] == "proved");

  // and the new row can turn red like any other
  std::string wrong = read_file(equations);
  wrong.replace(wrong.find("R*(1 - cos(alpha))"), 18, "R*(1 - sin(alpha))");
  write(equations, wrong);
  const Result spoiled = run_program(folder.path / "b/ledger", show);
  CHECK(spoiled.exit_code == 1);
  CHECK(nlohmann::json::parse(spoiled.out)["verdict"] == "refuted");
}

TEST_CASE("a component that is not there is refused by its name") {
  const TemporaryFolder folder;
  write(folder.path / "CMakeLists.txt",
        "cmake_minimum_required(VERSION 3.22)\nproject(mine NONE)\n"
        "find_package(Rederive REQUIRED COMPONENTS numbres)\n");
  const Result run = run_program(
      "/usr/bin/cmake", {"-DCMAKE_PREFIX_PATH=" + prefix().string(), "-B", folder.path / "b", folder.path});
  CHECK(run.exit_code == 1);
  CHECK(contains(run.err, "there is no component 'numbres'"));
}

TEST_CASE("the Debian package runs where it is unpacked, and depends on what its programs load") {
  if (!has_tool("dpkg-shlibdeps") || !has_tool("file")) return;
  const TemporaryFolder folder;
  said(folder.path, "cpack --config " + quoted(build + "/CPackConfig.cmake") +
                        " -D CPACK_COMPONENTS_ALL=programs -D CPACK_DEBIAN_COMPRESSION_TYPE=none -B . &&"
                        " dpkg-deb -x rederive_1.0.0_*.deb root");
  CHECK(said(folder.path, "root/usr/bin/ledger show 17b") == said(build + "/bin", "./ledger show 17b"));
  const std::string depends = said(folder.path, "dpkg-deb -f rederive_1.0.0_*.deb Depends") + ",";
  std::istringstream owners(
      said(folder.path,
           "objdump -p root/usr/bin/* | awk -v folder=/lib/$(dpkg-architecture -qDEB_HOST_MULTIARCH)/ "
           "'/NEEDED/ {print folder $2; print \"/usr\" folder $2}' | sort -u >loaded;"
           " grep -lxF -f loaded /var/lib/dpkg/info/*.list | sed -E 's|.*/||; s/(:.*)?[.]list$//'"));
  int count = 0;
  for (std::string owner; std::getline(owners, owner); ++count)
    CHECK_MESSAGE(
        (contains(", " + depends, ", " + owner + " (") || contains(", " + depends, ", " + owner + ",")),
        owner, " is not among ", depends);
  CHECK(count > 10);
  CHECK(contains(said(folder.path, "dpkg-deb -f rederive_1.0.0_*.deb Recommends"), "gnuplot-nox"));
}
