// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file PointFilterTester.h
 * @brief Runs a filter of the list on point sets, listens to what it says and looks at what it
 * gives.
 */

#ifndef PointFilterTester_h
#define PointFilterTester_h

#include "AllPointFilters.h"
#include "PointClouds.h"

namespace PointTest
{

class PointFilterTester
{
public:
  explicit PointFilterTester(const PointFilter& about)
    : About(about)
    , Filter(about.Make())
  {
    this->Seen->Watch(this->Filter);
  }

  vtkPolyData* Denoise(vtkPolyData* input) { return Run(this->Filter, input, this->Seen); }

  /// No error, and no warning but those that the filter is known for.
  bool SaidNothing() const
  {
    const std::string& warnings = this->Seen->Warnings;
    const bool known =
      this->About.Is(NEEDS_NOISE) && warnings.find("have no noise") != std::string::npos;
    if (!this->Seen->Errors.empty() || !(warnings.empty() || known))
    {
      std::cerr << "said: " << this->Seen->Errors << warnings << "\n";
      return false;
    }
    return true;
  }

  /// The result is as documented, and nothing was said.
  bool Quiet(vtkPolyData* input)
  {
    auto before = Copy(input);
    vtkPolyData* output = this->Denoise(input);
    return this->SaidNothing() && SameData(input, before) && this->IsSound(input, output);
  }

  /// One error that contains the text, and no output.
  bool Refuses(vtkPolyData* input, const std::string& text)
  {
    vtkPolyData* output = this->Denoise(input);
    const std::string& errors = this->Seen->Errors;
    const std::size_t first = errors.find("ERROR:");
    const bool one =
      first != std::string::npos && errors.find("ERROR:", first + 1) == std::string::npos;
    if (!one || errors.find(text) == std::string::npos)
    {
      std::cerr << "said: " << errors << "\n";
      return false;
    }
    return output->GetNumberOfPoints() == 0 && output->GetNumberOfCells() == 0;
  }

  /// Of any input: cells and order stay, the added arrays tell the truth, and all is finite but
  /// what was not before.
  bool IsSound(vtkPolyData* input, vtkPolyData* output) const
  {
    const vtkIdType count = input->GetNumberOfPoints();
    if (output->GetNumberOfPoints() != count || !SameCells(input, output))
    {
      return this->Complain("points or cells");
    }
    if (count == 0)
    {
      return true;
    }
    vtkPointData* data = output->GetPointData();
    vtkDataArray* normals = data->GetArray("Normals");
    vtkDataArray* moves = data->GetArray("Displacement");
    vtkDataArray* status = data->GetArray("Status");
    vtkDataArray* classes = data->GetArray("FeatureClass");
    const int before = input->GetPoints()->GetDataType();
    if (!normals || normals != data->GetNormals() || normals->GetDataType() != VTK_DOUBLE ||
      !moves || moves->GetDataType() != VTK_DOUBLE || !status ||
      status->GetDataType() != VTK_UNSIGNED_CHAR || !output->GetPoints() ||
      output->GetPoints()->GetDataType() != (before == VTK_FLOAT ? VTK_FLOAT : VTK_DOUBLE) ||
      !output->GetFieldData()->GetArray("DenoisingReport"))
    {
      return this->Complain("arrays");
    }
    for (vtkIdType i = 0; i < count; ++i)
    {
      double p[3];
      double q[3];
      double n[3];
      double d[3];
      input->GetPoint(i, p);
      output->GetPoint(i, q);
      normals->GetTuple(i, n);
      moves->GetTuple(i, d);
      const bool finite = std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
      if ((status->GetComponent(i, 0) == vtkPointDenoisingFilter::NOT_FINITE) == finite ||
        status->GetComponent(i, 0) > vtkPointDenoisingFilter::NOT_FINITE)
      {
        return this->Complain("status");
      }
      const double length = vtkMath::Norm(n);
      if (length != 0.0 && !(std::abs(length - 1.0) < 1e-9))
      {
        return this->Complain("length of a normal");
      }
      if (classes && !(classes->GetComponent(i, 0) <= vtkPointDenoisingFilter::CORNER))
      {
        return this->Complain("feature class");
      }
      for (int c = 0; c < 3; ++c)
      {
        const bool asBefore =
          std::isnan(p[c]) ? std::isnan(q[c]) && d[c] == 0.0 : q[c] == p[c] && d[c] == 0.0;
        if (finite ? !std::isfinite(q[c]) || d[c] != q[c] - p[c] : !asBefore)
        {
          return this->Complain("place or displacement");
        }
      }
    }
    return true;
  }

  const PointFilter& About;
  vtkSmartPointer<vtkPointDenoisingFilter> Filter;
  vtkNew<Messages> Seen;

private:
  bool Complain(const char* what) const
  {
    std::cerr << "wrong: " << what << "\n";
    return false;
  }
};

}

#endif
