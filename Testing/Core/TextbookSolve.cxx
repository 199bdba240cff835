// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// All normals at once, from a full matrix.

#include "TextbookInternals.h"
#include "TextbookVectors.h"

#include <cmath>

namespace Textbook
{

std::vector<Vector> Solve(std::vector<std::vector<double>> matrix, std::vector<Vector> right)
{
  const std::size_t n = right.size();
  for (std::size_t k = 0; k < n; ++k)
  {
    std::size_t pivot = k;
    for (std::size_t row = k + 1; row < n; ++row)
    {
      pivot = std::abs(matrix[row][k]) > std::abs(matrix[pivot][k]) ? row : pivot;
    }
    std::swap(matrix[k], matrix[pivot]);
    std::swap(right[k], right[pivot]);
    for (std::size_t row = k + 1; row < n; ++row)
    {
      const double factor = matrix[row][k] / matrix[k][k];
      if (factor != 0.0)
      {
        for (std::size_t column = k; column < n; ++column)
        {
          matrix[row][column] -= factor * matrix[k][column];
        }
        right[row] = right[row] - factor * right[k];
      }
    }
  }
  for (std::size_t k = n; k-- > 0;)
  {
    for (std::size_t column = k + 1; column < n; ++column)
    {
      right[k] = right[k] - matrix[k][column] * right[column];
    }
    right[k] = (1.0 / matrix[k][k]) * right[k];
  }
  return right;
}

namespace
{

/// Weights of the neighbours that sum up to 1, or none.
std::map<int, double> Row(const Surroundings& here, const Settings& settings, const Fields& fields,
  int i, Margins& margins)
{
  std::map<int, double> weights;
  double total = 0.0;
  for (const int j : here.Averaged[i])
  {
    if (here.Areas[j] > 0.0)
    {
      const PairWeight weight = WeightOf(here, settings, fields, i, j, margins);
      weights[j] = weight.Fixed * weight.Range;
      total += weights[j];
    }
  }
  if (!(total > 1e-140))
  {
    return {};
  }
  for (auto& weight : weights)
  {
    weight.second /= total;
  }
  return weights;
}

/// What a face adds to the energies; degenerate faces nothing.
std::vector<double> EnergyFactors(const std::vector<double>& areas, bool byArea)
{
  double sum = 0.0;
  double count = 0.0;
  for (const double area : areas)
  {
    sum += area;
    count += area > 0.0 ? 1.0 : 0.0;
  }
  std::vector<double> factors;
  for (const double area : areas)
  {
    factors.push_back(area == 0.0 ? 0.0 : (byArea ? area * count / sum : 1.0));
  }
  return factors;
}

}

/// Minimises (1 - fidelity) |N - W N|^2 + fidelity |N - n|^2, both sums over the faces weighted.
std::vector<Vector> SolveGlobally(const Surroundings& here, const Settings& settings,
  const Fields& fields, Margins& margins)
{
  const int n = int(fields.Current.size());
  const std::vector<double> factors = EnergyFactors(here.Areas, settings.AreaEnergy);
  std::vector<std::map<int, double>> weights;
  std::vector<std::vector<double>> matrix(n, std::vector<double>(n, 0.0));
  std::vector<Vector> right;
  for (int i = 0; i < n; ++i)
  {
    weights.push_back(Row(here, settings, fields, i, margins));
    std::map<int, double> difference = { { i, 1.0 } }; // row of 1 - W
    for (const auto& weight : weights[i])
    {
      difference[weight.first] -= weight.second;
    }
    for (const auto& a : difference)
    {
      for (const auto& b : difference)
      {
        matrix[a.first][b.first] += (1.0 - settings.Fidelity) * factors[i] * a.second * b.second;
      }
    }
    matrix[i][i] += settings.Fidelity * factors[i];
    right.push_back(settings.Fidelity * factors[i] * fields.Averaged[i]);
    if (factors[i] == 0.0)
    {
      matrix[i][i] = 1.0; // no face looks at it
    }
  }

  const std::vector<Vector> solution = Solve(matrix, right);
  std::vector<Vector> filtered = fields.Current;
  for (int i = 0; i < n; ++i)
  {
    Vector normal = solution[i];
    if (factors[i] == 0.0)
    {
      normal = { 0.0, 0.0, 0.0 };
      for (const auto& weight : weights[i])
      {
        normal = normal + weight.second * solution[weight.first];
      }
    }
    if (Length(normal) > 1e-12)
    {
      filtered[i] = Unit(normal);
    }
  }
  return filtered;
}

}
