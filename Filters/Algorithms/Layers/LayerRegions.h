// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The domain of each layer: blocks of four columns that have both its horizons, and halves of blocks with three.
//
//    o---o    o        o---o    o---o        Two layers may have three columns of a block each, but not the same three.
//    |   |    | \      |  /     |  \|        Borders must not cross: then only the layers whose halves are cut along
//    the o---o    o--o     o        o   o        diagonal of the first one have theirs.

#ifndef SeismicHorizonsLayerRegions_h
#define SeismicHorizonsLayerRegions_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/ColumnIndex.h"
#include "Common/Horizon/LinkCuts.h"
#include "Common/Horizon/Types.h"
#include "Filters/Algorithms/Boundary/ExteriorBoundary.h"
#include "Filters/Algorithms/BoundarySimplification/BoundarySimplification.h"
#include "OrderedStack.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
struct LayerOutline
{
  Loops Boundary;
  std::vector<std::int32_t> Patch; // by point: NoPatch for those outside
};

/// `known` has 1 where heights count, or is empty. Points of `horizons` in other columns count below outlines. Ends of
/// cracks stay, too.
LayerOutline SimplifyOutline(PlanePoints columns, const HeightStack& heights,
  const std::vector<std::vector<unsigned char>>& known, const std::vector<HorizonView>& horizons,
  const std::vector<ColumnIndex>& indices, const ExteriorBoundary& boundary, BoundarySimplificationOptions options,
  const Monitor& monitor);

class LayerRegions
{
public:
  /// `isIn` has 1 for columns with both horizons of a layer. Keeps references. Cuts, which may be null, open blocks.
  LayerRegions(PlanePoints columns, const std::vector<std::vector<unsigned char>>& isIn, const LinkCuts* cuts);

  bool HasArea(std::size_t layer, PointId point) const;

  /// Whether a triangle, which no border crosses, lies in a layer.
  bool Holds(std::size_t layer, const std::array<PlanePoint, 3>& corners) const;

  /// The borders of layers inside the outlines of all columns, as straight lines, which do not cross. Points of loops
  /// are marked; borders end there.
  std::vector<Edge> FindBorders(const std::vector<unsigned char>& isOnLoop) const;

private:
  static constexpr int All = 15; // bits of the corners of a block: lower left, lower right, upper left, upper right

  PointId PointAt(std::int64_t x, std::int64_t y) const;
  int PresentCorners(std::size_t layer, std::int64_t x, std::int64_t y) const;
  int PartOf(std::size_t layer, std::int64_t x, std::int64_t y) const;
  int PartOfAll(std::int64_t x, std::int64_t y) const;
  template <typename Visitor>
  void ForEachBorderLink(const PlanePoint& column, Visitor&& visit) const;

  int OpenPartOf(std::int64_t x, std::int64_t y, int corners) const;

  const ColumnIndex Index; // with an empty rim
  const PlanePoints Columns;
  const std::vector<std::vector<unsigned char>>& IsIn;
  const LinkCuts* const Cuts;
  std::int64_t FirstX = 0; // of the index, rim included
  std::int64_t FirstY = 0;
};
}

#endif
