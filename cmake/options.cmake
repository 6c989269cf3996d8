# Build options shared by every layer.

option(BIOTOPE_EDITOR "Build the editor and the command line (needs GLFW and Dear ImGui)" ON)
option(BIOTOPE_TESTS "Build the tests" ON)
option(BIOTOPE_BENCHMARKS "Build tests/bench" OFF)
option(BIOTOPE_FUZZ "Build tests/fuzz with libFuzzer (needs clang++)" OFF)
set(BIOTOPE_SANITIZE "" CACHE STRING "Sanitizers to build with: address,undefined or thread")

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

find_program(BIOTOPE_CCACHE ccache)
if(BIOTOPE_CCACHE)
  # Without this it would not cache what is compiled with a precompiled header.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${BIOTOPE_CCACHE})
endif()

# Results must be the same to the bit wherever the program runs: no fused
# multiply-add that one processor has and another has not.
add_compile_options(-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Werror
                    -ffp-contract=off)
# Nobody reads floating-point exceptions or errno here; without these promises loops with comparisons and roots stay scalar.
add_compile_options(-fno-trapping-math -fno-math-errno)
# GCC 12 reports false positives of these from inside the standard library at -O2 and above.
add_compile_options(-Wno-error=maybe-uninitialized -Wno-error=array-bounds
                    -Wno-error=stringop-overflow -Wno-error=stringop-overread -Wno-error=restrict)

if(BIOTOPE_FUZZ)
  # GCC's warnings are the rule; clang is here for libFuzzer alone.
  add_compile_options(-Wno-error -Wno-everything -fsanitize=fuzzer-no-link)
endif()

if(BIOTOPE_SANITIZE)
  add_compile_options(-fsanitize=${BIOTOPE_SANITIZE} -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${BIOTOPE_SANITIZE})
endif()
