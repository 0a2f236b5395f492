# One target and one include root per folder: the folder `bench/grid` is the target `bench_grid`, with
# the public headers `bench/grid/include/grid/*.hpp`. A folder can include only the targets that it
# names under DEPENDS or PRIVATE.

add_library(gs_warnings INTERFACE)
target_compile_options(
  gs_warnings
  INTERFACE -Wall
            -Wextra
            -Wconversion
            -Wshadow
            -Wdouble-promotion
            -Werror)
if(CMAKE_UNITY_BUILD AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # A unity file includes the sources of a folder; g++ then takes their anonymous namespaces for those
  # of a header.
  target_compile_options(gs_warnings INTERFACE -Wno-subobject-linkage)
endif()

# No fused multiply-add in firmware or bench: with it, two processors could differ in the last bit.
add_library(gs_arithmetic INTERFACE)
target_compile_options(gs_arithmetic INTERFACE -ffp-contract=off)

# gs_library(NAME SOURCES a.cpp … [DEPENDS public targets] [PRIVATE targets])
function(gs_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;DEPENDS;PRIVATE")
  if(arg_SOURCES)
    add_library(${name} STATIC ${arg_SOURCES})
    target_include_directories(${name} PUBLIC ${CMAKE_CURRENT_SOURCE_DIR}/include)
    target_link_libraries(
      ${name}
      PUBLIC ${arg_DEPENDS} gs_arithmetic
      PRIVATE ${arg_PRIVATE} gs_warnings)
  else()
    add_library(${name} INTERFACE)
    target_include_directories(${name} INTERFACE ${CMAKE_CURRENT_SOURCE_DIR}/include)
    target_link_libraries(${name} INTERFACE ${arg_DEPENDS} gs_arithmetic)
  endif()
endfunction()

# Test code is compiled more often than its run time matters; the libraries under test are optimised.
set(GSBENCH_TEST_OPTIONS
    -O0
    CACHE STRING "Compiler options of the tests alone")

# gs_precompiled(TARGET HEADERS <a> … | REUSE_FROM other): precompiled headers for a target, or those
# of another target with the same options. ccache needs -fpch-preprocess with g++.
function(gs_precompiled target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "REUSE_FROM" "HEADERS")
  if(arg_REUSE_FROM)
    target_precompile_headers(${target} REUSE_FROM ${arg_REUSE_FROM})
  else()
    target_precompile_headers(${target} PRIVATE ${arg_HEADERS})
  endif()
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${target} PRIVATE -fpch-preprocess)
  endif()
endfunction()

# gs_test(NAME SOURCES a.cpp … DEPENDS targets [LABEL …] [TIMEOUT s] [THREADS]): a GoogleTest
# program with one CTest test for each case. Programs with a LABEL (`slow`, `end-to-end`) are not built
# for the sanitizers; a slow suite has a short form without a label. THREADS: built for the thread
# sanitizer as well. Only one label for each program: gtest_discover_tests() loses a second one.
add_custom_target(sanitized_tests)
add_custom_target(threaded_tests)
function(gs_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "THREADS" "TIMEOUT;LABEL" "SOURCES;DEPENDS")
  if(NOT arg_TIMEOUT)
    set(arg_TIMEOUT 300)
  endif()
  if(NOT arg_LABEL)
    set(arg_LABEL sanitized)
    add_dependencies(sanitized_tests ${name})
    if(arg_THREADS)
      set(arg_LABEL sanitized-threaded)
      add_dependencies(threaded_tests ${name})
    endif()
  endif()
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE ${arg_DEPENDS} GTest::gmock GTest::gtest_main gs_arithmetic
                                        gs_warnings)
  # Qt needs -fPIC; all tests have it, so that they can share the precompiled headers.
  target_compile_options(${name} PRIVATE -fPIC ${GSBENCH_TEST_OPTIONS})
  gs_precompiled(${name} REUSE_FROM test_precompiled)
  target_compile_definitions(${name} PRIVATE GSBENCH_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
                                             GSBENCH_BINARY_DIR="${PROJECT_BINARY_DIR}")
  gtest_discover_tests(
    ${name}
    DISCOVERY_TIMEOUT 60
    PROPERTIES TIMEOUT ${arg_TIMEOUT} LABELS "${arg_LABEL}"
               ENVIRONMENT XDG_DATA_HOME=${PROJECT_BINARY_DIR}/user_data)
endfunction()

# gs_performance_test(NAME SOURCES a.cpp … DEPENDS targets): a program that measures speed and fails
# below a limit. `./dev perf` runs it, one program at a time so that others do not affect the result.
function(gs_performance_test name)
  find_package(benchmark REQUIRED)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;DEPENDS")
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE ${arg_DEPENDS} benchmark::benchmark gs_warnings)
  target_compile_definitions(${name} PRIVATE GSBENCH_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
                                             GSBENCH_BINARY_DIR="${PROJECT_BINARY_DIR}")
  add_test(NAME ${name} COMMAND ${name} CONFIGURATIONS Performance)
  set_tests_properties(${name} PROPERTIES LABELS performance RUN_SERIAL ON)
endfunction()
