// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkSurfaceComparison.h"

#include "ComparedSurface.h"
#include "SMPExecution.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <cmath>
#include <limits>

using namespace SurfaceDenoising;

vtkStandardNewMacro(vtkSurfaceComparison);

struct vtkSurfaceComparison::Quantity
{
  const char* Name;
  double vtkSurfaceComparison::*Value;

  static const Quantity All[27];
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
  QuantityMacro(TriangleQuality),
  QuantityMacro(ReferenceTriangleQuality),
};
#undef QuantityMacro

namespace
{

constexpr double Undefined = std::numeric_limits<double>::quiet_NaN();

/// Larger of two numbers; NaN if one of them is NaN.
double Larger(double a, double b) { return std::isnan(a) || a > b ? a : b; }

}

struct vtkSurfaceComparison::Work
{
  ComparedSurface Result;
  ComparedSurface Reference;
  SMPExecution Execution;
  std::string Error;
  Buffer<Index> Partner;       ///< face of the reference nearest to each face of the result
  Buffer<double> Distances;    ///< of the points of the result
  Buffer<double> NormalAngles; ///< of the faces of the result

  explicit Work(vtkAlgorithm* algorithm)
    : Execution(algorithm)
  {
  }
};

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
  output->GetCellData()->AddArray(work.Result.CellMeans(work.NormalAngles, "NormalAngleError"));
  this->WriteQuantities(output, vtkTable::GetData(outputs, 1));
  return 1;
}

bool vtkSurfaceComparison::Compare(Work& work)
{
  if (!this->ReadSurfaces(work) || !this->MeasureDistances(work))
  {
    return false;
  }
  this->CompareNormals(work);
  this->CompareShapes(work);
  if (this->SameConnectivity != 0.0)
  {
    this->CompareFeatures(work);
  }
  return work.Execution.Proceed(1.0);
}

bool vtkSurfaceComparison::ReadSurfaces(Work& work)
{
  ComparedSurface& result = work.Result;
  ComparedSurface& reference = work.Reference;
  std::string why;
  if (!ReadSurface(result.Data, result.View, why, work.Execution))
  {
    work.Error = "The input cannot be compared. " + why;
    return false;
  }
  if (!ReadSurface(reference.Data, reference.View, why, work.Execution))
  {
    work.Error = "The reference cannot be compared with. " + why;
    return false;
  }
  const bool same = HaveSameFaces(result.Data, reference.Data);
  this->SameConnectivity = same;
  if (same)
  {
    TriangulateAlike(reference.View, result.View);
  }
  // From here on in the coordinates of the reference.
  const Vec3 shift = result.View.Centre - reference.View.Centre;
  for (Vec3& position : result.View.Mesh.Positions)
  {
    position += shift;
  }
  result.Analyze(work.Execution);
  reference.Analyze(work.Execution);
  if (!reference.HasArea())
  {
    work.Error = "The reference is no surface: it has no polygon or strip with an area.";
    return false;
  }
  return work.Execution.Proceed(0.1);
}

bool vtkSurfaceComparison::MeasureDistances(Work& work)
{
  const ComparedSurface& result = work.Result;
  const ComparedSurface& reference = work.Reference;
  SMPExecution& execution = work.Execution;

  const TriangleTree referenceFaces = reference.MakeTree();
  NearestFaces vertices = FindNearest(referenceFaces, result.View.Mesh.Positions, execution);
  if (!execution.Proceed(0.3))
  {
    return false;
  }
  NearestFaces centroids = FindNearest(referenceFaces, result.Geometry.Centroids, execution);
  if (!execution.Proceed(0.5))
  {
    return false;
  }
  work.Distances = std::move(vertices.Distances);
  work.Partner = std::move(centroids.Faces);
  const Statistics distances = result.SummarizeVertices(work.Distances, execution);
  this->MeanDistance = distances.Mean;
  this->HausdorffToReference =
    std::fmax(distances.Maximum, Summarize(centroids.Distances, {}, execution).Maximum);

  // The way back. Without faces in the result all distances are NaN.
  const TriangleTree resultFaces = result.MakeTree();
  vertices = FindNearest(resultFaces, reference.View.Mesh.Positions, execution);
  if (!execution.Proceed(0.7))
  {
    return false;
  }
  centroids = FindNearest(resultFaces, reference.Geometry.Centroids, execution);
  this->HausdorffFromReference =
    std::fmax(reference.SummarizeVertices(vertices.Distances, execution).Maximum,
      Summarize(centroids.Distances, {}, execution).Maximum);
  this->HausdorffDistance = Larger(this->HausdorffToReference, this->HausdorffFromReference);
  return execution.Proceed(0.9);
}

