// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Divides a horizon into bands of rows. A band has the boundary of the horizon between its rows, and open edges along cuts.
//
//     o   o---o---o   o       The surface is on both sides of the row between the columns marked +, so that edges there
//      \\  |       |  /        are open. Elsewhere the boundary itself runs along the row, or crosses it.
//    ---o-+++++++++-o---
//        \\         /
//         o---o---o

#ifndef SeismicHorizonsBandCuts_h
#define SeismicHorizonsBandCuts_h

#include "Common/Horizon/BoundedHorizon.h"
#include "Common/Horizon/PlaneGeometry.h"
#include "Common/Horizon/Types.h"
#include "PointRows.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_set>
#include <vector>

namespace SeismicHorizons
{
/// A row between two bands.
class BandCut
{
public:
  explicit BandCut(std::int32_t row)
    : At(row)
  {
  }

  std::int32_t Row() const { return this->At; }

  /// Of edges of loops that start in the row and go up, or end in it from below: columns in the row and in the other one.
  void AddAbove(std::int32_t here, std::int32_t other) { this->Above.push_back({ here, other }); }
  void AddBelow(std::int32_t here, std::int32_t other) { this->Below.push_back({ here, other }); }

  /// All edges must have been added. `row` has the points of the row. Nodes are the fewest within a height tolerance.
  void Open(const PointWindow& row, double heightTolerance);

  bool IsOpen(const PlanePoint& a, const PlanePoint& b) const
  {
    const auto [least, greatest] = std::minmax(a.X, b.X);
    const auto after = std::upper_bound(this->Ranges.begin(), this->Ranges.end(), least,
      [](std::int32_t x, const Range& range) { return x < range.First; });
    return a.Y == this->At && b.Y == this->At && after != this->Ranges.begin() && greatest <= after[-1].Last;
  }

  /// Open edges between nodes of the row, to the right.
  const std::vector<Edge>& Edges() const { return this->OpenEdges; }
  /// Nodes that are not on the boundary. Their heights fit the row: beside nodes that are off by a part of the error, as
  /// heights of whole voxels are, bands would need many times more vertices.
  const std::vector<LockedHeight>& Nodes() const { return this->InnerNodes; }

private:
  using Crossings = std::vector<std::array<std::int32_t, 2>>;

  struct Range
  {
    std::int32_t First;
    std::int32_t Last;
  };

  void AddNodes(const PointWindow& row, std::size_t first, std::size_t last, double heightTolerance);
  static std::vector<Range> RangesBetween(Crossings crossings);
  static std::vector<Range> Intersect(const std::vector<Range>& some, const std::vector<Range>& others);

  std::int32_t At;
  Crossings Above;
  Crossings Below;
  std::vector<Range> Ranges; // ascending
  std::vector<Edge> OpenEdges;
  std::vector<LockedHeight> InnerNodes;
};

/// Loops of a boundary with a radius of 1, by bands.
class BandCuts
{
public:
  BandCuts(const PointRows& rows, std::int32_t rowsOfBand, const Loops& boundary);

  std::size_t NumberOfBands() const { return this->Edges.size(); }
  std::int32_t FirstRow(std::size_t band) const { return band == 0 ? this->Box.Least.Y : this->Cuts[band - 1].Row(); }
  std::int32_t LastRow(std::size_t band) const
  {
    return band == this->Cuts.size() ? this->Box.Greatest.Y : this->Cuts[band].Row();
  }

  /// Cut n lies between band n and the next one.
  const BandCut& Cut(std::size_t n) const { return this->Cuts[n]; }
  std::size_t NumberOfCuts() const { return this->Cuts.size(); }
  void Open(std::size_t n, double heightTolerance);

  /// The edges around a band, with open ones along its cuts, and loops of one point. They can be taken once.
  std::vector<Edge> TakeEdges(std::size_t band);
  const std::vector<PointId>& LoopsOfOne(std::size_t band) const { return this->Alone[band]; }

private:
  std::size_t BandOf(std::int32_t row) const;
  BandCut* FindCut(std::int32_t row);
  void AddEdge(PointId from, PointId to, bool isBoth);

  const PointRows& Rows;
  const PlaneBox Box;
  std::vector<BandCut> Cuts;
  std::vector<std::vector<Edge>> Edges;
  std::vector<std::vector<PointId>> Alone;
};

/// Keys of directed edges.
inline std::uint64_t EdgeKeyOf(PointId from, PointId to)
{
  return std::uint64_t(std::uint32_t(from)) << 32U | std::uint32_t(to);
}
inline PointId FromOf(std::uint64_t key)
{
  return PointId(std::uint32_t(key >> 32U));
}
inline PointId ToOf(std::uint64_t key)
{
  return PointId(std::uint32_t(key));
}
}

#endif
