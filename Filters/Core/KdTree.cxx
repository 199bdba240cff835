// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "KdTree.h"

#include <nanoflann.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace SurfaceDenoising
{

namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// The finite points and their numbers, in the form in which nanoflann asks for them.
struct PointTable
{
  Buffer<Vec3> Positions;
  Buffer<Index> Numbers;

  explicit PointTable(const Buffer<Vec3>& points)
  {
    this->Positions.reserve(points.size());
    this->Numbers.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      if (points[i].allFinite())
      {
        this->Positions.push_back(points[i]);
        this->Numbers.push_back(static_cast<Index>(i));
      }
    }
  }

  std::size_t kdtree_get_point_count() const { return this->Positions.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t axis) const
  {
    return this->Positions[i][static_cast<Eigen::Index>(axis)];
  }
  template <typename Box>
  bool kdtree_get_bbox(Box&) const
  {
    return false; // nanoflann computes it
  }
};

/// Squared distance and number, which order the results.
using Candidate = std::pair<double, Index>;

/**
 * A result set of nanoflann: the best candidates so far, at most Capacity of them and none at or
 * beyond Bound. With a set of our own, ties are decided by number instead of by the layout of the
 * tree, and nothing is used that nanoflann 1.5 renamed.
 */
class ResultSet
{
public:
  using DistanceType = double;
  using IndexType = Index;

  ResultSet(std::vector<Candidate>& candidates, std::size_t capacity, double bound)
    : Candidates(candidates)
    , Capacity(capacity)
    , Bound(bound)
  {
    this->Candidates.clear();
  }

  std::size_t size() const { return this->Candidates.size(); }
  bool empty() const { return this->Candidates.empty(); }
  bool full() const { return this->size() == this->Capacity; }
  void sort() {} // nanoflann 1.6 and later call it; the caller sorts anyway

  /// Only smaller distances are offered: the next number lets ties with the worst candidate pass.
  /// When there is nothing nearer than what was found, nothing is offered any more.
  double worstDist() const
  {
    if (!this->full())
    {
      return this->Bound;
    }
    const double worst = this->Candidates.front().first;
    return worst > 0.0 ? std::nextafter(worst, Infinity) : -1.0;
  }

  bool addPoint(double squaredDistance, Index position)
  {
    // A heap with the worst candidate in front.
    const Candidate candidate(squaredDistance, position);
    if (this->full())
    {
      if (this->Candidates.front() < candidate)
      {
        return true;
      }
      std::pop_heap(this->Candidates.begin(), this->Candidates.end());
      this->Candidates.pop_back();
    }
    this->Candidates.push_back(candidate);
    std::push_heap(this->Candidates.begin(), this->Candidates.end());
    return true;
  }

private:
  std::vector<Candidate>& Candidates;
  std::size_t Capacity;
  double Bound;
};

}

struct KdTree::Tree
{
  using Distance = nanoflann::L2_Simple_Adaptor<double, PointTable>;

  PointTable Table;
  nanoflann::KDTreeSingleIndexAdaptor<Distance, PointTable, 3, Index> Nodes;

  explicit Tree(const Buffer<Vec3>& points)
    : Table(points)
    , Nodes(3, this->Table)
  {
  }

  void Find(const Vec3& query, std::size_t capacity, double bound, std::vector<Index>& found) const
  {
    static thread_local std::vector<Candidate> candidates; // keeps its memory from query to query
    found.clear();
    if (capacity == 0 || !query.allFinite())
    {
      return;
    }
    ResultSet results(candidates, capacity, bound);
    this->Nodes.findNeighbors(results, query.data(), {});
    std::sort(candidates.begin(), candidates.end());
    for (const Candidate& candidate : candidates)
    {
      found.push_back(this->Table.Numbers[candidate.second]);
    }
  }
};

KdTree::KdTree(const Buffer<Vec3>& points)
  : Hidden(std::make_unique<Tree>(points))
{
}

KdTree::~KdTree() = default;

void KdTree::Nearest(const Vec3& query, std::size_t count, std::vector<Index>& found) const
{
  this->Hidden->Find(query, count, Infinity, found);
}

void KdTree::Within(const Vec3& query, double radius, std::vector<Index>& found,
  std::size_t limit) const
{
  // nanoflann excludes the bound itself, we include the radius.
  const double bound = radius >= 0.0 ? std::nextafter(radius * radius, Infinity) : 0.0;
  this->Hidden->Find(query, limit, bound, found);
}

}
