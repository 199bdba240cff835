// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file PolygonGeometry.h
 * @brief Edges and normals of the polygons that a mesh was triangulated from.
 *
 * How a polygon was cut into triangles must not show in either.
 */

#ifndef SurfaceDenoising_PolygonGeometry_h
#define SurfaceDenoising_PolygonGeometry_h

#include "SurfaceAdapter.h"

namespace SurfaceDenoising
{

/**
 * Mean length of the edges of all polygons and strips, each edge counted once, without the
 * diagonals along which polygons were cut. 0 without edges.
 */
double MeanPolygonEdgeLength(vtkPolyData* surface, const MeshView& view, Execution& execution);

/**
 * Unit normals of the vertices: the sum of the area vectors (Newell) of the polygons and strip
 * triangles around them, normalised. Zero where the sum is.
 */
Buffer<Vec3> VertexNormals(vtkPolyData* surface, const MeshView& view, double scale);

}

#endif
