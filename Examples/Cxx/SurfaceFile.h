// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SurfaceFile_h
#define SurfaceFile_h

#include "vtkCommand.h"
#include "vtkSmartPointer.h"

#include <string>

class vtkPolyData;

/// Keeps the errors and warnings of an object instead of printing them.
class MessageKeeper : public vtkCommand
{
public:
  static MessageKeeper* New() { return new MessageKeeper; }

  /// Errors and warnings of the object, and of its executive if it is an algorithm.
  void Watch(vtkObject* object);
  void Execute(vtkObject* caller, unsigned long event, void* text) override;

  std::string Error;   ///< the first one, in one line
  std::string Warning; ///< the first one, in one line
};

/// What a file must hold.
enum class Needs
{
  Polygons,
  Points ///< polygons or not
};

/// Strips count too.
bool HasPolygons(vtkPolyData* surface);

/// Reads a surface by its extension. Returns null with a message that says what is wrong.
vtkSmartPointer<vtkPolyData> ReadSurfaceFile(const std::string& path, std::string& message,
  Needs needs = Needs::Polygons);

/// Writes a surface by its extension. Returns false with a message that says what is wrong.
bool WriteSurfaceFile(const std::string& path, vtkPolyData* surface, std::string& message);

/// True if a surface can be written to a file of this name; else message says why not.
bool CanWriteSurfaceFile(const std::string& path, std::string& message);

/// True if a file of this name can hold the surface: STL files hold no points without polygons.
bool CanHold(const std::string& path, vtkPolyData* surface, std::string& message);

#endif
