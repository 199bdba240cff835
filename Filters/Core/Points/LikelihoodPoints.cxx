// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LikelihoodPoints.h"

namespace SurfaceDenoising
{

std::unique_ptr<PointOperator> MakeLikelihoodPoints(const LikelihoodPointsSettings&)
{
  return nullptr;
}

}
