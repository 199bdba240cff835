# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The survey's Figure 1: methods that move the points at once shrink the object, those that filter
the normals first do not."""

import meshes
import methods
from charts import COLORS, Chart, Curve, save_charts
from palettes import use_palette
from sidebyside import Panel, save_contact_sheet
from trials import run

# Iterations of the second group are one sweep over the normals and one step of the points.
SWEEP = {"NumberOfNormalIterations": 1, "NumberOfVertexIterations": 1}
ONE_STAGE = [("Mean curvature flow", "NumberOfIterations", {}),
             ("Anisotropic flow", "NumberOfIterations", {}),
             ("Bilateral vertex", "NumberOfIterations", {}),
             ("Windowed sinc (VTK)", "NumberOfIterations", {})]
TWO_STAGE = [("Bilateral normal", "NumberOfOuterIterations", SWEEP),
             ("Tukey bilateral", "NumberOfOuterIterations", SWEEP)]
ITERATIONS = (1, 2, 3, 5, 7, 10, 15, 20, 30, 40, 50)
# Those of windowed sinc are the degree of a polynomial, and below this it is no low-pass filter.
FEWEST = {"Windowed sinc (VTK)": 10}
SHOWN = 20


def with_iterations(caption, count, name, settings):
    """The method with its defaults but for these."""
    method = methods.find_methods([caption])[0]
    return method._replace(settings={
        "default": {**method.settings["default"], **settings, name: count}})


def draw(model, curves, picture):
    """Writes the two pictures, and returns rows of numbers and what failed."""
    before = meshes.measure(model.noisy, model.noisy, model.truth)
    rows, failed, lines = [], [], []
    panels = [Panel(model.truth, "Truth"), Panel(model.noisy, "Noisy: " + change(before))]
    for caption, name, settings in ONE_STAGE + TWO_STAGE:
        found = []
        for count in (count for count in ITERATIONS if count >= FEWEST.get(caption, 1)):
            result = run(meshes, with_iterations(caption, count, name, settings), model.noisy,
                         model.truth, "default")
            if result.failure:
                failed.append("{}, {} iterations".format(caption, count))
                continue
            found.append((count, result.quantities))
            if count == SHOWN:
                panels.append(Panel(result.surface, "{}: {}".format(
                    caption, change(result.quantities))))
        lines.append((caption, [(0, before)] + found))
        rows += [{"part": "shrinkage", "model": model.name, "method": caption, "iterations": count,
                  "MeanNormalAngle": quantities["MeanNormalAngle"],
                  "RelativeVolumeChange": quantities["RelativeVolumeChange"]}
                 for count, quantities in found]
    save_charts(curves, [
        chart("Change of volume", "percent", "RelativeVolumeChange", 100.0, lines, "bottom left"),
        chart("Noise that is left", "mean angle in degrees", "MeanNormalAngle", 1.0, lines, None)],
        columns=2, chart_size=(560, 400))
    save_contact_sheet(picture, panels, model.view, model.up, panel_area=110000, font_size=15)
    use_palette(picture)
    return rows, failed


def chart(title, axis, quantity, factor, lines, legend):
    two_stage = [caption for caption, *_ in TWO_STAGE]
    return Chart(title, [
        Curve(caption, [count for count, _ in found],
              [factor * quantities[quantity] for _, quantities in found],
              COLORS[i], caption in two_stage) for i, (caption, found) in enumerate(lines)],
        "iterations", axis, legend=legend)


def change(quantities):
    return "{:+.1f} %".format(100.0 * quantities["RelativeVolumeChange"])
