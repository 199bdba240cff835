# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""State files, Python state and traces bring back the same points."""

from paraview import simple, smstate, smtrace
from paraview.simple import GetSources, LoadState, ResetSession, SaveState, Sphere, SurfaceNoise
from paraview.servermanager import Fetch
from vtkmodules.util.numpy_support import vtk_to_numpy

# Filters, each once, with settings that are not the default.
FILTERS = {
    "RobustNormalFilter": {
        "Norm": "Tukey", "Argument": "Angle", "ScaleSource": "Given", "RangeScale": 55.0,
        "Operator": "Diffusion", "NumberOfOuterIterations": 3, "NumberOfNormalIterations": 4},
    "GuidedNormalFilter": {"RangeScale": 0.4, "Radius": 2.5, "NumberOfOuterIterations": 5},
    "MedianNormalFilter": {
        "MedianType": "Weighted", "EdgeRepetitions": 3, "VertexScheme": "Face Mean"},
    "BilateralNormalFilter": {"Scheme": "Global", "Fidelity": 0.02, "AreaEnergy": 0},
    "TukeyBilateralNormalFilter": {
        "AsReleased": 1, "NumberOfOuterIterations": 7, "Relaxation": 0.1},
    "GeometricFidelityNormalFilter": {"CurvatureType": "Edge", "FidelityWeight": 0.05},
    "MeanCurvatureFlowFilter": {"TimeStep": 0.07, "RestoreVolume": 1},
    "RobustPointNormalFilter": {
        "Norm": "Tukey", "Argument": "Angle", "RangeScale": 55.0, "Operator": "Voting Tensor",
        "NormalSource": "Plane Fit", "PositionScheme": "Quadric Fit", "PositionNorm": "Huber"},
    "MovingRobustPCAFilter": {
        "NormalAngle": 30.0, "Neighborhood": "Ball", "Radius": 2.5, "NumberOfOuterIterations": 2},
    "GuidedPointNormalFilter": {"UseSkeleton": 1, "NormalOrientation": "Spanning Tree"},
}


def build():
    sphere = Sphere(ThetaResolution=24, PhiResolution=24)
    noisy = SurfaceNoise(Input=sphere, Direction="Random", Size=0.25, Seed=7)
    return [getattr(simple, name)(Input=noisy, **settings) for name, settings in FILTERS.items()]


def points():
    """Of each filter, by its name."""
    return {source.GetXMLName(): vtk_to_numpy(Fetch(source).GetPoints().GetData()).copy()
            for source in GetSources().values() if source.GetXMLName() in FILTERS}


def check_replay(replay, text):
    """In a new session, replay makes the pipeline again; the text sets what is not default."""
    settings = ["Direction = 'Random'", "Seed = 7"]
    for changes in FILTERS.values():
        settings += ["{} = {!r}".format(*change) for change in changes.items()]
    for setting in settings:
        assert text is None or setting in text, (setting, text)
    ResetSession()
    assert not GetSources()
    replay()
    found = points()
    assert list(sorted(found)) == list(sorted(FILTERS)), list(found)
    for name in FILTERS:
        assert (found[name] == expected[name]).all(), name


smtrace.start_trace()
for result in build():
    result.UpdatePipeline()
trace = smtrace.stop_trace()
expected = points()
assert len(expected) == len(FILTERS), list(expected)
different = {array.tobytes() for array in expected.values()}
assert len(different) == len(FILTERS) and min(map(len, expected.values())) > 500
SaveState("state.pvsm")
python_state = smstate.get_state()

check_replay(lambda: LoadState("state.pvsm"), None)
check_replay(lambda: exec(python_state, {}), python_state)
check_replay(lambda: exec(trace, {}), trace)
