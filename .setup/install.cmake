# What `cmake --install` puts where. Programs read what stands in PREFIX/share/rederive
# beside them, so that PREFIX can be moved; rederive_data() installs that.
include(CMakePackageConfigHelpers)

file(GLOB lesson_files RELATIVE ${PROJECT_SOURCE_DIR}/lessons CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/lessons/lesson-*.cpp)
string(REPLACE .cpp "" lesson_programs "${lesson_files}")
install(TARGETS ledger rocking emit exercises ${lesson_programs} RUNTIME DESTINATION bin)

# To build on: the rooms as libraries, found by CMake and, two of them, by pkg-config.
list(TRANSFORM rooms PREPEND rederive_ OUTPUT_VARIABLE libraries)
foreach(room options emitted ${rooms})
  set_target_properties(rederive_${room} PROPERTIES EXPORT_NAME ${room})
endforeach()
install(TARGETS rederive_options rederive_emitted ${libraries} EXPORT RederiveTargets
        ARCHIVE DESTINATION lib COMPONENT development)
install(EXPORT RederiveTargets NAMESPACE rederive:: DESTINATION lib/cmake/Rederive COMPONENT development)
install(DIRECTORY derivations numerics lessons DESTINATION include/rederive COMPONENT development
        FILES_MATCHING PATTERN *.hpp PATTERN workbench EXCLUDE PATTERN commands EXCLUDE)
install(FILES ${PROJECT_BINARY_DIR}/emitted/rocking_block.hpp DESTINATION include/rederive/emitted COMPONENT development)

configure_file(.setup/RederiveConfig.cmake.in RederiveConfig.cmake @ONLY)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/RederiveConfigVersion.cmake COMPATIBILITY SameMajorVersion)
install(FILES .setup/RederiveDependencies.cmake ${PROJECT_BINARY_DIR}/RederiveConfig.cmake
              ${PROJECT_BINARY_DIR}/RederiveConfigVersion.cmake DESTINATION lib/cmake/Rederive COMPONENT development)

get_filename_component(arb ${ARB_LIBRARY} NAME_WE)
string(REGEX REPLACE "^lib" "" arb ${arb})
get_filename_component(ginac ${GINAC_LIBRARY} NAME)
set(ginac ":${ginac}")  # the static one, where it was found
foreach(module rederive-numerics rederive-decide)
  configure_file(.setup/${module}.pc.in ${module}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${module}.pc DESTINATION lib/pkgconfig COMPONENT development)
endforeach()
