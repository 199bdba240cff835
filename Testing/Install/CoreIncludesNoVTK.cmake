# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause

# The numeric core must not know VTK: no file in `folder` may include a header vtk*.

file(GLOB_RECURSE files "${folder}/*.h" "${folder}/*.cxx")
if (NOT files)
  message(FATAL_ERROR "There are no sources in ${folder}")
endif ()
foreach (file IN LISTS files)
  file(STRINGS "${file}" includes REGEX "^[ \t]*#[ \t]*include[ \t]*[<\"]([^>\"]*/)?vtk")
  foreach (include IN LISTS includes)
    message(SEND_ERROR "${file}: ${include}")
  endforeach ()
endforeach ()
