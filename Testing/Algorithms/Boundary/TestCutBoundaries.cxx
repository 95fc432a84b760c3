// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Boundaries of horizons that are cut along links.

#include "Filters/Algorithms/Boundary/ExteriorBoundary.h"
#include "Tools/BoundaryChecker.h"
#include "Tools/Check.h"
#include "Tools/CrackedPatches.h"
#include "Tools/CutChecker.h"

#include <algorithm>
#include <sstream>

using namespace SeismicHorizons;
using CrackedPatches::CrackedPatch;

namespace
{
CrackedPatch Full(int width, int height)
{
  const Patches::Columns columns =
    Patches::FromPicture(std::vector<std::string>(std::size_t(height), std::string(std::size_t(width), '#')));
  return { columns, LinkCuts(PlaneBox(columns)) };
}

BoundaryOptions With(const CrackedPatch& patch, int radius = 1)
{
  BoundaryOptions options;
  options.Radius = radius;
  options.Cuts = &patch.Cuts;
  return options;
}

/// The loops as text, a column each, like "0,0 0,1 | 5,5".
std::string Text(const Patches::Columns& columns, const Loops& loops)
{
  std::ostringstream text;
  for (std::size_t loop = 0; loop < loops.Size(); ++loop)
  {
    text << (loop == 0 ? "" : " |");
    std::for_each(loops.begin(loop), loops.end(loop),
      [&](PointId point) { text << ' ' << columns[std::size_t(point)].X << ',' << columns[std::size_t(point)].Y; });
  }
  return text.str();
}

std::string LoopsOf(const CrackedPatch& patch, const BoundaryOptions& options)
{
  return Text(patch.Columns, FindExteriorBoundary(patch.Columns, options).Boundary);
}

/// The loops other than the outline of the first patch.
std::string CracksOf(const CrackedPatch& patch, const BoundaryOptions& options)
{
  const std::string text = LoopsOf(patch, options);
  const std::size_t bar = text.find(" |");
  return bar == std::string::npos ? std::string() : text.substr(bar + 2);
}

/// One faulted link opens the two blocks beside it; a second one makes the crack longer. Sizes of holes do not count.
void TestStraightCracks()
{
  CrackedPatch patch = Full(6, 5);
  patch.Cuts.CutNorth({ 2, 2 });
  const std::string oneLink = " 1,2 2,2 3,2 3,3 2,3 1,3";
  for (int radius = 1; radius <= 3; ++radius)
  {
    BoundaryOptions options = With(patch, radius);
    CHECK_EQUAL(CracksOf(patch, options), oneLink);
    options.KeepHoles = true;
    options.SmallestHoleSize = 100;
    CHECK_EQUAL(CracksOf(patch, options), oneLink);
  }
  patch.Cuts.CutNorth({ 3, 2 });
  CHECK_EQUAL(CracksOf(patch, With(patch)), " 1,2 2,2 3,2 4,2 4,3 3,3 2,3 1,3");
  CrackedPatch upright = Full(4, 6);
  upright.Cuts.CutEast({ 1, 2 });
  CHECK_EQUAL(CracksOf(upright, With(upright)), " 1,1 2,1 2,2 2,3 1,3 1,2");
}

/// The corner that a crack turns around keeps the diagonal beyond it.
void TestTurn()
{
  CrackedPatch patch = Full(5, 5);
  patch.Cuts.CutNorth({ 1, 1 });
  patch.Cuts.CutEast({ 1, 2 });
  CHECK_EQUAL(CracksOf(patch, With(patch)), " 0,1 1,1 2,2 2,3 1,3 1,2 0,2");
}

/// A crack from edge to edge parts two patches; a ring parts what it encloses, down to a single column.
void TestPartingCracks()
{
  CrackedPatch across = Full(3, 4);
  for (std::int32_t x = 0; x < 3; ++x)
  {
    across.Cuts.CutNorth({ x, 1 });
  }
  CHECK_EQUAL(LoopsOf(across, With(across)), " 0,0 0,1 1,1 2,1 2,0 1,0 | 0,2 0,3 1,3 2,3 2,2 1,2");
  CrackedPatch ring = Full(3, 3);
  ring.Cuts.CutEast({ 0, 1 });
  ring.Cuts.CutEast({ 1, 1 });
  ring.Cuts.CutNorth({ 1, 0 });
  ring.Cuts.CutNorth({ 1, 1 });
  CHECK_EQUAL(LoopsOf(ring, With(ring)), " 0,0 0,1 0,2 1,2 2,2 2,1 2,0 1,0 | 1,1 | 0,1 1,0 2,1 1,2");
  BoundaryOptions withoutSmall = With(ring);
  withoutSmall.MinimumPatchSize = 2;
  CHECK_EQUAL(FindExteriorBoundary(ring.Columns, withoutSmall).Patch[4], NoPatch);
}

/// A crack that reaches the outline is part of it.
void TestOpenCrack()
{
  CrackedPatch patch = Full(3, 4);
  patch.Cuts.CutNorth({ 0, 1 });
  CHECK_EQUAL(LoopsOf(patch, With(patch)), " 0,0 0,1 1,1 1,2 0,2 0,3 1,3 2,3 2,2 2,1 2,0 1,0");
}

/// A cut between the empty columns of a gap keeps it open, also where an island lies in it.
void TestCutGaps()
{
  CrackedPatch patch{ Patches::FromPicture({ "######", "######", "##..##", "######", "######" }),
    LinkCuts(PlaneBox({ { 0, 0 }, { 5, 4 } })) };
  CHECK_EQUAL(CracksOf(patch, With(patch)), "");
  patch.Cuts.CutEast({ 2, 2 });
  CHECK_EQUAL(CracksOf(patch, With(patch)), " 1,2 2,1 3,1 4,2 3,3 2,3");
  // Hops along the other gap stay.
  CrackedPatch island{ Patches::FromPicture({ "#######", "#.....#", "#.##..#", "#.##..#", "#.....#", "#######" }),
    LinkCuts(PlaneBox({ { 0, 0 }, { 6, 5 } })) };
  CHECK_EQUAL(FindExteriorBoundary(island.Columns, With(island)).NumberOfPatches, 1u);
  island.Cuts.CutEast({ 2, 2 });
  CHECK_EQUAL(FindExteriorBoundary(island.Columns, With(island)).NumberOfPatches, 2u);
}

/// A long hop spans a gap, but not where a cut runs through that.
void TestLongHops()
{
  CrackedPatch patch{ Patches::FromPicture({ "##..##", "##..##", "##..##" }),
    LinkCuts(PlaneBox({ { 0, 0 }, { 5, 2 } })) };
  CHECK_EQUAL(FindExteriorBoundary(patch.Columns, With(patch, 3)).NumberOfPatches, 1u);
  patch.Cuts.CutEast({ 2, 2 });
  CHECK_EQUAL(FindExteriorBoundary(patch.Columns, With(patch, 3)).NumberOfPatches, 1u);
  patch.Cuts.CutEast({ 2, 1 });
  patch.Cuts.CutEast({ 2, 0 });
  CHECK_EQUAL(FindExteriorBoundary(patch.Columns, With(patch, 3)).NumberOfPatches, 2u);
}

/// Cutoffs are boundary points by every definition.
void TestMarks()
{
  CrackedPatch patch = Full(6, 6);
  patch.Cuts.CutNorth({ 2, 2 });
  for (const BoundaryType type : { BoundaryType::Exterior, BoundaryType::Topological4, BoundaryType::Topological8 })
  {
    const ExteriorBoundary boundary = FindExteriorBoundary(patch.Columns, OptionsFor(type, With(patch)));
    const std::vector<BoundaryKind> marks = MarkBoundary(type, patch.Columns, boundary);
    CHECK_EQUAL(std::count(marks.begin(), marks.end(), BoundaryKind::Hole), 6);
    CHECK_EQUAL(std::count(marks.begin(), marks.end(), BoundaryKind::Inside), 10);
  }
}

void TestErrors()
{
  const CrackedPatch patch = Full(3, 3);
  BoundaryOptions options = With(patch, 2);
  options.Growth = GrowthStrategy::Distance;
  CHECK_THROWS_WITH(FindExteriorBoundary(patch.Columns, options),
    "faulted links and growth by distance with a radius of 2 columns, expected clockwise growth, or a radius of 1");
  options.Radius = 1;
  CHECK_EQUAL(FindExteriorBoundary(patch.Columns, options).NumberOfPatches, 1u);
  CHECK_EQUAL(FindExteriorBoundary({}, With(patch)).NumberOfPatches, 0u);
}

BoundaryOptions MakeOptions(int which, const LinkCuts& cuts)
{
  BoundaryOptions options;
  options.Radius = 1 + which / 4;
  options.KeepHoles = which % 4 != 0;
  options.SmallestHoleSize = which % 4 == 1 ? 1 : which % 4 == 2 ? 4 : 1000;
  options.Cuts = &cuts;
  return options;
}

/// Each with every radius from 1 to 3 and four choices of holes.
void TestRandomLattices()
{
  Patches::Random random(11);
  for (int n = 0; n < CrackedPatches::NumberOfLattices(); ++n)
  {
    const CrackedPatch patch = CrackedPatches::Make(random);
    for (int which = 0; which < 12; ++which)
    {
      const BoundaryOptions options = MakeOptions(which, patch.Cuts);
      const ExteriorBoundary boundary = FindExteriorBoundary(patch.Columns, options);
      const bool isSound =
        CHECK_EQUAL(BoundaryChecker::CheckBoundary(patch.Columns, boundary, options), std::string()) &&
        CHECK_EQUAL(CutChecker::CheckBoundary(patch, boundary, options), std::string());
      if (!isSound)
      {
        std::cerr << "lattice " << n << ", case " << which << '\n';
        return;
      }
    }
  }
}

/// Cuts that cut nothing change nothing.
void TestNoCuts()
{
  Patches::Random random(12);
  for (int n = 0; n < 200; ++n)
  {
    const Patches::Columns columns = Patches::Make(Patches::Shape(n % int(Patches::Shape::Count)), random);
    const LinkCuts none{ PlaneBox(columns) };
    for (int which = 0; which < 12; ++which)
    {
      BoundaryOptions options = MakeOptions(which, none);
      const ExteriorBoundary with = FindExteriorBoundary(columns, options);
      options.Cuts = nullptr;
      const ExteriorBoundary without = FindExteriorBoundary(columns, options);
      CHECK(with.Patch == without.Patch && Text(columns, with.Boundary) == Text(columns, without.Boundary) &&
        with.NumberOfPatches == without.NumberOfPatches);
    }
  }
}
}

int TestCutBoundaries(int, char*[])
{
  TestStraightCracks();
  TestTurn();
  TestPartingCracks();
  TestOpenCrack();
  TestCutGaps();
  TestLongHops();
  TestMarks();
  TestErrors();
  TestNoCuts();
  TestRandomLattices();
  return Check::Result();
}
