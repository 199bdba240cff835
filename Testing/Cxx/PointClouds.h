// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file PointClouds.h
 * @brief Points to denoise, with and without cells and normals, and comparisons to the last bit.
 */

#ifndef PointClouds_h
#define PointClouds_h

#include "TestSurfaces.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"

#include <cstring>

namespace PointTest
{

using namespace MeshTest;

using Places = std::vector<std::array<double, 3>>;

inline vtkSmartPointer<vtkPolyData> MakeCloud(const Places& points)
{
  return MakeSurface(points, {});
}

/// The unit sphere, evenly, with noise; the spacing is 3.54 / sqrt(count).
inline vtkSmartPointer<vtkPolyData> SphereCloud(int count = 600, double noise = 0.04)
{
  Places points;
  for (int i = 0; i < count; ++i)
  {
    const double z = 1.0 - (2.0 * i + 1.0) / count;
    const double angle = i * 2.399963229728653;
    const double r = std::sqrt(1.0 - z * z);
    points.push_back({ r * std::cos(angle), r * std::sin(angle), z });
  }
  auto cloud = MakeCloud(points);
  Shake(cloud, noise);
  return cloud;
}

/// side x side points on each face of the cube [-1, 1]^3, with noise; the spacing is 2 / side.
inline vtkSmartPointer<vtkPolyData> CubeCloud(int side = 10, double noise = 0.04)
{
  Places points;
  for (std::size_t face = 0; face < 6; ++face)
  {
    for (int k = 0; k < side * side; ++k)
    {
      std::array<double, 3> p;
      p[face / 2] = face % 2 == 0 ? 1.0 : -1.0;
      p[(face / 2 + 1) % 3] = (k % side * 2.0 + 1.0) / side - 1.0;
      p[(face / 2 + 2) % 3] = (k / side * 2.0 + 1.0) / side - 1.0;
      points.push_back(p);
    }
  }
  auto cloud = MakeCloud(points);
  Shake(cloud, noise);
  return cloud;
}

/// Normals of a sphere around the origin, with noise and any length.
inline vtkSmartPointer<vtkDoubleArray> SphereNormals(vtkPolyData* cloud, const char* name,
  double noise = 0.0, double length = 1.0)
{
  auto normals = vtkSmartPointer<vtkDoubleArray>::New();
  normals->SetName(name);
  normals->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
  {
    double n[3];
    cloud->GetPoint(i, n);
    vtkMath::Normalize(n);
    for (int c = 0; c < 3; ++c)
    {
      n[c] += noise * Wobble(5 * i + c);
    }
    vtkMath::Normalize(n);
    vtkMath::MultiplyScalar(n, length);
    normals->InsertNextTuple(n);
  }
  return normals;
}

/// Every point becomes a vertex cell.
inline void AddVertices(vtkPolyData* cloud)
{
  vtkNew<vtkCellArray> vertices;
  for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
  {
    vertices->InsertNextCell(1, &i);
  }
  cloud->SetVerts(vertices);
}

/// True if both are null, or have the same name, type and content, NaN included.
inline bool SameArray(vtkAbstractArray* a, vtkAbstractArray* b)
{
  if (!a || !b)
  {
    return a == b;
  }
  const std::string nameOfA = a->GetName() ? a->GetName() : "";
  const std::string nameOfB = b->GetName() ? b->GetName() : "";
  if (nameOfA != nameOfB || a->GetDataType() != b->GetDataType() ||
    a->GetNumberOfComponents() != b->GetNumberOfComponents() ||
    a->GetNumberOfValues() != b->GetNumberOfValues())
  {
    return false;
  }
  if (vtkDataArray::SafeDownCast(a) == nullptr)
  {
    for (vtkIdType i = 0; i < a->GetNumberOfValues(); ++i)
    {
      if (a->GetVariantValue(i).ToString() != b->GetVariantValue(i).ToString())
      {
        return false;
      }
    }
    return true;
  }
  const auto bytes = static_cast<std::size_t>(a->GetNumberOfValues() * a->GetDataTypeSize());
  return bytes == 0 || std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0), bytes) == 0;
}

