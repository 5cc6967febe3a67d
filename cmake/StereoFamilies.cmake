# SPDX-License-Identifier: Apache-2.0
# stereo_add_family(NAME <family> SOURCES <folder> MODELS <header> LINK <library>)
#
# Makes the named configurations of a family known to all programs. In the folder (from the project's root; on its include
# path, beside hls/) stands <family>/family.hpp with the core, and <family>/configurations.hpp with the rows. <header>, seen
# from hls_tb/: the family's models, compiled in the library.
#
# Rows of the user's own, for which STEREO_OWN_ROWS names a folder with <family>.hpp, stand behind those.
#
# For each row core_<name>, a module with the clocked core, is made in the folder `cores` of the build; `cores` are all of
# them, `tested_cores` those that the fast set of the tests takes.
function(stereo_add_family)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "NAME;SOURCES;MODELS;LINK" "")
  set(entries "")
  set(folder "${PROJECT_SOURCE_DIR}/${arg_SOURCES}")
  stereo_read_rows("${folder}/${arg_NAME}/configurations.hpp")
  stereo_add_rows(${arg_SOURCES})
  set(own "${STEREO_OWN_ROWS}/${arg_NAME}.hpp")
  if(STEREO_OWN_ROWS AND EXISTS "${own}")
    stereo_read_rows("${own}")
    stereo_write_own_rows(${arg_NAME} ${arg_SOURCES} "${own}")
    stereo_add_rows(${STEREO_OWN_FOLDER})
  endif()
  file(CONFIGURE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/${arg_NAME}_configurations.cpp" @ONLY CONTENT
"// Made by CMake from ${arg_SOURCES}/${arg_NAME}/configurations.hpp.
#include \"${arg_MODELS}\"
#include \"${arg_NAME}/family.hpp\"
#include \"engines/families.hpp\"
#include \"random_cores/random_options.hpp\"

namespace stereo {
Family make_${arg_NAME}();
Family make_${arg_NAME}() {
   using namespace ${arg_NAME};
   return {\"${arg_NAME}\", \"${arg_SOURCES}\", {
${entries}   }, std::make_shared<AlgorithmOf<Matching>>(Matching()), &random_row<Config>,
           option_limits(Config())};
}
}  // namespace stereo
")
  target_sources(stereo_configurations PRIVATE "${CMAKE_CURRENT_BINARY_DIR}/${arg_NAME}_configurations.cpp")
  # A table: nobody waits for it, and everybody who changes a block for its compilation.
  set_source_files_properties("${CMAKE_CURRENT_BINARY_DIR}/${arg_NAME}_configurations.cpp" PROPERTIES COMPILE_OPTIONS -O0)
  target_include_directories(stereo_configurations PRIVATE "${folder}")
  target_link_libraries(stereo_configurations PUBLIC ${arg_LINK})
  set_property(GLOBAL APPEND PROPERTY STEREO_FAMILIES make_${arg_NAME})
endfunction()

# stereo_add_rows(<folder>): what stereo_add_family adds for the rows just read, whose table stands in the folder.
macro(stereo_add_rows sources)
  foreach(name use IN ZIP_LISTS names uses)
    string(APPEND entries "      configuration_entry<Core<configurations::${name}>>("
           "\"${name}\", \"${use}\", \"${arg_NAME}\", \"${sources}\"),\n")
    stereo_add_core(NAME ${name} FAMILY ${arg_NAME} USE ${use} FOLDER "${PROJECT_SOURCE_DIR}/${sources}")
    add_dependencies(cores core_${name})
    if(name IN_LIST STEREO_TESTED)
      add_dependencies(tested_cores core_${name})
    endif()
  endforeach()
endmacro()

