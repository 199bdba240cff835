# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The readme and the comparison script have every method of the tables of methods."""

import os
import sys

from surfacedenoising import vtkDenoisingMethods, vtkPointDenoisingMethods

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
sys.path.insert(0, os.path.join(ROOT, "Examples", "Python"))
sys.dont_write_bytecode = True
from methods import METHODS, POINT_METHODS

with open(os.path.join(ROOT, "README.md"), encoding="utf-8") as file:
    table = [line for line in file if line.startswith("|")]

problems = []
for methods, entries, least in ((vtkDenoisingMethods, METHODS, 18),
                                (vtkPointDenoisingMethods, POINT_METHODS, 9)):
    rows = range(methods.GetNumberOfMethods())
    assert len(rows) >= least, len(rows)
    for row in rows:
        name, paper, proxy = (get(row) for get in (
            methods.GetName, methods.GetPaper, methods.GetFilter))
        if not any("vtk" + proxy in line and paper in line for line in table):
            problems.append("README.md has no line for {}: vtk{}, {}".format(name, proxy, paper))
        if not any(entry.proxy == proxy and entry.paper == paper for entry in entries):
            problems.append("methods.py has no entry for {}: {}, {}".format(name, proxy, paper))
captions = [entry.caption.lower() for entry in METHODS + POINT_METHODS]
problems += ["two methods are called {}".format(caption) for caption in set(captions)
             if captions.count(caption) > 1]

assert not problems, "\n" + "\n".join(problems)
