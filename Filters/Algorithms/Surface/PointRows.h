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
#include <vector>

namespace SeismicHorizons
{
/// Points of successive rows.
struct PointWindow
{
  PointId First = 0;
  std::vector<PlanePoint> Columns;
  std::vector<double> Height; // lattice units
  std::vector<unsigned char> IsLeftOut; // 1 for points without a patch; empty if all have one

  bool HasPatch(std::size_t n) const { return this->IsLeftOut.empty() || this->IsLeftOut[n] == 0; }
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
    PointWindow window;
    window.First = this->FirstOf(firstRow);
    const PointId end = this->FirstOf(lastRow + 1);
    window.Columns.assign(this->Columns.begin() + window.First, this->Columns.begin() + end);
    window.Height.assign(this->Height.begin() + window.First, this->Height.begin() + end);
    return window;
  }

private:
  const PlanePoints Columns;
  const std::vector<double>& Height;
  const PlaneBox Area;
};
}

#endif
