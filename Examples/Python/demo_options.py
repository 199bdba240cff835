# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Denoises a surface or a point cloud with the ParaView plugin.

With --truth FILE, noise is added to a clean model, and what the filter makes of it is compared with
the truth. With a file of your own, that file is the noisy surface, or the cloud if it has no
polygons. Either way you get what is clean (denoised.vtp, denoised.ply, for clouds denoised.xyz), a
picture (denoising.png) and a table.

Without --method, Denoise Surface finds out what suits the data. It has nothing to set: with one of
the settings below, Bilateral normal is run instead, Robust point normal on points, and with --norm
the method that is composed with it.
"""

import argparse

import methods
from options import add_noise_options, add_output_options

COMPOSER = methods.Method("RobustNormalFilter", "robust", "", {"default": {}})
POINT_COMPOSER = methods.POINT_METHODS[0]
AUTOMATIC = methods.find_methods(["DenoiseSurface"])
BY_HAND = methods.find_methods(["Bilateral normal"]) + [POINT_COMPOSER]


def parse_options():
    """The command line; of methods, those that may be meant, for surfaces and for points."""
    parser = argparse.ArgumentParser(prog="demo", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("surface", nargs="?", help="noisy surface: PLY OBJ STL OFF VTP VTK; or "
                        "points: also XYZ XYZN PTS ASC")
    add_noise_options(parser)
    parser.add_argument("-m", "--method", metavar="NAME",
                        help="robust (to compose one), DenoiseSurface or another one: " +
                        methods.captions(peers=False))
    settings = parser.add_argument_group("settings of the method")
    settings.add_argument("--norm", help="error norm of the robust method, such as Tukey")
    settings.add_argument("-r", "--range-scale", type=float, metavar="SCALE",
                          help="differences of normals that count as noise, in the unit of the method")
    settings.add_argument("--outer-iterations", type=int, metavar="N")
    settings.add_argument("-n", "--normal-iterations", "--iterations", type=int, metavar="N")
    settings.add_argument("-v", "--vertex-iterations", "--point-iterations", type=int, metavar="N")
    settings.add_argument("--vertex-scheme", "--position-scheme", metavar="SCHEME",
                          help="how points move, such as \"Integral Fit\"; of clouds \"Gradient\"")
    add_output_options(parser)
    options = parser.parse_args()
    if bool(options.surface) == bool(options.truth):
        parser.error("give either a noisy surface or --truth FILE")
    try:
        options.methods = find_candidates(options)
    except ValueError as error:
        parser.error(str(error))
    caption = options.methods[0].caption
    if methods.is_peer(options.methods[0]):
        parser.error("{} is no filter of the plugin".format(caption))
    if options.norm and POINT_COMPOSER not in options.methods:
        parser.error("--norm belongs to --method robust")
    if options.points and not any(map(methods.is_for_points, options.methods)):
        parser.error("{} wants polygons, not points".format(caption))
    return options


def find_candidates(options):
    if options.method == "robust" or (options.norm and not options.method):
        return [COMPOSER, POINT_COMPOSER]
    if options.method:
        return methods.find_methods([options.method])
    given = (options.range_scale, options.outer_iterations, options.normal_iterations,
             options.vertex_iterations, options.vertex_scheme)
    return BY_HAND if any(value is not None for value in given) else AUTOMATIC


if __name__ == "__main__":
    parse_options()
