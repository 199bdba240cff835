// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkBilateralNormalFilter
 * @brief   bilateral filtering of face normals
 *
 * The local scheme of Y. Zheng, H. Fu, O. K.-C. Au, C.-L. Tai, "Bilateral normal filtering for mesh
 * denoising", IEEE TVCG 17(10), 1521-1530, 2011:
 *
 *   n_i <- normalise( sum_{j in N(i)}  A_j  exp(-|c_i - c_j|^2 / (2 s_c^2))  exp(-|n_i - n_j|^2 /
 * (2 s_r^2))  n_j )
 *
 * over the neighbours N(i) of face i without the face itself, with areas, centroids and the spatial
 * scale s_c as in the input, then the vertex update. Good on moderate noise; edges survive where
 * the normals on either side differ by clearly more than the range scale s_r. On strong noise
 * blotches remain.
 *
 * In robust terms: a Gaussian error norm on the chord between normals, with a spatial Gaussian.
 *
 * Differs from the paper: face flips are prevented unless PreventFlips is switched off.
 */

#ifndef vtkBilateralNormalFilter_h
#define vtkBilateralNormalFilter_h

#include "vtkFaceNormalFilter.h"

class VTKSURFACEDENOISINGMESH_EXPORT vtkBilateralNormalFilter : public vtkFaceNormalFilter
{
public:
  static vtkBilateralNormalFilter* New();
  vtkTypeMacro(vtkBilateralNormalFilter, vtkFaceNormalFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The range scale s_r in chord lengths of unit normals (0.35, the default, is 20 degrees; 0.52 is
   * 30; 1 is 60). From 0.2 for little noise to 0.6 for a lot on smooth objects; above 0.45 sharp
   * edges get rounded. 0: taken from the data, the robust standard deviation (median absolute
   * deviation) of the differences of neighbouring normals.
   */
  vtkSetClampMacro(RangeScale, double, 0.0, 2.0);
  vtkGetMacro(RangeScale, double);
  ///@}

  ///@{
  /// The spatial scale s_c in mean distances between the centroids of adjacent faces. Default 1; 0:
  /// no spatial kernel.
  vtkSetClampMacro(SpatialScale, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SpatialScale, double);
  ///@}

  ///@{
  /// N(i), EDGE_ADJACENT or VERTEX_SHARING (default).
  vtkSetClampMacro(Neighborhood, int, EDGE_ADJACENT, VERTEX_SHARING);
  vtkGetMacro(Neighborhood, int);
  void SetNeighborhoodToEdgeAdjacent() { this->SetNeighborhood(EDGE_ADJACENT); }
  void SetNeighborhoodToVertexSharing() { this->SetNeighborhood(VERTEX_SHARING); }
  ///@}

protected:
  vtkBilateralNormalFilter();
  ~vtkBilateralNormalFilter() override;

  void Configure(SurfaceDenoising::MeshDenoisingSettings& settings) override;

  double RangeScale = 0.35;
  double SpatialScale = 1.0;
  int Neighborhood = VERTEX_SHARING;

private:
  vtkBilateralNormalFilter(const vtkBilateralNormalFilter&) = delete;
  void operator=(const vtkBilateralNormalFilter&) = delete;
};

#endif
