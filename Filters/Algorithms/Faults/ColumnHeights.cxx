// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ColumnHeights.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/ColumnIndex.h"

#include <algorithm>
#include <cassert>
#include <string>

namespace SeismicHorizons
{
namespace
{
PlaneBox FindBox(PlanePoints columns)
{
  if (columns.empty())
  {
    throw InputError("no points, expected a horizon");
  }
  return PlaneBox(columns);
}

std::int64_t FindIn(const std::vector<std::int64_t>& kept, std::int64_t coordinate)
{
  const auto found = std::lower_bound(kept.begin(), kept.end(), coordinate);
  return found != kept.end() && *found == coordinate ? found - kept.begin() : -1;
}

std::string DescribeBox(const PlanePoint& column)
{
  return "column (" + std::to_string(column.X) + ", " + std::to_string(column.Y) + ")";
}
}

//----------------------------------------------------------------------------------------------------------------------
ColumnHeights::ColumnHeights(PlanePoints columns, const std::vector<double>& height)
  : Box(FindBox(columns))
  , Places(this->Box)
{
  assert(height.size() == columns.size());
  if (AreScattered(columns))
  {
    const ColumnIndex index(columns, 0, int(Margin));
    for (std::int64_t x = 0; x < index.Width(); ++x)
    {
      this->ColumnsKept.push_back(std::int64_t(index.GivenColumn(x).X) - this->Box.Origin().X);
    }
    for (std::int64_t y = 0; y < index.Height(); ++y)
    {
      this->RowsKept.push_back(std::int64_t(index.GivenColumn(y * index.Width()).Y) - this->Box.Origin().Y);
    }
    this->Places =
      LinkGrid(PlaneBox({ { 0, 0 }, { std::int32_t(index.Width() - 1), std::int32_t(index.Height() - 1) } }));
  }
  this->Values.assign(this->Places.NumberOfColumns(), std::numeric_limits<double>::quiet_NaN());
  constexpr double Tolerance = 1e-3; // Integer heights that passed through world coordinates are rounded.
  for (std::size_t point = 0; point < columns.size(); ++point)
  {
    double& value = this->Values[this->PlaceOf(this->Box.ColumnOf(columns[point]))];
    if (!std::isfinite(height[point]))
    {
      throw InputError("height " + std::to_string(height[point]) + " in " + DescribeBox(columns[point]) +
        ", expected a finite number");
    }
    if (!std::isnan(value))
    {
      const auto first = std::find(columns.begin(), columns.end(), columns[point]) - columns.begin();
      throw SameColumnError(PointId(first), PointId(point), columns[point]);
    }
    value = height[point];
    this->Whole = this->Whole && std::abs(value - std::round(value)) <= Tolerance;
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::int64_t ColumnHeights::FindPlace(std::int64_t column) const
{
  const std::int64_t x = FindIn(this->ColumnsKept, column % this->Box.Width());
  const std::int64_t y = FindIn(this->RowsKept, column / this->Box.Width());
  return x < 0 || y < 0 ? -1 : y * this->Places.Width() + x;
}

//----------------------------------------------------------------------------------------------------------------------
std::int64_t ColumnHeights::ToGrid(std::int64_t link) const
{
  if (this->ColumnsKept.empty())
  {
    return link;
  }
  const std::int64_t place = LinkGrid::FirstColumn(link);
  return this->Box.LinkOf(this->ColumnsKept[place % this->Places.Width()], this->RowsKept[place / this->Places.Width()],
    LinkGrid::SideOf(link));
}

//----------------------------------------------------------------------------------------------------------------------
std::int64_t ColumnHeights::ToRaster(std::int64_t link) const
{
  const std::int64_t place = this->PlaceOf(LinkGrid::FirstColumn(link));
  return place < 0 ? -1 : LinkGrid::LinkOf(place, LinkGrid::SideOf(link));
}
}
