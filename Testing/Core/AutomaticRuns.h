// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file AutomaticRuns.h
 * @brief Noisy meshes, denoised without a setting.
 */

#ifndef AutomaticRuns_h
#define AutomaticRuns_h

#include "Automatic/AutomaticMesh.h"
#include "RandomMeshes.h"

#include <gtest/gtest.h>

inline SurfaceDenoising::AutomaticReport Automatic(SurfaceDenoising::TriangleMesh& mesh,
  double strength = 1.0)
{
  SurfaceDenoising::Execution serial;
  SurfaceDenoising::AutomaticReport report;
  EXPECT_TRUE(SurfaceDenoising::DenoiseAutomatically(mesh, strength, report, serial));
  return report;
}

inline SurfaceDenoising::TriangleMesh Noisy(const SurfaceDenoising::TriangleMesh& clean,
  double level)
{
  SurfaceDenoising::TriangleMesh mesh = clean;
  AddNormalNoise(mesh, level, 12345);
  return mesh;
}

#endif
