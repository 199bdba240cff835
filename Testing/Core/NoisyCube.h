// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file NoisyCube.h
 * @brief A cube with noise along the normals and in any direction, of which an independent program
 * tells what methods make.
 */

#ifndef NoisyCube_h
#define NoisyCube_h

#include "MeshDenoising.h"
#include "Metrics.h"
#include "RandomMeshes.h"

#include <gtest/gtest.h>

using namespace SurfaceDenoising;

struct Figures
{
  double MeanAngle = 0.0; ///< between the normals of the faces and those of the clean cube, degrees
  double Volume = 0.0;
  std::size_t FeatureEdges = 0; ///< sharper than 70 degrees
};

inline Figures Measure(const TriangleMesh& mesh, const TriangleMesh& reference)
{
  Execution serial;
  FaceGeometry geometry;
  FaceGeometry clean;
  ComputeFaceGeometry(mesh, 1.0, geometry, serial);
  ComputeFaceGeometry(reference, 1.0, clean, serial);
  Figures figures;
  for (std::size_t f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    figures.MeanAngle +=
      AngleBetween(geometry.Normals[f], clean.Normals[f]) / double(mesh.NumberOfFaces());
  }
  figures.Volume = SignedVolume(mesh, serial);
  const NeighborGraph edges = EdgeAdjacentFaces(mesh, VertexStars(mesh), serial);
  figures.FeatureEdges =
    CompareFeatureEdges(edges, geometry.Normals, geometry.Normals, 70.0, serial).Reference;
  return figures;
}

class NoisyCube : public testing::Test
{
protected:
  NoisyCube()
  {
    AddNormalNoise(this->Noisy, 0.2, 12345);
    AddDirectionNoise(this->DirectionNoisy, 0.3, 12345);
  }

  Figures Denoise(const TriangleMesh& mesh, const MeshDenoisingSettings& settings) const
  {
    TriangleMesh result = mesh;
    Buffer<Vec3> normals;
    MeshDenoisingReport report;
    Execution serial;
    EXPECT_TRUE(DenoiseMesh(result, normals, settings, report, serial));
    return Measure(result, this->Clean);
  }

  TriangleMesh Clean = Cube(8);
  TriangleMesh Noisy = this->Clean;
  TriangleMesh DirectionNoisy = this->Clean;
};

#endif
