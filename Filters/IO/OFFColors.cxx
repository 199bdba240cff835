// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "OFFColors.h"

#include "vtkIntArray.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
void OFFColors::Append(const OFFColor& color)
{
  this->Uniform &= this->Size == 0 || color.Size == this->Components;
  this->Components = color.Size;
  ++this->Size;
  if (this->Uniform && color.Size > 0)
  {
    const auto end = color.Components.begin() + std::min(color.Size, color.Components.size());
    this->Values.insert(this->Values.end(), color.Components.begin(), end);
    this->Fractional |= color.Fractional;
  }
}

//------------------------------------------------------------------------------
void OFFColors::Append(const OFFColors& others)
{
  if (others.Size == 0)
  {
    return;
  }
  this->Uniform &= others.Uniform && (this->Size == 0 || others.Components == this->Components);
  this->Components = others.Components;
  this->Size += others.Size;
  this->Values.insert(this->Values.end(), others.Values.begin(), others.Values.end());
  this->Fractional |= others.Fractional;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataArray> OFFColors::MakeArray() const
{
  const bool isColor = this->Components == 3 || this->Components == 4;
  if (!this->Uniform || !(isColor || this->Components == 1))
  {
    return nullptr;
  }
  vtkSmartPointer<vtkDataArray> array;
  array.TakeReference(isColor ? static_cast<vtkDataArray*>(vtkUnsignedCharArray::New())
                              : static_cast<vtkDataArray*>(vtkIntArray::New()));
  array->SetName("Colors");
  array->SetNumberOfComponents(static_cast<int>(this->Components));
  array->SetNumberOfTuples(this->Size);

  // Decimal points alone do not tell: some programs write 255.0.
  const double largest = *std::max_element(this->Values.begin(), this->Values.end());
  const double scale = isColor && this->Fractional && largest <= 1.0 ? 255.0 : 1.0;
  const double most = isColor ? 255.0 : static_cast<double>(VTK_INT_MAX);
  for (std::size_t i = 0; i < this->Values.size(); ++i)
  {
    const auto tuple = static_cast<vtkIdType>(i / this->Components);
    const auto component = static_cast<int>(i % this->Components);
    const double value = std::clamp(std::round(this->Values[i] * scale), 0.0, most);
    array->SetComponent(tuple, component, value);
  }
  return array;
}
