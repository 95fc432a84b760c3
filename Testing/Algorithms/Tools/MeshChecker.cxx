// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshChecker.h"

#include <algorithm>
#include <map>
#include <queue>
#include <set>
#include <utility>

namespace MeshChecker
{
namespace
{
using SeismicHorizons::BoundedHorizon;
using SeismicHorizons::Loops;
using SeismicHorizons::PlanePoint;
using SeismicHorizons::PointId;
using SeismicHorizons::RawVector;
__extension__ typedef __int128 Wide;
using Edge = std::pair<PointId, PointId>;

Wide Turn(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c)
{
  return Wide(b.X - a.X) * (c.Y - a.Y) - Wide(b.Y - a.Y) * (c.X - a.X);
}

int SignOf(Wide value)
{
  return int(value > 0) - int(value < 0);
}

bool Cross(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, const PlanePoint& d)
{
  return SignOf(Turn(a, b, c)) * SignOf(Turn(a, b, d)) < 0 && SignOf(Turn(c, d, a)) * SignOf(Turn(c, d, b)) < 0;
}

bool Between(const PlanePoint& a, const PlanePoint& b, const PlanePoint& p)
{
  return Turn(a, b, p) == 0 && std::min(a.X, b.X) <= p.X && p.X <= std::max(a.X, b.X) && std::min(a.Y, b.Y) <= p.Y &&
    p.Y <= std::max(a.Y, b.Y);
}

std::string Describe(const char* what, PointId a, PointId b)
{
  return std::string(what) + " " + std::to_string(a) + " - " + std::to_string(b);
}

/// A picture of the columns with a rim, for flooding.
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
    // Holes are filled here: all that is not outside hangs together.
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
    area += Wide(a.X) * b.Y - Wide(a.Y) * b.X;
    if (std::max(std::abs(a.X - b.X), std::abs(a.Y - b.Y)) > 1 || (loop.size() > 1 && a == b))
    {
      return Describe("hop", loop[n], loop[(n + 1) % loop.size()]);
    }
    if (b < at(0))
    {
      return "first point of a loop";
    }
    for (std::size_t m = 0; m < n; ++m)
    {
      if (Cross(a, b, at(m), at(m + 1)))
      {
        return Describe("crossing at hop", loop[n], loop[m]);
      }
    }
  }
  return area > 0 ? "direction of a loop" : std::string();
}

/// The loops of a boundary one by one, and what they are.
class BoundaryParts
{
public:
  BoundaryParts(const std::vector<PlanePoint>& columns, const SeismicHorizons::ExteriorBoundary& boundary)
    : Columns(columns)
    , Boundary(boundary)
  {
    for (std::size_t loop = 0; loop < boundary.Boundary.Size(); ++loop)
    {
      this->Single.emplace_back().AppendLoop(boundary.Boundary, loop);
    }
  }

  std::size_t Size() const { return this->Single.size(); }
  bool IsHole(std::size_t loop) const { return loop >= this->Boundary.NumberOfPatches; }
  std::int32_t PatchOf(std::size_t loop) const
  {
    return this->Boundary.Patch[std::size_t(*this->Boundary.Boundary.begin(loop))];
  }
  int Locate(std::size_t loop, const PlanePoint& place) const
  {
    // A loop of one point has no edges.
    const bool isPoint =
      this->Single[loop].TotalLength() == 1 && this->Columns[std::size_t(*this->Single[loop].begin(0))] == place;
    return isPoint ? 0 : MeshChecker::Locate(this->Columns, this->Single[loop], place);
  }

  Wide TwiceArea(std::size_t loop) const
  {
    Wide area = 0;
    this->Single[loop].ForEachEdge(
      [&](PointId from, PointId to)
      {
        const PlanePoint& a = this->Columns[std::size_t(from)];
        const PlanePoint& b = this->Columns[std::size_t(to)];
        area += Wide(a.X) * b.Y - Wide(a.Y) * b.X;
      });
    return area;
  }

