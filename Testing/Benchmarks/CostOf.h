// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file CostOf.h
 * @brief What a piece of work takes.
 */

#ifndef CostOf_h
#define CostOf_h

#include <chrono>
#include <ctime>

struct Cost
{
  double Seconds = 0.0;
  double ProcessorSeconds = 0.0; ///< of all threads; other programs disturb it less
};

template <typename Work>
Cost CostOf(const Work& work)
{
  const std::clock_t processorStart = std::clock();
  const auto start = std::chrono::steady_clock::now();
  work();
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  return { seconds.count(), double(std::clock() - processorStart) / CLOCKS_PER_SEC };
}

#endif
