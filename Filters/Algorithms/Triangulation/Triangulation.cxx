// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// 1. Full blocks. An edge between neighbouring columns is in every constrained Delaunay triangulation, as its circle
// holds no other column. A block of two by two points thus becomes two triangles, and a ring, three by three points
// around a single missing one, six. InCircle (Predicates.h) chooses diagonals. Boundary edges may not cut blocks.
//
//     *---*        *---*---*
//     | / |        |  / \  |
//     *---*        | / : \ |
//                  *   :   *
//     a block      | \ : / |      a ring
//                  |  \ /  |
//                  *---*---*
//
// 2. Patches: loose points, which blocks and rings do not surround, boundary edges, and outer edges of blocks.
// 3. Fronts mesh each patch (PatchFront.h), from its boundary inwards and from its blocks outwards.
// 4. Boundary edges that are not Delaunay among all points of a patch are counted.
//
// Triangles of full blocks come first, row by row.

#include "Triangulation.h"

#include "Common/Base/CountingSort.h"
#include "Common/Base/Errors.h"
#include "Common/Base/Parallel.h"
#include "Common/Horizon/CellGrid.h"
#include "Common/Horizon/MeshChecker.h"
#include "Common/Horizon/Predicates.h"
#include "PatchFront.h"
#include "SearchGrid.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <cmath>
#include <iterator>
#include <numeric>
#include <string>
#include <utility>

namespace SeismicHorizons
{
namespace
{
// ---- Full blocks ----------------------------------------------------------------------------------------------------

// With fewer points per column, visiting all columns costs more than full blocks save.
constexpr std::int64_t MostColumnsPerPoint = 8;

bool RunsBetweenBlocks(const PlanePoint& a, const PlanePoint& b)
{
  return std::abs(a.X - b.X) + std::abs(a.Y - b.Y) == 1;
}

template <std::size_t Size>
bool AreInOnePatch(const std::array<PointId, Size>& points, const std::int32_t* patches)
{
  return std::all_of(
    points.begin(), points.end(), [&](PointId point) { return patches[point] == patches[points.front()]; });
}

PointId* Write(PointId a, PointId b, PointId c, PointId* corners)
{
  corners[0] = a;
  corners[1] = b;
  corners[2] = c;
  return corners + 3;
}

PointId* WriteSquare(const std::array<PointId, 4>& corner, std::size_t first, PointId* corners)
{
  corners = Write(corner[first], corner[first + 1], corner[first + 2], corners);
  return Write(corner[first], corner[first + 2], corner[(first + 3) % 4], corners);
}

class FullBlocks
{
public:
  FullBlocks() = default;

  /// Finds no block if points are sparse in their bounding box, or if two points share a place.
  FullBlocks(const BoundedHorizon& horizon, const PlaneFrame& frame)
    : Frame(frame)
    , Width(std::int64_t(frame.Inward(frame.Greatest).X) + 1)
    , Height(std::int64_t(frame.Inward(frame.Greatest).Y) + 1)
    , BlockDiagonal(InCircle({ 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 }) < 0 ? 0 : 1)
    , RingDiagonal(InCircle({ 1, 0 }, { 2, 1 }, { 1, 2 }, { 0, 1 }) < 0 ? 0 : 1)
  {
    const std::int64_t most = MostColumnsPerPoint * std::int64_t(horizon.Plane.size());
    if (this->Width * this->Height > most || !this->PlacePoints(horizon.Plane))
    {
      *this = FullBlocks();
      return;
    }
    this->Blocks.assign(this->Points.size(), Nothing);
    this->MarkCutBlocks(horizon);
    this->MarkTurns(horizon);
    const bool isOnePatch = std::all_of(
      horizon.Patch.begin(), horizon.Patch.end(), [&](std::int32_t patch) { return patch == horizon.Patch.front(); });
    const std::int32_t* const patches = isOnePatch ? nullptr : horizon.Patch.data();
    std::vector<std::size_t> full(this->Height, 0);
    std::vector<std::size_t> rings(this->Height, 0);
    this->ForEachRow([&](std::int64_t y) { full[y] = this->FindFull(y, patches); });
    this->ForEachRow([&](std::int64_t y) { rings[y] = this->FindRings(y, patches); });
    this->RowStarts.push_back(0);
    for (std::size_t y = 0; y + 1 < full.size(); ++y)
    {
      // FindRings counts a ring in the row of its middle, one above its least corner.
      this->RowStarts.push_back(this->RowStarts.back() + 2 * full[y] + 6 * rings[y + 1]);
    }
  }

