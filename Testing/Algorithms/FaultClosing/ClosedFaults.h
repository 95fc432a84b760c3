// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Cracked lattices with the open ends of their cracks, through the simplifications.

#ifndef SeismicHorizonsClosedFaults_h
#define SeismicHorizonsClosedFaults_h

#include "Filters/Algorithms/FaultClosing/FaultClosing.h"
#include "Filters/Algorithms/Triangulation/Triangulation.h"
#include "Tools/ClosingChecker.h"
#include "Tools/TestHorizons.h"

#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace ClosedFaults
{
using namespace TestHorizons;
using CrackedPatches::CrackedPatch;

struct Cracked
{
  BoundedHorizon Horizon;
  Cracks Open;
};

inline Cracked Make(const CrackedPatch& patch, const BoundaryOptions& options, const std::vector<double>& heights)
{
  ExteriorBoundary boundary = FindExteriorBoundary(patch.Columns, options);
  const KeptPoints kept = DropPointsWithoutPatch(boundary);
  Cracked cracked;
  cracked.Open = std::move(boundary.OpenCracks);
  BoundedHorizon& horizon = cracked.Horizon;
  for (const PlanePoint& column : kept.Select(patch.Columns))
  {
    horizon.Plane.push_back({ column.X * SubVoxelsPerColumn, column.Y * SubVoxelsPerColumn });
  }
  horizon.Height = kept.Select(heights);
  horizon.Patch = std::move(boundary.Patch);
  horizon.Count.assign(kept.size(), 1);
  horizon.Boundary = std::move(boundary.Boundary);
  horizon.SubVoxelsPerColumn = SubVoxelsPerColumn;
  horizon.Cuts = std::make_shared<const LinkCuts>(patch.Cuts);
  return cracked;
}

/// The same cracks in a horizon of fewer points: the points of open ends are still there.
inline Cracks FindAgain(const Cracked& cracked, const BoundedHorizon& horizon)
{
  std::map<PlanePoint, PointId> pointAt;
  for (std::size_t point = 0; point < horizon.Plane.size(); ++point)
  {
    pointAt[horizon.Plane[point]] = PointId(point);
  }
  Cracks cracks = cracked.Open;
  for (Edge& openEnd : cracks.OpenEnds)
  {
    openEnd = { pointAt.at(cracked.Horizon.Plane[openEnd.From]), pointAt.at(cracked.Horizon.Plane[openEnd.To]) };
  }
  return cracks;
}

/// With the points of open ends kept.
inline BoundedHorizon Simplify(const Cracked& cracked, BoundarySimplificationOptions options)
{
  options.Fixed = cracked.Open.PointsOfOpenEnds();
  BoundedHorizon result =
    Drop(cracked.Horizon, SimplifyBoundary(OnColumns(cracked.Horizon), cracked.Horizon.Boundary, options));
  result.Cuts = cracked.Horizon.Cuts;
  return result;
}

inline RawVector<PointId> Close(const Cracked& cracked, const BoundedHorizon& horizon)
{
  return CloseFaults(horizon.Plane, horizon.Boundary, FindAgain(cracked, horizon));
}
}

#endif
