// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "DenoisingReport.h"

#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"

namespace SurfaceDenoising
{

void DenoisingReport::WriteTo(vtkDataSet* output) const
{
  vtkNew<vtkDoubleArray> array;
  array->SetName("DenoisingReport");
  array->SetNumberOfComponents(static_cast<int>(this->Figures.size()));
  array->SetNumberOfTuples(1);
  for (std::size_t i = 0; i < this->Figures.size(); ++i)
  {
    array->SetComponentName(static_cast<vtkIdType>(i), this->Figures[i].first.c_str());
    array->SetValue(static_cast<vtkIdType>(i), this->Figures[i].second);
  }
  output->GetFieldData()->AddArray(array);
}

}
