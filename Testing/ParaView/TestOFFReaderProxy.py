# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""ParaView opens OFF files, alone and as time steps of one source."""

from paraview.simple import OpenDataFile, OFFReader

TETRAHEDRON = "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 {}\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n"

names = ["tetrahedron_{}.off".format(step) for step in range(3)]
for step, name in enumerate(names):
    with open(name, "w") as file:
        file.write(TETRAHEDRON.format(step + 1))

source = OpenDataFile(names[0])
assert source is not None
assert source.GetXMLName() == "OFFReader", source.GetXMLName()
source.UpdatePipeline()
assert source.GetDataInformation().GetNumberOfCells() == 4

series = OFFReader(FileNames=names)
series.UpdatePipelineInformation()
assert list(series.TimestepValues) == [0, 1, 2], series.TimestepValues
for step in range(3):
    series.UpdatePipeline(step)
    bounds = series.GetDataInformation().GetBounds()
    assert bounds[5] == step + 1, (step, bounds)
