// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file Vectorize.h
 * @brief Wide vector instructions for the few loops that need them, with the same bits on every
 * processor.
 */

#ifndef SurfaceDenoising_Vectorize_h
#define SurfaceDenoising_Vectorize_h

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

/**
 * Compiles a function once per instruction set and picks the best at load time. The loops are
 * element by element and the core is built without contraction to fused operations, so that all
 * versions give the same bits. Sanitizers cannot run before the load-time choice.
 */
#if defined(__x86_64__) && defined(__ELF__) && defined(__GNUC__) && !defined(__clang__) &&         \
  !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define SURFACEDENOISING_VECTORIZED __attribute__((target_clones("avx512f", "avx2", "default")))
#define SURFACEDENOISING_AVX512 __attribute__((target("avx512f")))
#define SURFACEDENOISING_DEFAULT __attribute__((target("default")))
#else
#define SURFACEDENOISING_VECTORIZED
#define SURFACEDENOISING_DEFAULT
#endif

namespace SurfaceDenoising
{

/**
 * exp(x) for x <= 0 with a relative error below 1e-15, in a form that compilers vectorise. Below
 * -700, where exp is 1e-304, the value at -700 is returned.
 */
inline double ExpOfNegative(double x)
{
  x = x > -700.0 ? x : -700.0;
  // x = k ln 2 + r. Adding 1.5 * 2^52 rounds to the integer k and leaves it in the low bits of the
  // sum.
  constexpr double shift = 6755399441055744.0;
  const double shifted = x * 1.4426950408889634 + shift;
  const double k = shifted - shift;
  const double r = (x - k * 6.93147180369123816490e-01) - k * 1.90821492927058770002e-10;

  // Taylor's series: |r| <= ln(2) / 2, where the first term left out is 2e-16.
  double series = 1.0 / 479001600.0;
  series = series * r + 1.0 / 39916800.0;
  series = series * r + 1.0 / 3628800.0;
  series = series * r + 1.0 / 362880.0;
  series = series * r + 1.0 / 40320.0;
  series = series * r + 1.0 / 5040.0;
  series = series * r + 1.0 / 720.0;
  series = series * r + 1.0 / 120.0;
  series = series * r + 1.0 / 24.0;
  series = series * r + 1.0 / 6.0;
  series = series * r + 0.5;
  series = series * r + 1.0;
  series = series * r + 1.0;

  // 2^k, by writing k into the exponent of a double.
  std::uint64_t bits;
  std::memcpy(&bits, &shifted, sizeof(bits));
  bits = (bits + 1023) << 52;
  double power;
  std::memcpy(&power, &bits, sizeof(power));
  return series * power;
}

/**
 * The angle between two unit vectors in radians, in [0, pi], from the square of their chord: 2
 * asin(chord / 2), with an absolute error below 1e-15, in a form that compilers vectorise.
 */
inline double AngleOfSquaredChord(double squaredChord)
{
  const double half = 0.5 * std::sqrt(std::min(squaredChord, 4.0));
  // asin(t) = pi / 2 - 2 asin(sqrt((1 - t) / 2)) brings arguments down to 1/2, where a polynomial
  // in t^2, the Chebyshev interpolant of asin(t) / t, does the rest.
  const bool steep = half > 0.5;
  const double t = steep ? std::sqrt(0.5 * (1.0 - half)) : half;
  const double z = t * t;
  double series = 0.03257934796692842;
  series = series * z - 0.02093065831518245;
  series = series * z + 0.02166805886905636;
  series = series * z + 0.0037180577483250537;
  series = series * z + 0.010778675120995992;
  series = series * z + 0.011398850408440755;
  series = series * z + 0.01398088299217101;
  series = series * z + 0.017351600625343435;
  series = series * z + 0.022372216106072148;
  series = series * z + 0.030381942642327187;
  series = series * z + 0.04464285717686322;
  series = series * z + 0.07499999999966611;
  series = series * z + 0.16666666666666796;
  const double angle = 2.0 * (t + t * z * series);
  return steep ? 3.14159265358979323846 - 2.0 * angle : angle;
}

}

#endif
