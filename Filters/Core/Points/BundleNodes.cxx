// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "BundleNodes.h"

#include <algorithm>
#include <cmath>
#include <limits>

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
    this->Collect(i, true);
    std::size_t count = 0;
    if (this->Normals.size() >= this->Settings.FewestFlat)
    {
      count = this->FindPlanes(i, bundle);
    }
    if (count == 0)
    {
      this->Collect(i, false);
      count = this->FindPlanes(i, bundle);
    }
    if (count == 0)
    {
      bundle[count++] = this->Points.Normals[i];
    }
    return count;
  }

private:
  void Collect(Index i, bool flatOnly)
  {
    const PointSet& points = this->Points;
    this->Normals.clear();
    this->Ways.clear();
    for (const Index j : points.Neighbors.Row(i))
    {
      if (!points.Normals[j].isZero(0.0) && !(flatOnly && this->Features[j]))
      {
        this->Normals.push_back(points.Normals[j]);
        this->Ways.push_back(points.Positions[j] - points.Positions[i]);
      }
    }
  }

  /// The planes of the clusters that pass near the point.
  std::size_t FindPlanes(Index i, Vec3* bundle)
  {
    if (this->Normals.empty())
    {
      return 0;
    }
    const BundleSettings& settings = this->Settings;
    const double spacing = this->Points.SpacingAt(i);
    const double sigma = settings.SpatialScale * spacing;
    ClusterNormals(this->Normals, this->Points.Normals[i], settings.Clusters, this->Clusters);
    if (this->Clusters.Centres.size() == 1)
    {
      bundle[0] = this->Points.Normals[i]; // all alike: no feature
      return 1;
    }
    std::size_t count = 0;
    for (std::size_t c = 0; c < this->Clusters.Centres.size(); ++c)
    {
      const Vec3& centre = this->Clusters.Centres[c];
      auto isMember = [&](std::size_t k) { return this->Clusters.Of[k] == static_cast<int>(c); };
      // Relative to the nearest member, so that far ones have weights as well.
      double nearest = std::numeric_limits<double>::infinity();
      for (std::size_t k = 0; k < this->Normals.size(); ++k)
      {
        nearest = isMember(k) ? std::min(nearest, this->Ways[k].squaredNorm()) : nearest;
      }
      Vec3 normal(0.0, 0.0, 0.0);
      Vec3 middle(0.0, 0.0, 0.0);
      double weight = 0.0;
      for (std::size_t k = 0; k < this->Normals.size(); ++k)
      {
        if (isMember(k))
        {
          const Vec3& n = this->Normals[k];
          const bool turned = settings.Clusters.Unoriented && n.dot(centre) < 0.0;
          const double w =
            sigma > 0.0 ? std::exp((nearest - this->Ways[k].squaredNorm()) / (sigma * sigma)) : 1.0;
          normal += (turned ? -w : w) * n;
          middle += w * this->Ways[k];
          weight += w;
        }
      }
      const double length = normal.norm();
      normal = length > 1e-12 ? Vec3(normal / length) : centre;
      const double height = std::abs(normal.dot(middle)) / weight;
      if (!(settings.Reach > 0.0) || height <= settings.Reach * spacing)
      {
        bundle[count++] = normal;
      }
    }
    return count;
  }

  const PointSet& Points;
  const Buffer<unsigned char>& Features;
  const BundleSettings& Settings;
  std::vector<Vec3> Normals;
  std::vector<Vec3> Ways; ///< from the point to the neighbours
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
  Buffer<Index> sizes(listed.size(), 1); // of loops that were stopped as well
  execution.For(
    listed.size(),
    [&](std::size_t begin, std::size_t end)
    {
      BundleMaker maker(points, features, settings);
      for (std::size_t f = begin; f < end; ++f)
      {
        sizes[f] = static_cast<Index>(maker.Make(listed[f], bundles.data() + f * most));
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
