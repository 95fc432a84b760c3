// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FaultSources.h"

#include "Common/Base/Errors.h"
#include "Common/Base/LeastSquares.h"
#include "Common/Horizon/Median.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace SeismicHorizons
{
namespace
{
Eigen::Vector3d PlaceOf(const SpacePoint& place)
{
  return { place.X, place.Y, place.Z };
}

bool IsLoop(const FaultStick& stick)
{
  const SpacePoint &first = stick.Places.front(), &last = stick.Places.back();
  return stick.Places.size() > 3 && first.X == last.X && first.Y == last.Y && first.Z == last.Z;
}

/// The middle distance of successive sticks on the map.
double MeasureSpacing(const FaultSheet& sheet)
{
  std::vector<double> distances;
  for (std::size_t stick = 0; stick + 1 < sheet.Sticks; ++stick)
  {
    double distance = 0.0, count = 0.0;
    for (std::size_t level = 0; level < sheet.Levels; ++level)
    {
      const auto &a = sheet.Places[sheet.At(stick, level)], &b = sheet.Places[sheet.At(stick + 1, level)];
      if (a && b)
      {
        distance += std::hypot(a->X - b->X, a->Y - b->Y);
        count += 1.0;
      }
    }
    if (count > 0.0)
    {
      distances.push_back(distance / count);
    }
  }
  return distances.empty() ? 0.0 : UpperMedian(distances);
}

FaultPicks PickSheet(const std::string& name, const FaultSheet& sheet)
{
  FaultPicks picks;
  picks.Name = name;
  picks.Spacing = MeasureSpacing(sheet);
  for (std::size_t stick = 0; stick < sheet.Sticks; ++stick)
  {
    for (std::size_t level = 0; level + 1 < sheet.Levels; ++level)
    {
      const auto &a = sheet.Places[sheet.At(stick, level)], &b = sheet.Places[sheet.At(stick, level + 1)];
      if (a && b)
      {
        picks.Segments.push_back({ PlaceOf(*a), PlaceOf(*b) });
      }
    }
  }
  return picks;
}

// ---- Traces ---------------------------------------------------------------------------------------------------------

/// Places along a trace, means of several cuts each, which smooths the steps between columns.
struct SmoothTrace
{
  std::vector<Eigen::Vector3d> Places;
  double LargestThrow = 0.0;
  Eigen::Vector2d Fall = Eigen::Vector2d::Zero(); // the sum
  double Heave = 0.0; // the middle gap
  double Throw = 0.0; // the middle one
};

SmoothTrace Smooth(const std::vector<TraceCut>& cuts)
{
  constexpr std::size_t together = 6;
  SmoothTrace trace;
  std::vector<double> throws, gaps;
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const TraceCut& cut : cuts)
  {
    middle += cut.Place.head<2>() / double(cuts.size());
    trace.Fall += cut.Fall;
    throws.push_back(cut.Fall.norm());
    gaps.push_back(cut.Gap);
  }
  trace.Heave = UpperMedian(gaps);
  trace.Throw = UpperMedian(throws);
  trace.LargestThrow = *std::max_element(throws.begin(), throws.end());
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const TraceCut& cut : cuts)
  {
    const Eigen::Vector2d off = cut.Place.head<2>() - middle;
    spread += off * off.transpose();
  }
  const Eigen::Vector2d along = FindPrincipalAxes(spread).Axes.col(1);
  std::vector<std::pair<double, const TraceCut*>> sorted;
  for (const TraceCut& cut : cuts)
  {
    sorted.emplace_back((cut.Place.head<2>() - middle).dot(along), &cut);
  }
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (std::size_t first = 0; first < sorted.size(); first += together)
  {
    const std::size_t end = std::min(first + together, sorted.size());
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t n = first; n < end; ++n)
    {
      sum += sorted[n].second->Place;
    }
    trace.Places.push_back(sum / double(end - first));
  }
  if (trace.Places.size() == 1)
  {
    trace.Places = { sorted.front().second->Place, sorted.back().second->Place };
  }
  return trace;
}

/// The mean distance of successive places on the map.
double SpacingOf(const SmoothTrace& trace)
{
  double length = 0.0;
  for (std::size_t n = 1; n < trace.Places.size(); ++n)
  {
    length += (trace.Places[n] - trace.Places[n - 1]).head<2>().norm();
  }
  return length / double(trace.Places.size() - 1);
}

/// The map distance by height, across the trace. Places higher up lie away from the lower side.
Eigen::Vector2d LeanByDip(const SmoothTrace& trace, double dip, double column)
{
  const Eigen::Vector2d along = (trace.Places.back() - trace.Places.front()).head<2>().normalized();
  const Eigen::Vector2d across(along.y(), -along.x());
  constexpr double degrees = 3.14159265358979323846 / 180.0;
  const double ofGap = trace.Heave >= column && trace.Throw > 0.0 ? trace.Heave / trace.Throw : 0.0;
  const double lean = dip > 0.0 ? 1.0 / std::tan(dip * degrees) : ofGap;
  return lean * (trace.Fall.dot(across) < 0.0 ? across : Eigen::Vector2d(-across));
}

