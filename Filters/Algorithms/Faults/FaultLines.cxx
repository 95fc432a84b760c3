// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// CutAlong() walks over the blocks of two by two columns along a polyline and cuts the links between successive blocks.
// FindPassages() samples lines down a fault every half column for passages through the horizon.
//
// Given lines may be anywhere without a cost, since each segment is clipped to the neighbourhood of the box. Halves of
// coordinates are subtracted, as the difference of two large numbers may be infinite.

#include "FaultLines.h"

#include "Common/Base/Errors.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <sstream>
#include <tuple>

namespace SeismicHorizons
{
namespace
{
void RequireFiniteNumbers(
  const char* kind, std::size_t number, std::initializer_list<double> coordinates, const std::string& units)
{
  if (std::all_of(coordinates.begin(), coordinates.end(), [](double value) { return std::isfinite(value); }))
  {
    return;
  }
  std::ostringstream text;
  text << kind << ' ' << number << " with a point at ";
  const char* separator = "(";
  for (const double coordinate : coordinates)
  {
    text << separator << coordinate;
    separator = ", ";
  }
  throw InputError(text.str() + ") in " + units + ", expected finite numbers");
}

// ---- Clipping -------------------------------------------------------------------------------------------------------

class ClippedAxis
{
public:
  double In = -1.0; // These are fractions of the segment at the sides of the box.
  double Out = 2.0;

  ClippedAxis(double from, double to, double end)
    : From(from)
    , Half(0.5 * to - 0.5 * from)
    , Greatest(end + Margin)
  {
    if (this->Half != 0.0)
    {
      const double low = 0.5 * ((Least - from) / this->Half);
      const double high = 0.5 * ((this->Greatest - from) / this->Half);
      this->In = std::min(low, high);
      this->Out = std::max(low, high);
    }
    else if (from < Least || from > this->Greatest)
    {
      this->Out = -1.0;
    }
  }

  /// At a side, the exact coordinate of the side is returned, since far away coordinates are rounded to more than the
  /// box.
  double First(double part) const
  {
    return part == this->In ? (this->Half > 0.0 ? Least : this->Greatest) : this->At(part);
  }

  double Last(double part) const
  {
    return part == this->Out ? (this->Half > 0.0 ? this->Greatest : Least) : this->At(part);
  }

  double Clamp(double place) const { return std::clamp(place, Least, this->Greatest); }

private:
  // A margin of two columns keeps rounding from changing anything inside.
  static constexpr double Margin = 2.0;
  static constexpr double Least = -Margin;

  double At(double part) const { return this->Clamp(this->From + part * this->Half + part * this->Half); }

  const double From;
  const double Half;
  const double Greatest;
};

/// Places count from the least column of the box; First and Last are fractions of the segment.
struct NearSegment
{
  MapPlace From;
  MapPlace To;
  double First = 0.0;
  double Last = 1.0;

  NearSegment(const LinkGrid& box, const MapPlace& from, const MapPlace& to)
    : From{ from.X - box.Origin().X, from.Y - box.Origin().Y }
    , To{ to.X - box.Origin().X, to.Y - box.Origin().Y }
  {
    const ClippedAxis alongX(this->From.X, this->To.X, double(box.Width()));
    const ClippedAxis alongY(this->From.Y, this->To.Y, double(box.Height()));
    this->First = std::max({ 0.0, alongX.In, alongY.In });
    this->Last = std::min({ 1.0, alongX.Out, alongY.Out });
    this->From = this->First > 0.0 ? MapPlace{ alongX.First(this->First), alongY.First(this->First) }
                                   : MapPlace{ alongX.Clamp(this->From.X), alongY.Clamp(this->From.Y) };
    this->To = this->Last < 1.0 ? MapPlace{ alongX.Last(this->Last), alongY.Last(this->Last) }
                                : MapPlace{ alongX.Clamp(this->To.X), alongY.Clamp(this->To.Y) };
  }

