// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkSurfaceNoise.h"

#include "NeighborGraph.h"
#include "Noise.h"
#include "PointAdapter.h"
#include "PolygonGeometry.h"
#include "SMPExecution.h"
#include "SurfaceAdapter.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>

using namespace SurfaceDenoising;

vtkStandardNewMacro(vtkSurfaceNoise);

namespace
{

/// Over all points that have another point; 0 without any.
double MeanNearestDistance(const Buffer<Vec3>& points, Execution& execution)
{
  const NeighborGraph nearest = NearestPoints(points, 1, execution);
  const double sum = OrderedSum(execution, points.size(), 0.0,
    [&](std::size_t i)
    {
      const Span<Index> row = nearest.Row(i);
      return row.size() > 0 ? (points[i] - points[row[0]]).norm() : 0.0;
    });
  return nearest.NumberOfIds() > 0 ? sum / static_cast<double>(nearest.NumberOfIds()) : 0.0;
}

/// Moves every position. Without normals, directions are random.
void AddNoise(const NoiseSource& noise, const Buffer<Vec3>& normals, Buffer<Vec3>& positions,
  Execution& execution)
{
  execution.For(positions.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        positions[i] += noise.Amplitude(i) * (normals.empty() ? noise.Direction(i) : normals[i]);
      }
    });
}

void AddFieldValue(vtkPolyData* output, const char* name, double value)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->InsertNextValue(value);
  output->GetFieldData()->AddArray(array);
}

}

int vtkSurfaceNoise::RequestData(vtkInformation*, vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  this->UnitLength = 0.0;
  if (!input || input->GetNumberOfPoints() == 0)
  {
    output->ShallowCopy(input);
    return 1;
  }

  bool done = false;
  RunOnThreads(0, [&]() { done = this->MovePoints(input, output); });
  return done;
}

bool vtkSurfaceNoise::MovePoints(vtkPolyData* input, vtkPolyData* output)
{
  SMPExecution execution(this);
  MeshView view;
  std::string error;
  if (!ReadSurface(input, view, error, execution))
  {
    vtkErrorMacro(<< error);
    return false;
  }
  Buffer<Vec3>& positions = view.Mesh.Positions;
  const auto strays =
    std::count_if(positions.begin(), positions.end(), [](const Vec3& p) { return !p.allFinite(); });
  if (strays > 0)
  {
    vtkWarningMacro(<< strays << " points are not finite and stay as they are.");
  }

  const bool isSurface = view.Mesh.NumberOfFaces() > 0;
  this->UnitLength = isSurface ? MeanPolygonEdgeLength(input, view, execution)
                               : MeanNearestDistance(positions, execution);
  if (!(this->UnitLength > 0.0))
  {
    vtkWarningMacro("No noise was added because there is no length to measure it in: " << (isSurface
                        ? "all edges have length zero."
                        : "no point has a neighbor at another place. Are points duplicated?"));
  }

  Buffer<Vec3> normals;
  if (this->Direction == VertexNormals && isSurface)
  {
    normals = SurfaceDenoising::VertexNormals(input, view, this->UnitLength);
  }
  else if (this->Direction == VertexNormals)
  {
    vtkDataArray* given = GivenNormals(input, true);
    if (!given)
    {
      vtkErrorMacro("A point set without polygons needs point normals for noise along them. "
                    "Compute normals or choose random directions.");
      return false;
    }
    if (!ReadNormals(given, input, normals, error, execution))
    {
      vtkErrorMacro(<< error);
      return false;
    }
  }
  if (!execution.Proceed(0.5))
  {
    return true;
  }

  NoiseParameters parameters;
  parameters.Kind = static_cast<NoiseKind>(this->NoiseType);
  parameters.Deviation = this->Size * this->UnitLength;
  parameters.Fraction = this->Fraction;
  parameters.Seed = static_cast<std::uint64_t>(this->Seed);
  AddNoise(NoiseSource(parameters, positions.size()), normals, positions, execution);

  auto points = MovedPoints(input, view.Centre, positions, execution);
  if (isSurface)
  {
    PassSurface(input, points, output);
  }
  else
  {
    output->ShallowCopy(input);
    output->SetPoints(points);
  }
  AddFieldValue(output, "NoiseDeviation", parameters.Deviation);
  execution.Proceed(1.0);
  return true;
}

void vtkSurfaceNoise::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NoiseType: " << this->NoiseType << "\n";
  os << indent << "Direction: " << this->Direction << "\n";
  os << indent << "Size: " << this->Size << "\n";
  os << indent << "Fraction: " << this->Fraction << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "UnitLength: " << this->UnitLength << "\n";
}
