# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Denoises a surface or a point cloud with the ParaView plugin, as demo_options.py says; run it with
pvpython, or through Examples/demo.sh."""

from paraview.servermanager import Fetch
from paraview.simple import SaveData

import clouds
import meshes
import methods
from demo_options import COMPOSER, parse_options
from sidebyside import save_picture
from surfaces import (add_noise, check_written, fail, has_polygons, open_surface, output_files,
                      seconds_to_update)
from tables import print_table


def choose_method(options, surface):
    """Whether points alone are filtered, and by what: what is not said depends on what is there."""
    points = options.points or not has_polygons(surface) or all(
        map(methods.is_for_points, options.methods))
    for method in options.methods:
        if methods.is_for_points(method) == points:
            return points, method
    fail("{} holds no polygons for {}".format(options.truth or options.surface,
                                              options.methods[0].caption))


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


def print_method(method, denoised):
    """What was run and, of a method that chooses by itself, what it chose and why."""
    choice = Fetch(denoised).GetFieldData().GetAbstractArray("DenoisingChoice")
    for line in [method.caption] + [choice.GetValue(i) for i in range(
            choice.GetNumberOfValues() if choice else 0)]:
        print("--", line)


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
    print_method(method, denoised)
    print_table(head, rows)
    # Not "Appended", the default: VTK 9.2 cannot read that with the expat of today's Debian 12.
    SaveData(files[0], denoised, DataMode="Binary")
    SaveData(files[1], clouds.single(denoised) if points else denoised)
    if points:
        clouds.write_text(files[3], denoised)
    check_written(files if points else files[:3])


if __name__ == "__main__":
    main()