  std::size_t NumberOfTriangles() const { return this->RowStarts.empty() ? 0 : this->RowStarts.back(); }

  /// Loose points are not surrounded by blocks and rings, or are on the boundary.
  std::vector<PointId> FindLoosePoints(const BoundedHorizon& horizon) const
  {
    if (this->NumberOfTriangles() == 0)
    {
      std::vector<PointId> all(horizon.Plane.size());
      std::iota(all.begin(), all.end(), 0);
      return all;
    }
    std::vector<PointId> loose = this->FindUncovered();
    const std::vector<PointId> covered = this->FindCoveredBoundary(horizon);
    loose.insert(loose.end(), covered.begin(), covered.end());
    return loose;
  }

  void WriteTriangles(PointId* corners) const
  {
    if (this->NumberOfTriangles() > 0)
    {
      this->ForEachRow(
        [&](std::int64_t y)
        {
          [[maybe_unused]] const PointId* const end = this->WriteRow(y, corners + 3 * this->RowStarts[y]);
          assert(end == corners + 3 * this->RowStarts[y + 1]);
        });
    }
  }

  /// Calls visit(from, to) for outer edges of blocks and rings, with the block to the left. They begin and end in loose
  /// points.
  template <typename Visitor>
  void ForEachEdge(const BoundedHorizon& horizon, const std::vector<PointId>& loose, Visitor&& visit) const
  {
    for (std::size_t n = 0; this->NumberOfTriangles() > 0 && n < loose.size(); ++n)
    {
      const PlanePoint column = this->Frame.Inward(horizon.Plane[loose[n]]);
      this->VisitEdges(column.X, column.Y, [&](PointId to) { visit(loose[n], to); });
    }
  }

private:
  enum Block : unsigned char
  {
    Nothing = 0,
    Turn = 1, // The boundary passes between this block and the one to its left.
    Cut = 2, // A boundary edge crosses the block.
    Open = 4, // inside and not cut
    Full = 8,
    Ring = 16, // a quarter of a ring
    Meshed = Full | Ring
  };

  template <typename Work>
  void ForEachRow(Work&& work) const
  {
    ParallelFor(this->Height - 1, std::max<std::int64_t>(1, Grain / this->Width),
      [&work](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t y = first; y < last; ++y)
        {
          work(y);
        }
      });
  }

  bool PlacePoints(const std::vector<PlanePoint>& points)
  {
    this->Points.resize(this->Width * this->Height);
    ParallelFor(this->Width * this->Height, Grain,
      [this](std::int64_t first, std::int64_t last)
      { std::fill(this->Points.begin() + first, this->Points.begin() + last, NoPoint); });
    for (std::size_t point = 0; point < points.size(); ++point)
    {
      const PlanePoint column = this->Frame.Inward(points[point]);
      PointId& place = this->Points[this->Place(column.X, column.Y)];
      if (place != NoPoint)
      {
        return false;
      }
      place = PointId(point);
    }
    return true;
  }

  void MarkCutBlocks(const BoundedHorizon& horizon)
  {
    const CellGrid blocks({ { 0, 0 }, this->Frame.Inward(this->Frame.Greatest) }, 1, 1);
    horizon.Boundary.ForEachEdge(
      [&](PointId from, PointId to)
      {
        const PlanePoint a = this->Frame.Inward(horizon.Plane[from]);
        const PlanePoint b = this->Frame.Inward(horizon.Plane[to]);
        if (!RunsBetweenBlocks(a, b))
        {
          blocks.ForEachCellAlong(a, b, [this](std::int64_t block) { this->Blocks[block] |= Cut; });
        }
      });
  }

  /// An edge that crosses the line through the middles of a row of blocks toggles the inside for blocks with middles
  /// further to the right. An edge through a middle cuts that block anyway.
  void MarkTurns(const BoundedHorizon& horizon)
  {
    horizon.Boundary.ForEachEdge(
      [&](PointId from, PointId to)
      {
        const PlanePoint a = this->Frame.Inward(horizon.Plane[from]);
        const PlanePoint b = this->Frame.Inward(horizon.Plane[to]);
        for (std::int32_t y = std::min(a.Y, b.Y); y < std::max(a.Y, b.Y); ++y)
        {
          const double x = a.X + (double(b.X) - a.X) * (y + 0.5 - a.Y) / (double(b.Y) - a.Y);
          this->Blocks[this->Place(std::int64_t(std::floor(x + 0.5)), y)] ^= Turn;
        }
      });
  }

