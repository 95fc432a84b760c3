// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PinchOuts.h"

#include "Common/Base/Parameters.h"
#include "Common/Horizon/KeptPoints.h"
#include "Common/Horizon/SpacePoints.h"
#include "Filters/Algorithms/Boundary/ExteriorBoundary.h"
#include "Filters/Algorithms/BoundarySimplification/BoundarySimplification.h"

#include <cassert>
#include <cstddef>

namespace SeismicHorizons
{
namespace
{
class LineFinder
{
public:
  LineFinder(PlanePoints columns, const std::vector<unsigned char>& isOnLoop, const PinchOutOptions& options,
    PinchOutLines& lines)
    : Columns(columns)
    , IsOnLoop(isOnLoop)
    , Options(options)
    , Lines(lines)
  {
  }

  void Run(const std::vector<double>& upper, const std::vector<double>& lower, const Monitor& monitor)
  {
    for (std::size_t point = 0; point < this->Columns.size(); ++point)
    {
      if (upper[point] == lower[point])
      {
        this->Pinched.push_back(PointId(point));
        this->Places.push_back(this->Columns[point]);
        this->Heights.push_back(upper[point]);
      }
    }
    if (this->Pinched.empty())
    {
      return;
    }
    const Loops loops = this->FindLoops(monitor.Step(0.0, 0.5));
    const Loops simplified = this->Simplify(loops, monitor.Step(0.5, 1.0));
    this->AddLines(loops, simplified.MarkPoints(this->Pinched.size()));
  }

private:
  // Points of loops are numbered among the pinched ones.
  bool IsOnOutline(PointId point) const { return this->IsOnLoop[std::size_t(this->Pinched[std::size_t(point)])] != 0; }

  Loops FindLoops(const Monitor& monitor) const
  {
    BoundaryOptions options;
    options.HoleBoundaries = true;
    options.SmallestHoleSize = this->Options.SmallestPinch;
    options.MinimumPatchSize = this->Options.SmallestPinch;
    return FindExteriorBoundary(this->Places, options, monitor).Boundary;
  }

  Loops Simplify(const Loops& loops, const Monitor& monitor)
  {
    BoundarySimplificationOptions options;
    options.Method = OutlineMethod::FewestPoints;
    options.OutlineTolerance = this->Options.Tolerance;
    options.DistanceThreshold = this->Options.MaximumError;
    loops.ForEachEdge(
      [&](PointId from, PointId to)
      {
        if (this->IsOnOutline(from) != this->IsOnOutline(to))
        {
          options.Fixed.push_back(this->IsOnOutline(from) ? from : to);
          this->Lines.OnOutline.push_back(this->Pinched[std::size_t(options.Fixed.back())]);
        }
      });
    return SimplifyBoundary(SpacePoints(this->Places, this->Heights, 1), loops, options, monitor).Boundary;
  }

  /// Adds lines from each kept point to the next one, except along the outline.
  void AddLines(const Loops& loops, const std::vector<unsigned char>& isKept)
  {
    for (std::size_t loop = 0; loop < loops.Size(); ++loop)
    {
      std::vector<PointId> line; // since the last kept point
      bool isAlongOutline = true;
      const std::size_t length = loops.Length(loop);
      for (std::size_t n = 0; n < 2 * length; ++n) // the second round begins at the first kept point
      {
        const PointId point = loops.begin(loop)[n % length];
        isAlongOutline = isAlongOutline && this->IsOnOutline(point);
        line.push_back(this->Pinched[std::size_t(point)]);
        if (isKept[std::size_t(point)] == 0)
        {
          continue;
        }
        if (line.front() != line.back() && !isAlongOutline && n >= length)
        {
          this->Lines.Lines.push_back(line);
        }
        line = { line.back() };
        isAlongOutline = this->IsOnOutline(point);
      }
    }
  }

  PlanePoints Columns;
  const std::vector<unsigned char>& IsOnLoop;
  const PinchOutOptions& Options;
  PinchOutLines& Lines;
  std::vector<PointId> Pinched; // points without thickness
  std::vector<PlanePoint> Places;
  std::vector<double> Heights;
};
}

//----------------------------------------------------------------------------------------------------------------------
PinchOutLines FindPinchOutLines(PlanePoints columns, const HeightStack& heights,
  const std::vector<unsigned char>& isOnLoop, const PinchOutOptions& options, const Monitor& monitor)
{
  assert(isOnLoop.size() == columns.size() && HaveAll(heights, columns.size()));
  CheckAtLeast<std::int64_t>("smallest pinch-out", options.SmallestPinch, 1, " column");
  PinchOutLines lines;
  const auto layers = double(heights.size() - 1);
  for (std::size_t layer = 0; layer + 1 < heights.size(); ++layer)
  {
    LineFinder(columns, isOnLoop, options, lines)
      .Run(heights[layer], heights[layer + 1], monitor.Step(double(layer) / layers, double(layer + 1) / layers));
  }
  return lines;
}
}
