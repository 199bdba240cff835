// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "MovingLeastSquares.h"

namespace SurfaceDenoising
{

std::unique_ptr<PointOperator> MakeMovingLeastSquares(const MovingLeastSquaresSettings&)
{
  return nullptr;
}

}
