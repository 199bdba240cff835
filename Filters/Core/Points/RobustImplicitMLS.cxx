// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "RobustImplicitMLS.h"

namespace SurfaceDenoising
{

std::unique_ptr<PointOperator> MakeRobustImplicitMLS(const RobustImplicitMLSSettings&)
{
  return nullptr;
}

}
