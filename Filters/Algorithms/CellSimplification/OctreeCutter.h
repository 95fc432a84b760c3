// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Cuts the cubes of the elaborate simplification into leaves (thesis 4.3.2).

#ifndef SeismicHorizonsOctreeCutter_h
#define SeismicHorizonsOctreeCutter_h

#include "CellLeaves.h"
#include "Common/Types.h"
#include "ElaborateSimplification.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// The sizes of the cells of some leaves.
struct LeafSizes
{
  std::int64_t Sum = 0; // in units of the smallest size that halving can give, so that sums are exact
  std::int64_t Number = 0;

  void Add(const LeafSizes& other)
  {
    this->Sum += other.Sum;
    this->Number += other.Number;
  }
};

/// A cube, or an octant of one: its least corner and its side. Its own octants begin at the middle.
struct CubeBox
{
  std::int64_t X = 0; // sub-voxels
  std::int64_t Y = 0;
  double Z = 0.0; // lattice units
  std::int64_t PlaneSize = 0; // the side in sub-voxels
  double Size = 0.0; // the side in lattice units

  /// In which octant a place is, 0 to 7.
  int OctantOf(const PlanePoint& place, double height) const
  {
    const std::int64_t half = this->PlaneSize / 2;
    return int(place.X - this->X >= half) + 2 * int(place.Y - this->Y >= half) +
      4 * int(height - this->Z >= 0.5 * this->Size);
  }

  CubeBox Octant(int octant) const
  {
    CubeBox result(*this);
    result.PlaneSize = this->PlaneSize / 2;
    result.Size = 0.5 * this->Size;
    result.X += (octant & 1) ? result.PlaneSize : 0;
    result.Y += (octant & 2) ? result.PlaneSize : 0;
    result.Z += (octant & 4) ? result.Size : 0.0;
    return result;
  }
};

/// Cuts one group after the other. Each thread has its own; they may cut different groups at the same time.
class OctreeCutter
{
public:
  /// Cells of level `deepest` are not halved any more. Keeps references to the leaves and the options.
  OctreeCutter(CellLeaves& leaves, const ElaborateOptions& options, int deepest);

  /// Cuts the group of a cube into leaves, and gives their sizes. `leastLevel` is the least level of leaves without
  /// boundary points.
  LeafSizes Cut(PointId* first, PointId* last, const CubeBox& cube, int leastLevel);

private:
  void CutAny(PointId* first, PointId* last, const CubeBox& box, int level);
  void CutInner(PointId* first, PointId* last, const CubeBox& box, int level);
  void CutFlat(PointId* first, PointId* last, const CubeBox& box, int level);

  bool StaysWhole(const PointId* first, const PointId* last, std::ptrdiff_t boundaryPoints, double size);
  bool AnyApart(double extent, double size) const;
  bool IsFlat(const PointId* first, const PointId* last) const;
  template <typename Visitor>
  void Halve(PointId* first, PointId* last, const CubeBox& box, Visitor&& visit);
  void MakeLeaf(PointId* first, int level, bool hasBoundary, bool keepsInner);
  Eigen::Vector3d Place(PointId point) const;

  CellLeaves& Leaves;
  const ElaborateOptions& Options;
  const int Deepest;
  int LeastLevel = 0; // of the group at hand
  LeafSizes Sizes; // of its leaves so far
  // Memory to work with.
  std::vector<PointId> BoundaryPoints;
  std::vector<PointId> Order;
  std::vector<unsigned char> Octants;
};
}

#endif
