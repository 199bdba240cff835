// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file SMPExecution.h
 * @brief Runs the core's loops with vtkSMPTools, reports progress to an algorithm and hears its
 * abort.
 */

#ifndef SurfaceDenoising_SMPExecution_h
#define SurfaceDenoising_SMPExecution_h

#include "Execution.h"

class vtkAlgorithm;

namespace SurfaceDenoising
{

class SMPExecution : public Execution
{
public:
  /// Progress 0..1 of the work becomes first..last of the algorithm.
  SMPExecution(vtkAlgorithm* algorithm, double first = 0.0, double last = 1.0);

  void For(std::size_t count, const Body& body, std::size_t grain = 4096) override;
  bool Proceed(double fraction) override;

  /// True once Proceed has answered false.
  bool WasStopped() const { return this->Stopped; }

private:
  vtkAlgorithm* Algorithm;
  double First;
  double Last;
  double Done = 0.0; ///< the largest fraction so far
  bool Stopped = false;
};

/**
 * Runs work so that vtkSMPTools uses the given number of threads, 0: all cores. Many builds of VTK,
 * Debian's ParaView among them, start with the sequential backend; the standard threads that every
 * VTK has take over for the time of the work. Ask for 1 thread to stay on the calling one.
 */
void RunOnThreads(int threads, const std::function<void()>& work);

}

#endif
