// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Clockwise growth beside a graph that is built by the definition, from all pairs of points, and walked face by face.

#include "Boundary/ExteriorBoundary.h"
#include "Tools/Check.h"
#include "Tools/MeshChecker.h"
#include "Tools/Patches.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

using namespace SeismicHorizons;

namespace
{
using Edge = std::pair<std::size_t, std::size_t>;

// Plane geometry of its own, so that nothing is shared with what is tested.

std::int64_t Turn(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c)
{
  return (std::int64_t(b.X) - a.X) * (std::int64_t(c.Y) - a.Y) - (std::int64_t(b.Y) - a.Y) * (std::int64_t(c.X) - a.X);
}

bool AreOnBothSides(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, const PlanePoint& d)
{
  return (Turn(a, b, c) < 0 && Turn(a, b, d) > 0) || (Turn(a, b, c) > 0 && Turn(a, b, d) < 0);
}

bool Cross(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, const PlanePoint& d)
{
  return AreOnBothSides(a, b, c, d) && AreOnBothSides(c, d, a, b);
}

bool IsBetween(const PlanePoint& a, const PlanePoint& b, const PlanePoint& p)
{
  return p != a && p != b && Turn(a, b, p) == 0 && p.X >= std::min(a.X, b.X) && p.X <= std::max(a.X, b.X) &&
    p.Y >= std::min(a.Y, b.Y) && p.Y <= std::max(a.Y, b.Y);
}

class ReferenceGraph
{
public:
  ReferenceGraph(const Patches::Columns& columns, int radius)
    : Columns(columns)
  {
    std::vector<Candidate> candidates;
    for (std::size_t a = 0; a < columns.size(); ++a)
    {
      for (std::size_t b = 0; b < columns.size(); ++b)
      {
        if (a != b && IsRising(this->Way(a, b)) && Square(this->Way(a, b)) <= radius && !this->IsOverPoint(a, b))
        {
          candidates.push_back({ !this->IsDirect(a, b), Length(this->Way(a, b)), this->Sweep(a, b), { a, b } });
        }
      }
    }
    std::sort(candidates.begin(), candidates.end());
    for (const Candidate& candidate : candidates)
    {
      const Edge& edge = std::get<3>(candidate);
      const bool isCrossed = this->IsCrossed(edge);
      CHECK(!isCrossed || std::get<0>(candidate)); // direct hops never cross
      if (!isCrossed)
      {
        this->Edges.push_back(edge);
      }
    }
  }

  /// All faces, as points in the order of their walk, from the least column.
  std::vector<std::vector<PlanePoint>> Faces() const
  {
    std::map<std::size_t, std::vector<std::size_t>> next;
    std::set<Edge> left;
    for (const Edge& edge : this->Edges)
    {
      next[edge.first].push_back(edge.second);
      next[edge.second].push_back(edge.first);
      left.insert({ edge, { edge.second, edge.first } });
    }
    std::vector<std::vector<PlanePoint>> faces;
    while (!left.empty())
    {
      std::vector<PlanePoint> face;
      Edge edge = *left.begin();
      while (left.erase(edge) != 0)
      {
        face.push_back(this->Columns[edge.first]);
        edge = { edge.second, this->Turn(edge.second, edge.first, next[edge.second]) };
      }
      faces.push_back(Canonical(face));
    }
    for (std::size_t point = 0; point < this->Columns.size(); ++point)
    {
      if (next.count(point) == 0)
      {
        faces.push_back({ this->Columns[point] });
      }
    }
    return faces;
  }

  static std::vector<PlanePoint> Canonical(const std::vector<PlanePoint>& path)
  {
    std::vector<PlanePoint> best;
    for (std::size_t n = 0; n < path.size(); ++n)
    {
      std::vector<PlanePoint> shifted = path;
      std::rotate(shifted.begin(), shifted.begin() + std::ptrdiff_t(n), shifted.end());
      best = best.empty() ? shifted : std::min(best, shifted);
    }
    return best;
  }

private:
  /// Whether it is not direct, squared length, direction, ends.
  using Candidate = std::tuple<bool, std::int64_t, double, Edge>;

  static bool IsRising(const PlanePoint& way) { return way.Y > 0 || (way.Y == 0 && way.X > 0); }
  static int Square(const PlanePoint& way) { return std::max(std::abs(way.X), std::abs(way.Y)); }
  static std::int64_t Length(const PlanePoint& way)
  {
    return std::int64_t(way.X) * way.X + std::int64_t(way.Y) * way.Y;
  }

  PlanePoint Way(std::size_t a, std::size_t b) const
  {
    return { this->Columns[b].X - this->Columns[a].X, this->Columns[b].Y - this->Columns[a].Y };
  }

  /// How far a clockwise sweep from the south has turned. Directions of short hops are far apart.
  double Sweep(std::size_t a, std::size_t b) const
  {
    const double angle = std::atan2(-double(this->Way(a, b).X), -double(this->Way(a, b).Y));
    return angle < 0.0 ? angle + 8.0 * std::atan(1.0) : angle;
  }

  bool IsOverPoint(std::size_t a, std::size_t b) const
  {
    return std::any_of(this->Columns.begin(), this->Columns.end(),
      [&](const PlanePoint& point) { return IsBetween(this->Columns[a], this->Columns[b], point); });
  }

