// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file SurfaceTriangulation.h
 * @brief The triangles that the polygons and strips of a polydata are made of.
 */

#ifndef SurfaceDenoising_SurfaceTriangulation_h
#define SurfaceDenoising_SurfaceTriangulation_h

#include "SurfaceAdapter.h"

namespace SurfaceDenoising
{

/**
 * Fills the triangles of the view and their cells. Triangles are copied, polygons with more points
 * are cut by clipping ears, strips into their triangles. A polygon that VTK cannot cut becomes a
 * fan, one of fewer than three points nothing. Fails if a cell refers to a point that does not
 * exist.
 */
bool ReadTriangles(vtkPolyData* surface, MeshView& view, std::string& error, Execution& execution);

}

#endif
