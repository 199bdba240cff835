// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Automatic/LocalFits.h"

#include "Automatic/OutwardOrder.h"
#include "KdTree.h"
#include "Metrics.h"
#include "Points/PlaneFit.h"
#include "RobustScale.h"

#include <Eigen/Cholesky>

#include <cmath>
#include <numeric>

namespace SurfaceDenoising
{

namespace
{

constexpr std::size_t FewNeighbors = LocalFits::FewNeighbors;
constexpr std::size_t SomeNeighbors = LocalFits::SomeNeighbors;
constexpr std::size_t ManyNeighbors = LocalFits::ManyNeighbors;
constexpr std::size_t Coefficients = LocalFits::Coefficients;

/// The lesser over the larger variance in the plane, at least; 1/4 on the edge of a surface.
constexpr double LeastWidth = 0.15;

/// Of the normal equations over the number of points, in coordinates of unit variance: clouds
/// without rows have more than twice as much almost everywhere.
constexpr double LeastPivot = 0.05;

/// Cosine of the angle between the planes of the smallest and the largest fit, at least.
constexpr double LeastAgreement = 0.5;

/// Share of the points that have a fit of the smallest size, at least.
constexpr double LeastShare = 0.8;

/// Of the residuals of noise it is 3, of two sheets 1.
constexpr double LeastKurtosis = 2.9;

/// Chance lowers those of fits to N points below 3: their lower quartile by 2.6 to 2.9 over the
/// root of N, whatever the surface.
constexpr double QuartileSpread = 3.5;

/// From the lower quartile to the mean: 0.6 of normally distributed noise, 1.1 of noise of all
/// points in random directions, 2.2 to 3.3 if one point in five is moved, 1.6 and more beside
/// shape.
constexpr double MostKurtosisSpread = 1.4;

/// Points that wide fits are made for.
constexpr std::size_t WidePoints = 4000;

struct QuadricFit
{
  double Deviation = -1.0; ///< of the points of the fit; negative without a fit
  double Height = 0.0;     ///< of the origin over the polynomial
  double Kurtosis = 3.0;   ///< of the residuals; 3 for a normal distribution
  Vec3 Normal = Vec3(0.0, 0.0, 0.0);
};

/// The polynomial over the plane of these points, which are relative to the origin.
QuadricFit FitQuadric(const Vec3* points, std::size_t count)
{
  QuadricFit result;
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
  const Vec3 along = (plane.Along - plane.Normal.dot(plane.Along) * plane.Normal).normalized();
  const Vec3 u = along / std::sqrt(plane.Variances[2]);
  const Vec3 v = plane.Normal.cross(along) / std::sqrt(plane.Variances[1]);
  using Vector = Eigen::Matrix<double, 6, 1>;
  using Matrix = Eigen::Matrix<double, 6, 6>;
  auto basis = [&](const Vec3& p)
  {
    const double x = u.dot(p - plane.Centre);
    const double y = v.dot(p - plane.Centre);
    Vector terms;
    terms << 1.0, x, y, x * x - 1.0, x * y, y * y - 1.0;
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
  // Of a row and a point or two beside it, the polynomial can take up all noise.
  const Eigen::LDLT<Matrix> factors(a);
  if (!(factors.vectorD().minCoeff() > LeastPivot * static_cast<double>(count)))
  {
    return result;
  }
  const Vector solution = factors.solve(b);
  double squares = 0.0;
  double fourth = 0.0;
  for (std::size_t k = 0; k < count; ++k)
  {
    const double r = plane.HeightOf(points[k]) - solution.dot(basis(points[k]));
    squares += r * r;
    fourth += r * r * r * r;
  }
  const double number = static_cast<double>(count);
  result.Deviation = std::sqrt(squares / (number - double(Coefficients)));
  result.Kurtosis =
    squares > 0.0 ? number * fourth / (squares * squares) * (number + 1.0) / (number - 1.0) : 3.0;
  result.Normal = plane.Normal;
  const Vec3 origin(0.0, 0.0, 0.0);
  result.Height = plane.HeightOf(origin) - solution.dot(basis(origin));
  return result;
}

/// Fits to a point, which comes first and is the origin, and its neighbours.
void FitSizes(const std::vector<Vec3>& around, std::size_t i, LocalFits& fits)
{
  auto fit = [&](std::size_t count)
  { return FitQuadric(around.data(), std::min(around.size(), fits.Widening * count + 1)); };
  const QuadricFit few = fit(FewNeighbors);
  const QuadricFit some = fit(SomeNeighbors);
  const QuadricFit many = fit(ManyNeighbors);
  auto deviation = [&](const QuadricFit& smaller)
  {
    const bool turned =
      many.Deviation >= 0.0 && !(std::abs(smaller.Normal.dot(many.Normal)) > LeastAgreement);
    return turned ? -1.0 : smaller.Deviation;
  };
  fits.Few[i] = deviation(few);
  fits.Some[i] = deviation(some);
  fits.Many[i] = many.Deviation;
  fits.Kurtoses[i] = few.Kurtosis;
  fits.ManyKurtoses[i] = many.Kurtosis;
}

void Prepare(LocalFits& fits, std::size_t count)
{
  fits.Few.assign(count, -1.0);
  fits.Some.assign(count, -1.0);
  fits.Many.assign(count, -1.0);
  fits.Kurtoses.assign(count, 3.0);
  fits.ManyKurtoses.assign(count, 3.0);
}

}

bool LocalFits::AreOfSurface() const
{
  std::size_t few = 0;
  std::size_t many = 0;
  for (std::size_t i = 0; i < this->Many.size(); ++i)
  {
    many += this->Many[i] >= 0.0 ? 1 : 0;
    few += this->Many[i] >= 0.0 && this->Few[i] >= 0.0 ? 1 : 0;
  }
  return static_cast<double>(few) >= LeastShare * static_cast<double>(many) &&
    2 * many >= this->Many.size();
}

bool LocalFits::AreOfNoise() const
{
  Buffer<double> kurtoses;
  for (std::size_t i = 0; i < this->Few.size(); ++i)
  {
    if (this->Few[i] >= 0.0)
    {
      kurtoses.push_back(this->Kurtoses[i]);
    }
  }
  if (kurtoses.empty())
  {
    return true;
  }
  const double mean =
    std::accumulate(kurtoses.begin(), kurtoses.end(), 0.0) / static_cast<double>(kurtoses.size());
  const double quartile = Percentile(kurtoses, 0.25);
  const double number = static_cast<double>(this->Widening * FewNeighbors + 1);
  return mean >= LeastKurtosis && quartile >= 3.0 - QuartileSpread / std::sqrt(number) &&
    mean - quartile <= MostKurtosisSpread;
}

Buffer<double> LocalFits::Known(const Buffer<double>& values)
{
  Buffer<double> known;
  for (const double value : values)
  {
    if (value >= 0.0)
    {
      known.push_back(value);
    }
  }
  return known;
}

LocalFits::Residuals LocalFits::ResidualsOfMany() const
{
  Buffer<double> deviations = Known(this->Many);
  if (deviations.empty())
  {
    return { 0.0, 3.0 };
  }
  const double median = Median(deviations);
  Buffer<double> kurtoses;
  for (std::size_t i = 0; i < this->Many.size(); ++i)
  {
    if (this->Many[i] >= 0.0 && this->Many[i] <= median)
    {
      kurtoses.push_back(this->ManyKurtoses[i]);
    }
  }
  return { median, Median(kurtoses) };
}

LocalFits FitEverywhere(const Buffer<Vec3>& points, const CompressedRows& nearest,
  const Buffer<unsigned char>& leftOut, bool heights, Execution& execution)
{
  LocalFits fits;
  Prepare(fits, points.size());
  fits.Heights.assign(heights ? points.size() : 0, -1.0);
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
        const std::size_t others = std::min(around.size() - 1, SomeNeighbors);
        if (others < FewNeighbors)
        {
          continue;
        }
        if (leftOut.empty() || leftOut[i] == 0)
        {
          FitSizes(around, i, fits);
        }
        if (heights)
        {
          const QuadricFit fit = FitQuadric(around.data() + 1, others);
          fits.Heights[i] = fit.Deviation < 0.0 ? -1.0 : std::abs(fit.Height);
        }
      }
    },
    256);
  return fits;
}

