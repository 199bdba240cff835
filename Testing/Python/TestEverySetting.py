# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""No setting is accepted and then ignored: every one that a class of the package has, found by
looking at the class, changes its output, by itself or in one of the contexts below. Numbers keep to
the range of their setter."""

import inspect
import sys

import numpy
import surfacedenoising
from madesurfaces import surface_of
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonExecutionModel import vtkPolyDataAlgorithm

# Settings that change no output, with the reason.
EXCEPTIONS = {
    "NumberOfThreads": "results are the same on any number of threads",
    "vtkDenoiseSurface.FeatureAngle": "it changes the report alone",
    "vtkFeatureAwarePointFilter.LocalScale": "all widths of the method are local anyway",
}

# Numbers of which all are allowed, or that are checked when they are used.
NO_RANGE = {"Seed", "vtkRobustNormalFilter.RangeScale"}

# What a setting needs beside it to matter, by the setting or by class and setting. Others are tried
# with the defaults, which these are changes of.
CONTEXTS = {
    "vtkCurvatureNormalDiffusionFilter.PreventFlips": [
        {"NumberOfVertexIterations": 20, "RangeScale": 10.0}],
    "vtkGeometricFidelityNormalFilter.PreventFlips": [
        {"NumberOfVertexIterations": 20, "RangeScale": 10.0}],
    "StopAtNoise": [{"NumberOfOuterIterations": 40}],
    "vtkCurvatureNormalDiffusionFilter.StopAtNoise": [
        {"NumberOfOuterIterations": 40, "RangeScale": 10.0}],
    "vtkGeometricFidelityNormalFilter.StopAtNoise": [
        {"NumberOfOuterIterations": 40, "RangeScale": 10.0}],
    "vtkNormalVotingTensorFilter.StopAtNoise": [
        {"NumberOfOuterIterations": 40, "RangeScale": 180.0, "TensorThreshold": 0.9}],
    "vtkBilateralNormalFilter.Fidelity": [{"Scheme": 1}],
    "vtkBilateralNormalFilter.AreaEnergy": [{"Scheme": 1}],
    "EdgeRepetitions": [{"MedianType": 1}],
    "VertexRepetitions": [{"MedianType": 1}],
    "Regularization": [{"MedianType": 3}],
    "vtkRobustNormalFilter.RangeScale": [{"ScaleSource": 0}],
    "vtkRobustNormalFilter.Radius": [{"Neighborhood": 2}],
    "vtkRobustNormalFilter.RenewNeighborhood": [{"Neighborhood": 2, "NumberOfOuterIterations": 2}],
    "vtkRobustNormalFilter.CurvatureUnit": [{"Argument": 3, "ScaleSource": 0}],
    "vtkRobustNormalFilter.StepLength": [{"Operator": 1}],
    "vtkRobustNormalFilter.TangentialFlux": [{"Operator": 1}],
    "vtkRobustNormalFilter.Fidelity": [{"Operator": 2}],
    "vtkRobustNormalFilter.AreaEnergy": [{"Operator": 2}],
    "Fraction": [{"NoiseType": 2}],
    "vtkRobustPointNormalFilter.StepLength": [{"Operator": 1}],
    "vtkRobustPointNormalFilter.NumberOfPatchNeighbors": [{"Guidance": 1}],
    "vtkRobustPointNormalFilter.PatchAgreement": [{"Guidance": 1}],
    "vtkRobustPointNormalFilter.MemberAgreement": [{"Guidance": 1}],
    "SkeletonRadius": [{"UseSkeleton": 1}],
    "vtkRobustPointNormalFilter.EigenvalueCut": [{"PositionScheme": 4}],
    "vtkNormalPointUpdate.EigenvalueCut": [{"PositionScheme": 4}],
}

# The same for filters of surfaces with faces.
MESH_CONTEXTS = {
    "Relaxation": [{"VertexScheme": 4}],
    "PreventFlips": [{"NumberOfVertexIterations": 20}],
    "MaximumDisplacement": [{"NumberOfVertexIterations": 20}],
}

# The same for filters of point sets.
POINT_CONTEXTS = {
    "NumberOfNeighbors": [{"Neighborhood": 0}],
    "Radius": [{"Neighborhood": 1}],
    "MaximumNumberOfNeighbors": [{"Neighborhood": 1}],
    "RenewNeighborhood": [{"NumberOfOuterIterations": 2}],
    "NumberOfNormalNeighbors": [{"NormalSource": 3}],
    "UnorientedNormals": [{"NormalOrientation": 1}],
    "UseSkeleton": [{"SkeletonRadius": 1.0}],
    "vtkMovingLeastSquaresFilter.LocalScale": [{"Bandwidth": 2.0}],
}

# At most, for speed; presets have iterations of their own.
ITERATIONS = 3


def roof(n, noise):
    """An open surface of n x n x 2 triangles, with an edge and noise in all directions."""
    y, x = numpy.divmod(numpy.arange((n + 1) ** 2), n + 1)
    points = numpy.stack([x, y, 0.8 * abs(y - n / 2)], axis=1).astype(float)
    points += noise * numpy.random.RandomState(5).uniform(-1.0, 1.0, points.shape)
    corners = numpy.arange(n * n) // n * (n + 1) + numpy.arange(n * n) % n
    return surface_of(points, numpy.concatenate([
        corners[:, None] + (0, 1, n + 2), corners[:, None] + (0, n + 2, n + 1)]))


def octahedron(n, noise):
    """A closed surface: an octahedron of 8 n^2 triangles, with noise."""
    ids, triangles = {}, []

    def corner(signs, i, j):
        position = numpy.array([i, j, n - i - j]) * signs
        return ids.setdefault(tuple(position), len(ids))

    for signs in numpy.ndindex(2, 2, 2):
        s = 1 - 2 * numpy.array(signs)
        turn = s.prod()
        for i in range(n):
            for j in range(n - i):
                triangles.append((corner(s, i, j), corner(s, i + 1, j), corner(s, i, j + 1))[::turn])
                if i + j < n - 1:
                    triangles.append((corner(s, i + 1, j), corner(s, i + 1, j + 1),
                                      corner(s, i, j + 1))[::turn])
    points = numpy.array(list(ids), dtype=float)
    points += noise * numpy.random.RandomState(6).uniform(-1.0, 1.0, points.shape)
    return surface_of(points, triangles)


def with_signs(surface):
    """The surface with noisy normals of its points that point to either side."""
    points = vtk_to_numpy(surface.GetPoints().GetData())
    random = numpy.random.RandomState(7)
    normals = points / numpy.linalg.norm(points, axis=1)[:, None]
    normals += random.uniform(-0.3, 0.3, points.shape)
    normals *= random.choice([-1.0, 1.0], len(points))[:, None]
    array = numpy_to_vtk(normals, deep=1)
    array.SetName("Normals")
    surface.GetPointData().SetNormals(array)
    return surface


OPEN, FOLDED, CLOSED = roof(14, 0.25), roof(14, 0.9), octahedron(7, 0.2)
SIGNED = with_signs(octahedron(7, 0.2))


def concrete_filters():
    for name, cls in inspect.getmembers(surfacedenoising, inspect.isclass):
        if issubclass(cls, vtkPolyDataAlgorithm) and not name.endswith("Reader"):
            try:
                yield name, cls, cls()
            except TypeError:
                pass  # abstract


def settings(vtk_object):
    """Names X of all pairs SetX, GetX that the classes of the project add."""
    added = set(dir(vtk_object)) - set(dir(vtkPolyDataAlgorithm))
    return sorted(name[3:] for name in added
                  if name.startswith("Set") and "G" + name[1:] in added)


def get(vtk_object, name):
    return getattr(vtk_object, "Get" + name)()


def put(vtk_object, name, value):
    getattr(vtk_object, "Set" + name)(value)


def other_values(cls, name, value):
    """Values to try instead: all of an enumeration, some above and below of a number."""
    if isinstance(value, bool):
        return [not value]
    trial = cls()
    if isinstance(value, int):
        put(trial, name, 10 ** 6)  # setters clamp
        last = get(trial, name)
        return [i for i in range(last + 1) if i != value] if last < 100 else \
            [i for i in (value + 1, value * 4, max(0, value - 1), value // 4, 5) if i != value]
    return [value * 1.3 + 0.01, value * 0.6, value * 3.0, 0.1, 1.0, 20.0]


def results(algorithm):
    """All numbers that come out but those that count seconds."""
    numbers = []
    for port in range(algorithm.GetNumberOfOutputPorts()):
        output = algorithm.GetOutputDataObject(port)
        if output.IsA("vtkPolyData"):
            numbers.append(vtk_to_numpy(output.GetPoints().GetData()))
            parts = [output.GetPointData(), output.GetCellData(), output.GetFieldData()]
        else:
            parts = [output.GetRowData()]
        for part in parts:
            numbers += [vtk_to_numpy(part.GetArray(i)) for i in range(part.GetNumberOfArrays())
                        if part.GetArray(i) and part.GetArrayName(i) != "DenoisingReport"]
    return [array.astype(float).copy() for array in numbers]


def differ(a, b):
    return len(a) != len(b) or any(
        x.shape != y.shape or not numpy.allclose(x, y, rtol=0.0, atol=1e-9, equal_nan=True)
        for x, y in zip(a, b))


def run(cls, surface, changes):
    algorithm = cls()
    if cls.__name__ == "vtkNormalVertexUpdate":  # needs normals
        first = surfacedenoising.vtkMeanNormalFilter()
        first.UpdateVerticesOff()
        first.SetInputData(surface)
        first.Update()
        surface = first.GetOutput()
    algorithm.SetInputData(surface)
    if algorithm.GetNumberOfInputPorts() > 1:
        noise = surfacedenoising.vtkSurfaceNoise()
        noise.SetInputData(surface)
        noise.Update()
        algorithm.SetInputData(1, noise.GetOutput())
    for name in settings(algorithm):
        if name.startswith("NumberOf") and name.endswith("Iterations"):
            put(algorithm, name, min(ITERATIONS, get(algorithm, name)))
    for name, value in changes.items():
        put(algorithm, name, value)
    algorithm.Update()
    return results(algorithm)


def tells_pipeline(cls, name, value):
    trial = cls()
    before = get(trial, name), trial.GetMTime()
    put(trial, name, value)
    changed = get(trial, name) != before[0]
    assert (trial.GetMTime() > before[1]) == changed, (cls.__name__, name, value)


def keeps_range(cls, name, value):
    """Numbers beyond the range of a setter become its ends; there is no number without a range."""
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        return True
    trial = cls()
    low, high = (getattr(trial, "Get{}{}Value".format(name, end), None) for end in ("Min", "Max"))
    if not low:
        return False
    for beyond, end in ((low() - 1, low()), (min(high() * 2, sys.float_info.max), high())):
        if isinstance(value, int) and not -2 ** 31 <= beyond < 2 ** 31:
            continue
        put(trial, name, beyond)
        if get(trial, name) != end:
            return False
    return True


def matters(cls, name, value):
    """True if another value of the setting changes what comes out, of any surface in any context."""
    known = {**CONTEXTS, **MESH_CONTEXTS}
    surfaces = [OPEN, FOLDED, CLOSED]
    if issubclass(cls, surfacedenoising.vtkPointDenoisingFilter):
        known = {**CONTEXTS, **POINT_CONTEXTS}
        surfaces.append(SIGNED)
    contexts = known.get("{}.{}".format(cls.__name__, name), known.get(name, [{}]))
    for surface in surfaces:
        for context in contexts:
            before = run(cls, surface, {name: value, **context})
            for other in other_values(cls, name, value):
                tells_pipeline(cls, name, other)
                if differ(before, run(cls, surface, {**context, name: other})):
                    return True
    return False


problems, checked = [], 0
known = set()
for class_name, filter_class, filter_object in concrete_filters():
    assert differ(run(filter_class, OPEN, {}), []), class_name
    assert not differ(run(filter_class, OPEN, {}), run(filter_class, OPEN, {})), class_name
    names = settings(filter_object)
    known.update(names, (class_name + "." + name for name in names))
    for setting in names:
        effect = matters(filter_class, setting, get(filter_object, setting))
        expected = setting not in EXCEPTIONS and class_name + "." + setting not in EXCEPTIONS
        if not keeps_range(filter_class, setting, get(filter_object, setting)) and \
                not NO_RANGE & {setting, class_name + "." + setting}:
            problems.append("{}.{} has no range or leaves it".format(class_name, setting))
        if effect != expected:
            problems.append("{}.{} {}".format(
                class_name, setting, "matters" if effect else "makes no difference"))
        checked += 1

problems += ["there is no setting " + name
             for name in [*EXCEPTIONS, *CONTEXTS, *MESH_CONTEXTS, *POINT_CONTEXTS] if name not in known]
assert not problems, "\n" + "\n".join(problems)
assert checked > 300, checked
