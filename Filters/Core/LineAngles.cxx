// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LineAngles.h"

#include "Metrics.h"

#include <cmath>
#include <limits>

namespace SurfaceDenoising
{

namespace
{

constexpr double Undefined = std::numeric_limits<double>::quiet_NaN();

/// Calls compare(i) for all points.
template <typename Compare>
LineAngles CompareAll(std::size_t count, Execution& execution, Compare compare)
{
  LineAngles angles;
  angles.Degrees.resize(count);
  angles.Flipped.resize(count);
  execution.For(count,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const LineAngle angle = compare(i);
        angles.Degrees[i] = angle.Degrees;
        angles.Flipped[i] = angle.Flipped;
      }
    });
  return angles;
}

}

LineAngle AngleBetweenLines(const Vec3& a, const Vec3& b)
{
  const bool flipped = a.dot(b) < 0.0;
  return { AngleBetween(flipped ? Vec3(-a) : a, b), flipped };
}

LineAngles CompareWithFaces(const Buffer<Vec3>& normals, const Buffer<Vec3>& positions,
  const Buffer<Index>& nearest, const SurfaceSides& sides, const Buffer<Vec3>& faceNormals,
  Execution& execution)
{
  return CompareAll(normals.size(), execution,
    [&](std::size_t i)
    {
      LineAngle best{ Undefined, false };
      if (nearest[i] != NoIndex)
      {
        sides.VisitNearest(positions[i], nearest[i],
          [&](Index f)
          {
            const LineAngle angle = AngleBetweenLines(normals[i], faceNormals[f]);
            // Of equal angles the one with the right sign, so that the order does not matter.
            if (!(best.Degrees <= angle.Degrees) || (best.Degrees == angle.Degrees && best.Flipped))
            {
              best = angle;
            }
          });
      }
      return best;
    });
}

LineAngles CompareWithPoints(const Buffer<Vec3>& normals, const Buffer<Index>& nearest,
  const Buffer<Vec3>& referenceNormals, Execution& execution)
{
  return CompareAll(normals.size(), execution,
    [&](std::size_t i)
    {
      return nearest[i] == NoIndex ? LineAngle{ Undefined, false }
                                   : AngleBetweenLines(normals[i], referenceNormals[nearest[i]]);
    });
}

LineAngleSummary Summarize(const LineAngles& angles, Execution& execution)
{
  const Statistics statistics = Summarize(angles.Degrees, {}, execution);
  LineAngleSummary summary{ statistics.Mean, statistics.RootMeanSquare, Undefined, Undefined };
  if (statistics.Count > 0)
  {
    std::size_t within = 0;
    std::size_t flipped = 0;
    for (std::size_t i = 0; i < angles.Degrees.size(); ++i)
    {
      within += angles.Degrees[i] < 10.0;
      flipped += angles.Flipped[i] && !std::isnan(angles.Degrees[i]);
    }
    summary.ShareWithin10 = static_cast<double>(within) / static_cast<double>(statistics.Count);
    summary.Flipped = static_cast<double>(flipped);
  }
  return summary;
}

}
