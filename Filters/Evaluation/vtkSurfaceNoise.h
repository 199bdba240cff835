// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSurfaceNoise
 * @brief Adds reproducible noise to the points of a surface or a point set.
 *
 * Point p_i moves to
 *
 *     p_i + a_i d_i
 *
 * with a random signed length a_i (NoiseType) along a direction d_i (Direction). The standard
 * deviation of a_i is Size times the unit length of the input:
 * - with polygons or strips, the mean length of their edges, each edge counted once;
 * - without, the mean distance of a point to its nearest other point.
 *
 * The same input, settings and Seed give the same output on any number of threads: the random
 * numbers of a point are a function of Seed and the point's number. Across platforms results agree
 * to rounding.
 *
 * Topology and all arrays are passed on as they are; the input is not changed. Note that arrays
 * computed from the positions, such as "Normals", then describe the surface without noise: active
 * normals of a surface are therefore no longer active, those of a point set stay so. Single and
 * double precision points keep their type, any other type becomes double. The field data array
 * "NoiseDeviation" holds the standard deviation that was used.
 *
 * Points are independent even if they lie at the same place: surfaces whose faces do not share
 * points are torn apart (merge the points first, vtkCleanPolyData).
 *
 * @par Input that is not perfect
 * Points that are not finite stay as they are and are reported by a warning. Points without a
 * normal (at no face, or at degenerate faces alone, or with a zero vector in Normals) stay where
 * they are when the direction is VertexNormals. If there is no unit length (fewer than two points,
 * all edges of length zero), nothing moves and a warning says so. Empty input gives empty output,
 * and so does an abort, without an error.
 *
 * @sa
 * vtkSurfaceComparison
 */

#ifndef vtkSurfaceNoise_h
#define vtkSurfaceNoise_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkSurfaceDenoisingEvaluationModule.h" // For export macro

class VTKSURFACEDENOISINGEVALUATION_EXPORT vtkSurfaceNoise : public vtkPolyDataAlgorithm
{
public:
  static vtkSurfaceNoise* New();
  vtkTypeMacro(vtkSurfaceNoise, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// How the lengths a_i are distributed. All kinds have mean 0.
  enum NoiseTypes
  {
    Gaussian = 0, ///< normal distribution
    Uniform,      ///< evenly between -sqrt(3) and sqrt(3) standard deviations
    Impulsive     ///< normal distribution for a Fraction of the points, no noise for the others
  };

  ///@{
  /// Default: Gaussian.
  vtkSetClampMacro(NoiseType, int, Gaussian, Impulsive);
  vtkGetMacro(NoiseType, int);
  void SetNoiseTypeToGaussian() { this->SetNoiseType(Gaussian); }
  void SetNoiseTypeToUniform() { this->SetNoiseType(Uniform); }
  void SetNoiseTypeToImpulsive() { this->SetNoiseType(Impulsive); }
  ///@}

  /// The unit vectors d_i.
  enum Directions
  {
    /**
     * With polygons: the normals of the vertices of the input, area-weighted means of the normals
     * of the faces around them, whatever point normals the input has. Without polygons: the point
     * normals of the input, the active ones or the array "Normals", of any length. They must be
     * there, with three components and one for every point, or it is an error.
     */
    VertexNormals = 0,
    /**
     * Evenly distributed on the sphere, independent of a_i. The RMS displacement of a point is Size
     * unit lengths, that is Size / sqrt(3) per coordinate.
     */
    Random
  };

  ///@{
  /// Default: VertexNormals.
  vtkSetClampMacro(Direction, int, VertexNormals, Random);
  vtkGetMacro(Direction, int);
  void SetDirectionToVertexNormals() { this->SetDirection(VertexNormals); }
  void SetDirectionToRandom() { this->SetDirection(Random); }
  ///@}

  ///@{
  /**
   * Standard deviation of a_i in unit lengths (see above), for all types of noise. 0: no noise,
   * 0.1: weak, 0.3: strong, above 0.5 faces fold over one another. For Impulsive it is that of the
   * points that are hit. Default: 0.2.
   */
  vtkSetClampMacro(Size, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Size, double);
  ///@}

  ///@{
  /**
   * Share of the n points that Impulsive noise hits, from 0 to 1: exactly floor(Fraction * n)
   * points, chosen at random. Default: 0.2.
   */
  vtkSetClampMacro(Fraction, double, 0.0, 1.0);
  vtkGetMacro(Fraction, double);
  ///@}

  ///@{
  /// Another seed, other noise of the same kind. Default: 0.
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /// The unit length of the last input: mean edge length or mean distance to the nearest point.
  vtkGetMacro(UnitLength, double);
  ///@}

protected:
  vtkSurfaceNoise() = default;
  ~vtkSurfaceNoise() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int NoiseType = Gaussian;
  int Direction = VertexNormals;
  double Size = 0.2;
  double Fraction = 0.2;
  int Seed = 0;
  double UnitLength = 0.0;

private:
  vtkSurfaceNoise(const vtkSurfaceNoise&) = delete;
  void operator=(const vtkSurfaceNoise&) = delete;

  bool MovePoints(vtkPolyData* input, vtkPolyData* output);
};

#endif
