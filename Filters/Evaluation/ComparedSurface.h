// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file ComparedSurface.h
 * @brief One of the two sides of a comparison, with what is needed of it more than once.
 *
 * A side without faces is a point cloud: all its points count. Of a surface, the points that its
 * faces use count.
 */

#ifndef SurfaceDenoising_ComparedSurface_h
#define SurfaceDenoising_ComparedSurface_h

#include "Metrics.h"
#include "PointMetrics.h"
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
  Buffer<Vec3>
    Points; ///< those that count; NaN in place of the others and of those that are nowhere

  std::size_t NumberOfVertices() const { return this->View.Mesh.NumberOfVertices(); }
  std::size_t NumberOfFaces() const { return this->View.Mesh.NumberOfFaces(); }

  bool IsCloud() const { return this->NumberOfFaces() == 0; }

  /// Moves the coordinates.
  void Shift(const Vec3& shift);

  /// Computes stars, census, geometry and points of the mesh in View.
  void Analyze(Execution& execution);

  /// Forgets the faces.
  void BecomeCloud(Execution& execution);

  /// True if there is a face with an area.
  bool HasArea() const;

  /// True if there is a point that counts.
  bool HasPoints() const;

  /// For distances to the faces.
  TriangleTree MakeTree() const { return { this->View.Mesh, this->Geometry.Areas }; }

  /// Diagonal of the bounding box of the points that count.
  double Diagonal() const;

  /// The volume inside, or NaN if there is no inside.
  double EnclosedVolume(Execution& execution) const;

  /// Replaces the values of vertices that do not count by NaN.
  void LeaveOutUnused(Buffer<double>& values) const;

  /// Statistics of the values of the vertices that count.
  Statistics SummarizeVertices(Buffer<double> values, Execution& execution) const;

  /**
   * Unit normals of the points, see GivenNormals and ReadNormals. False if there are none, or none
   * that can be read.
   */
  bool ReadPointNormals(Buffer<Vec3>& normals, Execution& execution) const;

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
NearestElements FindNearest(const TriangleTree& tree, const Buffer<Vec3>& positions,
  Execution& execution);

/// A named array of NaN.
vtkSmartPointer<vtkDoubleArray> MakeUndefinedArray(const char* name, vtkIdType size);

}

#endif
