// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file AllMeshFilters.h
 * @brief Every filter that denoises surfaces, with every setting that makes another method of it.
 *
 * What all filters promise is tested on all of this list. A new method is added to it, with a flag
 * for what it does not promise; TestDenoisingMethods tells of a method that was forgotten.
 */

#ifndef AllMeshFilters_h
#define AllMeshFilters_h

#include "vtkMeshDenoisingFilter.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <iostream>
#include <string>
#include <vector>

namespace MeshTest
{

/// What does not hold for a filter, and why.
enum Exception : unsigned
{
  /// It reproduces the program of others, which repairs nothing and asks the last point of the mesh
  /// which way is up: seams tear, turned faces count as they are, open borders move, the result
  /// depends on order, size and orientation of the model, and a face without a neighbour gets the
  /// normal (0, 0, 1). Of the settings, only a few matter.
  AS_RELEASED = 1,
  /// It has the iterations of a paper, whatever was set.
  OWN_ITERATIONS = 2,
  /// It takes a scale from the noise of the surface, and warns if there is none.
  NEEDS_NOISE = 4,
  /// It scales the whole surface to its volume, and warns if that is open. Components do not move
  /// as if they were alone.
  WHOLE_VOLUME = 8,
  /// It is no repetition of anything: there is no number of iterations.
  ONE_PASS = 16
};

struct MeshFilter
{
  std::string Name;   ///< unlike any other
  std::string Method; ///< the row of the table of methods that it is the filter of, or empty
  std::function<vtkSmartPointer<vtkMeshDenoisingFilter>()> MakeDefault;
  unsigned Exceptions = 0;

  /// With few iterations, for speed.
  vtkSmartPointer<vtkMeshDenoisingFilter> Make() const;

  bool Is(Exception exception) const { return (this->Exceptions & exception) != 0; }
  bool IsTwoStage() const;
};

const std::vector<MeshFilter>& AllMeshFilters();

/// Leaves a filter no more than so many iterations of each kind.
void LimitIterations(vtkMeshDenoisingFilter* filter, int limit);

/// Runs test(filter, failures) on all of them, and says whose failures they were.
template <typename Test>
void TestAllMeshFilters(Test test, int& failures)
{
  for (const MeshFilter& filter : AllMeshFilters())
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
