# SPDX-License-Identifier: Apache-2.0
# Finds the high-level synthesis tool Bambu: first env BAMBU (the program itself), then PATH.
#
# Bambu_FOUND       whether it was found
# Bambu_EXECUTABLE  the program
# Bambu_VERSION     such as 2024.10
find_program(Bambu_EXECUTABLE NAMES "$ENV{BAMBU}" bambu)
if(Bambu_EXECUTABLE)
  execute_process(COMMAND "${Bambu_EXECUTABLE}" --version OUTPUT_VARIABLE _bambu_text ERROR_QUIET)
  if(_bambu_text MATCHES "PandA ([0-9]+[0-9.]*)")
    set(Bambu_VERSION "${CMAKE_MATCH_1}")
  endif()
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Bambu REQUIRED_VARS Bambu_EXECUTABLE VERSION_VAR Bambu_VERSION)
mark_as_advanced(Bambu_EXECUTABLE)
