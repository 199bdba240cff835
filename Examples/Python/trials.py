# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Methods that have their turn on one noisy surface, and what is kept of each."""

import importlib
import sys
import time

from paraview.servermanager import Fetch

import methods
from surfaces import as_source, seconds_to_update


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


def make_peer(proxy, settings, noisy):
    """The output of a class of VTK as a source, and how long it took."""
    peer = getattr(importlib.import_module("vtkmodules.vtkFiltersCore"), proxy)()
    for name, value in settings.items():
        getattr(peer, "Set" + name)(value)
    peer.SetInputData(Fetch(noisy))
    start = time.perf_counter()
    peer.Update()
    seconds = time.perf_counter() - start
    source = as_source(peer.GetOutput())
    seconds_to_update(source)
    return source, seconds


def run(kind, method, noisy, truth, family, **features):
    """Whatever a method does wrong, the others get their turn. The kind is clouds or meshes;
    features say what is one."""
    result = Result(method.caption, method, methods.settings_for(method.settings, family))
    try:
        if methods.is_peer(method):
            result.surface, result.seconds = make_peer(method.proxy, result.settings, noisy)
        else:
            result.surface = methods.make_filters(method, family, noisy)
            result.seconds = seconds_to_update(result.surface)
        result.quantities = kind.measure(result.surface, noisy, truth, **features)
    except Exception as error:
        # ParaView may say more; the first sentence is enough for a table.
        result.failure = " ".join(str(error).split()).split(". ")[0] or type(error).__name__
        print("{}: {}".format(method.caption, result.failure), file=sys.stderr)
    return result
