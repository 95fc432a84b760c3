// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FaultJoins.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
namespace
{
// These links of a line define its direction and throw at an end. The throw tapers towards tips of faults, but not at
// holes.
constexpr std::size_t LinksOfEnd = 20;
// Detection needs complete neighbourhoods, so that lines may end this many columns from a hole.
constexpr double LargestDistance = 8.0;
// This is 25 degrees, in radians, between the direction of a line and the other end.
constexpr double LargestTurn = 0.4363;
constexpr double LargestRatio = 2.0;
constexpr double Step = 0.5; // columns
// This is in columns; wider holes are not bridged.
constexpr double WidestHole = 1000.0;

struct LineEnd
{
  MapPlace Place;
  MapPlace Smooth; // without the stairs of links
  MapPlace Direction; // outwards, of length 1
  double LeftThrow = 0.0;
  double Height = 0.0;
  double Reach = 0.0; // columns to the other side of the hole
};

struct EndPair
{
  double Turn = 0.0;
  std::size_t First = 0;
  std::size_t Second = 0;
};

class EndSearch
{
public:
  EndSearch(const ColumnHeights& heights, const FaultLines& lines)
    : Heights(heights)
    , Lines(lines)
  {
  }

  std::vector<LineEnd> FindEnds() const
  {
    std::vector<LineEnd> ends;
    for (std::size_t line = 0; line < this->Lines.Size(); ++line)
    {
      this->Append(line, true, ends);
      this->Append(line, false, ends);
    }
    std::stable_sort(
      ends.begin(), ends.end(), [](const LineEnd& a, const LineEnd& b) { return a.Place.X < b.Place.X; });
    return ends;
  }

  std::vector<EndPair> FindPairs(const std::vector<LineEnd>& ends) const
  {
    std::vector<EndPair> pairs;
    for (std::size_t first = 0; first < ends.size(); ++first)
    {
      for (std::size_t second = first + 1;
           second < ends.size() && ends[second].Place.X - ends[first].Place.X <= 2.0 * ends[first].Reach; ++second)
      {
        const double turn = this->Turn(ends[first], ends[second]);
        if (turn <= 2.0 * LargestTurn)
        {
          pairs.push_back({ turn, first, second });
        }
      }
    }
    std::stable_sort(pairs.begin(), pairs.end(), [](const EndPair& a, const EndPair& b) { return a.Turn < b.Turn; });
    return pairs;
  }

private:
  void Append(std::size_t line, bool isLast, std::vector<LineEnd>& ends) const
  {
    const std::size_t start = this->Lines.Start(line);
    const std::size_t number = std::min(LinksOfEnd, this->Lines.End(line) - start);
    const auto link = [&](std::size_t fromEnd)
    { return this->Lines[isLast ? this->Lines.End(line) - 1 - fromEnd : start + fromEnd]; };
    LineEnd end;
    end.Place = MiddleOf(link(0));
    end.Height = link(0).Middle;
    // Linear regression removes the stairs of single links.
    const double half = 0.5 * double(number - 1);
    MapPlace mean;
    MapPlace slope;
    double squares = 0.0;
    double sum = 0.0;
    int known = 0;
    for (std::size_t n = 0; n < number; ++n)
    {
      const MapPlace place = MiddleOf(link(n));
      const double weight = half - double(n);
      mean.X += place.X / double(number);
      mean.Y += place.Y / double(number);
      slope.X += weight * place.X;
      slope.Y += weight * place.Y;
      squares += weight * weight;
      const double left = link(n).LeftThrow();
      sum += std::isnan(left) ? 0.0 : left;
      known += std::isnan(left) ? 0 : 1;
    }
    const double length = std::hypot(slope.X, slope.Y);
    if (known == 0 || length == 0.0)
    {
      return;
    }
    end.Direction = { slope.X / length, slope.Y / length };
    end.Smooth = { mean.X + half * slope.X / squares, mean.Y + half * slope.Y / squares };
    end.LeftThrow = (isLast ? sum : -sum) / known;
    end.Reach = this->FindReach(end);
    if (end.Reach > 0.0)
    {
      ends.push_back(end);
    }
  }

  /// Returns 0 without a hole nearby, or with nothing beyond it.
  double FindReach(const LineEnd& end) const
  {
    bool isHole = false;
    for (double distance = Step;; distance += Step)
    {
      const MapPlace place = Along(end, distance);
      if (!this->IsInside(place) || distance > (isHole ? WidestHole : LargestDistance))
      {
        return 0.0;
      }
      const bool isMissing = this->IsMissing(place);
      if (isHole && !isMissing)
      {
        return distance;
      }
      isHole = isHole || isMissing;
    }
  }

