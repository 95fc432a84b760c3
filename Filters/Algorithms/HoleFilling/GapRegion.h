// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A gap with the known columns around it, cut out of the lattice.

#ifndef SeismicHorizonsGapRegion_h
#define SeismicHorizonsGapRegion_h

#include "BoxPlaces.h"
#include "Common/ColumnIndex.h"
#include "Common/LinkCuts.h"
#include "SiteSolver.h"

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
/// Where the places of a index are on the lattice.
class RasterFrame
{
public:
  RasterFrame(const ColumnIndex& index, std::vector<std::int32_t> columnOf, std::vector<std::int32_t> rowOf)
    : Width(index.Width())
    , ColumnOf(std::move(columnOf))
    , RowOf(std::move(rowOf))
  {
  }

  PlanePoint Column(std::int64_t place) const
  {
    return { this->ColumnOf[place % this->Width], this->RowOf[place / this->Width] };
  }

private:
  std::int64_t Width;
  std::vector<std::int32_t> ColumnOf;
  std::vector<std::int32_t> RowOf;
};

/// What a place of a region is.
enum class PlaceKind : unsigned char
{
  Other = 0,
  Gap = 1,
  Ring = 2 // a known column near the gap
};

/// The surroundings of a gap in a box of their own. The box is turned over its diagonal where the gap is wider than
/// high, as systems over narrow rows are quicker to solve; nothing that is solved here depends on which axis is which.
class GapRegion
{
public:
  /// `gap` are the places of the gap in the index, in their order. The ring are the known columns that so many steps
  /// from the gap lead to, each to one of eight neighbours, over no faulted link and through no block with one.
  GapRegion(const ColumnIndex& index, const RasterFrame& frame, const LinkCuts* cuts,
    const std::vector<std::int64_t>& gap, int ringWidth);

  /// The gap, its ring, and the places beside these.
  std::shared_ptr<const BoxPlaces> Near;
  std::vector<PlaceKind> Kind; // of each place
  std::vector<PointId> Point; // at each place of the ring
  std::vector<std::int64_t> GapPlaces; // of the columns of the gap, in the order they were given

  /// Whether the link to the next place of the row, or to that above in the next row, is cut.
  bool IsCutEast(std::int64_t place) const { return (this->Cuts[place] & EastBit) != 0; }
  bool IsCutNorth(std::int64_t place) const { return (this->Cuts[place] & NorthBit) != 0; }
  bool HasCuts() const { return !this->Cuts.empty(); }

  /// Whether no side of the block of two by two places, the first of which is given, is cut.
  bool IsWholeBlock(std::int64_t place) const
  {
    return !this->HasCuts() ||
      !(this->IsCutEast(place) || this->IsCutNorth(place) || this->IsCutEast(this->Near->Above(place)) ||
        this->IsCutNorth(place + 1));
  }
  /// Whether a link is there to walk along: from a place to one of its four neighbours.
  bool IsLinked(std::int64_t place, std::int64_t neighbour) const
  {
    const std::int64_t first = place < neighbour ? place : neighbour;
    const bool isEast = place - neighbour == 1 || neighbour - place == 1;
    return !this->HasCuts() || !(isEast ? this->IsCutEast(first) : this->IsCutNorth(first));
  }

  /// The same for one of eight neighbours, or the place itself: diagonally through a block that is whole.
  bool CanStep(std::int64_t place, int dx, int dy) const;

  /// Calls visit(neighbour) for those of the four neighbours of a place to which the link is not cut.
  template <typename Visitor>
  void ForEachLinked(std::int64_t place, Visitor&& visit) const
  {
    for (const std::int64_t neighbour : { this->Near->Below(place), place - 1, place + 1, this->Near->Above(place) })
    {
      if (this->IsLinked(place, neighbour))
      {
        visit(neighbour);
      }
    }
  }

  /// Sites for the places of the gap, or for those of the ring as well.
  SiteBox MakeSites(bool withRing) const;

private:
  static constexpr unsigned char EastBit = 1;
  static constexpr unsigned char NorthBit = 2;

  void ReadCuts(const RasterFrame& frame, const LinkCuts& cuts, std::int64_t rasterWidth);
  void AddRing(const ColumnIndex& index, int ringWidth);

  std::int64_t InRaster(std::int64_t place, std::int64_t rasterWidth) const
  {
    const PlanePoint column = this->Near->Column(place);
    const std::int64_t x = this->Turned ? column.Y : column.X;
    const std::int64_t y = this->Turned ? column.X : column.Y;
    return this->First + y * rasterWidth + x;
  }

  bool Turned = false;
  std::int64_t First = 0; // the place in the index of the first place of the box
  std::vector<unsigned char> Cuts; // of each place, when there are any
};
}

#endif
