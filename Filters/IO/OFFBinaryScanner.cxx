// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "OFFBinaryScanner.h"

#include "FileContent.h"

#include <cmath>
#include <cstdint>
#include <cstring>

using namespace SurfaceDenoising;

//------------------------------------------------------------------------------
void OFFBinaryScanner::Fail(const std::string& what) const
{
  throw FileError("byte " + std::to_string(this->Position) + ": " + what);
}

//------------------------------------------------------------------------------
template <typename T>
T OFFBinaryScanner::ReadBigEndian(const char* what)
{
  static_assert(sizeof(T) == 4, "OFF stores 32-bit numbers");
  if (this->RemainingBytes() < sizeof(T))
  {
    throw FileError("byte " + std::to_string(this->Position) + ": the file ends where " + what +
        " should stand",
      vtkErrorCode::PrematureEndOfFileError);
  }
  std::uint32_t bits = 0;
  for (int i = 0; i < 4; ++i)
  {
    bits = bits << 8 | static_cast<unsigned char>(this->Bytes[this->Position++]);
  }
  T value;
  std::memcpy(&value, &bits, sizeof(T));
  return value;
}

//------------------------------------------------------------------------------
vtkIdType OFFBinaryScanner::ReadInteger(const char* what)
{
  return this->ReadBigEndian<std::int32_t>(what);
}

//------------------------------------------------------------------------------
double OFFBinaryScanner::ReadReal(const char* what)
{
  const float value = this->ReadBigEndian<float>(what);
  if (!std::isfinite(value))
  {
    this->Fail(std::string(what) + " is not a finite number");
  }
  return value;
}

//------------------------------------------------------------------------------
OFFColor OFFBinaryScanner::ReadColor(std::size_t numberOfComponents)
{
  OFFColor color;
  color.Fractional = true;
  for (; color.Size < numberOfComponents; ++color.Size)
  {
    const double component = this->ReadReal("a color component");
    if (color.Size < color.Components.size())
    {
      color.Components[color.Size] = component;
    }
  }
  return color;
}

//------------------------------------------------------------------------------
OFFColor OFFBinaryScanner::ReadVertexColor(bool) { return this->ReadColor(4); }

//------------------------------------------------------------------------------
OFFColor OFFBinaryScanner::ReadFaceColor()
{
  const vtkIdType components = this->ReadInteger("the number of color components");
  if (components < 0)
  {
    this->Fail("a face has " + std::to_string(components) + " color components");
  }
  return this->ReadColor(static_cast<std::size_t>(components));
}
