# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of few colors, which take a third of the space."""

import struct
import zlib

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkImagingColor import vtkImageQuantizeRGBToIndex
from vtkmodules.vtkIOImage import vtkPNGReader


def use_palette(name, colors=256):
    """Writes the PNG anew with a palette; what it shows looks the same."""
    reader = vtkPNGReader()
    reader.SetFileName(name)
    quantized = vtkImageQuantizeRGBToIndex()
    quantized.SetInputConnection(reader.GetOutputPort())
    quantized.SetNumberOfColors(colors)
    quantized.Update()
    image = quantized.GetOutput()
    width, height, _ = image.GetDimensions()
    rows = vtk_to_numpy(image.GetPointData().GetScalars()).astype(numpy.uint8)
    rows = rows.reshape(height, width)[::-1]  # from the top
    table = quantized.GetLookupTable()
    palette = vtk_to_numpy(table.GetTable())[:colors, :3].astype(numpy.uint8)
    filtered = numpy.hstack([numpy.zeros((height, 1), numpy.uint8), rows])  # 0: rows as they are
    with open(name, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n")
        for kind, content in (
                (b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 3, 0, 0, 0)),
                (b"PLTE", palette.tobytes()), (b"IDAT", zlib.compress(filtered.tobytes(), 9)),
                (b"IEND", b"")):
            file.write(struct.pack(">I", len(content)) + kind + content +
                       struct.pack(">I", zlib.crc32(kind + content)))
