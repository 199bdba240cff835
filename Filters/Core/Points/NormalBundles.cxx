// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "NormalBundles.h"

namespace SurfaceDenoising
{

std::unique_ptr<PointOperator> MakeNormalBundles(const NormalBundlesSettings&) { return nullptr; }

}
