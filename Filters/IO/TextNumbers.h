// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TextNumbers_h
#define TextNumbers_h

#include "vtkType.h"

#include <string>
#include <string_view>

namespace SurfaceDenoising
{

/// Numbers must not depend on the locale of the program, as those of strtod do. False if the token
/// is not a number from its first to its last character, or one too large for a double.
bool ToReal(std::string_view token, double& value);
bool ToInteger(std::string_view token, vtkIdType& value);

/// The token for an error message: short, and without what a terminal or a log cannot show.
std::string Quote(std::string_view token);

}

#endif
