// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Approximates a horizon by a mesh of few vertices within a bound on the vertical error.
//
// The mesh of the loops is refined in rounds: triangles whose error exceeds a limit get their worst point, unless the
// round has changed them; then the limit falls (Garland and Heckbert 1995, "Fast polygonal approximation of terrains
// and height fields"). All threads measure the triangles of a round, and vertices are about as few as one by one. The
// mesh stays constrained Delaunay, except for flips before heights are fitted for a number of points.
//
// The best effort (MeshImprover.h) then removes a quarter to a half of the vertices. For a number of points, it inserts
// four times as many as may be left, and removes the cheapest.

#ifndef SeismicHorizonsDecimation_h
#define SeismicHorizonsDecimation_h

#include "Common/Base/Errors.h"
#include "Common/Base/Monitor.h"
#include "Common/Base/RawVector.h"
#include "Common/Horizon/BoundedHorizon.h"
#include "Common/Horizon/Types.h"

#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

namespace SeismicHorizons
{
/// Best also flips edges, fits heights again and removes vertices.
enum class DecimationEffort
{
  Fast,
  Best
};

/// Selects the error to minimize for a given number of points.
enum class DecimationPriority
{
  LargestError,
  SumOfSquares
};

/// How far inner edges may be from links between points where they cross them.
enum class CrossingTolerance
{
  Same, // as columns
  Twice,
  Unbounded
};

/// Infinite without a bound.
inline double MaximumCrossingError(double maximumError, CrossingTolerance crossings)
{
  return crossings == CrossingTolerance::Same ? maximumError
    : crossings == CrossingTolerance::Twice   ? 2.0 * maximumError
                                              : std::numeric_limits<double>::infinity();
}

/// What meshes of one horizon and plans of layers have in common.
struct MeshQuality
{
  /// Inner vertices may leave their columns' heights to fit the points around them (HeightFit.h), which needs fewer
  /// vertices.
  bool FitHeights = true;
  DecimationEffort Effort = DecimationEffort::Best;
  /// No change makes a smaller angle in plan (0 to 60 degrees), unless one was smaller before.
  /// It is halved until a number of points can be reached.
  double SmallestAngle = 2.0;
  /// If not 0, triangles are near equilateral, with inner edges up to this length, in columns (at least 4).
  double EdgeLength = 0.0;
  /// Edges grow by at most this part of the distance from loops; 0 for any.
  double EdgeGrowth = 0.0;
};

struct DecimationQuality : MeshQuality
{
  DecimationPriority Priority = DecimationPriority::SumOfSquares;
  CrossingTolerance Crossings = CrossingTolerance::Same;
};

/// Heights rounded to whole voxels are off by half a voxel; this error, in lattice units, comes nearest to the unrounded
/// heights.
constexpr double ErrorOfWholeVoxels = 0.75;

struct DecimationOptions : DecimationQuality
{
  /// This bounds vertical errors of points, in lattice units.
  double MaximumError = ErrorOfWholeVoxels;
  double MaximumCrossingError() const
  {
    return SeismicHorizons::MaximumCrossingError(this->MaximumError, this->Crossings);
  }
  /// If not 0, it is the target instead of MaximumError, which must be 0. Points of loops are kept.
  std::size_t MaximumNumberOfPoints = 0;
  /// If not 0, it is the target. Loops are reviewed in a mesh within MaximumError, unless that is 0.
  std::size_t MaximumNumberOfTriangles = 0;
  /// Otherwise there are no errors, and only vertices have targets.
  bool IsMeasured = true;
};

inline bool HasNumber(const DecimationOptions& options)
{
  return options.MaximumNumberOfPoints > 0 || options.MaximumNumberOfTriangles > 0;
}

/// Even meshes, and those of the fast effort, remain as points were inserted.
inline bool IsImproved(const DecimationOptions& options)
{
  return options.Effort == DecimationEffort::Best && options.MaximumError > 0.0 && options.EdgeLength == 0.0 &&
    !HasNumber(options);
}

/// Throws InputError.
void CheckQuality(const MeshQuality& quality, bool isByNumber);

struct Decimation
{
  /// A dropped point is represented by the vertex of its triangle with the largest barycentric coordinate.
  Reduction Points;
  /// Triangles are counter-clockwise seen from +z.
  RawVector<PointId> Triangles;
  /// Of columns, and of edges where they count for LargestLoopError.
  std::vector<double> Errors;
  /// Of columns, the mean with vertices.
  double LargestError = 0.0;
  double MeanError = 0.0;
  /// Of inner edges, where they cross links between points.
  double LargestEdgeError = 0.0;
  /// Of loops, which are kept whatever their error, and of inner edges where they cross links to dropped points.
  double LargestLoopError = 0.0;
  /// The most points for a number of points or triangles, otherwise 0.
  std::size_t MaximumNumberOfPoints = 0;
  /// Slivers have an angle in plan below SmallestAngle.
  std::size_t NumberOfSlivers = 0;
};

/// What a review sees of a mesh within the error, before it is improved.
struct LoopTriangles
{
  /// At least those with a corner on a loop that have changed.
  std::vector<std::array<PointId, 3>> Corners;
  /// Changed edges are farther from links to these dropped points than the error, as no point inside could part them.
  std::vector<PointId> InTheWay;
  const std::vector<double>& Heights; // of all points
  std::size_t TrianglesOfLoops = 0; // of a mesh without inner vertices
  double Error = 0.0; // bounds that of the mesh
  int Reviews = 0; // of this mesh, before this one
};

struct MovedLoops
{
  Loops Boundary;
  DroppedPoints Dropped;
  /// Triangles beside these points will be seen again.
  std::vector<PointId> ShownAgain;
};

/// Returns other loops, in which dropped points are kept or others dropped, until the mesh is good. Then it returns
/// nothing.
using LoopReview = std::function<std::optional<MovedLoops>(const LoopTriangles&)>;

/// Points must lie in distinct columns inside the loops of their patch, else InputError. Points of negative patches are
/// ignored. Takes about 28 bytes per point and 16 per column of the patches' bounding boxes. Loops are not reviewed for a
/// number of points.
Decimation Decimate(BoundedHorizon horizon, const DecimationOptions& options = DecimationOptions(),
  const Monitor& monitor = Monitor(), const LoopReview& review = {});

/// Inserts the farthest points, until the mesh has so many triangles or is within the least error. Returns how far they
/// were, down to the error of that mesh, falling: as many as are above an error take the mesh about within it.
std::vector<double> FindErrors(
  BoundedHorizon horizon, std::size_t triangles, double leastError, const Monitor& monitor = Monitor());

class MeshFit;
/// Sums must include the vertices.
void WriteErrors(MeshFit errors, std::size_t vertices, Decimation& result);

InputError TooFewTriangles(std::size_t most, std::size_t least);
}

#endif
