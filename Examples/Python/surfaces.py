# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the examples share: files in, files out, noise, and what the filters say of their work."""

import os
import sys
import time

import numpy
from paraview.servermanager import Fetch
from paraview.simple import (ConvertToPointCloud, OpenDataFile, PVTrivialProducer,
                             SurfaceComparison, SurfaceNoise, XYZPointsReader)
from vtkmodules.util.numpy_support import vtk_to_numpy

# Texts with one point per line; ParaView has other readers for some of these names.
POINT_TEXTS = (".xyz", ".xyzn", ".pts", ".asc")


def program():
    return os.path.splitext(os.path.basename(sys.argv[0]))[0]


def fail(message):
    sys.exit("{}: {}".format(program(), message))


def open_file(name):
    if os.path.splitext(name)[1].lower() in POINT_TEXTS:
        return XYZPointsReader(FileNames=[name])
    return OpenDataFile(name)


def open_surface(name, polygons=True):
    """A reader for the file, if it holds polygons. Without them, if they are not asked for, points
    with a vertex each, which some readers do not make."""
    if not os.path.isfile(name):
        fail("there is no file {}".format(name))
    try:
        reader = open_file(name)
        reader.UpdatePipeline()
    except (AttributeError, RuntimeError):
        fail("{} cannot be read as a surface".format(name))
    data = Fetch(reader)
    if not (data and data.IsA("vtkPolyData")):
        fail("{} holds no surface".format(name))
    if data.GetNumberOfPolys() + data.GetNumberOfStrips() > 0:
        return reader
    if polygons:
        fail("{} holds no polygons".format(name))
    if data.GetNumberOfPoints() == 0:
        fail("{} holds no points".format(name))
    if data.GetNumberOfVerts() == 0:
        reader = ConvertToPointCloud(Input=reader, CellGenerationMode="Vertex cells")
    return reader


def has_polygons(surface):
    data = Fetch(surface)
    return data.GetNumberOfPolys() + data.GetNumberOfStrips() > 0


def as_source(data):
    """Data of VTK in ParaView's pipeline."""
    source = PVTrivialProducer()
    source.GetClientSideObject().SetOutput(data)
    return source


def add_noise(truth, size):
    return SurfaceNoise(Input=truth, Direction="Random", Size=size)


def seconds_to_update(proxy):
    """How long the filter takes; an error if nothing comes out of it."""
    start = time.perf_counter()
    proxy.UpdatePipeline()
    seconds = time.perf_counter() - start
    if proxy.GetDataInformation().GetNumberOfCells() == 0:
        raise RuntimeError("the surface cannot be denoised")
    return seconds


def compare(surface, reference, **settings):
    """The filter that compares, and all its quantities by name."""
    comparison = SurfaceComparison(Input=surface, Reference=reference, **settings)
    comparison.UpdatePipeline()
    table = Fetch(comparison, idx=1)
    if not (table and table.GetNumberOfRows()):
        raise RuntimeError("the result cannot be compared")
    return comparison, {table.GetColumnName(i): table.GetColumn(i).GetValue(0)
                        for i in range(table.GetNumberOfColumns())}


def displacements(moved, surface):
    """How far each point is from where it was."""
    return numpy.linalg.norm(positions(moved) - positions(surface), axis=1)


def positions(surface):
    return vtk_to_numpy(Fetch(surface).GetPoints().GetData()).astype(float)


def report(proxy, name):
    """A value that the filter reports, after it was executed."""
    proxy.UpdatePipeline()
    proxy.UpdatePropertyInformation()
    return proxy.GetProperty(name).GetData()


def output_files(folder, names):
    """Where the files go, without those of an earlier run."""
    try:
        os.makedirs(folder, exist_ok=True)
        files = [os.path.join(folder, name) for name in names]
        for file in files:
            if os.path.exists(file):
                os.remove(file)
    except OSError as error:
        fail("cannot write to {}: {}".format(folder, error.strerror))
    return files


def check_written(files):
    for file in files:
        if not os.path.isfile(file):
            fail("{} could not be written".format(file))
        print("-- wrote", file)
