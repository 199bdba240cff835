# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The survey's Table 2: what it says of each method, beside what is measured."""

import clouds
import meshes
import methods
from gallery import CURVE_ANGLE
from statements import AUTOMATIC, MESH_STATEMENTS, POINT_STATEMENTS
from surfaces import compare
from tables import markdown_table, number
from trials import Result, run

FEATURES = {"FeatureAngle": 30.0, "FeatureRings": 2}
NOTE = ("Near features is within 2 rings of faces around edges of more than 30\u00b0. Noise removed "
        "is how much less the mean {} is than before. ")
EDGE_NOTE = ("Edges kept are those edges of more than {:g}\u00b0 of the truth that still are such."
             .format(CURVE_ANGLE))
POINT_NOTE = "Distances are in thousandths of the diagonal of the truth."


class Kind:
    """How meshes, or clouds, are judged."""

    def __init__(self, module, listed, statements, quantities, factor, unit, form):
        self.module = module
        self.statements = statements
        self.methods = [method for caption in statements for method in listed
                        if method.caption == caption]
        self.methods += [method for method in listed if method.proxy == "DenoiseSurface"]
        self.mean, self.near, self.elsewhere = quantities
        self.factor = factor
        self.unit = unit
        self.form = form


MESHES = Kind(meshes, methods.METHODS, MESH_STATEMENTS,
              ("MeanNormalAngle", "FeatureNormalAngle", "SmoothNormalAngle"),
              1.0, "\u00b0", "{:.1f}")
CLOUDS = Kind(clouds, methods.POINT_METHODS, POINT_STATEMENTS,
              ("RelativeMeanDistance", "RelativeFeatureDistance", "RelativeSmoothDistance"),
              1000.0, "thousandths", "{:.2f}")


def run_all(kind, model):
    """The noisy model and all methods of the survey on it, with the parameters for its family."""
    noisy = clouds.bare_points(model.noisy) if kind is CLOUDS else model.noisy
    before = Result("Noisy")
    before.surface = noisy
    before.quantities = kind.module.measure(noisy, noisy, model.truth, **FEATURES)
    results = [before] + [run(kind.module, method, noisy, model.truth, model.family, **FEATURES)
                          for method in kind.methods]
    for result in results:
        if kind is MESHES and not result.failure:
            result.quantities["KeptEdges"] = kept_edges(result.surface, model.truth)
    return results


def kept_edges(surface, truth):
    """The share of the edges of the truth that meet at more than an angle and still do."""
    found = compare(surface, truth, FeatureAngle=CURVE_ANGLE)[1]
    edges = found["ReferenceFeatureEdges"]
    return 1.0 - found["MissedFeatureEdges"] / edges if edges else float("nan")


def removed(kind, before, result):
    return 1.0 - result.quantities[kind.mean] / before.quantities[kind.mean]


def table_of(kind, cad, cad_results, organic, organic_results):
    """Markdown: errors on the model with edges, and the share of the noise that goes on both."""
    head = ["method", "section and weights in the survey", "to be expected by it",
            "{}: near features ({})".format(cad.name, kind.unit), "elsewhere", "noise removed (%)"]
    head += ["edges kept (%)"] if kind is MESHES else []
    head.append("{}: noise removed (%)".format(organic.name))
    rows = []
    for result, other in zip(cad_results, organic_results):
        statement = kind.statements.get(result.caption, AUTOMATIC)
        row = [result.caption, "{}: {}".format(statement.section, statement.weights),
               statement.expected] if result.method else [result.caption, "", ""]
        if result.failure:
            row += ["failed: " + result.failure.replace("|", "/")] + ["-"] * (3 - (kind is CLOUDS))
        else:
            found = result.quantities
            row += [number(kind.factor * found[name], kind.form)
                    for name in (kind.near, kind.elsewhere)]
            row.append(number(100.0 * removed(kind, cad_results[0], result), "{:.0f}"))
            if kind is MESHES:
                row.append(number(100.0 * found["KeptEdges"], "{:.0f}"))
        row.append("failed" if other.failure else number(
            100.0 * removed(kind, organic_results[0], other), "{:.0f}"))
        rows.append(row)
    return markdown_table(head, rows, words=3)


def note(kind):
    """What the numbers in the table are."""
    text = NOTE.format("angle to the true normals" if kind is MESHES
                       else "distance from the true surface")
    return text + (EDGE_NOTE if kind is MESHES else POINT_NOTE)


def numbers_of(part, model, results):
    """Rows with all digits."""
    return [{"part": part, "model": model.name, "method": result.caption,
             "failure": result.failure, "seconds": result.seconds, **result.quantities}
            for result in results]
