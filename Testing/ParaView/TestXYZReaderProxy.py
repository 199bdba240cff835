# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""ParaView opens texts of points, alone and as time steps of one source, shows them, and leaves files
of atoms to its own reader; the examples read them as well as other files of points."""

import os
import sys

from paraview import make_name_valid, servermanager
from paraview.servermanager import Fetch
from paraview.simple import OpenDataFile, PointSource, SaveData, Sphere, XYZPointsReader, XYZReader

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../Examples/Python"))
sys.dont_write_bytecode = True
import surfaces

NORMALS = "0 0 {} 0 0 1\n1 0 0 0 0.6 0.8\n0 1 0 0 0 1\n"
COLORS = "0 0 0 255 0 0\n1 0 0 0 128 0\n"
HEADER = "//X,Y,Z,Nx,Ny,Nz\n"
ATOMS = "2\nhydrogen\nH 0 0 0\nH 0 0 0.74\n"


def write(name, content):
    with open(name, "w") as file:
        file.write(content)
    return name


def point_data(source):
    source.UpdatePipeline()
    return Fetch(source).GetPointData()


# File > Open: the readers that are offered for a file are those that can read it.
factory = servermanager.vtkSMProxyManager.GetProxyManager().GetReaderFactory()
factory.UpdateAvailableReaders()
session = servermanager.ActiveConnection.Session


def offered(name):
    """Names of the readers that ParaView offers for a file."""
    strings = factory.GetReaders(name, session)
    return [strings.GetString(i + 1) for i in range(0, strings.GetNumberOfStrings(), 3)]


for extension in ("xyz", "xyzn", "pts", "asc", "XYZ"):
    name = write("offered." + extension, NORMALS.format(0))
    assert "XYZPointsReader" in offered(name), (name, offered(name))
write("atoms.xyz", ATOMS)
assert "XYZPointsReader" not in offered("atoms.xyz"), offered("atoms.xyz")
assert "XYZPointsReader" not in offered(write("mesh.off", "OFF\n0 0 0\n")), offered("mesh.off")
assert XYZReader(FileName="atoms.xyz").GetXMLName() == "xyzreader", "ParaView's reader is still there"

for name in ("opened.xyzn", "opened.asc"):
    source = OpenDataFile(write(name, HEADER + NORMALS.format(0).replace(" ", ",")))
    assert source.GetXMLName() == "XYZPointsReader", source.GetXMLName()
    assert point_data(source).GetNormals().GetTuple3(1) == (0.0, 0.6, 0.8)
    assert source.GetDataInformation().GetNumberOfCells() == 3, "points are seen"

# Six columns of either kind.
source = XYZPointsReader(FileNames=[write("colors.xyz", COLORS)])
assert source.SixColumns == "Automatic", source.SixColumns
assert point_data(source).GetScalars().GetTuple3(0) == (255.0, 0.0, 0.0)
source.SixColumns = "Normals"
assert point_data(source).GetNormals().GetTuple3(0) == (255.0, 0.0, 0.0)
assert point_data(source).GetArray("RGB") is None
source.FileNames = [write("dark.xyz", "0 0 0 0 0 1\n")]
source.SixColumns = "Colors"
assert point_data(source).GetArray("RGB").GetTuple3(0) == (0.0, 0.0, 1.0)

names = [write("scan_{}.xyz".format(step), NORMALS.format(step + 1)) for step in range(3)]
series = XYZPointsReader(FileNames=names)
series.UpdatePipelineInformation()
assert list(series.TimestepValues) == [0, 1, 2], series.TimestepValues
for step in range(3):
    series.UpdatePipeline(step)
    bounds = series.GetDataInformation().GetBounds()
    assert bounds[5] == step + 1, (step, bounds)

# What users see of it.
proxy = series.SMProxy
assert make_name_valid(proxy.GetXMLLabel()) == "XYZPointsReader", proxy.GetXMLLabel()
texts = proxy.GetDocumentation()
assert len(texts.GetShortHelp()) <= 80 and texts.GetLongHelp() and len(texts.GetDescription()) > 200
for key in series.ListProperties():
    prop = series.GetProperty(key).SMProperty
    assert make_name_valid(prop.GetXMLLabel()) == key, (key, prop.GetXMLLabel())
    assert (prop.GetDocumentation().GetDescription() or "").strip(), key

# The examples.
SaveData("cloud.vtp", PointSource(NumberOfPoints=10), DataMode="Ascii")
SaveData("mesh.ply", Sphere())
write("cloud.ply", "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
      "property float z\nend_header\n0 0 0\n1 2 3\n")
for extension in surfaces.POINT_TEXTS:
    write("cloud" + extension, NORMALS.format(0))
    source = surfaces.open_surface("cloud" + extension, polygons=False)
    assert point_data(source).GetNormals().GetTuple3(2) == (0.0, 0.0, 1.0), extension
for name, points in (("cloud.vtp", 10), ("cloud.ply", 2), ("cloud.xyz", 3), ("mesh.ply", 50)):
    source = surfaces.open_surface(name, polygons=False)
    data = Fetch(source)
    assert data.GetNumberOfPoints() == points, (name, data.GetNumberOfPoints())
    assert data.GetNumberOfCells() > 0, (name, "points are seen")
write("broken.xyz", "1 2 3\n4 5\n")
for name, options, reason in (("cloud.xyz", {}, "no polygons"), ("cloud.ply", {}, "no polygons"),
                              ("cloud.vtp", {}, "no polygons"),
                              ("broken.xyz", {"polygons": False}, "no points"),
                              ("missing.xyz", {"polygons": False}, "there is no file")):
    try:
        surfaces.open_surface(name, **options)
        assert False, name + " was accepted"
    except SystemExit as end:
        assert name in str(end) and reason in str(end), end
