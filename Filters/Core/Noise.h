// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file Noise.h
 * @brief Reproducible random displacements of points.
 *
 * Nothing is drawn in sequence: the numbers of point i are a hash of the seed and i alone. They do
 * not depend on threads, on the order of the work or on other points, and they do not change when
 * points are added at the end.
 *
 * The hash is integer arithmetic and the same everywhere, bit for bit. Turning it into a Gaussian
 * or a direction takes std::log, std::cos and std::sin, whose last bit differs between C libraries:
 * across platforms displacements agree to a relative 1e-14 or so, within one platform exactly.
 */

#ifndef SurfaceDenoising_Noise_h
#define SurfaceDenoising_Noise_h

#include "Types.h"

namespace SurfaceDenoising
{

enum class NoiseKind
{
  Gaussian,  ///< amplitudes N(0, Deviation^2)
  Uniform,   ///< amplitudes evenly from -sqrt(3) Deviation to sqrt(3) Deviation
  Impulsive, ///< a fraction of the points gets Gaussian amplitudes, the others none
};

struct NoiseParameters
{
  NoiseKind Kind = NoiseKind::Gaussian;
  double Deviation = 0.0; ///< standard deviation of the amplitudes, a length
  double Fraction = 0.0;  ///< share of impulsive points, in [0, 1]
  std::uint64_t Seed = 0;
};

/**
 * The displacement of point i is Amplitude(i) times a unit vector: the normal of the point, or
 * Direction(i). The latter moves a point by Deviation in all (RMS), not in every coordinate.
 * May be asked from many threads at once.
 */
class NoiseSource
{
public:
  NoiseSource(const NoiseParameters& parameters, std::size_t numberOfPoints);

  /// Signed length of the displacement of point i.
  double Amplitude(std::size_t i) const;

  /// A unit vector, evenly distributed on the sphere.
  Vec3 Direction(std::size_t i) const;

private:
  NoiseParameters Parameters;
  Buffer<unsigned char> Hit; ///< the points that an impulse reaches; empty for other kinds
};

/**
 * Marks exactly floor(fraction * count) points with 1 and the others with 0; every set of that size
 * is equally likely. Products within 1e-6 below an integer count as that integer, so that 0.29 of
 * 100 points are 29.
 */
Buffer<unsigned char> ChooseFraction(double fraction, std::size_t count, std::uint64_t seed);

}

#endif
