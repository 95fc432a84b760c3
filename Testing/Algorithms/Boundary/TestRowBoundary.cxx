// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Indices without an array of columns, and boundaries without a number per point: both give what those with arrays
// give.

#include "Filters/Algorithms/Boundary/ExteriorBoundary.h"
#include "Tools/Check.h"
#include "Tools/Patches.h"

#include <algorithm>
#include <vector>

using namespace SeismicHorizons;

namespace
{
constexpr int NumberOfHorizons = 3000;

ColumnIndex IndexByRow(const Patches::Columns& columns, const PlaneBox& box, std::int32_t rim = 1)
{
  return { box, rim,
    [&columns](auto&& add)
    {
      for (const PlanePoint& column : columns)
      {
        add(column);
      }
    } };
}

ColumnIndex IndexByRow(const Patches::Columns& columns)
{
  return IndexByRow(columns, PlaneBox(columns));
}

/// Columns of a lattice that are there or not.
class Sheet
{
public:
  Sheet(std::int32_t width, std::int32_t height)
    : Width(width)
    , Height(height)
    , IsThere(std::size_t(width) * std::size_t(height), false)
  {
  }

  void Fill(const PlanePoint& least, const PlanePoint& greatest, bool isThere)
  {
    for (std::int32_t y = std::max(0, least.Y); y <= std::min(greatest.Y, this->Height - 1); ++y)
    {
      for (std::int32_t x = std::max(0, least.X); x <= std::min(greatest.X, this->Width - 1); ++x)
      {
        this->IsThere[std::size_t(y * this->Width + x)] = isThere;
      }
    }
  }

  PlanePoint RandomColumn(Patches::Random& random) const
  {
    return { random.Below(this->Width), random.Below(this->Height) };
  }

