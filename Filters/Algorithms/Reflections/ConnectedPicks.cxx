// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Threads join the picks of bands of rows, whose numbers are their own; then one joins the bands along their seams. The
// least number of a set stands for it, in whatever order picks are joined.

#include "ConnectedPicks.h"

#include "Common/FixedChunks.h"

#include <numeric>

namespace SeismicHorizons
{
namespace
{
class Components
{
public:
  Components(const ReflectionPicks& picks, ColumnConnectivity connectivity, Depth largestStep)
    : Picks(picks)
    , Steps(int(connectivity) / 2)
    , LargestStep(largestStep)
    , Parents(picks.Places.size())
  {
    std::iota(this->Parents.begin(), this->Parents.end(), 0);
  }

  RawVector<PointId> Find(const Monitor& monitor)
  {
    constexpr std::int64_t band = 64; // rows
    ForEachChunk(this->Picks.Columns[1], band, monitor,
      [this](std::size_t, std::int64_t first, std::int64_t last)
      {
        for (std::int64_t j = first; j < last; ++j)
        {
          this->JoinRow(int(j), j + 1 < last);
        }
      });
    for (std::int64_t j = band; j < this->Picks.Columns[1]; j += band)
    {
      this->JoinToNextRow(int(j - 1));
    }
    // Parents come before their children.
    for (PointId& parent : this->Parents)
    {
      parent = this->Parents[std::size_t(parent)];
    }
    return std::move(this->Parents);
  }

private:
  /// Joins the columns of a row, and with the next row where they are asked to.
  void JoinRow(int j, bool withNext)
  {
    for (int i = 0; i + 1 < this->Picks.Columns[0]; ++i)
    {
      this->JoinColumns(this->Picks.ColumnAt(i, j), this->Picks.ColumnAt(i + 1, j));
    }
    if (withNext)
    {
      this->JoinToNextRow(j);
    }
  }

  void JoinToNextRow(int j)
  {
    for (int step = 1; step < this->Steps; ++step)
    {
      const int offset = NeighbourSteps[std::size_t(step)].I;
      for (int i = std::max(0, -offset); i < this->Picks.Columns[0] - std::max(0, offset); ++i)
      {
        this->JoinColumns(this->Picks.ColumnAt(i, j), this->Picks.ColumnAt(i + offset, j + 1));
      }
    }
  }

  void JoinColumns(std::int64_t columnA, std::int64_t columnB)
  {
    PointId low = this->Picks.Begin(columnB);
    const PointId endB = this->Picks.End(columnB);
    const PointId endA = this->Picks.End(columnA);
    for (PointId a = this->Picks.Begin(columnA); a < endA; ++a)
    {
      const Depth place = this->Picks.PlaceOf(a);
      while (low < endB && this->Picks.PlaceOf(low) < place - this->LargestStep)
      {
        ++low;
      }
      for (PointId b = low; b < endB && this->Picks.PlaceOf(b) <= place + this->LargestStep; ++b)
      {
        this->Join(a, b);
      }
    }
  }

  PointId FindRoot(PointId pick)
  {
    while (this->Parents[std::size_t(pick)] != pick)
    {
      PointId& parent = this->Parents[std::size_t(pick)];
      parent = this->Parents[std::size_t(parent)];
      pick = parent;
    }
    return pick;
  }

  void Join(PointId a, PointId b)
  {
    a = this->FindRoot(a);
    b = this->FindRoot(b);
    this->Parents[std::size_t(std::max(a, b))] = std::min(a, b);
  }

  const ReflectionPicks& Picks;
  const int Steps;
  const Depth LargestStep;
  RawVector<PointId> Parents;
};
}

//----------------------------------------------------------------------------------------------------------------------
RawVector<PointId> FindConnectedPicks(
  const ReflectionPicks& picks, ColumnConnectivity connectivity, Depth largestStep, const Monitor& monitor)
{
  return Components(picks, connectivity, largestStep).Find(monitor);
}
}
