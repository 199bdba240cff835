// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CloudTuning.h"

#include "../SpatialOrder.h"
#include "../Stopwatch.h"
#include "CloudNoise.h"
#include "CloudRisk.h"
#include "InterruptedExecution.h"
#include "ProgressShare.h"

#include <cmath>

namespace SurfaceDenoising
{

namespace
{

/// Parts of the cloud that values are tried on, and those that the best are confirmed on.
constexpr std::size_t TrialParts = 5;
constexpr std::size_t FineParts = 15;

bool EstimateNoise(const PointCloud& cloud, CloudNoise& noise, CloudTuningReport& report,
  Execution& execution)
{
  InterruptedExecution measuring(execution, 0.0);
  noise = EstimateNoise(cloud.Positions, measuring);
  report.Spacing = noise.Spacing;
  report.Deviation = noise.Deviation;
  report.NoNoiseFound = !noise.IsNoisy();
  return measuring.Proceed(0.0) && execution.Proceed(0.0);
}

class CloudJudge : public OpenSettings::Judge
{
public:
  CloudJudge(const CloudRisk& risk, const PointDenoisingSettings& settings)
    : Risk(risk)
    , Settings(settings)
  {
  }

  bool Try(Execution& execution) override
  {
    InterruptedExecution trial(execution, 0.0);
    const double risk = this->Risk.Of(this->Settings, trial);
    this->Risks.push_back(std::isfinite(risk) ? risk : 1e300);
    return trial.Proceed(0.0) && execution.Proceed(1.0);
  }

  std::vector<double> Costs() const override { return this->Risks; }

private:
  const CloudRisk& Risk;
  const PointDenoisingSettings& Settings;
  std::vector<double> Risks;
};

}

bool MeasureNoise(const PointCloud& cloud, CloudTuningReport& report, Execution& execution)
{
  CloudNoise noise;
  return EstimateNoise(cloud, noise, report, execution);
}

bool TuneForCloud(const PointCloud& cloud, OpenSettings& open,
  const PointDenoisingSettings& settings, CloudTuningReport& report, Execution& execution)
{
  report = CloudTuningReport();
  const Stopwatch stopwatch(report.Seconds);
  CloudNoise noise;
  if (!EstimateNoise(cloud, noise, report, execution))
  {
    return false;
  }
  if (!report.NoNoiseFound)
  {
    Buffer<Index> inliers;
    for (std::size_t i = 0; i < cloud.Positions.size(); ++i)
    {
      if (cloud.Positions[i].allFinite() && noise.Outliers[i] == 0)
      {
        inliers.push_back(static_cast<Index>(i));
      }
    }
    const Buffer<Vec3> points = Gather(cloud.Positions, inliers);
    const Buffer<Vec3> normals =
      cloud.Normals.empty() ? Buffer<Vec3>() : Gather(cloud.Normals, inliers);
    const CloudRisk rough(points, normals, noise, noise.Deviation, TrialParts, execution);
    report.NoNoiseFound = !rough.GetSample().IsMeaningful();
    if (!report.NoNoiseFound)
    {
      CloudJudge first(rough, settings);
      ProgressShare searching(execution, 0.0, 0.7);
      if (!open.Search(first, searching))
      {
        return false;
      }
      const CloudRisk fine(points, normals, noise, noise.Deviation, FineParts, execution);
      CloudJudge second(fine, settings);
      ProgressShare confirming(execution, 0.7, 1.0);
      if (fine.GetSample().Positions.size() > rough.GetSample().Positions.size() &&
        !open.Confirm(first, second, confirming))
      {
        return false;
      }
    }
  }
  open.Keep();
  return execution.Proceed(1.0);
}

}
