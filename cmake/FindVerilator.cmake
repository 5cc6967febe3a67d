# SPDX-License-Identifier: Apache-2.0
# Finds the simulator Verilator: first env VERILATOR (the program itself), then PATH.
#
# Verilator_FOUND       whether it was found
# Verilator_EXECUTABLE  the program
# Verilator_VERSION     such as 5.006
find_program(Verilator_EXECUTABLE NAMES "$ENV{VERILATOR}" verilator)
if(Verilator_EXECUTABLE)
  execute_process(COMMAND "${Verilator_EXECUTABLE}" --version OUTPUT_VARIABLE _verilator_text ERROR_QUIET)
  if(_verilator_text MATCHES "Verilator ([0-9]+[0-9.]*)")
    set(Verilator_VERSION "${CMAKE_MATCH_1}")
  endif()
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Verilator REQUIRED_VARS Verilator_EXECUTABLE VERSION_VAR Verilator_VERSION)
mark_as_advanced(Verilator_EXECUTABLE)
