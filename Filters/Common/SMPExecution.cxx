// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SMPExecution.h"

#include "vtkAlgorithm.h"
#include "vtkSMPTools.h"
#include "vtkSurfaceDenoisingCompat.h"

#include <algorithm>
#include <string>

namespace SurfaceDenoising
{

SMPExecution::SMPExecution(vtkAlgorithm* algorithm, double first, double last)
  : Algorithm(algorithm)
  , First(first)
  , Last(last)
{
}

void SMPExecution::For(std::size_t count, const Body& body, std::size_t grain)
{
  const std::size_t threads = static_cast<std::size_t>(vtkSMPTools::GetEstimatedNumberOfThreads());
  if (threads < 2 || count <= grain)
  {
    Execution::For(count, body, grain);
    return;
  }
  // A few ranges per thread even out their speed.
  const std::size_t range = std::max(grain, count / (8 * threads) + 1);
  vtkSMPTools::For(0, static_cast<vtkIdType>(count), static_cast<vtkIdType>(range),
    [&body](vtkIdType begin, vtkIdType end)
    { body(static_cast<std::size_t>(begin), static_cast<std::size_t>(end)); });
}

bool SMPExecution::Proceed(double fraction)
{
  if (!this->Stopped)
  {
    // Trials repeat parts of the work: nobody wants to see progress go back.
    this->Done = std::max(this->Done, fraction);
    this->Algorithm->UpdateProgress(this->First + (this->Last - this->First) * this->Done);
    this->Stopped = Aborted(this->Algorithm);
  }
  return !this->Stopped;
}

void RunOnThreads(int threads, const std::function<void()>& work)
{
  std::string backend = vtkSMPTools::GetBackend();
  if (threads != 1 && backend == "Sequential")
  {
    backend = "STDThread";
  }
  vtkSMPTools::LocalScope(vtkSMPTools::Config(threads, backend, false), [&work]() { work(); });
}

}
