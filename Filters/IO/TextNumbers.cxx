// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TextNumbers.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <locale>
#include <sstream>

namespace SurfaceDenoising
{

//------------------------------------------------------------------------------
bool ToReal(std::string_view token, double& value)
{
  if (token.size() > 1 && token[0] == '+' && token[1] != '-')
  {
    token.remove_prefix(1); // valid, but unknown to from_chars
  }
#ifdef __cpp_lib_to_chars
  const char* const end = token.data() + token.size();
  const std::from_chars_result result = std::from_chars(token.data(), end, value);
  if (result.ec == std::errc::result_out_of_range)
  {
    value = 0.0; // fine for a number too small for a double, not for one too large
    return result.ptr == end && token.find_first_of("eE") == token.find('-', 1) - 1;
  }
  return result.ec == std::errc() && result.ptr == end;
#else
  const bool negative = !token.empty() && token[0] == '-';
  std::string letters(token.substr(negative ? 1 : 0)); // streams know neither infinity nor NaN
  std::transform(letters.begin(), letters.end(), letters.begin(),
    [](char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  if (letters == "nan" || letters == "inf" || letters == "infinity")
  {
    using Limits = std::numeric_limits<double>;
    value = letters == "nan" ? Limits::quiet_NaN() : Limits::infinity();
    value = negative ? -value : value;
    return true;
  }
  std::istringstream stream{ std::string(token) };
  stream.imbue(std::locale::classic());
  return (stream >> value) && stream.eof();
#endif
}

//------------------------------------------------------------------------------
bool ToInteger(std::string_view token, vtkIdType& value)
{
  const char* const end = token.data() + token.size();
  const std::from_chars_result result = std::from_chars(token.data(), end, value);
  return result.ec == std::errc() && result.ptr == end;
}

//------------------------------------------------------------------------------
std::string Quote(std::string_view token)
{
  const std::size_t longest = 32; // a binary file opened as text may have no spaces at all
  std::string text(token.substr(0, longest));
  std::replace_if(
    text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c == 127; }, '?');
  return "'" + text + (token.size() > longest ? "...'" : "'");
}

}
