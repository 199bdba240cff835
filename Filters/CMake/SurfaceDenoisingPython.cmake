# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause

# The Python package surfacedenoising: one extension module per wrapped VTK module and an
# __init__.py that gathers their classes. It lies beside vtkmodules in build and install tree:
# <prefix>/lib/python3.x/site-packages is what PYTHONPATH needs.

vtk_module_python_default_destination(python_destination)

vtk_module_wrap_python(
  MODULES ${wrapped_targets}
  TARGET SurfaceDenoising::Python
  PYTHON_PACKAGE surfacedenoising
  MODULE_DESTINATION "${python_destination}"
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  CMAKE_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/SurfaceDenoising"
  BUILD_STATIC OFF
  INSTALL_HEADERS OFF)

list(TRANSFORM wrapped_modules REPLACE "(.+)" "from .vtkSurfaceDenoising\\1 import *\n"
  OUTPUT_VARIABLE imports)
list(JOIN imports "" imports)
set(package_init "${CMAKE_BINARY_DIR}/${python_destination}/surfacedenoising/__init__.py")
file(CONFIGURE OUTPUT "${package_init}" @ONLY CONTENT
"\"\"\"Robust normal filtering for surface denoising, to be used beside vtkmodules.\"\"\"

@imports@
__version__ = \"@PROJECT_VERSION@\"
")
install(FILES "${package_init}" DESTINATION "${python_destination}/surfacedenoising"
  COMPONENT python)
