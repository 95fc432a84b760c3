// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Some of the points of a horizon.

#ifndef SeismicHorizonsSelection_h
#define SeismicHorizonsSelection_h

#include "Common/Types.h"

#include <vector>

namespace SeismicHorizons
{
/// The points that are marked, in the order of their numbers, and the new number of each.
struct Selection
{
  explicit Selection(const std::vector<unsigned char>& marks)
    : Numbers(marks.size(), NoPoint)
  {
    for (std::size_t point = 0; point < marks.size(); ++point)
    {
      if (marks[point] != 0)
      {
        this->Numbers[point] = PointId(this->Points.size());
        this->Points.push_back(PointId(point));
      }
    }
  }

  std::vector<PointId> Points;
  std::vector<PointId> Numbers;
};
}

#endif
