// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Boxes that are still to be searched, on a stack.

#ifndef SeismicHorizonsSearchStack_h
#define SeismicHorizonsSearchStack_h

namespace SeismicHorizons
{
/// Sorts boxes so that the nearest is last. There are four at most, for which this takes less time than std::sort.
template <typename Waiting>
void SortByDistance(Waiting* first, Waiting* last)
{
  for (Waiting* next = first + 1; next < last; ++next)
  {
    const Waiting moved = *next;
    Waiting* place = next;
    for (; place > first && (place - 1)->SquaredDistance < moved.SquaredDistance; --place)
    {
      *place = *(place - 1);
    }
    *place = moved;
  }
}
}

#endif
