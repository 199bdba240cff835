// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PointPeers.h"

#include "PointFilter.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/bilateral_smooth_point_set.h>
#include <CGAL/jet_smooth_point_set.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>
#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <memory>
#include <utility>

namespace
{

// As in the examples of its manual.
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Oriented = std::pair<Kernel::Point_3, Kernel::Vector_3>;
using Cloud = std::vector<Oriented>;

const std::string Bilateral = "CGAL Bilateral";
const std::string Jet = "CGAL Jet";

constexpr double SharpnessAngle = 25.0;

template <typename Concurrency>
void Smooth(const std::string& name, Cloud& cloud)
{
  const auto points = CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented>());
  if (name == Bilateral)
  {
    CGAL::bilateral_smooth_point_set<Concurrency>(cloud, BenchmarkNeighbors,
      points.normal_map(CGAL::Second_of_pair_property_map<Oriented>())
        .sharpness_angle(SharpnessAngle));
  }
  else
  {
    CGAL::jet_smooth_point_set<Concurrency>(cloud, BenchmarkNeighbors, points);
  }
}

std::shared_ptr<Cloud> Copy(vtkPolyData* data)
{
  auto cloud = std::make_shared<Cloud>();
  cloud->reserve(std::size_t(data->GetNumberOfPoints()));
  vtkDataArray* normals = data->GetPointData()->GetNormals();
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    const double* p = data->GetPoint(i);
    const double* n = normals->GetTuple(i);
    cloud->emplace_back(Kernel::Point_3(p[0], p[1], p[2]), Kernel::Vector_3(n[0], n[1], n[2]));
  }
  return cloud;
}

}

std::vector<std::string> PointPeerNames() { return { Bilateral, Jet }; }

int PointPeerThreads()
{
#ifdef CGAL_LINKED_WITH_TBB
  return 1024;
#else
  return 1;
#endif
}

std::function<void()> PointPeer(const std::string& name, vtkPolyData* data, int threads)
{
  if (name != Bilateral && name != Jet)
  {
    return {};
  }
  const std::shared_ptr<Cloud> cloud = Copy(data);
  if (threads == 1)
  {
    return [name, cloud] { Smooth<CGAL::Sequential_tag>(name, *cloud); };
  }
#ifdef CGAL_LINKED_WITH_TBB
  return [name, cloud, threads]
  {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
      std::size_t(threads));
    Smooth<CGAL::Parallel_tag>(name, *cloud);
  };
#else
  return {};
#endif
}
