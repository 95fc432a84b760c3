// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Smoothing.h"

#include <cstdint>
#include <string>
#include <unordered_map>

namespace
{
/// Which point is in a column.
class ColumnTable
{
public:
  explicit ColumnTable(const std::vector<std::array<int, 2>>& columns)
  {
    this->Points.reserve(columns.size());
    for (std::size_t point = 0; point < columns.size(); ++point)
    {
      const auto [i, j] = columns[point];
      if (!this->Points.emplace(Key(i, j), point).second)
      {
        throw SeismicHorizons::InputError(
          "two points in column (" + std::to_string(i) + ", " + std::to_string(j) + "), expected at most one");
      }
    }
  }

  /// The point of column (i, j), or null.
  const std::size_t* Find(int i, int j) const
  {
    const auto found = this->Points.find(Key(i, j));
    return found == this->Points.end() ? nullptr : &found->second;
  }

private:
  static std::int64_t Key(int i, int j) { return (std::int64_t(j) << 32) + i; }

  std::unordered_map<std::int64_t, std::size_t> Points;
};

double MeanAround(
  const ColumnTable& table, const std::array<int, 2>& column, const std::vector<double>& heights, int radius)
{
  double sum = 0.0;
  int count = 0;
  for (int j = column[1] - radius; j <= column[1] + radius; ++j)
  {
    for (int i = column[0] - radius; i <= column[0] + radius; ++i)
    {
      if (const std::size_t* const point = table.Find(i, j))
      {
        sum += heights[*point];
        ++count;
      }
    }
  }
  return sum / count; // the point itself is there
}
}

std::vector<double> SmoothHeights(const std::vector<std::array<int, 2>>& columns, const std::vector<double>& heights,
  int radius, const SeismicHorizons::Monitor& monitor)
{
  if (radius < 0)
  {
    throw SeismicHorizons::InputError("radius " + std::to_string(radius) + ", expected at least 0 columns");
  }
  const ColumnTable table(columns);
  std::vector<double> smooth(heights.size());
  for (std::size_t point = 0; point < heights.size(); ++point)
  {
    if (point % 65536 == 0)
    {
      monitor.Progress(double(point) / double(heights.size()));
    }
    smooth[point] = MeanAround(table, columns[point], heights, radius);
  }
  return smooth;
}
