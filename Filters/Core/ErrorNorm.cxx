// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ErrorNorm.h"

namespace SurfaceDenoising
{

namespace
{

template <std::size_t... I>
ErrorNorm MakeFromList(std::size_t id, double scale, std::index_sequence<I...>)
{
  ErrorNorm norm = L2Norm{ scale };
  ((I == id ? void(norm = std::variant_alternative_t<I, ErrorNorm>{ scale }) : void()), ...);
  return norm;
}

}

ErrorNorm MakeErrorNorm(NormId id, double scale)
{
  return MakeFromList(static_cast<std::size_t>(id), scale,
    std::make_index_sequence<std::variant_size_v<ErrorNorm>>());
}

const char* NameOf(const ErrorNorm& norm)
{
  return std::visit([](const auto& n) { return n.Name; }, norm);
}

NormProperties PropertiesOf(const ErrorNorm& norm)
{
  return std::visit([](const auto& n) { return n.Properties; }, norm);
}

double CutOff(const ErrorNorm& norm)
{
  return std::visit([](const auto& n) { return n.CutOff(); }, norm);
}

double Rho(const ErrorNorm& norm, double x)
{
  return std::visit([x](const auto& n) { return n.Rho(x); }, norm);
}

double Psi(const ErrorNorm& norm, double x)
{
  return std::visit([x](const auto& n) { return n.Psi(x); }, norm);
}

double Weight(const ErrorNorm& norm, double x)
{
  return std::visit([x](const auto& n) { return n.WeightOfSquare(x * x); }, norm);
}

}
