// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Pinch-out lines, around areas where two neighbours of a stack have become one. Without these lines layers end in thin
// feathers far beyond them, which are within the error. The lines are found, and kept as edges of a plan.

#ifndef SeismicHorizonsPinchOuts_h
#define SeismicHorizonsPinchOuts_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/ColumnIndex.h"
#include "Common/Horizon/LinkCuts.h"
#include "Common/Horizon/Types.h"
#include "Crossings.h"
#include "Filters/Algorithms/Decimation/HeightMesh.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
struct PinchOutOptions
{
  std::int64_t SmallestPinch = 25; // columns of areas with lines, and of holes in them: at least 1
  double Tolerance = 0.0; // from the line to the columns around the area in plan, in columns
  double MaximumError = 0.0; // from the line to the upper horizon, in lattice units
  double LongestEdge = 0.0; // of lines, in columns; 0 for any
};

struct PinchOutLines
{
  std::vector<PointId> OnOutline; // ends of lines, which have to stay on the outline
  /// Each with all points of the border that it replaces. Lines of different layers may cross.
  std::vector<std::vector<PointId>> Lines;
};

/// Columns are row by row; `isOnLoop` has 1 for points of outlines.
PinchOutLines FindPinchOutLines(PlanePoints columns, const HeightStack& heights,
  const std::vector<unsigned char>& isOnLoop, const PinchOutOptions& options, const Monitor& monitor = Monitor());

class KeptLines
{
public:
  /// `index` and `heights` belong to the points below the mesh. `isOnLine` gets 1 for points on lines.
  KeptLines(HeightMesh& mesh, const ColumnIndex& index, const HeightStack& heights, double maximumError,
    std::vector<unsigned char>& isOnLine)
    : Mesh(mesh)
    , Index(index)
    , Columns(index.Columns())
    , Heights(heights)
    , MaximumError(maximumError)
    , IsOnLine(isOnLine)
  {
  }

  /// Inserts the ends of lines, and keeps the edges between. Leaves out lines that cross others or end outside.
  void Keep(const PinchOutLines& lines);

  /// Releases lines too far from a horizon, which points beside them cannot cure. Returns whether there were any.
  bool DropFar();

  std::size_t Size() const { return this->Pieces; } // straight pieces of lines
  std::size_t LeftOut() const { return this->Lost; } // pieces that are not edges of the plan

private:
  void InsertEnds(const std::vector<Edge>& edges);
  std::vector<Edge> SplitFar(const PinchOutLines& lines) const;
  bool IsFar(VertexId vertex, PointId from, PointId to) const;
  bool IsFar(TriangleId triangle, int side) const;
  template <typename EndsOf>
  bool IsAnyFar(VertexId vertex, EndsOf&& endsOf) const;
  void MarkAlong(const std::vector<Edge>& edges);

  HeightMesh& Mesh;
  const ColumnIndex& Index;
  PlanePoints Columns;
  const HeightStack& Heights;
  double MaximumError;
  std::vector<unsigned char>& IsOnLine;
  std::size_t Pieces = 0;
  std::size_t Lost = 0;
};

/// Fits heights of vertices beside faulted links by planes through connected columns at most two away. `known` has 1
/// where heights count, or is empty. Vertices around the end of a cut, or with too few columns, are left out.
std::vector<InnerHeights> FitCutoffs(const HeightMesh& mesh, const ColumnIndex& index, const HeightStack& heights,
  const std::vector<std::vector<unsigned char>>& known, const LinkCuts& cuts);
}

#endif
