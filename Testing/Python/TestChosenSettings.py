# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Settings of 0 are chosen from the data, in every class that has any, found by looking at the
classes: the chosen values can be read, lie within the range of the setter, do to the surface what
they do when somebody sets them, and remove noise. Without noise nothing is chosen and nothing
moves."""

import inspect
import math
import os
import sys

import numpy
import surfacedenoising
from madesurfaces import surface_of
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonExecutionModel import vtkPolyDataAlgorithm

# What the data choose, where a class has it.
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../Examples/Python"))
from methods import OPEN  # noqa: E402

# Ways to use a class, beside its defaults, and settings that do not count then.
VARIANTS = {
    "vtkBilateralNormalFilter": [({}, set()), ({"Scheme": 1}, {"NumberOfNormalIterations"})],
    "vtkRobustNormalFilter": [({}, {"RangeScale", "Radius"}),
                              ({"ScaleSource": 0, "Neighborhood": 2}, set()),
                              ({"Preset": 1}, OPEN)],
    "vtkRobustPointNormalFilter": [({}, set()), ({"ScaleSource": 1}, {"RangeScale"}),
                                   ({"Preset": 1}, OPEN - {"NumberOfNormalNeighbors"})],
    # Normals are given: points go on until they stand still.
    "vtkNormalVertexUpdate": [({}, OPEN)],
}


def roof(n, noise):
    """Two planes that meet at a right angle, n x 2n squares each, with noise across them, as points
    and as distances of these from the planes."""
    y, x = numpy.divmod(numpy.arange((n + 1) ** 2), n + 1)
    points = numpy.stack([x, y, -abs(y - n / 2)], axis=1).astype(float)
    points[:, 2] += noise * numpy.random.RandomState(5).normal(0.0, 1.0, len(points))
    corners = numpy.arange(n * n) // n * (n + 1) + numpy.arange(n * n) % n
    return surface_of(points, numpy.concatenate([
        corners[:, None] + (0, 1, n + 2), corners[:, None] + (0, n + 2, n + 1)]))


def error(surface, n):
    """Mean distance from the planes, away from the border."""
    points = vtk_to_numpy(surface.GetPoints().GetData())
    y, x = numpy.divmod(numpy.arange((n + 1) ** 2), n + 1)
    inner = (numpy.minimum(x, n - x) > 2) & (numpy.minimum(y, n - y) > 2)
    x, y, z = points[inner].T
    return numpy.minimum(abs(z + y - n / 2), abs(z - y + n / 2)).mean() / math.sqrt(2)


def concrete_filters():
    for name, cls in inspect.getmembers(surfacedenoising, inspect.isclass):
        if issubclass(cls, vtkPolyDataAlgorithm) and hasattr(cls, "GetChosenValue"):
            try:
                yield name, cls, cls()
            except TypeError:
                pass  # abstract


class Listener:
    """Hears warnings; errors are for the caller to see."""

    def __init__(self, algorithm):
        self.warnings = 0
        algorithm.AddObserver("WarningEvent", self.hear)

    def hear(self, *_):
        self.warnings += 1


def run(cls, surface, values):
    algorithm = cls()
    listener = Listener(algorithm)
    for name, value in values.items():
        getattr(algorithm, "Set" + name)(value)
    algorithm.SetInputData(surface)
    algorithm.Update()
    return algorithm, listener


def with_normals(surface):
    filtered = surfacedenoising.vtkMeanNormalFilter()
    filtered.UpdateVerticesOff()
    filtered.SetInputData(surface)
    filtered.Update()
    return filtered.GetOutput()


def positions(algorithm):
    return vtk_to_numpy(algorithm.GetOutput().GetPoints().GetData()).astype(float)


N = 18
NOISY, CLEAN = with_normals(roof(N, 0.2)), with_normals(roof(N, 0.0))
BEFORE = error(NOISY, N)
checked = 0
for class_name, cls, example in concrete_filters():
    names = sorted(name for name in OPEN if hasattr(cls, "Set" + name))
    assert names, class_name
    for variant, closed in VARIANTS.get(class_name, [({}, set())]):
        print(class_name, variant)
        if example.IsA("vtkPointNeighborhoodFilter"):
            ball = variant.get("Neighborhood", example.GetNeighborhood()) == 1
            closed = closed | {"NumberOfNeighbors" if ball else "Radius"}
        algorithm, listener = run(cls, NOISY, {**variant, **{name: 0 for name in names}})
        chosen = {name: algorithm.GetChosenValue(name) for name in names}
        report = algorithm.GetOutput().GetFieldData().GetArray("DenoisingReport")
        figures = {report.GetComponentName(i): report.GetValue(i)
                   for i in range(report.GetNumberOfComponents())}
        for name in names:
            expected = name not in closed
            assert math.isfinite(chosen[name]) == expected, (class_name, variant, name, chosen)
            assert ("Chosen " + name in figures) == expected, (class_name, name, figures)
            if expected:
                assert chosen[name] > 0.0 and figures["Chosen " + name] == chosen[name], name
                checked += 1
        given = {name: int(value) if name.startswith("NumberOf") else value
                 for name, value in chosen.items() if math.isfinite(value)}
        again, _ = run(cls, NOISY, {**variant, **given})
        for name, value in given.items():
            assert abs(getattr(again, "Get" + name)() - value) <= 1e-12 * value, (class_name, name)
            assert math.isnan(again.GetChosenValue(name)), (class_name, name)
        if given:
            difference = abs(positions(algorithm) - positions(again)).max()
            assert difference < 1e-9, (class_name, variant, difference, given)
            assert not listener.warnings, class_name
            after = error(algorithm.GetOutput(), N)
            print("  error", BEFORE, "->", after, given)
            assert after < 0.9 * BEFORE, (class_name, after, BEFORE)
            quiet, listener = run(cls, CLEAN, {**variant, **{name: 0 for name in names}})
            assert listener.warnings == 1, (class_name, listener.warnings)
            moved = abs(positions(quiet) - vtk_to_numpy(CLEAN.GetPoints().GetData())).max()
            assert moved == 0.0, (class_name, moved)

# The vertex update goes on until a step is a hundredth of the first one.
def after_steps(count):
    algorithm, _ = run(surfacedenoising.vtkNormalVertexUpdate, NOISY,
                       {"NumberOfVertexIterations": count})
    return algorithm


def step(count):
    difference = positions(after_steps(count)) - positions(after_steps(count - 1 or -1))
    return math.sqrt((difference ** 2).mean())


still = after_steps(0)
report = still.GetOutput().GetFieldData().GetArray("DenoisingReport")
steps = int(report.GetValue([report.GetComponentName(i) for i in range(
    report.GetNumberOfComponents())].index("Vertex Iterations")))
assert 3 < steps < 200, steps
assert abs(positions(still) - positions(after_steps(steps))).max() == 0.0
assert step(steps) <= 0.01 * step(1) < step(steps - 1), (step(1), step(steps - 1), step(steps))

assert checked > 60, checked
