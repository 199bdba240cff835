// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Options.h"
#include "Method.h"

#include "vtkRobustNormalFilter.h"

#include <CLI/CLI.hpp>

#include <limits>

bool ReadOptions(int argc, char* argv[], Options& options, int& exitCode)
{
  CLI::App app("Removes noise from a surface or a point cloud and keeps its edges and its volume.",
    "denoise");
  // The filters have these meanings of 0 and -1.
  const auto scale = CLI::IsMember({ -1.0 }) | CLI::NonNegativeNumber;
  const CLI::Range iterations(-1, std::numeric_limits<int>::max());
  app.footer(
    "Of scales and iterations 0 takes the value from the data, -1 is none: no weight, no step.\n"
    "Files: PLY, OBJ, STL, VTP, VTK; OFF, and XYZ, XYZN, PTS, ASC with points, for reading only.\n"
    "Exit codes: 0 done, 1 bad command line, 2 cannot read, 3 cannot denoise, 4 cannot write.");

  std::map<std::string, int> norms;
  for (int norm = 0; norm < vtkRobustNormalFilter::GetNumberOfNorms(); ++norm)
  {
    norms[OptionName(vtkRobustNormalFilter::GetNormName(norm))] = norm;
  }

  app.add_option("input", options.Input, "The surface or the points with noise")->required();
  app.add_option("output", options.Output, "Where it goes without noise")->required();
  app
    .add_option("-m,--method", options.Method,
      "A published method, or robust or robust-point-normal to compose one; by default " +
        DefaultMethod(true) + ", without polygons " + DefaultMethod(false))
    ->check(CLI::IsMember(MethodNames()));
  app.add_option("--norm", options.Norm, "Error norm of the robust methods")
    ->transform(CLI::CheckedTransformer(norms, CLI::ignore_case));
  app
    .add_option("-r,--range-scale", options.RangeScale,
      "Differences of normals that count as noise, in the unit of the method (mostly chord length, "
      "where 0.35 is 20 degrees)")
    ->check(CLI::NonNegativeNumber);
  app
    .add_option("-s,--spatial-scale", options.SpatialScale,
      "Width of the spatial kernel in mean distances of face centroids or spacings of points")
    ->check(scale);
  app.add_option("-o,--outer-iterations", options.OuterIterations, "Turns of normals and points")
    ->check(iterations);
  app.add_option("-n,--normal-iterations", options.NormalIterations, "Steps that filter normals")
    ->check(iterations);
  app
    .add_option("-v,--vertex-iterations,--point-iterations", options.VertexIterations,
      "Steps that move points")
    ->check(iterations);
  app
    .add_option("--maximum-displacement", options.MaximumDisplacement,
      "How far points may move in mean edge lengths or spacings; 0: any distance")
    ->check(CLI::NonNegativeNumber);
  app.add_option("--boundary", options.Boundary, "What open borders do (fixed)")
    ->check(CLI::IsMember({ "fixed", "slide", "free" }));
  app.add_option("--reference", options.Reference, "A surface without noise to compare with");
  app.add_option("-t,--threads", options.Threads, "Number of threads; 0: all cores")
    ->check(CLI::NonNegativeNumber);
  app.add_flag("-q,--quiet", options.Quiet, "Say nothing unless something is wrong");

  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::ParseError& error)
  {
    exitCode = app.exit(error) == 0 ? 0 : 1;
    return false;
  }
  return true;
}
