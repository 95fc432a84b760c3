// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The seams of a part of a horizon: its lowest or highest row of columns, where another part goes on that has the same
// row. What connects the points along a seam must follow from this row alone, so that both parts find the same.
//
//        # # # . # # # .      Hops of at most k columns along a row at the edge of all points cross no others, and so
//        # # . . # # # #      are in the graph of any horizon. A gap that is wider, but no wider than the longest edge
//     ---# # g g # # . #---   of a seam, is closed by gap columns (g): the walk goes straight on through these, and
//                             they have no other hops. Above them a hole is left, or what is too small for one.

#ifndef SeismicHorizonsSeamGaps_h
#define SeismicHorizonsSeamGaps_h

#include "Common/ColumnIndex.h"
#include "ExteriorBoundary.h"
#include "PatchComponents.h"

#include <array>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// Throws InputError when a point is beyond a seam, or when the options do not suit one: loops of holes are needed,
/// patches must not be dropped that continue beyond a seam, and growth by distance does not take all hops along a seam.
void CheckSeams(PlanePoints columns, const BoundaryOptions& options);

/// Whether there are points on the seams of some options, which are the least and the greatest row then.
struct SeamPresence
{
  SeamPresence(PlanePoints columns, const SeamRows& seams);

  bool AtLeastRow = false;
  bool AtGreatestRow = false;
};

/// The columns of gaps in seams that are closed.
class SeamGaps
{
public:
  /// There are points.
  SeamGaps(PlanePoints columns, const ColumnIndex& index, const BoundaryOptions& options, const SeamPresence& seams);

  bool Has(std::int64_t place) const { return this->Rows[0].Has(place) || this->Rows[1].Has(place); }

  /// Makes components of points one that are on both sides of a gap.
  void Join(const ColumnIndex& index, PatchComponents& parts) const;

private:
  /// The columns of a row that are in gaps.
  struct Row
  {
    std::int64_t First = 0; // place of the first column
    std::vector<bool> IsInGap;

    bool Has(std::int64_t place) const
    {
      const std::int64_t column = place - this->First;
      return column >= 0 && column < std::int64_t(this->IsInGap.size()) && this->IsInGap[column];
    }
  };

  void Fill(Row& row, const ColumnIndex& index, const BoundaryOptions& options);

  std::array<Row, 2> Rows;
  std::vector<std::array<std::int64_t, 2>> Sides; // of each gap, the places of the points beside it
};
}

#endif
