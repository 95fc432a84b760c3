// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Boundary points are numbered, the new points of each cell are counted, and all cells write their points in parallel
// to known positions.
//
// The barycentre represents the inner points of a leaf if it is requested, lies strictly inside the boundary, and
// shares its place with no other. Otherwise the inner point nearest to it in plan does, which is always strictly inside
// and alone in its place.

#include "CellLeaves.h"

#include "Common/Base/FixedChunks.h"
#include "Common/Base/Parallel.h"
#include "Common/Horizon/PlaneGeometry.h"
#include "Common/Horizon/Predicates.h"

#include <algorithm>
#include <cassert>
#include <cstring>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
namespace
{
//----------------------------------------------------------------------------------------------------------------------

class NearestPoint
{
public:
  /// `points` are reordered into the tree.
  NearestPoint(const SubVoxelPlaces& plane, std::vector<PointId>& points)
    : Plane(plane)
    , Points(points)
  {
    if (points.size() > Few)
    {
      this->Divide({ 0, 0, points.size() });
    }
  }

  /// The least number wins among equally near points. Time is logarithmic, unless very many points are about equally
  /// near.
  PointId Find(const PlanePoint& place) const
  {
    Best best{ NoPoint, std::numeric_limits<std::int64_t>::max() };
    this->Search({ 0, 0, this->Points.size() }, place, best);
    return best.Point;
  }

private:
  struct Range
  {
    std::size_t Node;
    std::size_t First;
    std::size_t Last;

    bool IsLeaf() const { return this->Last - this->First <= Few; }
    std::size_t Middle() const { return this->First + (this->Last - this->First) / 2; }
    Range Low() const { return { 2 * this->Node + 1, this->First, this->Middle() }; }
    Range High() const { return { 2 * this->Node + 2, this->Middle(), this->Last }; }
  };

  struct Best
  {
    PointId Point;
    std::int64_t SquaredDistance;
  };

  void Divide(const Range& range)
  {
    PlaneBox box;
    const auto at = [this](std::size_t n) { return this->Points.begin() + std::ptrdiff_t(n); };
    std::for_each(at(range.First), at(range.Last), [&](PointId point) { box.Add(this->Plane[point]); });
    this->Boxes.resize(std::max(this->Boxes.size(), range.Node + 1));
    this->Boxes[range.Node] = box;
    if (range.IsLeaf())
    {
      return;
    }
    const bool isWide = std::int64_t(box.Greatest.X) - box.Least.X >= std::int64_t(box.Greatest.Y) - box.Least.Y;
    const auto axis = isWide ? &PlanePoint::X : &PlanePoint::Y;
    std::nth_element(at(range.First), at(range.Middle()), at(range.Last),
      [&](PointId a, PointId b) { return this->Plane[a].*axis < this->Plane[b].*axis; });
    this->Divide(range.Low());
    this->Divide(range.High());
  }

  void Search(const Range& range, const PlanePoint& place, Best& best) const
  {
    if (range.IsLeaf())
    {
      for (std::size_t n = range.First; n < range.Last; ++n)
      {
        const PointId point = this->Points[n];
        const std::int64_t distance = SquaredDistance(this->Plane[point], place);
        if (std::tie(distance, point) < std::tie(best.SquaredDistance, best.Point))
        {
          best = { point, distance };
        }
      }
      return;
    }
    Range nearer = range.Low();
    Range farther = range.High();
    std::int64_t near = this->SquaredDistanceToBox(nearer, place);
    std::int64_t far = this->SquaredDistanceToBox(farther, place);
    if (far < near)
    {
      std::swap(nearer, farther);
      std::swap(near, far);
    }
    // Equality is included, as an equally near point may have a lower number.
    if (near <= best.SquaredDistance)
    {
      this->Search(nearer, place, best);
    }
    if (far <= best.SquaredDistance)
    {
      this->Search(farther, place, best);
    }
  }

  std::int64_t SquaredDistanceToBox(const Range& range, const PlanePoint& place) const
  {
    const PlaneBox& box = this->Boxes[range.Node];
    return SquaredDistance(
      place, { std::clamp(place.X, box.Least.X, box.Greatest.X), std::clamp(place.Y, box.Least.Y, box.Greatest.Y) });
  }

  static constexpr std::size_t Few = 8;

