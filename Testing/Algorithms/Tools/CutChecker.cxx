// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CutChecker.h"

#include "Common/Horizon/PlaneGeometry.h"
#include "CutLattice.h"
#include "ExactPlane.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace CutChecker
{
using namespace ExactPlane;
using SeismicHorizons::BoundaryOptions;
using SeismicHorizons::ExteriorBoundary;
using SeismicHorizons::PlaneBox;
using SeismicHorizons::PointId;

namespace
{
/// For each point the least one that the hops to neighbours connect it with.
std::vector<std::size_t> Connect(const CrackedPatch& patch, const CutLattice& lattice)
{
  std::vector<std::size_t> parts(patch.Columns.size());
  std::iota(parts.begin(), parts.end(), std::size_t(0));
  const auto join = [&](const PlanePoint& a, const PlanePoint& b)
  {
    if (lattice.Has(a) && lattice.Has(b))
    {
      const std::size_t one = parts[std::size_t(lattice.At(a))];
      const std::size_t other = parts[std::size_t(lattice.At(b))];
      std::replace(parts.begin(), parts.end(), std::max(one, other), std::min(one, other));
    }
  };
  ForEachBlock(lattice.Extent(),
    [&](const PlanePoint& block)
    {
      const std::array<PlanePoint, 4> corners = CutLattice::Corners(block);
      const std::array<bool, 4> cut = lattice.CutSides(block);
      for (std::size_t n = 0; n < 4; ++n)
      {
        cut[n] ? void() : join(corners[n], corners[(n + 1) % 4]);
      }
      for (int n = 0; n < 2; ++n)
      {
        lattice.HasDiagonal(block, n) ? join(corners[std::size_t(n)], corners[std::size_t(n + 2)]) : void();
      }
    });
  return parts;
}

Wide TwiceAreaOf(const std::vector<PlanePoint>& places, const Loops& loops)
{
  Wide area = 0;
  loops.ForEachEdge(
    [&](PointId from, PointId to) { area -= Cross(places[std::size_t(from)], places[std::size_t(to)]); });
  return area;
}

/// What follows from the definition of hops to neighbours when all holes have loops.
std::string CheckBlocks(const CrackedPatch& patch, const ExteriorBoundary& boundary)
{
  const CutLattice lattice(patch);
  Wide area = 0;
  ForEachBlock(lattice.Extent(), [&](const PlanePoint& block) { area += lattice.TwiceArea(block); });
  if (TwiceAreaOf(patch.Columns, boundary.Boundary) != area)
  {
    return "area of the patches";
  }
  const std::vector<std::size_t> parts = Connect(patch, lattice);
  for (std::size_t a = 0; a < parts.size(); ++a)
  {
    for (std::size_t b = 0; b < a; ++b)
    {
      if ((parts[a] == parts[b]) != (boundary.Patch[a] == boundary.Patch[b]))
      {
        return "patches of points " + std::to_string(a) + " and " + std::to_string(b);
      }
    }
  }
  return {};
}

/// Calls visit(place) for places on all cuts, in quarters of columns: where a cut meets its link, its ends in the
/// middles of blocks unless the surface reaches these, and between.
template <typename Visitor>
void ForEachCutPlace(const CrackedPatch& patch, Visitor&& visit)
{
  const CutLattice lattice(patch);
  ForEachBlock(lattice.Extent(),
    [&](const PlanePoint& block)
    {
      const std::array<bool, 4> cut = lattice.CutSides(block);
      const std::array<PlanePoint, 4> outward = { PlanePoint{ 0, -1 }, PlanePoint{ 1, 0 }, PlanePoint{ 0, 1 },
        PlanePoint{ -1, 0 } };
      for (std::size_t n = 0; n < 4; ++n)
      {
        for (int part = lattice.LoneCorner(block) < 0 ? 0 : 1; cut[n] && part <= 2; ++part)
        {
          visit(PlanePoint{ 4 * block.X + 2 + part * outward[n].X, 4 * block.Y + 2 + part * outward[n].Y });
        }
      }
    });
}

bool HoldsCut(const CrackedPatch& patch, const ExteriorBoundary& boundary, std::size_t loop)
{
  Loops single;
  single.AppendLoop(boundary.Boundary, loop);
  std::vector<PlanePoint> places;
  for (const PlanePoint& column : patch.Columns)
  {
    places.push_back({ 4 * column.X, 4 * column.Y });
  }
  bool holds = false;
  ForEachCutPlace(patch, [&](const PlanePoint& place) { holds = holds || Locate(places, single, place) > 0; });
  return holds;
}

/// Columns strictly inside a loop.
std::int64_t CountInside(const CrackedPatch& patch, const ExteriorBoundary& boundary, std::size_t loop)
{
  Loops single;
  single.AppendLoop(boundary.Boundary, loop);
  std::int64_t inside = 0;
  ForEachBlock(PlaneBox(patch.Columns),
    [&](const PlanePoint& column) { inside += Locate(patch.Columns, single, column) > 0 ? 1 : 0; });
  return inside;
}
}

//----------------------------------------------------------------------------------------------------------------------
std::string CheckCuts(const CrackedPatch& patch, const std::vector<PlanePoint>& places, const Loops& loops, int scale)
{
  std::string wrong;
  ForEachCutPlace(patch,
    [&](const PlanePoint& place)
    {
      if (wrong.empty() && Locate(places, loops, { place.X * (scale / 4), place.Y * (scale / 4) }) >= 0)
      {
        wrong =
          "surface across the cut at (" + std::to_string(0.25 * place.X) + ", " + std::to_string(0.25 * place.Y) + ")";
      }
    });
  return wrong;
}

//----------------------------------------------------------------------------------------------------------------------
std::string CheckBoundary(const CrackedPatch& patch, const ExteriorBoundary& boundary, const BoundaryOptions& options)
{
  std::vector<PlanePoint> places;
  for (const PlanePoint& column : patch.Columns)
  {
    places.push_back({ 4 * column.X, 4 * column.Y });
  }
  std::string wrong = CheckCuts(patch, places, boundary.Boundary, 4);
  for (std::size_t loop = boundary.NumberOfPatches; wrong.empty() && loop < boundary.Boundary.Size(); ++loop)
  {
    const std::int64_t inside = CountInside(patch, boundary, loop);
    const bool isHole = options.KeepHoles && inside > 0 && inside >= options.SmallestHoleSize;
    if (!isHole && !HoldsCut(patch, boundary, loop))
    {
      wrong = "hole " + std::to_string(loop) + " holds no cut, and has the size " + std::to_string(inside);
    }
  }
  const bool hasAllHoles = options.Radius == 1 && options.KeepHoles && options.SmallestHoleSize == 1;
  return wrong.empty() && hasAllHoles ? CheckBlocks(patch, boundary) : wrong;
}
}
