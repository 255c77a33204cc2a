# Finds the libraries that .setup/wasm/build has compiled, under the names of RederiveDependencies.cmake.
set(wasm ${PROJECT_SOURCE_DIR}/build-wasm)
set(libraries ${wasm}/prefix/lib)
function(found name)
  add_library(${name} INTERFACE IMPORTED)
  target_link_libraries(${name} INTERFACE ${ARGN})
endfunction()
include_directories(SYSTEM ${CMAKE_CURRENT_LIST_DIR}/include ${wasm}/prefix/include)
add_compile_definitions(FMT_HEADER_ONLY TOML_HEADER_ONLY=1)
add_compile_definitions(GLOB_BRACE=0)  # which musl lacks; only notebooks use it
add_compile_options(-include ${CMAKE_CURRENT_LIST_DIR}/missing_from_libcxx.hpp)
foreach(name fmt::fmt CLI11::CLI11 nlohmann_json::nlohmann_json tomlplusplus::tomlplusplus Threads::Threads PkgConfig::SECCOMP)
  found(${name})
endforeach()
# The linker takes what it needs from each archive once, so a library precedes those that it needs. GiNaC is linked whole,
# because its classes announce themselves before `main`; they use CLN, whose constructors run when they are first used.
found(gmp ${libraries}/libgmp.a)
found(glpk ${libraries}/libglpk.a)
found(PkgConfig::MPFR ${libraries}/libmpfr.a gmp)
found(rederive::arb ${libraries}/libflint-arb.a ${libraries}/libflint.a PkgConfig::MPFR)
found(PkgConfig::GSL ${libraries}/libgsl.a)
found(PkgConfig::CLN ${libraries}/libcln.a gmp)
found(rederive::ginac -Wl,--whole-archive ${libraries}/libginac.a -Wl,--no-whole-archive PkgConfig::CLN)
