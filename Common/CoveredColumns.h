// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which columns a surface covers, and the ledger of its points (Ledger.h).

#ifndef SeismicHorizonsCoveredColumns_h
#define SeismicHorizonsCoveredColumns_h

#include "Ledger.h"
#include "Types.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace SeismicHorizons
{
/// Rows that parts of a surface share, which one of them counts (SurfaceJoin.h).
struct SharedRows
{
  std::optional<std::int32_t> Left; // counted by another part
  std::optional<std::int32_t> Kept; // counted here, also where edges along it have no area beside them
};

/// The columns inside closed outlines and on them. Edges in both directions, as around a single row of points, enclose
/// nothing. Memory and time follow from the rows that edges cross, and not from the area.
class CoveredColumns
{
public:
  /// What loops enclose, with the surface to their right. Vertices are in columns, or in sub-voxels.
  CoveredColumns(PlanePoints vertices, const Loops& boundary, std::int32_t subVoxelsPerColumn,
    const SharedRows& rows = SharedRows());

  std::int64_t Count() const;

  /// Whether these are the columns of a part.
  bool ArePart() const { return this->Rows.Left || this->Rows.Kept; }

  /// The ledger of points with a column each. `filled` has for each the value of the array Filled, or is empty.
  Ledger Account(PlanePoints columns, const std::vector<unsigned char>& filled) const;

private:
  /// Columns of a row, both included.
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
  /// How much more of the surface there is from a column of a row on.
  struct Change
  {
    std::int32_t Row;
    std::int32_t Column;
    std::int32_t Sheets;
  };

  void AddEdge(const PlanePoint& from, const PlanePoint& to, std::int32_t subVoxelsPerColumn);
  void MakeRuns();
  const Run* FindRun(const PlanePoint& column) const;

  SharedRows Rows;
  std::vector<Change> Changes; // until there are runs
  std::vector<Run> Runs; // by rows and columns
};
}

#endif
