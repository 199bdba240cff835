// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file DenoisingReport.h
 * @brief What a filter found and did, as a field array.
 */

#ifndef SurfaceDenoising_DenoisingReport_h
#define SurfaceDenoising_DenoisingReport_h

#include <string>
#include <utility>
#include <vector>

class vtkDataSet;

namespace SurfaceDenoising
{

class DenoisingReport
{
public:
  template <typename Number>
  void Add(const std::string& name, Number value)
  {
    this->Figures.emplace_back(name, static_cast<double>(value));
  }

  /// The figures as the field array "DenoisingReport": one tuple with named components.
  void WriteTo(vtkDataSet* output) const;

private:
  std::vector<std::pair<std::string, double>> Figures;
};

}

#endif