  /// Blocks with points of several patches, which are invalid, are left to the search, which reports the error.
  std::size_t FindFull(std::int64_t y, const std::int32_t* patches)
  {
    const PointId* const below = this->Points.data() + this->Place(0, y);
    const PointId* const above = below + this->Width;
    unsigned char* const blocks = this->Blocks.data() + this->Place(0, y);
    unsigned char inside = Nothing;
    std::size_t count = 0;
    for (std::int64_t x = 0; x + 1 < this->Width; ++x)
    {
      inside ^= blocks[x] & Turn;
      const bool open = inside != Nothing && (blocks[x] & Cut) == 0;
      // NoPoint is the only negative number, so that the sign of the combination shows a missing point.
      const bool full = open && (below[x] | below[x + 1] | above[x] | above[x + 1]) >= 0 &&
        (!patches || AreInOnePatch(std::array<PointId, 4>{ below[x], below[x + 1], above[x], above[x + 1] }, patches));
      blocks[x] = (open ? Open : Nothing) | (full ? Full : Nothing);
      count += full ? 1 : 0;
    }
    return count;
  }

  /// A block is in one ring at most, as it has one empty corner. Threads thus do not write to or read the same block.
  std::size_t FindRings(std::int64_t y, const std::int32_t* patches)
  {
    std::size_t count = 0;
    for (std::int64_t x = 1; y > 0 && x + 1 < this->Width; ++x)
    {
      if (this->At(x, y) == NoPoint && (this->At(x - 1, y) | this->At(x + 1, y)) >= 0 && this->IsRing(x, y, patches))
      {
        for (const std::int64_t row : { y - 1, y })
        {
          this->Blocks[this->Place(x - 1, row)] |= Ring;
          this->Blocks[this->Place(x, row)] |= Ring;
        }
        ++count;
      }
    }
    return count;
  }

  bool IsRing(std::int64_t x, std::int64_t y, const std::int32_t* patches) const
  {
    const std::array<PointId, 8> around = { this->At(x - 1, y - 1), this->At(x, y - 1), this->At(x + 1, y - 1),
      this->At(x - 1, y), this->At(x + 1, y), this->At(x - 1, y + 1), this->At(x, y + 1), this->At(x + 1, y + 1) };
    PointId all = 0;
    for (const PointId point : around)
    {
      all |= point;
    }
    return all >= 0 &&
      (this->Blocks[this->Place(x - 1, y - 1)] & this->Blocks[this->Place(x, y - 1)] &
        this->Blocks[this->Place(x - 1, y)] & this->Blocks[this->Place(x, y)] & Open) != 0 &&
      (!patches || AreInOnePatch(around, patches));
  }

  std::vector<PointId> FindUncovered() const
  {
    std::vector<PointId> uncovered;
    for (std::int64_t y = 0; y < this->Height; ++y)
    {
      bool left = false;
      for (std::int64_t x = 0; x < this->Width; ++x)
      {
        const bool right = this->IsMeshed(x, y) && this->IsMeshed(x, y - 1);
        if (!(left && right) && this->At(x, y) != NoPoint)
        {
          uncovered.push_back(this->At(x, y));
        }
        left = right;
      }
    }
    return uncovered;
  }

  std::vector<PointId> FindCoveredBoundary(const BoundedHorizon& horizon) const
  {
    std::vector<PointId> covered;
    horizon.Boundary.ForEachPoint(
      [&](PointId point)
      {
        const PlanePoint column = this->Frame.Inward(horizon.Plane[point]);
        if (this->Covers(column.X, column.Y))
        {
          covered.push_back(point);
        }
      });
    std::sort(covered.begin(), covered.end());
    covered.erase(std::unique(covered.begin(), covered.end()), covered.end());
    return covered;
  }

