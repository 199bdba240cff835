// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// The normal voting tensor with binary eigenvalues.

#include "TextbookInternals.h"
#include "TextbookVectors.h"

#include <algorithm>
#include <cmath>

namespace Textbook
{

namespace
{

using Matrix = std::array<Vector, 3>;

struct Eigen
{
  Vector Values; // largest first
  std::array<Vector, 3> Vectors;
};

/// Jacobi's method: turns in the coordinate planes until nothing is left beside the diagonal.
Eigen Decompose(Matrix m)
{
  Matrix v = { Vector{ 1.0, 0.0, 0.0 }, Vector{ 0.0, 1.0, 0.0 }, Vector{ 0.0, 0.0, 1.0 } };
  for (int sweep = 0; sweep < 50; ++sweep)
  {
    for (int p = 0; p < 2; ++p)
    {
      for (int q = p + 1; q < 3; ++q)
      {
        if (m[p][q] == 0.0)
        {
          continue;
        }
        const double angle = 0.5 * std::atan(2.0 * m[p][q] / (m[q][q] - m[p][p]));
        const double c = std::cos(angle);
        const double s = std::sin(angle);
        for (int k = 0; k < 3; ++k) // columns, of the eigenvectors too
        {
          const double a = m[k][p];
          const double b = m[k][q];
          m[k][p] = c * a - s * b;
          m[k][q] = s * a + c * b;
          const double d = v[k][p];
          const double e = v[k][q];
          v[k][p] = c * d - s * e;
          v[k][q] = s * d + c * e;
        }
        for (int k = 0; k < 3; ++k) // rows
        {
          const double a = m[p][k];
          const double b = m[q][k];
          m[p][k] = c * a - s * b;
          m[q][k] = s * a + c * b;
        }
        m[p][q] = 0.0;
        m[q][p] = 0.0;
      }
    }
  }
  std::array<int, 3> order = { 0, 1, 2 };
  std::sort(order.begin(), order.end(), [&m](int a, int b) { return m[a][a] > m[b][b]; });
  Eigen eigen;
  for (int k = 0; k < 3; ++k)
  {
    eigen.Values[k] = m[order[k]][order[k]];
    eigen.Vectors[k] = { v[0][order[k]], v[1][order[k]], v[2][order[k]] };
  }
  return eigen;
}

/// The normal a circular arc has at centroid i if it has the given one at j.
Vector Rotated(const Vector& n, const Vector& fromCentre)
{
  const Vector u = Unit(Cross(Cross(fromCentre, n), fromCentre));
  return 2.0 * Dot(n, u) * u - n;
}

/// How many of the eigenvectors count, largest eigenvalues first.
int KeptAxes(const Vector& values, double threshold, double& margin)
{
  for (int k = 1; k < 3; ++k)
  {
    const double lead = std::abs(values[k] - threshold);
    margin = std::min(margin, threshold > 0.0 ? lead / threshold : lead);
  }
  return values[2] >= threshold ? 3 : (values[1] >= threshold ? 2 : 1);
}

Vector Vote(const Eigen& eigen, int axes, double damping, const Vector& own)
{
  Vector sum = damping * own;
  for (int k = 0; k < axes; ++k)
  {
    sum = sum + Dot(eigen.Vectors[k], own) * eigen.Vectors[k];
  }
  return Length(sum) > 1e-12 ? Unit(sum) : own;
}

}

std::vector<Vector> VoteByTensor(const Surroundings& here, const Settings& settings,
  const Fields& fields, Margins& margins)
{
  std::vector<Vector> filtered = fields.Current;
  for (int i = 0; i < int(filtered.size()); ++i)
  {
    Matrix tensor = {};
    Vector sum = { 0.0, 0.0, 0.0 };
    double total = 0.0;
    for (const int j : here.Averaged[i])
    {
      if (here.Areas[j] == 0.0)
      {
        continue;
      }
      const PairWeight weight = WeightOf(here, settings, fields, i, j, margins);
      const double w = weight.Fixed * weight.Range;
      const Vector way = here.Centroids[j] - here.Centroids[i];
      const Vector vote = settings.RotateVotes && Length(way) > here.ShortestDistance
        ? Rotated(fields.Averaged[j], way)
        : fields.Averaged[j];
      for (int k = 0; k < 3; ++k)
      {
        tensor[k] = tensor[k] + w * vote[k] * vote;
      }
      sum = sum + w * fields.Averaged[j];
      total += w;
    }
    if (!(total > 1e-140))
    {
      continue;
    }
    for (Vector& row : tensor)
    {
      row = (1.0 / total) * row;
    }
    const Eigen eigen = Decompose(tensor);
    const Vector values = Unit(eigen.Values);
    const Vector own = fields.Current[i];
    if (Length(own) > 0.0)
    {
      const int axes = KeptAxes(values, settings.TensorThreshold, margins[i]);
      if (axes < 3) // equal eigenvalues have no axes
      {
        margins[i] = std::min(margins[i], (values[axes - 1] - values[axes]) / values[axes - 1]);
      }
      filtered[i] = Vote(eigen, axes, settings.Damping, own);
    }
    else
    {
      // Without a normal to project there is the mean.
      filtered[i] = Length(sum) > 1e-12 * total ? Unit(sum) : own;
    }
  }
  return filtered;
}

}
