// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file PointAdapter.h
 * @brief The points of a vtkPolyData in, a point cloud out, and back.
 */

#ifndef SurfaceDenoising_PointAdapter_h
#define SurfaceDenoising_PointAdapter_h

#include "Points/PointDenoising.h"

#include <string>

class vtkDataArray;
class vtkPolyData;

namespace SurfaceDenoising
{

struct PointView
{
  PointCloud Cloud;                  ///< positions are relative to Centre
  Vec3 Centre = Vec3(0.0, 0.0, 0.0); ///< the middle of the bounding box of the finite points
};

/**
 * Reads an array of normals of the points as unit vectors; zero and infinite ones become zero,
 * which is no normal. Fails with a message if the array has not three components and a tuple per
 * point.
 */
bool ReadNormals(vtkDataArray* array, vtkPolyData* data, Buffer<Vec3>& normals, std::string& error,
  Execution& execution);

/**
 * Reads all points, whether cells use them or not, and the normals of an array (or of none if it is
 * null). Fails with a message if there are more than 4294967294 points, if the extent is beyond
 * double precision, or if ReadNormals fails.
 */
bool ReadPoints(vtkPolyData* data, vtkDataArray* normals, PointView& view, std::string& error,
  Execution& execution);

/// The array with the normals that the points came with: the active one, or of a point cloud one of
/// three components that is called "Normals". (On a surface, such an array is what a filter left of
/// the surface before.) Null if there is none.
vtkDataArray* GivenNormals(vtkPolyData* data, bool isCloud);

/// Normals of the points from the polygons and strips around them, means weighted by area; zero for
/// points without polygons. Empty if there are no polygons or if they cannot be read.
Buffer<Vec3> NormalsOfFaces(vtkPolyData* data, Execution& execution);

/**
 * Passes everything of the input on with new points, the active point array "Normals", and the
 * arrays "Displacement" (how far each point moved), "Status" (see vtkPointDenoisingFilter) and, if
 * the cloud has classes, "FeatureClass".
 */
void PassPoints(vtkPolyData* input, const PointView& view, vtkPolyData* output,
  Execution& execution);

}

#endif
