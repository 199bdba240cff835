// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkDenoisingMethods.h"

#include "Methods.h"

#include "vtkAnisotropicMeanCurvatureFilter.h"
#include "vtkBilateralNormalFilter.h"
#include "vtkBilateralVertexFilter.h"
#include "vtkCurvatureNormalDiffusionFilter.h"
#include "vtkFuzzyVectorMedianNormalFilter.h"
#include "vtkGeometricFidelityNormalFilter.h"
#include "vtkGuidedNormalFilter.h"
#include "vtkHuberNormalFilter.h"
#include "vtkMeanCurvatureFlowFilter.h"
#include "vtkMeanNormalFilter.h"
#include "vtkMedianNormalFilter.h"
#include "vtkNonIterativeBilateralFilter.h"
#include "vtkNormalDiffusionFilter.h"
#include "vtkNormalVotingTensorFilter.h"
#include "vtkObjectFactory.h"
#include "vtkRobustNormalFilter.h"
#include "vtkTukeyBilateralNormalFilter.h"

namespace sd = SurfaceDenoising;

vtkStandardNewMacro(vtkDenoisingMethods);

namespace
{

const sd::MethodRow* Find(int method)
{
  const bool exists = method >= 0 && method < vtkDenoisingMethods::GetNumberOfMethods();
  return exists ? &sd::Methods()[static_cast<std::size_t>(method)] : nullptr;
}

}

vtkDenoisingMethods::vtkDenoisingMethods() = default;
vtkDenoisingMethods::~vtkDenoisingMethods() = default;

int vtkDenoisingMethods::GetNumberOfMethods() { return static_cast<int>(sd::Methods().size()); }

const char* vtkDenoisingMethods::GetName(int method)
{
  const sd::MethodRow* row = Find(method);
  return row ? row->Name : nullptr;
}

const char* vtkDenoisingMethods::GetPaper(int method)
{
  const sd::MethodRow* row = Find(method);
  return row ? row->Paper : nullptr;
}

const char* vtkDenoisingMethods::GetFilter(int method)
{
  const sd::MethodRow* row = Find(method);
  return row ? row->Filter : nullptr;
}

bool vtkDenoisingMethods::IsTwoStage(int method)
{
  const sd::MethodRow* row = Find(method);
  return row && row->TwoStage;
}

bool vtkDenoisingMethods::IsComposed(int method)
{
  const sd::MethodRow* row = Find(method);
  return row && row->Composed;
}

vtkMeshDenoisingFilter* vtkDenoisingMethods::NewFilter(int method)
{
  const sd::MethodRow* row = Find(method);
  if (!row)
  {
    return nullptr;
  }
  switch (row->Id)
  {
    case sd::Method::NormalDiffusion:
      return vtkNormalDiffusionFilter::New();
    case sd::Method::MeanNormal:
      return vtkMeanNormalFilter::New();
    case sd::Method::MedianNormal:
      return vtkMedianNormalFilter::New();
    case sd::Method::WeightedMedianNormal:
    {
      vtkMedianNormalFilter* filter = vtkMedianNormalFilter::New();
      filter->SetMedianTypeToWeighted();
      return filter;
    }
    case sd::Method::HuberNormal:
      return vtkHuberNormalFilter::New();
    case sd::Method::NormalVotingTensor:
      return vtkNormalVotingTensorFilter::New();
    case sd::Method::FuzzyVectorMedian:
      return vtkFuzzyVectorMedianNormalFilter::New();
    case sd::Method::CurvatureNormalDiffusion:
      return vtkCurvatureNormalDiffusionFilter::New();
    case sd::Method::GeometricFidelity:
      return vtkGeometricFidelityNormalFilter::New();
    case sd::Method::BilateralNormal:
      return vtkBilateralNormalFilter::New();
    case sd::Method::GlobalBilateralNormal:
    {
      vtkBilateralNormalFilter* filter = vtkBilateralNormalFilter::New();
      filter->SetSchemeToGlobal();
      return filter;
    }
    case sd::Method::GuidedNormal:
      return vtkGuidedNormalFilter::New();
    case sd::Method::TukeyBilateralNormal:
      return vtkTukeyBilateralNormalFilter::New();
    case sd::Method::ThresholdedCosine:
    {
      vtkRobustNormalFilter* filter = vtkRobustNormalFilter::New();
      filter->SetPreset(vtkRobustNormalFilter::THRESHOLDED_COSINE);
      return filter;
    }
    case sd::Method::MeanCurvatureFlow:
      return vtkMeanCurvatureFlowFilter::New();
    case sd::Method::AnisotropicMeanCurvature:
      return vtkAnisotropicMeanCurvatureFilter::New();
    case sd::Method::BilateralVertex:
      return vtkBilateralVertexFilter::New();
    case sd::Method::NonIterativeBilateral:
      return vtkNonIterativeBilateralFilter::New();
  }
  return nullptr;
}

void vtkDenoisingMethods::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (const sd::MethodRow& row : sd::Methods())
  {
    os << indent << row.Name << ": " << row.Paper << ", vtk" << row.Filter << "\n";
  }
}
