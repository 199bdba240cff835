# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The survey is repeated on small models: all pictures and tables are there, the measured norms are
those of their definitions, and what fails is told."""

import csv
import io
import os
import runpy
import sys
from contextlib import redirect_stderr, redirect_stdout

import numpy
from paraview.simple import Box, Clean, SaveData, Sphere, Subdivide, SurfaceNoise, Triangulate

from panels import check_panels

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../..")
SURVEY = os.path.join(ROOT, "Examples/Survey")
sys.path[:0] = [SURVEY, os.path.join(ROOT, "Examples/Python")]
sys.dont_write_bytecode = True
import methods
import norms
import overview
import shrinkage
import statements


def survey(*arguments):
    """What the script prints, and the reason that it gives for its end."""
    sys.argv = ["survey.py", *arguments]
    printed, end = io.StringIO(), None
    with redirect_stdout(printed), redirect_stderr(io.StringIO()):
        try:
            runpy.run_path(os.path.join(SURVEY, "survey.py"), run_name="__main__")
        except SystemExit as error:
            end = error.code
    return printed.getvalue(), end


# Of every method that has a statement there is one, and no statement is without a method.
captions = {method.caption for method in methods.METHODS + methods.POINT_METHODS}
every = {**statements.MESH_STATEMENTS, **statements.POINT_STATEMENTS}
assert set(every) <= captions, set(every) - captions
assert len(overview.MESHES.methods) == len(statements.MESH_STATEMENTS) + 1
assert len(overview.CLOUDS.methods) == len(statements.POINT_STATEMENTS) + 1

# The weights that are measured.
x = numpy.array([0.03, 0.2, 0.45, 0.7, 1.3])
for name, expected in (("L2", numpy.ones(5)), ("Truncated L2", x < 0.5),
                       ("Huber", numpy.minimum(1.0, 0.5 / x)),
                       ("Tukey", numpy.maximum(1.0 - (x / 0.5) ** 2, 0.0) ** 2),
                       ("Gaussian", numpy.exp(-2.0 * x * x))):
    found = norms.measured_weights(name, 0.5, x)
    assert numpy.allclose(found, expected, atol=1e-6), (name, found, expected)
assert len(norms.norm_names()) == 10, norms.norm_names()

# A cube has edges, a sphere has none; of one the noisy surface is given. Some methods are enough,
# one of which fails.
CHOSEN = ("Normal diffusion", "Mean normal", "Tukey bilateral", "Moving robust PCA")
for kind in (overview.MESHES, overview.CLOUDS):
    kind.methods[:] = [method for method in kind.methods
                       if method.caption in CHOSEN or method.proxy == "DenoiseSurface"]
overview.MESHES.methods[0] = overview.MESHES.methods[0]._replace(proxy="NoSuchFilter")
shrinkage.ITERATIONS = (20,)
cube = Subdivide(Input=Triangulate(Input=Clean(Input=Box())), NumberofSubdivisions=3)
SaveData("cube.ply", cube)
SaveData("noisy.ply", SurfaceNoise(Input=cube, Size=0.2))
SaveData("sphere.ply", Sphere(ThetaResolution=24, PhiResolution=24))
text, end = survey("--fandisk", "noisy.ply", "cube.ply", "--nicola", "sphere.ply", "-o", "survey")
assert end == "survey: failed: Normal diffusion", end
for name in ("fandisk", "nicola"):  # truth, noisy, and three that did not fail
    check_panels("survey/{}.png".format(name), columns=3, rows=2, count=5)
check_panels("survey/shrinkage.png", columns=3, rows=3, count=8)
for name in ("shrinkage-curves", "norms"):
    assert os.path.getsize("survey/{}.png".format(name)) > 5000, name
with open("survey/survey.md", encoding="utf-8") as file:
    page = file.read()
table = {line.split("|")[1].strip(): line for line in page.splitlines() if line.startswith("| ")}
assert set(CHOSEN) <= set(table), page
assert ["failed" in table[name] for name in CHOSEN] == [True, False, False, False], page
assert all(line in text for line in table.values()), text
assert "noisy.ply with the truth cube.ply" in page, page
with open("survey/survey.csv", newline="", encoding="utf-8") as file:
    rows = list(csv.DictReader(file))
changes = {row["method"]: abs(float(row["RelativeVolumeChange"])) for row in rows
           if row["part"] == "shrinkage" and row["iterations"] == "20"}
assert len(changes) == 6, changes
assert changes["Mean curvature flow"] > 0.1 > 5.0 * changes["Bilateral normal"], changes
kept = {row["method"]: float(row["KeptEdges"]) for row in rows
        if row["part"] == "meshes" and row["model"] == "fandisk" and row["KeptEdges"]}
assert kept["Tukey bilateral"] > 0.9 > 0.5 > kept["Mean normal"], kept

_, end = survey("--fandisk", "missing.ply", "--nicola", "sphere.ply", "-o", "none")
assert isinstance(end, str) and "missing.ply" in end and not os.path.exists("none"), end
