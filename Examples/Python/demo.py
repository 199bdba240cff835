# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Denoises a surface with the ParaView plugin; run it with pvpython, or through Examples/demo.sh.

With --truth FILE, noise is added to a clean model, and what the filter makes of it is compared with
the truth. With a file of your own, that file is the noisy surface. Either way you get the clean
surface (denoised.vtp, denoised.ply), a picture (denoising.png) and a table.
"""

import argparse
import math
import os
import sys
import time

from paraview.simple import (BilateralNormalFilter, OpenDataFile, PythonCalculator,
                             RobustNormalFilter, SaveData, SurfaceComparison, SurfaceNoise)
from paraview.servermanager import Fetch
from vtkmodules.util.numpy_support import vtk_to_numpy

from sidebyside import Panel, save_picture


def parse_options():
    parser = argparse.ArgumentParser(prog="demo", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("surface", nargs="?", help="noisy surface: PLY OBJ STL OFF VTP VTK")
    parser.add_argument("--truth", metavar="FILE", help="clean surface that gets noise")
    parser.add_argument("--noise", type=float, default=0.3, metavar="SIZE",
                        help="standard deviation of the noise in mean edge lengths (0.3)")
    parser.add_argument("-m", "--method", choices=("bilateral", "robust"), default="bilateral")
    parser.add_argument("--norm", help="error norm of the robust method, such as Tukey")
    parser.add_argument("-r", "--range-scale", type=float, metavar="SCALE",
                        help="differences of normals that count as noise (chord length)")
    parser.add_argument("-n", "--normal-iterations", "--iterations", type=int, metavar="N")
    parser.add_argument("-v", "--vertex-iterations", type=int, metavar="N")
    parser.add_argument("--vertex-scheme", metavar="SCHEME",
                        help="how points move, such as \"Integral Fit\"")
    parser.add_argument("--view", type=float, nargs=3, default=(1.0, -1.6, 0.9),
                        metavar=("X", "Y", "Z"), help="direction from the model to the camera")
    parser.add_argument("--up", type=float, nargs=3, default=(0.0, 0.0, 1.0),
                        metavar=("X", "Y", "Z"), help="what is up in the picture")
    parser.add_argument("-o", "--output", default="out", metavar="FOLDER")
    options = parser.parse_args()
    if bool(options.surface) == bool(options.truth):
        parser.error("give either a noisy surface or --truth FILE")
    if options.norm and options.method != "robust":
        parser.error("--norm belongs to --method robust")
    return options


def open_surface(name):
    """A reader for the file, if it holds polygons."""
    if not os.path.isfile(name):
        sys.exit("demo: there is no file {}".format(name))
    try:
        reader = OpenDataFile(name)
        reader.UpdatePipeline()
    except (AttributeError, RuntimeError):
        sys.exit("demo: {} cannot be read as a surface".format(name))
    data = Fetch(reader)
    if not (data and data.IsA("vtkPolyData")):
        sys.exit("demo: {} holds no surface".format(name))
    if data.GetNumberOfPolys() + data.GetNumberOfStrips() == 0:
        sys.exit("demo: {} holds no polygons".format(name))
    return reader


def make_filter(options, noisy):
    settings = {"NumberOfNormalIterations": options.normal_iterations,
                "NumberOfVertexIterations": options.vertex_iterations,
                "VertexScheme": options.vertex_scheme, "RangeScale": options.range_scale}
    if options.method == "robust":
        settings["Norm"] = options.norm
        settings["ScaleSource"] = None if options.range_scale is None else "Given"
    denoise = RobustNormalFilter if options.method == "robust" else BilateralNormalFilter
    try:
        return denoise(Input=noisy, **{name: value for name, value in settings.items()
                                       if value is not None})
    except ValueError as error:
        sys.exit("demo: {}".format(error))


def seconds_to_update(proxy):
    start = time.perf_counter()
    proxy.UpdatePipeline()
    seconds = time.perf_counter() - start
    if proxy.GetDataInformation().GetNumberOfCells() == 0:
        sys.exit("demo: the surface cannot be denoised")
    return seconds


def report(proxy, name):
    """A value that the filter reports, after it was executed."""
    proxy.UpdatePipeline()
    proxy.UpdatePropertyInformation()
    return proxy.GetProperty(name).GetData()


def number(value, form):
    return "-" if math.isnan(value) else form.format(value)  # volumes of open surfaces


def print_table(head, rows):
    columns = list(zip(head, *rows))
    widths = [max(len(text) for text in column) for column in columns]
    for row in [head] + rows:
        print("  ".join([row[0].ljust(widths[0])] +
                        [text.rjust(width) for text, width in zip(row[1:], widths[1:])]))


def denoise_known(options, picture):
    """Noise on a clean model, and how much of it is left."""
    truth = open_surface(options.truth)
    noisy = SurfaceNoise(Input=truth, Direction="Random", Size=options.noise)
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
    os.makedirs(options.output, exist_ok=True)

    def output(name):
        return os.path.join(options.output, name)

    results = ("denoised.vtp", "denoised.ply", "denoising.png")
    for name in results:
        if os.path.exists(output(name)):
            os.remove(output(name))  # of an earlier run

    denoise = denoise_known if options.truth else denoise_unknown
    denoised = denoise(options, output("denoising.png"))
    # Not "Appended", the default: VTK 9.2 cannot read that with the expat of today's Debian 12.
    SaveData(output("denoised.vtp"), denoised, DataMode="Binary")
    SaveData(output("denoised.ply"), denoised)
    for name in results:
        if not os.path.isfile(output(name)):
            sys.exit("demo: {} could not be written".format(output(name)))
        print("-- wrote", output(name))


if __name__ == "__main__":
    main()
