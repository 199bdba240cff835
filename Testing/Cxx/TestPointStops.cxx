// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// Filters can be stopped on clouds of many points, whatever their order: they ask often
// enough. The setup is what a filter does at least.

#include "PointFilterTester.h"

#include "vtkRobustPointNormalFilter.h"
#include "vtkVotingTensorPointFilter.h"

#include <cstdlib>
#include <numeric>
#include <random>

namespace
{

using namespace PointTest;

/// A noisy sphere whose points come in any order.
vtkSmartPointer<vtkPolyData> ShuffledCloud(int count)
{
  auto sphere = SphereCloud(count, 0.3 / std::sqrt(count));
  std::vector<vtkIdType> order(static_cast<std::size_t>(count));
  std::iota(order.begin(), order.end(), vtkIdType(0));
  std::shuffle(order.begin(), order.end(), std::mt19937(7));
  Places places;
  for (const vtkIdType i : order)
  {
    const double* p = sphere->GetPoint(i);
    places.push_back({ p[0], p[1], p[2] });
  }
  return MakeCloud(places);
}

/// Counts the questions whether to go on; ends the work when it comes to its second half.
class Watch : public vtkCommand
{
public:
  vtkTypeMacro(Watch, vtkCommand);
  static Watch* New() { return new Watch; }

  void Execute(vtkObject* caller, unsigned long, void*) override
  {
    ++this->Questions;
    auto* algorithm = vtkAlgorithm::SafeDownCast(caller);
    if (algorithm->GetProgress() > 0.5)
    {
      algorithm->SetAbortExecute(1);
    }
  }

  int Questions = 0;
};

void TestStops(const char* name, vtkPointDenoisingFilter* filter, vtkPolyData* cloud, int& failures)
{
  vtkNew<Watch> watch;
  filter->SetInputData(cloud);
  filter->SetNumberOfOuterIterations(1);
  filter->AddObserver(vtkCommand::ProgressEvent, watch);
  filter->Update();
  std::cout << name << " has asked " << watch->Questions << " times\n";
  CHECK(watch->Questions > 100);
}

}

int TestPointStops(int, char*[])
{
  int failures = 0;
  const auto cloud = ShuffledCloud(400000);
  vtkNew<vtkRobustPointNormalFilter> robust;
  robust->SetNormalSourceToPlaneFit();
  TestStops("The composer", robust, cloud, failures);
  vtkNew<vtkVotingTensorPointFilter> released;
  released->AsReleasedOn();
  TestStops("The released program", released, cloud, failures);
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
