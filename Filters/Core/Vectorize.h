// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file Vectorize.h
 * @brief Wide vector instructions for the few loops that need them, with the same bits on every
 * processor.
 */

#ifndef SurfaceDenoising_Vectorize_h
#define SurfaceDenoising_Vectorize_h

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
#else
#define SURFACEDENOISING_VECTORIZED
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

}

#endif
