// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "BandCuts.h"

#include "Common/Horizon/ColumnIndex.h"
#include "Common/Horizon/SpacePoints.h"
#include "Filters/Algorithms/BoundarySimplification/FewestPoints.h"

#include <numeric>
#include <unordered_set>
#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr double ReachOfNode = 0.9; // of the tolerance, from the node's own column

/// Heights of nodes on a line through all columns with the least sum of squares, where the first and the last node keep
/// their own. The equations have three diagonals (Thomas 1949).
std::vector<double> FitLine(const std::vector<PlanePoint>& columns, const std::vector<double>& heights,
  const std::vector<std::size_t>& nodes, double tolerance)
{
  const std::size_t size = nodes.size();
  std::vector<double> diagonal(size, 0.0);
  std::vector<double> beside(size, 0.0); // to the next node
  std::vector<double> right(size, 0.0);
  for (std::size_t n = 0; n + 1 < size; ++n)
  {
    const double start = columns[nodes[n]].X;
    const double length = columns[nodes[n + 1]].X - start;
    for (std::size_t column = nodes[n]; column < nodes[n + 1]; ++column)
    {
      const double part = (columns[column].X - start) / length;
      diagonal[n] += (1.0 - part) * (1.0 - part);
      diagonal[n + 1] += part * part;
      beside[n] += part * (1.0 - part);
      right[n] += (1.0 - part) * heights[column];
      right[n + 1] += part * heights[column];
    }
  }
  const auto fix = [&](std::size_t node)
  {
    diagonal[node] = 1.0;
    right[node] = heights[nodes[node]];
  };
  fix(0);
  fix(size - 1);
  std::vector<double> upper(size, 0.0);
  for (std::size_t n = 1; n < size; ++n)
  {
    const double before = n + 1 < size ? beside[n - 1] : 0.0;
    const double pivot = diagonal[n] - before * upper[n - 1];
    upper[n] = n + 1 < size ? beside[n] / pivot : 0.0;
    right[n] = (right[n] - before * right[n - 1]) / pivot;
  }
  for (std::size_t n = size - 1; n-- > 1;)
  {
    right[n] -= upper[n] * right[n + 1];
    const double own = heights[nodes[n]];
    right[n] = std::clamp(right[n], own - ReachOfNode * tolerance, own + ReachOfNode * tolerance);
  }
  return right;
}
}

//----------------------------------------------------------------------------------------------------------------------
void BandCut::Open(const PointWindow& row, double heightTolerance)
{
  this->Ranges = Intersect(RangesBetween(std::move(this->Above)), RangesBetween(std::move(this->Below)));
  std::size_t first = 0;
  for (const Range& range : this->Ranges)
  {
    while (row.Columns[first].X < range.First) // Both ends are points.
    {
      ++first;
    }
    std::size_t last = first;
    while (row.Columns[last].X < range.Last)
    {
      ++last;
    }
    this->AddNodes(row, first, last, heightTolerance);
    first = last;
  }
}

