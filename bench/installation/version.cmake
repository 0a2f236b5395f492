# cmake -DRELEASE=0.1.0 -DSOURCE=… -DTEMPLATE=… -DOUTPUT=… -P version.cmake: writes version.cpp with the
# release and the git revision of the sources. The file is left alone if it would not change.
function(git output)
  execute_process(
    COMMAND git -C ${SOURCE} ${ARGN}
    OUTPUT_VARIABLE text
    RESULT_VARIABLE status
    OUTPUT_STRIP_TRAILING_WHITESPACE
    ERROR_QUIET)
  set(${output}
      "${text}"
      PARENT_SCOPE)
  set(git_status
      ${status}
      PARENT_SCOPE)
endfunction()

set(version ${RELEASE})
git(revision rev-parse --short=12 HEAD)
git(prefix rev-parse --show-prefix)
# A source archive that was unpacked within another repository has no revision.
if(revision AND prefix STREQUAL "")
  git(ignored diff --quiet HEAD -- bench drivers firmware reports CMakeLists.txt)
  if(NOT git_status EQUAL 0)
    string(APPEND revision "-dirty")
  endif()
  string(APPEND version " (${revision})")
endif()
configure_file(${TEMPLATE} ${OUTPUT} @ONLY)
