// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef Options_h
#define Options_h

#include <string>

/// What the command line asks for.
struct Options
{
  std::string Input;
  std::string Output;
  std::string Reference;
  std::string Method;       ///< empty: what suits the input
  int Norm = -1;            ///< of vtkRobustNormalFilter::Norms, -1: the filter's default
  double RangeScale = -1.0; ///< negative: the filter's default
  double SpatialScale = -1.0;
  int OuterIterations = -1;
  int NormalIterations = -1;
  int VertexIterations = -1;
  double MaximumDisplacement = -1.0;
  std::string Boundary; ///< empty: the filter's default
  int Threads = 0;
  bool Quiet = false;
};

/// Reads the command line. Returns false with the exit code if the program is to end at once.
bool ReadOptions(int argc, char* argv[], Options& options, int& exitCode);

#endif
