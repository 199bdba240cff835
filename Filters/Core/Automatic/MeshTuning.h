// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file MeshTuning.h
 * @brief Chooses the settings of a method for a mesh.
 *
 * Values are the better the smaller the expected error of the normals (MeshRisk.h) under the noise
 * that the mesh has (SurfaceNoise.h), on the mesh or on patches of a large one.
 */

#ifndef SurfaceDenoising_MeshTuning_h
#define SurfaceDenoising_MeshTuning_h

#include "MeshRisk.h"
#include "OpenSettings.h"
#include "SurfaceNoise.h"

namespace SurfaceDenoising
{

struct MeshTuningReport
{
  SurfaceNoise Noise;
  /// There is no noise that a choice could be made for: settings hold what they started with.
  bool NoNoiseFound = false;
  double Seconds = 0.0;
};

/// False if there is no noise that could be told from the shape of a coarse mesh.
bool IsNoisy(const SurfaceNoise& noise);

/// The noise of a mesh as it comes, or of patches of a large one. Returns false if the execution
/// asked to stop.
bool MeasureNoise(const TriangleMesh& mesh, SurfaceNoise& noise, Execution& execution);

/**
 * Gives open settings the best values for a method, which moves the vertices of a mesh as these
 * settings say, and keeps them as chosen ones. The mesh is one as it comes; positions must be
 * finite. Returns false if the execution asked to stop.
 */
bool TuneForMesh(const TriangleMesh& mesh, OpenSettings& open, const MeshOperation& method,
  MeshTuningReport& report, Execution& execution);

}

#endif
