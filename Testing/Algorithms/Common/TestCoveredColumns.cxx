// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which columns loops and triangles cover, and the ledger of points.

#include "Common/Horizon/CoveredColumns.h"
#include "Common/Horizon/Predicates.h"
#include "Tools/Check.h"

#include <algorithm>
#include <random>
#include <vector>

namespace
{
using namespace SeismicHorizons;

constexpr std::int32_t Size = 12;

bool IsIn(const PlanePoint& p, const PlanePoint& a, const PlanePoint& b, const PlanePoint& c)
{
  const std::int64_t sides[3] = { SignedArea(a, b, p), SignedArea(b, c, p), SignedArea(c, a, p) };
  const auto [least, greatest] = std::minmax_element(sides, sides + 3);
  return SignedArea(a, b, c) != 0 && (*least >= 0 || *greatest <= 0);
}

Ledger AccountAll(
  const CoveredColumns& covered, PlanePoints columns, const std::vector<unsigned char>& filled, const KeptPoints& kept)
{
  Ledger ledger = covered.Account(columns, filled, kept);
  covered.Bridge(ledger);
  return ledger;
}

std::vector<PlanePoint> AllColumns()
{
  std::vector<PlanePoint> columns;
  for (std::int32_t n = 0; n < Size * Size; ++n)
  {
    columns.push_back({ n % Size, n / Size });
  }
  return columns;
}

/// Against the definition, triangles of any size and place that overlap.
void TestTriangles(std::int32_t subVoxels)
{
  std::mt19937 random(7);
  std::uniform_int_distribution<std::int32_t> place(0, (Size - 1) * subVoxels);
  const std::vector<PlanePoint> columns = AllColumns();
  for (int run = 0; run < 300; ++run)
  {
    std::vector<PlanePoint> corners(std::size_t(3 * (1 + run % 4)));
    Loops triangles;
    for (PlanePoint& corner : corners)
    {
      corner = { place(random), place(random) };
    }
    for (PointId corner = 0; corner < PointId(corners.size()); corner += 3)
    {
      const std::int64_t area = SignedArea(corners[corner], corners[corner + 1], corners[corner + 2]);
      if (area != 0)
      {
        triangles.Append(corner);
        triangles.Append(corner + (area < 0 ? 1 : 2));
        triangles.Append(corner + (area < 0 ? 2 : 1));
        triangles.Close();
      }
    }
    std::int64_t expected = 0;
    for (const PlanePoint& column : columns)
    {
      const PlanePoint p = { column.X * subVoxels, column.Y * subVoxels };
      bool isCovered = false;
      for (std::size_t n = 0; n < corners.size(); n += 3)
      {
        isCovered = isCovered || IsIn(p, corners[n], corners[n + 1], corners[n + 2]);
      }
      expected += isCovered ? 1 : 0;
    }
    const CoveredColumns covered(corners, triangles, subVoxels);
    CHECK_EQUAL(covered.Count(), expected);
    const Ledger ledger = AccountAll(covered, columns, {}, KeptPoints::All(columns.size()));
    CHECK_EQUAL(ledger[LedgerEntry::Known], expected);
    CHECK_EQUAL(ledger[LedgerEntry::Bridged], 0);
    CHECK_EQUAL(ledger.Read(), std::int64_t(columns.size()));
  }
}

Loops ToLoops(const std::vector<std::vector<PointId>>& lists)
{
  Loops loops;
  for (const std::vector<PointId>& list : lists)
  {
    std::for_each(list.begin(), list.end(), [&loops](PointId point) { loops.Append(point); });
    loops.Close();
  }
  return loops;
}

/// A rectangle with a hole, a spur to its right, a row of points and a point of their own.
///
///     2  o---o---o
///        |\     /|
///     1  |  o-o  o---o---o   o---o   o
///        | /   \ |
///     0  o---o---o
const std::vector<PlanePoint> Vertices = { { 0, 0 }, { 0, 4 }, { 8, 4 }, { 8, 2 }, { 10, 2 }, { 8, 0 }, { 2, 2 },
  { 4, 3 }, { 4, 1 }, { 0, 6 }, { 3, 6 }, { 6, 6 } };

void TestLoops()
{
  const Loops loops = ToLoops({ { 0, 1, 2, 3, 4, 3, 5 }, { 6, 8, 7 }, { 9, 10 }, { 11 } });
  // All of 9 x 5 but for (3, 2), which alone is strictly inside the hole.
  const CoveredColumns covered(Vertices, loops, 1);
  CHECK_EQUAL(covered.Count(), 44);
  const std::vector<PlanePoint> points = { { 0, 0 }, { 4, 3 }, { 8, 2 }, { 3, 2 }, { 9, 2 }, { 10, 2 }, { 2, 6 },
    { 6, 6 }, { 5, 2 }, { 6, 2 }, { 11, 11 } };
  const Ledger ledger =
    AccountAll(covered, points, { 0, 0, 0, 0, 0, 0, 0, 0, 1, 2, 1 }, KeptPoints::All(points.size()));
  CHECK_EQUAL(ledger[LedgerEntry::Known], 3);
  CHECK_EQUAL(ledger[LedgerEntry::Filled], 1);
  CHECK_EQUAL(ledger[LedgerEntry::Extrapolated], 1);
  CHECK_EQUAL(ledger[LedgerEntry::Bridged], 39);
  CHECK_EQUAL(ledger[LedgerEntry::LeftOut], 5);

  KeptPoints kept(points.size());
  kept.AppendRun(1, points.size() - 1);
  const Ledger without = AccountAll(covered, points, {}, kept); // the first one is covered, and dropped
  CHECK_EQUAL(without[LedgerEntry::Known], 4);
  CHECK_EQUAL(without[LedgerEntry::Bridged], 40);
  CHECK_EQUAL(without[LedgerEntry::LeftOut], 7);
}

void TestCoverOnly()
{
  Ledger ledger;
  ledger.Columns = { 100, 5, 10, 3, 2 };
  ledger.CoverOnly(120);
  CHECK_EQUAL(ledger[LedgerEntry::Bridged], 12);
  ledger.CoverOnly(90);
  CHECK_EQUAL(ledger[LedgerEntry::Bridged], 0);
  CHECK_EQUAL(ledger[LedgerEntry::Known], 82);
  CHECK_EQUAL(ledger[LedgerEntry::LeftOut], 20);
  ledger.CoverOnly(4);
  CHECK_EQUAL(ledger[LedgerEntry::Filled], 1);
  CHECK_EQUAL(ledger.Covered(), 4);
  CHECK_EQUAL(ledger.Read(), 102);
}
}

int TestCoveredColumns(int, char*[])
{
  TestTriangles(1);
  TestTriangles(1 << 10);
  TestLoops();
  TestCoverOnly();
  return Check::Result();
}
