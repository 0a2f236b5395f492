# The images for other builds: made by a build of their own, in firmware-m4/ beside it, whenever a
# source of theirs has changed. Sets GSBENCH_M4_IMAGE_FOLDER and GSBENCH_M4_IMAGE (the emulated
# outlet's) in the cache, and the target `firmware_m4` that both need. The compiler is looked for
# only when that is built: a run on simulated outlets needs neither.
set(m4_folder ${PROJECT_BINARY_DIR}/firmware-m4)
set(GSBENCH_M4_IMAGE_FOLDER
    ${m4_folder}/bin
    CACHE INTERNAL "Where the images for the Cortex-M4F are")
set(GSBENCH_M4_IMAGE
    ${GSBENCH_M4_IMAGE_FOLDER}/gs-outlet-mps2_an386.elf
    CACHE INTERNAL "The emulated outlet's image")

if(NOT GSBENCH_FIRMWARE_IMAGES)
  return()
endif()

set(images "")
foreach(name IN LISTS GSBENCH_BOARDS_cortex_m4 ITEMS mps2_an386-Os mps2_an386-contracted)
  list(APPEND images ${GSBENCH_M4_IMAGE_FOLDER}/gs-outlet-${name}.elf)
endforeach()

file(
  GLOB_RECURSE
  m4_sources
  CONFIGURE_DEPENDS
  ${PROJECT_SOURCE_DIR}/firmware/*.cpp
  ${PROJECT_SOURCE_DIR}/firmware/*.hpp
  ${PROJECT_SOURCE_DIR}/firmware/*.ld
  ${PROJECT_SOURCE_DIR}/firmware/*.cmake
  ${PROJECT_SOURCE_DIR}/firmware/*CMakeLists.txt)
# The preset's own folder would be shared by all builds of the tree, which may run at once.
add_custom_command(
  OUTPUT ${m4_folder}/.built
  BYPRODUCTS ${images}
  COMMAND ${CMAKE_COMMAND} --preset firmware-m4 -B ${m4_folder}
  COMMAND ${CMAKE_COMMAND} --build ${m4_folder}
  COMMAND ${CMAKE_COMMAND} -E touch ${m4_folder}/.built
  WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
  DEPENDS ${m4_sources}
          ${PROJECT_SOURCE_DIR}/CMakeLists.txt
          ${PROJECT_SOURCE_DIR}/CMakePresets.json
          ${PROJECT_SOURCE_DIR}/bench/cmake/arm-none-eabi.cmake
          ${PROJECT_SOURCE_DIR}/bench/cmake/compiler.cmake
          ${PROJECT_SOURCE_DIR}/bench/cmake/targets.cmake
  COMMENT "Firmware for the Cortex-M4F, with arm-none-eabi-g++"
  VERBATIM)
add_custom_target(firmware_m4 ALL DEPENDS ${m4_folder}/.built)
include(GNUInstallDirs)
foreach(board IN LISTS GSBENCH_BOARDS_cortex_m4)
  install(FILES ${GSBENCH_M4_IMAGE_FOLDER}/gs-outlet-${board}.elf
          DESTINATION ${CMAKE_INSTALL_DATADIR}/gsbench/firmware)
endforeach()
