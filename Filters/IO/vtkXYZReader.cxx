// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkXYZReader.h"

#include "FileContent.h"
#include "SMPExecution.h"
#include "XYZTable.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>

using namespace SurfaceDenoising;

namespace
{
/// An array of some columns of the table.
template <std::size_t N>
vtkSmartPointer<vtkDoubleArray> MakeArray(const XYZTable& table,
  const std::array<std::size_t, N>& columns, const char* name)
{
  const std::size_t rows = table.GetNumberOfRows();
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(N));
  array->SetNumberOfTuples(static_cast<vtkIdType>(rows));
  double* to = array->GetPointer(0);
  for (std::size_t row = 0; row < rows; ++row)
  {
    const double* const from = table.Values.data() + row * table.Columns;
    for (const std::size_t column : columns)
    {
      *to++ = from[column];
    }
  }
  return array;
}

/// Bytes of colors that are bytes or fractions.
vtkSmartPointer<vtkUnsignedCharArray> MakeColors(const XYZTable& table,
  const XYZLayout::Triple& columns)
{
  const auto values = MakeArray(table, columns, "RGB");
  const vtkIdType size = values->GetNumberOfValues();
  double largest = 0.0;
  bool allWhole = true;
  for (vtkIdType i = 0; i < size; ++i)
  {
    const double value = values->GetValue(i);
    if (!(0.0 <= value && value <= 255.0))
    {
      throw FileError("point " + std::to_string(i / 3) + " has a color component of " +
        std::to_string(value) + ", not between 0 and 255");
    }
    largest = std::max(largest, value);
    allWhole &= value == std::floor(value);
  }

  const double scale = largest <= 1.0 && !allWhole ? 255.0 : 1.0;
  auto bytes = vtkSmartPointer<vtkUnsignedCharArray>::New();
  bytes->SetName(values->GetName());
  bytes->SetNumberOfComponents(3);
  bytes->SetNumberOfTuples(values->GetNumberOfTuples());
  for (vtkIdType i = 0; i < size; ++i)
  {
    bytes->SetValue(i, static_cast<unsigned char>(std::lround(scale * values->GetValue(i))));
  }
  return bytes;
}

/// One vertex cell per point.
void MakeVertices(vtkIdType count, vtkPolyData* output)
{
  vtkNew<vtkIdTypeArray> ids;
  ids->SetNumberOfValues(count);
  std::iota(ids->GetPointer(0), ids->GetPointer(0) + count, 0);
  vtkNew<vtkCellArray> vertices;
  vertices->SetData(1, ids);
  output->SetVerts(vertices);
}

void MakeCloud(const XYZTable& table, vtkPolyData* output)
{
  const XYZLayout& layout = table.Layout;
  vtkNew<vtkPoints> points;
  points->SetData(MakeArray(table, layout.Position, "Points"));
  output->SetPoints(points);
  MakeVertices(points->GetNumberOfPoints(), output);

  // Others first: those that follow have the right to their names.
  vtkPointData* const data = output->GetPointData();
  for (const auto& other : layout.Others)
  {
    data->AddArray(MakeArray(table, std::array{ other.second }, other.first.c_str()));
  }
  if (layout.Intensity)
  {
    data->SetScalars(MakeArray(table, std::array{ *layout.Intensity }, "Intensity"));
  }
  if (layout.Normal)
  {
    data->SetNormals(MakeArray(table, *layout.Normal, "Normals"));
  }
  if (layout.Color)
  {
    const auto colors = MakeColors(table, *layout.Color);
    data->AddArray(colors);
    data->SetActiveScalars(colors->GetName());
  }
}
}

//------------------------------------------------------------------------------
vtkStandardNewMacro(vtkXYZReader);

//------------------------------------------------------------------------------
int vtkXYZReader::CanReadFile(const char* filename)
{
  const std::size_t most = 65536;
  try
  {
    std::string text = LoadFile(filename ? filename : "", most);
    if (text.size() == most)
    {
      text.resize(text.find_last_of('\n') + 1); // only whole lines tell
    }
    ReadXYZTable(
      text, [](double) { return true; }, 1);
    return 1;
  }
  catch (const FileError&)
  {
    return 0;
  }
}

//------------------------------------------------------------------------------
int vtkXYZReader::RequestData(vtkInformation*, vtkInformationVector**,
  vtkInformationVector* outputVector)
{
  this->SetErrorCode(vtkErrorCode::NoError);
  if (!this->FileName || !*this->FileName)
  {
    vtkErrorMacro("A FileName must be specified.");
    this->SetErrorCode(vtkErrorCode::NoFileNameError);
    return 0;
  }

  try
  {
    SMPExecution execution(this, 0.0, 0.9);
    XYZTable table = ReadXYZTable(LoadFile(this->FileName),
      [&execution](double part) { return execution.Proceed(part); });
    if (table.Stopped)
    {
      return 1;
    }
    if (const auto& triple = table.Layout.NormalOrColor)
    {
      const bool colors = this->SixColumns == Automatic
        ? AreColors(table.Values, table.Columns, *triple)
        : this->SixColumns == Colors;
      (colors ? table.Layout.Color : table.Layout.Normal) = triple;
    }
    vtkNew<vtkPolyData> cloud;
    MakeCloud(table, cloud);
    vtkPolyData::GetData(outputVector)->ShallowCopy(cloud);
    return 1;
  }
  catch (const FileError& error)
  {
    vtkErrorMacro(<< this->FileName << ": " << error.what());
    this->SetErrorCode(error.Code);
    return 0;
  }
}

//------------------------------------------------------------------------------
void vtkXYZReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SixColumns: " << this->SixColumns << "\n";
}
