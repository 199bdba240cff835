// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file FaceCurvature.h
 * @brief How strongly a surface is curved at its faces.
 */

#ifndef SurfaceDenoising_FaceCurvature_h
#define SurfaceDenoising_FaceCurvature_h

#include "TriangleMesh.h"

namespace SurfaceDenoising
{

/**
 * The mean of the curvatures at the three vertices of each face, in 1 / length. The curvature at a
 * vertex is its absolute mean curvature, |sum_f n_f x (r - q) / 2| / (2 M) over the faces f = (v,
 * q, r) of its star with normals n_f, with a third of the star's area as M: the area gradient over
 * the vertex's share. A vertex on the boundary has the mean of its neighbours inside, or 0.
 */
Buffer<double> FaceCurvatures(const TriangleMesh& mesh, const CompressedRows& stars,
  const Buffer<unsigned char>& boundary, const FaceGeometry& geometry, Execution& execution);

}

#endif
