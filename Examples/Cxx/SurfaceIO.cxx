// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceIO.h"

#include "Messages.h"

#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkOBJWriter.h>
#include <vtkOFFReader.h>
#include <vtkPLYReader.h>
#include <vtkPLYWriter.h>
#include <vtkPolyDataReader.h>
#include <vtkPolyDataWriter.h>
#include <vtkSTLReader.h>
#include <vtkSTLWriter.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>

namespace
{

using Surface = vtkSmartPointer<vtkPolyData>;

template <typename Reader>
Surface Read(const std::string& file, std::string& error)
{
  vtkNew<Reader> reader;
  const Messages messages(reader);
  reader->SetFileName(file.c_str());
  reader->Update();
  error = messages.GetErrors();
  return reader->GetOutput();
}

template <typename Writer>
void Write(vtkPolyData* surface, const std::string& file, std::string& error)
{
  vtkNew<Writer> writer;
  const Messages messages(writer);
  writer->SetFileName(file.c_str());
  writer->SetInputData(surface);
  const bool written = writer->Write() != 0 && writer->GetErrorCode() == 0;
  error = messages.GetErrors();
  if (!written && error.empty())
  {
    error = "writing failed";
  }
}

using ReadFunction = Surface (*)(const std::string&, std::string&);
using WriteFunction = void (*)(vtkPolyData*, const std::string&, std::string&);

const std::map<std::string, ReadFunction> Readers = {
  { ".obj", Read<vtkOBJReader> },
  { ".off", Read<vtkOFFReader> },
  { ".ply", Read<vtkPLYReader> },
  { ".stl", Read<vtkSTLReader> },
  { ".vtk", Read<vtkPolyDataReader> },
  { ".vtp", Read<vtkXMLPolyDataReader> },
};

const std::map<std::string, WriteFunction> Writers = {
  { ".obj", Write<vtkOBJWriter> },
  { ".ply", Write<vtkPLYWriter> },
  { ".stl", Write<vtkSTLWriter> },
  { ".vtk", Write<vtkPolyDataWriter> },
  { ".vtp", Write<vtkXMLPolyDataWriter> },
};

std::string Extension(const std::string& file)
{
  std::string extension = std::filesystem::path(file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

template <typename Table>
std::string Keys(const Table& table)
{
  std::string keys;
  for (const auto& entry : table)
  {
    keys += (keys.empty() ? "" : " ") + entry.first;
  }
  return keys;
}

}

std::string ReadableExtensions() { return Keys(Readers); }

std::string WritableExtensions() { return Keys(Writers); }

bool CanWrite(const std::string& file) { return Writers.count(Extension(file)) > 0; }

Surface ReadSurface(const std::string& file, std::string& error)
{
  std::error_code ignored;
  const auto reader = Readers.find(Extension(file));
  if (!std::filesystem::exists(file, ignored))
  {
    error = "there is no such file";
  }
  else if (!std::filesystem::is_regular_file(file, ignored))
  {
    error = "this is not a file";
  }
  else if (std::filesystem::file_size(file, ignored) == 0)
  {
    error = "the file is empty";
  }
  else if (reader == Readers.end())
  {
    error = "the extension is none of " + ReadableExtensions();
  }
  else
  {
    Surface surface = reader->second(file, error);
    if (!error.empty())
    {
      return nullptr;
    }
    if (surface->GetNumberOfPolys() + surface->GetNumberOfStrips() > 0)
    {
      return surface;
    }
    error = "there are no polygons in it";
  }
  return nullptr;
}

bool WriteSurface(vtkPolyData* surface, const std::string& file, std::string& error)
{
  Writers.at(Extension(file))(surface, file, error);
  return error.empty();
}
