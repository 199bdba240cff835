# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Every filter runs from paraview.simple, on a sphere and on an OFF file, and does its work."""

from paraview import servermanager, simple
from paraview.simple import (AnisotropicMeanCurvatureFilter, BilateralNormalFilter,
                             MaskPoints, MeanCurvatureFlowFilter, NormalPointUpdate,
                             NormalVertexUpdate, OpenDataFile, PointSource, RobustNormalFilter,
                             RobustPointNormalFilter, Sphere, SurfaceComparison, SurfaceNoise)
from paraview.servermanager import Fetch
from surfacedenoising import vtkDenoisingMethods as methods
from surfacedenoising import vtkPointDenoisingMethods as point_methods

# What is in the menu beside the filters of the tables of methods.
OTHERS = {"DenoiseSurface", "NormalPointUpdate", "NormalVertexUpdate", "RobustPointNormalFilter",
          "SurfaceComparison", "SurfaceNoise"}


def write_cube(name, n):
    """A cube of n x n x 2 triangles per side whose sides share their points."""
    ids, triangles = {}, []

    def point(*position):
        return ids.setdefault(position, len(ids))

    for axis in range(3):
        for side in (0, n):
            for i in range(n):
                for j in range(n):
                    corners = []
                    for a, b in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)):
                        position = [0, 0, 0]
                        position[axis], position[axis - 2], position[axis - 1] = side, a, b
                        corners.append(point(*position))
                    if side == 0:
                        corners.reverse()
                    triangles += [(corners[0], corners[1], corners[2]),
                                  (corners[0], corners[2], corners[3])]
    with open(name, "w") as file:
        file.write("OFF\n{} {} 0\n".format(len(ids), len(triangles)))
        file.writelines("{} {} {}\n".format(*position) for position in ids)
        file.writelines("3 {} {} {}\n".format(*triangle) for triangle in triangles)


def information(proxy, name):
    proxy.UpdatePipeline()
    proxy.UpdatePropertyInformation()
    return proxy.GetProperty(name).GetData()


def mean_angle(surface, truth):
    return information(SurfaceComparison(Input=surface, Reference=truth), "MeanNormalAngle")


def menu():
    """The names of the filters in the menu of the plugin."""
    manager = servermanager.ProxyManager().SMProxyManager
    iterator = manager.GetProxyDefinitionManager().NewSingleGroupIterator("filters")
    iterator.InitTraversal()
    while not iterator.IsDoneWithTraversal():
        hints = iterator.GetProxyHints()
        shown = hints and hints.FindNestedElementByName("ShowInMenu")
        if shown and shown.GetAttribute("category") == "Surface Denoising":
            yield iterator.GetProxyName()
        iterator.GoToNextItem()


def names_of_filters(table):
    return {table.GetFilter(i) for i in range(table.GetNumberOfMethods())}


def check_menu():
    everything = names_of_filters(methods) | names_of_filters(point_methods) | OTHERS
    assert everything == set(menu()), everything.symmetric_difference(set(menu()))


def check_all_methods(noisy, truth, before):
    """Each makes the surface better, with its defaults and as a preset."""
    filters = names_of_filters(methods)
    results = [getattr(simple, name)(Input=noisy) for name in sorted(filters)]
    results += [RobustNormalFilter(Input=noisy, Preset=methods.GetName(i))
                for i in range(methods.GetNumberOfMethods()) if methods.IsComposed(i)]
    for result in results:
        after = mean_angle(result, truth)
        assert after < 0.7 * before, (result.GetXMLName(), before, after)


def check_quantities(comparison, table):
    """Every column of the table is a property as well."""
    columns = {table.GetColumnName(i): table.GetColumn(i).GetValue(0)
               for i in range(table.GetNumberOfColumns())}
    assert "MeanDistance" in columns and "ChamferDistance" in columns, columns
    for name, value in columns.items():
        found = information(comparison, name)
        assert found == value or (found != found and value != value), (name, found, value)


def check_cloud(truth):
    """A point cloud is judged, and is a reference."""
    cloud = PointSource(NumberOfPoints=50, Radius=1.0)
    for reference in (truth, cloud):
        comparison = SurfaceComparison(Input=cloud, Reference=reference)
        assert (information(comparison, "MeanDistance") == 0.0) == (reference is cloud)
        assert information(comparison, "SpacingVariation") > 0.0


