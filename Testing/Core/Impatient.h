// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file Impatient.h
 * @brief An execution that is stopped.
 */

#ifndef Impatient_h
#define Impatient_h

#include "Execution.h"

#include <gtest/gtest.h>

/// Agrees to go on a number of times.
class Impatient : public SurfaceDenoising::Execution
{
public:
  explicit Impatient(int patience)
    : Patience(patience)
  {
  }

  bool Proceed(double fraction) override
  {
    EXPECT_GE(fraction, 0.0);
    EXPECT_LE(fraction, 1.0);
    return this->Patience-- > 0;
  }

private:
  int Patience;
};

#endif
