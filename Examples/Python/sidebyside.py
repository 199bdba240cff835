# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of several surfaces side by side, with one camera and one light for all."""

from collections import namedtuple

from paraview.simple import (AssignViewToLayout, ColorBy, CreateLayout, CreateView,
                             GetColorTransferFunction, GetLayoutByName, GetScalarBar, ResetCamera,
                             SaveScreenshot, Show, Text)

# A surface with a caption. Colored by (association, name) of an array from 0 to top, if there is
# one; legend then says what the colors mean.
Panel = namedtuple("Panel", "surface caption array top legend", defaults=(None, 1.0, ""))

INK = [0.13, 0.15, 0.19]
CLAY = [0.78, 0.80, 0.83]
# From the color of the uncolored surfaces to dark red: what is good looks alike in all panels.
ERROR_COLORS = [(0.0, *CLAY), (0.2, 0.98, 0.82, 0.52), (0.5, 0.93, 0.50, 0.22),
                (1.0, 0.60, 0.04, 0.10)]


def save_picture(name, panels, direction, up, panel_size=(700, 560)):
    """Writes all panels as one PNG: four in a square, others in a row."""
    views = [make_view(panel) for panel in panels]
    columns = 2 if len(panels) == 4 else len(panels)
    rows = len(panels) // columns
    arrange(views, columns, rows)
    look(views, direction, up)
    SaveScreenshot(name, GetLayoutByName("Side by side"), SeparatorWidth=2,
                   SeparatorColor=[1.0, 1.0, 1.0], OverrideColorPalette="",
                   ImageResolution=[columns * panel_size[0], rows * panel_size[1]])


def make_view(panel):
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
    caption = Show(Text(Text=panel.caption), view)
    caption.WindowLocation = "Any Location"
    caption.Position = [0.025, 0.915]
    caption.FontSize = 18
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


def arrange(views, columns, rows):
    layout = CreateLayout("Side by side")
    cells = [0]
    if rows == 2:
        top = layout.SplitVertical(0, 0.5)
        cells = [top, top + 1]
    places = []
    for cell in cells:
        for column in range(columns - 1):
            left = layout.SplitHorizontal(cell, 1.0 / (columns - column))
            places.append(left)
            cell = left + 1
        places.append(cell)
    for view, place in zip(views, places):
        AssignViewToLayout(view, layout, place)


def look(views, direction, up):
    """All cameras are that of the first view."""
    first = views[0]
    first.CameraFocalPoint = [0.0, 0.0, 0.0]
    first.CameraPosition = direction
    first.CameraViewUp = up
    ResetCamera(first)
    first.CameraViewAngle *= 0.87  # the model fills the view
    for view in views[1:]:
        for name in ("CameraPosition", "CameraFocalPoint", "CameraViewUp", "CameraViewAngle"):
            setattr(view, name, getattr(first, name))
