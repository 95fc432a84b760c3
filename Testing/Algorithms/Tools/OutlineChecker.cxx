// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "OutlineChecker.h"

#include "ExactPlane.h"

#include <algorithm>
#include <queue>
#include <set>
#include <utility>

namespace OutlineChecker
{
using namespace ExactPlane;
using SeismicHorizons::ExteriorBoundary;
using SeismicHorizons::PointId;

namespace
{
/// The columns with a rim, for finding connected ones by flooding.
class Map
{
public:
  enum : int
  {
    Empty = -1,
    Outside = -2
  };

  explicit Map(const std::vector<PlanePoint>& columns)
  {
    for (const PlanePoint& column : columns)
    {
      this->Width = std::max(this->Width, column.X + 3);
      this->Height = std::max(this->Height, column.Y + 3);
    }
    this->Cells.assign(std::size_t(this->Width * this->Height), Empty);
    for (std::size_t point = 0; point < columns.size(); ++point)
    {
      this->At(columns[point].X, columns[point].Y) = int(point);
    }
    this->Flood(
      -1, -1, 4, [](int cell) { return cell == Empty; }, [](int& cell) { cell = Outside; });
  }

  int& At(int x, int y) { return this->Cells[std::size_t((y + 1) * this->Width + x + 1)]; }
  bool Has(int x, int y) const { return x >= -1 && y >= -1 && x < this->Width - 1 && y < this->Height - 1; }

  template <typename Condition, typename Action>
  void Flood(int x, int y, int connectivity, Condition&& condition, Action&& action)
  {
    static const int steps[8][2] = { { 1, 0 }, { -1, 0 }, { 0, 1 }, { 0, -1 }, { 1, 1 }, { -1, 1 }, { 1, -1 },
      { -1, -1 } };
    std::queue<std::pair<int, int>> queue;
    std::set<std::pair<int, int>> seen;
    queue.push({ x, y });
    seen.insert({ x, y });
    while (!queue.empty())
    {
      const auto [i, j] = queue.front();
      queue.pop();
      if (!condition(this->At(i, j)))
      {
        continue;
      }
      action(this->At(i, j));
      for (int n = 0; n < connectivity; ++n)
      {
        const std::pair<int, int> next(i + steps[n][0], j + steps[n][1]);
        if (this->Has(next.first, next.second) && seen.insert(next).second)
        {
          queue.push(next);
        }
      }
    }
  }

private:
  int Width = 3;
  int Height = 3;
  std::vector<int> Cells;
};

std::string CheckPatches(const std::vector<PlanePoint>& columns, const std::vector<std::int32_t>& patch, Map& map)
{
  std::set<int> seen;
  for (std::size_t point = 0; point < columns.size(); ++point)
  {
    if (seen.count(int(point)) != 0)
    {
      continue;
    }
    // Holes are filled here: what is not outside is connected.
    std::set<std::int32_t> numbers;
    std::size_t size = 0;
    map.Flood(
      columns[point].X, columns[point].Y, 8, [](int cell) { return cell != Map::Outside; },
      [&](int& cell)
      {
        if (cell >= 0)
        {
          seen.insert(cell);
          numbers.insert(patch[std::size_t(cell)]);
          ++size;
        }
      });
    if (numbers.size() != 1 || std::size_t(std::count(patch.begin(), patch.end(), *numbers.begin())) != size)
    {
      return "patch of point " + std::to_string(point);
    }
  }
  return {};
}

std::string CheckLoop(const std::vector<PlanePoint>& columns, const std::vector<PointId>& loop)
{
  const auto at = [&](std::size_t n) { return columns[std::size_t(loop[n % loop.size()])]; };
  Wide area = 0;
  for (std::size_t n = 0; n < loop.size(); ++n)
  {
    const PlanePoint a = at(n);
    const PlanePoint b = at(n + 1);
    area += Cross(a, b);
    if (Apart(a, b) > 1 || (loop.size() > 1 && a == b))
    {
      return "hop from point " + std::to_string(loop[n]);
    }
    if (b < at(0))
    {
      return "first point of a loop";
    }
    for (std::size_t m = 0; m < n; ++m)
    {
      if (DoCross(a, b, at(m), at(m + 1)))
      {
        return "crossing of the hops from points " + std::to_string(loop[n]) + " and " + std::to_string(loop[m]);
      }
    }
  }
  return area > 0 ? "direction of a loop" : std::string();
}
}

//----------------------------------------------------------------------------------------------------------------------
std::string CheckOutlines(const std::vector<PlanePoint>& columns, const ExteriorBoundary& boundary)
{
  Map map(columns);
  std::string wrong = CheckPatches(columns, boundary.Patch, map);
  std::vector<bool> visited(columns.size(), false);
  for (std::size_t loop = 0; wrong.empty() && loop < boundary.Boundary.Size(); ++loop)
  {
    const std::vector<PointId> points(boundary.Boundary.begin(loop), boundary.Boundary.end(loop));
    for (const PointId point : points)
    {
      visited[std::size_t(point)] = true;
      wrong =
        boundary.Patch[std::size_t(point)] == std::int32_t(loop) ? wrong : "number of loop " + std::to_string(loop);
    }
    wrong = wrong.empty() ? CheckLoop(columns, points) : wrong;
  }
  for (std::size_t point = 0; wrong.empty() && point < columns.size(); ++point)
  {
    const int x = columns[point].X;
    const int y = columns[point].Y;
    const bool atOutside = map.At(x + 1, y) == Map::Outside || map.At(x - 1, y) == Map::Outside ||
      map.At(x, y + 1) == Map::Outside || map.At(x, y - 1) == Map::Outside;
    wrong = visited[point] == atOutside ? wrong : "point " + std::to_string(point) + " on or off the loops";
  }
  return wrong;
}
}
