# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The methods that compare.py compares, with the parameters that each gets."""

from collections import namedtuple

# proxy     the filter; a name that starts with vtk is a class of VTK, which runs outside ParaView's
#           pipeline as a peer
# caption   what the method is called in the table and in the picture, unlike any other
# paper     who published it
# settings  values of properties by the family of models that they suit: those of "default" hold for
#           all, those of "cad" (sharp edges, flat sides) and "organic" (faces, figures, scans)
#           come on top; a family that is not there has nothing of its own
Method = namedtuple("Method", "proxy caption paper settings")

FAMILIES = ("default", "cad", "organic")

METHODS = [
    Method("RobustNormalFilter", "Sun 2007", "Sun, Rosin, Martin, Langbein 2007", {
        # With Tukey's norm the weight is the square of (n . n') - T at the threshold T = 0.5.
        "default": {"Preset": "Thresholded Cosine"},
    }),
    Method("BilateralNormalFilter", "Bilateral normals", "Zheng, Fu, Au, Tai 2011", {
        "default": {},
    }),
    Method("vtkWindowedSincPolyDataFilter", "Windowed sinc (VTK)",
           "Taubin, Zhang, Golub 1996", {
               "default": {"NormalizeCoordinates": 1},
           }),
]


def is_peer(method):
    return method.proxy.startswith("vtk")


def settings_for(method, family):
    return {**method.settings["default"], **method.settings.get(family, {})}


def find_methods(names):
    """The methods called so, by caption or filter, in the order of the list; all for no names.
    ValueError if one is not there."""
    wanted = {name.lower() for name in names}
    known = {name.lower() for method in METHODS for name in (method.caption, method.proxy)}
    if wanted - known:
        raise ValueError("there is no method {}; there are {}".format(
            ", ".join(sorted(wanted - known)), ", ".join(method.caption for method in METHODS)))
    return [method for method in METHODS
            if not wanted or wanted & {method.caption.lower(), method.proxy.lower()}]