  bool IsEmpty() const { return this->First > this->Last; }
};

// ---- Passages -------------------------------------------------------------------------------------------------------

struct StickSample
{
  MapPlace Place;
  double Above = std::numeric_limits<double>::quiet_NaN(); // height above the horizon
};

/// The nearest column determines the height.
StickSample TakeSample(const ColumnHeights& heights, const MapPlace& place, double height)
{
  const double x = std::round(place.X);
  const double y = std::round(place.Y);
  const LinkGrid& grid = heights.Grid();
  const bool isInside = x >= 0.0 && y >= 0.0 && x < double(grid.Width()) && y < double(grid.Height());
  return { place, isInside ? height - heights[std::int64_t(y) * grid.Width() + std::int64_t(x)] : NoValue };
}

MapPlace PassageBetween(const PlanePoint& least, const StickSample& before, const StickSample& after)
{
  const double known = 0.5 * before.Above / (0.5 * before.Above - 0.5 * after.Above);
  const double share = std::isfinite(known) ? known : 0.5; // Infinite heights have no quotient.
  return { least.X + before.Place.X + share * (after.Place.X - before.Place.X),
    least.Y + before.Place.Y + share * (after.Place.Y - before.Place.Y) };
}

// ---- Cuts -----------------------------------------------------------------------------------------------------------

/// Walks over blocks of two by two columns.
void CutSegment(const ColumnHeights& heights, const MapPlace& start, const MapPlace& end, FaultLines& lines)
{
  const LinkGrid& grid = heights.Grid();
  const NearSegment near(grid, start, end);
  if (near.IsEmpty())
  {
    lines.Close();
    return;
  }
  const auto cut = [&](std::int64_t i, std::int64_t j, LinkSide side, bool isForward)
  {
    const bool isColumn = i >= 0 && j >= 0 && i < grid.Width() && j < grid.Height();
    const std::int64_t link = isColumn ? grid.LinkOf(i, j, side) : 0;
    isColumn&& grid.IsInside(link) ? lines.Append(MeasureCut(heights, link, isForward)) : lines.Close();
  };
  const auto block = [](double place) { return std::int64_t(std::floor(place)); };
  const MapPlace& from = near.From;
  const MapPlace& to = near.To;
  std::int64_t x = block(from.X);
  std::int64_t y = block(from.Y);
  std::int64_t stepsX = std::abs(block(to.X) - x);
  std::int64_t stepsY = std::abs(block(to.Y) - y);
  const bool isEastward = to.X > from.X;
  const bool isNorthward = to.Y > from.Y;
  while (stepsX + stepsY > 0)
  {
    // At a corner of the block, the side to the east or west comes first.
    const std::int64_t sideX = isEastward ? x + 1 : x;
    const std::int64_t sideY = isNorthward ? y + 1 : y;
    const double partX = stepsX > 0 ? (double(sideX) - from.X) / (to.X - from.X) : 2.0;
    const double partY = stepsY > 0 ? (double(sideY) - from.Y) / (to.Y - from.Y) : 2.0;
    if (partX <= partY)
    {
      cut(sideX, y, LinkSide::North, isEastward);
      x += isEastward ? 1 : -1;
      --stepsX;
    }
    else
    {
      cut(x, sideY, LinkSide::East, isNorthward);
      y += isNorthward ? 1 : -1;
      --stepsY;
    }
  }
}

void CheckNumber(const FaultLines& lines, const LinkGrid& grid)
{
  const std::int64_t most = std::max<std::int64_t>(1000000, 4 * grid.NumberOfLinks());
  if (std::int64_t(lines.NumberOfLinks()) > most)
  {
    throw InputError("fault polylines that cut " + std::to_string(lines.NumberOfLinks()) + " links of a horizon of " +
      std::to_string(grid.NumberOfColumns()) + " columns, expected at most " + std::to_string(most));
  }
}

// ---- Polygons -------------------------------------------------------------------------------------------------------

constexpr std::size_t MostCrossings = 100000000;

struct Stretch
{
  std::int32_t Row;
  double First;
  double Last;