  /// Columns strictly inside a loop.
  std::int64_t CountInside(std::size_t loop) const
  {
    const auto x = std::minmax_element(
      this->Columns.begin(), this->Columns.end(), [](const PlanePoint& a, const PlanePoint& b) { return a.X < b.X; });
    const auto y = std::minmax_element(
      this->Columns.begin(), this->Columns.end(), [](const PlanePoint& a, const PlanePoint& b) { return a.Y < b.Y; });
    std::int64_t inside = 0;
    for (std::int32_t i = x.first->X; i <= x.second->X; ++i)
    {
      for (std::int32_t j = y.first->Y; j <= y.second->Y; ++j)
      {
        inside += this->Locate(loop, { i, j }) > 0 ? 1 : 0;
      }
    }
    return inside;
  }

private:
  const std::vector<PlanePoint>& Columns;
  const SeismicHorizons::ExteriorBoundary& Boundary;
  std::vector<Loops> Single;
};

int Apart(const PlanePoint& a, const PlanePoint& b)
{
  return std::max(std::abs(a.X - b.X), std::abs(a.Y - b.Y));
}

std::string CheckHops(const std::vector<PlanePoint>& columns, const Loops& boundary, int radius)
{
  std::vector<Edge> boundaryEdges;
  boundary.ForEachEdge([&](PointId from, PointId to) { boundaryEdges.push_back({ from, to }); });
  for (std::size_t n = 0; n < boundaryEdges.size(); ++n)
  {
    const PlanePoint& a = columns[std::size_t(boundaryEdges[n].first)];
    const PlanePoint& b = columns[std::size_t(boundaryEdges[n].second)];
    if (a == b || Apart(a, b) > radius)
    {
      return Describe("length of hop", boundaryEdges[n].first, boundaryEdges[n].second);
    }
    for (std::size_t m = 0; m < n; ++m)
    {
      const PlanePoint& c = columns[std::size_t(boundaryEdges[m].first)];
      if (Apart(a, c) / 2 <= radius && Cross(a, b, c, columns[std::size_t(boundaryEdges[m].second)]))
      {
        return Describe("crossing at hop", boundaryEdges[n].first, boundaryEdges[m].first);
      }
    }
    for (std::size_t point = 0; Apart(a, b) > 1 && point < columns.size(); ++point)
    {
      if (columns[point] != a && columns[point] != b && Between(a, b, columns[point]))
      {
        return Describe("point on hop", PointId(point), boundaryEdges[n].first);
      }
    }
  }
  return {};
}

/// All that hangs together has one number.
std::string CheckConnection(const std::vector<PlanePoint>& columns, const std::vector<std::int32_t>& patch, int radius)
{
  for (std::size_t a = 0; a < columns.size(); ++a)
  {
    for (std::size_t b = 0; b < a; ++b)
    {
      if (patch[a] != patch[b] && Apart(columns[a], columns[b]) <= radius)
      {
        return Describe("two patches within the radius at", PointId(a), PointId(b));
      }
    }
  }
  return {};
}

std::string CheckLoops(const std::vector<PlanePoint>& columns, const SeismicHorizons::ExteriorBoundary& boundary,
  const BoundaryParts& parts, const SeismicHorizons::BoundaryOptions& options)
{
  for (std::size_t loop = 0; loop < parts.Size(); ++loop)
  {
    const std::string name = " of loop " + std::to_string(loop);
    if (parts.IsHole(loop) ? !options.HoleBoundaries : parts.PatchOf(loop) != std::int32_t(loop))
    {
      return "number" + name;
    }
    if (parts.IsHole(loop) != (parts.TwiceArea(loop) > 0))
    {
      return "direction" + name;
    }
    if (parts.IsHole(loop) && parts.CountInside(loop) < std::max<std::int64_t>(1, options.SmallestHoleSize))
    {
      return "size" + name;
    }
    const PlanePoint& first = columns[std::size_t(*boundary.Boundary.begin(loop))];
    for (const PointId* point = boundary.Boundary.begin(loop); point != boundary.Boundary.end(loop); ++point)
    {
      if (columns[std::size_t(*point)] < first || boundary.Patch[std::size_t(*point)] != parts.PatchOf(loop))
      {
        return "start or patch" + name;
      }
    }
  }
  return {};
}

