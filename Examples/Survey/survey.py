# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Repeats the experiments of the survey "Surface Denoising based on Normal Filtering in a Robust
Statistics Framework", as survey_options.py says; run it with pvpython, or through
Examples/Survey/survey.sh."""

import os
import sys
from collections import namedtuple

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Python"))
from paraview.simple import SurfaceNoise

import gallery
import norms
import overview
import shrinkage
from surfaces import check_written, fail, open_surface, output_files
from survey_options import MODELS, parse_options
from tables import write_csv

Model = namedtuple("Model", "name noisy truth family view up")

FILES = ("survey.md", "survey.csv", "shrinkage-curves.png", "shrinkage.png", "nicola.png",
         "fandisk.png", "norms.png")
PAGE = """# The survey, repeated

{models}

![Change of volume]({curves})

![After {shown} iterations]({shrinkage})

![Nicola]({nicola})

![Fandisk]({fandisk})

![Norms]({norms})

{mesh_table}

{mesh_note}

{point_table}

{point_note}
"""


def open_model(options, name, family, noise):
    files = getattr(options, name)
    truth_file = files[-1]
    truth = open_surface(truth_file)
    noisy = open_surface(files[0]) if len(files) == 2 else \
        SurfaceNoise(Input=truth, Direction="Vertex Normals", Size=noise)
    title = name if len(files) == 2 else os.path.splitext(os.path.basename(truth_file))[0]
    return Model(title, noisy, truth, family,
                 getattr(options, name + "_view"), getattr(options, name + "_up"))


def describe(options):
    """Which files are denoised."""
    lines = []
    for name, _, noise, *_ in MODELS:
        files = [os.path.basename(file) for file in getattr(options, name)]
        known = "{} with the truth {}".format(*files) if len(files) == 2 else \
            "{} with noise of {:g} mean edge lengths along normals".format(files[0], noise)
        lines.append("{}: {}.".format(name.capitalize(), known))
    return " ".join(lines)


def main():
    options = parse_options()
    cad, organic = (open_model(options, *model[:3]) for model in MODELS)
    page, csv, curves, shrunk, nicola, fandisk, chart = output_files(options.output, FILES)
    try:
        rows, failed = shrinkage.draw(cad, curves, shrunk)
        tables = []
        for kind in (overview.MESHES, overview.CLOUDS):
            results = [overview.run_all(kind, model) for model in (cad, organic)]
            failed += [result.caption for group in results for result in group if result.failure]
            tables.append(overview.table_of(kind, cad, results[0], organic, results[1]))
            if kind is overview.MESHES:
                gallery.draw(fandisk, kind.module, cad, results[0], curves=True)
                gallery.draw(nicola, kind.module, organic, results[1])
            for model, group in zip((cad, organic), results):
                rows += overview.numbers_of("meshes" if kind is overview.MESHES else "points",
                                            model, group)
        norms.draw(chart)
    except RuntimeError as error:
        fail(error)
    with open(page, "w", encoding="utf-8") as stream:
        stream.write(PAGE.format(
            models=describe(options), shown=shrinkage.SHOWN, mesh_table=tables[0],
            mesh_note=overview.note(overview.MESHES), point_table=tables[1],
            point_note=overview.note(overview.CLOUDS),
            **{name: os.path.basename(file) for name, file in (
                ("curves", curves), ("shrinkage", shrunk), ("nicola", nicola),
                ("fandisk", fandisk), ("norms", chart))}))
    write_csv(csv, rows)
    print("\n\n".join(tables))
    check_written((page, csv, curves, shrunk, nicola, fandisk, chart))
    if failed:
        fail("failed: {}".format(", ".join(dict.fromkeys(failed))))


if __name__ == "__main__":
    main()
