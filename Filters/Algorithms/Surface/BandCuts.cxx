// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "BandCuts.h"

#include <utility>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
void BandCut::Open(const PointWindow& row)
{
  this->Ranges = Intersect(RangesBetween(std::move(this->Above)), RangesBetween(std::move(this->Below)));
  std::unordered_set<std::int32_t> ends;
  for (const Range& range : this->Ranges)
  {
    ends.insert({ range.First, range.Last });
  }
  for (std::size_t n = 0; n < row.Columns.size(); ++n)
  {
    if (ends.count(row.Columns[n].X) > 0)
    {
      this->OpenEnds.push_back(row.First + PointId(n));
    }
    if (n > 0 && this->IsOpen(row.Columns[n - 1], row.Columns[n]))
    {
      this->OpenEdges.push_back({ row.First + PointId(n - 1), row.First + PointId(n) });
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
  const auto after = std::upper_bound(this->Cuts.begin(), this->Cuts.end(), row,
    [](std::int32_t own, const BandCut& cut) { return own < cut.Row(); });
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
void BandCuts::Open(std::size_t n)
{
  this->Cuts[n].Open(this->Rows.Read(this->Cuts[n].Row(), this->Cuts[n].Row()));
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
