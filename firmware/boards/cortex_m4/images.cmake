# Images for other builds, made by a separate cross build in firmware-m4/ whenever one of their
# sources has changed. Sets GSBENCH_M4_IMAGE_FOLDER and GSBENCH_M4_IMAGE (the emulated outlet's image)
# in the cache, and defines the target `firmware_m4` that builds them. The cross compiler is looked
# for only when that target is built: runs on simulated outlets do not need it.
set(m4_folder ${PROJECT_BINARY_DIR}/firmware-m4)
set(GSBENCH_M4_IMAGE_FOLDER
    ${m4_folder}/bin
    CACHE INTERNAL "Folder of the images for the Cortex-M4F")
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
list(APPEND images ${GSBENCH_M4_IMAGE_FOLDER}/gs-head-stm32f405.elf)

file(
  GLOB_RECURSE
  m4_sources
  CONFIGURE_DEPENDS
  ${PROJECT_SOURCE_DIR}/firmware/*.cpp
  ${PROJECT_SOURCE_DIR}/firmware/*.hpp
  ${PROJECT_SOURCE_DIR}/firmware/*.ld
  ${PROJECT_SOURCE_DIR}/firmware/*.cmake
  ${PROJECT_SOURCE_DIR}/firmware/*CMakeLists.txt)
# Not in the preset's own folder: all builds of the tree would share it, and they can run at once.
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
install(FILES ${GSBENCH_M4_IMAGE_FOLDER}/gs-head-stm32f405.elf
        DESTINATION ${CMAKE_INSTALL_DATADIR}/gsbench/firmware)
