// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file AutomaticSettings.h
 * @brief What can be said to denoising that needs no settings.
 */

#ifndef SurfaceDenoising_AutomaticSettings_h
#define SurfaceDenoising_AutomaticSettings_h

namespace SurfaceDenoising
{

/// What a surface is like, and which one a method is for.
enum class SurfaceType : int
{
  Any,
  Sharp, ///< flat sides and sharp edges
  Curved ///< curved, with detail but hardly an edge
};

struct AutomaticSettings
{
  /// Scales the noise that is assumed: 1 is what was found, 2 twice as much, which smooths more, 0
  /// none. Negative numbers and NaN count as 0, more than 10 as 10.
  double Strength = 1.0;

  /// Methods for other surfaces are not considered.
  SurfaceType Type = SurfaceType::Any;

  AutomaticSettings() = default;
  AutomaticSettings(double strength, SurfaceType type = SurfaceType::Any)
    : Strength(strength)
    , Type(type)
  {
  }

  double CheckedStrength() const
  {
    return this->Strength > 0.0 ? (this->Strength < 10.0 ? this->Strength : 10.0) : 0.0;
  }

  bool Considers(SurfaceType type) const
  {
    return this->Type == SurfaceType::Any || type == SurfaceType::Any || type == this->Type;
  }
};

}

#endif