def check_point_methods(truth):
    """Each brings a cloud closer to the truth, with its defaults and as a preset."""
    noisy = SurfaceNoise(Input=truth, NoiseType="Gaussian", Direction="Random", Size=0.3)
    cloud = MaskPoints(Input=noisy, OnRatio=1, MaximumNumberofPoints=10 ** 6, GenerateVertices=1,
                       SingleVertexPerCell=1)

    def distance(data):
        return information(SurfaceComparison(Input=data, Reference=truth), "MeanDistance")

    before = distance(cloud)
    assert before > 0.0 and len(Fetch(cloud).GetPointData().GetArray(0).GetName()) > 0
    results = [getattr(simple, name)(Input=cloud)
               for name in sorted(names_of_filters(point_methods))]
    results += [RobustPointNormalFilter(Input=cloud),
                RobustPointNormalFilter(Input=cloud, Operator="Plane Normal")]
    results += [RobustPointNormalFilter(Input=cloud, Preset=point_methods.GetName(i))
                for i in range(point_methods.GetNumberOfMethods()) if point_methods.IsComposed(i)]
    for result in results:
        after = distance(result)
        assert after < 0.8 * before, (result.GetXMLName(), before, after)
        assert information(result, "MeanSpacing") > 0.0
        for name in ("Normals", "Displacement", "Status"):
            assert name in result.PointData.keys(), (result.GetXMLName(), name)
        assert "DenoisingReport" in result.FieldData.keys(), result.GetXMLName()

    # Normals of one filter, and the update alone.
    normals = RobustPointNormalFilter(Input=cloud, NumberOfPointIterations=-1)
    both = NormalPointUpdate(Input=normals)
    assert both.NormalSource == "Input" and list(both.StartNormals) == ["POINTS", "None"], (
        both.NormalSource, both.StartNormals)
    whole = RobustPointNormalFilter(Input=cloud)
    difference = information(SurfaceComparison(Input=both, Reference=whole), "MeanDistance")
    assert difference < 1e-6, difference
    named = NormalPointUpdate(Input=normals, StartNormals=["POINTS", "Normals"])
    assert distance(named) == distance(both)


def check(truth):
    noisy = SurfaceNoise(Input=truth, NoiseType="Gaussian", Direction="Vertex Normals", Size=0.2)
    assert information(noisy, "UnitLength") > 0.0
    before = mean_angle(noisy, truth)
    assert before > 5.0, before

    bilateral = BilateralNormalFilter(Input=noisy, NumberOfNormalIterations=10)
    assert information(bilateral, "UsedRangeScale") == 0.35
    assert information(bilateral, "MeanEdgeLength") > 0.0
    robust = RobustNormalFilter(Input=noisy, Norm="Tukey", Argument="Angle", ScaleSource="Given",
                                RangeScale=60.0, Neighborhood="Radius", Radius=2.5)
    assert abs(information(robust, "UsedRangeScale") - 60.0) < 1e-9
    for result in (bilateral, robust):
        after = mean_angle(result, truth)
        assert after < 0.6 * before, (result.GetXMLName(), before, after)

    check_all_methods(noisy, truth, before)
    for result in (AnisotropicMeanCurvatureFilter(Input=noisy, PrescribeCurvature=1),
                   MeanCurvatureFlowFilter(Input=noisy, TimeStep=0.05, RestoreVolume=1)):
        after = mean_angle(result, truth)
        assert after < 0.9 * before, (result.GetXMLName(), before, after)

    # The two stages as two steps, without an update in between, are one filter.
    normals = BilateralNormalFilter(Input=noisy, NumberOfNormalIterations=10, UpdateVertices=0)
    both = NormalVertexUpdate(Input=normals)
    assert list(both.Normals) == ["CELLS", "FilteredNormals"], both.Normals
    both.UpdatePipeline()
    difference = mean_angle(both, bilateral)
    assert difference < 1e-6, difference
    assert mean_angle(normals, noisy) == 0.0

    # Start normals from another array; by default not even FilteredNormals is taken.
    again = RobustNormalFilter(Input=normals, NumberOfNormalIterations=-1)
    assert again.StartNormals[1] == "None", again.StartNormals
    again.StartNormals = ["CELLS", "FilteredNormals"]
    difference = mean_angle(again, bilateral)
    assert difference < 1e-6, difference

    # The quantities are a table on the second output.
    comparison = SurfaceComparison(Input=bilateral, Reference=truth)
    comparison.UpdatePipeline()
    table = Fetch(comparison, idx=1)
    assert table.IsA("vtkTable") and table.GetNumberOfRows() == 1, table
    assert table.GetColumnByName("MeanNormalAngle").GetValue(0) == mean_angle(bilateral, truth)
    assert "NormalAngleError" in comparison.CellData.keys(), comparison.CellData.keys()
    check_quantities(comparison, table)


check_menu()
check(Sphere(ThetaResolution=40, PhiResolution=40))
check_point_methods(Sphere(ThetaResolution=64, PhiResolution=64))
check_cloud(Sphere(ThetaResolution=40, PhiResolution=40))
write_cube("cube.off", 12)
check(OpenDataFile("cube.off"))
