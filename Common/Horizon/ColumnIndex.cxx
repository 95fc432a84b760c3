// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ColumnIndex.h"

#include "Common/Base/FixedChunks.h"
#include "PlaneGeometry.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

namespace SeismicHorizons
{
namespace
{
// Above both limits empty bands are narrowed.
constexpr std::int64_t EnoughColumnsPerPoint = 16;
constexpr std::int64_t EnoughDenseColumns = 1 << 20;

/// Throws InputError if two points share a column.
void CheckColumns(PlanePoints columns)
{
  std::vector<PointId> order(columns.size());
  std::iota(order.begin(), order.end(), 0);
  const auto column = [&columns](PointId point) -> const PlanePoint& { return columns[std::size_t(point)]; };
  std::stable_sort(order.begin(), order.end(), [&](PointId a, PointId b) { return column(a) < column(b); });
  const auto twin =
    std::adjacent_find(order.begin(), order.end(), [&](PointId a, PointId b) { return column(a) == column(b); });
  if (twin != order.end())
  {
    throw SameColumnError(*twin, *(twin + 1), column(*twin));
  }
}

void Narrow(std::vector<PlanePoint>& columns, std::int32_t PlanePoint::*axis, std::int32_t widest)
{
  std::vector<std::int32_t> before;
  before.reserve(columns.size());
  std::transform(columns.begin(), columns.end(), std::back_inserter(before),
    [axis](const PlanePoint& column) { return column.*axis; });
  std::sort(before.begin(), before.end());
  before.erase(std::unique(before.begin(), before.end()), before.end());
  std::vector<std::int32_t> after(before.size(), 0);
  for (std::size_t n = 1; n < before.size(); ++n)
  {
    after[n] = after[n - 1] + std::int32_t(std::min<std::int64_t>(std::int64_t(before[n]) - before[n - 1], widest));
  }
  for (PlanePoint& column : columns)
  {
    const auto found = std::lower_bound(before.begin(), before.end(), column.*axis);
    column.*axis = after[std::size_t(found - before.begin())];
  }
}

std::vector<std::int32_t> ListGiven(
  PlanePoints given, PlanePoints narrow, std::int32_t PlanePoint::*axis, std::int64_t least, std::int64_t size)
{
  constexpr std::int32_t unknown = std::numeric_limits<std::int32_t>::min();
  std::vector<std::int32_t> result(std::size_t(size), unknown);
  const PlaneBox box(given);
  result.front() = box.Least.*axis + std::int32_t(least); // The least narrow coordinate is 0.
  for (std::size_t n = 0; n < given.size(); ++n)
  {
    result[std::size_t(narrow[n].*axis - least)] = given[n].*axis;
  }
  for (std::size_t n = 1; n < result.size(); ++n)
  {
    result[n] = result[n] == unknown ? result[n - 1] + 1 : result[n];
  }
  return result;
}
}

//----------------------------------------------------------------------------------------------------------------------
InputError SameColumnError(PointId first, PointId second, const PlanePoint& column)
{
  return InputError("points " + std::to_string(first) + " and " + std::to_string(second) + " both in column (" +
    std::to_string(column.X) + ", " + std::to_string(column.Y) +
    "), expected at most one point of a horizon in a column");
}

//----------------------------------------------------------------------------------------------------------------------
ColumnRows ColumnRows::Of(PlanePoints columns)
{
  return AddUpChunks<ColumnRows>(std::int64_t(columns.size()), ChunkSize, Monitor(),
    [&](ColumnRows& rows, std::int64_t first, std::int64_t last)
    {
      std::for_each(
        columns.begin() + first, columns.begin() + last, [&rows](const PlanePoint& column) { rows.Add(Of(column)); });
    });
}

//----------------------------------------------------------------------------------------------------------------------
bool AreScattered(PlanePoints columns)
{
  if (columns.empty())
  {
    return false;
  }
  const PlaneBox box = ColumnRows::Of(columns).Box;
  const double width = double(box.Greatest.X) - box.Least.X + 1.0;
  const double height = double(box.Greatest.Y) - box.Least.Y + 1.0;
  return width * height > double(std::max(EnoughDenseColumns, EnoughColumnsPerPoint * std::int64_t(columns.size())));
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<PlanePoint> NarrowEmptyBands(PlanePoints columns, int reach)
{
  CheckColumns(columns); // Messages must have the original columns.
  std::vector<PlanePoint> narrow(columns.begin(), columns.end());
  Narrow(narrow, &PlanePoint::X, reach + 1);
  Narrow(narrow, &PlanePoint::Y, reach + 1);
  return narrow;
}

//----------------------------------------------------------------------------------------------------------------------
PlaceSet::PlaceSet(std::int64_t width, std::int64_t height)
  : Width(width)
  , Places(width * height)
  , Margin((width / WordBits + 1) * WordBits)
  , Words(std::size_t((2 * this->Margin + this->Places) / WordBits + 4), 0)
{
}

//----------------------------------------------------------------------------------------------------------------------
ColumnIndex::ColumnIndex(PlanePoints given, std::int32_t rim, int reach)
  : Given(given)
  , Count(std::uint32_t(given.size()))
{
  if (given.empty())
  {
    return;
  }
  if (reach != AllBands && AreScattered(given))
  {
    this->Narrow = NarrowEmptyBands(given, reach);
  }
  const PlanePoints columns = this->Columns();
  const ColumnRows rows = ColumnRows::Of(columns);
  this->SetBox(rows.Box, rim);
  if (!this->Narrow.empty())
  {
    this->GivenX = ListGiven(given, columns, &PlanePoint::X, this->MinX, this->SizeX);
    this->GivenY = ListGiven(given, columns, &PlanePoint::Y, this->MinY, this->SizeY);
  }
  if (rows.AreAscending)
  {
    this->AddRows();
    return;
  }
  for (std::size_t n = 0; n < columns.size(); ++n)
  {
    const std::int64_t place = this->Place(columns[n]);
    if (this->Points.Contains(place))
    {
      const PlanePoint* const first = std::find(columns.begin(), columns.end(), columns[n]);
      throw SameColumnError(PointId(first - columns.begin()), PointId(n), columns[n]);
    }
    this->Points.Add(place);
  }
  this->CountPoints();
  this->SortPoints();
}

//----------------------------------------------------------------------------------------------------------------------
void ColumnIndex::SetBox(const PlaneBox& box, std::int32_t rim)
{
  this->MinX = std::int64_t(box.Least.X) - rim;
  this->MinY = std::int64_t(box.Least.Y) - rim;
  this->SizeX = std::int64_t(box.Greatest.X) + rim + 1 - this->MinX;
  this->SizeY = std::int64_t(box.Greatest.Y) + rim + 1 - this->MinY;
  this->Points = PlaceSet(this->SizeX, this->SizeY);
}

//----------------------------------------------------------------------------------------------------------------------
std::int64_t ColumnIndex::PlaceAtRank(std::uint32_t rank) const
{
  const auto next = std::upper_bound(this->Before.begin(), this->Before.end(), rank);
  const std::int64_t first = (next - this->Before.begin() - 1) * PlaceSet::WordBits;
  std::uint64_t bits = this->Points.WordAt(first);
  for (std::uint32_t before = *std::prev(next); before < rank; ++before)
  {
    bits &= bits - 1;
  }
  return first + LowestBit(bits);
}

//----------------------------------------------------------------------------------------------------------------------
void ColumnIndex::AddRows()
{
  const PlanePoints columns = this->Columns();
  const std::int64_t places = this->NumberOfPlaces();
  this->Before.resize(this->NumberOfWords());
  ForEachChunk(places, ChunkSize, Monitor(),
    [&](std::size_t, std::int64_t first, std::int64_t last)
    {
      const auto isBefore = [this](const PlanePoint& column, std::int64_t place)
      { return this->Place(column) < place; };
      const PlanePoint* column = std::lower_bound(columns.begin(), columns.end(), first, isBefore);
      for (std::int64_t place = first; place < last; place += PlaceSet::WordBits)
      {
        this->Before[std::size_t(place / PlaceSet::WordBits)] = std::uint32_t(column - columns.begin());
        for (; column != columns.end() && this->Place(*column) < place + PlaceSet::WordBits; ++column)
        {
          this->Points.Add(this->Place(*column));
        }
      }
    });
}

//----------------------------------------------------------------------------------------------------------------------
void ColumnIndex::CountPoints()
{
  std::uint32_t count = 0;
  for (std::int64_t place = 0; place < this->NumberOfPlaces(); place += PlaceSet::WordBits)
  {
    this->Before.push_back(count);
    count += std::uint32_t(CountBits(std::uint64_t(this->Points.From(place))));
  }
}

//----------------------------------------------------------------------------------------------------------------------
void ColumnIndex::SortPoints()
{
  const PlanePoints columns = this->Columns();
  std::vector<PointId> order(columns.size());
  for (std::size_t n = 0; n < columns.size(); ++n)
  {
    order[this->Rank(this->Place(columns[n]))] = PointId(n);
  }
  this->Order = std::move(order);
}
}
