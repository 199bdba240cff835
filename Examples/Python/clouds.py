# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Point clouds: what they are judged by, and what pictures show of them."""

import math

import numpy
from paraview.servermanager import Fetch
from paraview.simple import Calculator, ConvertToPointCloud, Glyph, RobustPointNormalFilter
from vtkmodules.vtkCommonCore import vtkFloatArray, vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkStaticPointLocator
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

from sidebyside import Panel
from surfaces import as_source, compare, displacements, positions, report
from tables import number

# As those of meshes.
WITH_TRUTH = [("mean distance", "RelativeMeanDistance", 1000.0, "{:.3f}"),
              ("RMS", "RelativeRMSDistance", 1000.0, "{:.3f}"),
              ("largest", "RelativeMaximumDistance", 1000.0, "{:.2f}"),
              ("near features", "RelativeFeatureDistance", 1000.0, "{:.3f}"),
              ("elsewhere", "RelativeSmoothDistance", 1000.0, "{:.3f}"),
              ("normal angle (\u00b0)", "MeanPointNormalAngle", 1.0, "{:.2f}")]
WITHOUT_TRUTH = [("mean displacement (spacings)", "MeanDisplacement", 1.0, "{:.3f}"),
                 ("largest", "MaximumDisplacement", 1.0, "{:.2f}"),
                 ("points left alone", "KeptPoints", 1.0, "{:.0f}")]

TRUTH_NOTE = ("Distances are those of the points from the truth, in thousandths of its diagonal; "
              "near features is within {rings} rings of faces around edges of more than "
              "{angle:g}\u00b0. Normal angles are means over the angles between the normals of the "
              "points and the true ones, signs aside.")
NO_TRUTH_NOTE = "There is no truth: displacements are against the input."

MOST_DISCS = 100000  # more are not seen
KEPT = 1  # the status of points that are left as they were


def bare_points(surface):
    """The points of a surface, of which nothing else is known."""
    points = vtkPolyData()
    points.SetPoints(Fetch(surface).GetPoints())
    return points_of(as_source(points))


def points_of(surface):
    """The points of a surface with their arrays; the polygons are gone."""
    return ConvertToPointCloud(Input=surface, CellGenerationMode="Vertex cells")


def measure(cloud, noisy, truth, **settings):
    """The quantities that a result is judged by."""
    if truth:
        return compare_points(cloud, truth, **settings)[1]
    lengths = displacements(cloud, noisy) / (mean_spacing(noisy) or math.nan)
    status = vtk_to_numpy(Fetch(cloud).GetPointData().GetArray("Status"))
    return {"MeanDisplacement": numpy.nanmean(lengths),
            "MaximumDisplacement": numpy.nanmax(lengths),
            "KeptPoints": float(numpy.count_nonzero(status == KEPT))}


def upright(cloud):
    """The cloud with its normals or, if it has none, with those of fits; nothing moves."""
    return RobustPointNormalFilter(Input=cloud, NumberOfOuterIterations=-1,
                                   NormalOrientation="Keep")


def mean_spacing(cloud):
    """Which not every filter reports."""
    return report(upright(cloud), "MeanSpacing")


def compare_points(cloud, truth, **settings):
    comparison, found = compare(cloud, truth, **settings)
    for name in ("FeatureDistance", "SmoothDistance"):
        found["Relative" + name] = found[name] / (found["ReferenceDiagonal"] or math.nan)
    return comparison, found


def short_error(quantities):
    return "{:.2f}".format(1000.0 * quantities["RelativeMeanDistance"])