/// True if all arrays of a are in b, in the same places.
inline bool SameArrays(vtkFieldData* a, vtkFieldData* b)
{
  bool same = a->GetNumberOfArrays() == b->GetNumberOfArrays();
  for (int i = 0; same && i < a->GetNumberOfArrays(); ++i)
  {
    same = SameArray(a->GetAbstractArray(i), b->GetAbstractArray(i));
  }
  return same;
}

inline bool SameCells(vtkPolyData* a, vtkPolyData* b)
{
  auto same = [](vtkCellArray* c, vtkCellArray* d)
  {
    return c->GetNumberOfCells() == d->GetNumberOfCells() &&
      (c->GetNumberOfCells() == 0 ||
        (SameArray(c->GetOffsetsArray(), d->GetOffsetsArray()) &&
          SameArray(c->GetConnectivityArray(), d->GetConnectivityArray())));
  };
  return same(a->GetVerts(), b->GetVerts()) && same(a->GetLines(), b->GetLines()) &&
    same(a->GetPolys(), b->GetPolys()) && same(a->GetStrips(), b->GetStrips());
}

inline vtkAbstractArray* CoordinatesOf(vtkPolyData* data)
{
  return data->GetNumberOfPoints() > 0 ? data->GetPoints()->GetData() : nullptr;
}

/// True if nothing at all differs.
inline bool SameData(vtkPolyData* a, vtkPolyData* b)
{
  bool same = SameArray(CoordinatesOf(a), CoordinatesOf(b)) && SameCells(a, b) &&
    SameArrays(a->GetPointData(), b->GetPointData()) &&
    SameArrays(a->GetCellData(), b->GetCellData()) &&
    SameArrays(a->GetFieldData(), b->GetFieldData());
  for (int type = 0; same && type < vtkDataSetAttributes::NUM_ATTRIBUTES; ++type)
  {
    same = SameArray(a->GetPointData()->GetAbstractAttribute(type),
             b->GetPointData()->GetAbstractAttribute(type)) &&
      SameArray(a->GetCellData()->GetAbstractAttribute(type),
        b->GetCellData()->GetAbstractAttribute(type));
  }
  return same;
}

/// True if the points and the arrays that filters add are the same to the last bit.
inline bool SameResult(vtkPolyData* a, vtkPolyData* b)
{
  bool same = SameArray(CoordinatesOf(a), CoordinatesOf(b));
  for (const char* name : { "Normals", "Displacement", "Status", "FeatureClass" })
  {
    same = same &&
      SameArray(a->GetPointData()->GetAbstractArray(name),
        b->GetPointData()->GetAbstractArray(name));
  }
  return same;
}

/// How many points have this value in the array Status.
inline int CountStatus(vtkPolyData* output, int value)
{
  vtkDataArray* status = output->GetPointData()->GetArray("Status");
  int count = 0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    count += status->GetComponent(i, 0) == value;
  }
  return count;
}

/// A component of the array DenoisingReport; NaN if it has none of this name.
inline double Figure(vtkPolyData* output, const std::string& name)
{
  vtkDataArray* report = output->GetFieldData()->GetArray("DenoisingReport");
  for (int i = 0; i < report->GetNumberOfComponents(); ++i)
  {
    if (report->GetComponentName(i) == name)
    {
      return report->GetComponent(0, i);
    }
  }
  return vtkMath::Nan();
}

/// The sum of n . p over the points: positive if normals point away from the origin.
inline double Outwards(vtkPolyData* cloud)
{
  vtkDataArray* normals = cloud->GetPointData()->GetArray("Normals");
  double sum = 0.0;
  for (vtkIdType i = 0; normals && i < cloud->GetNumberOfPoints(); ++i)
  {
    double n[3];
    normals->GetTuple(i, n);
    sum += vtkMath::Dot(n, cloud->GetPoint(i));
  }
  return sum;
}

}

#endif
