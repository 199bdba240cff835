# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The survey's Table 1: the error norms, as the filter has them. No formula of a norm is written
here. The weight g is measured: two faces share an edge, the filter diffuses their normals once, and
how far a normal turns tells the weight of the other. Then psi(x) = x g(x), and rho is its
integral."""

import numpy
from paraview.servermanager import Fetch
from paraview.simple import RobustNormalFilter
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

from charts import COLORS, Chart, Curve, save_charts
from surfaces import as_source

SCALE = 0.5
L1_SCALE = 0.05  # where 1 / x is held
STEP = 0.04  # no weight times this is above 1
MEASURED = {"Operator": "Diffusion", "StepLength": STEP, "IncludeOwn": 0,
            "Neighborhood": "Edge Adjacent", "FaceWeighting": "Uniform", "SpatialScale": -1.0,
            "ScaleSource": "Given", "NumberOfNormalIterations": 1, "UpdateVertices": 0,
            "PreventFlips": 0}


def pairs_of_faces(angles):
    """A surface of pairs of triangles; their normals, the first of which is the z axis, are at
    these angles."""
    points, triangles = vtkPoints(), vtkCellArray()
    points.SetDataTypeToDouble()
    for i, angle in enumerate(angles):
        x = 4.0 * i
        corners = [points.InsertNextPoint(*corner) for corner in (
            (x, 0.0, 0.0), (x, 1.0, 0.0), (x - 1.0, 0.5, 0.0),
            (x + numpy.cos(angle), 0.5, -numpy.sin(angle)))]
        for triangle in ((0, 1, 2), (1, 0, 3)):
            triangles.InsertNextCell(3, [corners[corner] for corner in triangle])
    surface = vtkPolyData()
    surface.SetPoints(points)
    surface.SetPolys(triangles)
    return as_source(surface)


def measured_weights(norm, scale, x):
    """The weights that the filter gives to normals whose chords are x."""
    angles = 2.0 * numpy.arcsin(0.5 * x)
    turned = RobustNormalFilter(Input=pairs_of_faces(angles), Norm=norm, RangeScale=scale,
                                **MEASURED)
    normals = vtk_to_numpy(Fetch(turned).GetCellData().GetArray("FilteredNormals"))[::2]
    turns = numpy.arctan2(numpy.hypot(normals[:, 0], normals[:, 1]), normals[:, 2])
    # The new normal is (1 - w) n + w m, with m at its angle from n, and w the step times g.
    return numpy.sin(turns) / (numpy.sin(turns) + numpy.sin(angles - turns)) / STEP


def norm_names():
    return list(RobustNormalFilter(Input=pairs_of_faces([1.0])).GetProperty("Norm").Available)


def chart_of(norm):
    scale = L1_SCALE if norm == "L1" else SCALE
    x = numpy.linspace(0.005, 1.5, 300)
    g = measured_weights(norm, scale, x)
    psi = x * g
    steps = numpy.diff(x, prepend=0.0)
    rho = numpy.cumsum(0.5 * steps * (psi + numpy.concatenate(([0.0], psi[:-1]))))
    return Chart(norm if scale == SCALE else "{}, scale {:g}".format(norm, scale),
                 [Curve("rho", x, rho, COLORS[0]), Curve("psi", x, psi, COLORS[1], True),
                  Curve("g", x, g, COLORS[2])],
                 x_range=(0.0, 1.5), y_range=(0.0, 1.6),
                 legend="top right" if norm == "Truncated L2" else None)


def draw(picture):
    save_charts(picture, [chart_of(norm) for norm in norm_names()], columns=5,
                chart_size=(240, 230))
