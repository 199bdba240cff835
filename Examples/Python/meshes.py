# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces with polygons: what they are judged by, and what pictures show of them."""

from paraview.simple import PythonCalculator

from sidebyside import Panel
from surfaces import add_noise, compare, displacements, report
from tables import number

# Columns of a comparison of methods: what they are called, a quantity, what it is multiplied by,
# how it is written.
WITH_TRUTH = [("mean angle (\u00b0)", "MeanNormalAngle", 1.0, "{:.2f}"),
              ("near features (\u00b0)", "FeatureNormalAngle", 1.0, "{:.2f}"),
              ("elsewhere (\u00b0)", "SmoothNormalAngle", 1.0, "{:.2f}"),
              ("E_v x 1000", "RelativePositionError", 1000.0, "{:.3f}"),
              ("volume change (%)", "RelativeVolumeChange", 100.0, "{:+.3f}"),
              ("flipped faces", "FlippedFaces", 1.0, "{:.0f}")]
WITHOUT_TRUTH = [("mean displacement (edge lengths)", "MeanDisplacement", 1.0, "{:.3f}"),
                 ("volume change (%)", "RelativeVolumeChange", 100.0, "{:+.3f}")]

TRUTH_NOTE = ("Angles are means over the angles between the normals of the faces and the true "
              "ones; near features is within {rings} rings of faces around edges of more than "
              "{angle:g}\u00b0. E_v is the distance of the points from the truth, in thousandths "
              "of its diagonal.")
NO_TRUTH_NOTE = "There is no truth: displacement and change of volume are against the input."


def measure(surface, noisy, truth, **settings):
    """The quantities that a result is judged by."""
    if truth:
        return compare(surface, truth, **settings)[1]
    edge = mean_edge_length(noisy)
    return {"MeanDisplacement": displacements(surface, noisy).mean() / edge,
            "RelativeVolumeChange":
                compare(surface, noisy, **settings)[1]["RelativeVolumeChange"]}


def mean_edge_length(surface):
    """Which not every filter reports."""
    return report(add_noise(surface, 0.0), "UnitLength")


def short_error(quantities):
    return "{:.1f}\u00b0".format(quantities["MeanNormalAngle"])


def shown(surface):
    """What a picture shows."""
    return surface


def demo_known(truth, noisy, denoised):
    """Panels of a picture, and a table: its head, and a row each for the noisy and the denoised."""
    comparisons = [compare(surface, truth) for surface in (noisy, denoised)]
    rows = [["{:.2f}".format(found["MeanNormalAngle"]),
             "{:.3f}".format(1000.0 * found["RelativePositionError"]),
             number(100.0 * found["RelativeVolumeChange"], "{:+.3f}")] for _, found in comparisons]
    before, after = (short_error(found) for _, found in comparisons)
    return [Panel(truth, "Original"),
            Panel(noisy, "With noise: normals {} off".format(before)),
            Panel(denoised, "Denoised: normals {} off".format(after)),
            Panel(comparisons[1][0], "What is left", ("CELLS", "NormalAngleError"), 30.0,
                  "Error in degrees")], \
        ["mean angle (degrees)", "E_v x 1000", "volume change (%)"], rows


def demo_unknown(noisy, denoised):
    """Panels of a picture, and the head and the row of a table."""
    edge = mean_edge_length(noisy)
    moved = PythonCalculator(
        Input=[denoised, noisy], ArrayName="Displacement",
        Expression="mag(inputs[0].Points - inputs[1].Points) / {!r}".format(edge))
    lengths = displacements(denoised, noisy) / edge
    volume = compare(denoised, noisy)[1]["RelativeVolumeChange"]
    return [Panel(noisy, "Input"),
            Panel(denoised, "Denoised"),
            Panel(moved, "How far points moved", ("POINTS", "Displacement"),
                  max(lengths.max(), 1e-9), "Edge lengths")], \
        ["volume change (%)", "mean displacement (edge lengths)"], \
        [[number(100.0 * volume, "{:+.3f}"), "{:.3f}".format(lengths.mean())]]
