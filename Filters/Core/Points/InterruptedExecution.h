// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file InterruptedExecution.h
 * @brief Loops that can be stopped half way, for sweeps that take seconds.
 */

#ifndef SurfaceDenoising_InterruptedExecution_h
#define SurfaceDenoising_InterruptedExecution_h

#include "Execution.h"

namespace SurfaceDenoising
{

/**
 * Runs loops in pieces and asks in between whether to go on; after a no, nothing runs any more and
 * results are incomplete. Progress goes from first to last in every loop, but never back.
 */
class InterruptedExecution : public Execution
{
public:
  InterruptedExecution(Execution& execution, double first, double last)
    : Whole(execution)
    , Start(first)
    , Reached(first)
    , Last(last)
  {
  }

  InterruptedExecution(Execution& execution, double fraction)
    : InterruptedExecution(execution, fraction, fraction)
  {
  }

  void For(std::size_t count, const Body& body, std::size_t grain) override
  {
    // Elements that are worth this take long enough for small shares.
    grain = std::min<std::size_t>(grain, 512);
    const std::size_t piece = std::max(grain, (count + 31) / 32);
    for (std::size_t begin = 0; begin < count && this->Going; begin += piece)
    {
      this->Whole.For(
        std::min(piece, count - begin),
        [&](std::size_t b, std::size_t e) { body(begin + b, begin + e); }, grain);
      const double done =
        static_cast<double>(std::min(count, begin + piece)) / static_cast<double>(count);
      this->Reached = std::max(this->Reached, this->Start + (this->Last - this->Start) * done);
      this->Going = this->Whole.Proceed(this->Reached);
    }
  }

  bool Proceed(double) override { return this->Going; }

private:
  Execution& Whole;
  double Start;
  double Reached; ///< the most that was reported
  double Last;
  bool Going = true;
};

}

#endif
