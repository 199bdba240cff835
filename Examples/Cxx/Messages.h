// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file Messages.h
 * @brief Errors of VTK objects as plain sentences instead of VTK's raw output.
 */

#ifndef Messages_h
#define Messages_h

#include <string>

class vtkObject;

/// Listens to an object until one of the two goes away.
class Messages
{
public:
  explicit Messages(vtkObject* object);
  ~Messages();
  Messages(const Messages&) = delete;
  void operator=(const Messages&) = delete;

  bool HasErrors() const { return !this->Errors.empty(); }
  const std::string& GetErrors() const { return this->Errors; }
  const std::string& GetWarnings() const { return this->Warnings; }

private:
  void Take(vtkObject* caller, unsigned long event, void* text);

  vtkObject* Object;
  unsigned long Tags[2];
  std::string Errors;
  std::string Warnings;
};

#endif
