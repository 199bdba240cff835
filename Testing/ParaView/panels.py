# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What pictures of several panels show."""

from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.util.numpy_support import vtk_to_numpy


def check_panels(name, columns, rows=1, count=None):
    """All panels of the picture show a surface, row by row; those beyond count are white."""
    reader = vtkPNGReader()
    reader.SetFileName(name)
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
    pixels = pixels.reshape(height, width, -1)[::-1]  # from the top
    for i in range(columns * rows):
        row, column = divmod(i, columns)
        panel = pixels[row * height // rows:(row + 1) * height // rows,
                       column * width // columns:(column + 1) * width // columns]
        if count is None or i < count:
            assert panel.std() > 20.0, (name, i, panel.std())
        else:
            assert panel[4:-4, 4:-4].min() == 255, (name, i, panel.min())
