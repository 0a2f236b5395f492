add_library(firmware_boards_cortex_m4 INTERFACE)
target_include_directories(firmware_boards_cortex_m4 INTERFACE ${CMAKE_CURRENT_SOURCE_DIR}/include)

# All firmware is compiled anew for each image, with the image's own options: the folders' libraries
# give their sources and include roots only.
set(shared_libraries firmware_outlet firmware_wire firmware_node firmware_boards_settings_area
                     firmware_boards_bare_metal)
set(shared_sources ${CMAKE_CURRENT_SOURCE_DIR}/start_up.cpp)
set(shared_includes ${CMAKE_CURRENT_SOURCE_DIR}/include)
foreach(library IN LISTS shared_libraries)
  get_target_property(sources ${library} SOURCES)
  get_target_property(folder ${library} SOURCE_DIR)
  list(TRANSFORM sources PREPEND ${folder}/)
  list(APPEND shared_sources ${sources})
  list(APPEND shared_includes ${folder}/include)
endforeach()
set(m4_sections_folder ${CMAKE_CURRENT_SOURCE_DIR})

string(SUBSTRING ${GSBENCH_FIRMWARE_SHA256} 0 8 build)

# gs_m4_image(NAME SOURCES the board's own… [INCLUDES folders] OPTIONS compiler options): bin/NAME.elf
function(gs_m4_image name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;INCLUDES;OPTIONS")
  add_executable(${name} ${arg_SOURCES} ${shared_sources})
  set_target_properties(${name} PROPERTIES SUFFIX .elf)
  target_include_directories(${name} PRIVATE ${shared_includes} ${arg_INCLUDES})
  target_compile_definitions(${name} PRIVATE GSBENCH_FIRMWARE_BUILD=0x${build}u NDEBUG)
  target_compile_options(
    ${name}
    PRIVATE -fno-exceptions
            -fno-rtti
            -fno-math-errno
            -fno-threadsafe-statics
            -fno-use-cxa-atexit
            -ffunction-sections
            -fdata-sections
            -fstack-usage
            -g1
            ${arg_OPTIONS})
  # Also against libstdc++'s and newlib's start-up, which want a heap and an operating system.
  target_link_options(
    ${name}
    PRIVATE
    -nostartfiles
    -nodefaultlibs
    --specs=nano.specs
    -Wl,--gc-sections
    -Wl,--print-memory-usage
    -Wl,--fatal-warnings
    -L${m4_sections_folder}
    -T${CMAKE_CURRENT_SOURCE_DIR}/memory.ld)
  set_target_properties(${name} PROPERTIES LINK_DEPENDS
                                           "${CMAKE_CURRENT_SOURCE_DIR}/memory.ld;${m4_sections_folder}/sections.ld")
  target_link_libraries(${name} PRIVATE gs_warnings -Wl,--start-group m c_nano gcc -Wl,--end-group)
endfunction()

set(GSBENCH_M4_O2 -O2 -ffp-contract=off)
set(GSBENCH_M4_OS -Os -ffp-contract=off)
# What must not be: for the tests that show that they would see it.
set(GSBENCH_M4_CONTRACTED -O2 -ffp-contract=fast)

foreach(board mps2_an386 stm32f405)
  if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/../${board}/CMakeLists.txt)
    add_subdirectory(../${board} ${board})
  endif()
endforeach()
