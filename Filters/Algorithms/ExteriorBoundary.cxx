// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The rows of the lattice are read from left to right, and at every column it is known whether it lies inside a patch.
// Where a row comes from outside upon an occupied column that no walk has touched yet, a new patch begins, and its
// border is walked at once. Where a row leaves a patch the walk has left a mark: it looked at the empty column to the
// right. All that lies between entering and leaving belongs to the patch, holes and islands included; so one pass
// numbers all points, and a loop is only ever walked around what is not inside another one.

#include "ExteriorBoundary.h"

#include "ColumnRaster.h"

#include <algorithm>
#include <array>

namespace SeismicHorizons
{
namespace
{
// The eight neighbours clockwise, seen from +z with x to the right (east) and y upwards (north).
enum Direction
{
  North,
  NorthEast,
  East,
  SouthEast,
  South,
  SouthWest,
  West,
  NorthWest,
  NumberOfDirections
};

constexpr int Opposite(int direction)
{
  return (direction + 4) % NumberOfDirections;
}

class BorderWalk
{
public:
  BorderWalk(const std::vector<PlanePoint>& columns, ExteriorBoundary& result)
    : Columns(columns)
    , Raster(columns)
    , Result(result)
    , OutsideToTheEast(columns.size(), false)
  {
    const std::int64_t up = this->Raster.Width();
    this->Offsets = { up, up + 1, 1, 1 - up, -up, -up - 1, -1, up - 1 };
    this->Result.Patch.assign(columns.size(), -1);
  }

  void Run(const Monitor& monitor)
  {
    const std::int64_t height = this->Raster.Height();
    for (std::int64_t row = 0; row < height; ++row)
    {
      if (row % 64 == 0)
      {
        monitor.Progress(double(row) / double(height));
      }
      this->NumberRow(row);
    }
  }

private:
  void NumberRow(std::int64_t row)
  {
    std::int32_t inside = -1;
    const std::int64_t first = row * this->Raster.Width();
    for (std::int64_t place = first; place < first + this->Raster.Width(); ++place)
    {
      const PointId point = this->Raster[place];
      if (point == NoPoint)
      {
        continue;
      }
      std::int32_t& patch = this->Result.Patch[std::size_t(point)];
      if (inside < 0)
      {
        if (patch < 0)
        {
          this->Walk(place);
        }
        inside = patch;
      }
      patch = inside;
      if (this->OutsideToTheEast[std::size_t(point)])
      {
        inside = -1;
      }
    }
  }

  /// Sweeps clockwise around a place, beginning after `direction`, and gives the direction of the first occupied
  /// neighbour; NumberOfDirections when there is none.
  int NextDirection(std::int64_t place, int direction)
  {
    for (int turn = 1; turn <= NumberOfDirections; ++turn)
    {
      const int next = (direction + turn) % NumberOfDirections;
      if (this->Raster[place + this->Offsets[std::size_t(next)]] != NoPoint)
      {
        return next;
      }
      if (next == East)
      {
        this->OutsideToTheEast[std::size_t(this->Raster[place])] = true;
      }
    }
    return NumberOfDirections;
  }

  /// Walks the border of the patch at a place whose western neighbour is outside.
  void Walk(std::int64_t start)
  {
    this->Steps.clear();
    const int first = this->NextDirection(start, West);
    std::int64_t place = start;
    int direction = first;
    do
    {
      const PointId point = this->Raster[place];
      this->Result.Patch[std::size_t(point)] = std::int32_t(this->Result.Boundary.Size());
      this->Steps.push_back({ point, direction });
      if (direction < NumberOfDirections)
      {
        place += this->Offsets[std::size_t(direction)];
        direction = this->NextDirection(place, Opposite(direction));
      }
    } while (place != start || direction != first);
    this->AddLoop();
  }

  /// Adds the walk as a loop that begins where the contract says. A patch can touch itself at its first point; of the
  /// steps from there the one that comes first in a clockwise sweep from the south, where all is empty, begins.
  void AddLoop()
  {
    const auto first = std::min_element(this->Steps.begin(), this->Steps.end(),
      [this](const Step& a, const Step& b)
      {
        const PlanePoint& columnA = this->Columns[std::size_t(a.Point)];
        const PlanePoint& columnB = this->Columns[std::size_t(b.Point)];
        return columnA == columnB ? Sweep(a.Direction) < Sweep(b.Direction) : columnA < columnB;
      });
    std::rotate(this->Steps.begin(), first, this->Steps.end());
    for (const Step& step : this->Steps)
    {
      this->Result.Boundary.Append(step.Point);
    }
    this->Result.Boundary.Close();
  }

  static int Sweep(int direction) { return (direction + NumberOfDirections - South) % NumberOfDirections; }

  struct Step
  {
    PointId Point;
    int Direction;
  };

  const std::vector<PlanePoint>& Columns;
  const ColumnRaster Raster;
  ExteriorBoundary& Result;
  std::vector<bool> OutsideToTheEast;
  std::array<std::int64_t, NumberOfDirections> Offsets;
  std::vector<Step> Steps;
};
}

//----------------------------------------------------------------------------------------------------------------------
ExteriorBoundary FindExteriorBoundary(const std::vector<PlanePoint>& columns, const Monitor& monitor)
{
  ExteriorBoundary result;
  BorderWalk(columns, result).Run(monitor);
  return result;
}
}
