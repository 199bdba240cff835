// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file InterruptedLoops.h
 * @brief Work on one thread that can be stopped half way: loops in order, and sorting.
 */

#ifndef SurfaceDenoising_InterruptedLoops_h
#define SurfaceDenoising_InterruptedLoops_h

#include "InterruptedExecution.h"

namespace SurfaceDenoising
{

/// Calls body(i) for i in [0, count) in this order, on the calling thread. Asks after so many
/// whether to go on; returns false if not.
template <typename Body>
bool ForInOrder(std::size_t count, const Body& body, Execution& execution, double fraction,
  std::size_t between = std::size_t(1) << 17)
{
  for (std::size_t begin = 0; begin < count; begin += between)
  {
    if (!execution.Proceed(fraction))
    {
      return false;
    }
    const std::size_t end = std::min(count, begin + between);
    for (std::size_t i = begin; i < end; ++i)
    {
      body(i);
    }
  }
  return true;
}

/// The result of std::stable_sort. Returns false if the execution asked to stop; values are then in
/// any order.
template <typename Value, typename Less>
bool SortStably(Buffer<Value>& values, const Less& less, Execution& execution, double fraction)
{
  constexpr std::size_t piece = std::size_t(1) << 16;
  const std::size_t count = values.size();
  InterruptedExecution interrupted(execution, fraction);
  interrupted.For((count + piece - 1) / piece,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t k = begin * piece; k < std::min(count, end * piece); k += piece)
      {
        std::stable_sort(values.begin() + k, values.begin() + std::min(count, k + piece), less);
      }
    },
    1);
  if (!interrupted.Proceed(fraction))
  {
    return false;
  }
  Buffer<Value> merged(count > piece ? count : 0);
  for (std::size_t width = piece; width < count; width *= 2)
  {
    std::size_t left = 0;
    std::size_t middle = 0;
    std::size_t right = 0;
    std::size_t last = 0;
    const bool finished = ForInOrder(
      count,
      [&](std::size_t k)
      {
        if (k == last)
        {
          left = k;
          right = middle = std::min(count, k + width);
          last = std::min(count, middle + width);
        }
        const bool takesRight =
          right < last && (left == middle || less(values[right], values[left]));
        merged[k] = values[takesRight ? right++ : left++];
      },
      execution, fraction);
    if (!finished)
    {
      return false;
    }
    values.swap(merged);
  }
  return true;
}

}

#endif
