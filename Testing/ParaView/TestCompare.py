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

from paraview.simple import PointSource, SaveData, Sphere, SurfaceNoise

from panels import check_panels

PYTHON = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../Examples/Python")
sys.path.insert(0, PYTHON)
sys.dont_write_bytecode = True
import methods


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

# One clear message, and an exit code that says so.
SaveData("points.vtp", PointSource(NumberOfPoints=10), DataMode="Ascii")
for arguments in (("points.vtp",), ("missing.ply",), ("noisy.ply", "missing.ply"),
                  ("--truth", "missing.ply")):
    _, end = compare(*arguments, "-o", "none")
    assert isinstance(end, str) and arguments[-1] in end and "\n" not in end, (arguments, end)
assert not os.path.exists("none"), "nothing is written"
_, end = compare("noisy.ply", "--methods", "No such method")
assert end == 2, end
pvpython = os.readlink("/proc/self/exe")  # sys.executable names something else
bad = subprocess.run([pvpython, os.path.join(PYTHON, "compare.py"), "missing.ply"],
                     stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True,
                     check=False)
assert bad.returncode == 1, bad
assert bad.stdout.strip() == "compare: there is no file missing.ply", bad.stdout
