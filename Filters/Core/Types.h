// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file Types.h
 * @brief The vocabulary of the numeric core.
 *
 * All arithmetic is in double, whatever the precision of the input. Indices are 32-bit: four
 * billion elements would need a terabyte of working memory, so the narrower type is no limit in
 * practice and halves the traffic of the neighbour lists. Offsets into such lists are 64-bit.
 */

#ifndef SurfaceDenoising_Types_h
#define SurfaceDenoising_Types_h

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace SurfaceDenoising
{

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

/// Number of a vertex, a face or a point.
using Index = std::uint32_t;

/// "There is none" where an Index is expected.
constexpr Index NoIndex = ~Index(0);

/// Vertices of a face, counter-clockwise seen from outside.
using Triangle = std::array<Index, 3>;

/// Memory in huge pages for a long array; null if it is short or the system has none.
void* AllocatePages(std::size_t count, std::size_t size);

/// Returns false if AllocatePages gave null for as many.
bool ReleasePages(void* memory, std::size_t count, std::size_t size);

/**
 * std::allocator that leaves plain numbers uninitialised when a vector grows. The first write then
 * happens in the parallel loop that fills the array, not in a serial pass that writes zeros. Long
 * arrays get huge pages where there are such: a fault per small page is a tenth of the work.
 */
template <typename T>
struct UninitializedAllocator : std::allocator<T>
{
  T* allocate(std::size_t count)
  {
    if (void* pages = AllocatePages(count, sizeof(T)))
    {
      return static_cast<T*>(pages);
    }
    return std::allocator<T>::allocate(count);
  }

  void deallocate(T* memory, std::size_t count)
  {
    if (!ReleasePages(memory, count, sizeof(T)))
    {
      std::allocator<T>::deallocate(memory, count);
    }
  }

  template <typename U>
  struct rebind
  {
    using other = UninitializedAllocator<U>;
  };

  UninitializedAllocator() = default;
  template <typename U>
  UninitializedAllocator(const UninitializedAllocator<U>&)
  {
  }

  template <typename U>
  void construct(U* p)
  {
    ::new (static_cast<void*>(p)) U;
  }
  template <typename U, typename... Args>
  void construct(U* p, Args&&... args)
  {
    ::new (static_cast<void*>(p)) U(std::forward<Args>(args)...);
  }
};

/// A vector whose new elements have no defined value until they are written.
template <typename T>
using Buffer = std::vector<T, UninitializedAllocator<T>>;

/// Gives the memory of a buffer back, not only its length.
template <typename T>
void Release(Buffer<T>& buffer)
{
  Buffer<T>().swap(buffer);
}

/// A read-only stretch of an array.
template <typename T>
struct Span
{
  const T* First = nullptr;
  const T* Last = nullptr;

  const T* begin() const { return this->First; }
  const T* end() const { return this->Last; }
  std::size_t size() const { return static_cast<std::size_t>(this->Last - this->First); }
  const T& operator[](std::size_t i) const { return this->First[i]; }
};

}

#endif
