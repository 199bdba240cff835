// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file ChainRisk.h
 * @brief How wrong a denoised surface is, without knowing the right one.
 *
 * Let y = x + e be positions with white noise e of deviation sigma along the normals, g(y) what a
 * method makes of them, and J the linear map from displacements to the angles by which they turn
 * faces. Stein's identity gives the error of the normals up to a term that all methods share:
 *
 *   E |J (g(y) - x)|^2 = E |J (g(y) - y)|^2 + 2 sigma^2 tr(J^T J dg/dy) - sigma^2 tr(J^T J).
 *
 * (C. Stein, "Estimation of the mean of a multivariate normal distribution", Annals of Statistics
 * 9(6), 1981.) The derivative of g is that along one random direction, as in S. Ramani, T. Blu, M.
 * Unser, "Monte-Carlo SURE", IEEE Trans. Image Processing 17(9), 2008: with y+- = y +- b sigma w, w
 * white of deviation 1, its term is <J (g(y+) - g(y-)), J (y+ - y-)> / (2 b^2). Wide steps b look
 * over the jumps that robust weights make.
 *
 * Every face counts in units of its own noise, sigma^2 tr(J_f^T J_f), so that small faces, which
 * noise turns most, do not outweigh all others. Nothing means that a risk is not negative.
 */

#ifndef SurfaceDenoising_ChainRisk_h
#define SurfaceDenoising_ChainRisk_h

#include "../MeshDenoising.h"
#include "MeshSample.h"

namespace SurfaceDenoising
{

/// Methods one after the other.
using MethodChain = std::vector<MeshDenoisingSettings>;

/// Runs all of them on the mesh; their facts of the last are in the report. Returns false if the
/// execution asked to stop.
bool RunChain(TriangleMesh& mesh, const MethodChain& chain, Buffer<Vec3>& normals,
  MeshDenoisingReport& report, Execution& execution);

class ChainRisk
{
public:
  /**
   * The sample must outlive this. deviation is sigma, above 0; pilot makes a smooth surface of the
   * sample, whose faces define J.
   */
  ChainRisk(const MeshSample& sample, double deviation, const MethodChain& pilot,
    Execution& execution);

  /**
   * The estimated mean square error of the normals after the chain, over that of the input (which
   * is 1). Plus 4 times the share of faces that look away from the pilot: folds are no small angles
   * and J does not see them. NaN if the execution asked to stop. An empty chain is the input.
   */
  double Of(const MethodChain& chain, Execution& execution) const;

private:
  Vec3 Turn(const Buffer<Vec3>& to, const Buffer<Vec3>& from, std::size_t face) const;

  const MeshSample& Sample;
  double Deviation;
  Buffer<Vec3> Normals;                  ///< of the pilot's faces
  Buffer<std::array<Vec3, 3>> Gradients; ///< of the hat functions of the corners
  Buffer<double> Traces;                 ///< tr(J_f^T J_f); 0: not counted
  TriangleMesh Plus;
  TriangleMesh Minus;
};

}

#endif
