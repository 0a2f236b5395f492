# gs_program_beside(NAME SOURCE file.cpp HEADER file.hpp ENTRY function [IMAGE a.elf]) makes NAME.bin
# and NAME.elf in the current binary folder, for the class ProgramBeside. The program may call
# functions of IMAGE by name. Its own variables are not set up: it gets its memory by its argument.
set(GSBENCH_BESIDE_ADDRESS
    0x21800000
    CACHE INTERNAL "Address of such programs, in the PSRAM of mps2-an386")

function(gs_program_beside name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "SOURCE;HEADER;ENTRY;IMAGE" "")
  set(program ${CMAKE_CURRENT_BINARY_DIR}/${name})
  set(firmware ${PROJECT_SOURCE_DIR}/firmware)
  set(symbols "")
  if(arg_IMAGE)
    set(symbols -Wl,--just-symbols=${arg_IMAGE})
  endif()
  add_custom_command(
    OUTPUT ${program}.bin
    COMMAND
      arm-none-eabi-g++ -std=c++17 -O2 -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16
      -mlong-calls -ffp-contract=off -fno-exceptions -fno-rtti -fno-threadsafe-statics
      -ffreestanding -ffunction-sections -Wall -Wextra -Werror -I ${firmware}/outlet/include -I
      ${firmware}/wire/include -I ${firmware}/app/include -I ${firmware}/boards/cortex_m4/include -I
      ${firmware}/boards/mps2_an386 -nostdlib -Wl,--build-id=none -Wl,--gc-sections
      -Wl,-Ttext=${GSBENCH_BESIDE_ADDRESS} -Wl,--entry=${arg_ENTRY} ${symbols} -o ${program}.elf
      ${CMAKE_CURRENT_SOURCE_DIR}/${arg_SOURCE}
    COMMAND arm-none-eabi-objcopy -O binary ${program}.elf ${program}.bin
    DEPENDS ${arg_SOURCE} ${arg_HEADER} ${arg_IMAGE} firmware_m4
    COMMENT "Building ${name}, which runs beside the Cortex-M4F image"
    VERBATIM)
  add_custom_target(${name} DEPENDS ${program}.bin)
endfunction()
