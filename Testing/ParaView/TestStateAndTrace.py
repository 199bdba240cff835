# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""State files, Python state and traces bring back the same points."""

from paraview import smstate, smtrace
from paraview.simple import (GetSources, LoadState, ResetSession, RobustNormalFilter, SaveState,
                             Sphere, SurfaceNoise)
from paraview.servermanager import Fetch
from vtkmodules.util.numpy_support import vtk_to_numpy


def build():
    sphere = Sphere(ThetaResolution=24, PhiResolution=24)
    noisy = SurfaceNoise(Input=sphere, Direction="Random", Size=0.25, Seed=7)
    return RobustNormalFilter(
        Input=noisy, Norm="Tukey", Argument="Angle", ScaleSource="Given", RangeScale=55.0,
        Operator="Diffusion", NumberOfOuterIterations=3, NumberOfNormalIterations=4)


def points():
    denoised, = (source for source in GetSources().values()
                 if source.GetXMLName() == "RobustNormalFilter")
    return vtk_to_numpy(Fetch(denoised).GetPoints().GetData()).copy()


def check_replay(replay, text):
    """In a new session, replay makes the pipeline again; the text sets what is not default."""
    for setting in ("Norm = 'Tukey'", "RangeScale = 55.0", "Operator = 'Diffusion'",
                    "Direction = 'Random'", "Seed = 7"):
        assert text is None or setting in text, (setting, text)
    ResetSession()
    assert not GetSources()
    replay()
    assert (points() == expected).all()


smtrace.start_trace()
build().UpdatePipeline()
trace = smtrace.stop_trace()
expected = points()
assert len(expected) > 500
SaveState("state.pvsm")
python_state = smstate.get_state()

check_replay(lambda: LoadState("state.pvsm"), None)
check_replay(lambda: exec(python_state, {}), python_state)
check_replay(lambda: exec(trace, {}), trace)
