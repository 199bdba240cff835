// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file BundleExamples.h
 * @brief Small point sets with and without bundles of normals.
 */

#ifndef BundleExamples_h
#define BundleExamples_h

#include "Points/PointSet.h"

inline SurfaceDenoising::Vec3 Unit(double x, double y, double z)
{
  return SurfaceDenoising::Vec3(x, y, z).normalized();
}

/// Graph with these rows.
inline SurfaceDenoising::NeighborGraph Rows(
  const std::vector<std::vector<SurfaceDenoising::Index>>& rows)
{
  SurfaceDenoising::NeighborGraph graph;
  graph.Offsets.assign(1, 0);
  for (const std::vector<SurfaceDenoising::Index>& row : rows)
  {
    graph.Ids.insert(graph.Ids.end(), row.begin(), row.end());
    graph.Offsets.push_back(graph.Ids.size());
  }
  return graph;
}

/// Two faces at a right angle, their points at 0.5, 1.5, ... from the edge, the y axis.
inline SurfaceDenoising::PointSet ExactWedge(int along, int across)
{
  using namespace SurfaceDenoising;
  PointSet points;
  for (int a = 0; a < across; ++a)
  {
    for (int y = 0; y < along; ++y)
    {
      points.Positions.push_back(Vec3(-0.5 - a, y, 0.0));
      points.Normals.push_back(Vec3(0.0, 0.0, 1.0));
      points.Positions.push_back(Vec3(0.0, y, -0.5 - a));
      points.Normals.push_back(Vec3(1.0, 0.0, 0.0));
    }
  }
  Execution serial;
  points.Start = points.Positions;
  points.Neighbors = NearestPoints(points.Positions, 30, serial);
  points.Spacing = 1.0;
  points.Spacings.assign(points.Size(), 1.0);
  points.Status.assign(points.Size(), PointStatus::Filtered);
  return points;
}

#endif
