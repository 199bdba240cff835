// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PointDenoising.h"

#include "InterruptedExecution.h"
#include "PointRuns.h"
#include "PointWork.h"
#include "SpatialOrder.h"

namespace SurfaceDenoising
{

bool DenoisePoints(PointCloud& cloud, const PointDenoisingSettings& settings,
  PointDenoisingReport& report, Execution& execution)
{
  Buffer<Index> order = FindPointOrder(cloud.Positions, cloud.Normals, execution);
  InterruptedExecution ordering(execution, 0.0, 0.01);
  FormRuns(cloud.Positions, order, ordering);
  const std::size_t all = cloud.Positions.size();
  report.NotFinite = all - order.size();
  PointWork work(settings, report);
  PointSet& points = work.Points;
  points.Positions = Gather(cloud.Positions, order, ordering);
  if (!cloud.Normals.empty())
  {
    points.Normals = Gather(cloud.Normals, order, ordering);
  }
  if (!ordering.Proceed(0.01) || !execution.Proceed(0.01) || !work.SetUp(execution) ||
    !work.Run(execution) || !execution.Proceed(1.0))
  {
    return false;
  }
  report.Kept = static_cast<std::size_t>(
    std::count(points.Status.begin(), points.Status.end(), PointStatus::Kept));

  // Points that are not finite keep what they came with.
  const bool hadNormals = !cloud.Normals.empty();
  if (!hadNormals)
  {
    cloud.Normals.assign(all, Vec3(0.0, 0.0, 0.0));
  }
  cloud.Status.assign(all, PointStatus::NotFinite);
  cloud.Classes.clear();
  if (!points.Classes.empty())
  {
    cloud.Classes.assign(all, FeatureClass::Flat);
  }
  execution.For(order.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t k = begin; k < end; ++k)
      {
        const Index i = order[k];
        cloud.Positions[i] = points.Positions[k];
        cloud.Status[i] = points.Status[k];
        if (!points.Normals.empty())
        {
          cloud.Normals[i] = points.Normals[k];
        }
        if (!points.Classes.empty())
        {
          cloud.Classes[i] = points.Classes[k];
        }
      }
    });
  return true;
}

}
