# SPDX-License-Identifier: Apache-2.0
# Finds the VHDL simulator GHDL: first env GHDL (the program itself), then PATH.
#
# GHDL_FOUND       whether it was found
# GHDL_EXECUTABLE  the program
# GHDL_VERSION     such as 2.0.0
find_program(GHDL_EXECUTABLE NAMES "$ENV{GHDL}" ghdl)
if(GHDL_EXECUTABLE)
  execute_process(COMMAND "${GHDL_EXECUTABLE}" --version OUTPUT_VARIABLE _ghdl_text ERROR_QUIET)
  if(_ghdl_text MATCHES "GHDL ([0-9]+[0-9.]*)")
    set(GHDL_VERSION "${CMAKE_MATCH_1}")
  endif()
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(GHDL REQUIRED_VARS GHDL_EXECUTABLE VERSION_VAR GHDL_VERSION)
mark_as_advanced(GHDL_EXECUTABLE)