  PointId* WriteRow(std::int64_t y, PointId* corners) const
  {
    for (std::int64_t x = 0; x + 1 < this->Width; ++x)
    {
      const unsigned char block = this->Blocks[this->Place(x, y)];
      if ((block & Full) != 0)
      {
        corners = this->WriteBlock(x, y, corners);
      }
      else if ((block & Ring) != 0 && this->BeginsRing(x, y))
      {
        corners = this->WriteRing(x, y, corners);
      }
    }
    return corners;
  }

  PointId* WriteBlock(std::int64_t x, std::int64_t y, PointId* corners) const
  {
    const std::array<PointId, 4> corner = { this->At(x, y), this->At(x + 1, y), this->At(x + 1, y + 1),
      this->At(x, y + 1) };
    return WriteSquare(corner, this->BlockDiagonal, corners);
  }

  PointId* WriteRing(std::int64_t x, std::int64_t y, PointId* corners) const
  {
    const std::array<PointId, 4> corner = { this->At(x, y), this->At(x + 2, y), this->At(x + 2, y + 2),
      this->At(x, y + 2) };
    const std::array<PointId, 4> middle = { this->At(x + 1, y), this->At(x + 2, y + 1), this->At(x + 1, y + 2),
      this->At(x, y + 1) };
    for (std::size_t n = 0; n < 4; ++n)
    {
      corners = Write(corner[n], middle[n], middle[(n + 3) % 4], corners);
    }
    return WriteSquare(middle, this->RingDiagonal, corners);
  }

  template <typename Visitor>
  void VisitEdges(std::int64_t x, std::int64_t y, Visitor&& visit) const
  {
    const bool right = this->IsMeshed(x, y);
    const bool left = this->IsMeshed(x - 1, y);
    const bool leftBelow = this->IsMeshed(x - 1, y - 1);
    const bool rightBelow = this->IsMeshed(x, y - 1);
    if (right && !rightBelow)
    {
      visit(this->At(x + 1, y));
    }
    if (left && !right)
    {
      visit(this->At(x, y + 1));
    }
    if (leftBelow && !left)
    {
      visit(this->At(x - 1, y));
    }
    if (rightBelow && !leftBelow)
    {
      visit(this->At(x, y - 1));
    }
  }

  bool Covers(std::int64_t x, std::int64_t y) const
  {
    return this->IsMeshed(x, y) && this->IsMeshed(x - 1, y) && this->IsMeshed(x - 1, y - 1) && this->IsMeshed(x, y - 1);
  }

  std::int64_t Place(std::int64_t x, std::int64_t y) const { return y * this->Width + x; }
  PointId At(std::int64_t x, std::int64_t y) const { return this->Points[this->Place(x, y)]; }

  bool IsMeshed(std::int64_t x, std::int64_t y) const
  {
    return x >= 0 && y >= 0 && x + 1 < this->Width && y + 1 < this->Height &&
      (this->Blocks[this->Place(x, y)] & Meshed) != 0;
  }

  bool BeginsRing(std::int64_t x, std::int64_t y) const
  {
    return (this->Blocks[this->Place(x, y)] & Ring) != 0 && this->At(x + 1, y + 1) == NoPoint;
  }

  PlaneFrame Frame;
  std::int64_t Width = 0;
  std::int64_t Height = 0;
  RawVector<PointId> Points;
  std::vector<unsigned char> Blocks;
  std::vector<std::size_t> RowStarts; // triangles before each row
  // The diagonal connects the first and third corner (0), or the second and fourth (1).
  std::size_t BlockDiagonal = 0;
  std::size_t RingDiagonal = 0;
};

// ---- Patches --------------------------------------------------------------------------------------------------------

struct Patch
{
  std::vector<PointId> Points; // numbers in the horizon
  std::vector<PlanePoint> Places;
  PlaneFrame Frame;
  Loops Boundary;
  std::vector<Edge> BlockEdges; // with blocks to the left
};

class PatchList
{
public:
  /// Omits points that blocks cover. Throws InputError for invalid patch numbers.
  PatchList(const BoundedHorizon& horizon, const PlaneFrame& frame, const FullBlocks& blocks)
    : Horizon(horizon)
    , Frame(frame)
    , Patches(CountPatches(horizon.Patch))
    , Loose(blocks.FindLoosePoints(horizon))
    , Points(PointsByPatch(horizon, this->Loose, this->Patches))
    , LoopsOf(LoopsByPatch(horizon, this->Patches))
    , BlockEdges(EdgesByPatch(horizon, blocks, this->Loose, this->Patches))
    , LocalNumber(horizon.Patch.size())
  {
  }

