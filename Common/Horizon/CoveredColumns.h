// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Finds the columns that a surface covers, and the ledger of its points (Ledger.h).

#ifndef SeismicHorizonsCoveredColumns_h
#define SeismicHorizonsCoveredColumns_h

#include "KeptPoints.h"
#include "Ledger.h"
#include "Types.h"

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// Columns inside closed outlines and on them. Edges in both directions enclose nothing. Memory and time depend on the
/// rows that edges cross, not on the area.
class CoveredColumns
{
public:
  /// The surface is to the right of loops. Vertices are columns or sub-voxels.
  CoveredColumns(PlanePoints vertices, const Loops& boundary, std::int32_t subVoxelsPerColumn);

  std::int64_t Count() const;

  /// Marks columns that are covered with 1.
  std::vector<unsigned char> Mark(PlanePoints columns) const;
  /// `filled` has the array Filled, or is empty. Points that are not kept are left out even in covered columns. Ledgers of
  /// some of the points each add up; Bridge() then counts the covered columns without points.
  Ledger Account(PlanePoints columns, const std::vector<unsigned char>& filled, const KeptPoints& kept) const;
  void Bridge(Ledger& ledger) const { ledger[LedgerEntry::Bridged] = this->Count() - ledger.Covered(); }

private:
  struct Run
  {
    std::int32_t Row;
    std::int32_t First;
    std::int32_t Last;

    bool Contains(const PlanePoint& column) const
    {
      return column.Y == this->Row && this->First <= column.X && column.X <= this->Last;
    }
  };
  /// Layers of the surface that begin or end at a column.
  struct Change
  {
    std::int32_t Row;
    std::int32_t Column;
    std::int32_t Sheets;
  };

  void AddEdge(const PlanePoint& from, const PlanePoint& to, std::int32_t subVoxelsPerColumn);
  void MakeRuns();
  const Run* FindRun(const PlanePoint& column) const;
  template <typename Visitor>
  void ForEachPoint(PlanePoints columns, std::int64_t first, std::int64_t last, Visitor&& visit) const;

  std::vector<Change> Changes; // empty once there are runs
  std::vector<Run> Runs; // sorted by rows and columns
};
}

#endif
