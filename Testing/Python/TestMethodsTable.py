# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The readme and the comparison script have every method of the table of methods."""

import os
import sys

from surfacedenoising import vtkDenoisingMethods

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
sys.path.insert(0, os.path.join(ROOT, "Examples", "Python"))
sys.dont_write_bytecode = True
from methods import METHODS

with open(os.path.join(ROOT, "README.md"), encoding="utf-8") as file:
    table = [line for line in file if line.startswith("|")]

problems = []
rows = range(vtkDenoisingMethods.GetNumberOfMethods())
assert len(rows) >= 18, len(rows)
for row in rows:
    name, paper, proxy = (get(row) for get in (
        vtkDenoisingMethods.GetName, vtkDenoisingMethods.GetPaper, vtkDenoisingMethods.GetFilter))
    if not any("vtk" + proxy in line and paper in line for line in table):
        problems.append("README.md has no line for {}: vtk{}, {}".format(name, proxy, paper))
    if not any(entry.proxy == proxy and entry.paper == paper for entry in METHODS):
        problems.append("methods.py has no entry for {}: {}, {}".format(name, proxy, paper))

assert not problems, "\n" + "\n".join(problems)
