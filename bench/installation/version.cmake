# cmake -DRELEASE=0.1.0 -DSOURCE=… -DTEMPLATE=… -DOUTPUT=… -P version.cmake: writes version.cpp with the
# release and the git revision of the sources. The file is left alone if it would not change.
execute_process(
  COMMAND git -C ${SOURCE} describe --always --dirty --abbrev=12 --exclude=*
  OUTPUT_VARIABLE revision
  OUTPUT_STRIP_TRAILING_WHITESPACE
  ERROR_QUIET)
set(version ${RELEASE})
if(revision)
  string(APPEND version " (${revision})")
endif()
configure_file(${TEMPLATE} ${OUTPUT} @ONLY)
