// What is built is installed, moved and packed, and others build on it as the READMEs say.
#include <doctest/doctest.h>

#include <regex>
#include <sstream>
#include <tests/installed.hpp>

namespace {

/// The first block in a language of the section for those who build on `folder`.
std::string own_project(const std::string& folder, const std::string& language) {
  return block(folder + "/README.md", "## In your own project", language);
}

/// Runs a script that finds the installed tree in $P, and its packages with pkg-config.
std::string said_with_pkg_config(const fs::path& folder, const std::string& script) {
  return said(folder, "P=" + quoted(prefix()) + "; export PKG_CONFIG_PATH=$P/lib/pkgconfig; " + script);
}

/// Returns a folder with the Debian packages, unpacked: "programs" and "python".
const fs::path& unpacked() {
  static const TemporaryFolder folder;
  static const bool is_made = [] {
    const std::string components = fs::exists(build + "/python/rederive") ? "programs;python" : "programs";
    said(folder.path,
         "cpack --config " + quoted(build + "/CPackConfig.cmake") + " -D CPACK_COMPONENTS_ALL='" +
             components +
             "' -D CPACK_DEBIAN_COMPRESSION_TYPE=none -B . && dpkg-deb -x rederive_1.0.0_*.deb programs "
             "&& for p in python3-rederive_*.deb; do [ ! -f $p ] || dpkg-deb -x $p python; done");
    return true;
  }();
  (void)is_made;
  return folder.path;
}

std::string field(const std::string& package, const std::string& name) {
  return said(unpacked(), "dpkg-deb -f " + package + "_1.0.0_*.deb " + name);
}

}  // namespace

TEST_CASE("installed programs print what those of the build print, from their own data") {
  for (const std::string call :
       {"ledger show 17b", "ledger claims c01 --json", "ledger show 71 --coq", "exercises list",
        "exercises show barrier", "rocking threshold --omega 3", "emit --target python", "rocking --version",
        "rocking response --omega 3 --amplitude 1.41 --page /dev/stdout",
        "lesson-01-the-block-and-its-motion --format html"}) {
    INFO(call);
    CHECK(said(prefix() / "bin", "./" + call) == said(build + "/bin", "./" + call));
  }
  CHECK(said(prefix() / "bin", "./ledger --version") == "Rederive 1.0.0\n");
}

TEST_CASE("what is installed names no folder of the machine on which it was built") {
  for (const char* folder : {"bin", "share", "include", "lib/cmake", "lib/pkgconfig"})
    REQUIRE(fs::is_directory(prefix() / folder));
  CHECK(said(prefix(), "grep -rlF -e " + quoted(source) + " -e " + quoted(build) +
                           " bin share include lib/cmake lib/pkgconfig || [ $? = 1 ]") == "");
}

TEST_CASE("the public headers include public headers alone") {
  const fs::path headers = prefix() / "include/rederive";
  const std::regex include("^#include <((derivations|numerics|lessons|emitted)/.*)>");
  int count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(headers)) {
    if (!entry.is_regular_file()) continue;
    std::istringstream lines(read_file(entry.path()));
    std::smatch match;
    for (std::string line; std::getline(lines, line);)
      if (std::regex_search(line, match, include))
        CHECK_MESSAGE(fs::exists(headers / match[1].str()), entry.path(), " includes ", match[1].str());
    ++count;
  }
  CHECK(count > 50);
}

TEST_CASE("a project finds the numerics, without GiNaC, CLN or Z3") {
  const TemporaryFolder folder;
  write_file(folder.path / "my_program.cpp", own_project("numerics", "cpp"));
  make_project(
      folder.path,
      "add_executable(my_program my_program.cpp)\n" + own_project("numerics", "cmake") +
          "if(GINAC_LIBRARY OR CLN_FOUND)\n  message(FATAL_ERROR \"GiNaC was looked for\")\nendif()\n");
  CHECK(said(folder.path, "b/my_program").starts_with("from 1.4000998181532"));
  const std::string linked = said(folder.path, "ldd b/my_program && cat b/build.ninja");
  for (const char* wanted : {"libgsl", "librederive_numerics.a"})
    CHECK_MESSAGE(contains(linked, wanted), wanted);
  for (const char* unwanted : {"ginac", "libcln", "z3"}) CHECK_MESSAGE(!contains(linked, unwanted), unwanted);

  // and so does a compiler without CMake
  const std::string readme = read_file(source + "/numerics/README.md"),
                    compiler = "`c++ -std=c++20 my_program.cpp ";
  const std::size_t line = readme.find(compiler) + 1;
  said_with_pkg_config(folder.path, readme.substr(line, readme.find('`', line) - line));
  CHECK(said(folder.path, "./a.out") == said(folder.path, "b/my_program"));
}

