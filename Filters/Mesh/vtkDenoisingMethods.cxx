// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkDenoisingMethods.h"

#include "Methods.h"

#include "vtkObjectFactory.h"

namespace sd = SurfaceDenoising;

vtkStandardNewMacro(vtkDenoisingMethods);

namespace
{

const sd::MethodRow* Find(int method)
{
  const bool exists = method >= 0 && method < vtkDenoisingMethods::GetNumberOfMethods();
  return exists ? &sd::Methods()[static_cast<std::size_t>(method)] : nullptr;
}

}

vtkDenoisingMethods::vtkDenoisingMethods() = default;
vtkDenoisingMethods::~vtkDenoisingMethods() = default;

int vtkDenoisingMethods::GetNumberOfMethods()
{
  return static_cast<int>(sd::Methods().size());
}

const char* vtkDenoisingMethods::GetName(int method)
{
  const sd::MethodRow* row = Find(method);
  return row ? row->Name : nullptr;
}

const char* vtkDenoisingMethods::GetPaper(int method)
{
  const sd::MethodRow* row = Find(method);
  return row ? row->Paper : nullptr;
}

const char* vtkDenoisingMethods::GetFilter(int method)
{
  const sd::MethodRow* row = Find(method);
  return row ? row->Filter : nullptr;
}

bool vtkDenoisingMethods::IsTwoStage(int method)
{
  const sd::MethodRow* row = Find(method);
  return row && row->TwoStage;
}

bool vtkDenoisingMethods::IsComposed(int method)
{
  const sd::MethodRow* row = Find(method);
  return row && row->Composed;
}

void vtkDenoisingMethods::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (const sd::MethodRow& row : sd::Methods())
  {
    os << indent << row.Name << ": " << row.Paper << ", vtk" << row.Filter << "\n";
  }
}