/// From the plane through traces at different heights: N = a + b S + c Z, with S along the first one.
Eigen::Vector2d LeanByHeights(const std::vector<SmoothTrace>& traces)
{
  const std::vector<Eigen::Vector3d>& first = traces.front().Places;
  const Eigen::Vector2d along = (first.back() - first.front()).head<2>().normalized();
  const Eigen::Vector2d across(along.y(), -along.x());
  std::size_t size = 0;
  for (const SmoothTrace& trace : traces)
  {
    size += trace.Places.size();
  }
  Eigen::MatrixX3d rows(std::ptrdiff_t(size), 3);
  Eigen::VectorXd offsets(rows.rows());
  std::ptrdiff_t row = 0;
  for (const SmoothTrace& trace : traces)
  {
    for (const Eigen::Vector3d& place : trace.Places)
    {
      const Eigen::Vector3d local = place - first.front();
      rows.row(row) << 1.0, local.head<2>().dot(along), local.z();
      offsets(row++) = local.head<2>().dot(across);
    }
  }
  return SolveLeastSquares(rows, offsets).Unknowns.z() * across;
}
}

//----------------------------------------------------------------------------------------------------------------------
PickedSticks PickSticks(const std::vector<FaultStick>& sticks)
{
  std::vector<FaultStick> open;
  std::vector<const FaultStick*> loops;
  for (const FaultStick& stick : sticks)
  {
    if (stick.Places.size() > 1 && IsLoop(stick))
    {
      RequireFinite(stick.Places, std::size_t(&stick - sticks.data()));
      loops.push_back(&stick);
    }
    else
    {
      open.push_back(stick);
    }
  }
  PickedSticks picked;
  std::vector<FaultPicks>& faults = picked.Faults;
  picked.NumberAlone = open.size();
  const std::vector<FaultSheet> sheets = MakeFaultSheets(open, false);
  for (std::size_t n = 0; n < sheets.size(); ++n)
  {
    picked.NumberAlone -= sheets[n].Sticks;
    faults.push_back(PickSheet(NameOf(sheets, n), sheets[n]));
  }
  for (const FaultStick* const loop : loops)
  {
    const auto fault =
      std::find_if(faults.begin(), faults.end(), [loop](const FaultPicks& picks) { return picks.Name == loop->Fault; });
    if (fault == faults.end())
    {
      throw InputError("closed line of fault " + loop->Fault + ", which has no sticks, expected sticks of that name");
    }
    for (std::size_t n = 1; n < loop->Places.size(); ++n)
    {
      fault->TipLoop.push_back({ PlaceOf(loop->Places[n - 1]), PlaceOf(loop->Places[n]) });
    }
  }
  for (const FaultStick& stick : open)
  {
    const auto isNamed = [&stick](const FaultPicks& picks) { return picks.Name == stick.Fault; };
    const bool isKnown = std::find(picked.Alone.begin(), picked.Alone.end(), stick.Fault) != picked.Alone.end();
    if (!stick.Fault.empty() && !isKnown && std::none_of(faults.begin(), faults.end(), isNamed))
    {
      picked.Alone.push_back(stick.Fault);
    }
  }
  return picked;
}

//----------------------------------------------------------------------------------------------------------------------
FaultPicks PickSurface(const std::string& name, const std::vector<SpaceTriangle>& triangles)
{
  FaultPicks picks;
  picks.Name = name;
  picks.IsSurface = true;
  for (const SpaceTriangle& corners : triangles)
  {
    for (std::size_t n = 0; n < 3; ++n)
    {
      picks.Segments.push_back({ corners[n], corners[(n + 1) % 3] });
    }
  }
  return picks;
}

//----------------------------------------------------------------------------------------------------------------------
FaultPicks PickTraces(
  const std::string& name, const std::vector<std::vector<TraceCut>>& traces, double dip, double column, double index)
{
  std::vector<SmoothTrace> smooth;
  double least = std::numeric_limits<double>::infinity(), largest = -least, reach = 0.0;
  for (const std::vector<TraceCut>& cuts : traces)
  {
    smooth.push_back(Smooth(cuts));
    double middle = 0.0;
    for (const Eigen::Vector3d& place : smooth.back().Places)
    {
      middle += place.z() / double(smooth.back().Places.size());
    }
    least = std::min(least, middle);
    largest = std::max(largest, middle);
    reach = std::max(reach, smooth.back().LargestThrow);
  }
  const bool areApart = largest - least > reach;
  const Eigen::Vector2d lean = areApart ? LeanByHeights(smooth) : LeanByDip(smooth.front(), dip, column);
  const double half = std::max({ reach, index, areApart ? 0.5 * (largest - least) : 0.0 });
  FaultPicks picks;
  picks.Name = name;
  picks.Spacing = SpacingOf(smooth.front());
  picks.HasDip = lean != Eigen::Vector2d::Zero() || dip > 0.0;
  for (const SmoothTrace& trace : smooth)
  {
    for (const Eigen::Vector3d& place : trace.Places)
    {
      const Eigen::Vector3d up(half * lean.x(), half * lean.y(), half);
      picks.Segments.push_back({ place - up, place + up });
    }
  }
  return picks;
}
}
