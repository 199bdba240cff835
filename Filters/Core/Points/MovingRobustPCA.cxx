// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "MovingRobustPCA.h"

namespace SurfaceDenoising
{

std::unique_ptr<PointOperator> MakeMovingRobustPCA(const MovingRobustPCASettings&)
{
  return nullptr;
}

}
