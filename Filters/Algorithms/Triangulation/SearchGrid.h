// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The points and boundary edges that a search looks through, in a grid of square voxels with about one point each.

#ifndef SeismicHorizonsSearchGrid_h
#define SeismicHorizonsSearchGrid_h

#include "Common/CellGrid.h"
#include "Common/Types.h"

#include <vector>

namespace SeismicHorizons
{
/// Points get numbers of their own, voxel by voxel: those of a row of voxels follow each other.
class SearchGrid
{
public:
  /// Coordinates are at least 0 and below 2^29. Throws InputError when two points are in one place, a point lies on a
  /// boundary edge, or two boundary edges cross; `names` gives the numbers by which messages call the points.
  SearchGrid(const std::vector<PlanePoint>& points, const Loops& boundary, const std::vector<PointId>& names);

  /// The number a point got, and the name of the point with such a number.
  PointId NumberOf(PointId point) const { return this->Sorted.Numbers[std::size_t(point)]; }
  PointId NameOf(PointId number) const { return this->Sorted.Names[std::size_t(number)]; }

  const PlanePoint& At(PointId number) const { return this->Sorted.Places[std::size_t(number)]; }

  /// The points in a voxel are those from the first to before the end.
  PointId FirstIn(std::int64_t voxel) const { return this->Sorted.Starts[std::size_t(voxel)]; }
  PointId EndOf(std::int64_t voxel) const { return this->Sorted.Starts[std::size_t(voxel) + 1]; }

  /// How far apart points are on average.
  double Spacing() const { return this->PointSpacing; }
  /// How many steps to neighbours, also across corners, a voxel is away from one with boundary edges, up to 255.
  std::int64_t EdgeDistance(std::int64_t x, std::int64_t y) const
  {
    return this->EdgeDistances[std::size_t(this->Grid.Index(x, y))];
  }

  /// Places may be read for so many numbers after the last.
  static constexpr PointId Padding = 4;

  const CellGrid& Voxels() const { return this->Grid; }
  const EdgeLists& Edges() const { return this->EdgesInCell; }

private:
  /// The points in the order of the search.
  struct SortedPoints
  {
    SortedPoints(const CellGrid& grid, const std::vector<PlanePoint>& points, const std::vector<PointId>& names);

    std::vector<PlanePoint> Places; // voxel by voxel
    std::vector<PointId> Names; // the same
    std::vector<PointId> Starts; // for each voxel its first point
    std::vector<PointId> Numbers; // by the numbers that points had before
  };

  void MeasureEdgeDistances();
  void CheckPlaces() const;
  void CheckEdges() const;

  const double PointSpacing;
  const CellGrid Grid;
  const SortedPoints Sorted;
  const EdgeLists EdgesInCell;
  std::vector<unsigned char> EdgeDistances; // by voxel
};
}

#endif
