// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file RandomMeshes.h
 * @brief Small meshes with all the faults that meshes have, reproducible from a seed.
 */

#ifndef RandomMeshes_h
#define RandomMeshes_h

#include "TriangleMesh.h"

#include <cstdint>
#include <iosfwd>
#include <vector>

/// A generator that other programs can repeat: x <- 1664525 x + 1013904223 modulo 2^32.
class PortableRandom
{
public:
  explicit PortableRandom(std::uint32_t seed)
    : State(seed)
  {
  }
  double Uniform();                   ///< (x + 0.5) / 2^32, in (0, 1)
  double Gaussian();                  ///< mean 0, standard deviation 1, from two uniform numbers
  SurfaceDenoising::Vec3 Direction(); ///< a unit vector, evenly distributed
  std::uint32_t Below(std::size_t count); ///< in [0, count)

private:
  std::uint32_t State;
};

/**
 * The unit cube with n x n squares of two triangles on each side. Vertices in the order of nested
 * loops over x, y, z; faces by axis, side, and the two coordinates of the side.
 */
SurfaceDenoising::TriangleMesh Cube(int n);

/// Moves every vertex along its normal by Gaussian amplitudes, relative to the mean edge length.
void AddNormalNoise(SurfaceDenoising::TriangleMesh& mesh, double relative, std::uint32_t seed);

/// Moves every vertex in a random direction by Gaussian amplitudes, relative to the mean edge
/// length.
void AddDirectionNoise(SurfaceDenoising::TriangleMesh& mesh, double relative, std::uint32_t seed);

/// A plane sheet on the square [0, 1]^2 with irregular triangles and an open border.
SurfaceDenoising::TriangleMesh PlaneSheet(int n, std::uint32_t seed);

struct MeshRecipe
{
  const char* Name;
  SurfaceDenoising::TriangleMesh (*Make)(std::uint32_t seed);
  bool NeedsRepair; ///< seams or faces against their neighbours, which the core handles
};

const std::vector<MeshRecipe>& MeshRecipes();

/// For the names of parameterised tests.
void PrintTo(const MeshRecipe& recipe, std::ostream* out);

#endif
