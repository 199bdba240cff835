// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "NormalTensor.h"

#include "SymmetricEigen.h"

namespace SurfaceDenoising
{

Vec3 NormalTensorValues(const NormalFilter& filter, const Buffer<Vec3>& normals, std::size_t i,
  const double* weights)
{
  Mat3 tensor = Mat3::Zero();
  auto vote = [&](const Vec3& n) { tensor += *weights++ * n * n.transpose(); };
  if (filter.IncludesOwn())
  {
    vote(normals[i]);
  }
  for (const Index j : filter.Neighbors().Row(i))
  {
    vote(normals[j]);
  }
  // The trace is the sum of the weights, of those with a normal.
  const double trace = tensor.trace();
  if (!(trace > NormalFilter::NoWeight))
  {
    return Vec3(0.0, 0.0, 0.0);
  }
  return Decompose(tensor / trace).Values.reverse().cwiseMax(0.0);
}

}
