// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Sheets by heights in any unit. What becomes of horizons of voxels is in TestHorizonSheets.

#include "Common/ColumnSheets.h"
#include "Tools/Check.h"

#include <algorithm>
#include <cstddef>
#include <vector>

using namespace SeismicHorizons;

namespace
{
void HeightsMayBeFractionsAndLarge()
{
  // Two columns, each with a point at the least and at the largest height there is.
  const std::vector<int> i = { 0, 0, 1, 1 };
  const std::vector<int> j(4, 7);
  CHECK(FindSheets(i.data(), j.data(), { -1.7e308, 1.7e308, 1.7e308, -1.7e308 }) == std::vector<int>({ 0, 1, 1, 0 }));
  CHECK(FindSheets(i.data(), j.data(), { 0.25, 0.5, 0.375, 0.625 }) == std::vector<int>({ 0, 1, 0, 1 }));
}

void NoPointsNoSheets()
{
  CHECK(FindSheets(nullptr, nullptr, {}).empty());
}

/// Points of all horizons under one name, or of a well: comparing each with each would take hours, and all memory.
void PilesAreQuick()
{
  constexpr std::size_t pile = 100000;
  std::vector<int> i;
  std::vector<double> heights;
  for (int column = 0; column < 2; ++column)
  {
    for (std::size_t n = 0; n < pile; ++n)
    {
      i.push_back(column);
      heights.push_back(double(n));
    }
  }
  const std::vector<int> j(i.size(), 0);
  const std::vector<int> sheets = FindSheets(i.data(), j.data(), heights);
  CHECK_EQUAL(std::count(sheets.begin(), sheets.end(), -1), std::ptrdiff_t(2 * (pile - MostSheets)));
  for (int sheet = 0; sheet < MostSheets; ++sheet)
  {
    CHECK_EQUAL(sheets[std::size_t(sheet)], sheet);
    CHECK_EQUAL(sheets[pile + std::size_t(sheet)], sheet);
  }
}
}

int TestColumnSheets(int, char*[])
{
  HeightsMayBeFractionsAndLarge();
  NoPointsNoSheets();
  PilesAreQuick();
  return Check::Result();
}
