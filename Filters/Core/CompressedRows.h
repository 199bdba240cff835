// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file CompressedRows.h
 * @brief Lists of indices, one per element, in two flat arrays.
 */

#ifndef SurfaceDenoising_CompressedRows_h
#define SurfaceDenoising_CompressedRows_h

#include "Execution.h"
#include "Types.h"

namespace SurfaceDenoising
{

/// Row i is Ids[Offsets[i]] .. Ids[Offsets[i + 1] - 1].
class CompressedRows
{
public:
  Buffer<std::uint64_t> Offsets;
  Buffer<Index> Ids;

  std::size_t NumberOfRows() const { return this->Offsets.empty() ? 0 : this->Offsets.size() - 1; }
  std::size_t NumberOfIds() const { return this->Ids.size(); }

  Span<Index> Row(std::size_t i) const
  {
    return { this->Ids.data() + this->Offsets[i], this->Ids.data() + this->Offsets[i + 1] };
  }
};

/// Row j of the result lists the rows that have j, in ascending order; it has as many rows as
/// given.
inline CompressedRows Transpose(const CompressedRows& rows, std::size_t count)
{
  CompressedRows transposed;
  transposed.Offsets.assign(count + 1, 0);
  std::uint64_t* offsets = transposed.Offsets.data();
  for (const Index j : rows.Ids)
  {
    ++offsets[j + 1];
  }
  for (std::size_t j = 0; j < count; ++j)
  {
    offsets[j + 1] += offsets[j];
  }
  transposed.Ids.resize(rows.NumberOfIds());
  // Filling moves every offset to the start of the next row; the shift afterwards moves it back.
  Index* ids = transposed.Ids.data();
  for (std::size_t i = 0; i < rows.NumberOfRows(); ++i)
  {
    for (const Index j : rows.Row(i))
    {
      ids[offsets[j]++] = static_cast<Index>(i);
    }
  }
  for (std::size_t j = count; j > 0; --j)
  {
    offsets[j] = offsets[j - 1];
  }
  offsets[0] = 0;
  return transposed;
}

/**
 * Builds rows in parallel. makeAppend() is called once for every stretch of rows that a thread
 * takes and returns a function for it, which may own memory to work in: append(i, ids) adds the
 * entries of row i at the end of ids and must not look at what is there already. Every chunk of
 * rows, the least that a thread takes, is collected on its own and then copied to its place, so
 * that each row is computed once although its length is not known beforehand.
 */
template <typename MakeAppend>
CompressedRows BuildRowsWith(Execution& execution, std::size_t count, MakeAppend makeAppend,
  std::size_t chunk = 4096)
{
  const std::size_t chunks = (count + chunk - 1) / chunk;
  std::vector<Buffer<Index>> parts(chunks);
  CompressedRows rows;
  rows.Offsets.resize(count + 1);
  rows.Offsets[0] = 0;
  execution.For(
    chunks,
    [&](std::size_t begin, std::size_t end)
    {
      auto append = makeAppend();
      Buffer<Index> ids;
      for (std::size_t c = begin; c < end; ++c)
      {
        ids.clear();
        const std::size_t last = std::min(count, (c + 1) * chunk);
        for (std::size_t i = c * chunk; i < last; ++i)
        {
          append(i, ids);
          rows.Offsets[i + 1] = ids.size();
        }
        parts[c].assign(ids.begin(), ids.end());
      }
    },
    1);

  std::vector<std::uint64_t> starts(chunks + 1, 0);
  for (std::size_t c = 0; c < chunks; ++c)
  {
    starts[c + 1] = starts[c] + parts[c].size();
  }
  rows.Ids.resize(starts[chunks]);
  execution.For(
    chunks,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t c = begin; c < end; ++c)
      {
        std::copy(parts[c].begin(), parts[c].end(), rows.Ids.begin() + starts[c]);
        Release(parts[c]);
        const std::size_t last = std::min(count, (c + 1) * chunk);
        for (std::size_t i = c * chunk; i < last; ++i)
        {
          rows.Offsets[i + 1] += starts[c];
        }
      }
    },
    1);
  return rows;
}

/// The same with one function for all rows, which needs no memory of its own.
template <typename Append>
CompressedRows BuildRows(Execution& execution, std::size_t count, const Append& append,
  std::size_t chunk = 4096)
{
  return BuildRowsWith(
    execution, count,
    [&append] { return [&append](std::size_t i, Buffer<Index>& ids) { append(i, ids); }; }, chunk);
}

}

#endif
