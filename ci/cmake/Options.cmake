set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

option(SANDGLASS_NATIVE "Use every instruction of the machine that builds" ON)
option(SANDGLASS_WARNINGS_AS_ERRORS "Stop at a compiler warning (CI does)" OFF)
option(SANDGLASS_SANITIZE "Address and undefined-behaviour sanitizers" OFF)

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

find_program(CCACHE_PROGRAM ccache)
mark_as_advanced(CCACHE_PROGRAM)
if(CCACHE_PROGRAM)
  # Without these two it passes over every file that uses a precompiled header.
  set(CMAKE_CXX_COMPILER_LAUNCHER "${CMAKE_COMMAND}" -E env CCACHE_SLOPPINESS=pch_defines,time_macros "${CCACHE_PROGRAM}")
  add_compile_options(-fpch-preprocess)
endif()

add_library(sandglass_options INTERFACE)
target_include_directories(sandglass_options INTERFACE "${CMAKE_SOURCE_DIR}")
# Contraction to fused multiply-add would make results depend on the compiler's mood: bitwise claims need it off.
# errno and floating-point traps are never read, and keeping them up to date stops loops from being vectorised.
# Functions on wide vectors are inlined: how a processor without such registers would pass them does not matter.
target_compile_options(sandglass_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -ffp-contract=off
  -fno-math-errno -fno-trapping-math -Wno-psabi
  $<$<BOOL:${SANDGLASS_NATIVE}>:-march=native>
  $<$<BOOL:${SANDGLASS_WARNINGS_AS_ERRORS}>:-Werror>)
target_compile_definitions(sandglass_options INTERFACE $<$<CONFIG:Debug>:_GLIBCXX_ASSERTIONS>)
if(SANDGLASS_SANITIZE)
  target_compile_options(sandglass_options INTERFACE -O1 -fsanitize=address,undefined -fno-sanitize-recover=undefined
    -fno-omit-frame-pointer)
  target_link_options(sandglass_options INTERFACE -fsanitize=address,undefined)
endif()
