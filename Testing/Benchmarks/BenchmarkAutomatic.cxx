// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// How near automatic denoising comes to the best of a sweep over methods and parameters, which
// looks at the truth. Prints a table of mean angles between the normals of faces and those of the
// clean model, in degrees.
//
// benchmark-automatic <model.off>... takes minutes for each ten thousand faces of a model.

#include "Automatic/AutomaticMesh.h"
#include "Metrics.h"
#include "NoiseRows.h"
#include "NoisySurface.h"
#include "TunedChains.h"

#include <cmath>
#include <cstdio>
#include <string>

using namespace SurfaceDenoising;

namespace
{

double MeanAngle(const TriangleMesh& mesh, const TriangleMesh& clean)
{
  Execution serial;
  Buffer<double> angles(mesh.NumberOfFaces());
  for (std::size_t f = 0; f < angles.size(); ++f)
  {
    angles[f] = AngleBetween(mesh.DoubleAreaVector(f), clean.DoubleAreaVector(f));
  }
  return Summarize(angles, {}, serial).Mean;
}

/// Returns false if the file has no surface of triangles.
bool Measure(const char* file)
{
  Execution serial;
  const TriangleMesh clean = ReadMesh(file);
  if (clean.NumberOfFaces() == 0)
  {
    return false;
  }
  const std::string path = file;
  const std::string model = path.substr(path.find_last_of('/') + 1);
  for (const NoiseRow& row : NoiseRows())
  {
    const TriangleMesh noisy = WithNoise(clean, row);
    double best = MeanAngle(noisy, clean);
    std::string bestName = "nothing";
    std::printf("| %s | %s %.1f | %.2f ", model.c_str(), row.Name, row.Deviation, best);
    for (const TunedChain& chain : TunedChains())
    {
      TriangleMesh mesh = noisy;
      Buffer<Vec3> normals;
      MeshDenoisingReport report;
      RunChain(mesh, chain.Steps, normals, report, serial);
      const double angle = MeanAngle(mesh, clean);
      if (angle < best)
      {
        best = angle;
        bestName = chain.Name;
      }
    }
    TriangleMesh mesh = noisy;
    AutomaticReport report;
    DenoiseAutomatically(mesh, 1.0, report, serial);
    const double angle = MeanAngle(mesh, clean);
    std::printf("| %.2f (%s) | %.2f (%s; %zu repaired) | %.2f |\n", best, bestName.c_str(), angle,
      report.Plan.Reason.c_str(), report.RepairedVertices, angle / best);
    std::fflush(stdout);
  }
  return true;
}

}

int main(int argc, char** argv)
{
  std::printf("| model | noise | input | best of the sweep | automatic | ratio |\n"
              "|---|---|---|---|---|---|\n");
  bool measured = argc > 1;
  for (int i = 1; i < argc; ++i)
  {
    measured = Measure(argv[i]) && measured;
  }
  return measured ? 0 : 1;
}
