# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Curves in charts, written as pictures."""

import math
from collections import namedtuple

import vtkmodules.vtkRenderingContextOpenGL2  # draws what the others only describe
import vtkmodules.vtkRenderingFreeType
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkChartsCore import vtkAxis, vtkChart, vtkChartLegend, vtkChartMatrix, vtkChartXY
from vtkmodules.vtkCommonDataModel import vtkTable, vtkVector2f, vtkVector2i
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter
from vtkmodules.vtkViewsContext2D import vtkContextView

# One color per curve; dashed ones are told from the others without colors.
Curve = namedtuple("Curve", "caption x y color dashed", defaults=(False,))
# Ranges are (low, high), or None for those of the curves. Titles of axes and of the chart may be
# empty. The legend is in a corner, one of LEGENDS, or nowhere.
Chart = namedtuple("Chart", "title curves x y x_range y_range legend",
                   defaults=("", "", None, None, None))

LEGENDS = {"top right": (vtkChartLegend.RIGHT, vtkChartLegend.TOP),
           "bottom left": (vtkChartLegend.LEFT, vtkChartLegend.BOTTOM)}

COLORS = [(213, 94, 0), (0, 114, 178), (0, 158, 115), (204, 121, 167), (230, 159, 0),
          (86, 180, 233), (0, 0, 0)]  # which the color-blind tell apart
DASHES = 2
INK = (33, 38, 48)


def save_charts(name, charts, columns, chart_size=(460, 340)):
    """Writes the charts as one PNG, row by row from the top."""
    rows = math.ceil(len(charts) / columns)
    matrix = vtkChartMatrix()
    matrix.SetSize(vtkVector2i(columns, rows))
    matrix.SetGutter(vtkVector2f(62.0, 66.0))
    matrix.SetBorders(64, 52, 20, 36)
    for i, chart in enumerate(charts):
        row, column = divmod(i, columns)
        matrix.SetChart(vtkVector2i(column, rows - 1 - row), make_chart(chart))
    view = vtkContextView()
    view.GetRenderer().SetBackground(1.0, 1.0, 1.0)
    view.GetRenderWindow().SetOffScreenRendering(1)
    view.GetRenderWindow().SetSize(columns * chart_size[0], rows * chart_size[1])
    view.GetRenderWindow().SetMultiSamples(8)
    view.GetScene().AddItem(matrix)
    view.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(view.GetRenderWindow())
    image.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetFileName(name)
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()


def make_chart(chart):
    made = vtkChartXY()
    made.SetTitle(chart.title)
    made.GetTitleProperties().SetFontSize(15)
    made.GetTitleProperties().SetColor(*(value / 255.0 for value in INK))
    for curve in chart.curves:
        add_curve(made, curve)
    for position, title, limits in ((vtkAxis.BOTTOM, chart.x, chart.x_range),
                                    (vtkAxis.LEFT, chart.y, chart.y_range)):
        axis = made.GetAxis(position)
        axis.SetTitle(title)
        axis.GetTitleProperties().SetBold(0)
        axis.GetTitleProperties().SetFontSize(13)
        axis.GetLabelProperties().SetFontSize(12)
        axis.GetGridPen().SetColor(225, 228, 232)
        if limits:
            axis.SetBehavior(vtkAxis.FIXED)
            axis.SetMinimum(limits[0])
            axis.SetMaximum(limits[1])
    if chart.legend:
        made.SetShowLegend(True)
        horizontal, vertical = LEGENDS[chart.legend]
        made.GetLegend().SetHorizontalAlignment(horizontal)
        made.GetLegend().SetVerticalAlignment(vertical)
        made.GetLegend().SetLabelSize(12)
    return made


def add_curve(chart, curve):
    table = vtkTable()
    for title, values in (("x", curve.x), (curve.caption, curve.y)):
        column = numpy_to_vtk([float(value) for value in values], deep=1)
        column.SetName(title)
        table.AddColumn(column)
    line = chart.AddPlot(vtkChart.LINE)
    line.SetInputData(table, 0, 1)
    line.SetColor(*curve.color, 255)
    line.SetWidth(2.5)
    if curve.dashed:
        line.GetPen().SetLineType(DASHES)
