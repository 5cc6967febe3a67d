# SPDX-License-Identifier: Apache-2.0
include(GoogleTest)

# ctest labels, and the tools that their tests need:
#   unit   no hardware tool
#   cosim  GHDL; some also Verilator, yosys with yosys-abc, cocotb or FuseSoC (both from PyPI)
#   synth  GHDL with Bambu, or with yosys and nextpnr (from PyPI)
#   slow   takes many minutes; mostly beside one of the others

# stereo_add_pytest(NAME <test> FILE <file.py> [LABELS <label>...] [TIMEOUT <seconds>])
#
# Runs one pytest file. Its cases that are marked `slow`, where it has any and is not slow as a whole, are a test of their own,
# <test>_slow, with the label slow. The test finds the program in env STEREO_HLS and the sources in env STEREO_SOURCE_DIR. It counts
# as skipped, with the reason in its output, when every case of the file skipped itself (a missing tool).
function(stereo_add_pytest)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "NAME;FILE;TIMEOUT" "LABELS")
  if(NOT arg_TIMEOUT)
    set(arg_TIMEOUT 600)
  endif()
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${arg_FILE}")
  file(STRINGS "${arg_FILE}" marks REGEX "mark\\.slow|with_slow\\(")
  if(NOT marks OR slow IN_LIST arg_LABELS)
    stereo_add_pytest_run(${arg_NAME} "${arg_LABELS}" ${arg_TIMEOUT} "${arg_FILE}")
  else()
    stereo_add_pytest_run(${arg_NAME} "${arg_LABELS}" ${arg_TIMEOUT} -m "not slow" "${arg_FILE}")
    stereo_add_pytest_run(${arg_NAME}_slow "${arg_LABELS};slow" 7200 -m slow "${arg_FILE}")
  endif()
endfunction()

# stereo_add_pytest_run(<test> <labels> <seconds> <word>...): what stereo_add_pytest adds; the words are pytest's.
function(stereo_add_pytest_run name labels timeout)
  add_test(NAME ${name} COMMAND "${Python3_EXECUTABLE}" "${PROJECT_SOURCE_DIR}/cmake/run_pytest.py" ${ARGN})
  set(environment "STEREO_HLS=$<TARGET_FILE:stereo_hls>" "STEREO_SOURCE_DIR=${PROJECT_SOURCE_DIR}" "STEREO_TEST=${name}")
  # The fast set plays so few frames that -O2 takes the compiler longer than it saves.
  if(NOT slow IN_LIST labels)
    list(APPEND environment STEREO_MODEL_OPTIMISATION=-O1)
  endif()
  set_tests_properties(
    ${name}
    PROPERTIES LABELS "${labels}"
               TIMEOUT ${timeout}
               SKIP_RETURN_CODE 77
               ENVIRONMENT "${environment}")
endfunction()

# stereo_add_unit_tests([SLOW | SLOW_TYPES] LINK <library>... FILES <file>...)
#
# A program for each file of GoogleTest cases, named after its path without "_test.cpp": blocks/cost/sad_cost_test.cpp
# becomes blocks_cost_sad_cost_test. With SLOW the target slow_tests builds it, and it is one test with the label slow. With
# SLOW_TYPES there is another one of that kind, NAME_slow, which has all types of typed tests (testing/types.hpp).
function(stereo_add_unit_tests)
  cmake_parse_arguments(PARSE_ARGV 0 arg "SLOW;SLOW_TYPES" "" "LINK;FILES")
  foreach(file IN LISTS arg_FILES)
    string(REGEX REPLACE "\\.cpp$" "" name "${file}")
    string(REPLACE "/" "_" name "${name}")
    stereo_add_unit_program(${name} "${file}" ${arg_LINK})
    if(arg_SLOW)
      stereo_make_slow(${name})
    else()
      gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 120 PROPERTIES LABELS unit TIMEOUT 600)
    endif()
    if(arg_SLOW_TYPES)
      stereo_add_unit_program(${name}_slow "${file}" ${arg_LINK})
      target_compile_definitions(${name}_slow PRIVATE STEREO_ALL_TYPES)
      stereo_make_slow(${name}_slow)
    endif()
  endforeach()
endfunction()

# stereo_add_unit_program(<name> <file> <library>...), stereo_make_slow(<name>): what stereo_add_unit_tests adds.
function(stereo_add_unit_program name file)
  add_executable(${name} "${file}")
  target_include_directories(${name} SYSTEM PRIVATE ${OpenCV_INCLUDE_DIRS})
  target_link_libraries(${name} PRIVATE ${ARGN})
  target_precompile_headers(${name} REUSE_FROM stereo_testing)
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/tests")
endfunction()
function(stereo_make_slow name)
  set_target_properties(${name} PROPERTIES EXCLUDE_FROM_ALL ON)
  add_dependencies(slow_tests ${name})
  add_test(NAME ${name} COMMAND ${name})
  set_tests_properties(${name} PROPERTIES LABELS "unit;slow" TIMEOUT 3600)
endfunction()

# stereo_add_rejected_source(NAME <test> SOURCE <file.cpp> DEFINITION <macro=value> MESSAGE <regular expression>)
#
# Passes when the compiler refuses the source with that message.
function(stereo_add_rejected_source)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "NAME;SOURCE;DEFINITION;MESSAGE" "")
  add_test(NAME ${arg_NAME} COMMAND "${CMAKE_CXX_COMPILER}" -std=c++20 -fsyntax-only "-I${PROJECT_SOURCE_DIR}/hls"
                                    "-D${arg_DEFINITION}" "${CMAKE_CURRENT_SOURCE_DIR}/${arg_SOURCE}")
  set_tests_properties(${arg_NAME} PROPERTIES LABELS unit PASS_REGULAR_EXPRESSION "${arg_MESSAGE}")
endfunction()
