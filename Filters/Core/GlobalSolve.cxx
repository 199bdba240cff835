// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GlobalSolve.h"

#include "ConjugateGradient.h"

#include <atomic>

namespace SurfaceDenoising
{

namespace
{

/// A sparse matrix: the rows of a graph, and a value for each entry.
struct SparseMatrix
{
  CompressedRows Rows;
  Buffer<double> Values;

  Vec3 RowTimes(std::size_t i, const Buffer<Vec3>& x) const
  {
    Vec3 sum(0.0, 0.0, 0.0);
    for (std::uint64_t p = this->Rows.Offsets[i]; p < this->Rows.Offsets[i + 1]; ++p)
    {
      sum += this->Values[p] * x[this->Rows.Ids[p]];
    }
    return sum;
  }
};

/// W: the weights of every row, the site itself first if it is included, with sum 1; or 0 where
/// there is no weight.
SparseMatrix NormalizedWeights(const NormalFilter& filter, const NormalFilter::Fields& fields,
  Execution& execution)
{
  const NeighborGraph& graph = filter.Neighbors();
  const bool own = filter.IncludesOwn();
  SparseMatrix matrix;
  matrix.Rows = BuildRows(execution, graph.NumberOfRows(),
    [&](std::size_t i, Buffer<Index>& row)
    {
      if (own)
      {
        row.push_back(static_cast<Index>(i));
      }
      row.insert(row.end(), graph.Row(i).begin(), graph.Row(i).end());
    });
  matrix.Values.resize(matrix.Rows.NumberOfIds());
  filter.VisitWeights(fields, execution,
    [&](std::size_t i, const double* weights)
    {
      const std::uint64_t first = matrix.Rows.Offsets[i];
      const std::uint64_t count = matrix.Rows.Offsets[i + 1] - first;
      double total = 0.0;
      for (std::uint64_t p = 0; p < count; ++p)
      {
        total += weights[p];
      }
      for (std::uint64_t p = 0; p < count; ++p)
      {
        matrix.Values[first + p] = total > NormalFilter::NoWeight ? weights[p] / total : 0.0;
      }
    });
  return matrix;
}

SparseMatrix Transpose(const SparseMatrix& matrix)
{
  const std::size_t rows = matrix.Rows.NumberOfRows();
  SparseMatrix transpose;
  Buffer<std::uint64_t>& offsets = transpose.Rows.Offsets;
  offsets.assign(rows + 1, 0);
  for (const Index j : matrix.Rows.Ids)
  {
    ++offsets[j + 1];
  }
  for (std::size_t j = 0; j < rows; ++j)
  {
    offsets[j + 1] += offsets[j];
  }
  transpose.Rows.Ids.resize(matrix.Rows.NumberOfIds());
  transpose.Values.resize(matrix.Rows.NumberOfIds());
  Buffer<std::uint64_t> next(offsets.begin(), offsets.end() - 1);
  for (std::size_t i = 0; i < rows; ++i)
  {
    for (std::uint64_t p = matrix.Rows.Offsets[i]; p < matrix.Rows.Offsets[i + 1]; ++p)
    {
      const std::uint64_t q = next[matrix.Rows.Ids[p]]++;
      transpose.Rows.Ids[q] = static_cast<Index>(i);
      transpose.Values[q] = matrix.Values[p];
    }
  }
  return transpose;
}

/// D, without the sites that have no area.
Buffer<double> Energies(const Buffer<double>& areas, bool areaEnergy, Execution& execution)
{
  const double total =
    OrderedSum(execution, areas.size(), 0.0, [&areas](std::size_t i) { return areas[i]; });
  const auto counted = static_cast<double>(areas.size()) -
    static_cast<double>(std::count(areas.begin(), areas.end(), 0.0));
  Buffer<double> energies(areas.size());
  for (std::size_t i = 0; i < areas.size(); ++i)
  {
    energies[i] = areas[i] > 0.0 ? (areaEnergy ? areas[i] * counted / total : 1.0) : 0.0;
  }
  return energies;
}

}

bool SolveForNormals(const NormalFilter& filter, const NormalFilter::Fields& fields,
  const Buffer<double>& areas, const GlobalSolveSettings& settings, Buffer<Vec3>& filtered,
  std::size_t& kept, std::size_t& iterations, Execution& execution, double first, double last)
{
  const std::size_t sites = filter.Neighbors().NumberOfRows();
  const double lambda = settings.Fidelity;
  const SparseMatrix weights = NormalizedWeights(filter, fields, execution);
  const SparseMatrix transposed = Transpose(weights);
  const Buffer<double> energies = Energies(areas, settings.AreaEnergy, execution);
  auto forSites = [&](auto use)
  {
    execution.For(sites,
      [&use](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          use(i);
        }
      });
  };

  Buffer<Vec3> differences(sites); // (1 - lambda) D L x
  auto apply = [&](const Buffer<Vec3>& x, Buffer<Vec3>& product)
  {
    forSites([&](std::size_t i)
      { differences[i] = (1.0 - lambda) * energies[i] * (x[i] - weights.RowTimes(i, x)); });
    forSites(
      [&](std::size_t i)
      {
        product[i] =
          differences[i] - transposed.RowTimes(i, differences) + lambda * energies[i] * x[i];
      });
  };

  Buffer<double> diagonal(sites);
  Buffer<Vec3> target(sites);
  forSites(
    [&](std::size_t i)
    {
      // Column i of L has 1 - w_ii, and -w_ki elsewhere.
      double sum = lambda * energies[i] + (1.0 - lambda) * energies[i];
      for (std::uint64_t p = transposed.Rows.Offsets[i]; p < transposed.Rows.Offsets[i + 1]; ++p)
      {
        const Index k = transposed.Rows.Ids[p];
        const double w = transposed.Values[p];
        sum += (1.0 - lambda) * energies[k] * (k == i ? w * (w - 2.0) : w * w);
      }
      diagonal[i] = energies[i] > 0.0 ? sum : 0.0;
      target[i] = lambda * energies[i] * fields.Data[i];
    });

  Buffer<Vec3> solution = fields.Data;
  const ConjugateGradientResult result = SolveConjugateGradient(apply, diagonal, target, solution,
    settings.Tolerance, settings.MaximumIterations, execution, first, last);
  iterations += static_cast<std::size_t>(result.Iterations);
  if (result.Stopped)
  {
    return false;
  }

  filtered.resize(sites);
  std::atomic<std::size_t> keptSites{ 0 };
  forSites(
    [&](std::size_t i)
    {
      const Vec3 n = energies[i] > 0.0 ? solution[i] : weights.RowTimes(i, solution);
      const double length = n.norm();
      filtered[i] = length > 1e-12 ? Vec3(n / length) : fields.Current[i];
      keptSites += !(length > 1e-12);
    });
  kept = keptSites;
  return true;
}

}
