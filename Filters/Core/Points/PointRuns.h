// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file PointRuns.h
 * @brief Points in short runs with a box around each, and boxes around boxes.
 *
 * Where points already follow one another along a curve through space, this takes the place of a
 * search tree: nothing has to be sorted any more, and the points of a run look for their neighbours
 * in the same boxes.
 */

#ifndef SurfaceDenoising_PointRuns_h
#define SurfaceDenoising_PointRuns_h

#include "Execution.h"

namespace SurfaceDenoising
{

constexpr std::size_t RunLength = 16;

/**
 * Rearranges numbers of points, which follow a curve through space, within stretches of a thousand,
 * so that every RunLength of them from the first on lie close together.
 */
void FormRuns(const Buffer<Vec3>& points, Buffer<Index>& order, Execution& execution);

/// The boxes of points [0, RunLength), [RunLength, 2 RunLength) and so on. Any order of the points
/// is correct; that of FormRuns is fast.
class PointRuns
{
public:
  /// Children of a box.
  static constexpr std::size_t Fan = 8;

  struct Box
  {
    Vec3 Low;
    Vec3 High;
  };

  /// The boxes of successive children, axis by axis for vector instructions. Those that do not
  /// exist are empty: Low is infinite and High its negative.
  struct Family
  {
    double Low[3][Fan];
    double High[3][Fan];
  };

  /// All points must be finite.
  PointRuns(const Buffer<Vec3>& points, Execution& execution);

  std::size_t NumberOfPoints() const { return this->Count; }
  std::size_t NumberOfRuns() const { return (this->Count + RunLength - 1) / RunLength; }

  /// Coordinates of all points; the last run is filled up with NaN.
  const double* Coordinates(int axis) const { return this->Axes[axis].data(); }

  Vec3 Point(std::size_t i) const
  {
    return { this->Axes[0][i], this->Axes[1][i], this->Axes[2][i] };
  }

  Box BoxOf(std::size_t run) const;

  /// Of the runs [family * Fan, (family + 1) * Fan), of which one must exist.
  Box BoxOfFamily(std::size_t family) const;

  /// Level 0 has the boxes of the runs, level l + 1 those of the families of level l. The last
  /// level has one family.
  const std::vector<Buffer<Family>>& Levels() const { return this->Boxes; }

private:
  Box BoxAt(std::size_t level, std::size_t number) const;

  std::size_t Count;
  Buffer<double> Axes[3];
  std::vector<Buffer<Family>> Boxes;
};

}

#endif