/// A point is in the patch around it, and in no other.
std::string CheckInside(
  const std::vector<PlanePoint>& columns, const std::vector<std::int32_t>& patch, const BoundaryParts& parts)
{
  for (std::size_t point = 0; point < columns.size(); ++point)
  {
    // For each patch: 1 inside its loop or on it, less 1 inside one of its holes.
    std::map<std::int32_t, int> depth;
    for (std::size_t loop = 0; loop < parts.Size(); ++loop)
    {
      const int side = parts.Locate(loop, columns[point]);
      depth[parts.PatchOf(loop)] += parts.IsHole(loop) ? -int(side > 0) : int(side >= 0);
    }
    for (const auto& [number, inside] : depth)
    {
      if (inside != int(number == patch[point]))
      {
        return "point " + std::to_string(point) + " and patch " + std::to_string(number);
      }
    }
  }
  return {};
}

using EdgeTriangles = std::map<Edge, PointId>; // the third point to the left of a directed edge

std::string CollectEdges(
  const BoundedHorizon& horizon, const RawVector<PointId>& triangles, EdgeTriangles& edges, Wide& area)
{
  for (std::size_t corner = 0; corner < triangles.size(); corner += 3)
  {
    const PointId* const t = triangles.data() + corner;
    const Wide size =
      Turn(horizon.Plane[std::size_t(t[0])], horizon.Plane[std::size_t(t[1])], horizon.Plane[std::size_t(t[2])]);
    area += size;
    for (int n = 0; n < 3; ++n)
    {
      if (size <= 0 || !edges.insert({ { t[n], t[(n + 1) % 3] }, t[(n + 2) % 3] }).second)
      {
        return Describe(size <= 0 ? "triangle facing down at" : "two triangles left of", t[n], t[(n + 1) % 3]);
      }
    }
  }
  return {};
}

/// The boundary edges with surface on one side, in the direction that has it to the left, and twice the area they
/// enclose.
std::set<Edge> CollectBoundaryEdges(const BoundedHorizon& horizon, Wide& area)
{
  std::set<Edge> boundaryEdges;
  horizon.Boundary.ForEachEdge(
    [&](PointId from, PointId to)
    {
      const PlanePoint& a = horizon.Plane[std::size_t(to)];
      const PlanePoint& b = horizon.Plane[std::size_t(from)];
      area += Wide(a.X) * b.Y - Wide(a.Y) * b.X;
      if (boundaryEdges.erase({ from, to }) == 0)
      {
        boundaryEdges.insert({ to, from });
      }
    });
  return boundaryEdges;
}

std::string CheckEdges(const BoundedHorizon& horizon, const EdgeTriangles& edges, const std::set<Edge>& boundaryEdges)
{
  const auto at = [&](PointId point) { return horizon.Plane[std::size_t(point)]; };
  for (const auto& [edge, third] : edges)
  {
    const auto twin = edges.find({ edge.second, edge.first });
    const bool onBoundary = boundaryEdges.count(edge) != 0;
    if (onBoundary != (twin == edges.end()))
    {
      return Describe("boundary and mesh differ at", edge.first, edge.second);
    }
    if (!onBoundary && SideOfCircle(at(edge.first), at(edge.second), at(third), at(twin->second)) > 0)
    {
      return Describe("not Delaunay:", edge.first, edge.second);
    }
  }
  for (const Edge& edge : boundaryEdges)
  {
    if (edges.count(edge) == 0)
    {
      return Describe("no triangle at boundary", edge.first, edge.second);
    }
  }
  return {};
}

/// Points - edges + triangles = 1 for each patch, which is one loop and what it encloses, less 1 for each hole.
std::string CheckEuler(const BoundedHorizon& horizon, const EdgeTriangles& edges)
{
  std::map<std::int32_t, std::int64_t> sum;
  for (const std::int32_t patch : horizon.Patch)
  {
    ++sum[patch];
  }
  std::set<Edge> undirected;
  for (const auto& [edge, third] : edges)
  {
    undirected.insert(std::minmax(edge.first, edge.second));
  }
  horizon.Boundary.ForEachEdge([&](PointId from, PointId to) { undirected.insert(std::minmax(from, to)); });
  for (const Edge& edge : undirected)
  {
    --sum[horizon.Patch[std::size_t(edge.first)]];
  }
  // One loop of each patch is not that of a hole.
  for (std::size_t loop = 0; loop < horizon.Boundary.Size(); ++loop)
  {
    ++sum[horizon.Patch[std::size_t(*horizon.Boundary.begin(loop))]];
  }
  std::map<std::int32_t, std::int64_t> corners;
  for (const auto& [edge, third] : edges)
  {
    ++corners[horizon.Patch[std::size_t(edge.first)]];
  }
  for (const auto& [patch, count] : sum)
  {
    if (count + corners[patch] / 3 != 2)
    {
      return "Euler's formula fails for patch " + std::to_string(patch);
    }
  }
  return {};
}
}