  /// Returns the sum of turns at both ends, or a large angle if the ends do not match.
  double Turn(const LineEnd& a, const LineEnd& b) const
  {
    constexpr double none = 10.0;
    const double x = b.Place.X - a.Place.X;
    const double y = b.Place.Y - a.Place.Y;
    const double length = std::hypot(x, y);
    const double throwBeyond = -b.LeftThrow;
    const double ratio = throwBeyond / a.LeftThrow;
    if (length == 0.0 || length > 2.0 * a.Reach || length > 2.0 * b.Reach ||
      !(ratio >= 1.0 / LargestRatio && ratio <= LargestRatio))
    {
      return none;
    }
    const double atA = AngleOf((a.Direction.X * x + a.Direction.Y * y) / length);
    const double atB = AngleOf(-(b.Direction.X * x + b.Direction.Y * y) / length);
    return atA > LargestTurn || atB > LargestTurn || !this->IsMostlyMissing(a.Place, x, y, length) ? none : atA + atB;
  }

  bool IsMostlyMissing(const MapPlace& from, double x, double y, double length) const
  {
    const int steps = int(std::ceil(length / Step));
    int missing = 0;
    for (int n = 1; n < steps; ++n)
    {
      const double part = double(n) / steps;
      missing += this->IsMissing({ from.X + part * x, from.Y + part * y }) ? 1 : 0;
    }
    return 2 * missing >= steps - 1;
  }

  static double AngleOf(double cosine) { return std::acos(std::clamp(cosine, -1.0, 1.0)); }

  static MapPlace Along(const LineEnd& end, double distance)
  {
    return { end.Place.X + distance * end.Direction.X, end.Place.Y + distance * end.Direction.Y };
  }

  static MapPlace MiddleOf(const FaultedLink& cut)
  {
    const PlanePoint before = cut.Place.Column;
    const PlanePoint beyond = cut.Place.Beyond();
    return { 0.5 * (double(before.X) + beyond.X), 0.5 * (double(before.Y) + beyond.Y) };
  }

  std::int64_t X(const MapPlace& place) const { return std::int64_t(std::floor(place.X + 0.5)) - this->Least().X; }
  std::int64_t Y(const MapPlace& place) const { return std::int64_t(std::floor(place.Y + 0.5)) - this->Least().Y; }
  const PlanePoint& Least() const { return this->Heights.Grid().Origin(); }

  bool IsInside(const MapPlace& place) const
  {
    const LinkGrid& grid = this->Heights.Grid();
    return this->X(place) >= 0 && this->Y(place) >= 0 && this->X(place) < grid.Width() &&
      this->Y(place) < grid.Height();
  }

  bool IsMissing(const MapPlace& place) const
  {
    return std::isnan(this->Heights[this->Y(place) * this->Heights.Grid().Width() + this->X(place)]);
  }

  const ColumnHeights& Heights;
  const FaultLines& Lines;
};

/// A cubic leaves both ends in their directions.
FaultPolyline Bend(const LineEnd& from, const LineEnd& to)
{
  const double length = std::hypot(to.Smooth.X - from.Smooth.X, to.Smooth.Y - from.Smooth.Y);
  const int parts = std::max(1, int(std::ceil(length)));
  // The line starts just outside the last link, which is cut already.
  constexpr double outside = 1e-3;
  const auto start = [](const LineEnd& end) {
    return MapPlace{ end.Place.X + outside * end.Direction.X, end.Place.Y + outside * end.Direction.Y };
  };
  FaultPolyline line = { start(from) };
  for (int n = 1; n < parts; ++n)
  {
    const double t = double(n) / parts;
    const double u = 1.0 - t;
    const double first = u * u * (1.0 + 2.0 * t);
    const double last = t * t * (1.0 + 2.0 * u);
    const double out = u * u * t * length;
    const double in = u * t * t * length;
    line.push_back({ first * from.Smooth.X + last * to.Smooth.X + out * from.Direction.X + in * to.Direction.X,
      first * from.Smooth.Y + last * to.Smooth.Y + out * from.Direction.Y + in * to.Direction.Y });
  }
  line.push_back(start(to));
  return line;
}

FaultLines Join(const ColumnHeights& heights, const LineEnd& from, const LineEnd& to)
{
  const FaultLines path = CutAlong(heights, { Bend(from, to) });
  FaultLines joined;
  const double links = double(path.NumberOfLinks());
  for (std::size_t n = 0; n < path.NumberOfLinks(); ++n)
  {
    FaultedLink cut = path[n];
    if (std::isnan(cut.Throw))
    {
      const double part = (double(n) + 0.5) / links;
      const double left = (1.0 - part) * from.LeftThrow - part * to.LeftThrow;
      cut.Throw = IsLeftBeyond(cut.Place.Side, cut.IsForward) ? left : -left;
      cut.Middle = (1.0 - part) * from.Height + part * to.Height;
    }
    joined.Append(cut);
  }
  joined.Close();
  return joined;
}
}

//----------------------------------------------------------------------------------------------------------------------
void JoinThroughHoles(const ColumnHeights& heights, FaultLines& lines)
{
  const EndSearch search(heights, lines);
  const std::vector<LineEnd> ends = search.FindEnds();
  std::vector<bool> isJoined(ends.size(), false);
  FaultLines joins;
  for (const EndPair& pair : search.FindPairs(ends))
  {
    if (!isJoined[pair.First] && !isJoined[pair.Second])
    {
      isJoined[pair.First] = true;
      isJoined[pair.Second] = true;
      joins.Append(Join(heights, ends[pair.First], ends[pair.Second]));
    }
  }
  lines.Append(joins);
}
}
