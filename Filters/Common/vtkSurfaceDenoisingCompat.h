// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file vtkSurfaceDenoisingCompat.h
 * @brief Differences between VTK 9.1 and later versions, bridged in one place.
 */

#ifndef vtkSurfaceDenoisingCompat_h
#define vtkSurfaceDenoisingCompat_h

#include "vtkAlgorithm.h"

namespace SurfaceDenoising
{

namespace detail
{

/// VTK 9.3 and ParaView 5.11 also see an abort upstream ...
template <typename Algorithm>
auto Aborted(Algorithm* algorithm, int) -> decltype(algorithm->CheckAbort())
{
  return algorithm->CheckAbort();
}

/// ... earlier versions have a flag alone.
template <typename Algorithm>
bool Aborted(Algorithm* algorithm, long)
{
  return algorithm->GetAbortExecute() != 0;
}

}

/// True if the user asked the algorithm to stop. To be called from the thread that executes it.
inline bool Aborted(vtkAlgorithm* algorithm) { return detail::Aborted(algorithm, 0); }

}

#endif
