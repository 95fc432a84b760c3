// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FaultPolygons.h"

#include "Common/Base/Errors.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <tuple>

namespace SeismicHorizons
{
namespace
{
constexpr std::size_t MostCrossings = 100000000;

struct Stretch
{
  std::int32_t Row;
  double First;
  double Last;
};

bool IsStretchBefore(const Stretch& a, const Stretch& b)
{
  return std::tie(a.Row, a.First) < std::tie(b.Row, b.First);
}

class PolygonRows
{
public:
  explicit PolygonRows(PlanePoints columns)
  {
    for (const PlanePoint& column : columns)
    {
      this->Rows.push_back(column.Y);
    }
    std::sort(this->Rows.begin(), this->Rows.end());
    this->Rows.erase(std::unique(this->Rows.begin(), this->Rows.end()), this->Rows.end());
  }

  void Add(const FaultPolyline& polygon)
  {
    this->Crossings.clear();
    for (std::size_t n = 1; n < polygon.size(); ++n)
    {
      this->Cross(polygon[n - 1], polygon[n]);
    }
    std::sort(this->Crossings.begin(), this->Crossings.end(), IsStretchBefore);
    for (std::size_t n = 1; n < this->Crossings.size(); n += 2)
    {
      this->Stretches.push_back({ this->Crossings[n].Row, this->Crossings[n - 1].First, this->Crossings[n].First });
    }
  }

  /// Overlapping stretches of a row are merged after all polygons were added.
  void Join()
  {
    std::sort(this->Stretches.begin(), this->Stretches.end(), IsStretchBefore);
    std::vector<Stretch> joined;
    for (const Stretch& next : this->Stretches)
    {
      if (!joined.empty() && joined.back().Row == next.Row && next.First <= joined.back().Last)
      {
        joined.back().Last = std::max(joined.back().Last, next.Last);
      }
      else
      {
        joined.push_back(next);
      }
    }
    this->Stretches.swap(joined);
  }

  bool Cover(const PlanePoint& column) const
  {
    const auto after = std::upper_bound(
      this->Stretches.begin(), this->Stretches.end(), Stretch{ column.Y, double(column.X), 0.0 }, IsStretchBefore);
    return after != this->Stretches.begin() && std::prev(after)->Row == column.Y &&
      double(column.X) <= std::prev(after)->Last;
  }

private:
  /// A side includes its lower end only, so that corners count once. Halves avoid infinite differences.
  void Cross(const MapPlace& from, const MapPlace& to)
  {
    const double low = std::min(from.Y, to.Y);
    const double high = std::max(from.Y, to.Y);
    const double rise = 0.5 * to.Y - 0.5 * from.Y;
    for (auto row = std::lower_bound(this->Rows.begin(), this->Rows.end(), low);
         row != this->Rows.end() && double(*row) < high; ++row)
    {
      const double part = (0.5 * double(*row) - 0.5 * from.Y) / rise;
      this->Crossings.push_back({ *row, (1.0 - part) * from.X + part * to.X, 0.0 });
      if (++this->Number > MostCrossings)
      {
        throw InputError("fault polygons that cross rows of the lattice more than " + std::to_string(MostCrossings) +
          " times, expected simpler polygons");
      }
    }
  }

  std::vector<std::int32_t> Rows;
  std::vector<Stretch> Crossings;
  std::vector<Stretch> Stretches;
  std::size_t Number = 0;
};
}

//----------------------------------------------------------------------------------------------------------------------
bool IsClosed(const FaultPolyline& line)
{
  return line.size() > 3 && line.front().X == line.back().X && line.front().Y == line.back().Y;
}

//----------------------------------------------------------------------------------------------------------------------
KeptPoints FindOutside(PlanePoints columns, const std::vector<FaultPolyline>& lines)
{
  if (std::none_of(lines.begin(), lines.end(), IsClosed))
  {
    return KeptPoints::All(columns.size());
  }
  PolygonRows rows(columns);
  for (const FaultPolyline& line : lines)
  {
    if (IsClosed(line))
    {
      rows.Add(line);
    }
  }
  rows.Join();
  KeptPoints outside(columns.size());
  for (std::size_t point = 0; point < columns.size(); ++point)
  {
    if (!rows.Cover(columns[point]))
    {
      outside.Append(PointId(point));
    }
  }
  return outside;
}
}
