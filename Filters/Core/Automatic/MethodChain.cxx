// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "MethodChain.h"

#include "ProgressShare.h"

namespace SurfaceDenoising
{

bool RunChain(TriangleMesh& mesh, const MethodChain& chain, Buffer<Vec3>& normals,
  MeshDenoisingReport& report, Execution& execution)
{
  for (std::size_t k = 0; k < chain.size(); ++k)
  {
    ProgressShare share(execution, double(k) / double(chain.size()),
      double(k + 1) / double(chain.size()));
    normals.clear();
    report = MeshDenoisingReport();
    if (!DenoiseMesh(mesh, normals, chain[k], report, share))
    {
      return false;
    }
  }
  return true;
}

bool RunChain(TriangleMesh& mesh, const MethodChain& chain, Execution& execution)
{
  Buffer<Vec3> normals;
  MeshDenoisingReport report;
  return RunChain(mesh, chain, normals, report, execution);
}

}
