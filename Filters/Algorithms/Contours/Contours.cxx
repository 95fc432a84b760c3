// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Contours.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/ColumnIndex.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <tuple>
#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr double LargestNumber = 10000.0;
constexpr double FarthestLevel = 1e12;

Edge Sorted(PointId a, PointId b)
{
  return { std::min(a, b), std::max(a, b) };
}

/// A part of a contour in one triangle.
struct Segment
{
  std::int64_t Level;
  Edge Start;
  Edge End;

  auto Key() const { return std::tuple(this->Level, this->Start.From, this->Start.To); }
  /// The key of the segment that continues it.
  auto Next() const { return std::tuple(this->Level, this->End.From, this->End.To); }
};

/// The segment starts where the triangle, run around, goes below the level, and ends where it comes up again; on the
/// other side of an edge it is the other way round.
void AppendSegments(const std::array<PointId, 3>& triangle, const std::vector<double>& heights, double interval,
  std::vector<Segment>& segments)
{
  const std::array<double, 3> height = { heights[std::size_t(triangle[0])], heights[std::size_t(triangle[1])],
    heights[std::size_t(triangle[2])] };
  const auto [least, largest] = std::minmax_element(height.begin(), height.end());
  const auto first = std::int64_t(std::floor(*least / interval));
  const auto last = std::int64_t(std::ceil(*largest / interval));
  for (std::int64_t level = first; level <= last; ++level)
  {
    const double at = double(level) * interval;
    Segment segment = { level, {}, {} };
    for (std::size_t n = 0; n < 3; ++n)
    {
      const std::size_t next = (n + 1) % 3;
      const bool isAbove = height[n] >= at;
      if (isAbove != (height[next] >= at))
      {
        (isAbove ? segment.Start : segment.End) = Sorted(triangle[n], triangle[next]);
      }
    }
    if (segment.Start.From != NoPoint)
    {
      segments.push_back(segment);
    }
  }
}

class ContourTracer
{
public:
  ContourTracer(std::vector<Segment> segments, const std::vector<double>& heights, double interval)
    : Segments(std::move(segments))
    , Heights(heights)
    , Interval(interval)
    , IsTaken(this->Segments.size(), false)
  {
    std::sort(this->Segments.begin(), this->Segments.end(),
      [](const Segment& a, const Segment& b) { return a.Key() < b.Key(); });
  }

  std::vector<Contour> Run()
  {
    std::vector<bool> isContinued(this->Segments.size(), false);
    for (const Segment& segment : this->Segments)
    {
      const std::size_t next = this->FindNext(segment);
      if (next < this->Segments.size())
      {
        isContinued[next] = true;
      }
    }
    for (const bool areClosed : { false, true })
    {
      for (std::size_t n = 0; n < this->Segments.size(); ++n)
      {
        if (!this->IsTaken[n] && (areClosed || !isContinued[n]))
        {
          this->Trace(n);
        }
      }
    }
    std::stable_sort(
      this->Found.begin(), this->Found.end(), [](const Contour& a, const Contour& b) { return a.Level < b.Level; });
    return std::move(this->Found);
  }

private:
  /// Returns the number of segments without one. Of several, as where three triangles share an edge, the first is taken.
  std::size_t FindNext(const Segment& segment) const
  {
    const auto found = std::lower_bound(this->Segments.begin(), this->Segments.end(), segment.Next(),
      [](const Segment& one, const auto& key) { return one.Key() < key; });
    const bool isFound = found != this->Segments.end() && found->Key() == segment.Next();
    return isFound ? std::size_t(found - this->Segments.begin()) : this->Segments.size();
  }

  ContourPoint Place(const Segment& segment, const Edge& edge) const
  {
    const double from = this->Heights[std::size_t(edge.From)];
    const double to = this->Heights[std::size_t(edge.To)];
    return { edge, (double(segment.Level) * this->Interval - from) / (to - from) };
  }

