// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file PointOperator.h
 * @brief What a method does to a point set in one outer iteration.
 */

#ifndef SurfaceDenoising_PointOperator_h
#define SurfaceDenoising_PointOperator_h

#include "PointSet.h"

namespace SurfaceDenoising
{

/// What an operator chose and found.
struct PointOperatorReport
{
  double NormScale = 0.0;    ///< used, in units of the argument
  bool NoNoiseFound = false; ///< the scale from the data is zero: points were left as they were
};

class PointOperator
{
public:
  virtual ~PointOperator() = default;

  /// Called before the first iteration, and again when points.Neighbors was renewed.
  virtual void Renew(PointSet& /*points*/, Execution& /*execution*/) {}

  /**
   * One outer iteration: changes positions (by MoveTo or its rules), normals, classes, and marks
   * points that it could not filter as kept; the others are marked as filtered already. Every loop
   * reads old values and writes new ones. Returns false if the execution asked to stop; progress is
   * reported from first to last.
   */
  virtual bool Run(PointSet& points, Execution& execution, double first, double last) = 0;

  const PointOperatorReport& Report() const { return this->Done; }

protected:
  PointOperatorReport Done;
};

}

#endif
