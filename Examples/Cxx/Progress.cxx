// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Progress.h"

#include <vtkAlgorithm.h>
#include <vtkCommand.h>

#include <cstdio>
#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace
{

constexpr int Width = 50;

bool IsTerminal()
{
#ifdef _WIN32
  return _isatty(_fileno(stderr)) != 0;
#else
  return isatty(fileno(stderr)) != 0;
#endif
}

}

Progress::Progress(vtkAlgorithm* algorithm)
  : Algorithm(algorithm)
  , Tag(algorithm->AddObserver(vtkCommand::ProgressEvent, this, &Progress::Show))
  , Terminal(IsTerminal())
{
}

Progress::~Progress()
{
  this->Algorithm->RemoveObserver(this->Tag);
  if (this->Terminal && this->Shown >= 0)
  {
    std::fprintf(stderr, "\r%*s\r", Width + 7, ""); // leaves an empty line
  }
}

void Progress::Show()
{
  const double done = this->Algorithm->GetProgress();
  const int now = static_cast<int>(done * (this->Terminal ? 100 : 10) + 1e-9);
  if (now <= this->Shown)
  {
    return;
  }
  this->Shown = now;
  if (this->Terminal)
  {
    const std::string bar(static_cast<std::size_t>(done * Width), '#');
    std::fprintf(stderr, "\r[%-*s]%4d%%", Width, bar.c_str(), now);
    std::fflush(stderr);
  }
  else
  {
    std::fprintf(stderr, "%d%%\n", 10 * now);
  }
}
