// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Components of picks, beside a search that looks at all pairs.

#include "Filters/Algorithms/Reflections/SurfaceJoining.h"
#include "PickFixtures.h"
#include "Tools/Check.h"

#include <cmath>

using namespace PickFixtures;

namespace
{
/// Numbers the components by their first picks, one after the other, by trying all pairs.
std::vector<PointId> BruteForce(const ReflectionPicks& picks, bool overCorners, PickDepth step)
{
  const RawVector<std::int32_t> columns = picks.ListColumns();
  const auto areLinked = [&](PointId a, PointId b)
  {
    const int di = std::abs(columns[std::size_t(a)] % picks.Columns[0] - columns[std::size_t(b)] % picks.Columns[0]);
    const int dj = std::abs(columns[std::size_t(a)] / picks.Columns[0] - columns[std::size_t(b)] / picks.Columns[0]);
    const bool areNeighbours = di + dj == 1 || (overCorners && di == 1 && dj == 1);
    return areNeighbours && std::abs(picks.Places[a] - picks.Places[b]) <= step;
  };
  std::vector<PointId> component(std::size_t(picks.Size()), NoPoint);
  for (PointId first = 0; first < picks.Size(); ++first)
  {
    std::vector<PointId> front = { first };
    while (component[std::size_t(first)] == NoPoint || !front.empty())
    {
      if (front.empty())
      {
        break;
      }
      const PointId pick = front.back();
      front.pop_back();
      if (component[std::size_t(pick)] != NoPoint)
      {
        continue;
      }
      component[std::size_t(pick)] = first;
      for (PointId other = 0; other < picks.Size(); ++other)
      {
        if (areLinked(pick, other))
        {
          front.push_back(other);
        }
      }
    }
  }
  return component;
}

/// 200 rows: several bands, and their seams.
ReflectionPicks RandomPicks(unsigned seed)
{
  std::mt19937 random(seed);
  const std::array<int, 2> columns = { 3 + int(random() % 3), 130 + int(random() % 70) };
  std::vector<std::vector<double>> places(std::size_t(columns[0]) * std::size_t(columns[1]));
  for (std::vector<double>& column : places)
  {
    double place = 0.0;
    while ((place += 0.5 + double(random() % 80) / 16.0) < 12.0)
    {
      column.push_back(place);
    }
  }
  return MakePicks(columns, places);
}

void TestOracle()
{
  for (unsigned seed = 1; seed <= 6; ++seed)
  {
    const ReflectionPicks picks = RandomPicks(seed);
    for (const ColumnConnectivity connectivity : { ColumnConnectivity::Four, ColumnConnectivity::Eight })
    {
      const PickDepth step = PickDepth(0.25 * seed * DepthsPerSample);
      const RawVector<PointId> found = FindConnectedPicks(picks, connectivity, step);
      const std::vector<PointId> expected = BruteForce(picks, connectivity == ColumnConnectivity::Eight, step);
      CHECK(std::equal(found.begin(), found.end(), expected.begin(), expected.end()));
      const auto [one, three] = OnThreads([&]() { return FindConnectedPicks(picks, connectivity, step); });
      CHECK(one == three);
    }
  }
}

/// The step itself is within the step; corners only where they are asked for.
void TestSteps()
{
  const ReflectionPicks row = MakePicks({ 3, 1 }, { { 1.0 }, { 3.0 }, { 5.0001221 } });
  CHECK(FindConnectedPicks(row, ColumnConnectivity::Four, 2 * DepthsPerSample) == (RawVector<PointId>{ 0, 0, 2 }));
  const ReflectionPicks corner = MakePicks({ 2, 2 }, { { 1.0 }, {}, {}, { 1.0 } });
  CHECK(FindConnectedPicks(corner, ColumnConnectivity::Four, DepthsPerSample) == (RawVector<PointId>{ 0, 1 }));
  CHECK(FindConnectedPicks(corner, ColumnConnectivity::Eight, DepthsPerSample) == (RawVector<PointId>{ 0, 0 }));
  const ReflectionPicks other = MakePicks({ 2, 2 }, { {}, { 1.0 }, { 1.0 }, {} });
  CHECK(FindConnectedPicks(other, ColumnConnectivity::Four, DepthsPerSample) == (RawVector<PointId>{ 0, 1 }));
  CHECK(FindConnectedPicks(other, ColumnConnectivity::Eight, DepthsPerSample) == (RawVector<PointId>{ 0, 0 }));
  CHECK(FindConnectedPicks(MakePicks({ 1, 1 }, { {} }), ColumnConnectivity::Four, 1).empty());
}
}

int TestConnectedPicks(int, char*[])
{
  TestOracle();
  TestSteps();
  return Check::Result();
}