  std::int64_t Size() const { return this->Patches; }

  std::size_t NumberOfPoints() const { return this->Loose.size(); }

  /// Throws InputError if a loop leaves the patch.
  Patch Get(std::int64_t number)
  {
    Patch patch;
    patch.Points.assign(this->Points.begin(number), this->Points.end(number));
    patch.Places.reserve(patch.Points.size());
    for (const PointId point : patch.Points)
    {
      this->LocalNumber[point] = PointId(patch.Places.size());
      patch.Places.push_back(this->Horizon.Plane[point]);
    }
    if (!patch.Places.empty())
    {
      patch.Frame = PlaneFrame(patch.Places);
      // The unit suits all points, as covered points may lie between the loose points.
      patch.Frame.Shift = this->Frame.Shift;
    }
    for (PlanePoint& place : patch.Places)
    {
      place = patch.Frame.Inward(place);
    }
    for (const std::size_t* loop = this->LoopsOf.begin(number); loop != this->LoopsOf.end(number); ++loop)
    {
      this->AddLoop(*loop, std::int32_t(number), patch);
    }
    for (const Edge* edge = this->BlockEdges.begin(number); edge != this->BlockEdges.end(number); ++edge)
    {
      patch.BlockEdges.push_back({ this->NumberInPatch(edge->From), this->NumberInPatch(edge->To) });
    }
    return patch;
  }

  /// Get() must have been called for the patch.
  PointId NumberInPatch(PointId point) const { return this->LocalNumber[point]; }

private:
  static std::int64_t CountPatches(const std::vector<std::int32_t>& patches)
  {
    const auto range = std::minmax_element(patches.begin(), patches.end());
    if (*range.first < 0 || std::size_t(*range.second) >= patches.size())
    {
      throw InputError("patch numbers from " + std::to_string(*range.first) + " to " + std::to_string(*range.second) +
        ", expected numbers from 0 that are less than the " + std::to_string(patches.size()) + " points");
    }
    return std::int64_t(*range.second) + 1;
  }

  static PointLists PointsByPatch(
    const BoundedHorizon& horizon, const std::vector<PointId>& points, std::int64_t patches)
  {
    return PointLists(patches,
      [&](auto&& add)
      {
        for (const PointId point : points)
        {
          add(horizon.Patch[point], point);
        }
      });
  }

  static EdgeLists EdgesByPatch(
    const BoundedHorizon& horizon, const FullBlocks& blocks, const std::vector<PointId>& loose, std::int64_t patches)
  {
    return EdgeLists(patches,
      [&](auto&& add) {
        blocks.ForEachEdge(horizon, loose,
          [&](PointId from, PointId to) {
            add(horizon.Patch[from], Edge{ from, to });
          });
      });
  }

  static ItemLists<std::size_t> LoopsByPatch(const BoundedHorizon& horizon, std::int64_t patches)
  {
    return ItemLists<std::size_t>(patches,
      [&](auto&& add)
      {
        for (std::size_t loop = 0; loop < horizon.Boundary.Size(); ++loop)
        {
          add(horizon.Patch[*horizon.Boundary.begin(loop)], loop);
        }
      });
  }

  void AddLoop(std::size_t loop, std::int32_t number, Patch& patch) const
  {
    const Loops& boundary = this->Horizon.Boundary;
    for (const PointId* point = boundary.begin(loop); point != boundary.end(loop); ++point)
    {
      const std::int32_t found = this->Horizon.Patch[*point];
      if (found != number)
      {
        throw InputError("boundary loop " + std::to_string(loop) + " runs from patch " + std::to_string(number) +
          " to patch " + std::to_string(found) + " at point " + std::to_string(*point) +
          ", expected loops that stay in one patch");
      }
      patch.Boundary.Append(this->NumberInPatch(*point));
    }
    patch.Boundary.Close();
  }

