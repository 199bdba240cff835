# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause

# Runs the application on good and bad files and looks at exit codes and messages.

# expect(<exit code> <pattern of the output> <argument>...)
function (expect code pattern)
  execute_process(COMMAND "${denoise}" ${ARGN}
    RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if (NOT result STREQUAL "${code}" OR NOT output MATCHES "${pattern}")
    message(SEND_ERROR "denoise ${ARGN}: exit code ${result} instead of ${code}, or no \"${pattern}\" in:\n${output}")
  endif ()
endfunction ()

set(cube "OFF
8 6 0
0 0 0\n1 0 0.1\n1 1 0\n0 1 0.05\n0 0 1\n1 0 1\n1 1 1.1\n0 1 1
4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n")
file(WRITE cube.off "${cube}")
file(WRITE points.off "OFF\n2 0 0\n0 0 0\n1 1 1\n")
# A grid of points that are not quite in a plane.
set(cloud "")
foreach (i RANGE 7)
  foreach (j RANGE 7)
    math(EXPR height "(${i} * 7 + ${j} * 3) % 5")
    string(APPEND cloud "${i} ${j} 0.${height}\n")
  endforeach ()
endforeach ()
file(WRITE cloud.xyz "${cloud}")
file(WRITE broken.xyz "0 0 0\n1 0\n")
file(WRITE broken.off "OFF\n8 6 0\n0 0 0\n1 0\n")
file(WRITE empty.ply "")
file(WRITE scan.docx "a mesh, perhaps")
file(WRITE lies.stl "this is no STL file")
string(REPLACE "0 1 0.05" "0 nan 0.05" not_finite "${cube}")
file(WRITE not_finite.off "${not_finite}")

foreach (extension IN ITEMS ply obj stl vtp vtk)
  expect(0 "8 points, 6 polygons" cube.off clean.${extension} --vertex-iterations 3)
  if (NOT EXISTS "${CMAKE_CURRENT_BINARY_DIR}/clean.${extension}")
    message(SEND_ERROR "clean.${extension} was not written")
  endif ()
  expect(0 "^$" clean.${extension} again.ply --quiet)
endforeach ()
expect(0 "after:.*mean normal angle" cube.off clean.ply --reference cube.off --threads 1)
expect(0 "denoising 100%" cube.off clean.ply --method robust --norm truncated-l2 --range-scale 0.5)

# Points, which need no polygons.
foreach (extension IN ITEMS ply obj vtp vtk)
  expect(0 "64 points, 0 polygons" cloud.xyz clean.${extension})
  expect(0 "64 points, 0 polygons" clean.${extension} again.vtp --method robust-point-normal)
endforeach ()
expect(4 "polygons" cloud.xyz clean.stl)
foreach (method IN ITEMS robust-implicit-mls moving-robust-pca feature-aware-point tensor-point
    bilateral-point rolling-point-normal moving-least-squares guided-point-normal
    voting-tensor-point)
  expect(0 "after:.*mean distance" cloud.xyz clean.vtp --method ${method} --reference cloud.xyz)
endforeach ()
expect(0 "8 points, 6 polygons" cube.off clean.ply --method moving-robust-pca)
expect(1 "has no meaning" cloud.xyz clean.vtp --boundary free)
expect(1 "has no meaning" cloud.xyz clean.vtp --method tensor-point --norm tukey)
expect(0 "64 points" cloud.xyz clean.vtp --norm tukey --range-scale 0.5 --spatial-scale 2
  --outer-iterations 2 --normal-iterations 3 --point-iterations 4 --maximum-displacement 1)

# Steps and scales: 0 is from the data, -1 none, and what a filter does not know is no default of it.
expect(0 "settings" cube.off clean.ply --range-scale 0 --spatial-scale 0 --normal-iterations 0)
expect(0 "64 points" cloud.xyz clean.vtp --range-scale 0 --spatial-scale 0 --point-iterations 0)
expect(0 "" cube.off kept.ply --quiet --vertex-iterations -1 --normal-iterations -1 -s -1)
file(READ kept.ply kept)
expect(0 "" cube.off same.ply --quiet --outer-iterations -1)
file(READ same.ply same)
if (NOT kept STREQUAL same)
  message(SEND_ERROR "no vertex iterations are not the same as nothing at all")
endif ()
expect(1 "spatial-scale" cube.off clean.ply --spatial-scale -0.5)
expect(1 "spatial-scale" cube.off clean.ply --method bilateral-vertex --spatial-scale -1)
expect(1 "range-scale" cube.off clean.ply --range-scale 5)
expect(1 "range-scale" cube.off clean.ply --range-scale -1)
expect(1 "vertex-iterations" cube.off clean.ply --vertex-iterations -2)

expect(0 "--method" --help)
expect(1 "required" cube.off)
expect(1 "norm" cube.off clean.ply --method robust --norm mean-ish)
expect(1 "has no meaning" cube.off clean.ply --norm tukey)
expect(1 "has no meaning" cube.off clean.ply --method mean-curvature-flow --range-scale 1)
expect(1 "guided-normal" cube.off clean.ply --method guided)
foreach (method IN ITEMS guided-normal weighted-median-normal global-bilateral-normal
    thresholded-cosine mean-curvature-flow)
  expect(0 "8 points, 6 polygons" cube.off clean.ply --method ${method})
endforeach ()
expect(2 "no such file" missing.ply clean.ply)
expect(2 "folder" . clean.ply)
expect(2 "empty" empty.ply clean.ply)
expect(2 "lies.stl" lies.stl clean.ply)
expect(2 "broken.off" broken.off clean.ply)
expect(2 "finite" not_finite.off clean.ply)
foreach (extension IN ITEMS xyz xyzn pts asc XYZ)
  file(WRITE points.${extension} "0 0 0 0 0 1\n1 0 0 0 0 1\n1 1 0 0 0 1\n")
  expect(0 "3 points, 0 polygons" points.${extension} clean.ply)
  expect(2 "3 points but no polygons" points.${extension} clean.ply --method guided-normal)
endforeach ()
expect(2 "no polygons" points.off clean.ply --method bilateral-normal)
expect(2 "line 2: 2 columns" broken.xyz clean.ply)
expect(2 "not as" scan.docx clean.ply)
expect(4 "not as" cube.off clean.docx)
expect(4 "no folder" cube.off nowhere/clean.ply)
