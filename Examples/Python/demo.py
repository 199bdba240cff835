# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Denoises a surface or a point cloud with the ParaView plugin; run it with pvpython, or through
Examples/demo.sh.

With --truth FILE, noise is added to a clean model, and what the filter makes of it is compared with
the truth. With a file of your own, that file is the noisy surface, or the cloud if it has no
polygons. Either way you get what is clean (denoised.vtp, denoised.ply, for clouds denoised.xyz), a
picture (denoising.png) and a table.
"""

import argparse

from paraview.simple import SaveData

import clouds
import meshes
import methods
from sidebyside import save_picture
from surfaces import (add_noise, add_noise_options, add_output_options, check_written, fail,
                      has_polygons, open_surface, output_files, seconds_to_update)
from tables import print_table

COMPOSER = methods.Method("RobustNormalFilter", "robust", "", {"default": {}})
POINT_COMPOSER = methods.POINT_METHODS[0]
DEFAULT = "Bilateral normal"


def parse_options():
    parser = argparse.ArgumentParser(prog="demo", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("surface", nargs="?", help="noisy surface: PLY OBJ STL OFF VTP VTK; or "
                        "points: also XYZ XYZN PTS ASC")
    add_noise_options(parser)
    parser.add_argument("-m", "--method", metavar="NAME",
                        help="robust (to compose one) or a published one: " +
                        methods.captions(peers=False))
    parser.add_argument("--norm", help="error norm of the robust method, such as Tukey")
    parser.add_argument("-r", "--range-scale", type=float, metavar="SCALE",
                        help="differences of normals that count as noise, in the unit of the method")
    parser.add_argument("--outer-iterations", type=int, metavar="N")
    parser.add_argument("-n", "--normal-iterations", "--iterations", type=int, metavar="N")
    parser.add_argument("-v", "--vertex-iterations", "--point-iterations", type=int, metavar="N")
    parser.add_argument("--vertex-scheme", "--position-scheme", metavar="SCHEME",
                        help="how points move, such as \"Integral Fit\"; of clouds \"Gradient\"")
    add_output_options(parser)
    options = parser.parse_args()
    if bool(options.surface) == bool(options.truth):
        parser.error("give either a noisy surface or --truth FILE")
    options.composer = options.method == "robust"
    try:
        options.method = methods.find_methods([options.method])[0] \
            if options.method and not options.composer else None
    except ValueError as error:
        parser.error(str(error))
    if options.method and methods.is_peer(options.method):
        parser.error("{} is no filter of the plugin".format(options.method.caption))
    if options.norm and options.method not in (None, POINT_COMPOSER):
        parser.error("--norm belongs to --method robust")
    if options.points and options.method and not methods.is_for_points(options.method):
        parser.error("{} wants polygons, not points".format(options.method.caption))
    return options


def choose_method(options, surface):
    """Whether points alone are filtered, and by what: what is not said depends on what is there."""
    if options.method:
        points = methods.is_for_points(options.method)
        if not (points or has_polygons(surface)):
            fail("{} holds no polygons for {}".format(options.truth or options.surface,
                                                      options.method.caption))
        return points, options.method
    points = options.points or not has_polygons(surface)
    if points:
        return points, POINT_COMPOSER
    if options.norm and not options.composer:
        fail("--norm belongs to --method robust")
    return points, COMPOSER if options.composer else methods.find_methods([DEFAULT])[0]


def make_filter(options, points, method, noisy):
    settings = {"NumberOfOuterIterations": options.outer_iterations,
                "NumberOfNormalIterations": options.normal_iterations,
                "NumberOfPointIterations" if points else "NumberOfVertexIterations":
                    options.vertex_iterations,
                "PositionScheme" if points else "VertexScheme": options.vertex_scheme,
                "RangeScale": options.range_scale, "Norm": options.norm}
    if method is COMPOSER and options.range_scale is not None:
        settings["ScaleSource"] = "Given"
    try:
        return methods.make_filters(method, "default", noisy, {
            name: value for name, value in settings.items() if value is not None})
    except ValueError as error:
        fail(error)
    except AttributeError:
        fail("{} does not have one of these settings".format(method.caption))


def denoise(options, surface, points, method):
    """The clean surface, the panels of the picture, and the head and the rows of the table."""
    kind = clouds if points else meshes
    noisy = add_noise(surface, options.noise) if options.truth else surface
    seconds = [seconds_to_update(noisy)]
    if points:
        noisy = clouds.bare_points(noisy) if options.truth else clouds.points_of(noisy)
    denoised = make_filter(options, points, method, noisy)
    seconds.append(seconds_to_update(denoised))
    panels, head, rows = kind.demo_known(surface, noisy, denoised) if options.truth \
        else kind.demo_unknown(noisy, denoised)
    names = ["noisy", "denoised"][-len(rows):]
    return denoised, panels, ["model"] + head + ["seconds"], [
        [name] + row + ["{:.2f}".format(time)]
        for name, row, time in zip(names, rows, seconds[-len(rows):])]


def main():
    options = parse_options()
    files = output_files(options.output, ("denoised.vtp", "denoised.ply", "denoising.png",
                                          "denoised.xyz"))
    surface = open_surface(options.truth or options.surface, polygons=False)
    points, method = choose_method(options, surface)
    try:
        denoised, panels, head, rows = denoise(options, surface, points, method)
    except RuntimeError as error:
        fail(error)
    save_picture(files[2], panels, options.view, options.up)
    print_table(head, rows)
    # Not "Appended", the default: VTK 9.2 cannot read that with the expat of today's Debian 12.
    SaveData(files[0], denoised, DataMode="Binary")
    SaveData(files[1], clouds.single(denoised) if points else denoised)
    if points:
        clouds.write_text(files[3], denoised)
    check_written(files if points else files[:3])


if __name__ == "__main__":
    main()
