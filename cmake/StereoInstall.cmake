# SPDX-License-Identifier: Apache-2.0
# cmake --install BUILD_FOLDER --prefix PREFIX: the program with the clocked cores that are built, the headers of the cores for
# C++ of one's own (find_package(stereo_hls), target stereo_hls::cores), and the VHDL with its manifests.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)
set(program_folder ${CMAKE_INSTALL_LIBDIR}/stereo_hls)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/stereo_hls)
set(header_folder ${CMAKE_INSTALL_INCLUDEDIR}/stereo_hls)
set(data_folder ${CMAKE_INSTALL_DATADIR}/stereo_hls)

# The program looks for its modules beside the file that the link leads to.
install(TARGETS stereo_hls stereo_hls_images stereo_hls_video RUNTIME DESTINATION ${program_folder} LIBRARY DESTINATION ${program_folder})
file(MAKE_DIRECTORY "${PROJECT_BINARY_DIR}/cores")
install(DIRECTORY "${PROJECT_BINARY_DIR}/cores" DESTINATION ${program_folder} FILES_MATCHING PATTERN "*.so")
file(RELATIVE_PATH program_link "/${CMAKE_INSTALL_BINDIR}" "/${program_folder}/stereo_hls")
file(MAKE_DIRECTORY "${PROJECT_BINARY_DIR}/link")
file(CREATE_LINK "${program_link}" "${PROJECT_BINARY_DIR}/link/stereo_hls" SYMBOLIC)
install(FILES "${PROJECT_BINARY_DIR}/link/stereo_hls" DESTINATION ${CMAKE_INSTALL_BINDIR})

add_library(cores_headers INTERFACE)
set_target_properties(cores_headers PROPERTIES EXPORT_NAME cores)
target_compile_features(cores_headers INTERFACE cxx_std_20)
target_compile_options(cores_headers INTERFACE -Wno-unknown-pragmas) # those of the synthesis tool
target_include_directories(cores_headers INTERFACE "$<INSTALL_INTERFACE:${header_folder}>")
install(TARGETS cores_headers EXPORT stereo_hls)
install(EXPORT stereo_hls FILE stereo_hlsConfig.cmake NAMESPACE stereo_hls:: DESTINATION ${package_folder})
write_basic_package_version_file(stereo_hlsConfigVersion.cmake COMPATIBILITY SameMajorVersion ARCH_INDEPENDENT)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/stereo_hlsConfigVersion.cmake" DESTINATION ${package_folder})
install(DIRECTORY hls/ DESTINATION ${header_folder} FILES_MATCHING PATTERN "*.hpp")
# Where a core keeps its memories in native code.
install(FILES hls_tb/engines/clocked/heap_memories.hpp DESTINATION ${header_folder}/engines/clocked)

install(DIRECTORY hls/rtl generated_rtl DESTINATION ${data_folder} FILES_MATCHING PATTERN "*.vhd" PATTERN "*.json")
install(FILES LICENSE DESTINATION ${data_folder})
