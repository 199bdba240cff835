// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TensorRegions.h"

namespace SurfaceDenoising
{

std::unique_ptr<PointOperator> MakeTensorRegions(const TensorRegionsSettings&) { return nullptr; }

}
