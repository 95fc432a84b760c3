// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Clockwise growth beside a graph that is built by the definition, from all pairs of points, and walked face by face.

#include "Common/Horizon/PlaneGeometry.h"
#include "Filters/Algorithms/Boundary/ExteriorBoundary.h"
#include "Tools/Check.h"
#include "Tools/ExactPlane.h"
#include "Tools/Patches.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

using namespace SeismicHorizons;

namespace
{
using Hop = std::pair<std::size_t, std::size_t>;

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
          candidates.push_back({ !this->IsDirect(a, b), Length(this->Way(a, b)), this->SweepAngle(a, b), { a, b } });
        }
      }
    }
    std::sort(candidates.begin(), candidates.end());
    for (const Candidate& candidate : candidates)
    {
      const Hop& hop = std::get<3>(candidate);
      const bool isCrossed = this->IsCrossed(hop);
      CHECK(!isCrossed || std::get<0>(candidate)); // direct hops never cross
      if (!isCrossed)
      {
        this->Hops.push_back(hop);
      }
    }
  }

  /// All faces, as points in the order of their walk, from the least column.
  std::vector<std::vector<PlanePoint>> Faces() const
  {
    std::map<std::size_t, std::vector<std::size_t>> next;
    std::set<Hop> left;
    for (const Hop& hop : this->Hops)
    {
      next[hop.first].push_back(hop.second);
      next[hop.second].push_back(hop.first);
      left.insert({ hop, { hop.second, hop.first } });
    }
    std::vector<std::vector<PlanePoint>> faces;
    while (!left.empty())
    {
      std::vector<PlanePoint> face;
      Hop hop = *left.begin();
      while (left.erase(hop) != 0)
      {
        face.push_back(this->Columns[hop.first]);
        hop = { hop.second, this->Next(hop.second, hop.first, next[hop.second]) };
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
  using Candidate = std::tuple<bool, std::int64_t, double, Hop>;

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
  double SweepAngle(std::size_t a, std::size_t b) const
  {
    const double angle = std::atan2(-double(this->Way(a, b).X), -double(this->Way(a, b).Y));
    return angle < 0.0 ? angle + 8.0 * std::atan(1.0) : angle;
  }

  bool IsOverPoint(std::size_t a, std::size_t b) const
  {
    return std::any_of(this->Columns.begin(), this->Columns.end(),
      [&](const PlanePoint& point)
      {
        return point != this->Columns[a] && point != this->Columns[b] &&
          ExactPlane::IsOnSegment(this->Columns[a], this->Columns[b], point);
      });
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

  bool IsCrossed(const Hop& hop) const
  {
    return std::any_of(this->Hops.begin(), this->Hops.end(),
      [&](const Hop& other)
      {
        return ExactPlane::DoCross(
          this->Columns[hop.first], this->Columns[hop.second], this->Columns[other.first], this->Columns[other.second]);
      });
  }

  /// The first neighbour of a point in a clockwise sweep after another one.
  std::size_t Next(std::size_t point, std::size_t from, const std::vector<std::size_t>& neighbours) const
  {
    std::size_t best = from;
    double least = 100.0;
    for (const std::size_t neighbour : neighbours)
    {
      double turn = this->SweepAngle(point, neighbour) - this->SweepAngle(point, from);
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
  std::vector<Hop> Hops;
};

/// Twice the area of a face, positive when it runs counter-clockwise.
ExactPlane::Wide TwiceArea(const std::vector<PlanePoint>& face)
{
  ExactPlane::Wide area = 0;
  for (std::size_t n = 0; n < face.size(); ++n)
  {
    area += ExactPlane::Cross(face[n], face[(n + 1) % face.size()]);
  }
  return area;
}

/// Whether a face runs counter-clockwise and has a column strictly inside.
bool IsHole(const std::vector<PlanePoint>& face)
{
  Loops loop;
  for (std::size_t n = 0; n < face.size(); ++n)
  {
    loop.Append(PointId(n));
  }
  loop.Close();
  const PlaneBox box(face);
  for (std::int32_t x = box.Least.X; TwiceArea(face) > 0 && x <= box.Greatest.X; ++x)
  {
    for (std::int32_t y = box.Least.Y; y <= box.Greatest.Y; ++y)
    {
      if (ExactPlane::Locate(face, loop, { x, y }) > 0)
      {
        return true;
      }
    }
  }
  return false;
}

bool IsOutline(const std::vector<PlanePoint>& face)
{
  return TwiceArea(face) <= 0;
}

void Compare(const Patches::Columns& columns, int radius, const std::string& name)
{
  BoundaryOptions options;
  options.Radius = radius;
  options.KeepHoles = true;
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
