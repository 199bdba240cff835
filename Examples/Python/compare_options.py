# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Denoises one surface or point cloud with every method of the ParaView plugin.

    compare.py NOISY TRUTH       how far each result is from the truth
    compare.py --truth CLEAN     the same, with noise that is added to a clean model
    compare.py NOISY             how far each method moves the points

Methods for points are those that are compared if there are no polygons, with --points, or if they
are asked for. Writes a table (comparison.md; comparison.csv has all numbers) and a picture
(comparison.png) of all results. A method that fails is marked in the table, and the exit code is 1.
"""

import argparse

import methods
from options import add_noise_options, add_output_options


def parse_options():
    parser = argparse.ArgumentParser(prog="compare", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("noisy", nargs="?", help="noisy surface: PLY OBJ STL OFF VTP VTK; or "
                        "points: also XYZ XYZN PTS ASC")
    parser.add_argument("reference", metavar="truth", nargs="?", help="what it should be")
    add_noise_options(parser)
    parser.add_argument("--methods", nargs="+", default=[], metavar="NAME",
                        help="only these: " + methods.captions())
    parser.add_argument("--parameters", choices=methods.FAMILIES, default="default",
                        help="parameters for this family of models (default)")
    parser.add_argument("--feature-angle", type=float, default=30.0, metavar="DEGREES",
                        help="the truth has a feature where faces meet at more than this (30)")
    parser.add_argument("--feature-rings", type=int, default=2, metavar="N",
                        help="rings of faces around an edge that are near a feature (2)")
    add_output_options(parser)
    options = parser.parse_args()
    if bool(options.noisy) == bool(options.truth):
        parser.error("give a noisy surface, with the truth or without, or --truth FILE")
    try:
        options.methods = methods.find_methods(options.methods)
    except ValueError as error:
        parser.error(str(error))
    return options


if __name__ == "__main__":
    parse_options()
