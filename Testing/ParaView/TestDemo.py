# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The demo writes a surface that is cleaner than its input, in formats that can be read, and a
picture that shows something; it refuses what is no surface."""

import os
import runpy
import sys

from paraview.simple import (OpenDataFile, PointSource, SaveData, Sphere, SurfaceComparison,
                             SurfaceNoise)

from panels import check_panels

PYTHON = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../Examples/Python")
sys.path.insert(0, PYTHON)
sys.dont_write_bytecode = True


def demo(*arguments):
    sys.argv = ["demo.py", *arguments]
    runpy.run_path(os.path.join(PYTHON, "demo.py"), run_name="__main__")


def mean_angle(surface, truth):
    comparison = SurfaceComparison(Input=surface, Reference=truth)
    comparison.UpdatePipeline()
    comparison.UpdatePropertyInformation()
    return comparison.GetProperty("MeanNormalAngle").GetData()


truth = Sphere(ThetaResolution=40, PhiResolution=40)
noisy = SurfaceNoise(Input=truth, Size=0.2)
SaveData("noisy.ply", noisy)

demo("noisy.ply", "--output", "own", "--method", "robust", "--range-scale", "0.35")
for name in ("own/denoised.vtp", "own/denoised.ply"):
    angles = mean_angle(OpenDataFile(name), truth), mean_angle(noisy, truth)
    assert angles[0] < 0.6 * angles[1], (name, angles)

check_panels("own/denoising.png", columns=3)

SaveData("points.vtp", PointSource(NumberOfPoints=10), DataMode="Ascii")
for name in ("points.vtp", "missing.ply"):
    try:
        demo(name, "--output", "none")
        assert False, name + " was accepted"
    except SystemExit as end:
        assert name in str(end), end
