// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which columns are gaps, and their order.

#include "HoleFixtures.h"

#include "Common/Horizon/PlaneGeometry.h"
#include "Tools/Check.h"

#include <array>
#include <utility>

using namespace HoleFixtures;

namespace
{
/// The columns of the bounding box, and a rim of one around it.
class Raster
{
public:
  explicit Raster(const Patches::Columns& columns)
    : Box(columns)
    , Width(this->Box.Greatest.X - this->Box.Least.X + 3)
    , Known(std::size_t(this->Width * (this->Box.Greatest.Y - this->Box.Least.Y + 3)), false)
  {
    for (const PlanePoint& column : columns)
    {
      this->Known[(column.Y - this->Box.Least.Y + 1) * this->Width + column.X - this->Box.Least.X + 1] = true;
    }
  }

  /// The empty columns that are reached from one by steps to the four sides, row by row; not those seen before.
  Patches::Columns Flood(std::int64_t start)
  {
    std::vector<std::int64_t> found;
    std::vector<std::int64_t> open = { start };
    while (!open.empty())
    {
      const std::int64_t place = open.back();
      open.pop_back();
      if (place >= 0 && place < this->Size() && !this->Known[place])
      {
        this->Known[place] = true;
        found.push_back(place);
        const std::int64_t x = place % this->Width;
        const std::array<std::int64_t, 4> steps = { -this->Width, this->Width, x > 0 ? -1 : 0,
          x + 1 < this->Width ? 1 : 0 };
        for (const std::int64_t step : steps)
        {
          open.push_back(place + step);
        }
      }
    }
    std::sort(found.begin(), found.end());
    Patches::Columns columns;
    for (const std::int64_t place : found)
    {
      columns.push_back({ std::int32_t(this->Box.Least.X + place % this->Width - 1),
        std::int32_t(this->Box.Least.Y + place / this->Width - 1) });
    }
    return columns;
  }

  std::int64_t Size() const { return std::int64_t(this->Known.size()); }

private:
  const PlaneBox Box;
  const std::int64_t Width;
  std::vector<bool> Known; // or seen
};

FilledColumns Search(const Patches::Columns& columns, std::int64_t largest)
{
  HoleFillingOptions options = AllHoles(FillMethod::Membrane);
  options.LargestHoleSize = largest;
  return Fill(OnSurface(columns, [](double, double) { return 1.0; }), options);
}

/// By a flood from the corner, and then one from each column that is dry.
void TestRandomPatches()
{
  Patches::Random random(7);
  for (int n = 0; n < 600; ++n)
  {
    const Patches::Columns columns = Patches::Make(Patches::Shape(n % int(Patches::Shape::Count)), random);
    const std::size_t largest = n % 2 == 0 ? 1000000 : 1 + random.Below(9);
    Raster raster(columns);
    raster.Flood(0);
    Patches::Columns expected;
    std::int64_t closed = 0;
    std::int64_t open = 0;
    for (std::int64_t place = 0; place < raster.Size(); ++place)
    {
      const Patches::Columns gap = raster.Flood(place);
      const bool isSmall = gap.size() <= largest;
      expected.insert(expected.end(), gap.begin(), isSmall ? gap.end() : gap.begin());
      closed += isSmall && !gap.empty() ? 1 : 0;
      open += isSmall ? 0 : 1;
    }
    const FilledColumns found = Search(columns, std::int64_t(largest));
    CHECK(found.Column == expected);
    CHECK_EQUAL(found.FilledHoles, closed);
    CHECK_EQUAL(found.OpenHoles, open);
  }
}

std::int64_t CountGaps(const std::vector<std::string>& picture)
{
  return Search(Patches::FromPicture(picture), 1000000).FilledHoles;
}

void TestDiagonals()
{
  // Gaps that touch at a corner are two; a rim that is closed by corners alone is closed.
  CHECK_EQUAL(CountGaps({ "####", "#.##", "##.#", "####" }), 2);
  CHECK_EQUAL(CountGaps({ ".#.", "#.#", ".#." }), 1);
  // An island does not divide the gap around it, one that touches the rim at two corners does.
  CHECK_EQUAL(CountGaps({ "#####", "#...#", "#.#.#", "#...#", "#####" }), 1);
  CHECK_EQUAL(CountGaps({ "####", "#.##", "##.#", "#.##", "####" }), 3);
}
}

int TestHoleSearch(int, char*[])
{
  TestRandomPatches();
  TestDiagonals();
  return Check::Result();
}
