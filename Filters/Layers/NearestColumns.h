// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsNearestColumns_h
#define SeismicHorizonsNearestColumns_h

#include "Common/Base/CountingSort.h"
#include "Common/Horizon/Types.h"

namespace SeismicHorizons
{
/// Finds the nearest column on the map, in bins with about one column each. Of columns that are equally near it is the
/// one that vtkStaticPointLocator finds, which results of earlier versions have.
class NearestColumns
{
public:
  /// Without a copy; there is at least one column.
  explicit NearestColumns(PlanePoints columns);

  PointId Find(const PlanePoint& place) const;

private:
  struct Axis
  {
    double Least = 0.0;
    double BinsPerColumn = 0.0;
    std::int64_t Bins = 1;

    /// Places beyond are in the outermost bins.
    std::int64_t BinOf(double place) const;
  };

  struct Nearest
  {
    PointId Point = NoPoint;
    std::int64_t SquaredDistance = 0;
  };

  /// Keeps the first of the nearest columns of the bins so far.
  void Compare(std::int64_t x, std::int64_t y, const PlanePoint& place, Nearest& nearest) const;

  PlanePoints Columns;
  Axis X;
  Axis Y;
  ItemLists<PointId> Bins; // of points, by x of the bin first
};
}

#endif