//----------------------------------------------------------------------------------------------------------------------
void BandCut::AddNodes(const PointWindow& row, std::size_t first, std::size_t last, double heightTolerance)
{
  const auto begin = row.Columns.begin();
  const std::vector<PlanePoint> columns(begin + std::ptrdiff_t(first), begin + std::ptrdiff_t(last) + 1);
  const std::vector<double> heights(row.Height + first, row.Height + last + 1);
  const SpacePoints points(columns, heights, 1);
  const ColumnIndex index(columns);
  const std::vector<unsigned char> visits(columns.size(), 2); // of points that stay
  KeptOfChains known;
  FewestPoints fewest(points, index, visits, 0.0, heightTolerance, known, []() {});
  std::vector<PointId> chain(columns.size());
  std::iota(chain.begin(), chain.end(), PointId(0));
  std::vector<std::size_t> nodes = fewest.SimplifyChain(chain);
  if (nodes.empty() || nodes.back() + 1 != columns.size())
  {
    nodes.push_back(columns.size() - 1);
  }
  const std::vector<double> fitted = FitLine(columns, heights, nodes, heightTolerance);
  for (std::size_t n = 0; n + 1 < nodes.size(); ++n)
  {
    const auto idOf = [&](std::size_t node) { return row.First + PointId(first + nodes[node]); };
    this->OpenEdges.push_back({ idOf(n), idOf(n + 1) });
    if (n > 0)
    {
      this->InnerNodes.push_back({ idOf(n), fitted[n] });
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
// Beside the row, the surface is between each odd crossing and the next one.
std::vector<BandCut::Range> BandCut::RangesBetween(Crossings crossings)
{
  std::sort(crossings.begin(), crossings.end());
  std::vector<Range> ranges;
  for (std::size_t n = 0; n + 1 < crossings.size(); n += 2)
  {
    if (crossings[n][0] < crossings[n + 1][0])
    {
      ranges.push_back({ crossings[n][0], crossings[n + 1][0] });
    }
  }
  return ranges;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<BandCut::Range> BandCut::Intersect(const std::vector<Range>& some, const std::vector<Range>& others)
{
  std::vector<Range> both;
  for (std::size_t a = 0, b = 0; a < some.size() && b < others.size();)
  {
    const Range range{ std::max(some[a].First, others[b].First), std::min(some[a].Last, others[b].Last) };
    if (range.First < range.Last)
    {
      both.push_back(range);
    }
    some[a].Last < others[b].Last ? ++a : ++b;
  }
  return both;
}

//----------------------------------------------------------------------------------------------------------------------
BandCuts::BandCuts(const PointRows& rows, std::int32_t rowsOfBand, const Loops& boundary)
  : Rows(rows)
  , Box(rows.Box())
{
  const std::int64_t height = std::int64_t(this->Box.Greatest.Y) - this->Box.Least.Y + 1;
  const std::int64_t bands = std::max<std::int64_t>(1, (height + rowsOfBand / 2) / rowsOfBand);
  for (std::int64_t band = 1; band < bands; ++band)
  {
    this->Cuts.emplace_back(std::int32_t(this->Box.Least.Y + band * height / bands));
  }
  this->Edges.resize(std::size_t(bands));
  this->Alone.resize(std::size_t(bands));
  std::unordered_set<std::uint64_t> alongCuts;
  boundary.ForEachEdge(
    [&](PointId from, PointId to)
    {
      const std::int32_t row = rows.ColumnOf(from).Y;
      if (this->FindCut(row) && row == rows.ColumnOf(to).Y)
      {
        alongCuts.insert(EdgeKeyOf(from, to));
      }
    });
  boundary.ForEachEdge([&](PointId from, PointId to)
    { this->AddEdge(from, to, !alongCuts.empty() && alongCuts.count(EdgeKeyOf(to, from)) > 0); });
  for (std::size_t loop = 0; loop < boundary.Size(); ++loop)
  {
    if (boundary.Length(loop) == 1)
    {
      const PointId point = *boundary.begin(loop);
      this->Alone[this->BandOf(rows.ColumnOf(point).Y)].push_back(point);
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::size_t BandCuts::BandOf(std::int32_t row) const
{
  const auto after = std::upper_bound(
    this->Cuts.begin(), this->Cuts.end(), row, [](std::int32_t own, const BandCut& cut) { return own < cut.Row(); });
  return std::size_t(after - this->Cuts.begin());
}

//----------------------------------------------------------------------------------------------------------------------
BandCut* BandCuts::FindCut(std::int32_t row)
{
  const std::size_t band = this->BandOf(row);
  return band > 0 && this->Cuts[band - 1].Row() == row ? &this->Cuts[band - 1] : nullptr;
}

//----------------------------------------------------------------------------------------------------------------------
// An edge along a cut belongs to the band on the side of its surface; one in both directions, without surface, to the
// band above.
void BandCuts::AddEdge(PointId from, PointId to, bool isBoth)
{
  const PlanePoint a = this->Rows.ColumnOf(from);
  const PlanePoint b = this->Rows.ColumnOf(to);
  const PlanePoint& low = a.Y <= b.Y ? a : b;
  const PlanePoint& high = a.Y <= b.Y ? b : a;
  std::size_t band = this->BandOf(low.Y);
  BandCut* const cutBelow = this->FindCut(low.Y);
  BandCut* const cutAbove = this->FindCut(high.Y);
  if (low.Y == high.Y)
  {
    band -= cutBelow && b.X > a.X && !isBoth ? 1 : 0;
  }
  else if (cutBelow)
  {
    cutBelow->AddAbove(low.X, high.X);
  }
  if (low.Y != high.Y && cutAbove)
  {
    cutAbove->AddBelow(high.X, low.X);
  }
  this->Edges[band].push_back({ from, to });
}

//----------------------------------------------------------------------------------------------------------------------
void BandCuts::Open(std::size_t n, double heightTolerance)
{
  this->Cuts[n].Open(this->Rows.Read(this->Cuts[n].Row(), this->Cuts[n].Row()), heightTolerance);
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<Edge> BandCuts::TakeEdges(std::size_t band)
{
  std::vector<Edge> edges = std::move(this->Edges[band]);
  if (band > 0)
  {
    for (const Edge& edge : this->Cuts[band - 1].Edges())
    {
      edges.push_back({ edge.To, edge.From });
    }
  }
  if (band < this->Cuts.size())
  {
    const std::vector<Edge>& open = this->Cuts[band].Edges();
    edges.insert(edges.end(), open.begin(), open.end());
  }
  return edges;
}
}
