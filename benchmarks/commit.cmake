cmake_minimum_required(VERSION 3.22)
# Writes the commit of SOURCE into the header TARGET, if it has changed.
execute_process(
  COMMAND git -C ${SOURCE} describe --always --dirty --abbrev=12
  OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  set(commit "unknown")
endif()
file(CONFIGURE OUTPUT ${TARGET} CONTENT "#define SIGNORINI_COMMIT \"@commit@\"\n" @ONLY)
