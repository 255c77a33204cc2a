# Finds the external libraries that the libraries in `rederive_rooms` need. The build reads this file, and
# so does find_package(Rederive) for an installed tree, for the requested components alone: the numerics need neither
# GiNaC nor CLN. Sets Rederive_FOUND to FALSE, with a message, if a library is missing.
include(CMakeFindDependencyMacro)

macro(rederive_missing what)
  set(Rederive_FOUND FALSE)
  set(Rederive_NOT_FOUND_MESSAGE "${what} is missing")
  return()
endmacro()

macro(rederive_module name)
  pkg_check_modules(${name} QUIET IMPORTED_TARGET ${ARGN})
  if(NOT ${name}_FOUND)
    rederive_missing("the pkg-config module ${ARGN}")
  endif()
endmacro()

find_dependency(PkgConfig)
find_dependency(Threads)
find_dependency(fmt)

# The filter of system calls for what judges the answers of students.
rederive_module(SECCOMP libseccomp)

# Balls. Arb has no pkg-config file; Debian calls it flint-arb.
rederive_module(MPFR mpfr)
find_library(ARB_LIBRARY NAMES flint-arb arb)
find_library(FLINT_LIBRARY flint)
if(NOT ARB_LIBRARY OR NOT FLINT_LIBRARY)
  rederive_missing("Arb or FLINT (Debian: libflint-arb-dev, libflint-dev)")
endif()
if(NOT TARGET rederive::arb)
  add_library(rederive::arb INTERFACE IMPORTED)
  target_link_libraries(rederive::arb INTERFACE ${ARB_LIBRARY} ${FLINT_LIBRARY} PkgConfig::MPFR)
endif()

if(rederive_rooms MATCHES "numerics|lessons|certify|ledger|classroom")
  rederive_module(GSL gsl)
endif()
if(rederive_rooms STREQUAL numerics)
  return()
endif()

rederive_module(CLN cln)
rederive_module(GINAC ginac)
if(NOT TARGET rederive::ginac)
  add_library(rederive::ginac INTERFACE IMPORTED)
  target_link_libraries(rederive::ginac INTERFACE PkgConfig::GINAC PkgConfig::CLN)
endif()

if(rederive_rooms MATCHES "emit|paper|rocking_block|kernel|lessons|certify|ledger|classroom")
  find_dependency(tomlplusplus)
  find_dependency(nlohmann_json)
endif()
