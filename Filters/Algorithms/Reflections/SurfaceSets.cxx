// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceSets.h"

#include <numeric>
#include <utility>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
SurfaceSets::SurfaceSets(const ReflectionPicks& picks)
  : Picks(picks)
  , Labels(picks.Picks.size())
  , Sizes(picks.Picks.size(), 1)
  , ColumnNumbers(picks.ListColumns())
{
  std::iota(this->Labels.begin(), this->Labels.end(), 0);
  this->Ring = this->Labels;
}

//----------------------------------------------------------------------------------------------------------------------
std::int64_t SurfaceSets::CountShared(PointId set, PointId other, std::int64_t most) const
{
  std::int64_t shared = 0;
  this->ForEachMember(set,
    [&](PointId pick)
    {
      shared += this->HasColumn(other, this->ColumnOf(pick)) ? 1 : 0;
      return shared <= most;
    });
  return shared;
}

//----------------------------------------------------------------------------------------------------------------------
void SurfaceSets::Absorb(PointId big, PointId small, bool areShared)
{
  PointId pick = small;
  do
  {
    const PointId next = this->Ring[std::size_t(pick)];
    // Picks that came before it lie in other columns.
    if (areShared && this->HasColumn(big, this->ColumnOf(pick)))
    {
      this->Labels[std::size_t(pick)] = NoPoint;
    }
    else
    {
      this->Labels[std::size_t(pick)] = big;
      this->Ring[std::size_t(pick)] = std::exchange(this->Ring[std::size_t(big)], pick);
      ++this->Sizes[std::size_t(big)];
    }
    pick = next;
  } while (pick != small);
}
}
