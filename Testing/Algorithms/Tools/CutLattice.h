// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A cracked lattice, block by block, as the definition of cuts has it: for checkers, with none of the code they check.

#ifndef SeismicHorizonsCutLattice_h
#define SeismicHorizonsCutLattice_h

#include "Common/Horizon/PlaneGeometry.h"
#include "CrackedPatches.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>

namespace CutChecker
{
using CrackedPatches::CrackedPatch;
using SeismicHorizons::LinkCuts;
using SeismicHorizons::PlaneBox;
using SeismicHorizons::PlanePoint;
using SeismicHorizons::PointId;

/// The lattice as the definition of cuts has it: links, and what is left of blocks.
class CutLattice
{
public:
  explicit CutLattice(const CrackedPatch& patch)
    : Cuts(patch.Cuts)
    , Box(patch.Columns)
  {
    for (std::size_t point = 0; point < patch.Columns.size(); ++point)
    {
      this->PointAt[patch.Columns[point]] = PointId(point);
    }
  }

  const PlaneBox& Extent() const { return this->Box; }
  bool Has(const PlanePoint& column) const { return this->PointAt.count(column) != 0; }
  PointId At(const PlanePoint& column) const { return this->PointAt.at(column); }

  bool IsCut(const PlanePoint& a, const PlanePoint& b) const
  {
    return a.Y == b.Y ? this->Cuts.IsCutEast({ std::min(a.X, b.X), a.Y })
                      : this->Cuts.IsCutNorth({ a.X, std::min(a.Y, b.Y) });
  }

  /// The corners of a block, counter-clockwise, and which of its sides, each after a corner, are cut.
  static std::array<PlanePoint, 4> Corners(const PlanePoint& block)
  {
    return { PlanePoint{ block.X, block.Y }, PlanePoint{ block.X + 1, block.Y }, PlanePoint{ block.X + 1, block.Y + 1 },
      PlanePoint{ block.X, block.Y + 1 } };
  }

  std::array<bool, 4> CutSides(const PlanePoint& block) const
  {
    const std::array<PlanePoint, 4> corners = Corners(block);
    std::array<bool, 4> cut{};
    for (std::size_t n = 0; n < 4; ++n)
    {
      cut[n] = this->IsCut(corners[n], corners[(n + 1) % 4]);
    }
    return cut;
  }

  int NumberOfCuts(const PlanePoint& block) const
  {
    const std::array<bool, 4> cut = this->CutSides(block);
    return int(std::count(cut.begin(), cut.end(), true));
  }

  /// The corner that two cut sides leave alone, or -1.
  int LoneCorner(const PlanePoint& block) const
  {
    const std::array<bool, 4> cut = this->CutSides(block);
    int lone = -1;
    for (int n = 0; n < 4; ++n)
    {
      lone = cut[std::size_t(n)] && cut[std::size_t((n + 3) % 4)] ? n : lone;
    }
    return this->NumberOfCuts(block) == 2 ? lone : -1;
  }

  /// How many corners of a block have points.
  int NumberOfPoints(const PlanePoint& block) const
  {
    const std::array<PlanePoint, 4> corners = Corners(block);
    return int(
      std::count_if(corners.begin(), corners.end(), [this](const PlanePoint& corner) { return this->Has(corner); }));
  }

  /// Twice the area of the surface in a block.
  int TwiceArea(const PlanePoint& block) const
  {
    const std::array<PlanePoint, 4> corners = Corners(block);
    int occupied = 0;
    for (int n = 0; n < 4; ++n)
    {
      occupied += this->Has(corners[std::size_t(n)]) && n != this->LoneCorner(block) ? 1 : 0;
    }
    const bool hasSurface = this->NumberOfCuts(block) == 0 || this->LoneCorner(block) >= 0;
    return hasSurface && occupied > 2 ? occupied - 2 : 0;
  }

  /// Whether a diagonal of a block joins its corners n and n + 2.
  bool HasDiagonal(const PlanePoint& block, int n) const
  {
    const int lone = this->LoneCorner(block);
    return this->NumberOfCuts(block) == 0 || (lone >= 0 && lone != n && lone != n + 2);
  }

private:
  const LinkCuts& Cuts;
  PlaneBox Box;
  std::map<PlanePoint, PointId> PointAt;
};

template <typename Visitor>
void ForEachBlock(const PlaneBox& box, Visitor&& visit)
{
  for (std::int32_t y = box.Least.Y - 1; y <= box.Greatest.Y; ++y)
  {
    for (std::int32_t x = box.Least.X - 1; x <= box.Greatest.X; ++x)
    {
      visit(PlanePoint{ x, y });
    }
  }
}
}

#endif
