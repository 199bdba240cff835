# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Denoises a surface with the ParaView plugin; run it with pvpython, or through Examples/demo.sh.

With --truth FILE, noise is added to a clean model, and what the filter makes of it is compared with
the truth. With a file of your own, that file is the noisy surface. Either way you get the clean
surface (denoised.vtp, denoised.ply), a picture (denoising.png) and a table.
"""

import argparse

from paraview.simple import PythonCalculator, SaveData, SurfaceComparison
from paraview.servermanager import Fetch
from vtkmodules.util.numpy_support import vtk_to_numpy

import methods
from sidebyside import Panel, save_picture
from surfaces import (add_noise, add_noise_options, add_output_options, check_written, fail, number,
                      open_surface, output_files, report, seconds_to_update)

COMPOSER = methods.Method("RobustNormalFilter", "robust", "", {"default": {}})


def parse_options():
    parser = argparse.ArgumentParser(prog="demo", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("surface", nargs="?", help="noisy surface: PLY OBJ STL OFF VTP VTK")
    add_noise_options(parser)
    parser.add_argument("-m", "--method", default="Bilateral normal", metavar="NAME",
                        help="robust (to compose one) or a published one: " + ", ".join(
                            method.caption for method in methods.METHODS
                            if not methods.is_peer(method)))
    parser.add_argument("--norm", help="error norm of the robust method, such as Tukey")
    parser.add_argument("-r", "--range-scale", type=float, metavar="SCALE",
                        help="differences of normals that count as noise, in the unit of the method")
    parser.add_argument("--outer-iterations", type=int, metavar="N")
    parser.add_argument("-n", "--normal-iterations", "--iterations", type=int, metavar="N")
    parser.add_argument("-v", "--vertex-iterations", type=int, metavar="N")
    parser.add_argument("--vertex-scheme", metavar="SCHEME",
                        help="how points move, such as \"Integral Fit\"")
    add_output_options(parser)
    options = parser.parse_args()
    if bool(options.surface) == bool(options.truth):
        parser.error("give either a noisy surface or --truth FILE")
    if options.norm and options.method != "robust":
        parser.error("--norm belongs to --method robust")
    try:
        options.method = COMPOSER if options.method == "robust" else \
            methods.find_methods([options.method])[0]
    except ValueError as error:
        parser.error(str(error))
    if methods.is_peer(options.method):
        parser.error("{} is no filter of the plugin".format(options.method.caption))
    return options


def make_filter(options, noisy):
    settings = {"NumberOfOuterIterations": options.outer_iterations,
                "NumberOfNormalIterations": options.normal_iterations,
                "NumberOfVertexIterations": options.vertex_iterations,
                "VertexScheme": options.vertex_scheme, "RangeScale": options.range_scale,
                "Norm": options.norm}
    if options.method is COMPOSER and options.range_scale is not None:
        settings["ScaleSource"] = "Given"
    try:
        return methods.make_filters(options.method, "default", noisy, {
            name: value for name, value in settings.items() if value is not None})
    except ValueError as error:
        fail(error)
    except AttributeError:
        fail("{} does not have one of these settings".format(options.method.caption))


def print_table(head, rows):
    columns = list(zip(head, *rows))
    widths = [max(len(text) for text in column) for column in columns]
    for row in [head] + rows:
        print("  ".join([row[0].ljust(widths[0])] +
                        [text.rjust(width) for text, width in zip(row[1:], widths[1:])]))


def denoise_known(options, picture):
    """Noise on a clean model, and how much of it is left."""
    truth = open_surface(options.truth)
    noisy = add_noise(truth, options.noise)
    times = [("noisy", noisy, seconds_to_update(noisy))]
    denoised = make_filter(options, noisy)
    times.append(("denoised", denoised, seconds_to_update(denoised)))

    rows, comparisons = [], []
    for name, surface, seconds in times:
        comparison = SurfaceComparison(Input=surface, Reference=truth)
        comparisons.append(comparison)
        rows.append([name, "{:.2f}".format(report(comparison, "MeanNormalAngle")),
                     "{:.3f}".format(1000.0 * report(comparison, "RelativePositionError")),
                     number(100.0 * report(comparison, "RelativeVolumeChange"), "{:+.3f}"),
                     "{:.2f}".format(seconds)])
    angles = ["{:.1f}\u00b0".format(report(comparison, "MeanNormalAngle"))
              for comparison in comparisons]
    save_picture(picture, [
        Panel(truth, "Original"),
        Panel(noisy, "With noise: normals {} off".format(angles[0])),
        Panel(denoised, "Denoised: normals {} off".format(angles[1])),
        Panel(comparisons[1], "What is left", ("CELLS", "NormalAngleError"), 30.0,
              "Error in degrees")], options.view, options.up)
    print_table(["model", "mean angle (degrees)", "E_v x 1000", "volume change (%)", "seconds"],
                rows)
    return denoised


def denoise_unknown(options, picture):
    """A noisy surface, and how far its points moved."""
    noisy = open_surface(options.surface)
    denoised = make_filter(options, noisy)
    seconds = seconds_to_update(denoised)
    edge = report(denoised, "MeanEdgeLength")
    moved = PythonCalculator(
        Input=[denoised, noisy], ArrayName="Displacement",
        Expression="mag(inputs[0].Points - inputs[1].Points) / {!r}".format(edge))
    moved.UpdatePipeline()
    displacement = vtk_to_numpy(Fetch(moved).GetPointData().GetArray("Displacement"))
    volume = report(SurfaceComparison(Input=denoised, Reference=noisy), "RelativeVolumeChange")
    save_picture(picture, [
        Panel(noisy, "Input"),
        Panel(denoised, "Denoised"),
        Panel(moved, "How far points moved", ("POINTS", "Displacement"),
              max(displacement.max(), 1e-9), "Edge lengths")],
                 options.view, options.up)
    print_table(["model", "volume change (%)", "mean displacement (edge lengths)", "seconds"],
                [["denoised", number(100.0 * volume, "{:+.3f}"),
                  "{:.3f}".format(displacement.mean()), "{:.2f}".format(seconds)]])
    return denoised


def main():
    options = parse_options()
    files = output_files(options.output, ("denoised.vtp", "denoised.ply", "denoising.png"))
    denoise = denoise_known if options.truth else denoise_unknown
    try:
        denoised = denoise(options, files[2])
    except RuntimeError as error:
        fail(error)
    # Not "Appended", the default: VTK 9.2 cannot read that with the expat of today's Debian 12.
    SaveData(files[0], denoised, DataMode="Binary")
    SaveData(files[1], denoised)
    check_written(files)


if __name__ == "__main__":
    main()
