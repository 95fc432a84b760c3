// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceSets.h"

#include <utility>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
SurfaceSets::SurfaceSets(const ReflectionPicks& picks)
  : Picks(picks)
  , Labels(picks.Places.size(), NoPoint - 1)
  , Members(picks.Places.size())
{
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
        visit(pick, this->SetOf(pick));
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
  PointId size = this->SizeOf(big);
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
      ++size;
    }
    pick = next;
  } while (pick != small);
  this->Labels[std::size_t(big)] = NoPoint - size;
}

//----------------------------------------------------------------------------------------------------------------------
RawVector<PointId> SurfaceSets::TakeLabels()
{
  for (PointId pick = 0; pick < this->Picks.Size(); ++pick)
  {
    this->Labels[std::size_t(pick)] = this->SetOf(pick);
  }
  return std::move(this->Labels);
}
}
