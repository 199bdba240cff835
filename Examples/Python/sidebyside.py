# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of several surfaces side by side, with one camera and one light for all."""

import math
from collections import namedtuple

import numpy
from paraview.servermanager import Fetch
from paraview.simple import (AssignViewToLayout, ColorBy, CreateLayout, CreateView, Delete,
                             GetColorTransferFunction, GetScalarBar, ResetCamera, SaveScreenshot,
                             Show, Text)
from vtkmodules.util.numpy_support import vtk_to_numpy

# A surface with a caption. Colored by (association, name) of an array from 0 to top, if there is
# one; legend then says what the colors mean. Lines, if there are any, are drawn in black on top.
Panel = namedtuple("Panel", "surface caption array top legend lines",
                   defaults=(None, 1.0, "", None))

INK = [0.13, 0.15, 0.19]
CLAY = [0.78, 0.80, 0.83]
# From the color of the uncolored surfaces to dark red: what is good looks alike in all panels.
ERROR_COLORS = [(0.0, *CLAY), (0.2, 0.98, 0.82, 0.52), (0.5, 0.93, 0.50, 0.22),
                (1.0, 0.60, 0.04, 0.10)]


def save_picture(name, panels, direction, up, panel_size=(700, 560)):
    """Writes all panels as one PNG: four in a square, others in a row."""
    columns = 2 if len(panels) == 4 else len(panels)
    views = [make_view(panel) for panel in panels]
    layout = arrange(views, columns)
    look(views, direction, up)
    capture(name, layout, columns, len(panels) // columns, panel_size)
    close(views)


def save_contact_sheet(name, panels, direction, up, panel_area=240000, font_size=21):
    """Writes many panels as one PNG, in a grid. The first surface fills its panel; where the others
    are is seen in the same place."""
    columns = len(panels) if len(panels) <= 3 else math.ceil(math.sqrt(len(panels)))
    views = [make_view(panel, font_size, 0.905) for panel in panels]
    layout = arrange(views, columns)
    axes, points = seen_from(panels[0].surface, direction, up)
    width, height = numpy.ptp(points[:, :2], axis=0)
    panel_width = round(math.sqrt(panel_area * min(max(width / (height or width), 0.85), 1.4)))
    panel_size = (panel_width, round(panel_area / panel_width))
    look_closely(views, axes, points, panel_size[0] / panel_size[1])
    # Letters keep their size in the panels, however many there are.
    capture(name, layout, columns, math.ceil(len(panels) / columns), panel_size,
            FontScaling="Do not scale fonts")
    close(views)


def capture(name, layout, columns, rows, panel_size, **settings):
    SaveScreenshot(name, layout, SeparatorWidth=2, SeparatorColor=[1.0, 1.0, 1.0],
                   OverrideColorPalette="", CompressionLevel="9",
                   ImageResolution=[columns * panel_size[0], rows * panel_size[1]], **settings)


def close(views):
    """Before the end of the program, which else may find windows without a display."""
    for view in views:
        Delete(view)


def make_view(panel, font_size=18, height=0.915):
    view = CreateView("RenderView")
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.BackgroundColorMode = "Gradient"
    view.Background = [0.76, 0.81, 0.87]
    view.Background2 = [0.98, 0.98, 0.99]
    view.KeyLightIntensity = 0.95
    view.KeyLightElevation = 45.0
    view.KeyLightAzimuth = -25.0
    view.KeyLightWarmth = 0.58
    view.FillLightWarmth = 0.42
    view.UseFXAA = 1
    display = Show(panel.surface, view)
    display.Interpolation = "Flat"  # each face with its own normal: noise is seen
    display.DiffuseColor = CLAY
    display.AmbientColor = CLAY
    display.Ambient = 0.12
    display.Diffuse = 0.88
    display.Specular = 0.25
    display.SpecularPower = 25.0
    if panel.array:
        color(display, view, panel)
    if panel.lines:
        lines = Show(panel.lines, view)
        lines.ColorArrayName = ["POINTS", ""]
        lines.AmbientColor = lines.DiffuseColor = [0.0, 0.0, 0.0]
        lines.LineWidth = 2.0
    caption = Show(Text(Text=panel.caption), view)
    caption.WindowLocation = "Any Location"
    caption.Position = [0.025, height]
    caption.FontSize = font_size
    caption.Color = INK
    return view


def color(display, view, panel):
    ColorBy(display, panel.array)
    colors = GetColorTransferFunction(panel.array[1])
    colors.ColorSpace = "Lab"
    colors.RGBPoints = [value for at, *rgb in ERROR_COLORS for value in (at * panel.top, *rgb)]
    legend = GetScalarBar(colors, view)
    legend.Title = panel.legend
    legend.ComponentTitle = ""
    legend.TitleJustification = "Left"
    legend.TitleColor = legend.LabelColor = INK
    legend.TitleFontSize = 14
    legend.LabelFontSize = 13
    legend.AutomaticLabelFormat = 0
    legend.LabelFormat = "%.2g"
    legend.UseCustomLabels = 1
    legend.CustomLabels = [panel.top * step / 3.0 for step in range(4)]
    legend.AddRangeLabels = 0
    legend.Orientation = "Horizontal"
    legend.WindowLocation = "Any Location"
    legend.Position = [0.04, 0.03]
    legend.ScalarBarLength = 0.3
    legend.ScalarBarThickness = 14
    display.SetScalarBarVisibility(view, True)


def arrange(views, columns):
    """Row by row; what is left of the last row stays white."""
    layout = CreateLayout("Side by side")
    rows = math.ceil(len(views) / columns)
    places = []
    for row in split(layout.SplitVertical, 0, rows):
        places += split(layout.SplitHorizontal, row, columns)
    for view, place in zip(views, places):
        AssignViewToLayout(view, layout, place)
    return layout


def split(halve, cell, count):
    """The cells that come of cutting one into equal parts, each cut splitting one off the rest."""
    cells = []
    for left in range(count, 1, -1):
        cells.append(halve(cell, 1.0 / left))
        cell = cells[-1] + 1
    return cells + [cell]


def look(views, direction, up):
    first = views[0]
    first.CameraFocalPoint = [0.0, 0.0, 0.0]
    first.CameraPosition = direction
    first.CameraViewUp = up
    ResetCamera(first)
    first.CameraViewAngle *= 0.87  # the model fills the view
    share_camera(views)


def seen_from(surface, direction, up):
    """The axes to the right, up and towards the camera, and the points in these coordinates."""
    back = numpy.array(direction) / numpy.linalg.norm(direction)
    right = numpy.cross(up, back)
    right /= numpy.linalg.norm(right)
    axes = numpy.array([right, numpy.cross(back, right), back])
    points = vtk_to_numpy(Fetch(surface).GetPoints().GetData()).astype(float)
    return axes, points[numpy.isfinite(points).all(axis=1)] @ axes.T


def look_closely(views, axes, points, aspect):
    """The points fill the panel, below the caption and with a margin on all sides."""
    middle = 0.5 * (points.min(axis=0) + points.max(axis=0))
    first = views[0]
    top, bottom, side = 0.80, 0.94, 0.94  # shares of half a panel that the surface may use
    slope = math.tan(math.radians(0.5 * first.CameraViewAngle))
    slopes = slope * numpy.array([side * aspect, 0.5 * (top + bottom)])
    for _ in range(5):  # what is nearer looks larger, so that the middle of the picture moves
        around = points - middle
        # The points seen farthest out decide.
        distance = (around[:, 2] + (numpy.abs(around[:, :2]) / slopes).max(axis=1)).max()
        seen = around[:, :2] / (distance - around[:, 2:])
        middle[:2] += 0.5 * distance * (seen.min(axis=0) + seen.max(axis=0))
    focus = middle + [0.0, 0.5 * (bottom - top) * slope * distance, 0.0]
    first.CameraFocalPoint = list(focus @ axes)
    first.CameraPosition = list((focus + [0.0, 0.0, distance]) @ axes)
    first.CameraViewUp = list(axes[1])
    share_camera(views)


def share_camera(views):
    """All cameras are that of the first view."""
    for view in views[1:]:
        for name in ("CameraPosition", "CameraFocalPoint", "CameraViewUp", "CameraViewAngle"):
            setattr(view, name, getattr(views[0], name))
