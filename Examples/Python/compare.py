# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Denoises one surface with every method; run it with pvpython, or through Examples/compare.sh.

    compare.py NOISY TRUTH       how far each result is from the truth
    compare.py --truth CLEAN     the same, with noise that is added to a clean model
    compare.py NOISY             how far each method moves the points

Writes a table (comparison.md; comparison.csv has all numbers) and a picture (comparison.png) of all
results. A method that fails is marked in the table, and the exit code is 1.
"""

import argparse
import csv
import importlib
import os
import sys
import time

import numpy
from paraview import simple
from paraview.servermanager import Fetch
from vtkmodules.util.numpy_support import vtk_to_numpy

import methods
from sidebyside import Panel, save_contact_sheet
from surfaces import (add_noise, add_noise_options, add_output_options, check_written, fail, number,
                      open_surface, output_files, report, seconds_to_update)


class Result:
    """What became of a surface, in numbers, or why nothing did."""

    def __init__(self, caption, method=None, settings=None):
        self.caption = caption
        self.method = method
        self.settings = settings or {}
        self.surface = None
        self.seconds = float("nan")
        self.quantities = {}
        self.failure = ""


# Columns of the table: what they are called, a quantity, what it is multiplied by, how it is
# written. The seconds come last.
WITH_TRUTH = [("mean angle (\u00b0)", "MeanNormalAngle", 1.0, "{:.2f}"),
              ("near features (\u00b0)", "FeatureNormalAngle", 1.0, "{:.2f}"),
              ("elsewhere (\u00b0)", "SmoothNormalAngle", 1.0, "{:.2f}"),
              ("E_v x 1000", "RelativePositionError", 1000.0, "{:.3f}"),
              ("volume change (%)", "RelativeVolumeChange", 100.0, "{:+.3f}"),
              ("flipped faces", "FlippedFaces", 1.0, "{:.0f}")]
WITHOUT_TRUTH = [("mean displacement (edge lengths)", "MeanDisplacement", 1.0, "{:.3f}"),
                 ("volume change (%)", "RelativeVolumeChange", 100.0, "{:+.3f}")]


def parse_options():
    parser = argparse.ArgumentParser(prog="compare", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("noisy", nargs="?", help="noisy surface: PLY OBJ STL OFF VTP VTK")
    parser.add_argument("reference", metavar="truth", nargs="?", help="what it should be")
    add_noise_options(parser)
    parser.add_argument("--methods", nargs="+", default=[], metavar="NAME",
                        help="only these: " + ", ".join(m.caption for m in methods.METHODS))
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


def make_peer(proxy, settings, noisy):
    """The output of a class of VTK as a source, and how long it took."""
    peer = getattr(importlib.import_module("vtkmodules.vtkFiltersCore"), proxy)()
    for name, value in settings.items():
        getattr(peer, "Set" + name)(value)
    peer.SetInputData(Fetch(noisy))
    start = time.perf_counter()
    peer.Update()
    seconds = time.perf_counter() - start
    source = simple.PVTrivialProducer()
    source.GetClientSideObject().SetOutput(peer.GetOutput())
    seconds_to_update(source)
    return source, seconds


def compare(surface, reference, options):
    """All quantities of the comparison by name."""
    comparison = simple.SurfaceComparison(
        Input=surface, Reference=reference, FeatureAngle=options.feature_angle,
        FeatureRings=options.feature_rings)
    comparison.UpdatePipeline()
    table = Fetch(comparison, idx=1)
    if not (table and table.GetNumberOfRows()):
        raise RuntimeError("the result cannot be compared")
    return {table.GetColumnName(i): table.GetColumn(i).GetValue(0)
            for i in range(table.GetNumberOfColumns())}


def points_of(surface):
    return vtk_to_numpy(Fetch(surface).GetPoints().GetData()).astype(float)


def measure(surface, noisy, truth, options):
    """The quantities that a result is judged by."""
    if truth:
        return compare(surface, truth, options)
    moved = numpy.linalg.norm(points_of(surface) - points_of(noisy), axis=1)
    edge = report(add_noise(noisy, 0.0), "UnitLength")
    return {"MeanDisplacement": moved.mean() / edge,
            "RelativeVolumeChange": compare(surface, noisy, options)["RelativeVolumeChange"]}


def run(method, noisy, truth, options):
    """Whatever a method does wrong, the others get their turn."""
    family = options.parameters
    result = Result(method.caption, method, methods.settings_for(method.settings, family))
    try:
        if methods.is_peer(method):
            result.surface, result.seconds = make_peer(method.proxy, result.settings, noisy)
        else:
            result.surface = methods.make_filters(method, family, noisy)
            result.seconds = seconds_to_update(result.surface)
        result.quantities = measure(result.surface, noisy, truth, options)
    except Exception as error:
        # ParaView may say more; the first sentence is enough for a table.
        result.failure = " ".join(str(error).split()).split(". ")[0] or type(error).__name__
        print("{}: {}".format(method.caption, result.failure), file=sys.stderr)
    return result


def markdown_table(results, columns):
    head = ["method", "paper"] + [title for title, *_ in columns] + ["seconds"]
    rows = []
    for result in results:
        name = result.caption
        if result.method and methods.is_peer(result.method):
            name += ", peer"
        row = [name, result.method.paper if result.method else ""]
        if result.failure:
            row += ["failed: " + result.failure.replace("|", "/")] + ["-"] * len(columns)
        else:
            row += [number(factor * result.quantities[quantity], form)
                    for _, quantity, factor, form in columns]
            row.append(number(result.seconds, "{:.2f}"))
        rows.append(row)
    # A reason for a failure may be long; it does not make its column so.
    widths = [max(len(text) for text in column if not text.startswith("failed"))
              for column in zip(head, *rows)]
    rule = ["-" * width if i < 2 else "-" * (width - 1) + ":" for i, width in enumerate(widths)]
    return "\n".join(
        "| " + " | ".join(text.ljust(width) if i < 2 else text.rjust(width)
                          for i, (text, width) in enumerate(zip(row, widths))) + " |"
        for row in [head, rule] + rows)


def notes(options, truth):
    """What the numbers in the table are."""
    lines = ["Parameters: {}.".format(options.parameters)]
    if truth:
        lines.append("Angles are means over the angles between the normals of the faces and the "
                     "true ones; near features is within {} rings of faces around edges of more "
                     "than {:g}\u00b0. E_v is the distance of the points from the truth, in "
                     "thousandths of its diagonal.".format(options.feature_rings,
                                                           options.feature_angle))
    else:
        lines.append("There is no truth: displacement and change of volume are against the input.")
    if options.truth:
        lines.append("Noise: {:g} mean edge lengths, in random directions.".format(options.noise))
    lines.append("Seconds are those of a single run.")
    return " ".join(lines)


def write_csv(file, results):
    """All numbers that there are, with all digits; what is not known is empty or nan."""
    quantities = max((list(result.quantities) for result in results), key=len)
    with open(file, "w", newline="", encoding="utf-8") as stream:
        writer = csv.writer(stream)
        writer.writerow(["method", "filter", "paper", "peer", "settings", "failure", "seconds"] +
                        quantities)
        for result in results:
            method = result.method
            settings = "; ".join("{}={}".format(*item) for item in result.settings.items())
            proxies = " > ".join([method.proxy] + [proxy for proxy, _ in method.then]) \
                if method else ""
            writer.writerow([result.caption, proxies,
                             method.paper if method else "",
                             int(bool(method and methods.is_peer(method))), settings,
                             result.failure, repr(result.seconds)] +
                            [repr(result.quantities[name]) if name in result.quantities else ""
                             for name in quantities])


def caption(result, truth):
    if truth:
        return "{}: {:.1f}\u00b0".format(result.caption, result.quantities["MeanNormalAngle"])
    return result.caption


def main():
    options = parse_options()
    truth_file = options.truth or options.reference
    truth = open_surface(truth_file) if truth_file else None
    noisy = open_surface(options.noisy) if options.noisy else add_noise(truth, options.noise)
    table_file, csv_file, picture = output_files(
        options.output, ("comparison.md", "comparison.csv", "comparison.png"))
    results = []
    if truth:
        before = Result("Noisy")
        before.surface = noisy
        try:
            before.quantities = compare(noisy, truth, options)
        except RuntimeError:
            fail("the noisy surface cannot be compared with the truth")
        results.append(before)
    results += [run(method, noisy, truth, options) for method in options.methods]

    table = markdown_table(results, WITH_TRUTH if truth else WITHOUT_TRUTH)
    with open(table_file, "w", encoding="utf-8") as stream:
        stream.write("# {}\n\n{}\n\n{}\n\n![All results]({})\n".format(
            os.path.basename(options.noisy or options.truth), table, notes(options, truth),
            os.path.basename(picture)))
    write_csv(csv_file, results)
    panels = [Panel(result.surface, caption(result, truth))
              for result in results if not result.failure]
    panels.insert(1 if truth else 0, Panel(truth or noisy, "Truth" if truth else "Input"))
    save_contact_sheet(picture, panels, options.view, options.up)
    print(table)
    check_written((table_file, csv_file, picture))
    failed = [result.caption for result in results if result.failure]
    if failed:
        fail("failed: {}".format(", ".join(failed)))


if __name__ == "__main__":
    main()