TEST_CASE("a program, a shared library and a plugin prove an identity, by CMake and by pkg-config") {
  const TemporaryFolder folder;
  const std::string main = "int main()", program = own_project("derivations/decide", "cpp");
  std::string library = program;
  write_file(folder.path / "proves.cpp", program);
  write_file(folder.path / "library.cpp",
             library.replace(library.find(main), main.size(), "extern \"C\" int proves()"));
  write_file(folder.path / "calls.cpp", "extern \"C\" int proves();\nint main() { return proves(); }\n");
  write_file(folder.path / "loads.cpp",
             "#include <dlfcn.h>\nint main(int, char** names) {\n"
             "  void* plugin = dlopen(names[1], RTLD_NOW);\n"
             "  return plugin ? reinterpret_cast<int (*)()>(dlsym(plugin, \"proves\"))() : 2;\n}\n");
  make_project(folder.path,
               "find_package(Rederive 1.0 REQUIRED COMPONENTS decide)\n"
               "link_libraries(rederive::decide)\nadd_executable(proves proves.cpp)\n"
               "add_library(mine SHARED library.cpp)\nadd_library(plugin MODULE library.cpp)\n"
               "add_executable(calls calls.cpp)\ntarget_link_libraries(calls PRIVATE mine)\n"
               "add_executable(loads loads.cpp)\ntarget_link_libraries(loads PRIVATE ${CMAKE_DL_LIBS})\n");
  said(folder.path, "b/proves && b/calls && b/loads b/libplugin.so");
  said_with_pkg_config(
      folder.path,
      "c++ b/CMakeFiles/proves.dir/proves.cpp.o $(pkg-config --libs rederive-decide) && ./a.out &&"
      " c++ -std=c++20 -shared -fPIC library.cpp $(pkg-config --cflags --libs rederive-decide) -o libmine.so "
      "&&"
      " c++ calls.cpp -L. -lmine -Wl,-rpath,. -o calls && ./calls && b/loads ./libmine.so");
}

TEST_CASE("a component that is not there is refused by its name") {
  const TemporaryFolder folder;
  write_file(folder.path / "CMakeLists.txt",
             "cmake_minimum_required(VERSION 3.22)\nproject(mine NONE)\n"
             "find_package(Rederive REQUIRED COMPONENTS numbres)\n");
  const Result run = run_program("/usr/bin/cmake", {"-G", "Ninja", "-DCMAKE_PREFIX_PATH=" + prefix().string(),
                                                    "-B", folder.path / "b", folder.path});
  CHECK(run.exit_code == 1);
  CHECK(contains(run.err, "there is no component 'numbres'"));
}

TEST_CASE("the Debian package of the Python module runs where it is unpacked, and names its Python") {
  if (!fs::exists(build + "/python/rederive") || !has_tool("dpkg-shlibdeps") || !has_tool("file")) return;
  CHECK(said(unpacked(),
             "PYTHONPATH=python/usr/lib/python3/dist-packages /usr/bin/python3 -c 'import rederive as r; "
             "print(r.prove(\"x\", \"x\").verdict, r.threshold(r.Pulse(3)).code)'") == "proved 2\n");
  const std::string depends = field("python3-rederive", "Depends"),
                    version =
                        said("/", "/usr/bin/python3 -c 'import sys; print(sys.version_info[1], end=\"\")'");
  for (const std::string& needed :
       {"python3 (>= 3." + version + "~)", std::string("python3-numpy"), std::string("libmpfr6")})
    CHECK_MESSAGE(contains(depends, needed), depends);
  CHECK(contains(field("python3-rederive", "Maintainer"), "Rederive maintainers <"));
}

TEST_CASE("the Debian package runs where it is unpacked, and depends on what its programs load") {
  if (!has_tool("dpkg-shlibdeps") || !has_tool("file")) return;
  CHECK(said(unpacked(), "programs/usr/bin/ledger show 17b") == said(build + "/bin", "./ledger show 17b"));
  const std::string depends = ", " + field("rederive", "Depends") + ",";
  std::istringstream owners(
      said(unpacked(),
           "objdump -p programs/usr/bin/* | awk -v folder=/lib/$(dpkg-architecture -qDEB_HOST_MULTIARCH)/ "
           "'/NEEDED/ {print folder $2; print \"/usr\" folder $2}' | sort -u >loaded;"
           " grep -lxF -f loaded /var/lib/dpkg/info/*.list | sed -E 's|.*/||; s/(:.*)?[.]list$//'"));
  int count = 0;
  for (std::string owner; std::getline(owners, owner); ++count)
    CHECK_MESSAGE((contains(depends, ", " + owner + " (") || contains(depends, ", " + owner + ",")), owner,
                  " is not among ", depends);
  CHECK(count > 10);
  CHECK(contains(field("rederive", "Recommends"), "gnuplot-nox"));
}

TEST_CASE(
    "configuring anew leaves the links to data as they are, for programs that run, and drops stale ones") {
  const TemporaryFolder folder;
  const std::string configure = "cmake -G Ninja -S " + quoted(source) + " -B b",
                    links = "stat -c '%n %i %z' b/share/rederive/*.toml b/share/rederive/*/*";
  said(folder.path, configure);
  const std::string before = said(folder.path, links);
  fs::create_symlink("/nowhere", folder.path / "b/share/rederive/stale.toml");
  said(folder.path, configure);
  CHECK(said(folder.path, links) == before);
}
