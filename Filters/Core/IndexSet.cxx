// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "IndexSet.h"

#include <algorithm>

namespace SurfaceDenoising
{

void IndexSet::Clear()
{
  this->Count = 0;
  if (++this->Round == 0)
  {
    std::fill(this->Slots.begin(), this->Slots.end(), Slot());
    this->Round = 1;
  }
}

void IndexSet::Grow()
{
  std::vector<Slot> old(4 * this->Slots.size());
  old.swap(this->Slots);
  const std::uint32_t round = this->Round;
  this->Count = 0;
  for (const Slot& slot : old)
  {
    if (slot.Round == round)
    {
      this->Insert(slot.Value);
    }
  }
}

}