  const SubVoxelPlaces Plane;
  std::vector<PointId>& Points;
  std::vector<PlaneBox> Boxes;
};

//----------------------------------------------------------------------------------------------------------------------
// Writing

struct CellRepresentative
{
  const PointId* First = nullptr;
  const PointId* Last = nullptr;
  PlanePoint Plane; // sub-voxels
  double Height = 0.0; // lattice units
  PointId Nearest = NoPoint;
  bool Averaged = false; // else Nearest
};

std::int32_t RoundedQuotient(std::int64_t sum, std::int64_t count)
{
  const std::int64_t numerator = 2 * sum + count;
  const std::int64_t quotient = numerator / (2 * count);
  return std::int32_t(numerator % (2 * count) < 0 ? quotient - 1 : quotient);
}

/// The segment must not end on the edge. An end of the edge on the segment counts as left of it, so that a loop that
/// touches the segment is crossed twice or never, and a loop that passes through it once.
bool Crosses(const PlanePoint& a, const PlanePoint& b, const PlanePoint& from, const PlanePoint& to)
{
  return (SignedArea(from, to, a) >= 0) != (SignedArea(from, to, b) >= 0) &&
    (SignedArea(a, b, from) > 0) != (SignedArea(a, b, to) > 0);
}

class LeafWriter
{
public:
  LeafWriter(const CellLeaves& leaves, RepresentativeKind representative)
    : Leaves(leaves)
    , Representative(representative)
    , Edges(leaves.NumberOfCells(), [this](auto&& add) { this->ForEachCrossing(add); })
  {
  }

  Reduction Run(const Monitor& monitor)
  {
    this->NumberBoundaryPoints();
    const std::vector<std::uint32_t> next = this->CountNewPoints(monitor.Step(0.0, 0.2));
    const std::size_t size = next.back();
    this->Result.Source.resize(size);
    this->Result.Averaged.assign(size, 0);
    this->Result.Plane.resize(size);
    this->Result.Height.resize(size);
    this->Result.Origin.resize(size);
    ParallelFor(this->Leaves.NumberOfCells(), CellLeaves::Grain, monitor.Step(0.2, 1.0),
      [&](std::int64_t first, std::int64_t last)
      {
        Scratch scratch;
        for (std::int64_t cell = first; cell < last; ++cell)
        {
          this->WriteCell(cell, PointId(next[cell]), scratch);
        }
      });
    return std::move(this->Result);
  }

private:
  struct Scratch
  {
    std::vector<PointId> Kept;
    std::vector<CellRepresentative> Found;
    std::vector<PlanePoint> Places;
  };

  template <typename Add>
  void ForEachCrossing(Add& add) const
  {
    const SubVoxelPlaces& plane = this->Leaves.Places();
    this->Leaves.Horizon().Boundary.ForEachEdge(
      [&](PointId from, PointId to)
      {
        this->Leaves.Grid().ForEachCellAlong(plane[from], plane[to],
          [&](std::int64_t square)
          {
            const std::int64_t cell = this->Leaves.FirstCellFrom(square);
            if (cell < this->Leaves.NumberOfCells() && this->Leaves.Square(cell) == square)
            {
              add(cell, Edge{ from, to });
            }
          });
      });
  }

  void NumberBoundaryPoints()
  {
    const std::vector<unsigned char>& flags = this->Leaves.BoundaryFlags();
    this->Result.Target = FilledVector(flags.size(), NoPoint);
    // Few points are on the boundary, and memchr finds them many times faster than a loop over all flags.
    const unsigned char* const begin = flags.data();
    const unsigned char* const end = begin + flags.size();
    const auto find = [end](const unsigned char* from)
    { return static_cast<const unsigned char*>(std::memchr(from, 1, std::size_t(end - from))); };
    for (const unsigned char* found = find(begin); found; found = found + 1 < end ? find(found + 1) : nullptr)
    {
      this->Result.Target[found - begin] = PointId(this->Result.Source.size());
      this->Result.Source.push_back(PointId(found - begin));
    }
    this->Result.Boundary = this->Leaves.Horizon().Boundary.Renumbered(this->Result.Target);
  }

