// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What tests of the elaborate simplification share: squares of columns, and the levels of cells.

#ifndef SeismicHorizonsElaborateFixtures_h
#define SeismicHorizonsElaborateFixtures_h

#include "Filters/Algorithms/CellSimplification/CellSimplification.h"
#include "Tools/ReductionChecker.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <string>
#include <vector>

namespace ElaborateFixtures
{
using namespace ReductionChecker;

using Height = std::function<double(int, int)>;
using Levels = std::map<int, int>;

inline double Slope(int x, int y)
{
  return 0.125 * x + 0.0625 * y; // below 8 for all squares here: one layer
}

inline BoundedHorizon Square(int size, const Height& height = Slope)
{
  const Patches::Columns columns =
    Patches::FromPicture(std::vector<std::string>(std::size_t(size), std::string(std::size_t(size), '#')));
  std::vector<double> heights;
  for (const PlanePoint& column : columns)
  {
    heights.push_back(height(column.X, column.Y));
  }
  return MakeHorizon(columns, heights);
}

inline BoundedHorizon LevelSquare(int size)
{
  return Square(size, [](int, int) { return 0.0; });
}

inline PlanePoint Column(double x, double y)
{
  return { std::int32_t(x * SubVoxelsPerColumn), std::int32_t(y * SubVoxelsPerColumn) };
}

/// How many output points come from cells of each level: level -> number, of a ring and a kind.
inline std::map<int, int> CountLevels(const Reduction& result, int ring, PointKind kind)
{
  std::map<int, int> levels;
  for (const PointOrigin& origin : result.Origin)
  {
    levels[origin.Level] += origin.Ring == ring && origin.Kind == kind ? 1 : 0;
  }
  for (auto level = levels.begin(); level != levels.end();)
  {
    level = level->second == 0 ? levels.erase(level) : std::next(level);
  }
  return levels;
}

inline int DeepestLevel(const Reduction& result)
{
  int level = 0;
  for (const PointOrigin& origin : result.Origin)
  {
    level = std::max(level, int(origin.Level));
  }
  return level;
}
}

#endif
