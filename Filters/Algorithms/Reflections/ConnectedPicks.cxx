// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Finds components of picks at most a step apart (thesis, 2.2.1) by union-find. Threads join bands of rows, then one
// thread joins their seams. The least number names a set, whatever the order of joins.

#include "SurfaceJoining.h"

#include "Common/Base/FixedChunks.h"

#include <cassert>
#include <numeric>

namespace SeismicHorizons
{
namespace
{
class Components
{
public:
  Components(const ReflectionPicks& picks, ColumnConnectivity connectivity, PickDepth largestStep)
    : Picks(picks)
    , Steps(int(connectivity) / 2)
    , LargestStep(largestStep)
    , Parents(picks.Places.size())
  {
    std::iota(this->Parents.begin(), this->Parents.end(), 0);
  }

  RawVector<PointId> Find(const Monitor& monitor)
  {
    constexpr std::int64_t band = 64;
    ForEachChunk(this->Picks.Columns[1], band, monitor,
      [this](std::size_t, std::int64_t first, std::int64_t last)
      {
        for (std::int64_t j = first; j < last; ++j)
        {
          this->JoinRow(int(j), 0, j + 1 < last ? this->Steps : 1);
        }
      });
    for (std::int64_t j = band; j < this->Picks.Columns[1]; j += band)
    {
      this->JoinRow(int(j - 1), 1, this->Steps);
    }
    for (PointId pick = 0; pick < this->Picks.Size(); ++pick)
    {
      PointId& parent = this->Parents[pick];
      assert(parent <= pick);
      parent = this->Parents[parent]; // already a root
    }
    return std::move(this->Parents);
  }

private:
  void JoinRow(int j, int firstStep, int endStep)
  {
    for (int n = firstStep; n < endStep; ++n)
    {
      const ColumnStep& step = TraceSteps[n];
      for (int i = std::max(0, -step.I); i < this->Picks.Columns[0] - std::max(0, step.I); ++i)
      {
        this->Picks.ForEachPair(this->Picks.ColumnAt(i, j), this->Picks.ColumnAt(i + step.I, j + step.J),
          this->LargestStep, [this](PointId a, PointId b) { this->Join(a, b); });
      }
    }
  }

  PointId FindRoot(PointId pick)
  {
    while (this->Parents[pick] != pick)
    {
      PointId& parent = this->Parents[pick];
      parent = this->Parents[parent];
      pick = parent;
    }
    return pick;
  }

  void Join(PointId a, PointId b)
  {
    a = this->FindRoot(a);
    b = this->FindRoot(b);
    this->Parents[std::max(a, b)] = std::min(a, b);
  }

  const ReflectionPicks& Picks;
  const int Steps;
  const PickDepth LargestStep;
  RawVector<PointId> Parents;
};
}

//----------------------------------------------------------------------------------------------------------------------
RawVector<PointId> FindConnectedPicks(
  const ReflectionPicks& picks, ColumnConnectivity connectivity, PickDepth largestStep, const Monitor& monitor)
{
  return Components(picks, connectivity, largestStep).Find(monitor);
}
}
