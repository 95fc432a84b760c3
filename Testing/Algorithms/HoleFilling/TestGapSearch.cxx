// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HoleFilling/GapSearch.h"
#include "Tools/Check.h"
#include "Tools/Patches.h"

#include <set>
#include <utility>

using namespace SeismicHorizons;

namespace
{
using Places = std::set<std::int64_t>;

std::vector<Places> Search(const ColumnRaster& raster)
{
  const GapList gaps = FindGaps(raster);
  std::vector<Places> result(gaps.Size());
  for (std::size_t gap = 0; gap < gaps.Size(); ++gap)
  {
    for (const GapRun* run = gaps.begin(gap); run != gaps.end(gap); ++run)
    {
      for (std::int64_t place = run->First; place <= run->Last; ++place)
      {
        CHECK(result[gap].insert(place).second);
        CHECK_EQUAL(raster[place], NoPoint);
      }
    }
    CHECK_EQUAL(std::int64_t(result[gap].size()), gaps.Columns[gap]);
  }
  return result;
}

/// The empty places that are reached from one by steps to the four sides.
Places Flood(const ColumnRaster& raster, std::int64_t start, Places& seen)
{
  Places found;
  std::vector<std::int64_t> open = { start };
  while (!open.empty())
  {
    const std::int64_t place = open.back();
    open.pop_back();
    const bool isInside = place >= 0 && place < raster.Width() * raster.Height();
    if (isInside && raster[place] == NoPoint && seen.insert(place).second)
    {
      found.insert(place);
      const std::int64_t x = place % raster.Width();
      for (const std::int64_t step :
        { -raster.Width(), raster.Width(), x > 0 ? -1L : 0L, x + 1 < raster.Width() ? 1L : 0L })
      {
        open.push_back(place + step);
      }
    }
  }
  return found;
}

/// By a flood from the corner, and then one from each place that is dry.
void TestRandomPatches()
{
  Patches::Random random(7);
  for (int n = 0; n < 600; ++n)
  {
    const ColumnRaster raster(Patches::Make(Patches::Shape(n % int(Patches::Shape::Count)), random), 1 + n % 3);
    Places seen;
    Flood(raster, 0, seen);
    std::vector<Places> expected;
    for (std::int64_t place = 0; place < raster.Width() * raster.Height(); ++place)
    {
      Places gap = Flood(raster, place, seen);
      if (!gap.empty())
      {
        expected.push_back(std::move(gap));
      }
    }
    CHECK(Search(raster) == expected);
  }
}

void TestDiagonals()
{
  // Gaps that touch at a corner are two; a rim that is closed by corners alone is closed.
  CHECK_EQUAL(Search(ColumnRaster(Patches::FromPicture({ "####", "#.##", "##.#", "####" }))).size(), 2u);
  CHECK_EQUAL(Search(ColumnRaster(Patches::FromPicture({ ".#.", "#.#", ".#." }))).size(), 1u);
  // An island does not divide the gap around it, one that touches the rim at two corners does.
  CHECK_EQUAL(Search(ColumnRaster(Patches::FromPicture({ "#####", "#...#", "#.#.#", "#...#", "#####" }))).size(), 1u);
  CHECK_EQUAL(Search(ColumnRaster(Patches::FromPicture({ "####", "#.##", "##.#", "#.##", "####" }))).size(), 3u);
}
}

int TestGapSearch(int, char*[])
{
  TestRandomPatches();
  TestDiagonals();
  return Check::Result();
}
