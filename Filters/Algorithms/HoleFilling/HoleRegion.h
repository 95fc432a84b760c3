// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A hole, or one of the sections into which cuts divide it, with the known columns around it, cut out of the lattice;
// and the surface over it.

#ifndef SeismicHorizonsHoleRegion_h
#define SeismicHorizonsHoleRegion_h

#include "BoxPlaces.h"
#include "Common/Base/Monitor.h"
#include "Common/Horizon/ColumnIndex.h"
#include "Common/Horizon/LinkCuts.h"
#include "HoleFilling.h"
#include "SiteSolver.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>
#include <vector>

namespace SeismicHorizons
{
enum class PlaceKind : unsigned char
{
  Other = 0,
  Hole = 1,
  Ring = 2
};

/// The box is transposed if the hole is wider than high, since systems with short rows are faster to solve.
class HoleRegion
{
public:
  /// `hole` is ascending. The ring consists of known columns within `ringWidth` steps to eight neighbours, over no
  /// faulted link and through no block with one.
  HoleRegion(const ColumnIndex& index, const LinkCuts* cuts, const std::vector<std::int64_t>& hole, int ringWidth);

  std::shared_ptr<const BoxPlaces> Near;
  std::vector<PlaceKind> Kind; // by place
  std::vector<PointId> Point; // by place, for the ring
  std::vector<std::int64_t> HolePlaces; // in the order given

  bool IsCutEast(std::int64_t place) const { return (this->Cuts[place] & EastBit) != 0; }
  bool IsCutNorth(std::int64_t place) const { return (this->Cuts[place] & NorthBit) != 0; }
  bool HasCuts() const { return !this->Cuts.empty(); }

  /// No side of the block of two by two places is cut.
  bool IsWholeBlock(std::int64_t place) const
  {
    return !this->HasCuts() ||
      !(this->IsCutEast(place) || this->IsCutNorth(place) || this->IsCutEast(this->Near->Above(place)) ||
        this->IsCutNorth(place + 1));
  }
  bool IsLinked(std::int64_t place, std::int64_t neighbour) const
  {
    const std::int64_t first = place < neighbour ? place : neighbour;
    const bool isEast = place - neighbour == 1 || neighbour - place == 1;
    return !this->HasCuts() || !(isEast ? this->IsCutEast(first) : this->IsCutNorth(first));
  }

  /// A diagonal step needs a whole block.
  bool CanStep(std::int64_t place, int dx, int dy) const;

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

  SiteBox MakeSites(bool withRing) const;

private:
  static constexpr unsigned char EastBit = 1;
  static constexpr unsigned char NorthBit = 2;

  void ReadCuts(const ColumnIndex& index, const LinkCuts& cuts);
  void AddRing(const ColumnIndex& index, int ringWidth);

  std::int64_t InIndex(std::int64_t place, const ColumnIndex& index) const
  {
    const PlanePoint column = this->Near->Column(place);
    const std::int64_t x = this->Turned ? column.Y : column.X;
    const std::int64_t y = this->Turned ? column.X : column.Y;
    return this->First + y * index.Width() + x;
  }

  bool Turned = false;
  std::int64_t First = 0; // place of the box in the index
  std::vector<unsigned char> Cuts;
};

struct HolePlate
{
  HolePlate(const HoleRegion& region, double ringWeight);

  const SiteSystem<2> System;
  const std::unique_ptr<const SiteSolver> Solver;
};

/// Plates of small holes are cached, since many have the same shape, mostly a single column. Threads share the cache
/// and must use one ring weight.
class HolePlates
{
public:
  std::shared_ptr<const HolePlate> Get(const HoleRegion& region, double ringWeight);

private:
  static constexpr std::int64_t LargestKept = 256; // places of a plate
  static constexpr std::size_t MostKept = 256; // plates, about 20 MB in all

  std::mutex Mutex;
  std::unordered_map<std::string, std::shared_ptr<const HolePlate>> Kept;
};

/// Writes values from an entry of the result on, in the order of HoleRegion::HolePlaces. Writes nothing if no known
/// column is linked to them.
void FillHole(const HoleRegion& region, const std::vector<double>& heights, const std::vector<PointValue>& attributes,
  const HoleFillingOptions& options, HolePlates& plates, std::size_t entry, FilledColumns& result,
  const Monitor& monitor);
}

#endif
