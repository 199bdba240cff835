// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// How near automatic denoising of points comes to the best of a sweep over methods and parameters,
// which looks at the truth. Prints a table of mean distances of the points from the clean model, in
// hundredths of its mean edge length.
//
// benchmark-automatic-points <model.off> [cuts] takes minutes for each ten thousand points. With
// cuts, every triangle is cut into cuts * cuts: a dense scan of the same shape.

#include "Automatic/AutomaticCloud.h"
#include "Metrics.h"
#include "NoiseRows.h"
#include "NoisySurface.h"
#include "TriangleTree.h"
#include "TunedClouds.h"

#include <cstdio>
#include <cstdlib>
#include <string>

using namespace SurfaceDenoising;

namespace
{

class Truth
{
public:
  explicit Truth(const TriangleMesh& mesh)
    : EdgeLength(TakeEdgeCensus(mesh, VertexStars(mesh), Serial).MeanEdgeLength)
    , Tree(mesh, AreasOf(mesh))
  {
  }

  double Error(const Buffer<Vec3>& points) const
  {
    double sum = 0.0;
    for (const Vec3& point : points)
    {
      sum += this->Tree.Nearest(point).Distance;
    }
    return 100.0 * sum / double(points.size()) / this->EdgeLength;
  }

private:
  static Buffer<double> AreasOf(const TriangleMesh& mesh)
  {
    Buffer<double> areas(mesh.NumberOfFaces());
    for (std::size_t f = 0; f < areas.size(); ++f)
    {
      areas[f] = 0.5 * mesh.DoubleAreaVector(f).norm();
    }
    return areas;
  }

  Execution Serial;
  double EdgeLength;
  TriangleTree Tree;
};

/// Points that belong to faces.
Buffer<Vec3> PointsOf(const TriangleMesh& mesh)
{
  const CompressedRows stars = VertexStars(mesh);
  Buffer<Vec3> points;
  for (std::size_t v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    if (stars.Row(v).size() > 0)
    {
      points.push_back(mesh.Positions[v]);
    }
  }
  return points;
}

void Measure(const std::string& model, const TriangleMesh& clean)
{
  Execution serial;
  const Truth truth(clean);
  const std::vector<TunedCloud> sweep = TunedClouds();
  for (const NoiseRow& row : NoiseRows())
  {
    const Buffer<Vec3> points = PointsOf(WithNoise(clean, row));
    double best = truth.Error(points);
    std::string name = "nothing";
    std::printf("| %s | %s %.1f | %.2f ", model.c_str(), row.Name, row.Deviation, best);
    for (const TunedCloud& tuned : sweep)
    {
      PointCloud cloud;
      cloud.Positions = points;
      PointDenoisingReport report;
      DenoisePoints(cloud, tuned.Settings, report, serial);
      const double error = truth.Error(cloud.Positions);
      if (error < best)
      {
        best = error;
        name = tuned.Name;
      }
    }
    PointCloud cloud;
    cloud.Positions = points;
    AutomaticCloudReport report;
    DenoiseAutomatically(cloud, 1.0, report, serial);
    const double error = truth.Error(cloud.Positions);
    std::printf("| %.2f (%s) | %.2f (%s: %s) | %.2f |\n", best, name.c_str(), error,
      report.Choice.Method.c_str(), report.Choice.Reason.c_str(), error / best);
    std::fflush(stdout);
  }
}

}

int main(int argc, char** argv)
{
  if (argc < 2)
  {
    return 1;
  }
  const std::string path = argv[1];
  const TriangleMesh clean = ReadMesh(argv[1]);
  if (clean.NumberOfFaces() == 0)
  {
    return 1;
  }
  const int cuts = argc > 2 ? std::atoi(argv[2]) : 1;
  std::string model = path.substr(path.find_last_of('/') + 1);
  model += cuts > 1 ? ", cut by " + std::to_string(cuts) : "";
  std::printf("| model | noise | input | best of the sweep | automatic | ratio |\n"
              "|---|---|---|---|---|---|\n");
  Measure(model, Subdivide(clean, std::max(1, cuts)));
  return 0;
}