  /// Row by row, with the first column at `origin`.
  Patches::Columns List(const PlanePoint& origin) const
  {
    Patches::Columns columns;
    for (std::size_t n = 0; n < this->IsThere.size(); ++n)
    {
      if (this->IsThere[n])
      {
        columns.push_back({ origin.X + std::int32_t(n) % this->Width, origin.Y + std::int32_t(n) / this->Width });
      }
    }
    return columns;
  }

private:
  const std::int32_t Width;
  const std::int32_t Height;
  std::vector<bool> IsThere;
};

/// Rectangles inside each other, which are holes and islands by turns.
void AddRings(Sheet& sheet, Patches::Random& random)
{
  PlanePoint least = sheet.RandomColumn(random);
  PlanePoint greatest{ least.X + random.Below(40), least.Y + random.Below(20) };
  for (bool isThere = random.Chance(0.3); least.X <= greatest.X && least.Y <= greatest.Y; isThere = !isThere)
  {
    sheet.Fill(least, greatest, isThere);
    const int width = 1 + random.Below(3);
    least = { least.X + width, least.Y + width };
    greatest = { greatest.X - width, greatest.Y - width };
  }
}

/// Strips of one column, present or missing, and single columns.
void AddStrips(Sheet& sheet, Patches::Random& random)
{
  const PlanePoint least = sheet.RandomColumn(random);
  const int length = random.Chance(0.5) ? 0 : random.Below(30);
  const bool isUpright = random.Chance(0.5);
  sheet.Fill(least, { least.X + (isUpright ? 0 : length), least.Y + (isUpright ? length : 0) }, random.Chance(0.5));
}

/// Rows are longer than 64 columns in most horizons.
Patches::Columns MakeHorizon(Patches::Random& random)
{
  const std::int32_t width = 1 + random.Below(200);
  const std::int32_t height = 1 + random.Below(40);
  Sheet sheet(width, height);
  const PlanePoint least = sheet.RandomColumn(random);
  sheet.Fill({ least.X / 4, least.Y / 4 }, { width - 1 - least.Y / 8, height - 1 - least.X / 8 }, true);
  for (int n = random.Below(12); n > 0; --n)
  {
    AddRings(sheet, random);
  }
  for (int n = random.Below(2) * random.Below(40); n > 0; --n)
  {
    AddStrips(sheet, random);
  }
  return sheet.List({ random.Below(2000) - 1000, random.Below(2000) - 1000 });
}

BoundaryOptions RandomOptions(Patches::Random& random)
{
  BoundaryOptions options;
  options.KeepHoles = random.Chance(0.75);
  options.SmallestHoleSize = 1 + random.Below(3) * random.Below(40);
  options.MinimumPatchSize = 1 + random.Below(2) * random.Below(30);
  return options;
}

bool AreEqual(const Loops& a, const Loops& b)
{
  bool areEqual = a.Size() == b.Size();
  for (std::size_t loop = 0; areEqual && loop < a.Size(); ++loop)
  {
    areEqual = std::equal(a.begin(loop), a.end(loop), b.begin(loop), b.end(loop));
  }
  return areEqual;
}

/// Returns whether all is equal.
bool Compare(const Patches::Columns& columns, const BoundaryOptions& options)
{
  const ExteriorBoundary expected = FindExteriorBoundary(columns, options);
  const RowBoundary found = FindExteriorBoundary(IndexByRow(columns), options);
  std::vector<std::int32_t> patches;
  std::vector<std::int64_t> sizes(expected.NumberOfPatches, 0);
  for (std::size_t point = 0; point < columns.size(); ++point)
  {
    patches.push_back(found.Patches.PatchAt(PointId(point)));
    if (expected.Patch[point] != NoPatch)
    {
      ++sizes[std::size_t(expected.Patch[point])];
    }
  }
  return CHECK(AreEqual(found.Boundary, expected.Boundary)) && CHECK(patches == expected.Patch) &&
    CHECK_EQUAL(found.NumberOfPatches, expected.NumberOfPatches) && CHECK(found.PatchSizes == sizes);
}

void TestRandomHorizons()
{
  Patches::Random random(31);
  for (int n = 0; n < NumberOfHorizons; ++n)
  {
    const Patches::Columns columns = MakeHorizon(random);
    for (int which = 0; which < 4; ++which)
    {
      if (!columns.empty() && !Compare(columns, RandomOptions(random)))
      {
        std::cerr << "horizon " << n << '\n';
        return;
      }
    }
  }
}

void TestRandomPatches()
{
  Patches::Random random(32);
  for (int n = 0; n < NumberOfHorizons; ++n)
  {
    Patches::Columns columns = Patches::Make(Patches::Shape(n % int(Patches::Shape::Count)), random);
    std::sort(columns.begin(), columns.end(), PrecedesByRow);
    if (!Compare(columns, RandomOptions(random)))
    {
      std::cerr << "patch " << n << '\n';
      return;
    }
  }
}

/// The island in the open hole is a patch, the one in the filled hole belongs to the patch around it.
void TestSpans()
{
  const Patches::Columns columns = Patches::FromPicture({
    "#########",
    "#...#...#",
    "#.#.#.#.#",
    "#...##..#",
    "#########",
  });
  BoundaryOptions options;
  options.KeepHoles = true;
  options.SmallestHoleSize = 9;
  RowBoundary boundary = FindExteriorBoundary(IndexByRow(columns), options);
  CHECK_EQUAL(boundary.NumberOfPatches, 2u);
  CHECK_EQUAL(boundary.Boundary.Size(), 3u);
  CHECK((boundary.PatchSizes == std::vector<std::int64_t>{ std::int64_t(columns.size()) - 1, 1 }));
  CHECK_EQUAL(boundary.Patches.NumberOfSpans(), 3u);
  options.MinimumPatchSize = 2;
  boundary = FindExteriorBoundary(IndexByRow(columns), options);
  CHECK_EQUAL(boundary.NumberOfPatches, 1u);
  CHECK_EQUAL(
    std::count_if(columns.begin(), columns.end(),
      [&](const PlanePoint& column) { return boundary.Patches.PatchAt(PointId(&column - columns.data())) == NoPatch; }),
    1);
}

/// Columns come back from the bits, from an array, and from an array in another order.
void TestColumnsOfPoints()
{
  Patches::Random random(33);
  for (int n = 0; n < 300; ++n)
  {
    Patches::Columns columns = MakeHorizon(random);
    PlaneBox box(columns);
    box.Add({ -1000, -1000 });
    box.Add({ 1300, 1100 });
    const ColumnIndex byRow = IndexByRow(columns, box, random.Below(3));
    const ColumnIndex ordered(columns);
    CHECK_EQUAL(byRow.NumberOfPoints(), columns.size());
    CHECK(byRow.IsRowMajor() && ordered.IsRowMajor() && byRow.Columns().empty());
    bool areEqual = true;
    for (std::size_t point = 0; point < columns.size(); ++point)
    {
      areEqual = areEqual && byRow.ColumnOf(PointId(point)) == columns[point] &&
        byRow.PlaceOf(PointId(point)) == byRow.Place(columns[point]) &&
        byRow.PointAt(columns[point]) == PointId(point) && ordered.ColumnOf(PointId(point)) == columns[point] &&
        byRow.Rank(byRow.PlaceOf(PointId(point))) == std::int64_t(point);
    }
    CHECK(areEqual);
    std::reverse(columns.begin(), columns.end());
    const ColumnIndex reversed(columns);
    CHECK_EQUAL(reversed.NumberOfPoints(), columns.size());
    CHECK(columns.size() < 2 || !reversed.IsRowMajor());
    CHECK(columns.empty() || reversed.ColumnOf(0) == columns.front());
  }
}

void TestErrorsAndEmpty()
{
  const Patches::Columns columns{ { 3, 7 }, { 4, 7 } };
  BoundaryOptions options;
  CHECK_THROWS_WITH(IndexByRow({ { 3, 7 }, { 4, 7 }, { 4, 7 } }),
    "points 1 and 2 both in column (4, 7), expected at most one point of a horizon in a column");
  options.Radius = 2;
  CHECK_THROWS_WITH(FindExteriorBoundary(IndexByRow(columns), options),
    "a radius of 2 columns for a horizon that is larger than memory, expected 1");
  options.Radius = 0;
  CHECK_THROWS_WITH(FindExteriorBoundary(IndexByRow(columns), options), "radius 0, expected 1 to 32 columns");
  options.Radius = 1;
  const LinkCuts cuts{ PlaneBox(columns) };
  options.Cuts = &cuts;
  CHECK_THROWS_WITH(FindExteriorBoundary(IndexByRow(columns), options),
    "faulted links for a horizon that is larger than memory, expected none");
  options.Cuts = nullptr;
  options.MinimumPatchSize = 2;
  CHECK_EQUAL(FindExteriorBoundary(IndexByRow({}), options).Boundary.Size(), 0u);
  CHECK_EQUAL(FindExteriorBoundary(IndexByRow({}, PlaneBox(columns)), options).Boundary.Size(), 0u);
}
}

int TestRowBoundary(int, char*[])
{
  TestRandomHorizons();
  TestRandomPatches();
  TestSpans();
  TestColumnsOfPoints();
  TestErrorsAndEmpty();
  return Check::Result();
}
