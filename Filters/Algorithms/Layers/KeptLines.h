// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Pinch-out lines as edges of a plan.

#ifndef SeismicHorizonsKeptLines_h
#define SeismicHorizonsKeptLines_h

#include "Common/Horizon/ColumnIndex.h"
#include "Common/Horizon/LinkCuts.h"
#include "Crossings.h"
#include "Filters/Algorithms/Decimation/HeightMesh.h"
#include "PinchOuts.h"

#include <cstddef>
#include <vector>

namespace SeismicHorizons
{
/// Fits heights of vertices beside faulted links by planes through connected columns at most two away. `known` has 1
/// where heights count, or is empty. Vertices around the end of a cut, or with too few columns, are left out.
std::vector<InnerHeights> FitCutoffs(const HeightMesh& mesh, const ColumnIndex& index, const HeightStack& heights,
  const std::vector<std::vector<unsigned char>>& known, const LinkCuts& cuts);

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
}

#endif