  void Trace(std::size_t first)
  {
    Contour contour;
    contour.Level = this->Segments[first].Level;
    contour.Points.push_back(this->Place(this->Segments[first], this->Segments[first].Start));
    for (std::size_t n = first; n < this->Segments.size() && !this->IsTaken[n]; n = this->FindNext(this->Segments[n]))
    {
      this->IsTaken[n] = true;
      contour.Points.push_back(this->Place(this->Segments[n], this->Segments[n].End));
    }
    this->Found.push_back(std::move(contour));
  }

  std::vector<Segment> Segments;
  const std::vector<double>& Heights;
  const double Interval;
  std::vector<bool> IsTaken;
  std::vector<Contour> Found;
};
}

//----------------------------------------------------------------------------------------------------------------------
PlanTriangles JoinColumns(PlanePoints columns, const std::vector<double>& heights, const LinkCuts* cuts)
{
  const ColumnIndex index(columns);
  PlanTriangles triangles;
  const auto appendSquare = [&](const PlanePoint& at)
  {
    const PlanePoint east = { at.X + 1, at.Y }, north = { at.X, at.Y + 1 };
    if (cuts && (cuts->IsCutEast(at) || cuts->IsCutEast(north) || cuts->IsCutNorth(at) || cuts->IsCutNorth(east)))
    {
      return;
    }
    std::array<PointId, 4> corners = { index.PointAt(at), index.PointAt(east), index.PointAt({ at.X + 1, at.Y + 1 }),
      index.PointAt(north) };
    const auto missing = std::find(corners.begin(), corners.end(), NoPoint);
    if (missing != corners.end())
    {
      std::rotate(corners.begin(), missing, corners.end());
      if (std::count(corners.begin(), corners.end(), NoPoint) == 1)
      {
        triangles.push_back({ corners[1], corners[2], corners[3] });
      }
      return;
    }
    const auto height = [&](std::size_t corner) { return heights[std::size_t(corners[corner])]; };
    if (std::abs(height(1) - height(3)) < std::abs(height(0) - height(2))) // The diagonal is level.
    {
      std::rotate(corners.begin(), corners.begin() + 1, corners.end());
    }
    triangles.push_back({ corners[0], corners[1], corners[2] });
    triangles.push_back({ corners[0], corners[2], corners[3] });
  };
  index.ForEachPoint(0, index.NumberOfPlaces(),
    [&](std::int64_t place, PointId)
    {
      const PlanePoint at = index.GivenColumn(place);
      appendSquare(at);
      if (index.PointAt({ at.X - 1, at.Y }) == NoPoint) // The square to the west is appended by no other point.
      {
        appendSquare({ at.X - 1, at.Y });
      }
    });
  return triangles;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<Contour> FindContours(
  const PlanTriangles& triangles, const std::vector<double>& heights, double interval, const Monitor& monitor)
{
  if (heights.empty())
  {
    return {};
  }
  const auto [least, largest] = std::minmax_element(heights.begin(), heights.end());
  // Levels further from 0 have no exact numbers.
  const double farthest = std::max(std::abs(*least), std::abs(*largest)) / interval;
  if (!((*largest - *least) / interval <= LargestNumber) || !(farthest < FarthestLevel))
  {
    std::ostringstream text;
    text << "an interval of " << interval << " for z from " << *least << " to " << *largest
         << ", expected one that gives at most " << LargestNumber << " levels, not more than " << FarthestLevel
         << " from 0";
    throw InputError(text.str());
  }
  std::vector<Segment> segments;
  constexpr std::size_t step = 1 << 16;
  for (std::size_t n = 0; n < triangles.size(); ++n)
  {
    AppendSegments(triangles[n], heights, interval, segments);
    if (n % step == 0)
    {
      monitor.Progress(double(n) / double(triangles.size()));
    }
  }
  return ContourTracer(std::move(segments), heights, interval).Run();
}
}
