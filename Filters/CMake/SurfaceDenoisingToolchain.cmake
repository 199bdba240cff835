# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause

# Finds what the project is built with and defines the target SurfaceDenoisingBuild, which carries
# everything that only the build needs: header-only libraries and warnings. All our own sources link
# it privately, the generated wrapping code does not, and the installed package never mentions it.

if (NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif ()

if (SurfaceDenoising_WITH_PARAVIEW)
  find_package(ParaView 5.11 REQUIRED COMPONENTS RemotingCore WrapClientServer ProcessXML)
endif ()

# ParaView brings its own VTK: this call then returns that one with our components.
set(vtk_components
  CommonCore CommonDataModel CommonExecutionModel FiltersCore FiltersGeneral IOCore)
if (SurfaceDenoising_WRAP_PYTHON)
  list(APPEND vtk_components Python WrappingPythonCore)
endif ()
if (BUILD_TESTING)
  list(APPEND vtk_components FiltersSources TestingCore)
endif ()
find_package(VTK 9.1 REQUIRED COMPONENTS ${vtk_components})

find_package(Eigen3 3.3 REQUIRED NO_MODULE)
find_package(nanoflann 1.4 REQUIRED)

add_library(SurfaceDenoisingBuild INTERFACE)
target_compile_features(SurfaceDenoisingBuild INTERFACE cxx_std_17)
target_link_libraries(SurfaceDenoisingBuild INTERFACE Eigen3::Eigen nanoflann::nanoflann)
target_compile_options(SurfaceDenoisingBuild INTERFACE
  $<$<COMPILE_LANG_AND_ID:CXX,GNU,Clang,AppleClang>:-Wall -Wextra>)

if (SurfaceDenoising_SANITIZE)
  # The checks of each access for null, alignment and size are left out (the address sanitizer sees
  # bad accesses itself), and symbols but for those of a stack trace: two thirds of the compilation.
  add_compile_options(-fsanitize=${SurfaceDenoising_SANITIZE} -fno-sanitize-recover=all
    -fno-sanitize=null,alignment,object-size -fno-omit-frame-pointer -g1)
  add_link_options(-fsanitize=${SurfaceDenoising_SANITIZE})
endif ()
