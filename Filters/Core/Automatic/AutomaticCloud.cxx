// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Automatic/AutomaticCloud.h"

#include "Automatic/ProgressShare.h"
#include "Automatic/SurfaceStep.h"
#include "InterruptedExecution.h"
#include "KdTree.h"
#include "SpatialOrder.h"

namespace SurfaceDenoising
{

namespace
{

/// Places of outliers on the surface of the denoised points; those farther away than reach stay.
void PullOutliers(PointCloud& cloud, const Buffer<Index>& outliers, const PointCloud& clean,
  double reach, AutomaticCloudReport& report, Execution& execution)
{
  const KdTree tree(clean.Positions);
  execution.For(
    outliers.size(),
    [&](std::size_t begin, std::size_t end)
    {
      std::vector<Index> found;
      SurfaceStep way;
      for (std::size_t k = begin; k < end; ++k)
      {
        const Index i = outliers[k];
        const Vec3 place = cloud.Positions[i];
        cloud.Status[i] = PointStatus::Kept;
        tree.Nearest(place, SurfaceStep::QuadricNeighbors, found);
        way.Start();
        Vec3 side(0.0, 0.0, 0.0);
        for (const Index j : found)
        {
          way.Add(clean.Positions[j] - place);
          side += clean.Normals[j];
        }
        Vec3 normal;
        const Vec3 step = way.Step(normal);
        if (!normal.isZero(0.0) && step.norm() <= reach)
        {
          cloud.Positions[i] = place + step;
          cloud.Normals[i] = side.dot(normal) < 0.0 ? Vec3(-normal) : normal;
          cloud.Status[i] = PointStatus::Filtered;
        }
      }
    },
    256);
  report.Pulled = std::size_t(std::count_if(outliers.begin(), outliers.end(),
    [&](Index i) { return cloud.Status[i] == PointStatus::Filtered; }));
  report.LeftOutliers = outliers.size() - report.Pulled;
}

}

bool DenoiseAutomatically(PointCloud& cloud, const AutomaticSettings& asked,
  AutomaticCloudReport& report, Execution& execution)
{
  report = AutomaticCloudReport();
  const double strength = asked.CheckedStrength();
  if (!(strength > 0.0))
  {
    report.Choice.Reason = "The strength is 0.";
    return true;
  }
  InterruptedExecution measuring(execution, 0.0);
  report.Noise = EstimateNoise(cloud.Positions, measuring);
  if (!measuring.Proceed(0.0) || !execution.Proceed(0.1))
  {
    return false;
  }
  // Points along a curve through space, so that nothing depends on their order.
  const Buffer<Index> order = FindPointOrder(cloud.Positions, cloud.Normals, execution);
  Buffer<Index> kept;
  Buffer<Index> outliers;
  for (const Index i : order)
  {
    (report.Noise.Outliers[i] != 0 ? outliers : kept).push_back(i);
  }
  PointCloud clean;
  clean.Positions = Gather(cloud.Positions, kept);
  clean.Normals = cloud.Normals.empty() ? Buffer<Vec3>() : Gather(cloud.Normals, kept);
  ProgressShare choosing(execution, 0.1, 0.1);
  report.Choice = ChooseForCloud(clean.Positions, report.Noise, strength, asked.Type, choosing);
  if (!choosing.Proceed(0.0))
  {
    return false;
  }
  if (report.Choice.Nothing && outliers.empty())
  {
    return true;
  }
  PointDenoisingSettings settings = report.Choice.Settings;
  if (report.Choice.Nothing)
  {
    settings.OuterIterations = 0; // normals tell outliers the side
  }
  ProgressShare denoising(execution, 0.3, 1.0);
  if (!DenoisePoints(clean, settings, report.Denoising, denoising) || !execution.Proceed(1.0))
  {
    return false;
  }
  const std::size_t all = cloud.Positions.size();
  cloud.Normals.resize(all, Vec3(0.0, 0.0, 0.0));
  cloud.Status.assign(all, PointStatus::NotFinite);
  cloud.Classes.clear();
  for (std::size_t k = 0; k < kept.size(); ++k)
  {
    cloud.Positions[kept[k]] = clean.Positions[k];
    cloud.Normals[kept[k]] = clean.Normals[k];
    cloud.Status[kept[k]] = clean.Status[k];
  }
  InterruptedExecution pulling(execution, 1.0);
  PullOutliers(cloud, outliers, clean, 10.0 * report.Noise.Spacing, report, pulling);
  report.Denoising.NotFinite = all - order.size();
  return pulling.Proceed(1.0);
}

}
