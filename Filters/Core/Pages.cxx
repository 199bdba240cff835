// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Types.h"

#if defined(__linux__)
#include <cstdlib>
#include <new>
#include <sys/mman.h>
#endif

namespace SurfaceDenoising
{

#if defined(__linux__)

namespace
{

constexpr std::size_t HugePage = std::size_t(1) << 21;

/// Arrays of so many bytes do not waste much of their last page.
constexpr std::size_t Long = 4 * HugePage;

bool IsLong(std::size_t count, std::size_t size) { return count >= Long / size; }

}

void* AllocatePages(std::size_t count, std::size_t size)
{
  if (!IsLong(count, size))
  {
    return nullptr;
  }
  if (count > (~std::size_t(0) - HugePage) / size)
  {
    throw std::bad_alloc();
  }
  const std::size_t bytes = (count * size + HugePage - 1) / HugePage * HugePage;
  void* memory = std::aligned_alloc(HugePage, bytes);
  if (!memory)
  {
    throw std::bad_alloc();
  }
  madvise(memory, bytes, MADV_HUGEPAGE); // only a wish
  return memory;
}

bool ReleasePages(void* memory, std::size_t count, std::size_t size)
{
  if (!IsLong(count, size))
  {
    return false;
  }
  std::free(memory);
  return true;
}

#else

void* AllocatePages(std::size_t, std::size_t) { return nullptr; }
bool ReleasePages(void*, std::size_t, std::size_t) { return false; }

#endif

}
