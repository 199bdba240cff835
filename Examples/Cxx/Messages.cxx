// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Messages.h"

#include <vtkCommand.h>
#include <vtkObject.h>

namespace
{

/// "ERROR: In file.cxx, line 1\nvtkClass (0x12): text\n\n" without all but the text.
std::string Essence(const std::string& raw)
{
  std::size_t begin = raw.find("): ");
  begin = begin == std::string::npos ? 0 : begin + 3;
  const std::size_t end = raw.find_last_not_of(" \n\r\t");
  return end == std::string::npos || end < begin ? raw : raw.substr(begin, end + 1 - begin);
}

}

Messages::Messages(vtkObject* object)
  : Object(object)
{
  this->Tags[0] = object->AddObserver(vtkCommand::ErrorEvent, this, &Messages::Take);
  this->Tags[1] = object->AddObserver(vtkCommand::WarningEvent, this, &Messages::Take);
}

Messages::~Messages()
{
  this->Object->RemoveObserver(this->Tags[0]);
  this->Object->RemoveObserver(this->Tags[1]);
}

void Messages::Take(vtkObject*, unsigned long event, void* text)
{
  std::string& list = event == vtkCommand::ErrorEvent ? this->Errors : this->Warnings;
  const std::string message = Essence(text ? static_cast<const char*>(text) : "unknown reason");
  list += list.empty() ? message : "; " + message;
}