bool FitWidely(const Buffer<Vec3>& all, const Buffer<unsigned char>& leftOut, LocalFits& fits,
  Execution& execution)
{
  Buffer<Vec3> points;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    if (leftOut.empty() || leftOut[i] == 0)
    {
      points.push_back(all[i]);
    }
  }
  const Buffer<Index> ranked = OutwardOrder(points, execution);
  const std::size_t count = std::min(points.size(), WidePoints);
  const KdTree tree(points);
  for (std::size_t widening = 2; widening <= LocalFits::MostWidening; widening *= 2)
  {
    if (points.size() < 4 * widening * ManyNeighbors)
    {
      return false;
    }
    LocalFits wide;
    wide.Widening = widening;
    Prepare(wide, count);
    execution.For(
      count,
      [&](std::size_t begin, std::size_t end)
      {
        std::vector<Index> found;
        std::vector<Vec3> around;
        for (std::size_t k = begin; k < end; ++k)
        {
          const Index i = ranked[(2 * k + 1) * points.size() / (2 * count)];
          tree.Nearest(points[i], widening * ManyNeighbors + 1, found);
          around.assign(1, Vec3(0.0, 0.0, 0.0));
          for (const Index j : found)
          {
            if (j != i)
            {
              around.push_back(points[j] - points[i]);
            }
          }
          FitSizes(around, k, wide);
        }
      },
      16);
    if (!execution.Proceed(0.0))
    {
      return false;
    }
    if (wide.AreOfSurface())
    {
      fits = std::move(wide);
      return fits.AreOfNoise();
    }
  }
  return false;
}

}
