// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file TextbookBundleInternals.h
 * @brief What both parts of the textbook version of bundles of normals need.
 */

#ifndef TextbookBundleInternals_h
#define TextbookBundleInternals_h

#include "TextbookBundlePoints.h"

#include <algorithm>
#include <cmath>

namespace TextbookBundles
{

inline double Gauss(double x, double sigma) { return std::exp(-(x / sigma) * (x / sigma)); }

inline double Like(const Point& a, const Point& b, bool unoriented)
{
  return unoriented ? std::abs(a.dot(b)) : a.dot(b);
}

inline Point Facing(const Point& n, const Point& side, bool unoriented)
{
  return unoriented && n.dot(side) < 0.0 ? Point(-n) : n;
}

inline double Difference(const Point& a, const Point& b, bool unoriented)
{
  return unoriented ? std::min((a - b).norm(), (a + b).norm()) : (a - b).norm();
}

inline bool HasNormal(const Point& n) { return n != Point(0.0, 0.0, 0.0); }

/// Number of the centre that n is most like.
inline int MostLike(const Point& n, const std::vector<Point>& centres, bool unoriented)
{
  int best = 0;
  for (int c = 1; c < static_cast<int>(centres.size()); ++c)
  {
    if (Like(n, centres[c], unoriented) > Like(n, centres[best], unoriented))
    {
      best = c;
    }
  }
  return best;
}

/// Of all points, that an iteration starts from.
std::vector<std::vector<Point>> FirstBundles(const Cloud& cloud, const Parameters& parameters);

}

#endif
