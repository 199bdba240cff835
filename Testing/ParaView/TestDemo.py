# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The demo writes a surface or a cloud that is cleaner than its input, in formats that can be read,
and a picture that shows something; it refuses what it cannot denoise."""

import io
import os
import runpy
import sys
from contextlib import redirect_stdout

import numpy
from paraview.servermanager import Fetch
from paraview.simple import (GenerateSurfaceNormals, OpenDataFile, PointSource, SaveData, Sphere,
                             SurfaceComparison, SurfaceNoise)

from panels import check_panels

PYTHON = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../Examples/Python")
sys.path.insert(0, PYTHON)
sys.dont_write_bytecode = True
from clouds import bare_points
from surfaces import has_polygons, open_surface, positions


def demo(*arguments):
    """What the script prints."""
    sys.argv = ["demo.py", *arguments]
    printed = io.StringIO()
    with redirect_stdout(printed):
        runpy.run_path(os.path.join(PYTHON, "demo.py"), run_name="__main__")
    return printed.getvalue()


def measured(surface, truth, quantity):
    comparison = SurfaceComparison(Input=surface, Reference=truth)
    comparison.UpdatePipeline()
    comparison.UpdatePropertyInformation()
    return comparison.GetProperty(quantity).GetData()


truth = Sphere(ThetaResolution=40, PhiResolution=40)
noisy = SurfaceNoise(Input=truth, Size=0.2)
SaveData("noisy.ply", noisy)

demo("noisy.ply", "--output", "own", "--method", "robust", "--range-scale", "0.35")
for name in ("own/denoised.vtp", "own/denoised.ply"):
    angles = [measured(surface, truth, "MeanNormalAngle")
              for surface in (OpenDataFile(name), noisy)]
    assert angles[0] < 0.6 * angles[1], (name, angles)

check_panels("own/denoising.png", columns=3)

# A cloud, in a text without normals; a mesh by its points; a clean model that gets noise.
numpy.savetxt("noisy.xyz", positions(noisy))
SaveData("truth.ply", truth)
before = measured(noisy, truth, "RelativeMeanDistance")
for folder, arguments, columns in (
        ("cloud", ("noisy.xyz", "--point-iterations", "7"), 3),
        ("by_method", ("noisy.ply", "--method", "rolling point normal"), 3),
        ("automatic", ("noisy.xyz",), 3),
        ("known", ("--truth", "truth.ply", "--noise", "0.2", "--points", "--method",
                   "Denoise Surface"), 2)):
    printed = demo(*arguments, "--output", folder)
    assert ("-- Denoise Surface" in printed) == (folder in ("automatic", "known")), printed
    for name in ("denoised.vtp", "denoised.ply", "denoised.xyz"):
        file = os.path.join(folder, name)
        cloud = open_surface(file, polygons=False)
        distance = measured(cloud, truth, "RelativeMeanDistance")
        assert distance < 0.6 * before, (file, distance, before)
        assert not has_polygons(cloud), file
        normals = Fetch(cloud).GetPointData().GetNormals()
        assert normals or name == "denoised.ply", file
    check_panels(os.path.join(folder, "denoising.png"), columns, rows=2 if columns == 2 else 1)
assert not os.path.exists("own/denoised.xyz"), "surfaces are no lists of points"

bare = Fetch(bare_points(GenerateSurfaceNormals(Input=truth)))
assert bare.GetNumberOfVerts() == bare.GetNumberOfPoints() > 0, "points that are seen"
assert bare.GetPointData().GetNumberOfArrays() == 0, "clean normals tell nothing of noisy points"

SaveData("points.vtp", PointSource(NumberOfPoints=10), DataMode="Ascii")
for name, arguments in (("points.vtp", ("--method", "Bilateral normal")),
                        ("missing.ply", ())):
    try:
        demo(name, *arguments, "--output", "none")
        assert False, name + " was accepted"
    except SystemExit as end:
        assert name in str(end), end
