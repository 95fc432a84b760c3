// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SurveyMap.h"

#include "Common/Base/Errors.h"
#include "Common/Base/FixedChunks.h"
#include "Common/Horizon/Lattice.h"
#include "LatticeSearch.h"
#include "LineLattice.h"

#include <string>
#include <utility>

namespace SeismicHorizons
{
namespace
{
[[noreturn]] void RefuseLine(const char* what)
{
  throw InputError(std::string(what) + " on one line, expected some that span a lattice");
}

PlaneMap FitCorners(const std::array<CornerPoint, 3>& corners, const LineNumbering& lines)
{
  PlaneFit fit;
  const Eigen::Vector2d first(corners[0].X, corners[0].Y);
  for (const CornerPoint& corner : corners)
  {
    fit.Add(LineIndex(lines, corner.Crossline, corner.Inline), Eigen::Vector2d(corner.X, corner.Y) - first);
  }
  std::optional<PlaneMap> map = fit.Solve();
  if (!map)
  {
    RefuseLine("three corner points whose line numbers are");
  }
  map->Origin += first;
  return *map;
}

PlaneMap GivenMap(const PlacementOptions& options)
{
  PlaneMap map;
  map.Origin = options.Origin;
  map.Steps << options.ColumnStep, options.RowStep;
  return map;
}
}

//----------------------------------------------------------------------------------------------------------------------
void PlaceRows(PickTable& picks, const PlacementOptions& options)
{
  if (!std::exchange(picks.AreRows, false))
  {
    return;
  }
  if (options.Source != LatticeSource::OriginAndSteps)
  {
    throw InputError("a matrix of heights without coordinates, expected those of the first number, and the steps to "
                     "the next number and the next line: set LatticeSource OriginAndSteps");
  }
  for (std::size_t pick = 0; pick < picks.Size(); ++pick)
  {
    const Eigen::Vector2d place =
      options.Origin + picks.Crossline[pick] * options.ColumnStep + picks.Inline[pick] * options.RowStep;
    picks.X.push_back(place.x());
    picks.Y.push_back(place.y());
  }
  picks.Crossline = picks.Inline = {};
}

//----------------------------------------------------------------------------------------------------------------------
PlaneMap FitPlaces(const PickPlaces& picks, const LineNumbering& lines, const Monitor& monitor)
{
  const Eigen::Vector2d middle(picks.X.front(), picks.Y.front());
  const auto all = AddUpChunks<PlaneFit>(std::int64_t(picks.X.size()), ChunkSize, monitor,
    [&](PlaneFit& fit, std::int64_t first, std::int64_t last)
    {
      for (auto pick = std::size_t(first); pick < std::size_t(last); ++pick)
      {
        fit.Add(LineIndex(lines, picks.Crossline[pick], picks.Inline[pick]),
          Eigen::Vector2d(picks.X[pick], picks.Y[pick]) - middle);
      }
    });
  std::optional<PlaneMap> map = all.Solve();
  if (!map)
  {
    map = all.SolveAlongLine();
  }
  if (!map)
  {
    RefuseLine("picks");
  }
  map->Origin += middle;
  return *map;
}

//----------------------------------------------------------------------------------------------------------------------
PlaneMap LinesAsPlaces(const LineNumbering& lines)
{
  PlaneMap map;
  map.Origin = { lines.FirstCrossline, lines.FirstInline };
  map.Steps = Eigen::Vector2d(lines.CrosslineStep, lines.InlineStep).asDiagonal();
  return map;
}

//----------------------------------------------------------------------------------------------------------------------
SurveyLattice FindSurveyMap(const PickPlaces& picks, const PlacementOptions& options, const Monitor& monitor)
{
  SurveyLattice lattice;
  PlaneMap map;
  if (picks.HasLines())
  {
    lattice.Lines =
      options.Lines ? options.Lines : FindLineNumbering(picks.Crossline, picks.Inline, monitor.Step(0.0, 0.5));
  }
  else if (options.Source == LatticeSource::CornerPoints)
  {
    throw InputError("corner points for picks without line numbers, expected picks with inlines and crosslines");
  }
  if (options.Source == LatticeSource::OriginAndSteps)
  {
    map = GivenMap(options);
  }
  else if (options.Source == LatticeSource::CornerPoints)
  {
    map = FitCorners(options.Corners, *lattice.Lines);
  }
  else if (!lattice.Lines)
  {
    map = FindLattice(picks.X, picks.Y, monitor);
  }
  else
  {
    map = picks.HasPlaces() ? FitPlaces(picks, *lattice.Lines, monitor.Step(0.5, 1.0)) : LinesAsPlaces(*lattice.Lines);
  }
  if (AreParallel(map.Steps.col(0), map.Steps.col(1)))
  {
    RefuseLine("positions of picks");
  }
  lattice.Origin = map.Origin;
  lattice.ColumnStep = map.Steps.col(0);
  lattice.RowStep = map.Steps.col(1);
  return lattice;
}
}
