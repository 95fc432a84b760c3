// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Juxtaposition.h"

#include <algorithm>
#include <cmath>

namespace SeismicHorizons
{
namespace
{
/// The cutoffs of one horizon between two successive places.
struct CutInterval
{
  std::ptrdiff_t Horizon;
  std::array<std::array<double, 2>, 2> Height; // by wall and end
};

/// A line of one wall between two places, and the layer below it there.
struct CutLine
{
  std::array<double, 2> Height;
  std::size_t Wall;
  std::ptrdiff_t Horizon;

  double Middle() const { return 0.5 * (this->Height[0] + this->Height[1]); }
};

double HeightOnWall(const CutoffPiece& piece, FaultWall wall, double s)
{
  const auto after = std::lower_bound(piece.Pairs.begin() + 1, piece.Pairs.end() - 1, s,
    [](const CutoffPair& pair, double value) { return pair.S < value; });
  const CutoffPair &b = *after, &a = *(after - 1);
  const double part = (s - a.S) / (b.S - a.S);
  return a.Wall[wall].Height + part * (b.Wall[wall].Height - a.Wall[wall].Height);
}

std::vector<CutInterval> ListIntervals(const std::vector<const HorizonCutoffs*>& horizons, double from, double to)
{
  std::vector<CutInterval> intervals;
  const double middle = 0.5 * (from + to);
  for (std::size_t horizon = 0; horizon < horizons.size(); ++horizon)
  {
    for (const CutoffPiece& piece : horizons[horizon]->Pieces)
    {
      if (piece.Pairs.front().S < middle && middle < piece.Pairs.back().S)
      {
        CutInterval interval{ std::ptrdiff_t(horizon), {} };
        for (const FaultWall wall : { Footwall, HangingWall })
        {
          interval.Height[wall] = { HeightOnWall(piece, wall, from), HeightOnWall(piece, wall, to) };
          if (!intervals.empty())
          {
            for (const std::size_t end : { 0, 1 })
            {
              interval.Height[wall][end] = std::min(interval.Height[wall][end], intervals.back().Height[wall][end]);
            }
          }
        }
        intervals.push_back(interval);
      }
    }
  }
  return intervals;
}

/// Where lines of both walls cross, as parts of the interval from 0 to 1.
std::vector<double> ListCrossings(const std::vector<CutInterval>& intervals)
{
  std::vector<double> parts = { 0.0, 1.0 };
  for (const CutInterval& a : intervals)
  {
    for (const CutInterval& b : intervals)
    {
      const double before = a.Height[Footwall][0] - b.Height[HangingWall][0];
      const double after = a.Height[Footwall][1] - b.Height[HangingWall][1];
      if (before * after < 0.0)
      {
        parts.push_back(before / (before - after));
      }
    }
  }
  std::sort(parts.begin(), parts.end());
  parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
  return parts;
}

/// The area on the fault, level by level of its nodes.
double MeasureArea(const FaultPlate& fault, const MetArea& area)
{
  constexpr int steps = 16;
  const double width = area.S[1] - area.S[0], s = 0.5 * (area.S[0] + area.S[1]);
  const double base = 0.5 * (area.Base[0] + area.Base[1]), top = 0.5 * (area.Top[0] + area.Top[1]);
  double sum = 0.0;
  for (int n = 0; n < steps; ++n)
  {
    const double height = (top - base) / steps;
    sum += fault.AreaOf(width, height, s, base + (n + 0.5) * height);
  }
  return sum;
}

void AddAreas(const FaultPlate& fault, const std::vector<CutInterval>& intervals, std::array<double, 2> ends,
  std::array<double, 2> parts, std::vector<MetArea>& areas)
{
  std::vector<CutLine> lines;
  for (const CutInterval& interval : intervals)
  {
    for (const FaultWall wall : { Footwall, HangingWall })
    {
      const std::array<double, 2>& height = interval.Height[wall];
      const auto at = [&height](double part) { return height[0] + part * (height[1] - height[0]); };
      lines.push_back({ { at(parts[0]), at(parts[1]) }, wall, interval.Horizon });
    }
  }
  std::stable_sort(
    lines.begin(), lines.end(), [](const CutLine& a, const CutLine& b) { return a.Middle() > b.Middle(); });
  std::array<std::size_t, 2> passed = { 0, 0 };
  const auto layerOf = [&](std::size_t wall)
  {
    MetLayer layer;
    layer.Top = passed[wall] > 0 ? intervals[passed[wall] - 1].Horizon : MetLayer::Outside;
    layer.Base = passed[wall] < intervals.size() ? intervals[passed[wall]].Horizon : MetLayer::Outside;
    return layer;
  };
  for (std::size_t n = 0; n + 1 < lines.size(); ++n)
  {
    ++passed[lines[n].Wall];
    MetArea area;
    area.S = { ends[0] + parts[0] * (ends[1] - ends[0]), ends[0] + parts[1] * (ends[1] - ends[0]) };
    area.Top = lines[n].Height;
    area.Base = lines[n + 1].Height;
    area.Layer = { layerOf(Footwall), layerOf(HangingWall) };
    if (area.Top[0] > area.Base[0] || area.Top[1] > area.Base[1])
    {
      area.Area = MeasureArea(fault, area);
      areas.push_back(area);
    }
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<MetArea> FindJuxtaposition(const FaultPlate& fault, const std::vector<const HorizonCutoffs*>& horizons)
{
  std::vector<double> places;
  for (const HorizonCutoffs* horizon : horizons)
  {
    for (const CutoffPiece& piece : horizon->Pieces)
    {
      for (const CutoffPair& pair : piece.Pairs)
      {
        places.push_back(pair.S);
      }
    }
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  std::vector<MetArea> areas;
  for (std::size_t n = 0; n + 1 < places.size(); ++n)
  {
    const std::vector<CutInterval> intervals = ListIntervals(horizons, places[n], places[n + 1]);
    const std::vector<double> parts = ListCrossings(intervals);
    for (std::size_t part = 0; part + 1 < parts.size() && !intervals.empty(); ++part)
    {
      AddAreas(fault, intervals, { places[n], places[n + 1] }, { parts[part], parts[part + 1] }, areas);
    }
  }
  return areas;
}
}
