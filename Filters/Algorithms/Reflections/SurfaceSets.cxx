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
  , Members(picks.Picks.size())
  , Sizes(picks.Picks.size(), 1)
{
  std::iota(this->Labels.begin(), this->Labels.end(), 0);
  for (std::size_t column = 0; column + 1 < picks.Starts.size(); ++column)
  {
    for (PointId pick = picks.Starts[column]; pick < picks.Starts[column + 1]; ++pick)
    {
      this->Members[std::size_t(pick)] = { pick, std::int32_t(column) };
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
void SurfaceSets::SortMembers(const ColumnWindow& window)
{
  const auto forEachUpwards = [&](auto&& visit)
  {
    for (int j = window.EndJ; j-- > window.FirstJ;)
    {
      const PointId end = this->Picks.Begin(this->Picks.ColumnAt(window.EndI, j));
      for (PointId pick = end; pick-- > this->Picks.Begin(this->Picks.ColumnAt(window.FirstI, j));)
      {
        visit(pick, this->Labels[std::size_t(pick)]);
      }
    }
  };
  forEachUpwards(
    [this](PointId pick, PointId set)
    {
      if (set == pick)
      {
        this->Members[std::size_t(pick)].Next = pick;
      }
    });
  forEachUpwards(
    [this](PointId pick, PointId set)
    {
      if (set != pick && set != NoPoint)
      {
        this->Members[std::size_t(pick)].Next = std::exchange(this->Members[std::size_t(set)].Next, pick);
      }
    });
}

//----------------------------------------------------------------------------------------------------------------------
void SurfaceSets::Absorb(PointId big, PointId small, bool areShared)
{
  PointId pick = small;
  do
  {
    const PointId next = this->Members[std::size_t(pick)].Next;
    // Picks that came before it lie in other columns.
    if (areShared && this->HasColumn(big, this->ColumnOf(pick)))
    {
      this->Labels[std::size_t(pick)] = NoPoint;
    }
    else
    {
      this->Labels[std::size_t(pick)] = big;
      this->Members[std::size_t(pick)].Next = std::exchange(this->Members[std::size_t(big)].Next, pick);
      ++this->Sizes[std::size_t(big)];
    }
    pick = next;
  } while (pick != small);
}
}
