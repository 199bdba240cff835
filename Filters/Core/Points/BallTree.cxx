// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "BallTree.h"

#include <limits>

namespace SurfaceDenoising
{

BallTree::BallTree(const Buffer<Vec3>& centres, const Buffer<double>& radii, Execution& execution)
  : Centres(centres)
  , Radii(radii)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Node nothing{ Vec3::Constant(infinity), Vec3::Constant(-infinity), 0.0 };
  auto join = [](Node& node, const Node& other)
  {
    if (other.Radius > 0.0) // what contains nothing need not be found
    {
      node.Lowest = node.Lowest.cwiseMin(other.Lowest);
      node.Highest = node.Highest.cwiseMax(other.Highest);
      node.Radius = std::max(node.Radius, other.Radius);
    }
  };
  for (std::size_t below = centres.size(); below > 1 || this->Levels.empty();)
  {
    if (below == 0)
    {
      return;
    }
    const bool leaves = this->Levels.empty();
    Buffer<Node> level((below + Fan - 1) / Fan);
    execution.For(level.size(),
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t n = begin; n < end; ++n)
        {
          level[n] = nothing;
          for (std::size_t k = n * Fan; k < std::min(below, (n + 1) * Fan); ++k)
          {
            join(level[n],
              leaves ? Node{ centres[k], centres[k], radii[k] } : this->Levels.back()[k]);
          }
        }
      });
    below = level.size();
    this->Levels.push_back(std::move(level));
  }
}

}
