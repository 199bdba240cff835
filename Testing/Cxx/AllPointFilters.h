// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file AllPointFilters.h
 * @brief Every filter that denoises point sets, with every setting that makes another method of it.
 *
 * What all filters promise is tested on all of this list, which has every row of the table of
 * methods by itself. A new variant of the composer is added to it, with what is special about it.
 */

#ifndef AllPointFilters_h
#define AllPointFilters_h

#include "vtkPointDenoisingFilter.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <iostream>
#include <string>
#include <vector>

namespace PointTest
{

/// What is special about a filter.
enum Trait : unsigned
{
  /// It has the numbers of a paper, whatever was set.
  OWN_SETTINGS = 1,
  /// It tells flat points, edges and corners apart.
  TELLS_CLASSES = 2,
  /// The signs of normals mean nothing to it, without a setting.
  IGNORES_SIGNS = 4,
  /// It looks at positions alone; normals to start with tell the side of those in the result.
  IGNORES_NORMALS = 8,
  /// It takes a scale from the noise of the normals, and warns if there is none.
  NEEDS_NOISE = 16,
  /// It takes curved surfaces of few points for features, and makes facets of them. Points may get
  /// the normal of another one, which may be on the other side.
  MAKES_FACETS = 32,
  /// It reproduces the program of others: points move one after the other, so that the result
  /// depends on their order and on the size of the model, and normals come from fits of its own.
  AS_RELEASED = 64
};

struct PointFilter
{
  std::string Name;   ///< unlike any other
  std::string Method; ///< the row of the table of methods that it is the filter of, or empty
  std::function<vtkSmartPointer<vtkPointDenoisingFilter>()> MakeDefault;
  unsigned Traits = 0;

  /// With few iterations, for speed.
  vtkSmartPointer<vtkPointDenoisingFilter> Make() const;

  bool Is(Trait trait) const { return (this->Traits & trait) != 0; }
};

const std::vector<PointFilter>& AllPointFilters();

/// Leaves a filter no more than so many iterations of each kind.
void LimitIterations(vtkPointDenoisingFilter* filter, int limit);

/// Makes a filter take n and -n for the same normal, if it can be told to.
void IgnoreSigns(vtkPointDenoisingFilter* filter);

/// Runs test(filter, failures) on all of them, and says whose failures they were.
template <typename Test>
void TestAllPointFilters(Test test, int& failures)
{
  for (const PointFilter& filter : AllPointFilters())
  {
    const int before = failures;
    test(filter, failures);
    if (failures > before)
    {
      std::cerr << "  by: " << filter.Name << "\n";
    }
  }
}

}

#endif
