// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "VotingTensorPoints.h"

namespace SurfaceDenoising
{

std::unique_ptr<PointOperator> MakeVotingTensorPoints(const VotingTensorPointsSettings&)
{
  return nullptr;
}

}
