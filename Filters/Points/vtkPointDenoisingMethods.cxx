// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkPointDenoisingMethods.h"

#include "Points/PointMethods.h"

#include "vtkBilateralPointFilter.h"
#include "vtkFeatureAwarePointFilter.h"
#include "vtkGuidedPointNormalFilter.h"
#include "vtkMovingLeastSquaresFilter.h"
#include "vtkMovingRobustPCAFilter.h"
#include "vtkObjectFactory.h"
#include "vtkRobustImplicitMLSFilter.h"
#include "vtkRollingPointNormalFilter.h"
#include "vtkTensorPointFilter.h"
#include "vtkVotingTensorPointFilter.h"

namespace sd = SurfaceDenoising;

vtkStandardNewMacro(vtkPointDenoisingMethods);

namespace
{

const sd::PointMethodRow* Find(int method)
{
  const bool exists = method >= 0 && method < vtkPointDenoisingMethods::GetNumberOfMethods();
  return exists ? &sd::PointMethods()[static_cast<std::size_t>(method)] : nullptr;
}

}

vtkPointDenoisingMethods::vtkPointDenoisingMethods() = default;
vtkPointDenoisingMethods::~vtkPointDenoisingMethods() = default;

int vtkPointDenoisingMethods::GetNumberOfMethods()
{
  return static_cast<int>(sd::PointMethods().size());
}

const char* vtkPointDenoisingMethods::GetName(int method)
{
  const sd::PointMethodRow* row = Find(method);
  return row ? row->Name : nullptr;
}

const char* vtkPointDenoisingMethods::GetPaper(int method)
{
  const sd::PointMethodRow* row = Find(method);
  return row ? row->Paper : nullptr;
}

const char* vtkPointDenoisingMethods::GetFilter(int method)
{
  const sd::PointMethodRow* row = Find(method);
  return row ? row->Filter : nullptr;
}

bool vtkPointDenoisingMethods::IsComposed(int method)
{
  const sd::PointMethodRow* row = Find(method);
  return row && row->Composed;
}

vtkPointDenoisingFilter* vtkPointDenoisingMethods::NewFilter(int method)
{
  const sd::PointMethodRow* row = Find(method);
  if (!row)
  {
    return nullptr;
  }
  switch (row->Id)
  {
    case sd::PointMethod::RobustImplicitMLS:
      return vtkRobustImplicitMLSFilter::New();
    case sd::PointMethod::MovingRobustPCA:
      return vtkMovingRobustPCAFilter::New();
    case sd::PointMethod::FeatureAwarePoint:
      return vtkFeatureAwarePointFilter::New();
    case sd::PointMethod::GuidedPointNormal:
      return vtkGuidedPointNormalFilter::New();
    case sd::PointMethod::TensorPoint:
      return vtkTensorPointFilter::New();
    case sd::PointMethod::BilateralPoint:
      return vtkBilateralPointFilter::New();
    case sd::PointMethod::RollingPointNormal:
      return vtkRollingPointNormalFilter::New();
    case sd::PointMethod::VotingTensorPoint:
      return vtkVotingTensorPointFilter::New();
    case sd::PointMethod::MovingLeastSquares:
      return vtkMovingLeastSquaresFilter::New();
  }
  return nullptr;
}

void vtkPointDenoisingMethods::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (const sd::PointMethodRow& row : sd::PointMethods())
  {
    os << indent << row.Name << ": " << row.Paper << ", vtk" << row.Filter << "\n";
  }
}