//----------------------------------------------------------------------------------------------------------------------
// By cofactors of the 4 x 4 determinant.
int SideOfCircle(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, const PlanePoint& d)
{
  const auto lift = [&d](const PlanePoint& p) { return Wide(p.X - d.X) * (p.X - d.X) + Wide(p.Y - d.Y) * (p.Y - d.Y); };
  return SignOf(lift(a) * Turn(d, b, c) - lift(b) * Turn(d, a, c) + lift(c) * Turn(d, a, b));
}

//----------------------------------------------------------------------------------------------------------------------
std::string CheckExteriorBoundary(
  const std::vector<PlanePoint>& columns, const SeismicHorizons::ExteriorBoundary& boundary)
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

//----------------------------------------------------------------------------------------------------------------------
std::string CheckBoundary(const std::vector<PlanePoint>& columns, const SeismicHorizons::ExteriorBoundary& boundary,
  const SeismicHorizons::BoundaryOptions& options)
{
  const BoundaryParts parts(columns, boundary);
  std::string wrong = CheckHops(columns, boundary.Boundary, options.Radius);
  wrong = wrong.empty() ? CheckConnection(columns, boundary.Patch, options.Radius) : wrong;
  wrong = wrong.empty() ? CheckLoops(columns, boundary, parts, options) : wrong;
  return wrong.empty() ? CheckInside(columns, boundary.Patch, parts) : wrong;
}

//----------------------------------------------------------------------------------------------------------------------
int Locate(const std::vector<PlanePoint>& places, const Loops& boundary, const PlanePoint& place)
{
  bool inside = false;
  bool on = false;
  boundary.ForEachEdge(
    [&](PointId from, PointId to)
    {
      const PlanePoint& a = places[std::size_t(from)];
      const PlanePoint& b = places[std::size_t(to)];
      if (std::max(a.Y, b.Y) < place.Y || std::min(a.Y, b.Y) > place.Y)
      {
        return;
      }
      on = on || Between(a, b, place);
      // A ray to the right: it passes the hop when the hop goes over its height with the place on its left.
      const PlanePoint& low = a.Y < b.Y ? a : b;
      const PlanePoint& high = a.Y < b.Y ? b : a;
      if (low.Y <= place.Y && place.Y < high.Y && Turn(low, high, place) > 0)
      {
        inside = !inside;
      }
    });
  return on ? 0 : (inside ? 1 : -1);
}

//----------------------------------------------------------------------------------------------------------------------
std::string CheckCrossings(const BoundedHorizon& horizon)
{
  return CheckHops(horizon.Plane, horizon.Boundary, 1 << 30);
}

//----------------------------------------------------------------------------------------------------------------------
std::string CheckMesh(const BoundedHorizon& horizon, const RawVector<PointId>& triangles)
{
  EdgeTriangles edges;
  Wide meshArea = 0;
  Wide boundaryArea = 0;
  std::string wrong = CollectEdges(horizon, triangles, edges, meshArea);
  const std::set<Edge> boundaryEdges = CollectBoundaryEdges(horizon, boundaryArea);
  if (wrong.empty() && meshArea != boundaryArea)
  {
    wrong = "area of the mesh";
  }
  std::vector<bool> used(horizon.Plane.size(), false);
  for (const PointId point : triangles)
  {
    used[std::size_t(point)] = true;
  }
  for (std::size_t loop = 0; loop < horizon.Boundary.Size(); ++loop)
  {
    std::for_each(horizon.Boundary.begin(loop), horizon.Boundary.end(loop),
      [&used](PointId point) { used[std::size_t(point)] = true; });
  }
  const auto unused = std::find(used.begin(), used.end(), false);
  if (wrong.empty() && unused != used.end())
  {
    wrong = "unused point " + std::to_string(unused - used.begin());
  }
  wrong = wrong.empty() ? CheckEdges(horizon, edges, boundaryEdges) : wrong;
  return wrong.empty() ? CheckEuler(horizon, edges) : wrong;
}
}
