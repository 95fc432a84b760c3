// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Rows of the lattice cut the outlines. A run of covered columns begins at an edge with the surface to its right, and
// ends at an edge with the surface to its left. Counting just above and just below each row makes edges along rows
// irrelevant.

#include "CoveredColumns.h"

#include "Common/Base/FixedChunks.h"
#include "Common/Base/Parallel.h"

#include <algorithm>
#include <tuple>

namespace SeismicHorizons
{
namespace
{
std::int64_t FloorQuotient(std::int64_t value, std::int64_t divisor)
{
  return value / divisor - (value % divisor < 0 ? 1 : 0);
}

std::int64_t CeilQuotient(std::int64_t value, std::int64_t divisor)
{
  return -FloorQuotient(-value, divisor);
}

/// Omits edges that loops follow in both directions.
std::vector<Edge> ListOneWayEdges(const Loops& boundary)
{
  std::vector<Edge> edges;
  edges.reserve(boundary.TotalLength());
  boundary.ForEachEdge([&edges](PointId from, PointId to) { edges.push_back({ from, to }); });
  const auto ends = [](const Edge& edge)
  { return std::make_tuple(std::min(edge.From, edge.To), std::max(edge.From, edge.To), edge.From < edge.To); };
  std::sort(edges.begin(), edges.end(), [&](const Edge& a, const Edge& b) { return ends(a) < ends(b); });
  std::vector<Edge> kept;
  for (const Edge& edge : edges)
  {
    if (!kept.empty() && kept.back().From == edge.To && kept.back().To == edge.From)
    {
      kept.pop_back();
    }
    else
    {
      kept.push_back(edge);
    }
  }
  return kept;
}
}

//----------------------------------------------------------------------------------------------------------------------
CoveredColumns::CoveredColumns(PlanePoints vertices, const Loops& boundary, std::int32_t subVoxelsPerColumn)
{
  for (const Edge& edge : ListOneWayEdges(boundary))
  {
    this->AddEdge(vertices[edge.From], vertices[edge.To], subVoxelsPerColumn);
  }
  this->MakeRuns();
}

//----------------------------------------------------------------------------------------------------------------------
void CoveredColumns::AddEdge(const PlanePoint& from, const PlanePoint& to, std::int32_t subVoxelsPerColumn)
{
  const bool isUp = from.Y < to.Y;
  const PlanePoint& low = isUp ? from : to;
  const PlanePoint& high = isUp ? to : from;
  const std::int64_t rise = std::int64_t(high.Y) - low.Y;
  const std::int64_t way = std::int64_t(high.X) - low.X;
  const std::int64_t last = FloorQuotient(high.Y, subVoxelsPerColumn);
  for (std::int64_t row = CeilQuotient(low.Y, subVoxelsPerColumn); rise > 0 && row <= last; ++row)
  {
    const std::int64_t y = row * subVoxelsPerColumn;
    const std::int64_t x = low.X * rise + (y - low.Y) * way; // Intersection, times the rise.
    const std::int32_t sides = (y > low.Y ? 1 : 0) + (y < high.Y ? 1 : 0);
    const std::int64_t column =
      isUp ? CeilQuotient(x, rise * subVoxelsPerColumn) : FloorQuotient(x, rise * subVoxelsPerColumn) + 1;
    this->Changes.push_back({ std::int32_t(row), std::int32_t(column), isUp ? sides : -sides });
  }
}

//----------------------------------------------------------------------------------------------------------------------
void CoveredColumns::MakeRuns()
{
  std::sort(this->Changes.begin(), this->Changes.end(),
    [](const Change& a, const Change& b) { return std::tie(a.Row, a.Column) < std::tie(b.Row, b.Column); });
  std::int64_t sheets = 0;
  for (auto change = this->Changes.begin(); change != this->Changes.end();)
  {
    const std::int32_t row = change->Row;
    const std::int32_t column = change->Column;
    const bool wasCovered = sheets > 0;
    for (; change != this->Changes.end() && change->Row == row && change->Column == column; ++change)
    {
      sheets += change->Sheets;
    }
    if (!wasCovered && sheets > 0)
    {
      this->Runs.push_back({ row, column, column });
    }
    else if (wasCovered && sheets == 0)
    {
      this->Runs.back().Last = column - 1;
    }
  }
  this->Changes = std::vector<Change>();
}

//----------------------------------------------------------------------------------------------------------------------
std::int64_t CoveredColumns::Count() const
{
  std::int64_t count = 0;
  for (const Run& run : this->Runs)
  {
    count += std::int64_t(run.Last) - run.First + 1;
  }
  return count;
}

//----------------------------------------------------------------------------------------------------------------------
// Calls visit(point, is covered). Points are mostly row-major, so the next ones are often in the same run.
template <typename Visitor>
void CoveredColumns::ForEachPoint(PlanePoints columns, std::int64_t first, std::int64_t last, Visitor&& visit) const
{
  for (auto point = std::size_t(first); point < std::size_t(last);)
  {
    const Run* const run = this->FindRun(columns[point]);
    do
    {
      visit(point++, run != nullptr);
    } while (run && point < std::size_t(last) && run->Contains(columns[point]));
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<unsigned char> CoveredColumns::Mark(PlanePoints columns) const
{
  std::vector<unsigned char> marks(columns.size(), 0);
  ParallelFor(std::int64_t(marks.size()), Grain,
    [&](std::int64_t first, std::int64_t last)
    {
      this->ForEachPoint(
        columns, first, last, [&](std::size_t point, bool isCovered) { marks[point] = isCovered ? 1 : 0; });
    });
  return marks;
}

//----------------------------------------------------------------------------------------------------------------------
const CoveredColumns::Run* CoveredColumns::FindRun(const PlanePoint& column) const
{
  const auto after = std::upper_bound(this->Runs.begin(), this->Runs.end(), column,
    [](const PlanePoint& place, const Run& run) { return std::tie(place.Y, place.X) < std::tie(run.Row, run.First); });
  return after != this->Runs.begin() && after[-1].Contains(column) ? &after[-1] : nullptr;
}

//----------------------------------------------------------------------------------------------------------------------
Ledger CoveredColumns::Account(
  PlanePoints columns, const std::vector<unsigned char>& filled, const KeptPoints& kept) const
{
  const auto entryOf = [&](std::size_t point) { return filled.empty() ? LedgerEntry::Known : EntryOf(filled[point]); };
  const auto count = [&](Ledger& ledger, std::int64_t first, std::int64_t last)
  {
    this->ForEachPoint(columns, first, last,
      [&](std::size_t point, bool isCovered)
      {
        const LedgerEntry entry = entryOf(point);
        if (isCovered)
        {
          ++ledger[entry];
        }
        else if (entry == LedgerEntry::Known)
        {
          ++ledger[LedgerEntry::LeftOut];
        }
      });
  };
  Ledger ledger = AddUpChunks<Ledger>(std::int64_t(columns.size()), ChunkSize, Monitor(), count);
  const auto correct = [&](PointId point) // A dropped point under the mesh was counted as Known.
  {
    const bool isMoved = entryOf(point) == LedgerEntry::Known && this->FindRun(columns[point]);
    ledger[LedgerEntry::Known] -= isMoved ? 1 : 0;
    ledger[LedgerEntry::LeftOut] += isMoved ? 1 : 0;
  };
  kept.ForEachDropped(correct);
  return ledger;
}
}
