// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SealedImprover.h"

#include "BoxTree.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace SeismicHorizons
{
namespace
{
using GonePlaces = std::vector<Eigen::Vector3d>;

constexpr double Short = 0.02; // columns; edges up to this length may go with their corners

/// Visits heights over a triangle, until visit(how far one is above it) is false.
template <typename Visitor>
void ForEachHeight(const SheetHeights& heights, const std::array<Eigen::Vector3d, 3>& corners, Visitor&& visit)
{
  if (heights.Heights.empty())
  {
    return;
  }
  std::array<Eigen::Vector3d, 3> p;
  for (std::size_t n = 0; n < 3; ++n)
  {
    p[n] = heights.Axes * corners[n];
    p[n].head<2>() = (p[n].head<2>() - heights.Origin).array() / heights.Step.array();
  }
  const Eigen::Vector3d b = p[1] - p[0], c = p[2] - p[0];
  const double area = b.x() * c.y() - b.y() * c.x();
  if (!(area > 0.0))
  {
    return;
  }
  const double slopeX = (b.z() * c.y() - c.z() * b.y()) / area, slopeY = (c.z() * b.x() - b.z() * c.x()) / area;
  const auto rows = double(heights.Heights.size() / std::size_t(heights.Width));
  const double first = std::max(0.0, std::ceil(std::min({ p[0].y(), p[1].y(), p[2].y() })));
  const double last = std::min(rows - 1.0, std::floor(std::max({ p[0].y(), p[1].y(), p[2].y() })));
  for (double row = first; row <= last; ++row)
  {
    double from = 1e300, to = -1e300;
    for (std::size_t n = 0; n < 3; ++n)
    {
      const Eigen::Vector3d &u = p[n], &v = p[(n + 1) % 3];
      if ((u.y() <= row) != (v.y() <= row) || u.y() == row)
      {
        const double x = u.y() == v.y() ? u.x() : u.x() + (v.x() - u.x()) * (row - u.y()) / (v.y() - u.y());
        from = std::min(from, x);
        to = std::max(to, x);
      }
    }
    const int begin = int(std::clamp(std::ceil(from), 0.0, double(heights.Width)));
    const int end = int(std::clamp(std::floor(to), -1.0, double(heights.Width - 1)));
    const double* const along = &heights.Heights[std::size_t(row) * std::size_t(heights.Width)];
    for (int x = begin; x <= end; ++x)
    {
      if (!std::isnan(along[x]) && !visit(along[x] - p[0].z() - slopeX * (x - p[0].x()) - slopeY * (row - p[0].y())))
      {
        return;
      }
    }
  }
}

double CosineOfSmallestAngle(const std::array<Eigen::Vector3d, 3>& corners)
{
  double largest = -1.0;
  for (std::size_t n = 0; n < 3; ++n)
  {
    const Eigen::Vector3d u = corners[(n + 1) % 3] - corners[n], v = corners[(n + 2) % 3] - corners[n];
    largest = std::max(largest, u.dot(v) / (u.norm() * v.norm()));
  }
  return largest;
}

/// 6 times the volume of a tetrahedron; 0 if rounding could turn its sign.
double CertainVolume(
  const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, const Eigen::Vector3d& d)
{
  const Eigen::Vector3d p = a - d, q = b - d, r = c - d;
  const double volume = p.dot(q.cross(r));
  constexpr double rounding = 1e-14;
  return std::abs(volume) > rounding * p.norm() * q.norm() * r.norm() ? volume : 0.0;
}

class Improver
{
public:
  Improver(SealedComplex complex, const std::vector<SheetShape>& shapes, const ImproverOptions& options)
    : Complex(std::move(complex))
    , Shapes(shapes)
    , Options(options)
    , LargestCosine(std::cos(options.SmallestAngle / DegreesPerRadian))
    , Around(this->Complex.Vertices.size())
    , Changed(this->Complex.Vertices.size(), 0)
    , Attempts(this->Complex.Vertices.size())
  {
    std::vector<std::vector<BoxTree::Entry>> entries(shapes.size());
    for (std::size_t n = 0; n < this->Complex.Triangles.size(); ++n)
    {
      const LabelledTriangle& triangle = this->Complex.Triangles[n];
      entries[std::size_t(triangle.Sheet)].push_back({ SealId(n), this->BoxOf(triangle.Corners) });
      for (const SealId corner : triangle.Corners)
      {
        this->Around[std::size_t(corner)].push_back(SealId(n));
      }
    }
    this->Trees = std::vector<BoxTree>(entries.begin(), entries.end());
  }

  void Run(const Monitor& monitor)
  {
    this->CloseGaps();
    constexpr std::array<double, 6> parts = { 0.05, 0.2, 0.4, 0.7, 1.0, 1.0 };
    for (std::size_t round = 0; round < parts.size(); ++round)
    {
      monitor.Progress(double(round) / double(parts.size()));
      this->Part = parts[round];
      this->RemoveVertices();
      this->FlipEdges();
      this->CloseGaps();
    }
  }

  SealedComplex Take()
  {
    std::vector<LabelledTriangle>& triangles = this->Complex.Triangles;
    triangles.erase(std::remove_if(triangles.begin(), triangles.end(),
                      [](const LabelledTriangle& triangle) { return triangle.Sheet < 0; }),
      triangles.end());
    DropUnused(this->Complex);
    return std::move(this->Complex);
  }

private:
  /// To remove a vertex that is on no line, whose error would count, too.
  struct Attempt
  {
    std::size_t Time = 0;
    double Part = 0.0; // of the error of heights
  };

  double PartOfHeights() const { return std::max(this->Part, 0.5); }
  const Eigen::Vector3d& At(SealId vertex) const { return this->Complex.Vertices[std::size_t(vertex)]; }
  const LabelledTriangle& Triangle(SealId triangle) const { return this->Complex.Triangles[std::size_t(triangle)]; }
  std::array<Eigen::Vector3d, 3> CornersOf(const SheetCorners& t) const
  {
    return { this->At(t[0]), this->At(t[1]), this->At(t[2]) };
  }
  Eigen::AlignedBox3d BoxOf(const SheetCorners& t) const
  {
    Eigen::AlignedBox3d box(this->At(t[0]));
    return box.extend(this->At(t[1])).extend(this->At(t[2]));
  }
  static bool Has(const SheetCorners& corners, SealId vertex)
  {
    return corners[0] == vertex || corners[1] == vertex || corners[2] == vertex;
  }

  std::vector<SealId> NeighboursOf(SealId vertex) const
  {
    std::vector<SealId> neighbours;
    for (const SealId triangle : this->Around[std::size_t(vertex)])
    {
      for (const SealId corner : this->Triangle(triangle).Corners)
      {
        if (corner != vertex)
        {
          neighbours.push_back(corner);
        }
      }
    }
    std::sort(neighbours.begin(), neighbours.end());
    neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
    return neighbours;
  }

  /// What surfaces meet at an edge, in order. Beyond its tips a fault is another surface.
  using EdgeKind = std::vector<std::array<SealId, 3>>;
  EdgeKind KindOf(SealId a, SealId b) const
  {
    EdgeKind kind;
    for (const SealId triangle : this->Around[std::size_t(a)])
    {
      const LabelledTriangle& t = this->Triangle(triangle);
      if (Has(t.Corners, b))
      {
        kind.push_back({ t.IsBeyondTips ? ~t.Sheet : t.Sheet, t.Labels[0], t.Labels[1] });
      }
    }
    std::sort(kind.begin(), kind.end());
    return kind;
  }
  static bool IsLine(const EdgeKind& kind) { return kind.size() != 2 || kind[0] != kind[1]; }

  /// Ends of the line through the vertex: none inside a surface, two on a line, otherwise the vertex is a corner.
  std::vector<SealId> LineThrough(SealId vertex, const std::vector<SealId>& neighbours, bool& isCorner) const
  {
    std::vector<SealId> ends;
    EdgeKind first;
    isCorner = false;
    for (const SealId neighbour : neighbours)
    {
      EdgeKind kind = this->KindOf(vertex, neighbour);
      if (IsLine(kind))
      {
        isCorner = isCorner || (!ends.empty() && kind != first);
        first = std::move(kind);
        ends.push_back(neighbour);
      }
    }
    isCorner = isCorner || (!ends.empty() && ends.size() != 2);
    return ends;
  }

  void RemoveVertices()
  {
    std::vector<std::pair<double, SealId>> order;
    for (std::size_t n = 0; n < this->Around.size(); ++n)
    {
      double least = 1e300;
      for (const SealId triangle : this->Around[n])
      {
        for (const SealId corner : this->Triangle(triangle).Corners)
        {
          const double length = (this->At(corner) - this->At(SealId(n))).squaredNorm();
          least = corner == SealId(n) ? least : std::min(least, length);
        }
      }
      order.emplace_back(least, SealId(n));
    }
    std::sort(order.begin(), order.end());
    for (const auto& [length, vertex] : order)
    {
      this->Remove(vertex);
    }
  }

  /// What could not be removed cannot be now, if nothing has changed around it, nor the errors that count.
  bool IsSettled(SealId vertex) const
  {
    const Attempt& last = this->Attempts[std::size_t(vertex)];
    const auto isAsBefore = [&](SealId other) { return this->Changed[std::size_t(other)] < last.Time; };
    const std::vector<SealId> neighbours = this->NeighboursOf(vertex);
    return this->PartOfHeights() == last.Part && isAsBefore(vertex) &&
      std::all_of(neighbours.begin(), neighbours.end(), isAsBefore);
  }

  void Remove(SealId vertex)
  {
    if (this->Around[std::size_t(vertex)].empty() || this->IsSettled(vertex))
    {
      return;
    }
    const Removal removal = this->RemovalOf(vertex);
    const auto lengthTo = [&](SealId target) { return (this->At(target) - this->At(vertex)).squaredNorm(); };
    std::vector<SealId> targets = removal.Neighbours;
    std::sort(targets.begin(), targets.end(),
      [&](SealId a, SealId b)
      {
        const double p = lengthTo(a), q = lengthTo(b);
        return p != q ? p < q : a < b;
      });
    bool isCorner = false;
    const std::vector<SealId> ends = this->LineThrough(vertex, removal.Neighbours, isCorner);
    ++this->Time;
    this->Attempts[std::size_t(vertex)] = { isCorner || ends.empty() ? this->Time : 0, this->PartOfHeights() };
    if (isCorner)
    {
      const double shortest = std::pow(Short * this->Options.Column, 2);
      if (lengthTo(targets.front()) < shortest && this->IsOnWallsOf(vertex, targets.front()))
      {
        this->Try(removal, targets.front());
      }
      return;
    }
    GonePlaces gone = ends.empty() ? GonePlaces() : this->GoneFrom(vertex, ends);
    for (const SealId target : targets)
    {
      if (ends.empty() && this->Try(removal, target, true))
      {
        return;
      }
      if (std::find(ends.begin(), ends.end(), target) != ends.end() && this->IsNearLine(gone, ends) &&
        this->IsOnWallsOf(vertex, target) && this->Try(removal, target))
      {
        this->Gone.erase(KeyOf(vertex, ends[0]));
        this->Gone.erase(KeyOf(vertex, ends[1]));
        this->Gone[KeyOf(ends[0], ends[1])] = std::move(gone);
        return;
      }
    }
  }

  /// Whether the other vertex is on all walls that the vertex is on, which it may not leave.
  bool IsOnWallsOf(SealId vertex, SealId other) const
  {
    const std::vector<SealId>& around = this->Around[std::size_t(vertex)];
    return std::all_of(around.begin(), around.end(),
      [&](SealId triangle)
      {
        const SealId sheet = this->Triangle(triangle).Sheet;
        const std::vector<SealId>& others = this->Around[std::size_t(other)];
        return !this->Shapes[std::size_t(sheet)].IsLevel() ||
          std::any_of(
            others.begin(), others.end(), [&](SealId beside) { return this->Triangle(beside).Sheet == sheet; });
      });
  }

  /// Whether the other vertex is on all faults that the vertex is on, which it may not draw beyond their tips.
  bool IsOnFaultsOf(SealId vertex, SealId other) const
  {
    const std::vector<SealId>& around = this->Around[std::size_t(vertex)];
    const std::vector<SealId>& others = this->Around[std::size_t(other)];
    return std::all_of(around.begin(), around.end(),
      [&](SealId triangle)
      {
        const LabelledTriangle& own = this->Triangle(triangle);
        const auto isOn = [&](bool isBeyondTips)
        {
          return std::any_of(others.begin(), others.end(),
            [&](SealId beside) {
              return this->Triangle(beside).Sheet == own.Sheet && this->Triangle(beside).IsBeyondTips == isBeyondTips;
            });
        };
        return own.IsBeyondTips || !isOn(true) || isOn(false);
      });
  }

  /// Places of the line that a vertex and those removed before it had.
  GonePlaces GoneFrom(SealId vertex, const std::vector<SealId>& ends) const
  {
    GonePlaces gone = { this->At(vertex) };
    for (const SealId end : ends)
    {
      const auto found = this->Gone.find(KeyOf(vertex, end));
      if (found != this->Gone.end())
      {
        gone.insert(gone.end(), found->second.begin(), found->second.end());
      }
    }
    return gone;
  }

  bool IsNearLine(const GonePlaces& gone, const std::vector<SealId>& ends) const
  {
    const Eigen::Vector3d &from = this->At(ends[0]), way = this->At(ends[1]) - from;
    const double most = std::pow(this->Part * this->Options.LineError, 2);
    return std::all_of(gone.begin(), gone.end(),
      [&](const Eigen::Vector3d& place)
      {
        const double part = std::clamp((place - from).dot(way) / way.squaredNorm(), 0.0, 1.0);
        return (place - from - part * way).squaredNorm() <= most;
      });
  }

  /// Beyond tips the sides of a horizon differ by their errors: the strips of the fault between them are closed like zips.
  void CloseGaps()
  {
    std::vector<SealId> strips;
    for (std::size_t n = 0; n < this->Complex.Triangles.size(); ++n)
    {
      if (this->Complex.Triangles[n].IsBeyondTips)
      {
        strips.push_back(SealId(n));
      }
    }
    for (bool isNew = !strips.empty(); isNew;)
    {
      isNew = false;
      for (const SealId triangle : strips)
      {
        isNew = (this->Triangle(triangle).Sheet >= 0 && this->CloseAt(triangle)) || isNew;
      }
    }
  }

  /// Joins ends of the shortest edge possible.
  bool CloseAt(SealId triangle)
  {
    const SheetCorners t = this->Triangle(triangle).Corners;
    std::array<std::array<SealId, 2>, 3> edges = { { { t[0], t[1] }, { t[1], t[2] }, { t[2], t[0] } } };
    const auto length = [&](const std::array<SealId, 2>& edge)
    { return (this->At(edge[1]) - this->At(edge[0])).squaredNorm(); };
    std::sort(edges.begin(), edges.end(),
      [&](const std::array<SealId, 2>& a, const std::array<SealId, 2>& b) { return length(a) < length(b); });
    const double area = (this->At(t[1]) - this->At(t[0])).cross(this->At(t[2]) - this->At(t[0])).norm();
    if (area > MostGap * this->Options.LineError * std::sqrt(length(edges[2])))
    {
      return false;
    }
    this->IsClosing = true;
    const bool isDone = std::any_of(edges.begin(), edges.end(),
      [&](const std::array<SealId, 2>& edge)
      {
        const auto join = [&](SealId vertex, SealId target)
        {
          return this->IsOnWallsOf(vertex, target) && this->IsOnFaultsOf(vertex, target) &&
            this->Try(this->RemovalOf(vertex), target);
        };
        return join(edge[0], edge[1]) || join(edge[1], edge[0]);
      });
    this->IsClosing = false;
    return isDone;
  }

  /// A vertex that may go, with its neighbours, and the cosine of the smallest angle that may arise.
  struct Removal
  {
    SealId Vertex;
    std::vector<SealId> Neighbours;
    double LargestCosine;
  };
  Removal RemovalOf(SealId vertex) const
  {
    Removal removal = { vertex, this->NeighboursOf(vertex), this->IsClosing ? 1.0 : this->LargestCosine };
    for (const SealId triangle : this->Around[std::size_t(vertex)])
    {
      const double cosine = CosineOfSmallestAngle(this->CornersOf(this->Triangle(triangle).Corners));
      removal.LargestCosine = std::max(removal.LargestCosine, cosine);
    }
    return removal;
  }

  bool CanJoin(SealId vertex, SealId target, const std::vector<SealId>& neighbours) const
  {
    const std::vector<SealId> others = this->NeighboursOf(target);
    std::vector<SealId> common;
    std::set_intersection(
      neighbours.begin(), neighbours.end(), others.begin(), others.end(), std::back_inserter(common));
    for (const SealId triangle : this->Around[std::size_t(vertex)])
    {
      const SheetCorners& corners = this->Triangle(triangle).Corners;
      if (!Has(corners, target))
      {
        continue;
      }
      for (const SealId corner : corners)
      {
        if (corner == vertex || corner == target)
        {
          continue;
        }
        common.erase(std::remove(common.begin(), common.end(), corner), common.end());
        // The triangle becomes an edge, and two lines must not become one, but for those on both sides of a gap.
        const bool isGap = this->IsClosing && this->Triangle(triangle).IsBeyondTips;
        if (!isGap && IsLine(this->KindOf(vertex, corner)) && IsLine(this->KindOf(target, corner)))
        {
          return false;
        }
      }
    }
    return common.empty();
  }

  bool Try(const Removal& removal, SealId target, bool isInside = false)
  {
    std::vector<SealId> changed, gone;
    std::vector<SheetCorners> corners;
    for (const SealId triangle : this->Around[std::size_t(removal.Vertex)])
    {
      SheetCorners t = this->Triangle(triangle).Corners;
      if (Has(t, target))
      {
        gone.push_back(triangle);
        continue;
      }
      std::replace(t.begin(), t.end(), removal.Vertex, target);
      changed.push_back(triangle);
      corners.push_back(t);
    }
    if (!this->HaveAngles(changed, corners, removal.LargestCosine) ||
      !this->CanJoin(removal.Vertex, target, removal.Neighbours) || !this->AreWithin(changed, corners))
    {
      return false;
    }
    std::vector<SealId> all = changed;
    all.insert(all.end(), gone.begin(), gone.end());
    if (this->MeetOthers(changed, corners, all, isInside))
    {
      this->Attempts[std::size_t(removal.Vertex)].Time = 0; // The others may go.
      return false;
    }
    for (const SealId triangle : gone)
    {
      this->TakeOut(triangle);
      this->Complex.Triangles[std::size_t(triangle)].Sheet = -1;
    }
    this->Replace(changed, corners);
    return true;
  }

  void PutIn(SealId triangle)
  {
    const SheetCorners& corners = this->Triangle(triangle).Corners;
    this->Trees[std::size_t(this->Triangle(triangle).Sheet)].Add(triangle, this->BoxOf(corners));
    for (const SealId corner : corners)
    {
      this->Changed[std::size_t(corner)] = this->Time;
      this->Around[std::size_t(corner)].push_back(triangle);
    }
  }

  void TakeOut(SealId triangle)
  {
    const SheetCorners& corners = this->Triangle(triangle).Corners;
    this->Trees[std::size_t(this->Triangle(triangle).Sheet)].Remove(triangle, this->BoxOf(corners));
    for (const SealId corner : corners)
    {
      this->Changed[std::size_t(corner)] = this->Time;
      std::vector<SealId>& around = this->Around[std::size_t(corner)];
      around.erase(std::remove(around.begin(), around.end(), triangle), around.end());
    }
  }

  void Replace(const std::vector<SealId>& changed, const std::vector<SheetCorners>& corners)
  {
    for (std::size_t n = 0; n < changed.size(); ++n)
    {
      this->TakeOut(changed[n]);
      this->Complex.Triangles[std::size_t(changed[n])].Corners = corners[n];
      this->PutIn(changed[n]);
    }
  }

  bool HaveAngles(
    const std::vector<SealId>& changed, const std::vector<SheetCorners>& corners, double largestCosine) const
  {
    for (std::size_t n = 0; n < changed.size(); ++n)
    {
      const SheetShape& shape = this->Shapes[std::size_t(this->Triangle(changed[n]).Sheet)];
      const std::array<Eigen::Vector3d, 3> places = this->CornersOf(corners[n]);
      const Eigen::Vector3d normal = (places[1] - places[0]).cross(places[2] - places[0]);
      constexpr double least = 0.05; // no triangle is steeper on the plane of its sheet, as a cosine
      if (!(normal.dot(shape.Axes.row(2)) > least * normal.norm()) || !(CosineOfSmallestAngle(places) <= largestCosine))
      {
        return false;
      }
    }
    return true;
  }

  bool AreWithin(const std::vector<SealId>& changed, const std::vector<SheetCorners>& corners) const
  {
    bool areWithin = true;
    for (std::size_t n = 0; n < changed.size() && areWithin; ++n)
    {
      const SheetShape& shape = this->Shapes[std::size_t(this->Triangle(changed[n]).Sheet)];
      const double most = this->PartOfHeights() * shape.Error;
      ForEachHeight(shape.Heights, this->CornersOf(corners[n]),
        [&areWithin, most](double above)
        {
          areWithin = std::abs(above) <= most;
          return areWithin;
        });
    }
    return areWithin;
  }

  /// Whether triangles with these corners would meet each other or others, while `gone`, which include them, go. Those inside
  /// a sheet fill the same place on its plane.
  bool MeetOthers(const std::vector<SealId>& changed, const std::vector<SheetCorners>& corners,
    const std::vector<SealId>& gone, bool isInside) const
  {
    if (isInside && this->Shapes[std::size_t(this->Triangle(changed.front()).Sheet)].IsLevel())
    {
      return false;
    }
    for (std::size_t n = 0; n < changed.size(); ++n)
    {
      const auto own = std::size_t(this->Triangle(changed[n]).Sheet);
      const Eigen::AlignedBox3d box = this->BoxOf(corners[n]);
      const auto isGone = [&](SealId triangle) { return std::find(gone.begin(), gone.end(), triangle) != gone.end(); };
      const auto meets = [&](SealId other)
      { return !isGone(other) && this->Meet(changed[n], corners[n], other, this->Triangle(other).Corners); };
      for (std::size_t sheet = 0; sheet < this->Trees.size(); ++sheet)
      {
        if (!(isInside && sheet == own) && this->Trees[sheet].Any(box, meets))
        {
          return true;
        }
      }
      for (std::size_t other = 0; other < n && !isInside; ++other)
      {
        if (this->Meet(changed[n], corners[n], changed[other], corners[other]))
        {
          return true;
        }
      }
    }
    return false;
  }

  /// Whether two triangles may meet elsewhere than at common corners.
  bool Meet(SealId first, const SheetCorners& a, SealId second, const SheetCorners& b) const
  {
    std::array<SealId, 3> common = { -1, -1, -1 };
    std::size_t count = 0;
    for (const SealId corner : a)
    {
      if (Has(b, corner))
      {
        common[count++] = corner;
      }
    }
    if (count == 3)
    {
      return true;
    }
    if (count == 2)
    {
      return this->IsFlatAgainst(a, b, common[0], common[1]);
    }
    if (this->Triangle(first).Sheet == this->Triangle(second).Sheet)
    {
      return this->OverlapOnPlane(this->Shapes[std::size_t(this->Triangle(first).Sheet)].Axes, a, b);
    }
    for (std::size_t n = 0; n < 3; ++n)
    {
      const std::array<SealId, 2> ofA = { a[n], a[(n + 1) % 3] }, ofB = { b[n], b[(n + 1) % 3] };
      if ((ofA[0] != common[0] && ofA[1] != common[0] && this->Pierces(ofA, b)) ||
        (ofB[0] != common[0] && ofB[1] != common[0] && this->Pierces(ofB, a)))
      {
        return true;
      }
    }
    return false;
  }

  /// Triangles of one sheet overlap if no edge of either parts them.
  bool OverlapOnPlane(const Eigen::Matrix3d& axes, const SheetCorners& a, const SheetCorners& b) const
  {
    std::array<std::array<Eigen::Vector2d, 3>, 2> places;
    for (std::size_t n = 0; n < 3; ++n)
    {
      places[0][n] = (axes * this->At(a[n])).head<2>();
      places[1][n] = (axes * this->At(b[n])).head<2>();
    }
    for (std::size_t own = 0; own < 2; ++own)
    {
      for (std::size_t n = 0; n < 3; ++n)
      {
        const Eigen::Vector2d &from = places[own][n], way = places[own][(n + 1) % 3] - from;
        const auto isBeyond = [&](const Eigen::Vector2d& place)
        {
          const Eigen::Vector2d to = place - from;
          constexpr double rounding = 1e-12;
          return way.x() * to.y() - way.y() * to.x() <= rounding * way.norm() * to.norm();
        };
        if (std::all_of(places[1 - own].begin(), places[1 - own].end(), isBeyond))
        {
          return false;
        }
      }
    }
    return true;
  }

  bool IsFlatAgainst(const SheetCorners& a, const SheetCorners& b, SealId from, SealId to) const
  {
    const auto across = [&](const SheetCorners& t)
    {
      const SealId other =
        *std::find_if(t.begin(), t.end(), [&](SealId corner) { return corner != from && corner != to; });
      const Eigen::Vector3d axis = (this->At(to) - this->At(from)).normalized(), way = this->At(other) - this->At(from);
      return Eigen::Vector3d((way - way.dot(axis) * axis).normalized());
    };
    constexpr double most = 0.998; // the cosine of about 4 degrees
    return across(a).dot(across(b)) > most;
  }

  bool Pierces(const std::array<SealId, 2>& edge, const SheetCorners& t) const
  {
    const Eigen::Vector3d &p = this->At(edge[0]), &q = this->At(edge[1]);
    const Eigen::Vector3d &a = this->At(t[0]), &b = this->At(t[1]), &c = this->At(t[2]);
    const double first = CertainVolume(a, b, c, p), second = CertainVolume(a, b, c, q);
    if (first * second > 0.0)
    {
      return false;
    }
    if (first == 0.0 || second == 0.0)
    {
      // What ends on a wall is on its plane.
      std::vector<Eigen::Vector3d> touching;
      touching.insert(touching.end(), first == 0.0 ? 1 : 0, p);
      touching.insert(touching.end(), second == 0.0 ? 1 : 0, q);
      return this->Touch(touching, { a, b, c });
    }
    const double ab = CertainVolume(p, q, a, b), bc = CertainVolume(p, q, b, c), ca = CertainVolume(p, q, c, a);
    return (ab >= 0.0 && bc >= 0.0 && ca >= 0.0) || (ab <= 0.0 && bc <= 0.0 && ca <= 0.0);
  }

  /// Whether a point or segment on the plane of a triangle is inside, at least in part.
  bool Touch(const std::vector<Eigen::Vector3d>& touching, const std::array<Eigen::Vector3d, 3>& t) const
  {
    const Eigen::Vector3d normal = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
    const auto isBeyond = [&normal](const Eigen::Vector3d& from, const Eigen::Vector3d& to, double side)
    {
      return [=](const Eigen::Vector3d& place)
      {
        constexpr double rounding = 1e-12;
        const Eigen::Vector3d way = to - from, across = place - from;
        return side * normal.dot(way.cross(across)) <= rounding * way.norm() * across.norm();
      };
    };
    for (std::size_t n = 0; n < 3; ++n)
    {
      if (std::all_of(touching.begin(), touching.end(), isBeyond(t[n], t[(n + 1) % 3], 1.0)))
      {
        return false;
      }
    }
    return touching.size() < 2 ||
      (!std::all_of(t.begin(), t.end(), isBeyond(touching[0], touching[1], 1.0)) &&
        !std::all_of(t.begin(), t.end(), isBeyond(touching[0], touching[1], -1.0)));
  }

  void FlipEdges()
  {
    for (std::size_t n = 0; n < this->Complex.Triangles.size(); ++n)
    {
      for (std::size_t corner = 0; corner < 3 && this->Complex.Triangles[n].Sheet >= 0; ++corner)
      {
        this->Flip(SealId(n), corner);
      }
    }
  }

  bool Flip(SealId triangle, std::size_t corner)
  {
    const SheetCorners& t = this->Triangle(triangle).Corners;
    const SealId a = t[corner], b = t[(corner + 1) % 3], c = t[(corner + 2) % 3];
    SealId other = -1;
    if (IsLine(this->KindOf(a, b)))
    {
      return false;
    }
    for (const SealId beside : this->Around[std::size_t(a)])
    {
      other = beside != triangle && Has(this->Triangle(beside).Corners, b) ? beside : other;
    }
    const SheetCorners& s = this->Triangle(other).Corners;
    const SealId d = *std::find_if(s.begin(), s.end(), [&](SealId vertex) { return vertex != a && vertex != b; });
    const std::vector<SealId>& around = this->Around[std::size_t(c)];
    if (std::any_of(
          around.begin(), around.end(), [&](SealId beside) { return Has(this->Triangle(beside).Corners, d); }))
    {
      return false;
    }
    const double before =
      std::max(CosineOfSmallestAngle(this->CornersOf(t)), CosineOfSmallestAngle(this->CornersOf(s)));
    constexpr double least = 1e-3;
    const std::vector<SheetCorners> corners = { { a, d, c }, { d, b, c } };
    const std::vector<SealId> both = { triangle, other };
    if (!this->HaveAngles(both, corners, before - least) || !this->AreWithin(both, corners) ||
      this->MeetOthers(both, corners, both, true))
    {
      return false;
    }
    this->Replace({ triangle, other }, corners);
    return true;
  }

  SealedComplex Complex; // Triangles that are gone have no sheet.
  const std::vector<SheetShape>& Shapes;
  const ImproverOptions& Options;
  double LargestCosine;
  double Part = 1.0; // of errors
  bool IsClosing = false;
  std::vector<std::vector<SealId>> Around;
  std::size_t Time = 1; // counts attempts
  std::vector<std::size_t> Changed; // by vertex, when a triangle around it did
  std::vector<Attempt> Attempts; // by vertex, the last ones
  std::vector<BoxTree> Trees; // by sheet
  std::unordered_map<EdgeKey, GonePlaces> Gone; // by edge of a line, places it had
};
}

//----------------------------------------------------------------------------------------------------------------------
SealedComplex Improve(
  SealedComplex complex, const std::vector<SheetShape>& shapes, const ImproverOptions& options, const Monitor& monitor)
{
  Improver improver(std::move(complex), shapes, options);
  improver.Run(monitor);
  return improver.Take();
}

//----------------------------------------------------------------------------------------------------------------------
double MeasureLargestError(const SealedComplex& complex, const std::vector<SheetShape>& shapes)
{
  double error = 0.0;
  for (const LabelledTriangle& triangle : complex.Triangles)
  {
    std::array<Eigen::Vector3d, 3> corners;
    for (std::size_t n = 0; n < 3; ++n)
    {
      corners[n] = complex.Vertices[std::size_t(triangle.Corners[n])];
    }
    ForEachHeight(shapes[std::size_t(triangle.Sheet)].Heights, corners,
      [&error](double above)
      {
        error = std::max(error, std::abs(above));
        return true;
      });
  }
  return error;
}
}
