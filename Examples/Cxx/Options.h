// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef Options_h
#define Options_h

#include <optional>
#include <string>

/// What the command line asks for. What is not given is left to the filter.
struct Options
{
  std::string Input;
  std::string Output;
  std::string Reference;
  std::string Method;      ///< empty: what suits the input
  std::optional<int> Norm; ///< of vtkRobustNormalFilter::Norms
  std::optional<double> RangeScale;
  std::optional<double> SpatialScale;
  std::optional<int> OuterIterations;
  std::optional<int> NormalIterations;
  std::optional<int> VertexIterations;
  std::optional<double> MaximumDisplacement;
  std::optional<std::string> Boundary;
  int Threads = 0;
  bool Quiet = false;
};

/// Reads the command line. Returns false with the exit code if the program is to end at once.
bool ReadOptions(int argc, char* argv[], Options& options, int& exitCode);

#endif
