# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Repeats the experiments of the survey "Surface Denoising based on Normal Filtering in a Robust
Statistics Framework".

    survey.py --fandisk NOISY TRUTH --nicola NOISY TRUTH
    survey.py --fandisk CLEAN --nicola CLEAN     models that get noise along their normals

Fandisk stands for objects with edges, Nicola for those without. Writes pictures, tables (survey.md)
and all numbers (survey.csv). What fails is told at the end, and the exit code is 1.
"""

import argparse

# Name of the option, family of parameters, noise in mean edge lengths, and view and up in the
# picture, which suit the files of the survey.
MODELS = (("fandisk", "cad", 0.3, (1.0, 0.9, -1.6), (0.0, 1.0, 0.0)),
          ("nicola", "organic", 0.2, (-1.0, 0.5, -0.1), (0.0, 1.0, 0.0)))


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
    parser.add_argument("-o", "--output", default="out", metavar="FOLDER",
                        help="where results go (out)")
    options = parser.parse_args()
    for name, *_ in MODELS:
        if len(getattr(options, name)) > 2:
            parser.error("--{} takes a noisy surface and the truth".format(name))
    return options


if __name__ == "__main__":
    parse_options()
