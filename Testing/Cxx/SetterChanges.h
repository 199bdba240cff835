// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file SetterChanges.h
 * @brief Tells whether a setting of a filter makes a difference.
 */

#ifndef SetterChanges_h
#define SetterChanges_h

#include "AllMeshFilters.h"
#include "AllPointFilters.h"
#include "TestSurfaces.h"

namespace MeshTest
{

using PointTest::LimitIterations;

template <typename Filter>
class Changes
{
public:
  using Setting = std::function<void(Filter*)>;

  /// Of a filter with few iterations, prepared for the settings to matter.
  explicit Changes(Setting prepare = nullptr, vtkPolyData* surface = Roof(16))
    : Surface(surface)
    , Prepare(prepare)
    , Expected(Copy(this->Run(nullptr)))
  {
  }

  /// True if the setting makes a difference to the points.
  bool operator()(Setting set) { return PointDistance(this->Expected, this->Run(set)) > 1e-9; }

private:
  vtkSmartPointer<vtkPolyData> Run(Setting set)
  {
    vtkNew<Filter> filter;
    LimitIterations(filter, 4);
    if (this->Prepare)
    {
      this->Prepare(filter);
    }
    // A setter that does not tell the pipeline has no effect there.
    const vtkMTimeType before = filter->GetMTime();
    if (set)
    {
      set(filter);
    }
    filter->SetInputData(this->Surface);
    filter->Update();
    return set && filter->GetMTime() == before ? this->Expected.Get() : filter->GetOutput();
  }

  vtkSmartPointer<vtkPolyData> Surface;
  Setting Prepare;
  vtkSmartPointer<vtkPolyData> Expected;
};

}

#endif
