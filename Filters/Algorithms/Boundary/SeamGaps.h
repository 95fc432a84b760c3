// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Seams of a window of a horizon: its lowest or highest row of columns, which the next window repeats. The connections
// along a seam must follow from this row alone, so that both windows find the same.
//
//       # # # . # # # .      Hops along a row at the edge of all points cross no other hop, and so are in the graph of
//       # # . . # # # #      any horizon. A break that is wider than the radius, up to the longest edge of a seam, is
//    ---# # g g # # . #---   closed by gap columns (g): the walk passes straight through them, and they have no other
//                            hops. A hole, if large enough, remains above them.

#ifndef SeismicHorizonsSeamGaps_h
#define SeismicHorizonsSeamGaps_h

#include "Common/Horizon/ColumnIndex.h"
#include "ExteriorBoundary.h"
#include "PatchComponents.h"

#include <array>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// Growth by distance with long hops is refused, as it omits some hops along a seam.
void CheckSeams(PlanePoints columns, const BoundaryOptions& options);

struct SeamPresence
{
  SeamPresence(PlanePoints columns, const SeamRows& seams);

  bool AtLeastRow = false;
  bool AtGreatestRow = false;
};

class SeamGaps
{
public:
  /// `columns` must not be empty.
  SeamGaps(PlanePoints columns, const ColumnIndex& index, const BoundaryOptions& options, const SeamPresence& seams);

  bool Has(std::int64_t place) const { return this->Rows[0].Has(place) || this->Rows[1].Has(place); }

  void Join(const ColumnIndex& index, PatchComponents& parts) const;

private:
  struct Row
  {
    std::int64_t First = 0;
    std::vector<bool> IsInGap;

    bool Has(std::int64_t place) const
    {
      const std::int64_t column = place - this->First;
      return column >= 0 && column < std::int64_t(this->IsInGap.size()) && this->IsInGap[column];
    }
  };

  void Fill(Row& row, const ColumnIndex& index, const BoundaryOptions& options);

  std::array<Row, 2> Rows;
  std::vector<std::array<std::int64_t, 2>> Sides; // places of the points beside each break
};
}

#endif
