# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the survey has to say of every method, in words of our own: the rows of its overview table
and what its theory of error norms lets one expect."""

from collections import namedtuple

# section   where the survey treats the method
# weights   the error norm, what it is applied to, and the spatial weight
# expected  what becomes of edges and noise by the survey
Statement = namedtuple("Statement", "section weights expected")

FADES = "influence fades with the difference: edges well above the scale stay"
SPATIAL = "the same with less say for what is far: smoother, edges stay"

# By the captions of methods.py.
MESH_STATEMENTS = {
    "Normal diffusion": Statement(
        "3.1 a", "Gaussian of the directional curvature", FADES),
    "Mean normal": Statement(
        "3.1 b", "L2; faces count by area", "influence without bound: noise goes, edges blur"),
    "Median normal": Statement(
        "3.1 b", "truncated L1 of the angle", "outliers are not heard: edges stay"),
    "Weighted median": Statement(
        "3.1 b", "truncated L1 of the angle; nearer faces count more",
        "outliers are not heard: edges stay"),
    "Huber normal": Statement(
        "3.1 c", "Huber's minimax of the chord, untried before",
        "influence bounded, in one place said to fall again: edges stay better than with L2"),
    "Voting tensor": Statement(
        "3.1 d", "1 or 0.1 by the angle, much like truncated L2",
        "noise and features are sorted by eigenvalues: edges stay"),
    "Fuzzy vector median": Statement(
        "3.1 e", "Gaussian of the chord to the vector median", FADES),
    "Curvature diffusion": Statement(
        "3.1 f", "Gaussian of the gradient of normals", FADES),
    "Geometric fidelity": Statement(
        "3.1 g", "listed as Huber's minimax, of a curvature",
        "influence bounded: edges stay, points stay close to where they were"),
    "Bilateral normal": Statement(
        "3.2 a", "Gaussian of the chord; spatial Gaussian", SPATIAL),
    "Global bilateral": Statement(
        "3.2 a", "Gaussian of the chord; spatial Gaussian; one system for all", SPATIAL),
    "Guided normal": Statement(
        "3.2 b", "Gaussian of the chord of guidance normals; spatial Gaussian",
        "differences without noise: edges stay under strong noise"),
    "Tukey bilateral": Statement(
        "3.2 c", "Tukey of the chord; spatial Gaussian",
        "no influence at all beyond the scale: sharpest edges, flat sides"),
}

POINT_STATEMENTS = {
    "Robust implicit MLS": Statement(
        "4.1 a", "Gaussian of residual and of chord; local widths",
        "edges stay; weaker for want of a spatial filter"),
    "Moving robust PCA": Statement(
        "4.1 b", "Gaussian of the angle", FADES),
    "Feature-aware point": Statement(
        "4.2 a", "Gaussian of the angle, width from the data; spatial Gaussian",
        "features tell the filter where to hold back: edges stay"),
    "Guided point normal": Statement(
        "4.2 b", "Gaussian of the chord of guidance normals; spatial Gaussian",
        "several normals at features: sharp edges and corners"),
    "Tensor point": Statement(
        "4.2 c", "Gaussian of arc length and curvature",
        "fits to one side only: edges stay"),
    "Bilateral point": Statement(
        "4.2 d", "Gaussian of the height; spatial Gaussian",
        "as good as bilateral filters of normals"),
    "Rolling point normal": Statement(
        "4.2 e", "Gaussian of the chord of rolling normals; spatial Gaussian",
        "small structures go, large edges come back"),
    "Voting tensor point": Statement(
        "4.2 f", "truncated L2 of the angle",
        "outliers are not heard: edges and corners stay"),
}

AUTOMATIC = Statement("-", "chosen from the data", "not in the survey")
