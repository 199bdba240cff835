# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The comparison runs all methods that are asked for, with and without the truth; one that fails
does not stop the others, but is told of; and what is no surface is refused."""

import csv
import io
import os
import runpy
import subprocess
import sys
from contextlib import redirect_stderr, redirect_stdout

import numpy
from paraview.simple import OpenDataFile, PointSource, SaveData, Sphere, SurfaceNoise

from panels import check_panels

PYTHON = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../Examples/Python")
sys.path.insert(0, PYTHON)
sys.dont_write_bytecode = True
import methods
from surfaces import positions


def compare(*arguments):
    """What the script prints, and the reason that it gives for its end."""
    sys.argv = ["compare.py", *arguments]
    printed, end = io.StringIO(), None
    with redirect_stdout(printed), redirect_stderr(io.StringIO()):
        try:
            runpy.run_path(os.path.join(PYTHON, "compare.py"), run_name="__main__")
        except SystemExit as error:
            end = error.code
    return printed.getvalue(), end


def rows_of(name):
    with open(name, newline="", encoding="utf-8") as file:
        return {row["method"]: row for row in csv.DictReader(file)}


def table_lines(text):
    return [line for line in text.splitlines() if line.startswith("| ")]


truth = Sphere(ThetaResolution=40, PhiResolution=40)
SaveData("truth.ply", truth)
SaveData("noisy.ply", SurfaceNoise(Input=truth, Size=0.2))

# With the truth: a method by its caption, a peer by its class.
text, end = compare("noisy.ply", "truth.ply", "-o", "known", "--methods", "bilateral normal",
                    "vtkWindowedSincPolyDataFilter")
assert end is None, end
rows = rows_of("known/comparison.csv")
assert list(rows) == ["Noisy", "Bilateral normal", "Windowed sinc (VTK)"], list(rows)
for name in list(rows)[1:]:
    assert float(rows[name]["seconds"]) > 0.0 and not rows[name]["failure"], rows[name]
    for quantity in ("MeanNormalAngle", "RelativePositionError", "SmoothNormalAngle"):
        before, after = float(rows["Noisy"][quantity]), float(rows[name][quantity])
        assert after < 0.6 * before, (name, quantity, before, after)
    assert abs(float(rows[name]["RelativeVolumeChange"])) < 0.02, rows[name]
    assert rows[name]["FeatureNormalAngle"] == "nan", "a sphere has no features"
assert [row["peer"] for row in rows.values()] == ["0", "0", "1"], rows
lines = table_lines(text)
assert len(lines) == 5 and len({line.count("|") for line in lines}) == 1, text
with open("known/comparison.md", encoding="utf-8") as file:
    assert table_lines(file.read()) == lines, "the file has the table that is printed"
assert "{:.2f}".format(float(rows["Bilateral normal"]["MeanNormalAngle"])) in lines[3], lines
check_panels("known/comparison.png", columns=2, rows=2)

# Without it, and with methods that fail in several ways.
methods.METHODS += [
    methods.Method("NoSuchFilter", "Missing", "", {"default": {}}),
    methods.Method("BilateralNormalFilter", "Misspelt", "", {"default": {"RangeScales": 1.0}}),
    methods.Method("BilateralNormalFilter", "Tuned", "",
                   {"default": {"NumberOfNormalIterations": 1},
                    "cad": {"RangeScale": 0.2}})]
text, end = compare("noisy.ply", "-o", "own", "--parameters", "cad", "--methods", "Thresholded cosine",
                    "Missing", "Misspelt", "Tuned")
assert end == "compare: failed: Missing, Misspelt", end
rows = rows_of("own/comparison.csv")
assert list(rows) == ["Thresholded cosine", "Missing", "Misspelt", "Tuned"], list(rows)
for name in ("Thresholded cosine", "Tuned"):
    assert 0.01 < float(rows[name]["MeanDisplacement"]) < 0.5, rows[name]
    assert not rows[name]["failure"], rows[name]
for name in ("Missing", "Misspelt"):
    assert rows[name]["failure"] and rows[name]["MeanDisplacement"] == "", rows[name]
    assert any("failed: " in line for line in table_lines(text) if name in line), text
assert rows["Tuned"]["settings"] == "NumberOfNormalIterations=1; RangeScale=0.2", rows["Tuned"]
check_panels("own/comparison.png", columns=3)

# A clean model gets noise; more panels than fill the grid.
text, end = compare("--truth", "truth.ply", "--noise", "0.1", "-o", "made", "--methods",
                    "Bilateral normal", "Misspelt", "Tuned", "Thresholded cosine")
assert end == "compare: failed: Misspelt", end
check_panels("made/comparison.png", columns=3, rows=2, count=5)

# Points: of a mesh, with and without the truth, and in a text; all methods by default.
numpy.savetxt("noisy.xyz", positions(OpenDataFile("noisy.ply")))
runs = (("known", ("noisy.ply", "truth.ply", "--points")),
        ("made", ("--truth", "truth.ply", "--noise", "0.2", "--methods", "Rolling point normal")),
        ("own", ("noisy.xyz", "--parameters", "organic", "--methods", "Moving robust PCA",
                 "robust point normal", "DenoiseSurface")))
for folder, arguments in runs:
    text, end = compare(*arguments, "-o", "points_" + folder)
    assert end is None, end
    rows = rows_of("points_" + folder + "/comparison.csv")
    assert len(table_lines(text)) == len(rows) + 2, text
    for name in rows:
        assert not rows[name]["failure"], rows[name]
        if folder == "own":
            assert 0.01 < float(rows[name]["MeanDisplacement"]) < 0.5, rows[name]
        elif name != "Noisy":
            before, after = (float(rows[row]["RelativeMeanDistance"]) for row in ("Noisy", name))
            assert after < 0.7 * before, (name, before, after)
            assert float(rows[name]["MeanPointNormalAngle"]) < 20.0, rows[name]
    every = len(rows) - (folder != "own")
    assert every == {"known": len(methods.POINT_METHODS), "made": 1, "own": 3}[folder], list(rows)
check_panels("points_known/comparison.png", columns=4, rows=4, count=len(methods.POINT_METHODS) + 2)
check_panels("points_own/comparison.png", columns=2, rows=2)

# One clear message, and an exit code that says so.
SaveData("points.vtp", PointSource(NumberOfPoints=10), DataMode="Ascii")
for arguments in (("missing.ply",), ("noisy.ply", "missing.ply"), ("--truth", "missing.ply"),
                  ("--methods", "Bilateral normal", "--noise", "0.1", "--truth", "points.vtp"),
                  ("noisy.ply", "points.vtp")):
    _, end = compare(*arguments, "-o", "none")
    assert isinstance(end, str) and arguments[-1] in end and "\n" not in end, (arguments, end)
assert not os.path.exists("none"), "nothing is written"
_, end = compare("noisy.ply", "--methods", "No such method")
assert end == 2, end
_, end = compare("noisy.ply", "--methods", "Bilateral normal", "Bilateral point", "-o", "none")
assert end == "compare: methods for surfaces and methods for points do not go into one table", end
pvpython = os.readlink("/proc/self/exe")  # sys.executable names something else
bad = subprocess.run([pvpython, os.path.join(PYTHON, "compare.py"), "missing.ply"],
                     stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True,
                     check=False)
assert bad.returncode == 1, bad
assert bad.stdout.strip() == "compare: there is no file missing.ply", bad.stdout
