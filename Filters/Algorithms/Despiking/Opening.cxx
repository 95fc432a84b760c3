// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A square is full when each of its rows is. So rows are looked at first, and then columns of what they gave; and the
// same the other way round to cover with squares.

#include "Opening.h"

#include <algorithm>

namespace SeismicHorizons
{
namespace
{
using Marks = std::vector<unsigned char>;

/// The lines of places of a raster along one axis.
class LineFilter
{
public:
  LineFilter(std::int64_t lines, std::int64_t lineStride, std::int64_t places, std::int64_t placeStride)
    : Lines(lines)
    , LineStride(lineStride)
    , Places(places)
    , PlaceStride(placeStride)
  {
  }

  /// Leaves marks where the next `length` places of the line, the place included, are marked.
  void Erode(Marks& marks, int length) const
  {
    this->ForEachLine(
      [&](std::int64_t begin)
      {
        int run = 0;
        for (std::int64_t n = this->Places; n-- > 0;)
        {
          unsigned char& mark = marks[std::size_t(begin + n * this->PlaceStride)];
          run = mark != 0 ? run + 1 : 0;
          mark = run >= length ? 1 : 0;
        }
      });
  }

  /// Marks the next `length` places of each mark.
  void Dilate(Marks& marks, int length) const
  {
    this->ForEachLine(
      [&](std::int64_t begin)
      {
        int left = 0;
        for (std::int64_t n = 0; n < this->Places; ++n)
        {
          unsigned char& mark = marks[std::size_t(begin + n * this->PlaceStride)];
          left = mark != 0 ? length : std::max(left - 1, 0);
          mark = left > 0 ? 1 : 0;
        }
      });
  }

private:
  template <typename Work>
  void ForEachLine(Work&& work) const
  {
    for (std::int64_t line = 0; line < this->Lines; ++line)
    {
      work(line * this->LineStride);
    }
  }

  std::int64_t Lines;
  std::int64_t LineStride;
  std::int64_t Places;
  std::int64_t PlaceStride;
};
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<PointId> FindThreads(const ColumnRaster& raster, int width)
{
  const std::int64_t size = raster.Width() * raster.Height();
  Marks marks(std::size_t(size), 0);
  for (std::int64_t place = 0; place < size; ++place)
  {
    marks[std::size_t(place)] = raster[place] != NoPoint ? 1 : 0;
  }
  const LineFilter alongRows(raster.Height(), raster.Width(), raster.Width(), 1);
  const LineFilter alongColumns(raster.Width(), 1, raster.Height(), raster.Width());
  alongRows.Erode(marks, width + 1);
  alongColumns.Erode(marks, width + 1);
  alongRows.Dilate(marks, width + 1);
  alongColumns.Dilate(marks, width + 1);
  std::vector<PointId> threads;
  for (std::int64_t place = 0; place < size; ++place)
  {
    if (raster[place] != NoPoint && marks[std::size_t(place)] == 0)
    {
      threads.push_back(raster[place]);
    }
  }
  return threads;
}
}
