set(m4_folder ${CMAKE_CURRENT_SOURCE_DIR})
set(m4_libraries
    firmware_outlet
    firmware_wire
    firmware_queues
    firmware_boards_cortex_m4)
# What the images of outlets have besides.
set(GSBENCH_M4_OUTLET firmware_app firmware_boards_settings_storage firmware_boards_superloop)

# Options of images. CONTRACTED must never ship: tests use it to show that they detect it.
set(GSBENCH_M4_O2 -O2 -ffp-contract=off)
set(GSBENCH_M4_OS -Os -ffp-contract=off)
set(GSBENCH_M4_CONTRACTED -O2 -ffp-contract=fast)

# gs_m4_image(NAME LIBRARIES further libraries… OPTIONS compiler options…) makes bin/NAME.elf.
#
# All firmware is compiled again for each image, with the image's own options. The libraries only
# supply their sources and include roots, and are not built themselves.
function(gs_m4_image name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "LIBRARIES;OPTIONS")
  set(all_sources "")
  set(include_roots "")
  foreach(library IN LISTS m4_libraries arg_LIBRARIES)
    set_target_properties(${library} PROPERTIES EXCLUDE_FROM_ALL ON)
    get_target_property(sources ${library} SOURCES)
    get_target_property(folder ${library} SOURCE_DIR)
    list(APPEND include_roots ${folder}/include)
    if(sources)
      list(TRANSFORM sources PREPEND ${folder}/)
      list(APPEND all_sources ${sources})
    endif()
  endforeach()
  add_executable(${name} ${all_sources})
  set_target_properties(
    ${name} PROPERTIES SUFFIX .elf LINK_DEPENDS
                       "${CMAKE_CURRENT_SOURCE_DIR}/memory.ld;${m4_folder}/sections.ld")
  target_include_directories(${name} PRIVATE ${include_roots})
  target_compile_definitions(${name} PRIVATE GSBENCH_FIRMWARE_BUILD=${GSBENCH_FIRMWARE_BUILD} NDEBUG)
  target_compile_options(
    ${name}
    PRIVATE -fno-exceptions
            -fno-rtti
            -fno-math-errno
            -fno-threadsafe-statics
            -fno-use-cxa-atexit
            -ffunction-sections
            -fdata-sections
            -g1
            ${arg_OPTIONS})
  # Without the start-up code of libstdc++ and newlib, which requires a heap and an operating system.
  target_link_options(
    ${name}
    PRIVATE
    -nostartfiles
    -nodefaultlibs
    --specs=nano.specs
    -Wl,--gc-sections
    -Wl,--print-memory-usage
    -Wl,--fatal-warnings
    -L${m4_folder}
    -T${CMAKE_CURRENT_SOURCE_DIR}/memory.ld)
  target_link_libraries(${name} PRIVATE gs_warnings -Wl,--start-group m c_nano gcc -Wl,--end-group)
endfunction()
