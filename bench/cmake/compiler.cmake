# Warnings are errors and C++17 is used in full, so an older compiler would fail with something
# obscure: say it here instead.
if(NOT ((CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 12)
        OR (CMAKE_CXX_COMPILER_ID STREQUAL "Clang" AND CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 14)))
  message(
    FATAL_ERROR
      "gsbench builds with g++ 12 or clang++ 14 and later; this is "
      "${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION} (${CMAKE_CXX_COMPILER}).")
endif()

find_program(GSBENCH_CCACHE ccache)
if(GSBENCH_CCACHE AND NOT DEFINED CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_C_COMPILER_LAUNCHER ${GSBENCH_CCACHE})
  # It takes precompiled headers only where it is told that they depend on no macro and no clock.
  set(CMAKE_CXX_COMPILER_LAUNCHER env CCACHE_SLOPPINESS=pch_defines,time_macros ${GSBENCH_CCACHE})
endif()

# No path of the machine that built it in a program: debuggers take sources relative to the root.
add_compile_options(-ffile-prefix-map=${PROJECT_SOURCE_DIR}/= -ffile-prefix-map=${PROJECT_BINARY_DIR}/=build/)
