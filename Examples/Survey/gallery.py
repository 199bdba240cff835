# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The survey's Figures 2 and 3: what every method makes of one model."""

from paraview.simple import FeatureEdges

from palettes import use_palette
from sidebyside import Panel, save_contact_sheet

CURVE_ANGLE = 70.0  # the survey's black curves: where faces meet at more than this


def feature_curves(surface):
    return FeatureEdges(Input=surface, FeatureEdges=1, FeatureAngle=CURVE_ANGLE, BoundaryEdges=0,
                        NonManifoldEdges=0, ManifoldEdges=0, Coloring=0)


def draw(picture, kind, model, results, curves=False):
    """Truth, noisy and all results that there are; curves are those of features."""
    surfaces = [(model.truth, "Truth")] + [
        (result.surface, "{}: {}".format(result.caption.replace("Denoise Surface (automatic)",
                                                                "Automatic"),
                                         kind.short_error(result.quantities)))
        for result in results if not result.failure]
    panels = [Panel(surface, caption, lines=feature_curves(surface) if curves else None)
              for surface, caption in surfaces]
    save_contact_sheet(picture, panels, model.view, model.up, panel_area=62000, font_size=11)
    use_palette(picture, 96)
