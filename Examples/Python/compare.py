# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Denoises one surface or point cloud with every method, as compare_options.py says; run it with
pvpython, or through Examples/compare.sh."""

import os

import clouds
import meshes
import methods
from compare_options import parse_options
from sidebyside import Panel, save_contact_sheet
from surfaces import (add_noise, check_written, fail, has_polygons, open_surface,
                      output_files)
from tables import markdown_table, number, write_csv
from trials import Result, run


def choose_methods(options, noisy):
    """Whether points alone are compared, and the methods: what is not said depends on what is
    there."""
    points = options.points or not has_polygons(noisy) or (
        bool(options.methods) and all(map(methods.is_for_points, options.methods)))
    chosen = methods.of_kind(options.methods, points)
    on_points = [methods.is_for_points(method) for method in chosen]
    if points and not all(on_points):
        fail("{} wants polygons, not the points of {}".format(
            chosen[on_points.index(False)].caption, options.noisy or options.truth))
    if not points and any(on_points):
        fail("methods for surfaces and methods for points do not go into one table")
    return points, chosen or (methods.POINT_METHODS if points else methods.METHODS)


def table_of(results, columns):
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
    return markdown_table(head, rows)


def notes(kind, options, truth):
    """What the numbers in the table are."""
    lines = ["Parameters: {}.".format(options.parameters),
             kind.TRUTH_NOTE.format(rings=options.feature_rings, angle=options.feature_angle)
             if truth else kind.NO_TRUTH_NOTE]
    if options.truth:
        lines.append("Noise: {:g} mean edge lengths, in random directions.".format(options.noise))
    lines.append("Seconds are those of a single run.")
    return " ".join(lines)


def numbers_of(result):
    """A row with all digits; what is not known is empty or nan."""
    method = result.method
    proxies = [method.proxy] + [proxy for proxy, _ in method.then] if method else []
    return {"method": result.caption, "filter": " > ".join(proxies),
            "paper": method.paper if method else "",
            "peer": int(bool(method and methods.is_peer(method))),
            "settings": "; ".join("{}={}".format(*item) for item in result.settings.items()),
            "failure": result.failure, "seconds": repr(result.seconds),
            **{name: repr(float(value)) for name, value in result.quantities.items()}}


def main():
    options = parse_options()
    truth_file = options.truth or options.reference
    truth = open_surface(truth_file, polygons=False) if truth_file else None
    noisy = open_surface(options.noisy, polygons=False) if options.noisy else \
        add_noise(truth, options.noise)
    points, chosen = choose_methods(options, noisy)
    kind = clouds if points else meshes
    if truth and not (points or has_polygons(truth)):
        fail("{} holds no polygons".format(truth_file))
    if points:
        noisy = clouds.points_of(noisy) if options.noisy else clouds.bare_points(noisy)
    table_file, csv_file, picture = output_files(
        options.output, ("comparison.md", "comparison.csv", "comparison.png"))
    features = {"FeatureAngle": options.feature_angle, "FeatureRings": options.feature_rings}
    results = []
    if truth:
        before = Result("Noisy")
        before.surface = noisy
        try:
            before.quantities = kind.measure(noisy, noisy, truth, **features)
        except RuntimeError:
            fail("the noisy surface cannot be compared with the truth")
        results.append(before)
    results += [run(kind, method, noisy, truth, options.parameters, **features)
                for method in chosen]

    table = table_of(results, kind.WITH_TRUTH if truth else kind.WITHOUT_TRUTH)
    with open(table_file, "w", encoding="utf-8") as stream:
        stream.write("# {}\n\n{}\n\n{}\n\n![All results]({})\n".format(
            os.path.basename(options.noisy or options.truth), table, notes(kind, options, truth),
            os.path.basename(picture)))
    write_csv(csv_file, [numbers_of(result) for result in results])
    panels = [Panel(kind.shown(result.surface),
                    result.caption + (": " + kind.short_error(result.quantities) if truth else ""))
              for result in results if not result.failure]
    if truth:
        panels.insert(1, Panel(kind.shown(truth), "Truth"))
    else:
        panels.insert(0, Panel(kind.shown(noisy), "Input"))
    save_contact_sheet(picture, panels, options.view, options.up)
    print(table)
    check_written((table_file, csv_file, picture))
    failed = [result.caption for result in results if result.failure]
    if failed:
        fail("failed: {}".format(", ".join(failed)))


if __name__ == "__main__":
    main()