  friend bool operator<(const Stretch& a, const Stretch& b)
  {
    return std::tie(a.Row, a.First) < std::tie(b.Row, b.First);
  }
};

/// A side includes its lower end only, so that corners count once. Halves avoid infinite differences.
void CrossRows(
  const std::vector<std::int32_t>& rows, const MapPlace& from, const MapPlace& to, std::vector<Stretch>& crossings)
{
  const double low = std::min(from.Y, to.Y);
  const double high = std::max(from.Y, to.Y);
  const double rise = 0.5 * to.Y - 0.5 * from.Y;
  for (auto row = std::lower_bound(rows.begin(), rows.end(), low); row != rows.end() && double(*row) < high; ++row)
  {
    const double part = (0.5 * double(*row) - 0.5 * from.Y) / rise;
    crossings.push_back({ *row, (1.0 - part) * from.X + part * to.X, 0.0 });
    if (crossings.size() > MostCrossings)
    {
      throw InputError("fault polygons that cross rows of the lattice more than " + std::to_string(MostCrossings) +
        " times, expected simpler polygons");
    }
  }
}

/// Returns the stretches of rows in closed lines, in order and without overlaps.
std::vector<Stretch> FindInside(PlanePoints columns, const std::vector<FaultPolyline>& lines)
{
  std::vector<std::int32_t> rows;
  for (const PlanePoint& column : columns)
  {
    rows.push_back(column.Y);
  }
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  std::vector<Stretch> crossings;
  for (const FaultPolyline& line : lines)
  {
    const std::size_t begin = crossings.size();
    for (std::size_t n = 1; n < line.size() && IsClosed(line); ++n)
    {
      CrossRows(rows, line[n - 1], line[n], crossings);
    }
    std::sort(crossings.begin() + std::ptrdiff_t(begin), crossings.end());
  }
  std::vector<Stretch> all;
  for (std::size_t n = 1; n < crossings.size(); n += 2)
  {
    all.push_back({ crossings[n].Row, crossings[n - 1].First, crossings[n].First });
  }
  std::sort(all.begin(), all.end());
  std::vector<Stretch> joined;
  for (const Stretch& next : all)
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
  return joined;
}
}

//----------------------------------------------------------------------------------------------------------------------
FaultedLink MeasureCut(const ColumnHeights& heights, std::int64_t link, bool isForward)
{
  assert(heights.Grid().IsInside(link));
  const double before = heights[LinkGrid::FirstColumn(link)];
  const double beyond = heights[heights.Grid().SecondColumn(link)];
  const double middle = std::isnan(before) ? beyond : std::isnan(beyond) ? before : 0.5 * (before + beyond);
  return { heights.Grid().ToLink(link), beyond - before, middle, isForward };
}

//----------------------------------------------------------------------------------------------------------------------
void FaultLines::Append(const FaultLines& other)
{
  assert(this->Links.size() == (this->Ends.empty() ? 0 : this->Ends.back()));
  for (std::size_t line = 0; line < other.Size(); ++line)
  {
    this->Ends.push_back(this->Links.size() + other.Ends[line]);
    this->NameNew(other.Fault(line));
  }
  this->Links.insert(this->Links.end(), other.Links.begin(), other.Links.end());
}

//----------------------------------------------------------------------------------------------------------------------
void FaultLines::Close()
{
  const std::size_t start = this->Ends.empty() ? 0 : this->Ends.back();
  if (this->Links.size() == start)
  {
    return;
  }
  double sum = 0.0;
  for (std::size_t n = start; n < this->Links.size(); ++n)
  {
    const double left = this->Links[n].LeftThrow();
    sum += std::isfinite(left) ? left : 0.0;
  }
  if (sum < 0.0)
  {
    const auto first = this->Links.begin() + start;
    std::reverse(first, this->Links.end());
    std::for_each(first, this->Links.end(), [](FaultedLink& link) { link.IsForward = !link.IsForward; });
  }
  this->Ends.push_back(this->Links.size());
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<LinkOfLine> SortLinks(const FaultLines& lines)
{
  std::vector<LinkOfLine> sorted;
  sorted.reserve(lines.NumberOfLinks());
  for (std::size_t line = 0; line < lines.Size(); ++line)
  {
    for (std::size_t n = lines.Start(line); n < lines.End(line); ++n)
    {
      sorted.push_back({ n, line });
    }
  }
  const auto key = [&lines](const LinkOfLine& item)
  {
    const LatticeLink& link = lines[item.Link].Place;
    return std::make_tuple(link.Column.Y, link.Column.X, link.Side);
  };
  std::stable_sort(
    sorted.begin(), sorted.end(), [&key](const LinkOfLine& a, const LinkOfLine& b) { return key(a) < key(b); });
  sorted.erase(std::unique(sorted.begin(), sorted.end(),
                 [&key](const LinkOfLine& a, const LinkOfLine& b) { return key(a) == key(b); }),
    sorted.end());
  return sorted;
}

//----------------------------------------------------------------------------------------------------------------------
std::optional<LinkCuts> CutLinks(const std::vector<LatticeLink>& links)
{
  if (links.empty())
  {
    return std::nullopt;
  }
  PlaneBox box;
  for (const LatticeLink& link : links)
  {
    box.Add(link.Column);
  }
  LinkCuts cuts(box);
  for (const LatticeLink& link : links)
  {
    link.Side == LinkSide::North ? cuts.CutNorth(link.Column) : cuts.CutEast(link.Column);
  }
  return cuts;
}

//----------------------------------------------------------------------------------------------------------------------
void RequireFinite(const std::vector<SpacePoint>& places, std::size_t stick)
{
  for (const SpacePoint& place : places)
  {
    RequireFiniteNumbers("fault stick", stick, { place.X, place.Y, place.Z }, "world coordinates");
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<MapPlace> FindPassages(const ColumnHeights& heights, const std::vector<SpacePoint>& line)
{
  std::vector<MapPlace> passages;
  StickSample last;
  for (std::size_t n = 1; n < line.size(); ++n)
  {
    const SpacePoint& a = line[n - 1];
    const SpacePoint& b = line[n];
    const NearSegment near(heights.Grid(), { a.X, a.Y }, { b.X, b.Y });
    if (near.IsEmpty())
    {
      continue;
    }
    const MapPlace& from = near.From;
    const MapPlace& to = near.To;
    const double halfRise = 0.5 * b.Z - 0.5 * a.Z;
    const int samples = int(std::ceil(2.0 * std::hypot(to.X - from.X, to.Y - from.Y)) + 1.0);
    for (int sample = 0; sample <= samples; ++sample)
    {
      const double share = double(sample) / samples;
      const double part = near.First + share * (near.Last - near.First);
      const StickSample next =
        TakeSample(heights, { from.X + share * (to.X - from.X), from.Y + share * (to.Y - from.Y) },
          a.Z + part * halfRise + part * halfRise);
      if (std::isnan(next.Above))
      {
        continue;
      }
      if (!std::isnan(last.Above) && (last.Above < 0.0) != (next.Above < 0.0))
      {
        passages.push_back(PassageBetween(heights.Grid().Origin(), last, next));
      }
      last = next;
    }
  }
  return passages;
}

//----------------------------------------------------------------------------------------------------------------------
FaultLines CutAlong(
  const ColumnHeights& heights, const std::vector<FaultPolyline>& polylines, const std::vector<std::string>& faults)
{
  assert(faults.empty() || faults.size() == polylines.size());
  for (std::size_t line = 0; line < polylines.size(); ++line)
  {
    for (const MapPlace& place : polylines[line])
    {
      RequireFiniteNumbers("fault polyline", line, { place.X, place.Y }, "columns");
    }
  }
  FaultLines lines;
  for (std::size_t number = 0; number < polylines.size(); ++number)
  {
    const FaultPolyline& polyline = polylines[number];
    for (std::size_t n = 1; n < polyline.size(); ++n)
    {
      CheckNumber(lines, heights.Grid());
      CutSegment(heights, polyline[n - 1], polyline[n], lines);
    }
    lines.Close();
    lines.NameNew(faults.empty() ? std::string() : faults[number]);
  }
  return lines;
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
  const std::vector<Stretch> inside = FindInside(columns, lines);
  return KeptPoints::If(columns.size(),
    [&](std::size_t point)
    {
      const PlanePoint& column = columns[point];
      const auto after = std::upper_bound(inside.begin(), inside.end(), Stretch{ column.Y, double(column.X), 0.0 });
      return after == inside.begin() || std::prev(after)->Row != column.Y || double(column.X) > std::prev(after)->Last;
    });
}
}
