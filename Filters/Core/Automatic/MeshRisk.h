// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file MeshRisk.h
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
 * noise turns most, do not outweigh all others. Risks are means over groups of faces, from the
 * flattest surroundings to the sharpest. Nothing means that a risk is not negative.
 */

#ifndef SurfaceDenoising_MeshRisk_h
#define SurfaceDenoising_MeshRisk_h

#include "MeshSample.h"
#include "MethodChain.h"

#include <functional>

namespace SurfaceDenoising
{

/// What moves the vertices of a mesh. Returns false if the execution asked to stop.
using MeshOperation = std::function<bool(TriangleMesh& mesh, Execution& execution)>;

/// Risks of the groups of faces, in units of the noise of the input.
constexpr std::size_t RiskGroups = 8;
using GroupRisks = std::array<double, RiskGroups>;

class MeshRisk
{
public:
  /// The sample must outlive this. pilot makes a smooth surface of the sample, whose faces define
  /// J.
  MeshRisk(const MeshSample& sample, const MethodChain& pilot, Execution& execution);

  /// Share of the faces of the input that look away from those of the pilot: noise in all
  /// directions folds a surface, noise along its normals hardly.
  double FoldedShare() const { return this->Folded; }

  /// Sets sigma, a length above 0. To be called before Of.
  void Assume(double deviation, Execution& execution);

  /**
   * The estimated mean square error of the normals after the operation, over that of the input
   * (which is about 1), per group. Plus half the share of faces that look away from the pilot:
   * folds are no small angles and J does not see them all. Plus, in the flatter half of the groups,
   * how rough the result is, the mean square difference of adjacent normals over that of the input:
   * of noise with heavy tails, Stein's identity does not see the spikes that are left. Returns
   * false if the execution asked to stop.
   */
  bool Of(const MeshOperation& operation, GroupRisks& risks, Execution& execution);

private:
  void Group(const Buffer<Vec3>& vertexNormals);
  /// Groups whose faces should lie in line with their neighbours.
  static constexpr std::size_t FlatGroups = RiskGroups / 2;
  using FlatRoughness = std::array<double, FlatGroups>;

  FlatRoughness RoughnessOf(const TriangleMesh& mesh, Execution& execution) const;
  Vec3 Turn(const Buffer<Vec3>& to, const Buffer<Vec3>& from, std::size_t face) const;

  const MeshSample& Sample;
  double Deviation = 0.0;
  double Folded = 0.0;
  Buffer<Vec3> Normals;                  ///< of the pilot's faces
  Buffer<Vec3> VertexNormals;            ///< of the pilot
  Buffer<std::array<Vec3, 3>> Gradients; ///< of the hat functions of the corners
  Buffer<double> Traces;                 ///< tr(J_f^T J_f); 0: not counted
  std::vector<Buffer<Index>> Groups;     ///< faces that count, flat ones first
  NeighborGraph Adjacent;                ///< faces across edges
  TriangleMesh Plus;
  FlatRoughness RoughnessBefore{}; ///< of Plus
  TriangleMesh Minus;
};

/**
 * A number for each of some risks, which tells how good it is beside the others, the less the
 * better. What an angle is worth falls with its size: the sum over the groups of sqrt(R_g - min R_g
 * + 0.003), in the manner of a mean angle, with the minimum over all risks. What is good everywhere
 * but at the edges is better than what is a little worse everywhere.
 */
std::vector<double> CompareRisks(const std::vector<GroupRisks>& risks);

}

#endif