  std::vector<std::uint32_t> CountNewPoints(const Monitor& monitor) const
  {
    std::vector<std::uint32_t> next(this->Leaves.NumberOfCells() + 1, 0);
    ParallelFor(this->Leaves.NumberOfCells(), CellLeaves::Grain, monitor,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t cell = first; cell < last; ++cell)
        {
          next[cell + 1] = this->Leaves.CountMerging(cell);
        }
      });
    next.front() = std::uint32_t(this->Result.Source.size());
    std::partial_sum(next.begin(), next.end(), next.begin());
    return next;
  }

  void WriteCell(std::int64_t cell, PointId next, Scratch& scratch)
  {
    scratch.Found.clear();
    this->Leaves.ForEachLeaf(cell,
      [&](const PointId* first, const PointId* last)
      {
        if (this->Leaves.HasBoundary(first))
        {
          this->WriteBoundaryPoints(first, last, scratch.Kept);
        }
        if (this->Leaves.MergesInner(first))
        {
          scratch.Found.push_back(this->FindRepresentative(cell, first, last));
        }
        else if (std::ptrdiff_t(scratch.Kept.size()) < last - first)
        {
          this->MergeIntoBoundary(first, last, scratch.Kept);
        }
      });
    this->SeparatePlaces(scratch.Found, scratch.Places);
    for (const CellRepresentative& representative : scratch.Found)
    {
      this->WriteNewPoint(representative, next);
      ++next;
    }
  }

  void WriteBoundaryPoints(const PointId* first, const PointId* last, std::vector<PointId>& kept)
  {
    kept.clear();
    for (const PointId* point = first; point != last; ++point)
    {
      if (this->Leaves.IsOnBoundary(*point))
      {
        const std::size_t number = std::size_t(this->Result.Target[*point]);
        this->Result.Plane[number] = this->Leaves.Plane(*point);
        this->Result.Height[number] = this->Leaves.Height(*point);
        this->Result.Origin[number].Level = static_cast<unsigned char>(this->Leaves.Level(first));
        kept.push_back(*point);
      }
    }
  }

  void MergeIntoBoundary(const PointId* first, const PointId* last, std::vector<PointId>& kept)
  {
    const NearestPoint nearestKept(this->Leaves.Places(), kept);
    for (const PointId* point = first; point != last; ++point)
    {
      if (!this->Leaves.IsOnBoundary(*point))
      {
        const PointId nearest = nearestKept.Find(this->Leaves.Plane(*point));
        this->Result.Target[*point] = this->Result.Target[nearest];
      }
    }
  }

  CellRepresentative FindRepresentative(std::int64_t cell, const PointId* first, const PointId* last) const
  {
    CellRepresentative representative = this->FindBarycentre(first, last);
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    std::int64_t count = 0;
    for (const PointId* point = first; point != last; ++point)
    {
      if (this->Leaves.IsOnBoundary(*point))
      {
        continue;
      }
      ++count;
      const std::int64_t distance = SquaredDistance(this->Leaves.Plane(*point), representative.Plane);
      if (distance < least)
      {
        least = distance;
        representative.Nearest = *point;
      }
    }
    representative.Averaged = count > 1 && this->Representative == RepresentativeKind::Barycentre &&
      this->IsInside(cell, representative.Plane, representative.Nearest);
    if (!representative.Averaged)
    {
      this->UseNearest(representative);
    }
    return representative;
  }

  CellRepresentative FindBarycentre(const PointId* first, const PointId* last) const
  {
    std::int64_t count = 0;
    std::int64_t x = 0;
    std::int64_t y = 0;
    double z = 0.0;
    for (const PointId* point = first; point != last; ++point)
    {
      if (!this->Leaves.IsOnBoundary(*point))
      {
        const std::int64_t weight = this->Leaves.Weight(*point);
        count += weight;
        x += weight * this->Leaves.Plane(*point).X;
        y += weight * this->Leaves.Plane(*point).Y;
        z += double(weight) * this->Leaves.Height(*point);
      }
    }
    CellRepresentative representative;
    representative.First = first;
    representative.Last = last;
    representative.Plane = { RoundedQuotient(x, count), RoundedQuotient(y, count) };
    representative.Height = z / double(count);
    return representative;
  }

  /// `place` must be in the convex hull of a cell and patch. The segment from `inner` must cross the boundary of the
  /// patch an even number of times; with cuts never, as it may cross both cutoffs of a crack.
  bool IsInside(std::int64_t cell, const PlanePoint& place, PointId inner) const
  {
    const PlanePoint from = this->Leaves.Plane(inner);
    bool inside = true;
    for (const Edge* edge = this->Edges.begin(cell); edge != this->Edges.end(cell); ++edge)
    {
      if (this->Leaves.Patch(edge->From) != this->Leaves.Patch(inner))
      {
        continue;
      }
      const PlanePoint a = this->Leaves.Plane(edge->From);
      const PlanePoint b = this->Leaves.Plane(edge->To);
      if (place == a || place == b || OnOpenSegment(a, b, place))
      {
        return false;
      }
      const bool crosses = Crosses(a, b, from, place);
      if (crosses && this->Leaves.HasCuts())
      {
        return false;
      }
      inside = inside != crosses;
    }
    return inside;
  }

  /// Barycentres of stacked leaves that share a place are replaced by nearest points. These may coincide with other
  /// barycentres, hence the iteration.
  void SeparatePlaces(std::vector<CellRepresentative>& representatives, std::vector<PlanePoint>& places) const
  {
    bool changed = representatives.size() > 1;
    while (changed)
    {
      changed = false;
      places.clear();
      for (const CellRepresentative& representative : representatives)
      {
        places.push_back(representative.Plane);
      }
      std::sort(places.begin(), places.end());
      for (CellRepresentative& representative : representatives)
      {
        const auto same = std::equal_range(places.begin(), places.end(), representative.Plane);
        if (representative.Averaged && same.second - same.first > 1)
        {
          this->UseNearest(representative);
          changed = true;
        }
      }
    }
  }

  void UseNearest(CellRepresentative& representative) const
  {
    representative.Averaged = false;
    representative.Plane = this->Leaves.Plane(representative.Nearest);
    representative.Height = this->Leaves.Height(representative.Nearest);
  }

  void WriteNewPoint(const CellRepresentative& representative, PointId number)
  {
    const std::size_t target = std::size_t(number);
    this->Result.Source[target] = representative.Nearest;
    this->Result.Averaged[target] = representative.Averaged ? 1 : 0;
    this->Result.Plane[target] = representative.Plane;
    this->Result.Height[target] = representative.Height;
    this->Result.Origin[target].Level = static_cast<unsigned char>(this->Leaves.Level(representative.First));
    this->Result.Origin[target].Kind = representative.Averaged ? PointKind::Barycentre : PointKind::InputPoint;
    for (const PointId* point = representative.First; point != representative.Last; ++point)
    {
      if (!this->Leaves.IsOnBoundary(*point))
      {
        this->Result.Target[*point] = number;
      }
    }
  }

  const CellLeaves& Leaves;
  const RepresentativeKind Representative;
  const EdgeLists Edges;
  Reduction Result;
};

