# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause

# Builds and installs the modules named in `modules` with VTK's module system.

list(TRANSFORM modules REPLACE "(.+)" "${CMAKE_CURRENT_SOURCE_DIR}/Filters/\\1/vtk.module"
  OUTPUT_VARIABLE module_files)
list(TRANSFORM modules PREPEND "SurfaceDenoising::" OUTPUT_VARIABLE module_targets)
list(TRANSFORM wrapped_modules PREPEND "SurfaceDenoising::" OUTPUT_VARIABLE wrapped_targets)

# Installed libraries find one another in their own folder, wherever that is moved to, and VTK where
# it was at build time.
if (APPLE)
  set(CMAKE_INSTALL_RPATH "@loader_path")
else ()
  set(CMAKE_INSTALL_RPATH "$ORIGIN")
endif ()
set(CMAKE_INSTALL_RPATH_USE_LINK_PATH ON)

vtk_module_scan(
  MODULE_FILES ${module_files}
  REQUEST_MODULES ${module_targets}
  PROVIDES_MODULES found_modules
  WANT_BY_DEFAULT ON)

vtk_module_build(
  MODULES ${found_modules}
  PACKAGE SurfaceDenoising
  INSTALL_EXPORT SurfaceDenoising
  UTILITY_TARGET SurfaceDenoisingBuild
  HEADERS_DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/SurfaceDenoising"
  TEST_DIRECTORY_NAME NONE)
