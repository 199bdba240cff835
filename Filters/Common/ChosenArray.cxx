// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ChosenArray.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkInformation.h"

namespace SurfaceDenoising
{

ArrayChoice ChosenArray(vtkAlgorithm* algorithm, vtkDataObject* input, int association)
{
  ArrayChoice choice;
  vtkInformation* chosen = algorithm->GetInputArrayInformation(0);
  vtkDataSetAttributes* arrays = input->GetAttributes(association);
  if (chosen->Has(vtkDataObject::FIELD_NAME()))
  {
    choice.Name = chosen->Get(vtkDataObject::FIELD_NAME());
    // "None" is how ParaView says that nothing was chosen.
    choice.Made = !choice.Name.empty() && choice.Name != "None";
    choice.Array = choice.Made ? arrays->GetArray(choice.Name.c_str()) : nullptr;
  }
  else if (chosen->Has(vtkDataObject::FIELD_ATTRIBUTE_TYPE()))
  {
    choice.Made = true;
    choice.Array = arrays->GetAttribute(chosen->Get(vtkDataObject::FIELD_ATTRIBUTE_TYPE()));
  }
  if (chosen->Get(vtkDataObject::FIELD_ASSOCIATION()) != association)
  {
    choice.Array = nullptr;
  }
  return choice;
}

}
