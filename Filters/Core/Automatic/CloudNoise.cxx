// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Automatic/CloudNoise.h"

#include "Automatic/CloudImpulses.h"
#include "InterruptedExecution.h"
#include "Metrics.h"
#include "Points/PlaneFit.h"
#include "Points/PointNeighbors.h"
#include "Points/PointRuns.h"
#include "RobustScale.h"
#include "SpatialOrder.h"

#include <Eigen/Cholesky>

#include <cmath>

namespace SurfaceDenoising
{

namespace
{

constexpr std::size_t FewNeighbors = 9;
constexpr std::size_t SomeNeighbors = 20;
constexpr std::size_t ManyNeighbors = 40;
constexpr std::size_t Coefficients = 6;

/// The lesser over the larger variance in the plane, at least; 1/4 on the edge of a surface.
constexpr double LeastWidth = 0.15;

struct QuadricResidual
{
  double Deviation = -1.0; ///< of the points of the fit; negative without a fit
  double Height = 0.0;     ///< of the origin over the polynomial
};

/// The polynomial over the plane of these points, which are relative to the origin.
QuadricResidual FitQuadric(const Vec3* points, std::size_t count)
{
  QuadricResidual result;
  PlaneSum sum;
  for (std::size_t k = 0; k < count; ++k)
  {
    sum.Add(points[k]);
  }
  const Plane plane = sum.FitAxes();
  // Of points along a curve, the second direction is that of the noise.
  if (plane.Normal.isZero(0.0) || !(plane.Variances[1] > LeastWidth * plane.Variances[2]))
  {
    return result;
  }
  const double unit = 1.0 / std::sqrt(plane.Variances[2]);
  const Vec3 u = (plane.Along - plane.Normal.dot(plane.Along) * plane.Normal).normalized() * unit;
  const Vec3 v = plane.Normal.cross(u);
  using Vector = Eigen::Matrix<double, 6, 1>;
  using Matrix = Eigen::Matrix<double, 6, 6>;
  auto basis = [&](const Vec3& p)
  {
    const double x = u.dot(p - plane.Centre);
    const double y = v.dot(p - plane.Centre);
    Vector terms;
    terms << 1.0, x, y, x * x, x * y, y * y;
    return terms;
  };
  Matrix a = Matrix::Zero();
  Vector b = Vector::Zero();
  for (std::size_t k = 0; k < count; ++k)
  {
    const Vector terms = basis(points[k]);
    a.noalias() += terms * terms.transpose();
    b += plane.HeightOf(points[k]) * terms;
  }
  // Points on a conic section leave a coefficient open: any will do.
  a.diagonal().array() += 1e-10 * static_cast<double>(count);
  const Vector solution = a.ldlt().solve(b);
  double squares = 0.0;
  for (std::size_t k = 0; k < count; ++k)
  {
    const double r = plane.HeightOf(points[k]) - solution.dot(basis(points[k]));
    squares += r * r;
  }
  result.Deviation = std::sqrt(squares / static_cast<double>(count - Coefficients));
  const Vec3 origin(0.0, 0.0, 0.0);
  result.Height = plane.HeightOf(origin) - solution.dot(basis(origin));
  return result;
}

/// What fits around every point tell.
struct LocalFits
{
  Buffer<double> Few;     ///< deviations; negative without a fit
  Buffer<double> Some;    ///< the same
  Buffer<double> Many;    ///< the same
  Buffer<double> Heights; ///< of points over the fit of the others, absolute; negative without one
};

LocalFits FitEverywhere(const Buffer<Vec3>& points, const NeighborGraph& nearest,
  const Buffer<unsigned char>& leftOut, bool heights, Execution& execution)
{
  LocalFits fits;
  fits.Few.resize(points.size());
  fits.Some.resize(points.size());
  fits.Many.resize(points.size());
  fits.Heights.resize(heights ? points.size() : 0);
  execution.For(
    points.size(),
    [&](std::size_t begin, std::size_t end)
    {
      std::vector<Vec3> around;
      for (std::size_t i = begin; i < end; ++i)
      {
        around.assign(1, Vec3(0.0, 0.0, 0.0));
        for (const Index j : nearest.Row(i))
        {
          if (leftOut.empty() || leftOut[j] == 0)
          {
            around.push_back(points[j] - points[i]);
          }
        }
        const bool out = !leftOut.empty() && leftOut[i] != 0;
        auto deviation = [&](std::size_t count)
        {
          return out || around.size() < FewNeighbors + 1
            ? -1.0
            : FitQuadric(around.data(), std::min(around.size(), count + 1)).Deviation;
        };
        fits.Few[i] = deviation(FewNeighbors);
        fits.Some[i] = deviation(SomeNeighbors);
        fits.Many[i] = deviation(ManyNeighbors);
        if (heights)
        {
          const std::size_t others = std::min(around.size() - 1, SomeNeighbors);
          fits.Heights[i] = -1.0;
          if (others >= FewNeighbors)
          {
            const QuadricResidual fit = FitQuadric(around.data() + 1, others);
            fits.Heights[i] = fit.Deviation < 0.0 ? -1.0 : std::abs(fit.Height);
          }
        }
      }
    },
    256);
  return fits;
}

/// The deviation of normally distributed residuals of which this share is below what is found; the
/// deviate is that quantile of a normal variable.
double ReadLower(const Buffer<double>& deviations, std::size_t neighbors, double share,
  double deviate)
{
  Buffer<double> found;
  for (const double deviation : deviations)
  {
    if (deviation >= 0.0)
    {
      found.push_back(deviation);
    }
  }
  if (found.empty())
  {
    return 0.0;
  }
  const auto place = found.begin() + static_cast<std::ptrdiff_t>(share * double(found.size()));
  std::nth_element(found.begin(), place, found.end());
  const double third = 2.0 / (9.0 * static_cast<double>(neighbors + 1 - Coefficients));
  return *place / std::pow(1.0 - third + deviate * std::sqrt(third), 1.5);
}

double DeviationOf(const LocalFits& fits, double spacing)
{
  const double few = ReadLower(fits.Few, FewNeighbors, 0.1, -1.2815515655446004);
  const double some = ReadLower(fits.Some, SomeNeighbors, 0.2, -0.8416212335729143);
  const double many = ReadLower(fits.Many, ManyNeighbors, 0.2, -0.8416212335729143);
  // Squares of what is shape grow with a power of the number of points, those of noise do not.
  // Three sizes tell the power: 2 on rough surfaces, 3 and more on smooth ones.
  constexpr double small = FewNeighbors + 1;
  constexpr double medium = SomeNeighbors + 1;
  constexpr double large = ManyNeighbors + 1;
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
      if (values[j] >= 0.0 && around.size() < SomeNeighbors)
      {
        around.push_back(values[j]);
      }
    }
    return Median(around);
  };
  const Buffer<double>& heights = fits.Heights;
  const double high = std::max(6.0 * noise.Deviation, 3.0 * noise.Spacing);
  outliers.assign(spacings.size(), 0);
  for (std::size_t i = 0; i < spacings.size(); ++i)
  {
    // Neighbours of a lonely point are close together, or are lonely as well and lie all around.
    if (spacings[i] > 2.5 * noise.Spacing &&
      (spacings[i] > 2.5 * medianAround(i, spacings) || fits.Some[i] > 0.3 * spacings[i]))
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
  Buffer<double> known;
  for (const double height : heights)
  {
    if (height >= 0.0)
    {
      known.push_back(height);
    }
  }
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
  const NeighborGraph nearest = NearestOrderedPoints(ordered, ManyNeighbors, interrupted);
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
  noise.Deviation = DeviationOf(fits, noise.Spacing);
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
    noise.Deviation =
      DeviationOf(FitEverywhere(ordered, nearest, outliers, false, interrupted), noise.Spacing);
  }
  for (std::size_t k = 0; k < order.size(); ++k)
  {
    noise.Outliers[order[k]] = outliers[k];
  }
  return noise;
}

}
