// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file ComparedSurface.h
 * @brief One of the two sides of a comparison, with what is needed of it more than once.
 */

#ifndef SurfaceDenoising_ComparedSurface_h
#define SurfaceDenoising_ComparedSurface_h

#include "Metrics.h"
#include "SurfaceAdapter.h"
#include "TriangleTree.h"

class vtkDoubleArray;

namespace SurfaceDenoising
{

struct ComparedSurface
{
  vtkPolyData* Data = nullptr;
  MeshView View;
  CompressedRows Stars;
  EdgeCensus Census;
  FaceGeometry Geometry;

  std::size_t NumberOfVertices() const { return this->View.Mesh.NumberOfVertices(); }
  std::size_t NumberOfFaces() const { return this->View.Mesh.NumberOfFaces(); }

  /// Computes stars, census and geometry of the mesh in View.
  void Analyze(Execution& execution);

  /// True if there is a face with an area.
  bool HasArea() const;

  /// For distances to the faces.
  TriangleTree MakeTree() const { return { this->View.Mesh, this->Geometry.Areas }; }

  /// Diagonal of the bounding box of the faces.
  double Diagonal() const;

  /// The volume inside, or NaN if there is no inside.
  double EnclosedVolume(Execution& execution) const;

  /// Statistics of the values of the vertices of faces; of all vertices if there are no faces.
  Statistics SummarizeVertices(Buffer<double> values, Execution& execution) const;

  /// For each cell the area-weighted mean of the values of its faces, NaN without any.
  vtkSmartPointer<vtkDoubleArray> CellMeans(const Buffer<double>& values, const char* name) const;
};

/// True if both have equally many points and the same polygons and strips.
bool HaveSameFaces(vtkPolyData* a, vtkPolyData* b);

/**
 * Replaces the triangles of the result by those of the reference, which has the same polygons: how
 * a polygon is cut depends on its shape, and faces correspond only if both are cut alike.
 */
void TriangulateAlike(const MeshView& reference, MeshView& result);

/// What TriangleTree::Nearest answers, for many positions.
struct NearestFaces
{
  Buffer<double> Distances;
  Buffer<Index> Faces;
};

NearestFaces FindNearest(const TriangleTree& tree, const Buffer<Vec3>& positions,
  Execution& execution);

/// A named array of NaN.
vtkSmartPointer<vtkDoubleArray> MakeUndefinedArray(const char* name, vtkIdType size);

}

#endif