SimplificationCell DescribeCell(
  const CellLeaves& leaves, const Reduction& result, const PointId* first, const PointId* last)
{
  const PlanePoint place = leaves.Plane(*first);
  const PlanePoint corner = leaves.Grid().Corner(leaves.Grid().CellOf(place));
  std::int64_t x = corner.X;
  std::int64_t y = corner.Y;
  std::int64_t size = leaves.CellSize();
  for (int level = 0; level < leaves.Level(first); ++level)
  {
    size /= 2;
    x += place.X - x >= size ? size : 0;
    y += place.Y - y >= size ? size : 0;
  }
  const double scale = 1.0 / leaves.Horizon().SubVoxelsPerColumn;
  SimplificationCell cell;
  cell.Low = { double(x) * scale, double(y) * scale, 0.0 };
  cell.Size = double(size) * scale;
  cell.Origin = result.Origin[result.Target[std::size_t(*first)]];
  cell.Origin.Kind = leaves.HasBoundary(first) ? PointKind::Boundary : cell.Origin.Kind;
  cell.Flatness = result.Flatness.empty() ? 0.0 : result.Flatness[result.Target[std::size_t(*first)]];
  cell.Patch = leaves.Patch(*first);
  cell.Points = std::int32_t(last - first);
  return cell;
}
}

//----------------------------------------------------------------------------------------------------------------------
Reduction WriteLeaves(const CellLeaves& leaves, RepresentativeKind representative, const Monitor& monitor)
{
  Reduction result = LeafWriter(leaves, representative).Run(monitor);
  result.SubVoxelsPerColumn = leaves.Horizon().SubVoxelsPerColumn;
  return result;
}

//----------------------------------------------------------------------------------------------------------------------
void ListCells(const CellLeaves& leaves, Reduction& result, const CellBottom& bottom)
{
  leaves.ForEachLeaf(
    [&](const PointId* first, const PointId* last)
    {
      SimplificationCell cell = DescribeCell(leaves, result, first, last);
      cell.Low.Z = bottom(first, last, leaves.Level(first));
      result.Cells.push_back(cell);
    });
}
}
