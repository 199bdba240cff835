// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file ProgressShare.h
 * @brief A part of a longer work, which reports progress from 0 to 1 of its own.
 */

#ifndef SurfaceDenoising_ProgressShare_h
#define SurfaceDenoising_ProgressShare_h

#include "../Execution.h"

namespace SurfaceDenoising
{

/// Runs loops on another execution and tells it of progress from first to last.
class ProgressShare : public Execution
{
public:
  ProgressShare(Execution& execution, double first, double last)
    : Whole(execution)
    , First(first)
    , Last(last)
  {
  }

  void For(std::size_t count, const Body& body, std::size_t grain) override
  {
    this->Whole.For(count, body, grain);
  }

  bool Proceed(double fraction) override
  {
    return this->Whole.Proceed(this->First + (this->Last - this->First) * fraction);
  }

private:
  Execution& Whole;
  double First;
  double Last;
};

}

#endif
