// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file PatchGuidance.h
 * @brief Guidance normals: the mean normal of the most consistent patch around a face.
 *
 * W. Zhang, B. Deng, J. Zhang, S. Bouaziz, L. Liu, "Guided mesh normal filtering", Computer
 * Graphics Forum 34(7), 2015. The patch of a face is the face with all that share a vertex with it.
 * Its inconsistency is H = Phi R: Phi, the largest chord between two of its normals; R, the largest
 * chord across an edge inside of the patch over the sum of these (plus 1e-9), which tells one sharp
 * edge from noise everywhere; 1 without such an edge. A face takes the area-weighted mean normal of
 * the least inconsistent of all patches that contain it, on a tie its own, then the first.
 */

#ifndef SurfaceDenoising_PatchGuidance_h
#define SurfaceDenoising_PatchGuidance_h

#include "NeighborGraph.h"

namespace SurfaceDenoising
{

class PatchGuidance
{
public:
  /// The graphs, of faces that share an edge or a vertex, must outlive the guidance.
  PatchGuidance(const TriangleMesh& mesh, const NeighborGraph& edgeAdjacent,
    const NeighborGraph& vertexSharing, Execution& execution);

  /**
   * Faces without normal belong to no patch. A face that is in no patch of at least two faces keeps
   * its normal.
   */
  void Compute(const Buffer<Vec3>& normals, const Buffer<double>& areas, Buffer<Vec3>& guidance,
    Execution& execution);

  /// H of the patch of every face in the last call, infinite if it is none.
  const Buffer<double>& Inconsistencies() const { return this->Inconsistency; }

private:
  const NeighborGraph& Members;  ///< of the patch of every face, but the face itself
  const NeighborGraph& Adjacent; ///< faces that share an edge
  CompressedRows InnerEdges;     ///< of every patch, as entries of Adjacent

  // Kept between calls: the memory of one is that of the next.
  Buffer<double> EdgeChords; ///< per entry of Adjacent; -1 at a face without normal
  Buffer<double> Inconsistency;
  Buffer<Vec3> PatchNormals;
};

}

#endif
