// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A mesh of few vertices that is nowhere farther from the horizon than a bound.
//
// The first mesh has the points of the loops alone. Then points are inserted where it is farthest from the horizon,
// until it is near enough or has as many vertices as it may have (Garland and Heckbert 1995, "Fast polygonal
// approximation of terrains and height fields"). This is done in rounds: in each, all triangles whose error is above a
// limit get their worst point, from the largest error down, but for those that an insertion of the round has changed.
// When none is above the limit, it falls to a part of the largest error. So all that costs time, the measuring of the
// triangles that are new, is done by all threads at once, and the vertices are about as few as one by one.
//
// The mesh is at all times the constrained Delaunay triangulation of its vertices: that of Triangulation.h. Only where
// heights are fitted for a number of points, sides are flipped once before, as the best effort does.
//
// The best effort goes on from there (MeshImprover.h). It removes vertices as long as the error is kept, flips sides
// for which the mesh comes nearer to the horizon, fits heights and removes again: that takes a quarter to a half of
// them. For a number of points it inserts four times as many as may be left, and removes the cheapest ones.

#ifndef SeismicHorizonsDecimation_h
#define SeismicHorizonsDecimation_h

#include "Common/BoundedHorizon.h"
#include "Common/Monitor.h"
#include "Common/RawVector.h"
#include "Common/Types.h"

#include <cstddef>
#include <vector>

namespace SeismicHorizons
{
enum class DecimationEffort
{
  Fast, // points are inserted
  Best // then sides are flipped, heights fitted and vertices removed again
};

/// With a number of points as the target, which error becomes small.
enum class DecimationPriority
{
  LargestError,
  SumOfSquares // of the errors of all points, and with it their mean
};

/// What a mesh with few points is like, however many these are.
struct DecimationQuality
{
  /// Whether heights of inner vertices are fitted to the points around them (HeightFit.h), which takes fewer vertices;
  /// else every vertex is a point of the horizon.
  bool FitHeights = true;
  DecimationEffort Effort = DecimationEffort::Best;
  DecimationPriority Priority = DecimationPriority::SumOfSquares;
  /// 0 to 60 degrees, in plan: no flip and no removal makes a smaller angle, but where there was
  /// a smaller one before. Where a number of points cannot be met so, it is halved until that is.
  double SmallestAngle = 2.0;
};

struct DecimationOptions : DecimationQuality
{
  /// The largest vertical distance of a point from the mesh, and of a side of the mesh from the line between two
  /// neighbouring columns that it crosses, in lattice units: at least 0. Heights that are rounded to whole voxels are
  /// half a voxel off; three quarters bring the mesh nearest to what was rounded.
  double MaximumError = 0.75;
  /// Not 0, the target instead of an error, which then is 0: so many points at most, at least those of the loops.
  std::size_t MaximumNumberOfPoints = 0;
};

struct Decimation
{
  /// The vertices: all points of loops, and the inner points that are left. A dropped point counts for the vertex of
  /// its triangle with the largest barycentric coordinate.
  Reduction Points;
  /// Three vertices per triangle, counter-clockwise seen from +z on the lattice.
  RawVector<PointId> Triangles;
  /// For each triangle the largest vertical distance of a point inside it or on its sides.
  std::vector<double> Errors;
  /// Of these the largest, and the mean over all points, vertices included.
  double LargestError = 0.0;
  double MeanError = 0.0;
  /// The same for sides of the mesh where they cross lines between columns: inner sides, and those of loops, which are
  /// kept as they are whatever their error.
  double LargestSideError = 0.0;
  double LargestLoopError = 0.0;
  /// Triangles with an angle in plan below the smallest one that was asked for: sides of loops leave no other.
  std::size_t NumberOfSlivers = 0;
};

/// The places of the points are columns, one at most in each, inside the loops of their patch; heights are finite.
/// Points of a negative patch are not looked at, and nothing represents them. Throws InputError otherwise, and when
/// triangulating the loops does. Takes about 28 bytes per point and 16 per column of the bounding box of a patch,
/// beside the result, and the memory of the horizon where that is moved.
Decimation Decimate(
  BoundedHorizon horizon, const DecimationOptions& options = DecimationOptions(), const Monitor& monitor = Monitor());

/// Its triangles alone, three points of the horizon each: what their errors are is not measured.
RawVector<PointId> MeshOf(BoundedHorizon horizon, const DecimationOptions& options, const Monitor& monitor = Monitor());
}

#endif
