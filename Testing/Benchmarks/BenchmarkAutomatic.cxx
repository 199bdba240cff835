// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// How near automatic denoising comes to the best of a sweep over methods and parameters, which
// looks at the truth. Prints a table of mean angles between the normals of faces and those of the
// clean model, in degrees.
//
// benchmark-automatic <model.off>... takes minutes for each ten thousand faces of a model.

#include "Automatic/AutomaticMesh.h"
#include "Metrics.h"
#include "Noise.h"
#include "NoisySurface.h"
#include "TunedChains.h"

#include <cmath>
#include <cstdio>
#include <string>

using namespace SurfaceDenoising;

namespace
{

struct NoiseRow
{
  const char* Name;
  NoiseKind Kind;
  double Deviation; ///< in mean edge lengths
  bool AlongNormals;
};

constexpr double ImpulsiveFraction = 0.2;

const NoiseRow Rows[] = {
  { "normals", NoiseKind::Gaussian, 0.1, true },
  { "normals", NoiseKind::Gaussian, 0.2, true },
  { "normals", NoiseKind::Gaussian, 0.3, true },
  { "normals", NoiseKind::Gaussian, 0.5, true },
  { "normals", NoiseKind::Gaussian, 0.7, true },
  { "directions", NoiseKind::Gaussian, 0.1, false },
  { "directions", NoiseKind::Gaussian, 0.3, false },
  { "directions", NoiseKind::Gaussian, 0.7, false },
  { "impulses, normals", NoiseKind::Impulsive, 0.5, true },
  { "impulses, directions", NoiseKind::Impulsive, 0.5, false },
};

TriangleMesh WithNoise(const TriangleMesh& clean, const NoiseRow& row, double edgeLength)
{
  NoiseParameters parameters;
  parameters.Kind = row.Kind;
  parameters.Deviation = row.Deviation * edgeLength;
  parameters.Fraction = ImpulsiveFraction;
  const NoiseSource noise(parameters, clean.NumberOfVertices());
  Buffer<Vec3> normals(clean.NumberOfVertices(), Vec3(0.0, 0.0, 0.0));
  for (std::size_t f = 0; f < clean.NumberOfFaces(); ++f)
  {
    for (const Index v : clean.Triangles[f])
    {
      normals[v] += clean.DoubleAreaVector(f);
    }
  }
  TriangleMesh mesh = clean;
  for (std::size_t v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    mesh.Positions[v] += noise.Amplitude(v) *
      (row.AlongNormals ? Vec3(normals[v].stableNormalized()) : noise.Direction(v));
  }
  return mesh;
}

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

void Measure(const char* file)
{
  Execution serial;
  const TriangleMesh clean = ReadMesh(file);
  const std::string path = file;
  const std::string model = path.substr(path.find_last_of('/') + 1);
  const double edgeLength = TakeEdgeCensus(clean, VertexStars(clean), serial).MeanEdgeLength;
  for (const NoiseRow& row : Rows)
  {
    const TriangleMesh noisy = WithNoise(clean, row, edgeLength);
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
}

}

int main(int argc, char** argv)
{
  std::printf("| model | noise | input | best of the sweep | automatic | ratio |\n"
              "|---|---|---|---|---|---|\n");
  for (int i = 1; i < argc; ++i)
  {
    Measure(argv[i]);
  }
  return argc > 1 ? 0 : 1;
}
