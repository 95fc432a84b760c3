// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Surfaces that grow one after the other, beside a search that looks through the whole rim at each step.

#include "PickFixtures.h"
#include "Reflections/SurfaceJoining.h"
#include "Tools/Check.h"

#include <limits>
#include <set>

using namespace PickFixtures;

namespace
{
class Oracle
{
public:
  Oracle(const ReflectionPicks& picks, const ReflectionLinks& links)
    : Picks(picks)
    , Links(links)
    , Columns(picks.ListColumns())
    , Surfaces(picks.Places.size(), NoPoint)
  {
  }

  RawVector<PointId> Run()
  {
    for (PointId seed = this->Strongest(); seed != NoPoint; seed = this->Strongest())
    {
      std::set<std::int32_t> taken;
      for (PointId pick = seed; pick != NoPoint; pick = this->BestOfRim(seed, taken))
      {
        this->Surfaces[std::size_t(pick)] = seed;
        taken.insert(this->Columns[std::size_t(pick)]);
      }
    }
    return this->Surfaces;
  }

private:
  PointId Strongest() const
  {
    PointId best = NoPoint;
    for (PointId pick = 0; pick < this->Picks.Size(); ++pick)
    {
      if (this->Surfaces[std::size_t(pick)] == NoPoint &&
        (best == NoPoint || this->Picks.CoarseStrengthOf(pick) > this->Picks.CoarseStrengthOf(best)))
      {
        best = pick;
      }
    }
    return best;
  }

  PointId BestOfRim(PointId seed, const std::set<std::int32_t>& taken) const
  {
    PointId best = NoPoint;
    float bestScore = -std::numeric_limits<float>::infinity();
    const auto consider = [&](PointId from, PointId to, PointId begin, int direction)
    {
      const bool isRim = this->Surfaces[std::size_t(from)] == seed && this->Surfaces[std::size_t(to)] == NoPoint &&
        taken.count(this->Columns[std::size_t(to)]) == 0;
      const float score = float(this->Links.Score(begin, direction));
      if (isRim && (score > bestScore || (score == bestScore && to < best)))
      {
        best = to;
        bestScore = score;
      }
    };
    for (PointId pick = 0; pick < this->Picks.Size(); ++pick)
    {
      for (int direction = 0; direction < this->Links.Directions(); ++direction)
      {
        const PointId next = this->Links.Next(pick, direction);
        if (next != NoPoint)
        {
          consider(pick, next, pick, direction);
          consider(next, pick, pick, direction);
        }
      }
    }
    return best;
  }

  const ReflectionPicks& Picks;
  const ReflectionLinks& Links;
  const RawVector<std::int32_t> Columns;
  RawVector<PointId> Surfaces;
};

void TestOracle()
{
  for (unsigned seed = 1; seed <= 4; ++seed)
  {
    const Traces cube = Rough({ 9, 7, 40 }, seed);
    ReflectionPicks picks = FindReflections(cube.View()).BySign[0];
    // Strengths that the filter tells apart.
    for (PointId pick = 0; pick < picks.Size(); ++pick)
    {
      picks.Strengths[std::size_t(pick)] = CoarseStrength(std::ldexp(1.0F, pick * 37 % 16));
    }
    LinkOptions options;
    options.LargestStep = 3 * DepthsPerSample;
    options.HalfWidth = 6;
    options.Connectivity = seed % 2 == 0 ? ColumnConnectivity::Eight : ColumnConnectivity::Four;
    const ReflectionLinks links(cube.View(), picks, options);
    const RawVector<PointId> found = JoinContinuously(picks, links);
    CHECK(found == Oracle(picks, links).Run());
    CHECK(std::set<PointId>(found.begin(), found.end()).size() < found.size() / 2);
  }
}
}

int TestContinuousJoining(int, char*[])
{
  TestOracle();
  return Check::Result();
}
