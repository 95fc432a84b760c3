// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The points of a horizon by rows, of which a few are in memory at a time.

#ifndef SeismicHorizonsPointRows_h
#define SeismicHorizonsPointRows_h

#include "Common/Horizon/PlaneGeometry.h"
#include "Common/Horizon/Types.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
/// Bands that are meshed at once; each takes about .5 GB. An even number.
constexpr std::size_t BandsAtOnce = 8;

/// Points of successive rows, which the window may own.
class PointWindow
{
public:
  PointWindow() = default;
  PointWindow(PointId first, PlanePoints columns, const double* height)
    : First(first)
    , Columns(columns)
    , Height(height)
  {
  }
  PointWindow(PointId first, std::vector<PlanePoint> columns, std::vector<double> height)
    : First(first)
    , OwnColumns(std::move(columns))
    , OwnHeight(std::move(height))
  {
    this->Columns = this->OwnColumns;
    this->Height = this->OwnHeight.data();
  }
  PointWindow(PointWindow&&) = default; // Vectors that are moved keep their places.
  PointWindow& operator=(PointWindow&&) = default;

  bool HasPatch(std::size_t n) const { return this->IsLeftOut.empty() || this->IsLeftOut[n] == 0; }

  PointId First = 0;
  PlanePoints Columns;
  const double* Height = nullptr; // lattice units
  std::vector<unsigned char> IsLeftOut; // 1 for points without a patch; empty if all have one

private:
  std::vector<PlanePoint> OwnColumns;
  std::vector<double> OwnHeight;
};

/// Points are numbered row by row.
class PointRows
{
public:
  virtual ~PointRows() = default;
  virtual PlaneBox Box() const = 0;
  virtual PlanePoint ColumnOf(PointId point) const = 0;
  /// The first point of this row or of a later one.
  virtual PointId FirstOf(std::int32_t row) const = 0;
  /// Rows may lie beyond the box.
  virtual PointWindow Read(std::int32_t firstRow, std::int32_t lastRow) const = 0;
  /// How many bands may be meshed at once, whose threads read them.
  virtual std::size_t MostAtOnce() const = 0;
};

class RowsInMemory : public PointRows
{
public:
  /// Columns ascend row by row, in the box. They and the heights must outlive this.
  RowsInMemory(PlanePoints columns, const std::vector<double>& height, const PlaneBox& box)
    : Columns(columns)
    , Height(height)
    , Area(box)
  {
  }

  PlaneBox Box() const override { return this->Area; }
  PlanePoint ColumnOf(PointId point) const override { return this->Columns[std::size_t(point)]; }

  PointId FirstOf(std::int32_t row) const override
  {
    const auto first = std::partition_point(
      this->Columns.begin(), this->Columns.end(), [row](const PlanePoint& column) { return column.Y < row; });
    return PointId(first - this->Columns.begin());
  }

  PointWindow Read(std::int32_t firstRow, std::int32_t lastRow) const override
  {
    const PointId first = this->FirstOf(firstRow);
    const auto size = std::size_t(this->FirstOf(lastRow + 1) - first);
    return { first, PlanePoints(this->Columns.begin() + first, size), this->Height.data() + first };
  }

  std::size_t MostAtOnce() const override { return BandsAtOnce; }

private:
  const PlanePoints Columns;
  const std::vector<double>& Height;
  const PlaneBox Area;
};
}

#endif
