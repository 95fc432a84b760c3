// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Pinch-out lines as sides of a plan.

#ifndef SeismicHorizonsKeptLines_h
#define SeismicHorizonsKeptLines_h

#include "Common/ColumnIndex.h"
#include "Crossings.h"
#include "Decimation/HeightMesh.h"
#include "PinchOuts.h"

#include <cstddef>
#include <vector>

namespace SeismicHorizons
{
class KeptLines
{
public:
  /// `index` and `heights` are of what the mesh lies over, by point. `isOnLine` gets 1 for points on lines.
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

  /// Inserts the ends, which stay, and keeps what is between them. Lines whose ends are outside, as the outline was
  /// simplified, and those that cross others, are left out.
  void Keep(const PinchOutLines& lines);

  /// Lines whose fitted ends have brought them too far from a horizon need not stay: that cannot be cured by points
  /// beside them. Whether there were some.
  bool DropFar();

  /// How many straight pieces lines have, and how many of these are no sides of the plan.
  std::size_t Size() const { return this->Pieces; }
  std::size_t LeftOut() const { return this->Lost; }

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
