// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Filters/Algorithms/Boundary/ExteriorBoundary.h"
#include "Tools/BoundaryChecker.h"
#include "Tools/Check.h"
#include "Tools/MonitorChecker.h"
#include "Tools/OutlineChecker.h"
#include "Tools/Patches.h"

#include <algorithm>
#include <set>
#include <sstream>

using namespace SeismicHorizons;

namespace
{
// Each with every radius from 1 to 5 and both rules.
constexpr int PatchesOfContract = 10000;

/// The loops as text, a column each, like "0,0 0,1 | 5,5".
std::string Text(const std::vector<PlanePoint>& columns, const Loops& loops)
{
  std::ostringstream text;
  for (std::size_t loop = 0; loop < loops.Size(); ++loop)
  {
    text << (loop == 0 ? "" : "|");
    std::for_each(loops.begin(loop), loops.end(loop),
      [&](PointId point) { text << ' ' << columns[std::size_t(point)].X << ',' << columns[std::size_t(point)].Y; });
  }
  return text.str();
}

std::string LoopsOf(const std::vector<std::string>& picture, const BoundaryOptions& options = BoundaryOptions())
{
  const Patches::Columns columns = Patches::FromPicture(picture);
  return Text(columns, FindExteriorBoundary(columns, options).Boundary);
}

BoundaryOptions With(int radius, GrowthStrategy growth, bool holes = false)
{
  BoundaryOptions options;
  options.Radius = radius;
  options.Growth = growth;
  options.KeepHoles = holes;
  return options;
}

void TestSmallPatches()
{
  CHECK_EQUAL(LoopsOf({ "#" }), " 0,0");
  CHECK_EQUAL(LoopsOf({ "##" }), " 0,0 1,0");
  CHECK_EQUAL(LoopsOf({ "##", "##" }), " 0,0 0,1 1,1 1,0");
  // The middle of three by three is inside, whether it is there or not.
  CHECK_EQUAL(LoopsOf({ "###", "###", "###" }), " 0,0 0,1 0,2 1,2 2,2 2,1 2,0 1,0");
  CHECK_EQUAL(LoopsOf({ "###", "#.#", "###" }), " 0,0 0,1 0,2 1,2 2,2 2,1 2,0 1,0");
  // A plus: hops are diagonal, and the middle is inside.
  CHECK_EQUAL(LoopsOf({ ".#.", "###", ".#." }), " 0,1 1,2 2,1 1,0");
}

void TestSpur()
{
  CHECK_EQUAL(LoopsOf({ "##..", "####" }), " 0,0 0,1 1,1 2,0 3,0 2,0 1,0");
}

/// The first point is where two lobes touch: a walk that stops at its first return would lose one of them.
void TestPinchAtFirstPoint()
{
  CHECK_EQUAL(LoopsOf({ ".#", "#.", ".#" }), " 0,1 1,2 0,1 1,0");
  CHECK_EQUAL(LoopsOf({ ".##", ".##", "#..", ".##", ".##" }), " 0,2 1,3 1,4 2,4 2,3 1,3 0,2 1,1 2,1 2,0 1,0 1,1");
}

void TestSeveralPatches()
{
  // Numbered by rows from below; the loop of each starts at its least x.
  CHECK_EQUAL(LoopsOf({ "#...", "....", "..##" }), " 2,0 3,0| 0,2");
}

/// An island in a hole belongs to the patch around it, however deep they are nested.
void TestIslands()
{
  const Patches::Columns columns = Patches::FromPicture({
    "#######",
    "#.....#",
    "#.###.#",
    "#.#.#.#",
    "#.###.#",
    "#.....#",
    "#######",
  });
  const ExteriorBoundary boundary = FindExteriorBoundary(columns);
  CHECK_EQUAL(boundary.Boundary.Size(), 1u);
  CHECK_EQUAL(boundary.Boundary.TotalLength(), 24u);
  CHECK_EQUAL(std::count(boundary.Patch.begin(), boundary.Patch.end(), 0), std::ptrdiff_t(columns.size()));
}

/// An open ring encloses nothing: what lies in it is a patch of its own.
void TestOpenRing()
{
  const Patches::Columns columns = Patches::FromPicture({ "#####", "#....", "#.#.#", "#...#", "#####" });
  CHECK_EQUAL(FindExteriorBoundary(columns).Boundary.Size(), 2u);
}

void TestRandomPatches()
{
  Patches::Random random(2);
  for (int shape = 0; shape < int(Patches::Shape::Count); ++shape)
  {
    for (int n = 0; n < 300; ++n)
    {
      const Patches::Columns columns = Patches::Make(Patches::Shape(shape), random);
      CHECK_EQUAL(OutlineChecker::CheckOutlines(columns, FindExteriorBoundary(columns)), std::string());
    }
  }
}

/// A gap of one column is bridged with k = 2: by distance there and back, clockwise along both sides.
void TestGap()
{
  const std::vector<std::string> gap = { "##.##", "##.##" };
  CHECK_EQUAL(LoopsOf(gap), " 0,0 0,1 1,1 1,0| 3,0 3,1 4,1 4,0");
  CHECK_EQUAL(LoopsOf(gap, With(2, GrowthStrategy::Distance)), " 0,0 0,1 1,1 1,0 3,0 3,1 4,1 4,0 3,0 1,0");
  CHECK_EQUAL(LoopsOf(gap, With(2, GrowthStrategy::Clockwise)), " 0,0 0,1 1,1 3,1 4,1 4,0 3,0 1,0");
}

/// Bays that a hop can span are closed by clockwise growth, and followed by distance.
void TestBay()
{
  const std::vector<std::string> bay = { "#.#", "###" };
  CHECK_EQUAL(LoopsOf(bay, With(2, GrowthStrategy::Distance)), LoopsOf(bay));
  CHECK_EQUAL(LoopsOf(bay), " 0,0 0,1 1,0 2,1 2,0 1,0");
  CHECK_EQUAL(LoopsOf(bay, With(2, GrowthStrategy::Clockwise)), " 0,0 0,1 2,1 2,0 1,0");
}

/// The drawing in the documentation.
void TestBayAndGap()
{
  const std::vector<std::string> picture = { "#.#.##", "###.##" };
  CHECK_EQUAL(LoopsOf(picture, With(2, GrowthStrategy::Distance)), " 0,0 0,1 1,0 2,1 2,0 4,0 4,1 5,1 5,0 4,0 2,0 1,0");
  CHECK_EQUAL(LoopsOf(picture, With(2, GrowthStrategy::Clockwise)), " 0,0 0,1 2,1 4,1 5,1 5,0 4,0 2,0 1,0");
}

/// The hop between (2, 5) and (5, 2) crosses a longer one, from (4, 4) to (0, 0). But the longer one has to be taken,
/// as no other hop leads to (0, 0).
void TestShortHopGivesWay()
{
  const std::vector<std::string> picture = { "..#...", "....#.", "......", ".....#", "......", "#....." };
  CHECK_EQUAL(LoopsOf(picture, With(4, GrowthStrategy::Clockwise)), " 0,0 4,4 2,5 4,4 5,2 4,4");
  CHECK_EQUAL(LoopsOf(picture, With(4, GrowthStrategy::Distance)), " 0,0 4,4 2,5 4,4 5,2 4,4");
  CHECK_EQUAL(LoopsOf(picture, With(3, GrowthStrategy::Clockwise)), " 0,0| 2,5 4,4 5,2");
}

/// Counter-clockwise from their least x, after the loops of patches. With k = 2 a hop spans the hole.
void TestHoles()
{
  const std::vector<std::string> ring = { "####", "#.##", "####" };
  const std::string outline = " 0,0 0,1 0,2 1,2 2,2 3,2 3,1 3,0 2,0 1,0";
  CHECK_EQUAL(LoopsOf(ring, With(1, GrowthStrategy::Distance, true)), outline + "| 0,1 1,0 2,1 1,2");
  CHECK_EQUAL(LoopsOf(ring, With(2, GrowthStrategy::Distance, true)), outline + "| 0,1 1,0 2,1 1,2");
  CHECK_EQUAL(LoopsOf(ring, With(2, GrowthStrategy::Clockwise, true)), outline);
}

/// An island is a patch of its own in a hole that has a loop, and a part of the patch around it in one that has none.
void TestIslandsInHoles()
{
  const Patches::Columns columns =
    Patches::FromPicture({ "#######", "#.....#", "#.....#", "#..#..#", "#.....#", "#.....#", "#######" });
  for (const int radius : { 1, 2 })
  {
    BoundaryOptions options = With(radius, GrowthStrategy::Clockwise, true);
    const ExteriorBoundary kept = FindExteriorBoundary(columns, options);
    CHECK_EQUAL(kept.NumberOfPatches, 2u);
    CHECK_EQUAL(kept.Boundary.Size(), 3u);
    options.SmallestHoleSize = 26;
    const ExteriorBoundary filled = FindExteriorBoundary(columns, options);
    CHECK_EQUAL(filled.NumberOfPatches, 1u);
    CHECK_EQUAL(filled.Boundary.Size(), 1u);
    CHECK_EQUAL(std::count(filled.Patch.begin(), filled.Patch.end(), 0), std::ptrdiff_t(columns.size()));
  }
}

/// Small patches have no number and no loops, and the patches after them have lower numbers. The hole of the last patch
/// stays.
void TestMinimumPatchSize()
{
  const Patches::Columns columns = Patches::FromPicture({ "###", "#.#", "###", "...", "#.#" });
  BoundaryOptions options = With(1, GrowthStrategy::Clockwise, true);
  options.MinimumPatchSize = 2;
  const ExteriorBoundary boundary = FindExteriorBoundary(columns, options);
  CHECK_EQUAL(boundary.NumberOfPatches, 1u);
  CHECK_EQUAL(boundary.Boundary.Size(), 2u);
  CHECK_EQUAL(std::count(boundary.Patch.begin(), boundary.Patch.end(), NoPatch), 2);
  CHECK_EQUAL(std::count(boundary.Patch.begin(), boundary.Patch.end(), 0), 8);
}

BoundaryOptions RandomOptions(int radius, GrowthStrategy growth, Patches::Random& random)
{
  BoundaryOptions options;
  options.Radius = radius;
  options.Growth = growth;
  options.KeepHoles = random.Chance(0.5);
  options.SmallestHoleSize = 1 + random.Below(4) * random.Below(3);
  return options;
}

/// Every radius and rule, with and without holes, on every kind of patch.
void TestContract()
{
  Patches::Random random(11);
  for (int n = 0; n < PatchesOfContract; ++n)
  {
    const Patches::Columns columns = Patches::Make(Patches::Shape(n % int(Patches::Shape::Count)), random);
    for (int which = 0; which < 10; ++which)
    {
      const BoundaryOptions options = RandomOptions(1 + which / 2, GrowthStrategy(which % 2), random);
      const std::string wrong =
        BoundaryChecker::CheckBoundary(columns, FindExteriorBoundary(columns, options), options);
      if (!CHECK_EQUAL(wrong, std::string()))
      {
        std::cerr << "patch " << n << ", radius " << options.Radius << ", growth " << int(options.Growth) << ", holes "
                  << options.KeepHoles << " from " << options.SmallestHoleSize << '\n';
      }
    }
  }
}

/// The topological boundary by its definition.
void TestTopologicalMarks()
{
  Patches::Random random(13);
  for (int n = 0; n < 500; ++n)
  {
    const Patches::Columns columns = Patches::Make(Patches::Shape(n % int(Patches::Shape::Count)), random);
    const std::set<PlanePoint> occupied(columns.begin(), columns.end());
    for (const BoundaryType type : { BoundaryType::Topological4, BoundaryType::Topological8 })
    {
      const ExteriorBoundary boundary = FindExteriorBoundary(columns, OptionsFor(type, BoundaryOptions()));
      const std::vector<BoundaryKind> marks = MarkBoundary(type, columns, boundary);
      for (std::size_t point = 0; point < columns.size(); ++point)
      {
        bool isBeside = false;
        for (int turn = 0; turn < 9; ++turn)
        {
          const PlanePoint way{ turn % 3 - 1, turn / 3 - 1 };
          const PlanePoint next{ columns[point].X + way.X, columns[point].Y + way.Y };
          isBeside =
            isBeside || (occupied.count(next) == 0 && (type == BoundaryType::Topological8 || way.X * way.Y == 0));
        }
        CHECK_EQUAL(marks[point] != BoundaryKind::Inside, isBeside);
      }
    }
  }
}

void TestOrderOfPointsIsNoMatter()
{
  Patches::Random random(3);
  for (int n = 0; n < 100; ++n)
  {
    Patches::Columns columns = Patches::Make(Patches::Shape::Sparse, random);
    const BoundaryOptions options = RandomOptions(1 + n % 3, GrowthStrategy(n % 2), random);
    const std::string before = Text(columns, FindExteriorBoundary(columns, options).Boundary);
    std::reverse(columns.begin(), columns.end());
    CHECK_EQUAL(Text(columns, FindExteriorBoundary(columns, options).Boundary), before);
  }
}

/// Patches in the far corners of the largest lattice have the loops they have near each other; a raster of their
/// bounding box would take 2^58 bytes.
void TestPatchesFarApart()
{
  constexpr std::int32_t Far = (1 << 28) - 100;
  Patches::Random random(12);
  for (int n = 0; n < 40; ++n)
  {
    const BoundaryOptions options = RandomOptions(1 + n % 4, GrowthStrategy(n / 4 % 2), random);
    const BoundaryType type = BoundaryType(n % 3);
    Patches::Columns near;
    Patches::Columns apart;
    for (const PlanePoint& corner : { PlanePoint{ 0, 0 }, { 40, 0 }, { 40, 40 } })
    {
      for (const PlanePoint& column : Patches::Make(Patches::Shape(n % int(Patches::Shape::Count)), random))
      {
        near.push_back({ corner.X + column.X, corner.Y + column.Y });
        apart.push_back({ column.X + (corner.X > 0 ? Far : 0), column.Y + (corner.Y > 0 ? Far : 0) });
      }
    }
    const ExteriorBoundary expected = FindExteriorBoundary(near, OptionsFor(type, options));
    const ExteriorBoundary found = FindExteriorBoundary(apart, OptionsFor(type, options));
    CHECK_EQUAL(Text(near, found.Boundary), Text(near, expected.Boundary));
    CHECK((found.Patch == expected.Patch));
    CHECK((MarkBoundary(type, apart, found) == MarkBoundary(type, near, expected)));
  }
  CHECK_THROWS_WITH(FindExteriorBoundary({ { 0, 0 }, { Far, 7 }, { Far, 7 } }),
    "points 1 and 2 both in column (268435356, 7), expected at most one point of a horizon in a column");
}

void TestErrorsAndEmpty()
{
  CHECK_EQUAL(FindExteriorBoundary({}).Boundary.Size(), 0u);
  CHECK_THROWS_WITH(FindExteriorBoundary({ { 4, 7 }, { 3, 7 }, { 4, 7 } }),
    "points 0 and 2 both in column (4, 7), expected at most one point of a horizon in a column");
  CHECK_THROWS_WITH(FindExteriorBoundary({}, With(0, GrowthStrategy::Distance)), "radius 0, expected 1 to 32 columns");
  CHECK_THROWS_WITH(
    FindExteriorBoundary({}, With(33, GrowthStrategy::Clockwise)), "radius 33, expected 1 to 32 columns");
  CHECK_EQUAL(FindExteriorBoundary({}, With(3, GrowthStrategy::Clockwise, true)).Boundary.Size(), 0u);
  CHECK_EQUAL(FindExteriorBoundary({}, With(3, GrowthStrategy::Distance, true)).Boundary.Size(), 0u);
}

/// Rows of which only every other column is there: many patches of one column, and at radius 2 one with a long border.
void TestMonitor()
{
  std::vector<std::string> picture(130);
  for (std::string& row : picture)
  {
    for (int n = 0; n < 40; ++n)
    {
      row += "#.";
    }
  }
  const Patches::Columns columns = Patches::FromPicture(picture);
  const auto check = [&](int leastCalls, const BoundaryOptions& options)
  {
    CHECK_EQUAL(MonitorChecker::Check(
                  leastCalls, [&](const Monitor& monitor) { FindExteriorBoundary(columns, options, monitor); }),
      std::string());
  };
  check(3, With(1, GrowthStrategy::Clockwise));
  check(7, With(2, GrowthStrategy::Distance));
  check(15, With(2, GrowthStrategy::Clockwise, true));
}
}

int TestExteriorBoundary(int, char*[])
{
  TestSmallPatches();
  TestSpur();
  TestPinchAtFirstPoint();
  TestSeveralPatches();
  TestIslands();
  TestOpenRing();
  TestRandomPatches();
  TestGap();
  TestBay();
  TestBayAndGap();
  TestShortHopGivesWay();
  TestHoles();
  TestIslandsInHoles();
  TestMinimumPatchSize();
  TestContract();
  TestTopologicalMarks();
  TestOrderOfPointsIsNoMatter();
  TestPatchesFarApart();
  TestErrorsAndEmpty();
  TestMonitor();
  return Check::Result();
}
