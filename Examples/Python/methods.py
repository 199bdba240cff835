# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The methods that compare.py compares, with the parameters that each gets: METHODS for surfaces,
POINT_METHODS for point clouds."""

from collections import namedtuple

# proxy     the filter; a name that starts with vtk is a class of VTK, which runs outside ParaView's
#           pipeline as a peer
# caption   what the method is called in the table and in the picture, unlike any other
# paper     who published it
# settings  values of properties by the family of models that they suit: those of "default" hold for
#           all, those of "cad" (sharp edges, flat sides) and "organic" (faces, figures, scans)
#           come on top; a family that is not there has nothing of its own
# then      further filters after it: pairs of a proxy and its settings, by family as above
Method = namedtuple("Method", "proxy caption paper settings then", defaults=((),))

#
# "automatic" is no family: all that OPEN names is chosen from the data.
FAMILIES = ("default", "cad", "organic", "automatic")

# Properties of which 0 means that the value is chosen from the data.
OPEN = {"RangeScale", "SpatialScale", "Radius", "HeightScale", "NormalAngle", "AngleThreshold",
        "FilterScale", "NormalScale", "Range", "PositionRangeScale", "PositionSpatialScale",
        "TimeStep", "EdgeThreshold", "NumberOfRolls", "NumberOfNeighbors",
        "NumberOfNormalNeighbors", "NumberOfIterations", "NumberOfOuterIterations",
        "NumberOfNormalIterations", "NumberOfVertexIterations", "NumberOfPointIterations"}

# Tukey's norm weighs the normals as max(0, n . n' - T)^2 does: the scale is sqrt(2 (1 - T)).
COSINE = {"Norm": "Tukey", "ScaleSource": "Given", "RangeScale": 1.0, "SpatialScale": -1.0,
          "FaceWeighting": "Uniform", "NumberOfNormalIterations": 20,
          "NumberOfVertexIterations": 50}

METHODS = [
    Method("NormalDiffusionFilter", "Normal diffusion", "Belyaev, Ohtake 2001", {
        "default": {},
        "cad": {"RangeScale": 40.0, "NumberOfOuterIterations": 40, "NumberOfVertexIterations": 10},
        "organic": {"RangeScale": 90.0, "NumberOfOuterIterations": 3,
                    "NumberOfVertexIterations": 10, "Neighborhood": "Vertex Sharing"},
    }),
    Method("MeanNormalFilter", "Mean normal", "Yagou, Ohtake, Belyaev 2002", {
        "default": {},
    }),
    Method("MedianNormalFilter", "Median normal", "Yagou, Ohtake, Belyaev 2002", {
        "default": {},
        "cad": {"NumberOfOuterIterations": 40},
        "organic": {"MedianType": "Directional", "NumberOfOuterIterations": 20},
    }),
    Method("MedianNormalFilter", "Weighted median", "Yagou, Belyaev, Wei 2002", {
        "default": {"MedianType": "Weighted"},
        "cad": {"NumberOfOuterIterations": 40},
        "organic": {"NumberOfOuterIterations": 20},
    }),
    Method("HuberNormalFilter", "Huber normal", "Huber 1981", {
        "default": {},
        "cad": {"RangeScale": 0.03, "NumberOfNormalIterations": 20, "NumberOfVertexIterations": 10},
        "organic": {"NumberOfNormalIterations": 10, "SpatialScale": 1.0,
                    "NumberOfVertexIterations": 10},
    }),
    Method("NormalVotingTensorFilter", "Voting tensor", "Yadav, Reitebuch, Polthier 2017", {
        "default": {},
        "cad": {"TensorThreshold": 0.15, "NumberOfOuterIterations": 100},
        "organic": {"TensorThreshold": 0.3, "NumberOfOuterIterations": 60},
    }),
    Method("FuzzyVectorMedianNormalFilter", "Fuzzy vector median", "Shen, Barner 2004", {
        "default": {},
        "cad": {"RangeScale": 0.25, "NumberOfOuterIterations": 20, "NumberOfVertexIterations": 5,
                "AreaWeighting": 1},
        "organic": {"RangeScale": 1.1, "NumberOfOuterIterations": 2, "AreaWeighting": 1},
    }),
    Method("CurvatureNormalDiffusionFilter", "Curvature diffusion",
           "Tasdizen, Whitaker, Burchard, Osher 2002", {
               "default": {},
               "cad": {"RangeScale": 0.6, "NumberOfOuterIterations": 15,
                       "NumberOfNormalIterations": 10},
               "organic": {"RangeScale": 1.0, "NumberOfOuterIterations": 1},
           }),
    Method("GeometricFidelityNormalFilter", "Geometric fidelity", "Centin, Signoroni 2018", {
        "default": {},
        "cad": {"CurvatureType": "Edge", "RangeScale": 0.3, "NumberOfOuterIterations": 40},
        "organic": {"RangeScale": 0.5, "NumberOfOuterIterations": 5},
    }),
    Method("BilateralNormalFilter", "Bilateral normal", "Zheng, Fu, Au, Tai 2011", {
        "default": {},
        "cad": {"NumberOfVertexIterations": 20},
        "organic": {"RangeScale": 0.5, "NumberOfNormalIterations": 4, "NumberOfVertexIterations": 7},
    }),
    Method("BilateralNormalFilter", "Global bilateral", "Zheng, Fu, Au, Tai 2011", {
        "default": {"Scheme": "Global"},
        "cad": {"Fidelity": 0.0003},
        "organic": {"RangeScale": 1.0, "Fidelity": 0.03},
    }),
    Method("GuidedNormalFilter", "Guided normal", "Zhang, Deng, Zhang, Bouaziz, Liu 2015", {
        "default": {},
        "cad": {"RangeScale": 0.2, "NumberOfOuterIterations": 50},
        "organic": {"RangeScale": 0.6, "NumberOfOuterIterations": 6, "NumberOfVertexIterations": 3},
    }),
    Method("TukeyBilateralNormalFilter", "Tukey bilateral", "Yadav, Reitebuch, Polthier 2018", {
        "default": {},
        "cad": {"RangeScale": 1.0, "NumberOfOuterIterations": 60, "Relaxation": 0.05},
        "organic": {"RangeScale": 1.0, "NumberOfOuterIterations": 10},
    }),
    Method("RobustNormalFilter", "Thresholded cosine", "Sun, Rosin, Martin, Langbein 2007", {
        "default": COSINE,
        "cad": {"NumberOfNormalIterations": 15, "NumberOfVertexIterations": 12},
        "organic": {"RangeScale": 1.3, "NumberOfNormalIterations": 4,
                    "NumberOfVertexIterations": 5},
    }),
    # A wide scale sorts the faces into sides and rounds nothing off that is sharp; a narrow one then
    # flattens each side. No paper has it.
    Method("TukeyBilateralNormalFilter", "Tukey, wide then narrow", "composed", {
        "default": {"RangeScale": 1.0, "NumberOfOuterIterations": 30, "Relaxation": 0.05},
        "organic": {"NumberOfOuterIterations": 10, "Relaxation": 0.2},
    }, [("RobustNormalFilter", {
        "default": {**COSINE, "RangeScale": 0.2},
        "organic": {"NumberOfNormalIterations": 1, "NumberOfVertexIterations": 5},
    })]),
    Method("MeanCurvatureFlowFilter", "Mean curvature flow", "Desbrun, Meyer, Schroeder, Barr 1999", {
        "default": {},
        "organic": {"TimeStep": 0.1, "NumberOfIterations": 5},
    }),
    Method("AnisotropicMeanCurvatureFilter", "Anisotropic flow", "Hildebrandt, Polthier 2004", {
        "default": {},
        "cad": {"NumberOfIterations": 40, "EdgeThreshold": 0.3},
    }),
    Method("BilateralVertexFilter", "Bilateral vertex", "Fleishman, Drori, Cohen-Or 2003", {
        "default": {},
        "cad": {"RangeScale": 1.5},
        "organic": {"RangeScale": 2.0, "NumberOfIterations": 3},
    }),
    Method("NonIterativeBilateralFilter", "Non-iterative bilateral", "Jones, Durand, Desbrun 2003", {
        "default": {},
        "cad": {"SpatialScale": 1.5},
        "organic": {"SpatialScale": 1.5},
    }),
    Method("DenoiseSurface", "Denoise Surface (automatic)", "composed", {
        "default": {},
    }),
    Method("vtkWindowedSincPolyDataFilter", "Windowed sinc (VTK)",
           "Taubin, Zhang, Golub 1996", {
               "default": {"NormalizeCoordinates": 1},
           }),
]

# They filter the points of a cloud, or those of a surface as if it had no polygons. The first can
# be composed. What the others are called is their name in the table of the C++ library.
POINT_METHODS = [
    Method("RobustPointNormalFilter", "Robust point normal", "composed", {
        "default": {},
        "cad": {"RangeScale": 0.15, "NumberOfNormalIterations": 10},
        "organic": {"RangeScale": 0.5, "NumberOfNormalIterations": 1, "NumberOfPointIterations": 2},
    }),
    Method("RobustImplicitMLSFilter", "Robust implicit MLS", "Oztireli, Guennebaud, Gross 2009", {
        "default": {},
        "cad": {"FilterScale": 4.0, "NormalScale": 0.3},
        "organic": {"NormalScale": 0.3},
    }),
    Method("MovingRobustPCAFilter", "Moving robust PCA", "Mattei, Castrodad 2017", {
        "default": {},
        "cad": {"NumberOfOuterIterations": 3},
        "organic": {"NumberOfOuterIterations": 1},
    }),
    Method("FeatureAwarePointFilter", "Feature-aware point", "Li 2009", {
        "default": {},
        "cad": {"FeatureSharpening": 0.9, "NumberOfOuterIterations": 8},
    }),
    Method("TensorPointFilter", "Tensor point", "Park, Lee, Jang, Lee, Lee 2013", {
        "default": {},
        "cad": {"FeatureThreshold": 0.5, "NumberOfOuterIterations": 2},
        "organic": {"FeatureThreshold": 0.7, "NumberOfOuterIterations": 1},
    }),
    Method("BilateralPointFilter", "Bilateral point", "Digne, de Franchis 2017", {
        "default": {},
        "cad": {"HeightScale": 0.3, "NumberOfOuterIterations": 3},
        "organic": {"HeightScale": 0.5},
    }),
    Method("RollingPointNormalFilter", "Rolling point normal", "Zheng, Li, Xu, Wu, Nie 2018", {
        "default": {},
        "cad": {"NumberOfRolls": 6},
        "organic": {"NumberOfRolls": 2, "NumberOfPointIterations": 3},
    }),
    Method("MovingLeastSquaresFilter", "Moving least squares",
           "Alexa, Behr, Cohen-Or, Fleishman, Levin, Silva 2003", {
               "default": {},
               "organic": {"NumberOfOuterIterations": 2},
           }),
    Method("GuidedPointNormalFilter", "Guided point normal", "Zheng, Li, Wu, Liu, Gao 2017", {
        "default": {},
        "cad": {"RangeScale": 0.2},
        "organic": {"RangeScale": 0.5, "NumberOfNormalIterations": 1,
                    "NumberOfPointIterations": 3},
    }),
    Method("VotingTensorPointFilter", "Voting tensor point",
           "Yadav, Reitebuch, Skrodzki, Zimmermann, Polthier 2018", {
               "default": {},
               "cad": {"NumberOfOuterIterations": 12},
           }),
    Method("DenoiseSurface", "Denoise Surface (automatic, points)", "composed", {
        "default": {"PointsOnly": 1},
    }),
]


def is_peer(method):
    return method.proxy.startswith("vtk")


def is_for_points(method):
    return method in POINT_METHODS


def of_kind(chosen, points):
    """The methods without those that are for the other kind of data, of filters that are chosen for
    both: the name of the filter stands for the one that fits."""
    proxies = [method.proxy for method in chosen if is_for_points(method) == points]
    return [method for method in chosen
            if is_for_points(method) == points or method.proxy not in proxies]


def settings_for(settings, family):
    return {**settings["default"], **settings.get(family, {})}


def make_filters(method, family, surface, overrides=None):
    """The last of the filters of a method, none of which has been executed. Overrides are settings
    of the first, and not for what is automatic."""
    from paraview import simple  # here, since the list is of use without ParaView
    settings = {**settings_for(method.settings, family), **(overrides or {})}
    for proxy, values in [(method.proxy, settings)] + [
            (proxy, settings_for(values, family)) for proxy, values in method.then]:
        make = getattr(simple, proxy, None)
        if not make:
            raise ValueError("there is no filter {}".format(proxy))
        surface = make(Input=surface, **values)
        if family == "automatic" and not is_peer(method):
            for name in OPEN & set(surface.ListProperties()):
                setattr(surface, name, 0)
    return surface


def captions(peers=True):
    """What can be asked for, for people."""
    return "; for points: ".join(
        ", ".join(method.caption for method in group if peers or not is_peer(method))
        for group in (METHODS, POINT_METHODS))


def find_methods(names):
    """The methods called so, by caption or filter, in the order of the lists; spaces and capitals
    do not count. ValueError if one is not there."""
    def key(name):
        return name.lower().replace(" ", "")

    wanted = {key(name): name for name in names}
    keys = [{key(method.caption), key(method.proxy)} for method in METHODS + POINT_METHODS]
    missing = [name for name in wanted if not any(name in known for known in keys)]
    if missing:
        raise ValueError("there is no method {}; there are {}".format(
            ", ".join(wanted[name] for name in missing), captions()))
    return [method for method, known in zip(METHODS + POINT_METHODS, keys)
            if known & wanted.keys()]
