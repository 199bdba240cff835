// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOFFReader.h"

#include "FileContent.h"
#include "OFFBinaryScanner.h"
#include "OFFColors.h"
#include "OFFKeyword.h"
#include "OFFTextScanner.h"
#include "SMPExecution.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

using namespace SurfaceDenoising;

namespace
{
struct Counts
{
  vtkIdType Vertices;
  vtkIdType Faces;
};

/// Read the counts of the header and refuse those for which the file has no room, so that nothing
/// is ever allocated that is not backed by data.
template <typename Scanner>
Counts ReadCounts(Scanner& scanner, const OFFKeyword& keyword)
{
  const vtkIdType vertices = scanner.ReadInteger("the number of vertices");
  const vtkIdType faces = scanner.ReadInteger("the number of faces");
  scanner.SkipEdgeCount();
  const std::size_t reals =
    3 + (keyword.Normals ? 3 : 0) + (keyword.Colors ? 3 : 0) + (keyword.TextureCoordinates ? 2 : 0);
  // The last number of a text need not be followed by a space.
  const double room = static_cast<double>(scanner.RemainingBytes()) + 1.0;
  const double needed = static_cast<double>(vertices) * Scanner::MinimumVertexBytes(reals) +
    static_cast<double>(faces) * Scanner::MinimumFaceBytes;
  if (vertices < 0 || faces < 0 || needed > room)
  {
    scanner.Fail("the header announces " + std::to_string(vertices) + " vertices and " +
      std::to_string(faces) + " faces, which do not fit into the rest of the file (" +
      std::to_string(scanner.RemainingBytes()) + " bytes)");
  }
  return { vertices, faces };
}

/// Every so many vertices or faces, says how far it is and asks whether to go on.
template <typename Scanner>
bool Proceed(const Scanner& scanner, vtkIdType number, std::size_t bytes, Execution& execution)
{
  return number % 16384 != 0 ||
    execution.Proceed(1.0 - static_cast<double>(scanner.RemainingBytes()) / bytes);
}

/// False if it was stopped, as the functions that follow.
template <typename Scanner>
bool ReadVertices(Scanner& scanner, const OFFKeyword& keyword, vtkIdType count, std::size_t bytes,
  vtkPolyData* output, Execution& execution)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  vtkNew<vtkDoubleArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(keyword.Normals ? count : 0);
  vtkNew<vtkDoubleArray> textureCoordinates;
  textureCoordinates->SetName("TextureCoordinates");
  textureCoordinates->SetNumberOfComponents(2);
  textureCoordinates->SetNumberOfTuples(keyword.TextureCoordinates ? count : 0);
  OFFColors colors;

  const auto readTuple = [&scanner](double* tuple, int size, const char* what)
  { std::generate_n(tuple, size, [&] { return scanner.ReadReal(what); }); };
  auto* const coordinates = vtkDoubleArray::SafeDownCast(points->GetData());
  for (vtkIdType i = 0; i < count; ++i)
  {
    if (!Proceed(scanner, i, bytes, execution))
    {
      return false;
    }
    readTuple(coordinates->GetPointer(3 * i), 3, "a coordinate");
    if (keyword.Normals)
    {
      readTuple(normals->GetPointer(3 * i), 3, "a normal component");
    }
    if (keyword.Colors)
    {
      colors.Append(scanner.ReadVertexColor(keyword.TextureCoordinates));
    }
    if (keyword.TextureCoordinates)
    {
      readTuple(textureCoordinates->GetPointer(2 * i), 2, "a texture coordinate");
    }
  }

  output->SetPoints(points);
  if (keyword.Normals)
  {
    output->GetPointData()->SetNormals(normals);
  }
  if (keyword.TextureCoordinates)
  {
    output->GetPointData()->SetTCoords(textureCoordinates);
  }
  if (const auto array = colors.MakeArray())
  {
    output->GetPointData()->SetScalars(array);
  }
  return true;
}

template <typename Scanner>
bool ReadFaces(Scanner& scanner, const Counts& counts, std::size_t bytes, vtkPolyData* output,
  Execution& execution)
{
  // A polydata numbers its vertices before its lines and these before its polygons.
  struct Kind
  {
    vtkNew<vtkCellArray> Cells;
    OFFColors Colors;
  };
  std::array<Kind, 3> kinds;
  kinds[2].Cells->AllocateEstimate(counts.Faces, 3);

  std::vector<vtkIdType> corners;
  for (vtkIdType face = 0; face < counts.Faces; ++face)
  {
    if (!Proceed(scanner, face, bytes, execution))
    {
      return false;
    }
    const vtkIdType size = scanner.ReadInteger("the number of corners of a face");
    if (size < 1 || static_cast<std::size_t>(size) > scanner.RemainingBytes())
    {
      scanner.Fail("face " + std::to_string(face) + " has " + std::to_string(size) + " corners");
    }
    corners.resize(size);
    for (vtkIdType& corner : corners)
    {
      corner = scanner.ReadInteger("the index of a corner");
      if (corner < 0 || corner >= counts.Vertices)
      {
        scanner.Fail("face " + std::to_string(face) + " refers to vertex " +
          std::to_string(corner) + ", the file has vertices 0 to " +
          std::to_string(counts.Vertices - 1));
      }
    }
    Kind& kind = kinds[std::min<vtkIdType>(size, 3) - 1];
    kind.Cells->InsertNextCell(size, corners.data());
    kind.Colors.Append(scanner.ReadFaceColor());
  }

  if (counts.Faces == 0)
  {
    for (vtkIdType point = 0; point < counts.Vertices; ++point)
    {
      kinds[0].Cells->InsertNextCell(1, &point);
    }
  }
  output->SetVerts(kinds[0].Cells);
  output->SetLines(kinds[1].Cells);
  output->SetPolys(kinds[2].Cells);

  OFFColors colors;
  for (const Kind& kind : kinds)
  {
    colors.Append(kind.Colors);
  }
  if (const auto array = colors.MakeArray())
  {
    output->GetCellData()->SetScalars(array);
  }
  return true;
}

template <typename Scanner>
bool ReadSurface(Scanner scanner, const OFFKeyword& keyword, vtkPolyData* output,
  Execution& execution)
{
  const std::size_t bytes = scanner.RemainingBytes();
  const Counts counts = ReadCounts(scanner, keyword);
  return ReadVertices(scanner, keyword, counts.Vertices, bytes, output, execution) &&
    ReadFaces(scanner, counts, bytes, output, execution);
}
}

//------------------------------------------------------------------------------
vtkStandardNewMacro(vtkOFFReader);

//------------------------------------------------------------------------------
int vtkOFFReader::CanReadFile(const char* filename)
{
  try
  {
    ReadOFFKeyword(LoadFile(filename ? filename : "", 4096));
    return 1;
  }
  catch (const FileError&)
  {
    return 0;
  }
}

//------------------------------------------------------------------------------
int vtkOFFReader::RequestData(vtkInformation*, vtkInformationVector**,
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
    const std::string text = LoadFile(this->FileName);
    const OFFKeyword keyword = ReadOFFKeyword(text);
    vtkNew<vtkPolyData> surface;
    SMPExecution execution(this);
    const bool finished = keyword.Binary
      ? ReadSurface(OFFBinaryScanner(text, keyword.Length), keyword, surface, execution)
      : ReadSurface(OFFTextScanner(text, keyword.Length), keyword, surface, execution);
    if (finished)
    {
      vtkPolyData::GetData(outputVector)->ShallowCopy(surface);
    }
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
void vtkOFFReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