  const BoundedHorizon& Horizon;
  const PlaneFrame Frame;
  const std::int64_t Patches;
  const std::vector<PointId> Loose;
  const PointLists Points;
  const ItemLists<std::size_t> LoopsOf;
  const EdgeLists BlockEdges;
  RawVector<PointId> LocalNumber;
};

// ---- Meshing --------------------------------------------------------------------------------------------------------

template <typename Item, typename Condition>
std::size_t CountIf(const std::vector<Item>& items, Condition&& condition)
{
  constexpr std::int64_t grain = 1024;
  std::atomic<std::size_t> count{ 0 };
  ParallelFor(std::int64_t(items.size()), grain,
    [&](std::int64_t first, std::int64_t last)
    { count += std::count_if(items.begin() + first, items.begin() + last, condition); });
  return count;
}

class PatchTriangulator
{
public:
  PatchTriangulator(const Patch& patch, const TriangulationOptions& options, Triangulation& result)
    : Input(patch)
    , Options(options)
    , Points(patch.Places, patch.Boundary, patch.Points)
    , Search(this->Points, options.Strategy)
    , Front(this->Points, this->Search, options.MostTriangles > 0 ? 1 : PatchFront::FindStrips(this->Points))
    , Result(result)
  {
    // The surface is to the right of a boundary edge, so that its reverse waits for a triangle. An edge that occurs in
    // both directions has no surface on either side.
    patch.Boundary.ForEachEdge([this](PointId from, PointId to) { this->AddEdge(from, to); });
    for (const Edge& edge : patch.BlockEdges)
    {
      this->AddEdge(edge.From, edge.To);
    }
    for (std::size_t loop = 0; loop < patch.Boundary.Size(); ++loop)
    {
      // A loop of one point has no edge.
      this->Front.Use(this->Points.NumberOf(*patch.Boundary.begin(loop)));
    }
  }

  void Run(const Monitor& monitor)
  {
    const std::size_t most = this->Options.MostTriangles;
    this->Front.Grow(most > 0 ? most : this->Front.MostTriangles() + 1, monitor);
    if (most == 0)
    {
      this->CheckAllUsed();
    }
    else if (this->Front.NumberOfTriangles() == most)
    {
      this->TraceLast();
    }
    this->Front.MoveTriangles(this->Result.Triangles);
  }

  std::size_t CountNonDelaunay(const std::vector<Edge>& edges) const
  {
    return CountIf(edges,
      [this](const Edge& edge)
      { return !this->Search.IsDelaunay(this->Points.NumberOf(edge.From), this->Points.NumberOf(edge.To)); });
  }

private:
  void AddEdge(PointId from, PointId to)
  {
    this->Front.AddEdge(this->Points.NumberOf(from), this->Points.NumberOf(to));
  }

  void TraceLast()
  {
    const Edge edge = this->Front.LastEdge();
    std::vector<WalkedCell> walk;
    this->Search.Find(edge.From, edge.To, 0.0f, &walk);
    const CellGrid& cells = this->Points.Cells();
    const PlaneFrame& frame = this->Input.Frame;
    this->Result.Walk.clear();
    for (const WalkedCell& cell : walk)
    {
      this->Result.Walk.push_back({ frame.Outward(cells.CornerOf(cell.X, cell.Y)),
        frame.Outward(cells.CornerOf(cell.X + 1, cell.Y + 1)), cell.Dilatation });
    }
  }

  void CheckAllUsed() const
  {
    for (PointId point = 0; point < this->Points.NumberOfPoints(); ++point)
    {
      if (!this->Front.IsUsed(point))
      {
        throw InputError("point " + std::to_string(this->Points.NameOf(point)) +
          " lies outside the boundary of its patch, expected all points inside");
      }
    }
  }

  const Patch& Input;
  const TriangulationOptions Options;
  const SearchGrid Points;
  const ThirdPointSearch Search;
  PatchFront Front;
  Triangulation& Result;
};

std::vector<Edge> FindBoundaryEdges(const Patch& patch)
{
  AdvancingFront walked(0, PointId(patch.Points.size()));
  patch.Boundary.ForEachEdge([&walked](PointId from, PointId to) { walked.AddEdge({ from, to }); });
  std::vector<Edge> edges;
  for (FrontEdge edge; walked.TakeNewest(edge);)
  {
    edges.push_back({ edge.From, edge.To });
  }
  return edges;
}

/// Neighbouring columns, also diagonal, have no other column in their smallest circle.
std::vector<Edge> FindLong(const std::vector<Edge>& edges, const std::vector<PlanePoint>& places)
{
  std::vector<Edge> result;
  std::copy_if(edges.begin(), edges.end(), std::back_inserter(result),
    [&places](const Edge& edge)
    {
      const PlanePoint& from = places[edge.From];
      const PlanePoint& to = places[edge.To];
      return std::max(std::abs(from.X - to.X), std::abs(from.Y - to.Y)) > 1;
    });
  return result;
}

class HorizonTriangulator
{
public:
  HorizonTriangulator(const BoundedHorizon& horizon, const TriangulationOptions& options)
    : Horizon(horizon)
    , Options(options)
    , Frame(horizon.Plane)
    , Blocks(options.MostTriangles > 0 ? FullBlocks() : FullBlocks(horizon, this->Frame))
    , Patches(horizon, this->Frame, this->Blocks)
  {
  }

