// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FaultPolylines.h"

#include "Common/Errors.h"
#include "SegmentClip.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <sstream>

namespace SeismicHorizons
{
namespace
{
/// Follows polylines over the blocks of two by two columns, each named by its least column. Places count from the least
/// column of the box.
class BlockWalk
{
public:
  BlockWalk(const ColumnHeights& heights, FaultLines& lines)
    : Heights(heights)
    , Grid(heights.Grid())
    , Lines(lines)
  {
  }

  void Follow(const MapPlace& start, const MapPlace& end)
  {
    const SegmentClip near(this->Grid, start, end);
    if (near.IsEmpty())
    {
      this->Lines.Close();
      return;
    }
    const MapPlace& from = near.From();
    const MapPlace& to = near.To();
    std::int64_t x = Block(from.X);
    std::int64_t y = Block(from.Y);
    std::int64_t stepsX = std::abs(Block(to.X) - x);
    std::int64_t stepsY = std::abs(Block(to.Y) - y);
    const bool isEastward = to.X > from.X;
    const bool isNorthward = to.Y > from.Y;
    while (stepsX + stepsY > 0)
    {
      // The side of the block that the line reaches first; at its corner that to the east or west.
      const double sideX = double(isEastward ? x + 1 : x);
      const double sideY = double(isNorthward ? y + 1 : y);
      const double partX = stepsX > 0 ? (sideX - from.X) / (to.X - from.X) : 2.0;
      const double partY = stepsY > 0 ? (sideY - from.Y) / (to.Y - from.Y) : 2.0;
      if (partX <= partY)
      {
        this->Cut(isEastward ? x + 1 : x, y, LinkSide::North, isEastward);
        x += isEastward ? 1 : -1;
        --stepsX;
      }
      else
      {
        this->Cut(x, isNorthward ? y + 1 : y, LinkSide::East, isNorthward);
        y += isNorthward ? 1 : -1;
        --stepsY;
      }
    }
  }

private:
  static std::int64_t Block(double place) { return std::int64_t(std::floor(place)); }

  void Cut(std::int64_t x, std::int64_t y, LinkSide side, bool isForward)
  {
    const bool isColumn = x >= 0 && y >= 0 && x < this->Grid.Width() && y < this->Grid.Height();
    const std::int64_t link = isColumn ? this->Grid.LinkOf(x, y, side) : 0;
    if (!isColumn || !this->Grid.IsInside(link))
    {
      this->Lines.Close();
      return;
    }
    this->Lines.Append(MeasureCut(this->Heights, link, isForward));
  }

  const ColumnHeights& Heights;
  const LinkGrid& Grid;
  FaultLines& Lines;
};

/// Each link of each line takes memory, also one that was cut before.
void CheckNumber(const FaultLines& lines, const LinkGrid& grid)
{
  constexpr std::size_t always = 1000000;
  const std::size_t most = std::max(always, 4 * std::size_t(grid.NumberOfLinks()));
  if (lines.NumberOfLinks() > most)
  {
    throw InputError("fault polylines that cut " + std::to_string(lines.NumberOfLinks()) + " links of a horizon of " +
      std::to_string(grid.NumberOfColumns()) + " columns, expected at most " + std::to_string(most));
  }
}

void CheckPlaces(const std::vector<FaultPolyline>& polylines)
{
  for (std::size_t line = 0; line < polylines.size(); ++line)
  {
    for (const MapPlace& place : polylines[line])
    {
      if (!std::isfinite(place.X) || !std::isfinite(place.Y))
      {
        std::ostringstream text;
        text << "fault polyline " << line << " with a point at (" << place.X << ", " << place.Y
             << ") in columns, expected finite numbers";
        throw InputError(text.str());
      }
    }
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
FaultLines CutAlong(const ColumnHeights& heights, const std::vector<FaultPolyline>& polylines)
{
  CheckPlaces(polylines);
  FaultLines lines;
  BlockWalk walk(heights, lines);
  const PlanePoint least = heights.Grid().ToLink(0).Column;
  for (const FaultPolyline& polyline : polylines)
  {
    for (std::size_t n = 1; n < polyline.size(); ++n)
    {
      CheckNumber(lines, heights.Grid());
      walk.Follow({ polyline[n - 1].X - least.X, polyline[n - 1].Y - least.Y },
        { polyline[n].X - least.X, polyline[n].Y - least.Y });
    }
    lines.Close();
  }
  return lines;
}
}
