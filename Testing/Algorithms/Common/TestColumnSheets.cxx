// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Sheets by heights in any unit. What becomes of horizons of voxels is in TestHorizonSheets.

#include "Common/Survey/ColumnSheets.h"
#include "Tools/Check.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

using namespace SeismicHorizons;

namespace
{
/// The sheet of each point; -1 for one that is dropped.
std::vector<int> FindSheets(PlanePoints columns, const std::vector<double>& heights)
{
  const ColumnSheets sheets = SplitIntoSheets(columns, heights);
  std::vector<int> sheetOf(heights.size(), -1);
  for (std::size_t sheet = 0; sheet < sheets.Points.size(); ++sheet)
  {
    CHECK(std::is_sorted(sheets.Points[sheet].begin(), sheets.Points[sheet].end()));
    for (const std::int32_t point : sheets.Points[sheet])
    {
      CHECK_EQUAL(sheetOf[point], -1);
      sheetOf[point] = int(sheet);
    }
  }
  CHECK_EQUAL(sheets.Dropped, std::count(sheetOf.begin(), sheetOf.end(), -1));
  return sheetOf;
}

void HeightsMayBeFractionsAndLarge()
{
  // Two columns, each with a point at the least and at the largest height there is.
  const std::vector<PlanePoint> columns = { { 0, 7 }, { 0, 7 }, { 1, 7 }, { 1, 7 } };
  CHECK(FindSheets(columns, { -1.7e308, 1.7e308, 1.7e308, -1.7e308 }) == std::vector<int>({ 0, 1, 1, 0 }));
  CHECK(FindSheets(columns, { 0.25, 0.5, 0.375, 0.625 }) == std::vector<int>({ 0, 1, 0, 1 }));
}

void NoPointsNoSheets()
{
  CHECK(FindSheets({}, {}).empty());
  CHECK_EQUAL(SplitIntoSheets({}, {}).Points.size(), 1U);
}

/// Layers are linked to each other where the dip of a column is about their distance.
void NothingIsLostOnDips()
{
  for (int distance = 1; distance < 12; ++distance)
  {
    std::vector<PlanePoint> columns;
    std::vector<double> heights;
    for (int j = 0; j < 10; ++j)
    {
      for (int i = 0; i < 12; ++i)
      {
        for (int layer = 0; layer < (j < 4 ? 2 : 1); ++layer)
        {
          columns.push_back({ i, j });
          heights.push_back(i + 2.0 * j + 0.5 * distance * layer);
        }
      }
    }
    const std::vector<int> sheets = FindSheets(columns, heights);
    CHECK_EQUAL(std::count(sheets.begin(), sheets.end(), 0), 120);
    CHECK_EQUAL(std::count(sheets.begin(), sheets.end(), 1), 48);
  }
}

/// Points of all horizons under one name, or of a well: comparing each with each would take hours, and all memory.
void PilesAreQuick()
{
  constexpr std::size_t pile = 100000;
  std::vector<PlanePoint> columns;
  std::vector<double> heights;
  for (int column = 0; column < 2; ++column)
  {
    for (std::size_t n = 0; n < pile; ++n)
    {
      columns.push_back({ column, 0 });
      heights.push_back(double(n));
    }
  }
  const std::vector<int> sheets = FindSheets(columns, heights);
  CHECK_EQUAL(std::count(sheets.begin(), sheets.end(), -1), std::ptrdiff_t(2 * (pile - MostSheets)));
  for (int sheet = 0; sheet < MostSheets; ++sheet)
  {
    CHECK_EQUAL(sheets[sheet], sheet);
    CHECK_EQUAL(sheets[pile + sheet], sheet);
  }
}
}

int TestColumnSheets(int, char*[])
{
  HeightsMayBeFractionsAndLarge();
  NoPointsNoSheets();
  NothingIsLostOnDips();
  PilesAreQuick();
  return Check::Result();
}