  Triangulation Run(const Monitor& monitor)
  {
    monitor.Progress(0.3);
    // By Euler's formula loose points are corners of less than two triangles each.
    this->Result.Triangles.reserve(3 * this->Blocks.NumberOfTriangles() + 6 * this->Patches.NumberOfPoints());
    this->Result.Triangles.resize(3 * this->Blocks.NumberOfTriangles());
    this->Blocks.WriteTriangles(this->Result.Triangles.data());
    std::size_t done = 0;
    for (std::int64_t number = 0; number < this->Patches.Size(); ++number)
    {
      const Patch patch = this->Patches.Get(number);
      if (!patch.Points.empty())
      {
        const double all = double(this->Patches.NumberOfPoints());
        const double before = 0.5 + 0.5 * double(done) / all;
        done += patch.Points.size();
        this->RunPatch(number, patch, monitor.Step(before, 0.5 + 0.5 * double(done) / all));
      }
    }
    this->CountDoubtful();
    return std::move(this->Result);
  }

private:
  void RunPatch(std::int64_t number, const Patch& patch, const Monitor& monitor)
  {
    PatchTriangulator triangulator(patch, this->Options, this->Result);
    triangulator.Run(monitor);
    if (this->Options.MostTriangles > 0)
    {
      return;
    }
    const std::vector<Edge> edges = FindBoundaryEdges(patch);
    this->Result.BoundaryEdges += edges.size();
    const std::vector<Edge> longEdges = FindLong(edges, patch.Places);
    if (this->Blocks.NumberOfTriangles() == 0)
    {
      this->Result.NonDelaunayEdges += triangulator.CountNonDelaunay(longEdges);
      return;
    }
    for (const Edge& edge : longEdges)
    {
      this->Doubtful.push_back({ number, patch.Points[edge.From], patch.Points[edge.To] });
    }
  }

  void CountDoubtful()
  {
    if (this->Doubtful.empty())
    {
      return;
    }
    PatchList whole(this->Horizon, this->Frame, FullBlocks());
    for (auto first = this->Doubtful.begin(); first != this->Doubtful.end();)
    {
      const auto last = std::find_if(
        first, this->Doubtful.end(), [first](const DoubtfulEdge& edge) { return edge.Patch != first->Patch; });
      const Patch patch = whole.Get(first->Patch);
      const SearchGrid points(patch.Places, Loops(), patch.Points);
      const ThirdPointSearch search(points, this->Options.Strategy);
      const auto number = [&](PointId point) { return points.NumberOf(whole.NumberInPatch(point)); };
      this->Result.NonDelaunayEdges += CountIf(std::vector<DoubtfulEdge>(first, last),
        [&](const DoubtfulEdge& edge) { return !search.IsDelaunay(number(edge.From), number(edge.To)); });
      first = last;
    }
  }

  struct DoubtfulEdge
  {
    std::int64_t Patch;
    PointId From;
    PointId To;
  };

  const BoundedHorizon& Horizon;
  const TriangulationOptions Options;
  const PlaneFrame Frame;
  const FullBlocks Blocks;
  PatchList Patches;
  std::vector<DoubtfulEdge> Doubtful;
  Triangulation Result;
};
}

//----------------------------------------------------------------------------------------------------------------------
Triangulation Triangulate(const BoundedHorizon& horizon, const TriangulationOptions& options, const Monitor& monitor)
{
  if (horizon.Plane.empty())
  {
    return {};
  }
  Triangulation result = HorizonTriangulator(horizon, options).Run(monitor);
  if (MeshChecker::IsOn && options.MostTriangles == 0)
  {
    MeshChecker::Require("Triangulate", horizon.Plane, horizon.Boundary, result.Triangles);
  }
  return result;
}
}
