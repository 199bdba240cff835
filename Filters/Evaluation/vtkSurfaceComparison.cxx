// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkSurfaceComparison.h"

#include "SurfaceComparisonWork.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <limits>

using namespace SurfaceDenoising;

vtkStandardNewMacro(vtkSurfaceComparison);

struct vtkSurfaceComparison::Quantity
{
  const char* Name;
  double vtkSurfaceComparison::*Value;

  static const Quantity All[49];
};

#define QuantityMacro(name)                                                                        \
  {                                                                                                \
#name, &vtkSurfaceComparison::name                                                             \
  }
const vtkSurfaceComparison::Quantity vtkSurfaceComparison::Quantity::All[] = {
  QuantityMacro(SameConnectivity),
  QuantityMacro(UncomparedFaces),
  QuantityMacro(MeanNormalAngle),
  QuantityMacro(RMSNormalAngle),
  QuantityMacro(MedianNormalAngle),
  QuantityMacro(Percentile95NormalAngle),
  QuantityMacro(MaximumNormalAngle),
  QuantityMacro(AreaWeightedNormalAngle),
  QuantityMacro(FlippedFaces),
  QuantityMacro(PositionError),
  QuantityMacro(RelativePositionError),
  QuantityMacro(MeanDistance),
  QuantityMacro(RelativeMeanDistance),
  QuantityMacro(HausdorffToReference),
  QuantityMacro(HausdorffFromReference),
  QuantityMacro(HausdorffDistance),
  QuantityMacro(RelativeHausdorffDistance),
  QuantityMacro(ReferenceDiagonal),
  QuantityMacro(Volume),
  QuantityMacro(ReferenceVolume),
  QuantityMacro(RelativeVolumeChange),
  QuantityMacro(ReferenceFeatureEdges),
  QuantityMacro(FoundFeatureEdges),
  QuantityMacro(MissedFeatureEdges),
  QuantityMacro(InventedFeatureEdges),
  QuantityMacro(FeatureFaces),
  QuantityMacro(FeatureNormalAngle),
  QuantityMacro(SmoothNormalAngle),
  QuantityMacro(TriangleQuality),
  QuantityMacro(ReferenceTriangleQuality),
  QuantityMacro(RMSDistance),
  QuantityMacro(MaximumDistance),
  QuantityMacro(RelativeRMSDistance),
  QuantityMacro(RelativeMaximumDistance),
  QuantityMacro(MeanSignedDistance),
  QuantityMacro(FeaturePoints),
  QuantityMacro(FeatureDistance),
  QuantityMacro(SmoothDistance),
  QuantityMacro(ChamferDistance),
  QuantityMacro(SquaredChamferDistance),
  QuantityMacro(PointHausdorffToReference),
  QuantityMacro(PointHausdorffFromReference),
  QuantityMacro(PointHausdorffDistance),
  QuantityMacro(SpacingVariation),
  QuantityMacro(ReferenceSpacingVariation),
  QuantityMacro(MeanPointNormalAngle),
  QuantityMacro(RMSPointNormalAngle),
  QuantityMacro(SharePointNormalsWithin10),
  QuantityMacro(FlippedPointNormals),
};
#undef QuantityMacro

namespace
{

constexpr double Undefined = std::numeric_limits<double>::quiet_NaN();

}

vtkSurfaceComparison::vtkSurfaceComparison()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
  this->ForgetQuantities();
}

vtkTable* vtkSurfaceComparison::GetTable()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(1));
}

int vtkSurfaceComparison::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

int vtkSurfaceComparison::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPolyData" : "vtkTable");
  return 1;
}

int vtkSurfaceComparison::RequestData(vtkInformation*, vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  this->ForgetQuantities();
  Work work(this);
  work.Result.Data = vtkPolyData::GetData(inputs[0]);
  work.Reference.Data = vtkPolyData::GetData(inputs[1]);
  if (!work.Result.Data || work.Result.Data->GetNumberOfPoints() == 0)
  {
    vtkErrorMacro("The input, the surface to be judged, is empty.");
    return 0;
  }
  if (!work.Reference.Data || work.Reference.Data->GetNumberOfPoints() == 0)
  {
    vtkErrorMacro("The reference is empty.");
    return 0;
  }
  bool done = false;
  RunOnThreads(0, [&]() { done = this->Compare(work); });
  if (!done)
  {
    this->ForgetQuantities();
    if (work.Execution.WasStopped())
    {
      return 1;
    }
    vtkErrorMacro(<< work.Error);
    return 0;
  }

  vtkPolyData* output = vtkPolyData::GetData(outputs, 0);
  output->ShallowCopy(work.Result.Data);
  auto distances = MakeUndefinedArray("Distance", output->GetNumberOfPoints());
  std::copy(work.Distances.begin(), work.Distances.end(), distances->GetPointer(0));
  output->GetPointData()->AddArray(distances);
  if (!work.PointNormalAngles.empty())
  {
    auto angles = MakeUndefinedArray("PointNormalAngleError", output->GetNumberOfPoints());
    std::copy(work.PointNormalAngles.begin(), work.PointNormalAngles.end(), angles->GetPointer(0));
    output->GetPointData()->AddArray(angles);
  }
  output->GetCellData()->AddArray(work.Result.CellMeans(work.NormalAngles, "NormalAngleError"));
  this->WriteQuantities(output, vtkTable::GetData(outputs, 1));
  return 1;
}

void vtkSurfaceComparison::ForgetQuantities()
{
  for (const Quantity& quantity : Quantity::All)
  {
    this->*quantity.Value = Undefined;
  }
}

void vtkSurfaceComparison::WriteQuantities(vtkPolyData* output, vtkTable* table) const
{
  for (const Quantity& quantity : Quantity::All)
  {
    auto value = MakeUndefinedArray(quantity.Name, 1);
    value->SetValue(0, this->*quantity.Value);
    output->GetFieldData()->AddArray(value);
    table->AddColumn(value);
  }
}

void vtkSurfaceComparison::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "FeatureRings: " << this->FeatureRings << "\n";
  for (const Quantity& quantity : Quantity::All)
  {
    os << indent << quantity.Name << ": " << this->*quantity.Value << "\n";
  }
}
