// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Makes a mesh from points: boundary, fewest points on outlines, decimation. An error or a number of triangles
// determines:
// - radius: the least that spans nearly all gaps between points
// - tolerances: the error, for outlines at most 0.75 columns, unless they need most of a number of triangles
// - smallest hole: a square of side 2 radius + 1, as narrower holes are gaps that the radius spans, or of twice the
// tolerance, as outlines may close narrower holes
//
// For a number of triangles, outlines are simplified for the error that is expected to leave that many, of the points that
// are farther from a first mesh when they are inserted. Inner vertices, two triangles each, fill up the number.

#ifndef SeismicHorizonsSurface_h
#define SeismicHorizonsSurface_h

#include "Common/Base/Errors.h"
#include "Common/Base/Monitor.h"
#include "Common/Horizon/BoundedHorizon.h"
#include "Common/Horizon/KeptPoints.h"
#include "Common/Horizon/PlaneGeometry.h"
#include "Common/Horizon/Types.h"
#include "Filters/Algorithms/Boundary/ExteriorBoundary.h"
#include "Filters/Algorithms/Decimation/Decimation.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace SeismicHorizons
{
class PartRanks;

/// Parameters without a value are chosen.
struct SurfaceOptions : DecimationQuality
{
  /// The error is in lattice units, at least 0.
  double MaximumError = ErrorOfWholeVoxels;
  /// If not 0, it replaces the error as the target.
  std::size_t MaximumNumberOfTriangles = 0;
  std::optional<int> Radius;
  GrowthStrategy Growth = GrowthStrategy::Clockwise;
  bool KeepHoles = true;
  std::optional<std::int64_t> SmallestHoleSize;
  std::int64_t MinimumPatchSize = 1;
  std::optional<double> OutlineTolerance;
  std::optional<double> DistanceThreshold;
  /// Cracks along cut links stay open, whatever their size. Null means no faults.
  const LinkCuts* Cuts = nullptr;
  /// Large horizons are meshed in parts (SurfaceParts.h) of so many rows; chosen if 0.
  std::int32_t RowsOfPart = 0;
  /// Processes that mesh large horizons together, of which this is process 0 (RankedParts.h). Null means this one alone.
  const PartRanks* Ranks = nullptr;
};

struct SurfaceParameters
{
  int Radius = 1;
  std::int64_t SmallestHoleSize = 1;
  double OutlineTolerance = 0.0;
  double DistanceThreshold = 0.0;
  /// For a number of triangles, tolerances follow it; it is 0 if none does.
  double MaximumError = 0.0;
  /// The target is an error if this is 0.
  std::size_t MaximumNumberOfPoints = 0;
};

struct SurfacePoints
{
  PlanePoints Columns;
  std::vector<double> Height; // lattice units
};

/// The tolerance of outlines on the map, in columns. It has a limit below 1, so that outlines stay on their side of the
/// middle of holes that are two or more columns wide, however large the vertical error is.
inline double ToleranceOfOutlines(double error)
{
  constexpr double Most = 0.75;
  return std::min(error, Most);
}

struct Surface
{
  SurfaceParameters Parameters;
  /// Points without a patch are dropped; the boundary numbers the rest.
  KeptPoints Kept;
  ExteriorBoundary Boundary;
  double BoundaryDeviation = 0.0;
  double OutlineDeviation = 0.0;
  double OutlineHeightDeviation = 0.0;
  std::int64_t NumberOutside = 0;
  /// Outlines kept these points beside slivers, and on links that edges would cross farther away than the error.
  std::vector<PointId> AddedToOutlines;
  /// From outlines; in the numbers of kept points, like the boundary.
  DroppedPoints Dropped;
  /// The mesh is empty if no point has a patch.
  Decimation Mesh;
};

/// Equals the three methods in sequence only if SmallestAngle is 0 and crossings have no bound; otherwise outlines keep
/// points.
/// Throws InputError as they do, and if outlines alone need more triangles.
Surface MakeSurface(
  SurfacePoints points, const SurfaceOptions& options = SurfaceOptions(), const Monitor& monitor = Monitor());

/// Part of a horizon with a boundary that is known, and is simplified between points that stay.
struct KnownBoundary
{
  Loops Boundary;
  std::vector<PointId> Fixed;
  std::vector<LockedHeight> Locked; // of fixed points, ascending
  DroppedPoints Dropped; // beside edges between fixed points
};

/// Options must have a radius, and an error as the target.
Surface MakePart(SurfacePoints points, const SurfaceOptions& options, KnownBoundary part, const Monitor& monitor);

std::int64_t ChooseSmallestHoleSize(int radius, double outlineTolerance);

// Steps between neighbouring points determine the radius.
//
//     a row of the lattice     #  #  #  .  #  .  .  #
//     its steps                 1  1   2      3

/// Entry n counts steps of n columns, the last entry all beyond LargestRadius.
using GapHistogram = std::array<std::int64_t, LargestRadius + 2>;

struct GapHistograms
{
  GapHistogram AlongRows = {};
  GapHistogram AlongColumns = {};
};

GapHistograms CountGaps(PlanePoints columns);

/// Counts the gaps of columns that are added row by row.
class GapCounter
{
public:
  explicit GapCounter(const PlaneBox& box);
  void Add(PlanePoints columns);
  const GapHistograms& Counted() const { return this->Gaps; }

private:
  GapHistograms Gaps;
  bool IsAny = false;
  PlanePoint Last;
  std::int32_t FirstX;
  std::vector<std::int32_t> Rows; // by x, of the last column there
};

/// Returns the least radius that spans 95 % of the steps along both axes. Full horizons have 99 % single steps, lines
/// at every n-th column none below n; a radius for the last steps would bridge holes and bays.
int ChooseRadius(const GapHistograms& gaps);
int ChooseRadius(PlanePoints columns);

/// The parameters that follow from an error, which is also the tolerance of a number of triangles.
/// Far outlines have no limit of their tolerance, so that few triangles suffice for them.
SurfaceParameters ParametersFor(const SurfaceOptions& options, int radius, double error, bool areOutlinesFar = false);
BoundaryOptions BoundaryOptionsFor(const SurfaceOptions& options, const SurfaceParameters& parameters);

// The number of triangles falls about as the error to the power of -1.5, a line in logarithms. The search follows it
// until errors on both sides of the number are known, then takes secants.

using TriangleCounter = std::function<std::size_t(double)>;

constexpr int MostSearchRuns = 10;
/// Smaller errors, in lattice units, make no difference.
constexpr double SmallestSearchedError = 1.0 / 1024;

/// Finds an error up to `largest` for which `count` usually gives 90 to 100 % of `most`; it need not fall everywhere.
/// Throws InputError if `largest` gives more.
double FindErrorForTriangles(std::size_t most, double first, double largest, const TriangleCounter& count);
}

#endif
