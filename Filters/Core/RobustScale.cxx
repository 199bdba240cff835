// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "RobustScale.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace SurfaceDenoising
{

double Median(Buffer<double>& values)
{
  if (values.empty())
  {
    return 0.0;
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1)
  {
    return *middle;
  }
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

double RobustScale(Buffer<double>& values, ScaleEstimator estimator)
{
  const double median = Median(values);
  switch (estimator)
  {
    case ScaleEstimator::Rayleigh:
      return median / RayleighMedian;
    case ScaleEstimator::HalfNormal:
      return median * MadConsistency;
    case ScaleEstimator::MedianAbsoluteDeviation:
      break;
  }
  for (double& value : values)
  {
    value = std::abs(value - median);
  }
  return MadConsistency * Median(values);
}

double ScaleForOutlierBoundary(NormId norm, double sigma)
{
  switch (norm)
  {
    case NormId::Tukey:
      return std::sqrt(5.0) * sigma;
    case NormId::Lorentzian:
    case NormId::Centin:
      return sigma / std::sqrt(2.0);
    default:
      return sigma;
  }
}

double EfficiencyConstant(NormId norm)
{
  switch (norm)
  {
    case NormId::TruncatedL2:
      return 2.795;
    case NormId::Huber:
      return 1.345;
    case NormId::Lorentzian:
      return 1.686;
    case NormId::Gaussian:
      return 2.111;
    case NormId::Tukey:
      return 4.685;
    case NormId::Box:
      return 2.710;
    case NormId::Centin:
      return 1.292;
    case NormId::L2:
      return std::numeric_limits<double>::infinity();
    case NormId::L1:
    case NormId::TruncatedL1:
      break;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}
