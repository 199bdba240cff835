// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file Metrics.h
 * @brief How far one surface is from another, in numbers.
 *
 * Angles are in degrees. A quantity that is not defined for its arguments is not a number (NaN),
 * never a zero that looks like a perfect result.
 */

#ifndef SurfaceDenoising_Metrics_h
#define SurfaceDenoising_Metrics_h

#include "NeighborGraph.h"
#include "TriangleMesh.h"

namespace SurfaceDenoising
{

/**
 * Angle between two vectors in degrees, from 0 to 180, accurate for small angles too. NaN if a
 * vector is zero, as the normal of a degenerate face is.
 */
double AngleBetween(const Vec3& a, const Vec3& b);

/// A sample of numbers in a few numbers. All but Count are NaN for an empty sample.
struct Statistics
{
  std::size_t Count = 0; ///< values that are numbers; the others are left out of everything below
  double Mean;
  double RootMeanSquare;
  double Median;       ///< Percentile(0.5)
  double Percentile95; ///< Percentile(0.95)
  double Maximum;
  double WeightedMean; ///< sum w_i x_i / sum w_i; NaN if there is no weight
};

/// weights has one entry per value, or none at all.
Statistics Summarize(const Buffer<double>& values, const Buffer<double>& weights,
  Execution& execution);

/**
 * The value below which the given fraction of a sample lies, with linear interpolation between
 * order statistics: of n values in ascending order, numbered from 0, the one at position fraction *
 * (n - 1). (Hyndman and Fan's definition 7, the default of NumPy and R.) Puts values into another
 * order.
 */
double Percentile(Buffer<double>& values, double fraction);

/**
 * The position error E_v of Sun et al. 2007: sqrt(sum_v sum_{f at v} A_f d_v^2 / (3 sum_f A_f))
 * with the distance d_v of vertex v from the reference. NaN without area.
 */
double AreaWeightedDistance(const TriangleMesh& mesh, const Buffer<double>& areas,
  const Buffer<double>& distances, Execution& execution);

/// True if the mesh bounds a volume: no boundary, no non-manifold edge, neighbours agree on
/// outside.
bool IsClosed(const EdgeCensus& census);

/**
 * Sum of det(a, b, c) / 6 over the faces, positive if their normals point outwards. Means the
 * enclosed volume for closed meshes only.
 */
double SignedVolume(const TriangleMesh& mesh, Execution& execution);

/**
 * Mean over the faces with area of circumradius / shortest edge: 0.577 (1 / sqrt(3)) for
 * equilateral triangles, 0.707 for right isosceles ones, without bound for slivers. NaN if no face
 * has an area.
 */
double TriangleQuality(const TriangleMesh& mesh, const Buffer<double>& areas, Execution& execution);

/// Feature edges of two meshes with the same faces.
struct FeatureAgreement
{
  std::size_t Reference = 0; ///< edges that are a feature of the reference
  std::size_t Found = 0;     ///< of these, those that are a feature of the other mesh as well
  std::size_t Invented = 0;  ///< edges that are a feature of the other mesh alone

  std::size_t Missed() const { return this->Reference - this->Found; }

  FeatureAgreement& operator+=(const FeatureAgreement& other)
  {
    this->Reference += other.Reference;
    this->Found += other.Found;
    this->Invented += other.Invented;
    return *this;
  }
};

/**
 * An edge is a feature if the normals of its two faces are more than angle degrees apart (0 = flat,
 * the convention of vtkFeatureEdges). Edges are taken as pairs of faces that share one: a
 * non-manifold edge of three faces counts three times, a boundary edge never, nor does an edge of a
 * degenerate face.
 */
FeatureAgreement CompareFeatureEdges(const NeighborGraph& edgeAdjacentFaces,
  const Buffer<Vec3>& normals, const Buffer<Vec3>& referenceNormals, double angle,
  Execution& execution);

/**
 * 1 for every face within a number of rings of the feature edges, else 0. The first ring are the
 * faces that share a vertex with a feature edge (as CompareFeatureEdges has it), each further ring
 * the faces that share a vertex with one of the ring before. No ring is no face.
 */
Buffer<unsigned char> FacesNearFeatures(const TriangleMesh& mesh, const CompressedRows& stars,
  const NeighborGraph& edgeAdjacentFaces, const Buffer<Vec3>& normals, double angle, int rings,
  Execution& execution);

/// The mean of some values by where they belong.
struct DividedMean
{
  double Inside;  ///< mean where the mark is set; NaN without any
  double Outside; ///< mean where it is not; NaN without any
};

/// marks has one entry per value; values that are not numbers are left out.
DividedMean MeansByMark(const Buffer<double>& values, const Buffer<unsigned char>& marks,
  Execution& execution);

}

#endif
