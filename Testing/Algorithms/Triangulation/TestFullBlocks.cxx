// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Meshes of horizons that are full in large parts: there triangles are made without a search.

#include "Common/Base/Parallel.h"
#include "Common/Horizon/MeshChecker.h"
#include "Filters/Algorithms/Triangulation/Triangulation.h"
#include "Tools/Check.h"
#include "Tools/TestHorizons.h"
#include "Tools/TriangleSets.h"

#include <algorithm>

using namespace TestHorizons;
using TriangleSets::Canonical;

namespace
{
const Patches::Columns FiveRowsOfSix = Patches::FromPicture({ "######", "######", "######", "######", "######" });

/// Full blocks are cut without a search. Three times as far apart, points have no neighbouring columns, and all
/// triangles are searched for: the mesh must be the same.
void TestFullBlocksAreWhatTheSearchFinds()
{
  Patches::Random random(9);
  for (int n = 0; n < 500; ++n)
  {
    // With few points missing, so that most that are miss alone.
    Patches::Columns columns = Patches::Make(Patches::Shape(n % int(Patches::Shape::Count)), random);
    const double missing = 0.2 * random.Fraction();
    columns.erase(
      std::remove_if(columns.begin() + 1, columns.end(), [&](const PlanePoint&) { return random.Chance(missing); }),
      columns.end());
    BoundedHorizon horizon = MakeLevelHorizon(columns);
    const auto blocks = Canonical(Triangulate(horizon).Triangles);
    for (PlanePoint& place : horizon.Plane)
    {
      place = { 3 * place.X, 3 * place.Y };
    }
    CHECK(blocks == Canonical(Triangulate(horizon).Triangles));
  }
}

/// A boundary may run through the inside and back: its edges are edges, and what is beside them is meshed all the same.
void TestBoundaryInsideFullBlocks()
{
  BoundedHorizon horizon = MakeLevelHorizon(FiveRowsOfSix);
  const auto point = [&horizon](std::int32_t x, std::int32_t y)
  {
    const auto found = std::find(
      horizon.Plane.begin(), horizon.Plane.end(), PlanePoint{ x * SubVoxelsPerColumn, y * SubVoxelsPerColumn });
    return PointId(found - horizon.Plane.begin());
  };
  Loops withSpur;
  const Loops outline = horizon.Boundary;
  std::for_each(outline.begin(0), outline.end(0),
    [&](PointId onOutline)
    {
      withSpur.Append(onOutline);
      if (onOutline == point(0, 2))
      {
        for (const std::int32_t x : { 1, 2, 3, 2, 1, 0 })
        {
          withSpur.Append(point(x, 2));
        }
      }
    });
  withSpur.Close();
  CHECK_EQUAL(withSpur.TotalLength(), outline.TotalLength() + 6);
  const auto plain = Canonical(Triangulate(horizon).Triangles);
  horizon.Boundary = withSpur;
  CHECK(Canonical(Triangulate(horizon).Triangles) == plain);
  CHECK(Canonical(Triangulate(horizon, { SearchStrategy::VoxelTraversal, 1000 }).Triangles) == plain);
  // So may a loop of a single point, which has no edge.
  horizon.Boundary = outline;
  horizon.Boundary.Append(point(3, 2));
  horizon.Boundary.Close();
  CHECK(Canonical(Triangulate(horizon).Triangles) == plain);
}

/// A point of another patch in the middle of full blocks is outside its own patch.
void TestForeignPointInFullBlocks()
{
  BoundedHorizon horizon = MakeLevelHorizon(FiveRowsOfSix);
  horizon.Patch[14] = 1;
  CHECK_THROWS_WITH(Triangulate(horizon), "lies outside the boundary of its patch");
}

/// Large enough for several threads to have rows of full blocks, with dropouts, gaps and rings where rows of one meet
/// those of another.
void TestThreadsMakeNoDifference()
{
  Patches::Random random(14);
  Patches::Columns columns;
  for (std::int32_t y = 0; y < 220; ++y)
  {
    for (std::int32_t x = 0; x < 500; ++x)
    {
      const bool inGap = (x - 250) * (x - 250) + (y - 110) * (y - 110) < 1600;
      if (!inGap && random.Below(12) != 0)
      {
        columns.push_back({ x, y });
      }
    }
  }
  const BoundedHorizon horizon = MakeLevelHorizon(columns);
  const int before = Detail::NumberOfThreads();
  Detail::NumberOfThreads() = 1;
  const Triangulation alone = Triangulate(horizon);
  Detail::NumberOfThreads() = 5;
  const Triangulation together = Triangulate(horizon);
  Detail::NumberOfThreads() = before;
  CHECK(alone.Triangles == together.Triangles);
  CHECK_EQUAL(alone.BoundaryEdges, together.BoundaryEdges);
  CHECK_EQUAL(MeshChecker::CheckMesh(horizon, together.Triangles), std::string());
}
}

int TestFullBlocks(int, char*[])
{
  TestFullBlocksAreWhatTheSearchFinds();
  TestBoundaryInsideFullBlocks();
  TestForeignPointInFullBlocks();
  TestThreadsMakeNoDifference();
  return Check::Result();
}
