// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where each layer of a stack is, where that differs from layer to layer: in blocks of four columns that all have both
// its horizons, and halves of blocks with three.
//
//    o---o    o        o---o    o---o        Two layers may have three columns of a block each, but not the same three.
//    |   |    | \      |  /     |  \|        Borders must not cross: then only the layers whose halves are cut along
//    the o---o    o--o     o        o   o        diagonal of the first one have theirs.

#ifndef SeismicHorizonsLayerRegions_h
#define SeismicHorizonsLayerRegions_h

#include "Common/ColumnIndex.h"
#include "Common/LinkCuts.h"
#include "Common/Types.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
class LayerRegions
{
public:
  /// For each layer 1 for the columns that have both its horizons, else 0. Keeps references. Cuts may be null; no layer
  /// is where these leave a block open (CutBlocks.h).
  LayerRegions(PlanePoints columns, const std::vector<std::vector<unsigned char>>& isIn, const LinkCuts* cuts);

  /// Whether a layer has a part of one of the four blocks around a column that reaches the column.
  bool HasArea(std::size_t layer, PointId point) const;

  /// Whether a triangle that no border crosses lies in a layer.
  bool Holds(std::size_t layer, const std::array<PlanePoint, 3>& corners) const;

  /// The borders of all layers but for what is the border of all columns together, each once, as straight lines along
  /// rows, columns or diagonals of the lattice. They end at points of loops, which are marked, and do not cross.
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
