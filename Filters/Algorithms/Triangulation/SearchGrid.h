// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The points and boundary edges that a search looks through, in a grid of square voxels with about one point each.

#ifndef SeismicHorizonsSearchGrid_h
#define SeismicHorizonsSearchGrid_h

#include "Common/CellGrid.h"
#include "Common/CountingSort.h"
#include "Common/Types.h"

#include <algorithm>
#include <string>
#include <vector>

namespace SeismicHorizons
{
/// Points get new numbers here, voxel by voxel and row by row, so that those in a row of voxels are in one range.
class SearchGrid
{
public:
  /// Coordinates of `points` are at least 0 and below 2^29. Throws InputError when two points are in one place, a point
  /// lies on a boundary edge, or two boundary edges cross; `names` are the numbers by which messages call the points.
  SearchGrid(const std::vector<PlanePoint>& points, const Loops& boundary, const std::vector<PointId>& names);

  /// The new number of a point, and the name of the point that has a new number.
  PointId NumberOf(PointId point) const { return this->Sorted.Numbers[std::size_t(point)]; }
  PointId NameOf(PointId number) const { return this->Sorted.Names[std::size_t(number)]; }

  PointId NumberOfPoints() const { return PointId(this->Sorted.Names.size()); }

  const PlanePoint& At(PointId number) const { return this->Sorted.Places[std::size_t(number)]; }

  /// The points in a voxel have the numbers from the first to before the end.
  PointId FirstIn(std::int64_t voxel) const { return this->Sorted.Voxels.First(voxel); }
  PointId EndOf(std::int64_t voxel) const { return this->Sorted.Voxels.End(voxel); }

  /// The first points of all voxels, row by row: those of a row of voxels end at the first point of the next voxel.
  const PointId* VoxelStarts() const { return this->Sorted.Voxels.Firsts(); }

  /// The column and the row of voxels at a coordinate; for one outside the grid, of the nearest voxel in it. Quicker
  /// than CellX and CellY of the grid, as coordinates are whole and the side of a voxel is a power of two.
  std::int64_t VoxelX(std::int32_t x) const { return std::clamp((x - this->Origin.X) >> this->Shift, 0, this->Last.X); }
  std::int64_t VoxelY(std::int32_t y) const { return std::clamp((y - this->Origin.Y) >> this->Shift, 0, this->Last.Y); }

  /// How far apart points are on average: the side of a square with the area that there is for one point.
  double Spacing() const { return this->PointSpacing; }
  /// How many steps from voxel to voxel, also across corners, it is to the nearest one with boundary edges, up to 255.
  std::int64_t EdgeDistance(std::int64_t x, std::int64_t y) const
  {
    return this->EdgeDistances[std::size_t(this->Grid.Index(x, y))];
  }

  /// At() may be asked for so many numbers after the last: a search can look at this many points at once.
  static constexpr PointId Padding = 4;

  const CellGrid& Voxels() const { return this->Grid; }
  const EdgeLists& Edges() const { return this->EdgesInVoxel; }

private:
  /// The points in the order of their new numbers.
  struct SortedPoints
  {
    SortedPoints(const CellGrid& grid, const std::vector<PlanePoint>& points, const std::vector<PointId>& names);

    CountingSort<PointId> Voxels;
    std::vector<PlanePoint> Places; // by new number
    std::vector<PointId> Names; // by new number
    std::vector<PointId> Numbers; // the new numbers, by those that points had before
  };

  void MeasureEdgeDistances();
  bool AreFewAndApart(std::int64_t voxel) const;
  void CheckPlaces(std::int64_t firstVoxel, std::int64_t endVoxel) const;
  void CheckEdges(std::int64_t firstVoxel, std::int64_t endVoxel) const;
  void CheckEdge(const Edge* edge, std::int64_t voxel) const;
  std::string Describe(const Edge& edge) const;

  const double PointSpacing;
  const CellGrid Grid;
  const int Shift; // the exponent of the side of a voxel
  const PlanePoint Origin; // of the grid
  const PlanePoint Last; // the last column and the last row of voxels
  const SortedPoints Sorted;
  const EdgeLists EdgesInVoxel;
  std::vector<unsigned char> EdgeDistances; // by voxel
};
}

#endif
