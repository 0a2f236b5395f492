# cmake -DNM=nm -DIMAGE=a.elf -DCODE_BYTES=n -DRAM_BYTES=n -P budget.cmake
#
# Fails if an image exceeds its budgets or contains a forbidden symbol: heap, exceptions, libm. Code:
# everything in flash, with the initial values of data. RAM: data, bss and the reserved stack.
execute_process(
  COMMAND ${NM} ${IMAGE}
  OUTPUT_VARIABLE symbols
  COMMAND_ERROR_IS_FATAL ANY)
string(REPLACE "\n" ";" symbols "${symbols}")

set(forbidden "")
foreach(symbol IN LISTS symbols)
  if(symbol MATCHES
     " (_?malloc(_r)?|_?free(_r)?|_?calloc(_r)?|_?realloc(_r)?|_?sbrk(_r)?|_Znw.*|_Zna.*|_Zd[la].*|__cxa_(throw|begin_catch|allocate_exception).*|_Unwind_.*|__aeabi_unwind_.*|(sin|cos|tan|exp|log|pow|atan2)f?)$")
    list(APPEND forbidden ${CMAKE_MATCH_1})
  elseif(symbol MATCHES "^([0-9a-f]+) . (gs_code_bytes|gs_ram_bytes)$")
    math(EXPR ${CMAKE_MATCH_2} "0x${CMAKE_MATCH_1}")
  endif()
endforeach()
if(NOT gs_code_bytes OR NOT gs_ram_bytes)
  message(FATAL_ERROR "${IMAGE} lacks the symbols gs_code_bytes and gs_ram_bytes")
endif()
message("${IMAGE}: ${gs_code_bytes} bytes of code, ${gs_ram_bytes} bytes of RAM")
if(forbidden)
  message(FATAL_ERROR "forbidden symbols: ${forbidden}")
endif()
if(gs_code_bytes GREATER CODE_BYTES)
  message(FATAL_ERROR "more code than its budget of ${CODE_BYTES} bytes")
endif()
if(gs_ram_bytes GREATER RAM_BYTES)
  message(FATAL_ERROR "more RAM than its budget of ${RAM_BYTES} bytes")
endif()
