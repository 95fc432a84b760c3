// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsReducedHorizon_h
#define SeismicHorizonsReducedHorizon_h

#include "Common/Horizon/DataModel.h"
#include "Common/Horizon/DroppedPoints.h"
#include "Common/Horizon/Horizon.h"
#include "Common/Horizon/Lattice.h"
#include "Common/Horizon/MergedPoints.h"
#include "Common/Horizon/Types.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace SeismicHorizons
{
/// The array CellOrigin; origin(item) is a PointOrigin.
template <typename Items, typename Origin>
DataArray MakeOrigins(const Items& items, Origin&& origin)
{
  DataArray array = NewArray<int>(PointArray::CellOrigin, std::int64_t(items.size()), 3);
  array.ComponentNames = { "Level", "Ring", "Kind" };
  int* value = array.As<int>();
  for (const auto& item : items)
  {
    const PointOrigin& own = origin(item);
    *value++ = own.Level;
    *value++ = own.Ring;
    *value++ = int(own.Kind);
  }
  return array;
}

DataArray MakePoints(const Horizon& input, const Lattice& lattice, const Reduction& reduction);

/// `output` has its points. PointCount is summed; averaged points get means of floating-point arrays and of
/// VerticalIndex, which becomes double, weighted by PointCount, and other values of the nearest merged point.
void WriteReduction(const Horizon& input, const Reduction& reduction, Horizon& output);

/// The values of merged points that are added in parts, as of a horizon that is not in memory. Points have no
/// PointCount.
class MergedParts
{
public:
  /// targets[n] is the output point of the n-th point, NoPoint for none. Points ascend from part to part.
  void Add(const ArrayTable& points, const PointId* targets, std::int64_t size);

  std::int64_t NumberOfPoints() const { return this->Merged; }
  std::int64_t CountOf(std::int64_t target) const { return this->Counts[std::size_t(target)]; }
  /// Null for an array whose values are not averaged.
  const std::vector<FiniteMean>* FindMeans(const std::string& name) const;

private:
  std::int64_t Merged = 0;
  std::vector<std::int64_t> Counts;
  std::map<std::string, std::vector<FiniteMean>> Means; // by array, of all components
};

/// The same for input points in parts: `nearest` has the source of each output point.
void WriteReduction(const Horizon& nearest, const MergedParts& merged, const Reduction& reduction, Horizon& output);

/// Loops are given in points of the input. Counts of dropped points are added to PointCount. Arrays are shared if no
/// point is dropped.
void WriteDropped(const Horizon& input, const DroppedPoints& dropped, const Loops& boundary, Horizon& output);
}

#endif
