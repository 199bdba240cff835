// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file Progress.h
 * @brief The progress of a filter on the terminal.
 */

#ifndef Progress_h
#define Progress_h

#include <string>

class vtkAlgorithm;

/// A bar if standard error is a terminal, otherwise a line for every tenth of the work.
class Progress
{
public:
  explicit Progress(vtkAlgorithm* algorithm);
  ~Progress();
  Progress(const Progress&) = delete;
  void operator=(const Progress&) = delete;

private:
  void Show();

  vtkAlgorithm* Algorithm;
  unsigned long Tag;
  bool Terminal;
  int Shown = -1; ///< percent, or tenths
};

#endif