# stereo_write_own_rows(<family> <sources> <file>): the table that takes the place of the family's for the user's own rows: the
# family's, then theirs. It stands in STEREO_OWN_FOLDER, from the project's root, as the synthesis tool gets a copy of what is
# below the root. `rtl` there is where their VHDL goes, in the user's folder.
function(stereo_write_own_rows family sources file)
  foreach(name use IN ZIP_LISTS names uses)
    if(NOT use STREQUAL "own")
      message(FATAL_ERROR "${file}: ${name}: the use of a row of your own is `own`, not `${use}`")
    elseif(TARGET core_${name})
      message(FATAL_ERROR "${file}: ${name}: another configuration has this name")
    endif()
  endforeach()
  file(READ "${file}" rows)
  set(folder "${PROJECT_SOURCE_DIR}/${STEREO_OWN_FOLDER}")
  file(RELATIVE_PATH table "${folder}/${family}" "${PROJECT_SOURCE_DIR}/${sources}/${family}/configurations.hpp")
  file(CONFIGURE OUTPUT "${folder}/${family}/configurations.hpp" @ONLY CONTENT
"// Made by CMake from the rows of the family and ${file}.
#pragma once

#include \"${table}\"
#line 1 \"${file}\"
${rows}")
  file(CREATE_LINK "${file}" "${folder}/${family}/rows.hpp" SYMBOLIC) # whose time says whether the program is older
  target_include_directories(stereo_configurations BEFORE PRIVATE "${folder}")
endfunction()

# stereo_read_rows(<table>): sets `names` and `uses` to those of the rows of a table of configurations.
function(stereo_read_rows table)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${table}")
  file(STRINGS "${table}" rows REGEX "^STEREO_ROW\\(")
  set(names "")
  set(uses "")
  foreach(row IN LISTS rows)
    string(REGEX MATCH "^STEREO_ROW\\(([a-z0-9_]+), ([a-z]+)," matched "${row}")
    if(NOT matched)
      message(FATAL_ERROR "${table}: a row begins STEREO_ROW(name, use, base, but one begins ${row}")
    endif()
    list(APPEND names ${CMAKE_MATCH_1})
    list(APPEND uses ${CMAKE_MATCH_2})
  endforeach()
  set(names "${names}" PARENT_SCOPE)
  set(uses "${uses}" PARENT_SCOPE)
endfunction()

# stereo_add_stage(NAME <stage> SOURCES <folder> HEADER <header>)
#
# Makes the named configurations of a stage in front of a matching core known to all programs, from <stage>/configurations.hpp
# in the folder. <header>, seen from hls_tb/, has stage_entry.
function(stereo_add_stage)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "NAME;SOURCES;HEADER" "")
  stereo_read_rows("${PROJECT_SOURCE_DIR}/${arg_SOURCES}/${arg_NAME}/configurations.hpp")
  set(entries "")
  foreach(name use IN ZIP_LISTS names uses)
    string(APPEND entries "      stage_entry<${arg_NAME}::configurations::${name}>("
           "\"${name}\", \"${use}\", \"${arg_NAME}\", \"${arg_SOURCES}\"),\n")
  endforeach()
  file(CONFIGURE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/${arg_NAME}_stages.cpp" @ONLY CONTENT
"// Made by CMake from ${arg_SOURCES}/${arg_NAME}/configurations.hpp.
#include \"${arg_HEADER}\"
#include \"${arg_NAME}/configurations.hpp\"

namespace stereo {
std::vector<Stage> make_${arg_NAME}_stages();
std::vector<Stage> make_${arg_NAME}_stages() {
   return {
${entries}   };
}
}  // namespace stereo
")
  target_sources(stereo_configurations PRIVATE "${CMAKE_CURRENT_BINARY_DIR}/${arg_NAME}_stages.cpp")
endfunction()

# stereo_add_core(NAME <configuration> FAMILY <family> USE <use> FOLDER <folder>): the module of one configuration.
function(stereo_add_core)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "NAME;FAMILY;USE;FOLDER" "")
  add_library(core_${arg_NAME} MODULE EXCLUDE_FROM_ALL "${PROJECT_SOURCE_DIR}/hls_tb/engines/clocked/core_module.cpp")
  target_compile_definitions(core_${arg_NAME} PRIVATE STEREO_FAMILY=${arg_FAMILY} STEREO_CONFIGURATION=${arg_NAME})
  target_include_directories(core_${arg_NAME} PRIVATE "${arg_FOLDER}" "${PROJECT_SOURCE_DIR}/hls" "${PROJECT_SOURCE_DIR}/hls_tb")
  target_link_libraries(core_${arg_NAME} PRIVATE stereo_register_list stereo_warnings)
  # Benchmarks time these; for the others the compiler's time counts more.
  if(NOT arg_USE STREQUAL paper)
    target_compile_options(core_${arg_NAME} PRIVATE -O1)
    target_precompile_headers(core_${arg_NAME} REUSE_FROM stereo_core_headers)
  elseif(STEREO_SHARED_LAUNCHER)
    set_target_properties(core_${arg_NAME} PROPERTIES CXX_COMPILER_LAUNCHER "${STEREO_SHARED_LAUNCHER}")
  endif()
  set_target_properties(core_${arg_NAME} PROPERTIES PREFIX "" OUTPUT_NAME ${arg_NAME} LIBRARY_OUTPUT_DIRECTORY
                                                                                      "${PROJECT_BINARY_DIR}/cores")
endfunction()

# Writes the list of families that stereo_configurations reads. Call it behind all stereo_add_family.
function(stereo_write_families)
  get_property(families GLOBAL PROPERTY STEREO_FAMILIES)
  list(TRANSFORM families REPLACE "^.+$" "CALL(\\0)")
  list(JOIN families " " calls)
  file(CONFIGURE OUTPUT family_list.hpp CONTENT "#define STEREO_FAMILIES(CALL) ${calls}\n")
  target_include_directories(stereo_configurations PRIVATE "${CMAKE_CURRENT_BINARY_DIR}")
endfunction()
