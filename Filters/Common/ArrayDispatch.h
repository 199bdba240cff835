// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file ArrayDispatch.h
 * @brief Work on data arrays whatever the type of their values.
 */

#ifndef SurfaceDenoising_ArrayDispatch_h
#define SurfaceDenoising_ArrayDispatch_h

#include "Execution.h"

#include "vtkArrayDispatch.h"
#include "vtkDataArrayRange.h"

namespace SurfaceDenoising
{

/// Runs worker(array, ...) on the fast type of an array with values of some types if it has one,
/// else on vtkDataArray.
template <typename Values = vtkArrayDispatch::Reals, typename Worker, typename... Args>
void OnArray(vtkDataArray* array, Worker worker, Args&&... args)
{
  using Dispatch = vtkArrayDispatch::DispatchByValueType<Values>;
  if (!Dispatch::Execute(array, worker, args...))
  {
    worker(array, args...);
  }
}

/// Copies an array of three components, one tuple per vector.
struct CopyVectors
{
  template <typename Array>
  void operator()(Array* array, Buffer<Vec3>& vectors, Execution& execution) const
  {
    const auto tuples = vtk::DataArrayTupleRange<3>(array);
    execution.For(vectors.size(),
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          const auto t = tuples[static_cast<vtkIdType>(i)];
          vectors[i] = Vec3(t[0], t[1], t[2]);
        }
      });
  }
};

}

#endif
