// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file Execution.h
 * @brief How loops run, and whether work goes on: the only ties of the core to its host.
 *
 * The core decides what is computed; an Execution decides on which threads and when to stop. The
 * base class runs everything on the calling thread and never stops.
 */

#ifndef SurfaceDenoising_Execution_h
#define SurfaceDenoising_Execution_h

#include "Types.h"

#include <algorithm>
#include <functional>

namespace SurfaceDenoising
{

class Execution
{
public:
  using Body = std::function<void(std::size_t begin, std::size_t end)>;

  virtual ~Execution() = default;

  /**
   * Calls body on ranges that cover [0, count) once, possibly at the same time on several threads.
   * How the range is cut is not defined: what body computes for an element must not depend on it.
   * body must not throw. Fewer than grain elements are not worth a thread.
   */
  virtual void For(std::size_t count, const Body& body, std::size_t /*grain*/ = 4096)
  {
    if (count > 0)
    {
      body(0, count);
    }
  }

  /**
   * Asked between sweeps, from the calling thread only: reports how much of the work is done, in
   * [0, 1], and answers whether to go on. Once it has answered false, results are incomplete.
   */
  virtual bool Proceed(double /*fraction*/) { return true; }
};

/**
 * Sum of term(i) for i in [0, count). Chunks of a fixed size are summed on their own and then added
 * in order, so that the result has the same bits on any number of threads.
 */
template <typename Value, typename Term>
Value OrderedSum(Execution& execution, std::size_t count, Value zero, Term term)
{
  constexpr std::size_t chunk = 4096;
  const std::size_t chunks = (count + chunk - 1) / chunk;
  std::vector<Value> partial(chunks, zero);
  execution.For(
    chunks,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t c = begin; c < end; ++c)
      {
        Value sum = zero;
        const std::size_t last = std::min(count, (c + 1) * chunk);
        for (std::size_t i = c * chunk; i < last; ++i)
        {
          sum += term(i);
        }
        partial[c] = sum;
      }
    },
    1);
  Value total = zero;
  for (const Value& value : partial)
  {
    total += value;
  }
  return total;
}

}

#endif
