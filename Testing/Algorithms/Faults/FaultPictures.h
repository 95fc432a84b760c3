// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Horizons for tests, given by a function, and cuts as text.

#ifndef SeismicHorizonsFaultPictures_h
#define SeismicHorizonsFaultPictures_h

#include "Filters/Algorithms/Faults/ColumnHeights.h"
#include "Filters/Algorithms/Faults/FaultLines.h"

#include <cmath>
#include <set>
#include <string>
#include <vector>

namespace SeismicHorizons
{
/// A horizon of width times length columns from (0, 0); where height(i, j) is nan there is no point.
template <typename Height>
ColumnHeights MakeHeights(int width, int length, Height&& height)
{
  std::vector<PlanePoint> columns;
  std::vector<double> values;
  for (int j = 0; j < length; ++j)
  {
    for (int i = 0; i < width; ++i)
    {
      const double value = height(i, j);
      if (!std::isnan(value))
      {
        columns.push_back({ i, j });
        values.push_back(value);
      }
    }
  }
  return ColumnHeights(columns, values);
}

/// Such as "E(4,0)", for the link from (4, 0) to (5, 0).
inline std::string ToText(const LatticeLink& link)
{
  return std::string(link.Side == LinkSide::East ? "E" : "N") + "(" + std::to_string(link.Column.X) + "," +
    std::to_string(link.Column.Y) + ")";
}

/// The links of all lines, each once, by j, i and side.
inline std::string ToText(const FaultLines& lines)
{
  std::string text;
  for (const LinkOfLine& item : SortLinks(lines))
  {
    text += (text.empty() ? "" : " ") + ToText(lines[item.Link].Place);
  }
  return text;
}

/// Whether the cuts of each line lead from corner to corner.
inline bool AreChains(const FaultLines& lines)
{
  const LinkGrid grid(PlaneBox({ { -10, -10 }, { 1 << 29, 1 << 29 } }));
  for (std::size_t line = 0; line < lines.Size(); ++line)
  {
    std::int64_t end = -1;
    for (std::size_t n = lines.Start(line); n < lines.End(line); ++n)
    {
      const std::int64_t link = grid.LinkOf(grid.ColumnOf(lines[n].Place.Column), lines[n].Place.Side);
      const auto corners = grid.CornersOf(link);
      if (end >= 0 && corners[lines[n].IsForward ? 0 : 1] != end)
      {
        return false;
      }
      end = corners[lines[n].IsForward ? 1 : 0];
    }
  }
  return true;
}
}

#endif
