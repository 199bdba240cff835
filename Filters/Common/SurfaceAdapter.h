// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file SurfaceAdapter.h
 * @brief vtkPolyData in, triangle mesh out, and back: the only place that knows cell arrays.
 */

#ifndef SurfaceDenoising_SurfaceAdapter_h
#define SurfaceDenoising_SurfaceAdapter_h

#include "TriangleMesh.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <string>
#include <vector>

class vtkDataArray;
class vtkPoints;
class vtkPolyData;

namespace SurfaceDenoising
{

/**
 * The triangles of a polydata. Vertex v is point v; points without polygons are vertices without
 * faces. Polygons and strips are cut into triangles by VTK's own cells. Coordinates are relative to
 * Centre, the middle of the bounding box of the points in use, so that models far from the origin
 * lose no digits.
 */
struct MeshView
{
  TriangleMesh Mesh;
  Vec3 Centre = Vec3(0.0, 0.0, 0.0);

  /// Cell id of each triangle, ascending. Empty if triangle f is cell FirstCell + f.
  Buffer<vtkIdType> FaceCell;
  vtkIdType FirstCell = 0;

  vtkIdType CellOfFace(std::size_t f) const
  {
    return this->FaceCell.empty() ? this->FirstCell + static_cast<vtkIdType>(f) : this->FaceCell[f];
  }
};

/// True if there are polygons or strips, whatever their area; points without any are a cloud.
bool HasPolygons(vtkPolyData* data);

/**
 * Reads the polygons and strips of a surface. Fails with a message that names the culprit if a cell
 * refers to a point that does not exist, a point in use has a coordinate that is not finite, or
 * there are more than 4294967294 points or triangles. A surface without polygons is an empty mesh,
 * not an error.
 */
bool ReadSurface(vtkPolyData* surface, MeshView& view, std::string& error, Execution& execution);

/**
 * New points for a surface whose points moved to positions, which are relative to centre: the input
 * point plus the displacement, so that what did not move keeps its bits. Points are float if the
 * input's are, else double.
 */
vtkSmartPointer<vtkPoints> MovedPoints(vtkPolyData* surface, const Vec3& centre,
  const Buffer<Vec3>& positions, Execution& execution);

/// One unit vector per cell: the mean of the vectors of its triangles, weighted by area. Zero for
/// vertices and lines.
vtkSmartPointer<vtkDataArray> CellVectors(vtkPolyData* surface, const MeshView& view,
  const Buffer<Vec3>& faceVectors, const char* name, Execution& execution);

/**
 * The vectors of the triangles of each cell, normalised. Fails if the array has not three
 * components and one tuple per cell, or an entry is not finite. Zero vectors stay zero.
 */
bool ReadCellVectors(vtkDataArray* array, vtkPolyData* surface, const MeshView& view,
  Buffer<Vec3>& faceVectors, std::string& error);

/// The names of arrays that a filter adds.
struct AddedArrays
{
  std::vector<const char*> OfPoints;
  std::vector<const char*> OfCells;
  std::vector<const char*> OfAll; ///< field data
};

/// Passes the input on as it is where the filter adds nothing. Arrays of these names, which a
/// filter before has added, stay behind: they would be taken for this one's.
void PassUnchanged(vtkPolyData* input, const AddedArrays& added, vtkPolyData* output);

/**
 * Passes everything of the input on with new points. Active normals described the old points: they
 * stay among the arrays but are no longer active, so that nobody shades the new surface with them.
 */
void PassSurface(vtkPolyData* input, vtkPoints* points, vtkPolyData* output);

}

#endif
