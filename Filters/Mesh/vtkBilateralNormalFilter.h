// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkBilateralNormalFilter
 * @brief   bilateral filtering of face normals
 *
 * Y. Zheng, H. Fu, O. K.-C. Au, C.-L. Tai, "Bilateral normal filtering for mesh denoising", IEEE
 * TVCG 17(10), 1521-1530, 2011. The weight of a neighbour j of face i, which is not its own
 * neighbour, is
 *
 *   w_ij = A_j  exp(-|c_i - c_j|^2 / (2 s_c^2))  exp(-|n_i - n_j|^2 / (2 s_r^2)).
 *
 * The LOCAL scheme repeats n_i <- normalise( sum_j w_ij n_j ) with areas, centroids and the spatial
 * scale s_c as in the input. The GLOBAL one finds all normals N at once, those that minimise
 *
 *   (1 - v) sum_i A_i |N_i - sum_j w_ij N_j / sum_j w_ij|^2  +  v sum_i A_i |N_i - n_i|^2,
 *
 * by conjugate gradients, and normalises them. Points move afterwards. Good on moderate noise;
 * edges survive where the normals on either side differ by clearly more than the range scale s_r.
 * On strong noise blotches remain.
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

  /// How normals are found.
  enum Schemes
  {
    LOCAL = 0, ///< by repeated weighted means
    GLOBAL = 1 ///< by one solution of a linear system
  };

  ///@{
  /**
   * How normals are found, one of Schemes. Default LOCAL. GLOBAL solves once per outer iteration,
   * however many normal iterations there are (-1: not at all), and takes a few times as long.
   */
  vtkSetClampMacro(Scheme, int, LOCAL, GLOBAL);
  vtkGetMacro(Scheme, int);
  void SetSchemeToLocal() { this->SetScheme(LOCAL); }
  void SetSchemeToGlobal() { this->SetScheme(GLOBAL); }
  ///@}

  ///@{
  /**
   * The range scale s_r in chord lengths of unit normals (0.35, the default, is 20 degrees; 0.52 is
   * 30; 1 is 60). From 0.2 for little noise to 0.6 for a lot on smooth objects; above 0.45 sharp
   * edges get rounded. 0: from the data.
   */
  vtkSetClampMacro(RangeScale, double, 0.0, 2.0);
  vtkGetMacro(RangeScale, double);
  ///@}

  ///@{
  /// The spatial scale s_c in mean distances of adjacent centroids. Default 1; 0: from the data;
  /// -1: no spatial weight.
  vtkSetClampMacro(SpatialScale, double, -1.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SpatialScale, double);
  ///@}

  ///@{
  /// Which faces are averaged, one of Neighborhoods. Default VERTEX_SHARING.
  vtkSetClampMacro(Neighborhood, int, EDGE_ADJACENT, VERTEX_SHARING);
  vtkGetMacro(Neighborhood, int);
  void SetNeighborhoodToEdgeAdjacent() { this->SetNeighborhood(EDGE_ADJACENT); }
  void SetNeighborhoodToVertexSharing() { this->SetNeighborhood(VERTEX_SHARING); }
  ///@}

  ///@{
  /**
   * The weight v of the input in the GLOBAL scheme, in [1e-9, 1]. Default 0.01: the smaller, the
   * smoother, and the longer it takes.
   */
  vtkSetClampMacro(Fidelity, double, 1e-9, 1.0);
  vtkGetMacro(Fidelity, double);
  ///@}

  ///@{
  /**
   * Weigh the energies of the GLOBAL scheme with face areas, as the paper does (default), or all
   * alike, as a program of others does.
   */
  vtkSetMacro(AreaEnergy, bool);
  vtkGetMacro(AreaEnergy, bool);
  vtkBooleanMacro(AreaEnergy, bool);
  ///@}

protected:
  vtkBilateralNormalFilter();
  ~vtkBilateralNormalFilter() override;

  const SurfaceDenoising::MeshDenoisingSettings& Defaults() const override;
  void Configure(SurfaceDenoising::MeshDenoisingSettings& settings) override;

  int Scheme = LOCAL;
  double RangeScale;
  double SpatialScale;
  int Neighborhood;
  double Fidelity;
  bool AreaEnergy;

private:
  vtkBilateralNormalFilter(const vtkBilateralNormalFilter&) = delete;
  void operator=(const vtkBilateralNormalFilter&) = delete;
};

#endif
