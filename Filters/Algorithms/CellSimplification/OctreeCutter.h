// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Cuts the cubes of the elaborate simplification into leaves (thesis 4.3.2).

#ifndef SeismicHorizonsOctreeCutter_h
#define SeismicHorizonsOctreeCutter_h

#include "CellLeaves.h"
#include "Common/Types.h"
#include "CubeBox.h"
#include "ElaborateSimplification.h"

#include <cstddef>
#include <vector>

namespace SeismicHorizons
{
/// Cuts one group after the other. Each thread has its own; they may cut different groups at the same time.
class OctreeCutter
{
public:
  /// Cells of level `deepest` are not halved any more. Keeps references to the leaves and the options.
  OctreeCutter(CellLeaves& leaves, const ElaborateOptions& options, int deepest);

  /// Cuts the group of a cube into leaves, and gives their sizes. `leastLevel` is the least level of leaves without
  /// boundary points.
  CellSizes Cut(PointId* first, PointId* last, const CubeBox& cube, int leastLevel);

private:
  void CutAny(PointId* first, PointId* last, const CubeBox& box, int level);
  void CutInner(PointId* first, PointId* last, const CubeBox& box, int level);
  void CutFlat(PointId* first, PointId* last, const CubeBox& box, int level);

  bool StaysWhole(const PointId* first, const PointId* last, std::ptrdiff_t boundaryPoints, double size);
  bool AnyApart(double extent, double size) const;
  template <typename Visitor>
  void Halve(PointId* first, PointId* last, const CubeBox& box, Visitor&& visit);
  void MakeLeaf(PointId* first, int level, bool hasBoundary, bool keepsInner);

  CellLeaves& Leaves;
  const ElaborateOptions& Options;
  const int Deepest;
  int LeastLevel = 0; // of the group at hand
  CellSizes Sizes; // of its leaves so far
  // Memory to work with.
  std::vector<PointId> BoundaryPoints;
  std::vector<PointId> Order;
  std::vector<unsigned char> Octants;
};
}

#endif
