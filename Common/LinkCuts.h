// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where a surface is torn: a bit for the link from each column to that east of it (i + 1), and one for that to the
// north (j + 1), whether there are points in the columns or not. A fault is a chain of cut links.

#ifndef SeismicHorizonsLinkCuts_h
#define SeismicHorizonsLinkCuts_h

#include "PlaneGeometry.h"
#include "Types.h"

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
class LinkCuts
{
public:
  /// No link is cut. The links of columns outside the box never are.
  explicit LinkCuts(const PlaneBox& box)
    : Box(box)
    , Width(std::int64_t(box.Greatest.X) - box.Least.X + 1)
    , East(std::size_t(Width * (std::int64_t(box.Greatest.Y) - box.Least.Y + 1)), false)
    , North(East)
  {
  }

  void CutEast(const PlanePoint& column) { this->East[this->Place(column)] = true; }
  void CutNorth(const PlanePoint& column) { this->North[this->Place(column)] = true; }

  bool IsCutEast(const PlanePoint& column) const
  {
    return this->Box.Contains(column) && this->East[this->Place(column)];
  }
  bool IsCutNorth(const PlanePoint& column) const
  {
    return this->Box.Contains(column) && this->North[this->Place(column)];
  }

private:
  std::size_t Place(const PlanePoint& column) const
  {
    return std::size_t(
      (std::int64_t(column.Y) - this->Box.Least.Y) * this->Width + (std::int64_t(column.X) - this->Box.Least.X));
  }

  PlaneBox Box;
  std::int64_t Width;
  std::vector<bool> East;
  std::vector<bool> North;
};
}

#endif
