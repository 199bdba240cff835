// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "BundleNodes.h"

#include <cmath>

namespace SurfaceDenoising
{

namespace
{

/// The normals of one feature; memory to work in lives as long as the object.
class BundleMaker
{
public:
  BundleMaker(const PointSet& points, const Buffer<unsigned char>& features,
    const BundleSettings& settings)
    : Points(points)
    , Features(features)
    , Settings(settings)
  {
  }

  /// Writes at most the maximum number of normals and returns how many.
  std::size_t Make(Index i, Vec3* bundle)
  {
    const PointSet& points = this->Points;
    const bool unoriented = this->Settings.Clusters.Unoriented;
    this->Collect(i, true);
    if (this->Normals.size() < this->Settings.FewestFlat)
    {
      this->Collect(i, false);
    }
    if (this->Normals.empty())
    {
      bundle[0] = points.Normals[i];
      return 1;
    }
    ClusterNormals(this->Normals, points.Normals[i], this->Settings.Clusters, this->Clusters);
    const double sigma = this->Settings.SpatialScale * points.SpacingAt(i);
    const std::size_t count = this->Clusters.Centres.size();
    for (std::size_t c = 0; c < count; ++c)
    {
      const Vec3& centre = this->Clusters.Centres[c];
      Vec3 sum(0.0, 0.0, 0.0);
      for (std::size_t k = 0; k < this->Normals.size(); ++k)
      {
        if (this->Clusters.Of[k] == static_cast<int>(c))
        {
          const Vec3& n = this->Normals[k];
          const double sign = unoriented && n.dot(centre) < 0.0 ? -1.0 : 1.0;
          sum += sign * std::exp(-this->Squares[k] / (sigma * sigma)) * n;
        }
      }
      const double length = sum.norm();
      bundle[c] = length > 1e-12 ? Vec3(sum / length) : centre;
    }
    return count;
  }

private:
  void Collect(Index i, bool flatOnly)
  {
    const PointSet& points = this->Points;
    this->Normals.clear();
    this->Squares.clear();
    for (const Index j : points.Neighbors.Row(i))
    {
      if (!points.Normals[j].isZero(0.0) && !(flatOnly && this->Features[j]))
      {
        this->Normals.push_back(points.Normals[j]);
        this->Squares.push_back((points.Positions[j] - points.Positions[i]).squaredNorm());
      }
    }
  }

  const PointSet& Points;
  const Buffer<unsigned char>& Features;
  const BundleSettings& Settings;
  std::vector<Vec3> Normals;
  std::vector<double> Squares;
  NormalClusters Clusters;
};

}

BundleNodes MakeBundles(const PointSet& points, const Buffer<unsigned char>& features,
  const BundleSettings& settings, Execution& execution)
{
  const std::size_t count = points.Size();
  const std::size_t most = static_cast<std::size_t>(std::max(1, settings.Clusters.Maximum));
  Buffer<Index> listed;
  for (std::size_t i = 0; i < count; ++i)
  {
    if (features[i])
    {
      listed.push_back(static_cast<Index>(i));
    }
  }
  Buffer<Vec3> bundles(listed.size() * most);
  Buffer<unsigned char> sizes(listed.size());
  execution.For(
    listed.size(),
    [&](std::size_t begin, std::size_t end)
    {
      BundleMaker maker(points, features, settings);
      for (std::size_t f = begin; f < end; ++f)
      {
        sizes[f] = static_cast<unsigned char>(maker.Make(listed[f], bundles.data() + f * most));
      }
    },
    256);

  BundleNodes nodes;
  nodes.First.resize(count + 1);
  nodes.First[0] = 0;
  std::size_t f = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    nodes.First[i + 1] = nodes.First[i] + (features[i] ? sizes[f++] : 1);
  }
  const std::size_t size = nodes.First[count];
  nodes.Points.resize(size);
  nodes.Normals.resize(size);
  nodes.Graph.Offsets.resize(size + 1);
  nodes.Graph.Offsets[0] = 0;
  f = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::size_t first = nodes.First[i];
    for (std::size_t k = first; k < nodes.First[i + 1]; ++k)
    {
      nodes.Points[k] = static_cast<Index>(i);
      nodes.Normals[k] = features[i] ? bundles[f * most + (k - first)] : points.Normals[i];
      nodes.Graph.Offsets[k + 1] = nodes.Graph.Offsets[k] + points.Neighbors.Row(i).size();
    }
    f += features[i] ? 1 : 0;
  }
  return nodes;
}

void MatchNodes(const NeighborGraph& neighbors, const Buffer<Vec3>& directions, bool unoriented,
  BundleNodes& nodes, Execution& execution)
{
  nodes.Graph.Ids.resize(nodes.Graph.Offsets.back());
  execution.For(nodes.Size(),
    [&](std::size_t begin, std::size_t end)
    {
      const Index* first = nodes.First.data();
      for (std::size_t k = begin; k < end; ++k)
      {
        Index* id = nodes.Graph.Ids.data() + nodes.Graph.Offsets[k];
        for (const Index j : neighbors.Row(nodes.Points[k]))
        {
          Index best = first[j];
          if (first[j + 1] - best > 1)
          {
            double most = -2.0;
            for (Index m = first[j]; m < first[j + 1]; ++m)
            {
              const double dot = directions[k].dot(nodes.Normals[m]);
              const double like = unoriented ? std::abs(dot) : dot;
              if (like > most)
              {
                most = like;
                best = m;
              }
            }
          }
          *id++ = best;
        }
      }
    });
}

}