def shown(cloud):
    """What a picture shows: discs at the points, across their normals, which are those of the cloud
    or, if it has none, of fits. They are so large that neighbours overlap."""
    cloud = upright(cloud)
    points = positions(cloud)
    finite = numpy.flatnonzero(numpy.isfinite(points).all(axis=1))
    stride = math.ceil(len(finite) / MOST_DISCS)
    picked = finite[::stride]
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    data.GetPoints().SetData(numpy_to_vtk(points[picked], deep=1))
    arrays = Fetch(cloud).GetPointData()
    for name in ("Normals", "Shown"):
        if arrays.HasArray(name):
            add_array(data, name, vtk_to_numpy(arrays.GetArray(name))[picked])
    # An outlier is no larger than others.
    sizes = numpy.minimum(distances_to_neighbor(data, 6), 2.0 * report(cloud, "MeanSpacing")
                          * math.sqrt(stride))
    add_array(data, "Size", sizes)
    discs = Glyph(Input=points_of(as_source(data)), GlyphType="2D Glyph", GlyphMode="All Points",
                  OrientationArray=["POINTS", "Normals"], ScaleArray=["POINTS", "Size"],
                  ScaleFactor=1.4)
    discs.GlyphType.GlyphType = "Circle"
    discs.GlyphType.Filled = 1
    discs.GlyphTransform.Rotate = [0.0, 90.0, 0.0]  # the normal of the disc becomes its x axis
    return discs


def add_array(data, name, values):
    array = numpy_to_vtk(values, deep=1)
    array.SetName(name)
    data.GetPointData().AddArray(array)


def distances_to_neighbor(data, which):
    """Of every point the distance of its nearest one, if which is 1, or of a farther one."""
    locator = vtkStaticPointLocator()
    locator.SetDataSet(data)
    locator.BuildLocator()
    points = vtk_to_numpy(data.GetPoints().GetData())
    near = vtkIdList()
    distances = numpy.zeros(len(points))
    for i, point in enumerate(points):
        locator.FindClosestNPoints(which + 1, point, near)  # the point itself is the first
        distances[i] = numpy.linalg.norm(points[near.GetId(near.GetNumberOfIds() - 1)] - point)
    return distances


def demo_known(truth, noisy, denoised):
    """See meshes."""
    comparisons = [compare_points(cloud, truth, FeatureAngle=30.0) for cloud in (noisy, denoised)]
    rows = [[number(factor * found[quantity], form) for _, quantity, factor, form in WITH_TRUTH]
            for _, found in comparisons]
    before, after = (short_error(found) for _, found in comparisons)
    comparison, found = comparisons[1]
    left = scaled(comparison, "Distance", 1000.0 / found["ReferenceDiagonal"])
    return [Panel(shown(bare_points(truth)), "Original"),
            Panel(shown(noisy), "With noise: {} thousandths off".format(before)),
            Panel(shown(denoised), "Denoised: {} thousandths off".format(after)),
            Panel(shown(left), "What is left", ("POINTS", "Shown"), rounded(2.0 * float(before)),
                  "Error in thousandths")], \
        [title.replace("\u00b0", "degrees") for title, *_ in WITH_TRUTH], rows


def demo_unknown(noisy, denoised):
    """See meshes."""
    found = measure(denoised, noisy, None)
    moved = scaled(denoised, "Displacement", 1.0 / (mean_spacing(noisy) or math.nan))
    return [Panel(shown(noisy), "Input"),
            Panel(shown(denoised), "Denoised"),
            Panel(shown(moved), "How far points moved", ("POINTS", "Shown"),
                  max(found["MaximumDisplacement"], 1e-9), "Spacings")], \
        [title for title, *_ in WITHOUT_TRUTH], \
        [[number(factor * found[quantity], form) for _, quantity, factor, form in WITHOUT_TRUTH]]


def rounded(number):
    """The number with one digit, for the legend."""
    return float("{:.0e}".format(number))


def scaled(cloud, array, factor):
    """The cloud with its array in another unit, called Shown."""
    return Calculator(Input=cloud, AttributeType="Point Data", ResultArrayName="Shown",
                      Function="{!r} * {}".format(factor, array))


def single(cloud):
    """The cloud with normals in single precision, without which PLY files have none."""
    data = vtkPolyData()
    data.ShallowCopy(Fetch(cloud))
    normals = vtkFloatArray()
    normals.DeepCopy(data.GetPointData().GetNormals())
    data.GetPointData().SetNormals(normals)
    return as_source(data)


def write_text(file, cloud):
    """A line with coordinates and normal per point, which XYZ Points Reader reads."""
    normals = vtk_to_numpy(Fetch(cloud).GetPointData().GetNormals())
    numpy.savetxt(file, numpy.hstack([positions(cloud), normals]), "%.9g",
                  header="x y z nx ny nz")
