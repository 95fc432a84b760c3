// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsInnerHeights_h
#define SeismicHorizonsInnerHeights_h

#include "Common/Types.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace SeismicHorizons
{
/// The heights of the vertices of a mesh that are on no loop: those that can move.
struct InnerHeights
{
  static constexpr std::size_t None = static_cast<std::size_t>(-1);

  /// The position of a vertex among them, or None.
  std::size_t Find(PointId point) const
  {
    const auto found = std::lower_bound(this->Points.begin(), this->Points.end(), point);
    return found != this->Points.end() && *found == point ? std::size_t(found - this->Points.begin()) : None;
  }

  std::vector<PointId> Points; // ascending
  std::vector<double> Heights;
};
}

#endif
