// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceFile.h"

#include "vtkAlgorithm.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtkOBJReader.h"
#include "vtkOBJWriter.h"
#include "vtkOFFReader.h"
#include "vtkPLYReader.h"
#include "vtkPLYWriter.h"
#include "vtkPolyData.h"
#include "vtkPolyDataReader.h"
#include "vtkPolyDataWriter.h"
#include "vtkSTLReader.h"
#include "vtkSTLWriter.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLPolyDataWriter.h"
#include "vtkXYZReader.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace
{

/// In lower case, with the dot.
std::string Extension(const std::string& path)
{
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

template <typename Reader>
vtkSmartPointer<vtkPolyData> ReadWith(const std::string& path, std::string& message, Needs needs)
{
  vtkNew<Reader> reader;
  vtkNew<MessageKeeper> keeper;
  keeper->Watch(reader);
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkSmartPointer<vtkPolyData> surface = reader->GetOutput();
  message = keeper->Error;
  if (message.empty() && (!surface || surface->GetNumberOfPoints() == 0))
  {
    message = keeper->Warning.empty() ? "it has no points" : keeper->Warning;
  }
  if (message.empty() && needs == Needs::Polygons && !HasPolygons(surface))
  {
    message = "it has " + std::to_string(surface->GetNumberOfPoints()) + " points but no polygons";
  }
  return message.empty() ? surface : nullptr;
}

template <typename Writer>
bool WriteWith(const std::string& path, vtkPolyData* surface, std::string& message)
{
  vtkNew<Writer> writer;
  vtkNew<MessageKeeper> keeper;
  keeper->Watch(writer);
  if constexpr (std::is_same_v<Writer, vtkXMLPolyDataWriter>)
  {
    // The default, raw data behind the XML, is refused by recent versions of expat.
    writer->SetDataModeToBinary();
  }
  writer->SetFileName(path.c_str());
  writer->SetInputData(surface);
  const bool written = writer->Write() != 0;
  message = keeper->Error;
  if (message.empty() && !written)
  {
    message = "the file could not be written";
  }
  return message.empty();
}

using Write = bool (*)(const std::string&, vtkPolyData*, std::string&);

Write FindWriter(const std::string& path, std::string& message)
{
  const std::string extension = Extension(path);
  if (extension == ".ply")
  {
    return WriteWith<vtkPLYWriter>;
  }
  if (extension == ".obj")
  {
    return WriteWith<vtkOBJWriter>;
  }
  if (extension == ".stl")
  {
    return WriteWith<vtkSTLWriter>;
  }
  if (extension == ".vtp")
  {
    return WriteWith<vtkXMLPolyDataWriter>;
  }
  if (extension == ".vtk")
  {
    return WriteWith<vtkPolyDataWriter>;
  }
  message = "files can be written as .ply, .obj, .stl, .vtp or .vtk, not as \"" + extension + "\"";
  return nullptr;
}

}

void MessageKeeper::Watch(vtkObject* object)
{
  object->AddObserver(vtkCommand::ErrorEvent, this);
  object->AddObserver(vtkCommand::WarningEvent, this);
  if (auto* algorithm = vtkAlgorithm::SafeDownCast(object))
  {
    algorithm->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this);
  }
}

void MessageKeeper::Execute(vtkObject* caller, unsigned long event, void* data)
{
  // "ERROR: In file, line n\nclass (address): what happened\n\n"
  std::string text = data ? static_cast<const char*>(data) : "";
  const std::size_t address = text.find("): ");
  text.erase(0, address == std::string::npos ? 0 : address + 3);
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())))
  {
    text.pop_back();
  }
  std::replace(text.begin(), text.end(), '\n', ' ');
  std::string& kept = event == vtkCommand::ErrorEvent ? this->Error : this->Warning;
  // The executive only repeats that its algorithm failed.
  if (kept.empty() && !vtkExecutive::SafeDownCast(caller))
  {
    kept = text;
  }
}

bool HasPolygons(vtkPolyData* surface)
{
  return surface->GetNumberOfPolys() + surface->GetNumberOfStrips() > 0;
}

vtkSmartPointer<vtkPolyData> ReadSurfaceFile(const std::string& path, std::string& message,
  Needs needs)
{
  if (!std::filesystem::exists(path))
  {
    message = "there is no such file";
    return nullptr;
  }
  if (std::filesystem::is_directory(path))
  {
    message = "it is a folder";
    return nullptr;
  }
  if (!std::ifstream(path))
  {
    message = "it may not be opened";
    return nullptr;
  }
  if (std::filesystem::is_regular_file(path) && std::filesystem::file_size(path) == 0)
  {
    message = "the file is empty";
    return nullptr;
  }
  const std::string extension = Extension(path);
  if (extension == ".ply")
  {
    return ReadWith<vtkPLYReader>(path, message, needs);
  }
  if (extension == ".obj")
  {
    return ReadWith<vtkOBJReader>(path, message, needs);
  }
  if (extension == ".stl")
  {
    return ReadWith<vtkSTLReader>(path, message, needs);
  }
  if (extension == ".off")
  {
    return ReadWith<vtkOFFReader>(path, message, needs);
  }
  if (extension == ".vtp")
  {
    return ReadWith<vtkXMLPolyDataReader>(path, message, needs);
  }
  if (extension == ".vtk")
  {
    return ReadWith<vtkPolyDataReader>(path, message, needs);
  }
  if (extension == ".xyz" || extension == ".xyzn" || extension == ".pts" || extension == ".asc")
  {
    return ReadWith<vtkXYZReader>(path, message, needs);
  }
  message =
    "files can be read as .ply, .obj, .stl, .off, .vtp or .vtk, points also as .xyz, .xyzn, "
    ".pts or .asc, not as \"" +
    extension + "\"";
  return nullptr;
}

bool WriteSurfaceFile(const std::string& path, vtkPolyData* surface, std::string& message)
{
  const Write write = FindWriter(path, message);
  return write && write(path, surface, message);
}

bool CanWriteSurfaceFile(const std::string& path, std::string& message)
{
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  if (!folder.empty() && !std::filesystem::is_directory(folder))
  {
    message = "there is no folder " + folder.string();
    return false;
  }
  return FindWriter(path, message) != nullptr;
}

bool CanHold(const std::string& path, vtkPolyData* surface, std::string& message)
{
  if (Extension(path) == ".stl" && !HasPolygons(surface))
  {
    message = "STL files hold polygons only";
    return false;
  }
  return true;
}