  bool IsDirect(std::size_t a, std::size_t b) const
  {
    const auto size = [this](std::size_t from, std::size_t to)
    { return std::make_pair(std::int64_t(Square(this->Way(from, to))), Length(this->Way(from, to))); };
    for (std::size_t point = 0; point < this->Columns.size(); ++point)
    {
      if (point != a && point != b && size(a, point) < size(a, b) && size(point, b) < size(a, b))
      {
        return false;
      }
    }
    return true;
  }

  bool IsCrossed(const Edge& edge) const
  {
    return std::any_of(this->Edges.begin(), this->Edges.end(),
      [&](const Edge& other)
      {
        return Cross(this->Columns[edge.first], this->Columns[edge.second], this->Columns[other.first],
          this->Columns[other.second]);
      });
  }

  /// The first neighbour of a point in a clockwise sweep after another one.
  std::size_t Turn(std::size_t point, std::size_t from, const std::vector<std::size_t>& neighbours) const
  {
    std::size_t best = from;
    double least = 100.0;
    for (const std::size_t neighbour : neighbours)
    {
      double turn = this->Sweep(point, neighbour) - this->Sweep(point, from);
      turn += neighbour == from || turn < 0.0 ? 8.0 * std::atan(1.0) : 0.0;
      if (turn < least)
      {
        least = turn;
        best = neighbour;
      }
    }
    return best;
  }

  const Patches::Columns& Columns;
  std::vector<Edge> Edges;
};

/// Twice the area of a face, counter-clockwise, and whether a column is strictly inside.
bool IsHole(const std::vector<PlanePoint>& face)
{
  Loops loop;
  std::int64_t area = 0;
  PlanePoint low = face.front();
  PlanePoint high = face.front();
  for (std::size_t n = 0; n < face.size(); ++n)
  {
    const PlanePoint& a = face[n];
    const PlanePoint& b = face[(n + 1) % face.size()];
    loop.Append(PointId(n));
    area += std::int64_t(a.X) * b.Y - std::int64_t(a.Y) * b.X;
    low = { std::min(low.X, a.X), std::min(low.Y, a.Y) };
    high = { std::max(high.X, a.X), std::max(high.Y, a.Y) };
  }
  loop.Close();
  for (std::int32_t x = low.X; area > 0 && x <= high.X; ++x)
  {
    for (std::int32_t y = low.Y; y <= high.Y; ++y)
    {
      if (MeshChecker::Locate(face, loop, { x, y }) > 0)
      {
        return true;
      }
    }
  }
  return false;
}

bool IsOutline(const std::vector<PlanePoint>& face)
{
  std::int64_t area = 0;
  for (std::size_t n = 0; n < face.size(); ++n)
  {
    const PlanePoint& a = face[n];
    const PlanePoint& b = face[(n + 1) % face.size()];
    area += std::int64_t(a.X) * b.Y - std::int64_t(a.Y) * b.X;
  }
  return area <= 0;
}

void Compare(const Patches::Columns& columns, int radius, const std::string& name)
{
  BoundaryOptions options;
  options.Radius = radius;
  options.HoleBoundaries = true;
  const ExteriorBoundary boundary = FindExteriorBoundary(columns, options);
  std::multiset<std::vector<PlanePoint>> found;
  for (std::size_t loop = 0; loop < boundary.Boundary.Size(); ++loop)
  {
    std::vector<PlanePoint> path;
    std::for_each(boundary.Boundary.begin(loop), boundary.Boundary.end(loop),
      [&](PointId point) { path.push_back(columns[std::size_t(point)]); });
    found.insert(ReferenceGraph::Canonical(path));
  }
  std::multiset<std::vector<PlanePoint>> expected;
  for (const std::vector<PlanePoint>& face : ReferenceGraph(columns, radius).Faces())
  {
    if (IsOutline(face) || IsHole(face))
    {
      expected.insert(face);
    }
  }
  if (!CHECK(found == expected))
  {
    std::cerr << name << ", radius " << radius << ": " << found.size() << " loops, expected " << expected.size()
              << '\n';
  }
}

/// Random columns of a square.
Patches::Columns Scatter(int size, double density, Patches::Random& random)
{
  Patches::Columns columns;
  for (int n = 0; n < size * size; ++n)
  {
    if (random.Chance(density))
    {
      columns.push_back({ n % size, n / size });
    }
  }
  return columns;
}
}

int TestPlanarHops(int, char*[])
{
  Patches::Random random(23);
  for (int n = 0; n < 300; ++n)
  {
    const Patches::Columns columns = Patches::Make(Patches::Shape(n % int(Patches::Shape::Count)), random);
    Compare(columns, 2 + n % 4, "patch " + std::to_string(n));
    if (n < 60)
    {
      Compare(columns, 6 + n % 10, "patch " + std::to_string(n));
    }
  }
  // Hops as long as can be, from nearly every point to nearly every other one.
  for (const double density : { 0.01, 0.03, 0.1 })
  {
    Compare(Scatter(60, density, random), LargestRadius, "density " + std::to_string(density));
  }
  return Check::Result();
}
