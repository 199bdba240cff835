// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file TextbookVectors.h
 * @brief Vector algebra on std::array, for the textbook.
 */

#ifndef TextbookVectors_h
#define TextbookVectors_h

#include "Textbook.h"

#include <cmath>

namespace Textbook
{

inline Vector operator+(const Vector& a, const Vector& b)
{
  return { a[0] + b[0], a[1] + b[1], a[2] + b[2] };
}

inline Vector operator-(const Vector& a, const Vector& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

inline Vector operator*(double s, const Vector& a) { return { s * a[0], s * a[1], s * a[2] }; }

inline double Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Vector Cross(const Vector& a, const Vector& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

inline double Length(const Vector& a) { return std::sqrt(Dot(a, a)); }

/// The vector itself if it is zero.
inline Vector Unit(const Vector& a) { return Length(a) > 0.0 ? (1.0 / Length(a)) * a : a; }

inline double AngleBetween(const Vector& a, const Vector& b)
{
  return std::atan2(Length(Cross(a, b)), Dot(a, b));
}

inline Vector AreaVector(const Mesh& mesh, const Face& face)
{
  const Vector& a = mesh.Points[face[0]];
  return 0.5 * Cross(mesh.Points[face[1]] - a, mesh.Points[face[2]] - a);
}

inline Vector Centroid(const Mesh& mesh, const Face& face)
{
  return (1.0 / 3.0) * (mesh.Points[face[0]] + mesh.Points[face[1]] + mesh.Points[face[2]]);
}

}

#endif
