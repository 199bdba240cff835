// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file Stopwatch.h
 * @brief How long things take.
 */

#ifndef SurfaceDenoising_Stopwatch_h
#define SurfaceDenoising_Stopwatch_h

#include <chrono>

namespace SurfaceDenoising
{

/// Adds the seconds of its life to a sum.
class Stopwatch
{
public:
  explicit Stopwatch(double& seconds)
    : Seconds(seconds)
    , Start(std::chrono::steady_clock::now())
  {
  }
  ~Stopwatch()
  {
    const std::chrono::duration<double> life = std::chrono::steady_clock::now() - this->Start;
    this->Seconds += life.count();
  }
  Stopwatch(const Stopwatch&) = delete;
  void operator=(const Stopwatch&) = delete;

private:
  double& Seconds;
  std::chrono::steady_clock::time_point Start;
};

}

#endif
