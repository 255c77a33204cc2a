# Says what `cmake --install` puts where, and which packages `cpack` makes. Programs read their data from
# PREFIX/share/rederive beside them, so PREFIX can be moved; rederive_data() installs these files.
include(CMakePackageConfigHelpers)

file(GLOB lesson_files RELATIVE ${PROJECT_SOURCE_DIR}/lessons CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/lessons/lesson-*.cpp)
string(REPLACE .cpp "" lesson_programs "${lesson_files}")
install(TARGETS ledger rocking emit exercises rederive ${lesson_programs} RUNTIME DESTINATION bin)

# For projects that build on Rederive: the libraries, for CMake and, two of them, for pkg-config.
list(TRANSFORM rooms PREPEND rederive_ OUTPUT_VARIABLE libraries)
foreach(room options emitted ${rooms})
  set_target_properties(rederive_${room} PROPERTIES EXPORT_NAME ${room})
endforeach()
install(TARGETS rederive_options rederive_emitted ${libraries} EXPORT RederiveTargets
        ARCHIVE DESTINATION lib COMPONENT development)
install(EXPORT RederiveTargets NAMESPACE rederive:: DESTINATION lib/cmake/Rederive COMPONENT development)
include(.setup/public_headers.cmake)
foreach(header ${public_headers})
  get_filename_component(folder ${header} DIRECTORY)
  install(FILES ${header} DESTINATION include/rederive/${folder} COMPONENT development)
endforeach()
install(FILES ${PROJECT_BINARY_DIR}/emitted/rocking_block.hpp ${PROJECT_BINARY_DIR}/emitted/rocking_block_symbols.hpp
        DESTINATION include/rederive/emitted COMPONENT development)

configure_file(.setup/RederiveConfig.cmake.in RederiveConfig.cmake @ONLY)
# The same for the build folder, for tests/fuzz.
export(EXPORT RederiveTargets NAMESPACE rederive:: FILE RederiveTargets.cmake)
# Projects include <rederive/…> from the build folder, too.
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/include/rederive)
foreach(folder derivations numerics lessons)  # each by itself: a link to the whole tree would lead back here
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/${folder} ${PROJECT_BINARY_DIR}/include/rederive/${folder} SYMBOLIC)
endforeach()
file(CREATE_LINK ${PROJECT_BINARY_DIR}/emitted ${PROJECT_BINARY_DIR}/include/rederive/emitted SYMBOLIC)
configure_file(.setup/RederiveDependencies.cmake RederiveDependencies.cmake COPYONLY)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/RederiveConfigVersion.cmake COMPATIBILITY SameMajorVersion)
install(FILES .setup/RederiveDependencies.cmake ${PROJECT_BINARY_DIR}/RederiveConfig.cmake
              ${PROJECT_BINARY_DIR}/RederiveConfigVersion.cmake DESTINATION lib/cmake/Rederive COMPONENT development)

get_filename_component(arb ${ARB_LIBRARY} NAME_WE)
string(REGEX REPLACE "^lib" "" arb ${arb})
foreach(module rederive-numerics rederive-decide)
  configure_file(.setup/${module}.pc.in ${module}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${module}.pc DESTINATION lib/pkgconfig COMPONENT development)
endforeach()

# Debian packages: the programs; the module that needs Open MPI; and the libraries. The numerics need fewer packages than
# the proofs.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME rederive)
# Debian requires an address. The project has none, and .invalid says so (RFC 2606).
set(CPACK_PACKAGE_CONTACT "Rederive maintainers <maintainers@rederive.invalid>")
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
    WORLD_READ WORLD_EXECUTE)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SECTION science)

set(CPACK_DEBIAN_PROGRAMS_PACKAGE_NAME rederive)
set(CPACK_DEBIAN_PROGRAMS_DESCRIPTION "paper on rocking blocks that you can run
 Every equation of a paper on the overturning of rigid blocks under ground
 excitation is derived again by computer algebra, and proved or refuted. With
 thresholds, histories, spectra and maps of the block's motion, lessons and
 exercises.")
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_RECOMMENDS gnuplot-nox)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SUGGESTS "rederive-mpi, coq, libcoq-coquelicot, libcoq-interval")

set(CPACK_DEBIAN_MPI_PACKAGE_NAME rederive-mpi)
set(CPACK_DEBIAN_MPI_DESCRIPTION "rocking maps, spectra and fragility under mpirun
 What the program rocking of the package rederive loads under mpirun.")
set(CPACK_DEBIAN_MPI_PACKAGE_DEPENDS "rederive (= ${PROJECT_VERSION})")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME librederive-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "motion of rocking blocks, and proofs of identities
 Static libraries, headers, and files for CMake and pkg-config: the response of
 a rigid block to ground motion, and a prover for identities, equations and
 inequalities. The recommended packages are for the proofs alone.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
    "rederive (= ${PROJECT_VERSION}), libgsl-dev, libmpfr-dev, libseccomp-dev, libflint-arb-dev, libflint-dev, libfmt-dev")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS "libginac-dev, libcln-dev, libglpk-dev, libgmp-dev, \
libtomlplusplus-dev, nlohmann-json3-dev, pkgconf")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-rederive)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_DESCRIPTION "paper on rocking blocks that you can run, as a Python module
 The ledger of a paper on the overturning of rigid blocks, a prover, the
 derived functions as code, and thresholds, histories, spectra and maps as
 NumPy arrays.")  # PACKAGE_DEPENDS: lessons/python

execute_process(COMMAND gzip -9n INPUT_FILE ${PROJECT_SOURCE_DIR}/.setup/changelog
                OUTPUT_FILE ${PROJECT_BINARY_DIR}/changelog.gz COMMAND_ERROR_IS_FATAL ANY)
set(components programs development)
if(TARGET rocking_ranks)
  list(APPEND components mpi)
endif()
if(TARGET python_module)
  list(APPEND components python)
endif()
foreach(component ${components})
  string(TOUPPER ${component} upper)
  set(documents share/doc/${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
  install(FILES .setup/copyright ${PROJECT_BINARY_DIR}/changelog.gz DESTINATION ${documents} COMPONENT ${component})
endforeach()
include(CPack)
