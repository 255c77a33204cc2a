// What is built is installed, moved and packed, and built upon there as the READMEs say.
#include <doctest/doctest.h>

#include <sstream>
#include <tests/installed.hpp>

namespace {

/// The first block in a language of the section for those who build on `folder`.
std::string own_project(const std::string& folder, const std::string& language) {
  return block(folder + "/README.md", "## In your own project", language, 0);
}

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
  write(folder.path / "my_program.cpp", own_project("numerics", "cpp"));
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
  said(folder.path, "export PKG_CONFIG_PATH=" + quoted(prefix() / "lib/pkgconfig") + "; " +
                        readme.substr(line, readme.find('`', line) - line));
  CHECK(said(folder.path, "./a.out") == said(folder.path, "b/my_program"));
}

TEST_CASE("a project proves an identity") {
  const TemporaryFolder folder;
  write(folder.path / "proves.cpp", own_project("derivations/decide", "cpp"));
  make_project(folder.path,
               "find_package(Rederive 1.0 REQUIRED COMPONENTS decide)\n"
               "add_executable(proves proves.cpp)\ntarget_link_libraries(proves PRIVATE rederive::decide)\n");
  said(folder.path, "b/proves");
  // without CMake
  said(folder.path,
       "export PKG_CONFIG_PATH=" + quoted(prefix() / "lib/pkgconfig") +
           "; c++ b/CMakeFiles/proves.dir/proves.cpp.o $(pkg-config --libs rederive-decide) && ./a.out");
}

TEST_CASE("a shared library and a plugin prove an identity, by CMake and by pkg-config") {
  const TemporaryFolder folder;
  const std::string main = "int main()";
  std::string code = own_project("derivations/decide", "cpp");
  code.replace(code.find(main), main.size(), "extern \"C\" int proves()");
  write(folder.path / "proves.cpp", code);
  write(folder.path / "calls.cpp", "extern \"C\" int proves();\nint main() { return proves(); }\n");
  write(folder.path / "loads.cpp",
        "#include <dlfcn.h>\nint main(int, char** names) {\n"
        "  void* plugin = dlopen(names[1], RTLD_NOW);\n"
        "  return plugin ? reinterpret_cast<int (*)()>(dlsym(plugin, \"proves\"))() : 2;\n}\n");
  make_project(
      folder.path,
      "find_package(Rederive REQUIRED COMPONENTS decide)\n"
      "add_library(proves SHARED proves.cpp)\ntarget_link_libraries(proves PRIVATE rederive::decide)\n"
      "add_library(plugin MODULE proves.cpp)\ntarget_link_libraries(plugin PRIVATE rederive::decide)\n"
      "add_executable(calls calls.cpp)\ntarget_link_libraries(calls PRIVATE proves)\n"
      "add_executable(loads loads.cpp)\ntarget_link_libraries(loads PRIVATE ${CMAKE_DL_LIBS})\n");
  said(folder.path, "b/calls && b/loads b/libplugin.so");

  said(folder.path,
       "export PKG_CONFIG_PATH=" + quoted(prefix() / "lib/pkgconfig") +
           "; c++ -std=c++20 -shared -fPIC proves.cpp $(pkg-config --cflags --libs rederive-decide)"
           " -o libproves.so && c++ calls.cpp -L. -lproves -Wl,-rpath,. -o calls && ./calls &&"
           " b/loads ./libproves.so");
}

TEST_CASE("a component that is not there is refused by its name") {
  const TemporaryFolder folder;
  write(folder.path / "CMakeLists.txt",
        "cmake_minimum_required(VERSION 3.22)\nproject(mine NONE)\n"
        "find_package(Rederive REQUIRED COMPONENTS numbres)\n");
  const Result run = run_program("/usr/bin/cmake", {"-G", "Ninja", "-DCMAKE_PREFIX_PATH=" + prefix().string(),
                                                    "-B", folder.path / "b", folder.path});
  CHECK(run.exit_code == 1);
  CHECK(contains(run.err, "there is no component 'numbres'"));
}

TEST_CASE(
    "the Debian package of the Python module runs where it is unpacked, and names the Python that it is "
    "for") {
  if (!fs::exists(build + "/python/rederive") || !has_tool("dpkg-shlibdeps") || !has_tool("file")) return;
  const TemporaryFolder folder;
  said(folder.path, "cpack --config " + quoted(build + "/CPackConfig.cmake") +
                        " -D CPACK_COMPONENTS_ALL=python -D CPACK_DEBIAN_COMPRESSION_TYPE=none -B . &&"
                        " dpkg-deb -x python3-rederive_1.0.0_*.deb root");
  CHECK(said(folder.path,
             "PYTHONPATH=root/usr/lib/python3/dist-packages /usr/bin/python3 -c 'import rederive as r; "
             "print(r.prove(\"x\", \"x\").verdict, r.threshold(r.Pulse(3)).code)'") == "proved 2\n");
  const std::string depends = said(folder.path, "dpkg-deb -f python3-rederive_1.0.0_*.deb Depends"),
                    version = said(folder.path,
                                   "/usr/bin/python3 -c 'import sys; print(sys.version_info[1], end=\"\")'");
  for (const std::string& wanted :
       {"python3 (>= 3." + version + "~)", std::string("python3-numpy"), std::string("libmpfr6")})
    CHECK_MESSAGE(contains(depends, wanted), depends);
  CHECK(contains(said(folder.path, "dpkg-deb -f python3-rederive_1.0.0_*.deb Maintainer"),
                 "Rederive maintainers <"));
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
