// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceStep.h"

#include "Points/PlaneFit.h"

#include <cmath>

namespace SurfaceDenoising
{

Vec3 SurfaceStep::Step(Vec3& normal)
{
  PlaneSum few;
  PlaneSum all;
  double scale = 0.0;
  for (std::size_t k = 0; k < this->Offsets.size(); ++k)
  {
    all.Add(this->Offsets[k]);
    scale += this->Offsets[k].norm() / double(this->Offsets.size());
    if (k < PlaneNeighbors)
    {
      few.Add(this->Offsets[k]);
    }
  }
  const Plane plane = few.Fit();
  normal = plane.Normal;
  const double height = plane.Normal.dot(plane.Centre);
  const Vec3 up = all.Fit().Normal;
  if (!up.isZero(0.0) && scale > 0.0)
  {
    this->Quadric.Start(up, scale);
    for (const Vec3& offset : this->Offsets)
    {
      this->Quadric.Add(offset);
    }
    const double other = this->Quadric.Height();
    if (std::abs(other) < std::abs(height))
    {
      normal = up;
      return other * up;
    }
  }
  return height * plane.Normal;
}

}
