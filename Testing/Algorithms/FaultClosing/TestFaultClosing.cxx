// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Small cracks that are closed, triangle by triangle.

#include "ClosedFaults.h"
#include "Tools/Check.h"

#include <algorithm>
#include <string>
#include <utility>

using namespace ClosedFaults;

namespace
{
CrackedPatch FromPicture(const std::vector<std::string>& rows)
{
  const Patches::Columns columns = Patches::FromPicture(rows);
  const PlaneBox box({ { 0, 0 }, { std::int32_t(rows.front().size()) - 1, std::int32_t(rows.size()) - 1 } });
  return { columns, LinkCuts(box) };
}

CrackedPatch Full(int width, int height)
{
  return FromPicture(std::vector<std::string>(std::size_t(height), std::string(std::size_t(width), '#')));
}

/// Cuts the links upwards from the columns of a row.
void CutRow(CrackedPatch& patch, std::int32_t first, std::int32_t last, std::int32_t row)
{
  for (std::int32_t x = first; x <= last; ++x)
  {
    patch.Cuts.CutNorth({ x, row });
  }
}

/// Cuts the links to the right from the columns of a file.
void CutFile(CrackedPatch& patch, std::int32_t file, std::int32_t first, std::int32_t last)
{
  for (std::int32_t y = first; y <= last; ++y)
  {
    patch.Cuts.CutEast({ file, y });
  }
}

std::string Column(const CrackedPatch& patch, PointId point)
{
  const PlanePoint& column = patch.Columns[point];
  return std::to_string(column.X) + ',' + std::to_string(column.Y);
}

struct Closed
{
  std::size_t Triangles;
  std::string OpenEnds; // their points, like "0,1-0,0"
  std::size_t Loops; // that are cutoffs all along
};

/// With loops for cracks alone, or for all holes, too.
Closed Close(const CrackedPatch& patch, bool withHoles = false, int radius = 1)
{
  BoundaryOptions options;
  options.Cuts = &patch.Cuts;
  options.KeepHoles = withHoles;
  options.Radius = radius;
  const Cracked cracked = Make(patch, options, std::vector<double>(patch.Columns.size(), 0.0));
  const RawVector<PointId> closing = ClosedFaults::Close(cracked, cracked.Horizon);
  if (radius == 1)
  {
    CHECK_EQUAL(ClosingChecker::CheckBlocks(patch, cracked.Horizon, closing), std::string());
    CHECK_EQUAL(ClosingChecker::CheckClosing(cracked.Horizon, Triangulate(cracked.Horizon).Triangles, closing,
                  ClosingChecker::FindOutlineOfBlocks(patch, cracked.Horizon)),
      std::string());
  }
  std::string openEnds;
  for (const Edge& openEnd : cracked.Open.OpenEnds)
  {
    openEnds += (openEnds.empty() ? "" : " ") + Column(patch, openEnd.From) + '-' + Column(patch, openEnd.To);
  }
  return { closing.size() / 3, openEnds, cracked.Open.Loops.size() };
}

void CheckClosed(const Closed& closed, std::size_t triangles, const std::string& openEnds, std::size_t loops)
{
  CHECK_EQUAL(closed.Triangles, triangles);
  CHECK_EQUAL(closed.OpenEnds, openEnds);
  CHECK_EQUAL(closed.Loops, loops);
}

/// L faulted links open L + 1 blocks, of two triangles each.
void TestInnerCracks()
{
  for (std::int32_t links = 1; links <= 3; ++links)
  {
    CrackedPatch along = Full(8, 6);
    CutRow(along, 2, 1 + links, 2);
    CrackedPatch upwards = Full(6, 8);
    CutFile(upwards, 2, 2, 1 + links);
    for (int radius = 1; radius <= 3; ++radius)
    {
      CheckClosed(Close(along, false, radius), 2 * std::size_t(links + 1), "", 1);
      CheckClosed(Close(upwards, false, radius), 2 * std::size_t(links + 1), "", 1);
    }
  }
}

/// Only half of the block at the corner of a crack is open.
void TestTurn()
{
  CrackedPatch patch = Full(5, 5);
  patch.Cuts.CutNorth({ 1, 1 });
  patch.Cuts.CutEast({ 1, 2 });
  CheckClosed(Close(patch), 5, "", 1);
}

void TestBranches()
{
  CrackedPatch branch = Full(8, 7);
  CutRow(branch, 2, 5, 2);
  CutFile(branch, 3, 3, 4);
  CheckClosed(Close(branch), 2 * 7, "", 1);
  CrackedPatch crossing = Full(8, 8);
  CutRow(crossing, 2, 5, 3);
  CutFile(crossing, 3, 2, 5);
  CheckClosed(Close(crossing), 2 * 9, "", 1);
}

/// A ring is a crack between two loops: that around it, and the outline of the island.
void TestRings()
{
  CrackedPatch ring = Full(7, 7);
  CutRow(ring, 2, 4, 1);
  CutRow(ring, 2, 4, 4);
  CutFile(ring, 1, 2, 4);
  CutFile(ring, 4, 2, 4);
  CheckClosed(Close(ring), 4 * 2 * 2 + 4, "", 2);
  CrackedPatch single = Full(3, 3);
  CutRow(single, 1, 1, 0);
  CutRow(single, 1, 1, 1);
  CutFile(single, 0, 1, 1);
  CutFile(single, 1, 1, 1);
  CheckClosed(Close(single), 4, "", 2);
}

/// The open end of a crack at the border leads along the border.
void TestOpenCracks()
{
  CrackedPatch open = Full(4, 4);
  CutRow(open, 0, 1, 1);
  CheckClosed(Close(open), 4, "0,2-0,1", 0);
  CrackedPatch across = Full(4, 4);
  CutRow(across, 0, 3, 1);
  CheckClosed(Close(across), 6, "3,1-3,2 0,2-0,1", 0);
  CrackedPatch shortest = Full(2, 2);
  CutRow(shortest, 0, 1, 0);
  CheckClosed(Close(shortest), 2, "1,0-1,1 0,1-0,0", 0);
}

/// A crack that runs into a gap is closed up to the gap, which stays open with its loop.
void TestGaps()
{
  CrackedPatch into = FromPicture({ "########", "########", "####..##", "####..##", "########", "########" });
  CutRow(into, 1, 3, 2);
  for (const bool withHoles : { false, true })
  {
    CheckClosed(Close(into, withHoles), 2 * 3, "3,2-3,3", 0);
  }
  // One beside a gap that it does not open.
  CrackedPatch beside = FromPicture({ "########", "########", "####..##", "########", "########", "########" });
  CutRow(beside, 2, 4, 1);
  CheckClosed(Close(beside, true), 2 * 4, "", 1);
  // One that has its tip beside a gap touches that, and with one more link it runs into it.
  CrackedPatch touching = FromPicture({ "#######", "#######", "#####.#", "#######", "#######", "#######" });
  CutRow(touching, 2, 3, 2);
  CheckClosed(Close(touching, true), 2 * 3, "", 1);
  touching.Cuts.CutNorth({ 4, 2 });
  CheckClosed(Close(touching, true), 2 * 3 + 1, "5,2-4,3", 0);
  // A cut that leads through a gap is two cracks.
  CrackedPatch through = FromPicture({ "#########", "#########", "####.####", "#########", "#########", "#########" });
  CutRow(through, 1, 7, 3);
  CheckClosed(Close(through, true), 2 * (2 * 3 + 1), "3,3-4,4 4,4-5,3", 0);
}

/// What a crack cuts off of a border, down to a single column.
void TestSmallPatches()
{
  CrackedPatch spur = FromPicture({ "..#..", "..#..", "#####", "#####" });
  CutRow(spur, 2, 2, 1);
  CheckClosed(Close(spur), 2, "3,1-2,2 2,2-1,1", 0);
  CrackedPatch corner = Full(3, 3);
  CutRow(corner, 2, 2, 1);
  CutFile(corner, 1, 2, 2);
  CheckClosed(Close(corner), 1, "2,1-2,2 2,2-1,2", 1);
  // A row of columns between two cracks.
  CrackedPatch strip = Full(6, 6);
  CutRow(strip, 1, 3, 1);
  CutRow(strip, 1, 3, 2);
  CheckClosed(Close(strip), 2 * 2 * 4, "", 2);
}

/// Hops of a larger radius lead over gaps, and open ends are as long. Missing columns that a square of such hops
/// encloses are no gap.
void TestLongOpenEnds()
{
  const std::string full = "#..#..#..#";
  const std::string none = "..........";
  CrackedPatch sparse = FromPicture({ full, none, none, full, none, none, full, none, none, full });
  CutRow(sparse, 0, 9, 4);
  CheckClosed(Close(sparse, false, 1), 0, "", 0);
  CheckClosed(Close(sparse, false, 2), 0, "", 0);
  CheckClosed(Close(sparse, false, 3), 6, "9,3-9,6 0,6-0,3", 0);
}

/// What checks these lattices sees what is wrong.
void TestChecker()
{
  CrackedPatch patch = Full(6, 5);
  CutRow(patch, 0, 2, 1);
  BoundaryOptions options;
  options.Cuts = &patch.Cuts;
  const Cracked cracked = Make(patch, options, std::vector<double>(patch.Columns.size(), 0.0));
  const RawVector<PointId> mesh = Triangulate(cracked.Horizon).Triangles;
  const RawVector<PointId> closing = ClosedFaults::Close(cracked, cracked.Horizon);
  ClosingChecker::Outline outline = ClosingChecker::FindOutlineOfBlocks(patch, cracked.Horizon);
  const auto check = [&](const RawVector<PointId>& triangles)
  { return ClosingChecker::CheckClosing(cracked.Horizon, mesh, triangles, outline); };
  CHECK_EQUAL(check(closing), std::string());
  RawVector<PointId> wrong(closing.begin() + 3, closing.end());
  CHECK(!check(wrong).empty());
  CHECK_EQUAL(ClosingChecker::CheckBlocks(patch, cracked.Horizon, wrong), "area of the cracks");
  wrong.insert(wrong.end(), closing.begin(), closing.begin() + 3);
  CHECK_EQUAL(check(wrong), std::string());
  std::swap(wrong[0], wrong[1]);
  CHECK_EQUAL(check(wrong), "closing triangle 0 does not turn counter-clockwise");
  wrong = closing;
  wrong.insert(wrong.end(), closing.begin(), closing.begin() + 3);
  CHECK_EQUAL(check(wrong), "closing triangle 0 overlaps another one");
  wrong = closing;
  wrong.insert(wrong.end(), mesh.begin(), mesh.begin() + 3);
  CHECK(check(wrong).find("overlaps the mesh") != std::string::npos);
  outline.OpenEnds.clear();
  CHECK_EQUAL(check(closing), "open ends of cracks");
  outline.IsCutoff.flip();
  CHECK_EQUAL(check(closing), "cutoffs that are closed");
  const CrackedPatch less{ Patches::Columns(patch.Columns.begin() + 12, patch.Columns.end()), patch.Cuts };
  CHECK_EQUAL(ClosingChecker::CheckBlocks(less, cracked.Horizon, closing), "closed over a missing column");
}

/// Without its cut a crack is part of the mesh, and a horizon that is not cut has none.
void TestWithoutCuts()
{
  const CrackedPatch patch = Full(4, 4);
  const Closed closed = Close(patch);
  CheckClosed(closed, 0, "", 0);
  CHECK(CloseFaults({}, Loops(), Cracks()).empty());
}

void TestErrors()
{
  CrackedPatch patch = Full(5, 5);
  CutRow(patch, 0, 1, 1);
  BoundaryOptions options;
  options.Cuts = &patch.Cuts;
  Cracked cracked = Make(patch, options, std::vector<double>(patch.Columns.size(), 0.0));
  const auto close = [&cracked]() { ClosedFaults::Close(cracked, cracked.Horizon); };
  const Cracks right = cracked.Open;
  cracked.Open.Loops = { 1 };
  CHECK_THROWS_WITH(close(), "a crack along loop 1, expected less than the 1 of the boundary");
  cracked.Open = right;
  cracked.Open.OpenEnds.push_back({ 11, 6 }); // from (1, 2) to (1, 1), between the same cutoffs
  CHECK_THROWS_WITH(close(), "crack not closed, from its open end between points 10 and 5");
  cracked.Open.OpenEnds = { { 10, 16 } }; // (1, 3) is inside
  CHECK_THROWS_WITH(close(), "open end of a crack at point 16, where no boundary loop begins");
  cracked.Open.OpenEnds = { { 5, 10 } }; // the wrong way round
  CHECK_THROWS_WITH(close(), "no surface to the left of the edge");
}
}

int TestFaultClosing(int, char*[])
{
  TestInnerCracks();
  TestTurn();
  TestBranches();
  TestRings();
  TestOpenCracks();
  TestGaps();
  TestSmallPatches();
  TestLongOpenEnds();
  TestChecker();
  TestWithoutCuts();
  TestErrors();
  return Check::Result();
}
