// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file InterruptedExecution.h
 * @brief Loops that can be stopped half way, for sweeps that take seconds.
 */

#ifndef SurfaceDenoising_InterruptedExecution_h
#define SurfaceDenoising_InterruptedExecution_h

#include "Execution.h"

#include <chrono>

namespace SurfaceDenoising
{

/**
 * Runs loops in pieces and asks in between whether to go on; after a no, nothing runs any more and
 * results are incomplete. Pieces begin small, and shrink and grow so that they take a tenth of a
 * second, on however many threads. The first loop reports progress from first to last, others that
 * follow stay there.
 */
class InterruptedExecution : public Execution
{
public:
  InterruptedExecution(Execution& execution, double first, double last)
    : Whole(execution)
    , First(first)
    , Last(last)
  {
  }

  InterruptedExecution(Execution& execution, double fraction)
    : InterruptedExecution(execution, fraction, fraction)
  {
  }

  void For(std::size_t count, const Body& body, std::size_t grain) override
  {
    // Elements that are worth this take long enough for small shares, of which a piece must have
    // some for every thread.
    grain = std::min<std::size_t>(grain, 64);
    const std::size_t most = std::max(64 * grain, (count + 31) / 32);
    std::size_t piece = std::max(grain, (count + 127) / 128);
    for (std::size_t begin = 0; begin < count && this->Going;)
    {
      const auto start = std::chrono::steady_clock::now();
      const std::size_t length = std::min(piece, count - begin);
      this->Whole.For(
        length, [&](std::size_t b, std::size_t e) { body(begin + b, begin + e); }, grain);
      begin += length;
      const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
      piece = taken.count() > 0.2 ? std::max(grain, piece / 2)
        : taken.count() < 0.06    ? std::min(most, piece * 2)
                                  : piece;
      const double done = static_cast<double>(begin) / static_cast<double>(count);
      this->Share = std::max(this->Share, done);
      this->Going = this->Whole.Proceed(this->First + (this->Last - this->First) * this->Share);
    }
  }

  bool Proceed(double) override { return this->Going; }

private:
  Execution& Whole;
  double First;
  double Last;
  double Share = 0.0; ///< of the way from first to last
  bool Going = true;
};

}

#endif
