// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Looks through the points of a block of voxels for the third point of an edge, four at a time.
//
// Of the points to the left of the edge, that with the least cotangent is looked for: of the angle at which it sees the
// edge. Cotangents are calculated in single precision for all points. Those that are less than the least one, or not
// more by some slack, are candidates: most often there is one, on a lattice often two. ThirdPointQuery::Consider
// compares candidates exactly. So the slack has to be larger than the rounding.
//
// That is so for points that are far enough from the line through the edge: with s, the size of the block and of the
// edge, and u, the rounding of a number, scalar product and doubled area are right to 48 u s^2, and their quotient c to
// 48 u s^2 (1 + |c|) / area. From an area of 4 * 48 u s^2 / slack on, that is a quarter of the slack. Points that are
// nearer to the line are candidates, too, if they might be better than those the caller asks for. Most often these are
// only the ends of the edge; then they are left out.

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
  /// long as there is one whose cotangent is not above the bound; else perhaps others, or none. When only visible points
  /// count, these are all up to the bound.
  static void Run(ThirdPointQuery& query, const VoxelBox& box, float bound);

private:
  BoxScan(ThirdPointQuery& query, const VoxelBox& box, float bound);

  template <bool WithNear>
  int Visit(const VoxelBox& box);

  template <bool WithNear>
  int Evaluate(const PointId* batches, std::size_t count);

  float Limit() const;

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
