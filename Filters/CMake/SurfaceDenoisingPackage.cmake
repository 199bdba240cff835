# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause

# The CMake package: what find_package(SurfaceDenoising) reads, in build and install tree.

include(CMakePackageConfigHelpers)

set(package_destination "${CMAKE_INSTALL_LIBDIR}/cmake/SurfaceDenoising")
set(package_vtk_components CommonCore CommonDataModel CommonExecutionModel IOCore)
list(JOIN package_vtk_components " " package_vtk_components)
file(RELATIVE_PATH package_vtk_suffix "${VTK_PREFIX_PATH}" "${VTK_DIR}")
if (SurfaceDenoising_WITH_PARAVIEW)
  set(package_vtk_origin " of ParaView ${ParaView_VERSION}")
endif ()

configure_package_config_file(
  "${CMAKE_CURRENT_LIST_DIR}/SurfaceDenoisingConfig.cmake.in"
  "${CMAKE_BINARY_DIR}/${package_destination}/SurfaceDenoisingConfig.cmake"
  INSTALL_DESTINATION "${package_destination}")
write_basic_package_version_file(
  "${CMAKE_BINARY_DIR}/${package_destination}/SurfaceDenoisingConfigVersion.cmake"
  COMPATIBILITY SameMajorVersion)
install(
  FILES
    "${CMAKE_BINARY_DIR}/${package_destination}/SurfaceDenoisingConfig.cmake"
    "${CMAKE_BINARY_DIR}/${package_destination}/SurfaceDenoisingConfigVersion.cmake"
  DESTINATION "${package_destination}"
  COMPONENT development)
install(FILES "${CMAKE_CURRENT_SOURCE_DIR}/Filters/LICENSE"
  DESTINATION "${CMAKE_INSTALL_DATADIR}/licenses/SurfaceDenoising"
  COMPONENT runtime)
