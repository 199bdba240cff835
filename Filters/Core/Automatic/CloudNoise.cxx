// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Automatic/CloudNoise.h"

#include "Automatic/CloudImpulses.h"
#include "Automatic/LocalFits.h"
#include "InterruptedExecution.h"
#include "Metrics.h"
#include "Points/PointNeighbors.h"
#include "Points/PointRuns.h"
#include "RobustScale.h"
#include "SpatialOrder.h"

#include <cmath>

namespace SurfaceDenoising
{

namespace
{

/// The deviation of normally distributed residuals of which this share is below what is found; the
/// deviate is that quantile of a normal variable.
double ReadLower(const Buffer<double>& deviations, std::size_t neighbors, double share,
  double deviate)
{
  Buffer<double> found = LocalFits::Known(deviations);
  if (found.empty())
  {
    return 0.0;
  }
  const auto place = found.begin() + static_cast<std::ptrdiff_t>(share * double(found.size()));
  std::nth_element(found.begin(), place, found.end());
  const double third = 2.0 / (9.0 * static_cast<double>(neighbors + 1 - LocalFits::Coefficients));
  return *place / std::pow(1.0 - third + deviate * std::sqrt(third), 1.5);
}

double DeviationOf(const LocalFits& fits, double spacingOfPoints)
{
  const double spacing = spacingOfPoints * std::sqrt(static_cast<double>(fits.Widening));
  const std::size_t w = fits.Widening;
  const double few = ReadLower(fits.Few, w * LocalFits::FewNeighbors, 0.1, -1.2815515655446004);
  const double some = ReadLower(fits.Some, w * LocalFits::SomeNeighbors, 0.2, -0.8416212335729143);
  const double many = ReadLower(fits.Many, w * LocalFits::ManyNeighbors, 0.2, -0.8416212335729143);
  // Squares of what is shape grow with a power of the number of points, those of noise do not.
  // Three sizes tell the power: 2 on rough surfaces, 3 and more on smooth ones.
  constexpr double small = LocalFits::FewNeighbors + 1;
  constexpr double medium = LocalFits::SomeNeighbors + 1;
  constexpr double large = LocalFits::ManyNeighbors + 1;
  const double first = std::max(0.0, some * some - few * few);
  const double second = std::max(0.0, many * many - some * some);
  constexpr double ofSquares =
    (large * large - medium * medium) / (medium * medium - small * small);
  const double power = first > 0.0
    ? std::min(3.5, std::max(2.0, 2.0 + std::log2(std::max(1e-3, second / first / ofSquares))))
    : 3.5;
  const double shape = first / (std::pow(medium / small, power) - 1.0);
  const double weak = std::sqrt(std::max(0.0, few * few - shape));
  const double shapeOfSome = second / (large * large / (medium * medium) - 1.0);
  const double middling = std::sqrt(std::max(0.0, some * some - shapeOfSome));

  auto ramp = [](double x, double from, double to)
  { return std::min(1.0, std::max(0.0, (x - from) / (to - from))); };
  auto blend = [](double from, double to, double share) { return from + share * (to - from); };
  // Of strong noise the frames of small fits take a part. Factors are those of a plane.
  const double notWeak = blend(middling * (1.0 + 0.06 * ramp(some / spacing, 0.4, 0.6)),
    1.08 * many, ramp(some / spacing, 0.6, 0.75));
  return blend(weak, notWeak, ramp(few / spacing, 0.25, 0.6));
}

/// Noise with heavy tails is stronger than its quieter places show: by this factor, 1 for normally
/// distributed noise. Where shape is more than noise, tails are those of shape.
double TailFactor(const LocalFits& fits, double deviation)
{
  constexpr double normal = 3.15;
  constexpr double slope = 0.25;
  constexpr double most = 1.5; // more is not noise of all points
  const LocalFits::Residuals residuals = fits.ResidualsOfMany();
  const double share = deviation / std::max(residuals.Deviation, deviation);
  return 1.0 +
    slope * std::min(1.0, 1.5 * share * share) * std::clamp(residuals.Kurtosis - normal, 0.0, most);
}

/// The deviation from these fits, or from wide ones where they follow curves.
void Measure(const Buffer<Vec3>& points, const Buffer<unsigned char>& leftOut,
  const LocalFits& fits, CloudNoise& noise, Execution& execution)
{
  LocalFits wide;
  const bool isWide = !fits.AreOfSurface() && FitWidely(points, leftOut, wide, execution);
  noise.Widening = isWide ? wide.Widening : 1;
  const LocalFits& used = isWide ? wide : fits;
  noise.Deviation = DeviationOf(used, noise.Spacing);
  if (noise.Deviation > 0.0)
  {
    noise.Deviation *= TailFactor(used, noise.Deviation);
  }
}

/// Marks outliers, see the header.
void FindOutliers(const NeighborGraph& nearest, const Buffer<double>& spacings,
  const LocalFits& fits, CloudNoise& noise, Buffer<unsigned char>& outliers)
{
  Buffer<double> around;
  auto medianAround = [&](std::size_t i, const Buffer<double>& values)
  {
    around.clear();
    for (const Index j : nearest.Row(i))
    {
      if (values[j] >= 0.0 && around.size() < LocalFits::SomeNeighbors)
      {
        around.push_back(values[j]);
      }
    }
    return Median(around);
  };
  const Buffer<double>& heights = fits.Heights;
  const double high = std::max(6.0 * noise.Deviation, 3.0 * noise.Spacing);
  // Whole faces of bare CAD models have vertices farther apart than others, and neighbours of these
  // are across edges: that they lie all around says nothing.
  const bool areOfSurface = fits.AreOfSurface();
  outliers.assign(spacings.size(), 0);
  for (std::size_t i = 0; i < spacings.size(); ++i)
  {
    // Neighbours of a lonely point are close together, or are lonely as well and lie all around.
    const bool isOnSurface = heights[i] >= 0.0 && heights[i] < 0.1 * spacings[i];
    if (spacings[i] > 2.5 * noise.Spacing &&
      ((!isOnSurface && spacings[i] > 2.5 * medianAround(i, spacings)) ||
        (areOfSurface && fits.Some[i] > 0.3 * spacings[i])))
    {
      outliers[i] = 1;
      ++noise.Far;
    }
    else if (heights[i] > high && spacings[i] > 1.4 * medianAround(i, spacings) &&
      heights[i] > 3.0 * medianAround(i, heights))
    {
      outliers[i] = 1;
      ++noise.Off;
    }
  }
}

/// Where noise of all points is stronger, in spacings, and uneven, its tail looks like impulses.
constexpr double LittleNoise = 0.1;

/// False for normally distributed noise without edges or detail, to which impulses need not be
/// looked for.
bool HasHeavyTails(const Buffer<double>& heights)
{
  Buffer<double> known = LocalFits::Known(heights);
  return !known.empty() && Percentile(known, 0.99) > 4.5 * Median(known);
}

}

CloudNoise EstimateNoise(const Buffer<Vec3>& points, Execution& execution)
{
  CloudNoise noise;
  noise.Outliers.assign(points.size(), 0);
  Buffer<Index> order = FindPointOrder(points, {}, execution);
  FormRuns(points, order, execution);
  noise.Finite = order.size();
  if (order.size() < 2 || !execution.Proceed(0.0))
  {
    return noise;
  }
  const Buffer<Vec3> ordered = Gather(points, order);
  InterruptedExecution interrupted(execution, 0.0);
  const NeighborGraph nearest =
    NearestOrderedPoints(ordered, LocalFits::ManyNeighbors, interrupted);
  if (!interrupted.Proceed(0.0))
  {
    return noise;
  }
  const Buffer<double> spacings = PointSpacings(ordered, nearest, execution);
  noise.Spacing = MedianSpacing(spacings);
  if (!(noise.Spacing > 0.0))
  {
    return noise; // all points at one place
  }
  const LocalFits fits = FitEverywhere(ordered, nearest, {}, true, interrupted);
  if (!interrupted.Proceed(0.0))
  {
    return noise;
  }
  Measure(ordered, {}, fits, noise, interrupted);
  Buffer<unsigned char> outliers;
  FindOutliers(nearest, spacings, fits, noise, outliers);
  Buffer<unsigned char> impulses;
  if (noise.Level() < LittleNoise && HasHeavyTails(fits.Heights) &&
    FindImpulses(ordered, nearest, noise.Spacing, impulses, interrupted))
  {
    for (std::size_t i = 0; i < outliers.size(); ++i)
    {
      noise.Off += impulses[i] && !outliers[i] ? 1 : 0;
      outliers[i] = std::max(outliers[i], impulses[i]);
    }
  }
  if (noise.Far + noise.Off > 0 && interrupted.Proceed(0.0))
  {
    Measure(ordered, outliers, FitEverywhere(ordered, nearest, outliers, false, interrupted), noise,
      interrupted);
  }
  for (std::size_t k = 0; k < order.size(); ++k)
  {
    noise.Outliers[order[k]] = outliers[k];
  }
  return noise;
}

}
