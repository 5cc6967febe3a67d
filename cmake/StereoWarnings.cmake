# SPDX-License-Identifier: Apache-2.0
# stereo_warnings         for code that instantiates hls/, where every assignment to a register narrows on purpose, as
#                         wires do: no -Wconversion
# stereo_strict_warnings  for all other code
add_library(stereo_warnings INTERFACE)
target_compile_options(stereo_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow $<$<BOOL:${STEREO_WERROR}>:-Werror>)
# From g++ 13 on: takes whatever a function returns for a part of what it is given, such as the module of a name.
include(CheckCXXCompilerFlag)
check_cxx_compiler_flag(-Wdangling-reference STEREO_HAS_DANGLING_REFERENCE)
if(STEREO_HAS_DANGLING_REFERENCE)
  target_compile_options(stereo_warnings INTERFACE -Wno-dangling-reference)
endif()

add_library(stereo_strict_warnings INTERFACE)
target_compile_options(stereo_strict_warnings INTERFACE -Wconversion)
target_link_libraries(stereo_strict_warnings INTERFACE stereo_warnings)
