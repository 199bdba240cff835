# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Repeats the experiments of the survey "Surface Denoising based on Normal Filtering in a Robust
Statistics Framework"; run it with pvpython, or through Examples/Survey/survey.sh.

    survey.py --fandisk NOISY TRUTH --nicola NOISY TRUTH
    survey.py --fandisk CLEAN --nicola CLEAN     models that get noise along their normals

Fandisk stands for objects with edges, Nicola for those without. Writes pictures, tables (survey.md)
and all numbers (survey.csv). What fails is told at the end, and the exit code is 1.
"""

import argparse
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
from tables import write_csv

Model = namedtuple("Model", "name noisy truth family view up")

# Name of the option, family of parameters, noise in mean edge lengths, and view and up in the
# picture, which suit the files of the survey.
MODELS = (("fandisk", "cad", 0.3, (1.0, 0.9, -1.6), (0.0, 1.0, 0.0)),
          ("nicola", "organic", 0.2, (-1.0, 0.5, -0.1), (0.0, 1.0, 0.0)))
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


def parse_options():
    parser = argparse.ArgumentParser(prog="survey", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    for name, _, noise, view, up in MODELS:
        parser.add_argument("--" + name, nargs="+", required=True, metavar="FILE",
                            help="noisy surface and truth; or the truth alone, which gets noise of "
                            "{:g} mean edge lengths".format(noise))
        parser.add_argument("--{}-view".format(name), type=float, nargs=3, default=view,
                            metavar=("X", "Y", "Z"), help="direction from the model to the camera")
        parser.add_argument("--{}-up".format(name), type=float, nargs=3, default=up,
                            metavar=("X", "Y", "Z"), help="what is up in the picture")
    parser.add_argument("-o", "--output", default="out", metavar="FOLDER")
    options = parser.parse_args()
    for name, *_ in MODELS:
        if len(getattr(options, name)) > 2:
            parser.error("--{} takes a noisy surface and the truth".format(name))
    return options


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
