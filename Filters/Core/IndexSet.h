// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file IndexSet.h
 * @brief "Was this one here already?", for growths that visit a few of very many elements.
 */

#ifndef SurfaceDenoising_IndexSet_h
#define SurfaceDenoising_IndexSet_h

#include "Types.h"

namespace SurfaceDenoising
{

/// A set of indices that is emptied without touching its memory.
class IndexSet
{
public:
  IndexSet() { this->Clear(); }

  void Clear();

  /// Returns true if the index was not there yet.
  bool Insert(Index index)
  {
    const std::size_t mask = this->Slots.size() - 1;
    std::size_t at = (index * std::size_t(0x9E3779B1u) >> 8) & mask;
    while (this->Slots[at].Round == this->Round)
    {
      if (this->Slots[at].Value == index)
      {
        return false;
      }
      at = (at + 1) & mask;
    }
    this->Slots[at] = { index, this->Round };
    if (2 * ++this->Count > this->Slots.size())
    {
      this->Grow();
    }
    return true;
  }

private:
  struct Slot
  {
    Index Value = 0;
    std::uint32_t Round = 0; ///< the slot is free unless this is the current round
  };

  void Grow();

  std::vector<Slot> Slots = std::vector<Slot>(256);
  std::size_t Count = 0;
  std::uint32_t Round = 0;
};

}

#endif
