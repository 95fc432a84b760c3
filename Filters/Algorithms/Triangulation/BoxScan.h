// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Looks through the points of a block of voxels for the third point of an edge, four at a time.
//
// Of the points to the left of the edge, that with the least cotangent is looked for: of the angle at which it sees the
// edge. Cotangents are calculated in single precision for all points. Those that exceed the least one by no more than
// some slack are candidates: most often one, on a lattice often two. ThirdPointQuery::Consider compares candidates
// exactly. So all that matters is that the slack is larger than rounding.
//
// It is for points that are far enough from the line through the edge. In a box of size s, with an edge of length e,
// the scalar product and the doubled area of a point are right to r = 48 u s (s + e), where u is the rounding of a
// number of size 1. So their quotient c is right to r (1 + |c|) / area: for an area of 4 r / slack, to a quarter of the
// slack. Points that are nearer to the line are candidates as well, if they may be better than the caller asks for.
// Mostly these are the ends of the edge alone; then they are left out.

#ifndef SeismicHorizonsBoxScan_h
#define SeismicHorizonsBoxScan_h

#include "FloatBatch.h"
#include "SearchGrid.h"
#include "ThirdPointQuery.h"

namespace SeismicHorizons
{
/// The voxels that the part of a circle to the left of an edge may touch. The circle is that of the points to the left
/// from which the edge is seen at an angle with some cotangent; `radius` is its own.
VoxelBox VoxelsOfCircle(const ThirdPointQuery& query, float cotangent, float radius);

/// The same for the circle of the best point so far.
VoxelBox VoxelsOfBest(const ThirdPointQuery& query);

class BoxScan
{
public:
  /// Lets the query consider those of the points in a box, in which the edge has to be, that may be the third point, as
  /// long as there is one whose cotangent is not above the bound; else perhaps others, or none. When only visible
  /// points count, these are all up to the bound.
  static void Run(ThirdPointQuery& query, const VoxelBox& box, float bound);

private:
  BoxScan(ThirdPointQuery& query, const VoxelBox& box, float bound);

  template <bool WithNear>
  int Visit(const VoxelBox& box);

  template <bool WithNear>
  int Evaluate(const PointId* batches, std::size_t count);

  float LimitFor(const FloatBatch& lowest) const;

  // So many batches are evaluated at a time. They are listed first, without a branch on how many a row has where it has
  // no more than three: a branch that a processor predicts wrongly takes it as long as a batch.
  static constexpr std::size_t Capacity = 8;
  static constexpr std::size_t MostPerRow = 3;

  ThirdPointQuery& Query;
  const float EdgeX;
  const float EdgeY;
  const float Bound;
  float Near; // the doubled area of a triangle whose third point is near the line through the edge
  FloatBatch Lowest; // of the cotangents so far
};
}

#endif
