// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// From the points of a horizon to a mesh: its boundary, fewest points on that, decimation; with the parameters of all
// three chosen for an error, or for a number of triangles.
//
//   radius            spans the gaps between points (GapHistogram.h)
//   tolerances        of the boundary: the error of the mesh, so that outlines are as near as the rest of it
//   smallest hole     holes that no square of side s fits in are closed, where s is the larger one of two lengths:
//                     2 radius + 1, since what a square of fewer columns leaves out is a hop from the points around it,
//                     and so no more than the gaps that the radius passes over; and twice the tolerance, since loops of
//                     narrower holes may move by half their width
//
// For a number of triangles, the error is the one for which a mesh of the fast effort has about as many. Outlines are
// simplified for it, and the mesh then gets as many vertices inside as the number leaves: each is two triangles more.

#ifndef SeismicHorizonsSurface_h
#define SeismicHorizonsSurface_h

#include "Boundary/ExteriorBoundary.h"
#include "Common/Errors.h"
#include "Common/KeptPoints.h"
#include "Common/Monitor.h"
#include "Common/Types.h"
#include "Decimation/Decimation.h"
#include "SeamChains.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace SeismicHorizons
{
/// Parameters of the boundary and of its simplification without a value are chosen. Messages about wrong ones are those
/// of the methods.
struct SurfaceOptions : DecimationQuality
{
  /// In lattice units, at least 0.
  double MaximumError = 0.75;
  /// Not 0, the target instead of the error, which counts for nothing then.
  std::size_t MaximumNumberOfTriangles = 0;
  std::optional<int> Radius;
  GrowthStrategy Growth = GrowthStrategy::Clockwise;
  bool HoleBoundaries = true;
  std::optional<std::int64_t> SmallestHoleSize;
  std::int64_t MinimumPatchSize = 1;
  std::optional<double> OutlineTolerance;
  std::optional<double> DistanceThreshold;
  /// For a part of a horizon, to be joined to others (SurfaceJoin.h). The longest edge is chosen. The parameters above
  /// then suit a seam (BoundaryOptions), and an error is the target.
  SeamRows Seams;
  /// Where the horizon is cut, or null (BoundaryOptions). Cracks stay open, whatever their size.
  const LinkCuts* Cuts = nullptr;
};

/// What the three methods were run with.
struct SurfaceParameters
{
  int Radius = 1;
  std::int64_t SmallestHoleSize = 1;
  double OutlineTolerance = 0.0;
  double DistanceThreshold = 0.0;
  /// That of the mesh, or, for a number of triangles, the one that tolerances follow: 0 when none does.
  double MaximumError = 0.0;
  /// The number of points that the mesh was made with; 0 with an error as the target.
  std::size_t MaximumNumberOfPoints = 0;
};

struct SurfacePoints
{
  PlanePoints Columns;
  std::vector<double> Height; // lattice units
};

/// How far outlines of a mesh within an error may be off on the map, in columns: where vertical indices are short, an
/// error may be many of them, and outlines stay all the same.
inline double ToleranceOfOutlines(double error)
{
  constexpr double Most = 2.0;
  return std::min(error, Most);
}

struct Surface
{
  SurfaceParameters Parameters;
  /// The points that have a patch, by which the boundary numbers them.
  KeptPoints Kept;
  ExteriorBoundary Boundary;
  /// How far points are from the simplified outlines, and how many outside (BoundarySimplification.h).
  double BoundaryDeviation = 0.0;
  double OutlineDeviation = 0.0;
  double OutlineHeightDeviation = 0.0;
  std::int64_t NumberOutside = 0;
  /// Points, numbered as the boundary does, that outlines kept only since there would be slivers next to them.
  std::vector<PointId> BesideSlivers;
  /// The mesh; its reduction is that of the points that have a patch. Empty when there are none.
  Decimation Mesh;
  /// Of a part with seams: points that were put onto their lines, and those to the left of open gaps (SeamChains.h); as
  /// the boundary numbers them.
  std::vector<SeamPin> Pins;
  std::vector<PointId> OpenGaps;
};

/// Gives what the methods give one after the other, to the bit. Throws InputError where they do, and for a number of
/// triangles below those that outlines take alone. At most MostSearchRuns (ErrorSearch.h) decimations of the fast
/// effort come before the last one for a number of triangles.
Surface MakeSurface(
  SurfacePoints points, const SurfaceOptions& options = SurfaceOptions(), const Monitor& monitor = Monitor());

/// The longest edge along a seam: the side of a square of so many columns, so that what the seam cuts of a smaller hole
/// is closed as that is; at most 64.
int ChooseLongestSeamEdge(std::int64_t smallestHoleSize);

/// The columns of the smallest hole that is left open.
std::int64_t ChooseSmallestHoleSize(int radius, double outlineTolerance);

// How far apart the points of a horizon are, and the radius of its boundary that follows.
//
//     a row of the lattice     #  #  #  .  #  .  .  #
//     its steps                 1  1   2      3

/// How many steps of each length lead from a point of a row to the next one: [n] counts those of n columns, the last
/// entry all that are longer than LargestRadius.
using GapHistogram = std::array<std::int64_t, LargestRadius + 2>;

struct GapHistograms
{
  GapHistogram AlongRows = {};
  GapHistogram AlongColumns = {};
};

/// Linear in the points, and in the rows and columns of the lattice between the outermost ones; where these are far
/// more than points, n log n. 4 bytes per such column; for points that do not come row by row 24 per point more, and 8
/// per row and column.
GapHistograms CountGaps(PlanePoints columns);

/// The least radius that spans 95 % of the steps along rows, and of those along columns; LargestRadius when none does.
/// Horizons with a point in every column have 99 % of their steps from neighbour to neighbour, whatever their outlines
/// and holes are like, and those on every n-th line none that is shorter than n; a radius for the last steps, too,
/// would bridge holes and bays.
int ChooseRadius(PlanePoints columns);

// The error for which a mesh has a number of triangles.
//
// The number falls with the error, about as its power of -1.5. So the search takes logarithms of both, in which that is
// a line: from a first error on to one on the other side of the number, and then by secants between the two.

/// How many triangles a mesh within an error has.
using TriangleCounter = std::function<std::size_t(double)>;

/// The most runs of the counter.
constexpr int MostSearchRuns = 10;
/// What no horizon of voxels can be told apart by, in lattice units.
constexpr double SmallestSearchedError = 1.0 / 1024;

/// An error from SmallestSearchedError to `largest` for which `count` gives at most `most`: as a rule from 90 % of it,
/// unless the smallest one gives less. The search begins at `first`. Throws InputError with the number for the largest
/// error when that is more than `most`. The number need not fall everywhere.
double FindErrorForTriangles(std::size_t most, double first, double largest, const TriangleCounter& count);

/// What is thrown when even the outlines take more triangles than there may be.
InputError TooFewTriangles(std::size_t most, std::size_t least);
}

#endif
