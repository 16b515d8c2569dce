include(GoogleTest)

# Tests are built once and run for a second: their compile time is what counts. The rooms keep their own flags.
set(SANDGLASS_TEST_OPTIONS $<$<CONFIG:Release>:-O1>)
# What nearly every file reads, read once: that is half of what it costs to compile one. ci/lint-includes sees to it that
# each file still names what it uses.
function(sandglass_headers name)
  add_library(${name} STATIC "${CMAKE_SOURCE_DIR}/ci/cmake/headers.cpp")
  target_link_libraries(${name} PRIVATE sandglass_options Eigen3::Eigen)
endfunction()
sandglass_headers(sandglass_source_headers)
target_link_libraries(sandglass_source_headers PRIVATE fmt::fmt)
target_precompile_headers(sandglass_source_headers PRIVATE <Eigen/Core> <algorithm> <array> <cmath> <cstdint> <functional>
  <map> <memory> <optional> <set> <span> <string> <variant> <vector> <fmt/format.h>)
sandglass_headers(sandglass_test_headers)
target_link_libraries(sandglass_test_headers PRIVATE GTest::gtest_main GTest::gmock)
target_compile_options(sandglass_test_headers PRIVATE ${SANDGLASS_TEST_OPTIONS})
target_precompile_headers(sandglass_test_headers PRIVATE <gtest/gtest.h> <Eigen/Core>)

# sandglass_room(NAME [USES room...] [LINKS target...] [FLAT] [LIGHT])
# A room is a folder of the house: every *.cpp in it becomes the library sandglass_NAME, every *_test.cpp the program
# test_NAME; main.cpp is left to a program of its own. USES lists the rooms that it may see: the allowed arrows and no
# others. FLAT: folders inside are rooms of their own. LIGHT: its files read little, so that precompiled headers cost
# more than they save.
function(sandglass_room name)
  cmake_parse_arguments(ROOM "FLAT;LIGHT" "" "USES;LINKS" ${ARGN})
  if(ROOM_FLAT)
    file(GLOB sources CONFIGURE_DEPENDS "*.cpp")
  else()
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS "*.cpp")
  endif()
  set(tests ${sources})
  list(FILTER sources EXCLUDE REGEX "(_test|/main)\\.cpp$")
  list(FILTER tests INCLUDE REGEX "_test\\.cpp$")
  list(TRANSFORM ROOM_USES PREPEND sandglass_)
  if(sources)
    add_library(sandglass_${name} STATIC ${sources})
    target_link_libraries(sandglass_${name} PUBLIC sandglass_options ${ROOM_USES} ${ROOM_LINKS})
    if(NOT ROOM_LIGHT)
      target_precompile_headers(sandglass_${name} REUSE_FROM sandglass_source_headers)
    endif()
  else()
    add_library(sandglass_${name} INTERFACE)
    target_link_libraries(sandglass_${name} INTERFACE sandglass_options ${ROOM_USES} ${ROOM_LINKS})
  endif()
  if(tests)
    add_executable(test_${name} ${tests})
    target_link_libraries(test_${name} PRIVATE sandglass_${name} GTest::gtest_main GTest::gmock)
    target_compile_options(test_${name} PRIVATE ${SANDGLASS_TEST_OPTIONS})
    target_precompile_headers(test_${name} REUSE_FROM sandglass_test_headers)
    # Four files at a time share what they instantiate: two thirds of what it costs to compile them one by one. Names of
    # a file's own must then differ within a room.
    set_target_properties(test_${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 4)
    target_compile_definitions(test_${name} PRIVATE SANDGLASS_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
    set(environment "")
    if(MPI::MPI_CXX IN_LIST ROOM_LINKS)
      set(environment ENVIRONMENT ASAN_OPTIONS=detect_leaks=0)  # Open MPI itself leaks
    endif()
    gtest_discover_tests(test_${name} TEST_PREFIX "${name}." DISCOVERY_TIMEOUT 60
      PROPERTIES TIMEOUT 300 ${environment})
  endif()
endfunction()
