# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Options that the examples share. What reads a command line does without ParaView, so that help is
there before anything is installed."""


def add_noise_options(parser):
    parser.add_argument("--truth", metavar="FILE", help="clean surface that gets noise")
    parser.add_argument("--noise", type=float, default=0.3, metavar="SIZE",
                        help="standard deviation of the noise in mean edge lengths (0.3)")
    parser.add_argument("--points", action="store_true",
                        help="take the points of the surface alone; so do methods for points")


def add_output_options(parser):
    parser.add_argument("--view", type=float, nargs=3, default=(1.0, -1.6, 0.9),
                        metavar=("X", "Y", "Z"), help="direction from the model to the camera")
    parser.add_argument("--up", type=float, nargs=3, default=(0.0, 0.0, 1.0),
                        metavar=("X", "Y", "Z"), help="what is up in the picture")
    parser.add_argument("-o", "--output", default="out", metavar="FOLDER",
                        help="where results go (out)")
