# cmake -DNM=nm -DLIBRARIES=a.a;b.a -P undefined_symbols.cmake
#
# Fails if the libraries together need a symbol that a freestanding build does not have: heap,
# exceptions, libm, C++ runtime. Allowed are functions that a compiler may always call, and those of
# the sanitizers.
set(defined "")
set(undefined "")
foreach(library IN LISTS LIBRARIES)
  execute_process(
    COMMAND ${NM} --format=posix ${library}
    OUTPUT_VARIABLE symbols
    COMMAND_ERROR_IS_FATAL ANY)
  string(REPLACE "\n" ";" symbols "${symbols}")
  foreach(symbol IN LISTS symbols)
    if(symbol MATCHES "^([^ ]+) [Uw]")
      list(APPEND undefined ${CMAKE_MATCH_1})
    elseif(symbol MATCHES "^([^ ]+) [A-Za-z]")
      list(APPEND defined ${CMAKE_MATCH_1})
    endif()
  endforeach()
endforeach()
if(NOT defined)
  message(FATAL_ERROR "no symbols in ${LIBRARIES}")
endif()
list(REMOVE_DUPLICATES undefined)
list(REMOVE_ITEM undefined ${defined})
list(FILTER undefined EXCLUDE REGEX "^(memcpy|memset|memmove|memcmp|_GLOBAL_OFFSET_TABLE_)$")
list(FILTER undefined EXCLUDE REGEX "^__(asan|ubsan|tsan|sanitizer|stack_chk)_")
if(undefined)
  list(JOIN undefined ", " names)
  message(FATAL_ERROR "needs more than a freestanding build has: ${names}")
endif()