void vtkSurfaceComparison::CompareNormals(Work& work)
{
  const Buffer<Vec3>& normals = work.Result.Geometry.Normals;
  const Buffer<Vec3>& expected = work.Reference.Geometry.Normals;
  const bool same = this->SameConnectivity != 0.0;
  Buffer<double>& angles = work.NormalAngles;
  angles.resize(normals.size());
  work.Execution.For(angles.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t f = begin; f < end; ++f)
      {
        const Index partner = same ? static_cast<Index>(f) : work.Partner[f];
        angles[f] = partner == NoIndex ? Undefined : AngleBetween(normals[f], expected[partner]);
      }
    });

  const Statistics angle = Summarize(angles, work.Result.Geometry.Areas, work.Execution);
  this->UncomparedFaces = static_cast<double>(angles.size() - angle.Count);
  this->MeanNormalAngle = angle.Mean;
  this->RMSNormalAngle = angle.RootMeanSquare;
  this->MedianNormalAngle = angle.Median;
  this->Percentile95NormalAngle = angle.Percentile95;
  this->MaximumNormalAngle = angle.Maximum;
  this->AreaWeightedNormalAngle = angle.WeightedMean;
  this->FlippedFaces = static_cast<double>(
    std::count_if(angles.begin(), angles.end(), [](double a) { return a > 90.0; }));
}

void vtkSurfaceComparison::CompareFeatures(Work& work)
{
  const NeighborGraph edges =
    EdgeAdjacentFaces(work.Reference.View.Mesh, work.Reference.Stars, work.Execution);
  const FeatureAgreement features = CompareFeatureEdges(edges, work.Result.Geometry.Normals,
    work.Reference.Geometry.Normals, this->FeatureAngle, work.Execution);
  this->ReferenceFeatureEdges = static_cast<double>(features.Reference);
  this->FoundFeatureEdges = static_cast<double>(features.Found);
  this->MissedFeatureEdges = static_cast<double>(features.Missed());
  this->InventedFeatureEdges = static_cast<double>(features.Invented);
}

void vtkSurfaceComparison::CompareShapes(Work& work)
{
  const ComparedSurface& result = work.Result;
  const ComparedSurface& reference = work.Reference;
  this->ReferenceDiagonal = reference.Diagonal();
  this->PositionError =
    AreaWeightedDistance(result.View.Mesh, result.Geometry.Areas, work.Distances, work.Execution);
  this->RelativePositionError = this->PositionError / this->ReferenceDiagonal;
  this->RelativeMeanDistance = this->MeanDistance / this->ReferenceDiagonal;
  this->RelativeHausdorffDistance = this->HausdorffDistance / this->ReferenceDiagonal;

  this->Volume = result.EnclosedVolume(work.Execution);
  this->ReferenceVolume = reference.EnclosedVolume(work.Execution);
  this->RelativeVolumeChange = this->ReferenceVolume == 0.0
    ? Undefined
    : (this->Volume - this->ReferenceVolume) / this->ReferenceVolume;

  this->TriangleQuality =
    SurfaceDenoising::TriangleQuality(result.View.Mesh, result.Geometry.Areas, work.Execution);
  this->ReferenceTriangleQuality = SurfaceDenoising::TriangleQuality(reference.View.Mesh,
    reference.Geometry.Areas, work.Execution);
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
  for (const Quantity& quantity : Quantity::All)
  {
    os << indent << quantity.Name << ": " << this->*quantity.Value << "\n";
  }
}
