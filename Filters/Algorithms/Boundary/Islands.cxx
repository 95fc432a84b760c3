// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A component lies inside a loop when its first point does. So the rows with first points are read from left to right:
// at each place it is known inside which loops it is, as every loop that the row crosses is entered or left there.

#include "Islands.h"

#include <algorithm>
#include <numeric>

namespace SeismicHorizons
{
namespace
{
/// Where a loop crosses a row.
struct Crossing
{
  double X;
  std::size_t Loop;
};

using PlaceVisitor = std::function<void(std::size_t, const std::vector<std::size_t>&)>;

class LoopReader
{
public:
  LoopReader(const std::vector<PlanePoint>& columns, const ColumnRaster& raster,
    const std::vector<std::int64_t>& places, const Loops& loops)
    : Columns(columns)
    , Raster(raster)
    , Places(places)
    , Boundary(loops)
    , RowNumber(std::size_t(raster.Height()), -1)
  {
  }

  void Run(const PlaceVisitor& visit)
  {
    this->NumberRows();
    this->FindCrossings();
    std::size_t place = 0;
    for (std::vector<Crossing>& crossings : this->Crossings)
    {
      std::sort(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) { return a.X < b.X; });
      place = this->ReadRow(crossings, place, visit);
    }
  }

private:
  std::int64_t RowOf(std::int64_t place) const { return place / this->Raster.Width(); }
  std::int64_t ColumnOf(std::int64_t place) const { return place % this->Raster.Width(); }

  /// Numbers the rows that have places.
  void NumberRows()
  {
    std::int32_t rows = 0;
    for (const std::int64_t place : this->Places)
    {
      std::int32_t& number = this->RowNumber[std::size_t(this->RowOf(place))];
      number = number < 0 ? rows++ : number;
    }
    this->Crossings.resize(std::size_t(rows));
  }

  void FindCrossings()
  {
    for (std::size_t loop = 0; loop < this->Boundary.Size(); ++loop)
    {
      this->Boundary.ForEachEdgeOf(loop,
        [&](PointId from, PointId to)
        {
          const std::int64_t a = this->Raster.Place(this->Columns[std::size_t(from)]);
          const std::int64_t b = this->Raster.Place(this->Columns[std::size_t(to)]);
          this->AddCrossings(std::min(a, b), std::max(a, b), loop);
        });
    }
  }

  /// The row of the upper end is left to the hop that goes on from there. No hop passes a point by less than 1 / k
  /// columns, so that rounding does not matter.
  void AddCrossings(std::int64_t low, std::int64_t high, std::size_t loop)
  {
    const std::int64_t rows = std::max<std::int64_t>(1, this->RowOf(high) - this->RowOf(low));
    const double slope = double(this->ColumnOf(high) - this->ColumnOf(low)) / double(rows);
    for (std::int64_t row = this->RowOf(low); row < this->RowOf(high); ++row)
    {
      const std::int32_t number = this->RowNumber[std::size_t(row)];
      if (number >= 0)
      {
        const double x = double(this->ColumnOf(low)) + slope * double(row - this->RowOf(low));
        this->Crossings[std::size_t(number)].push_back({ x, loop });
      }
    }
  }

  /// Visits the places in the row of one, and returns the next place.
  std::size_t ReadRow(const std::vector<Crossing>& crossings, std::size_t place, const PlaceVisitor& visit)
  {
    const std::int64_t row = this->RowOf(this->Places[place]);
    std::vector<std::size_t> around; // loops; few lie around a place
    auto next = crossings.begin();
    for (; place < this->Places.size() && this->RowOf(this->Places[place]) == row; ++place)
    {
      for (; next != crossings.end() && next->X < double(this->ColumnOf(this->Places[place])); ++next)
      {
        EnterOrLeave(around, next->Loop);
      }
      visit(place, around);
    }
    return place;
  }

  static void EnterOrLeave(std::vector<std::size_t>& around, std::size_t loop)
  {
    const auto found = std::find(around.begin(), around.end(), loop);
    if (found == around.end())
    {
      around.push_back(loop);
    }
    else
    {
      around.erase(found);
    }
  }

  const std::vector<PlanePoint>& Columns;
  const ColumnRaster& Raster;
  const std::vector<std::int64_t>& Places;
  const Loops& Boundary;
  std::vector<std::int32_t> RowNumber; // for each row of the raster, or -1
  std::vector<std::vector<Crossing>> Crossings; // by the number of the row
};

/// The patch at a place inside some loops, or -1. From outside to inside, outlines of patches and loops of holes take
/// turns when those of islands that belong to another patch are left out.
std::int32_t InnermostPatch(const std::vector<std::size_t>& around, const std::vector<std::int32_t>& patchOf)
{
  std::int32_t innermost = -1;
  std::size_t outlines = 0;
  std::size_t holes = 0;
  for (const std::size_t loop : around)
  {
    const bool isHole = loop >= patchOf.size();
    holes += isHole ? 1 : 0;
    if (!isHole && patchOf[loop] == std::int32_t(loop))
    {
      ++outlines;
      innermost = std::max(innermost, std::int32_t(loop));
    }
  }
  return outlines > holes ? innermost : -1;
}
}

//----------------------------------------------------------------------------------------------------------------------
void ForEachPlaceInLoops(const std::vector<PlanePoint>& columns, const ColumnRaster& raster,
  const std::vector<std::int64_t>& places, const Loops& loops, const PlaceVisitor& visit)
{
  LoopReader(columns, raster, places, loops).Run(visit);
}

//----------------------------------------------------------------------------------------------------------------------
// Components are met from below, so that each is met after the one around it, and an island in an island after both.
std::vector<std::int32_t> AssignIslands(const std::vector<PlanePoint>& columns, const ColumnRaster& raster,
  const std::vector<std::int64_t>& first, const Loops& loops)
{
  std::vector<std::int32_t> patchOf(first.size());
  std::iota(patchOf.begin(), patchOf.end(), 0);
  if (first.size() > 1)
  {
    ForEachPlaceInLoops(columns, raster, first, loops,
      [&patchOf](std::size_t part, const std::vector<std::size_t>& around)
      {
        const std::int32_t patch = InnermostPatch(around, patchOf);
        patchOf[part] = patch < 0 ? std::int32_t(part) : patch;
      });
  }
  return patchOf;
}
}
