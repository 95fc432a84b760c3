// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// 1. Full blocks. An edge between neighbouring columns is in every constrained Delaunay triangulation, as the circle
//    around it holds no other column. So what such edges enclose is meshed on its own, as long as it is inside the
//    boundary and no boundary edge cuts it:
//     - a full block, two by two points: two triangles. InCircle in Predicates.h says which diagonal cuts it.
//     - a ring, three by three points without the middle one, which is what a single missing point leaves: four
//       triangles at its corners, and two in the square between the middles of its sides, whose diagonal InCircle
//       settles, too.
//
//     *---*        *---*---*
//     | / |        |  / \  |
//     *---*        | / : \ |
//                  *   :   *
//     a block      | \ : / |      a ring
//                  |  \ /  |
//                  *---*---*
//
// 2. Patches, one after the other: the loose points, which blocks and rings do not surround on all sides, and the edges
//    to start from, those of the boundary and the sides of the blocks.
// 3. Each patch is meshed by fronts (PatchFront.h), from its boundary inwards and from its full blocks outwards.
// 4. Boundary edges are counted, and those among them that are not Delaunay. As full blocks may have points in their
//    circles, these are tried among all points of a patch.
//
// All triangles of full blocks come first in the mesh, row by row, then those of the patches.

#include "Triangulation.h"

#include "Common/CellGrid.h"
#include "Common/CountingSort.h"
#include "Common/Errors.h"
#include "Common/MeshChecker.h"
#include "Common/Parallel.h"
#include "Common/PlaneFrame.h"
#include "Common/Predicates.h"
#include "PatchFront.h"

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

constexpr std::int64_t Grain = 32768; // columns that a thread takes at a time

// Where fewer points than one in so many columns are left, looking at all columns takes longer than full blocks save.
constexpr std::int64_t MostColumnsPerPoint = 8;

/// Whether an edge leads to the next column in a row, or to the next row: it runs between blocks and cuts none.
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

/// Two triangles, cut by the diagonal from corner 0 or 1.
PointId* WriteSquare(const std::array<PointId, 4>& corner, std::size_t first, PointId* corners)
{
  corners = Write(corner[first], corner[first + 1], corner[first + 2], corners);
  return Write(corner[first], corner[first + 2], corner[(first + 3) % 4], corners);
}

/// A block is known by the column of its least corner.
class FullBlocks
{
public:
  /// Has no blocks.
  FullBlocks() = default;

  /// Finds those of all patches of a horizon; `frame` is that of its points. When the points are so few in their
  /// bounding box that there cannot be many full blocks, or when two of them are in one place, none is found.
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
      // FindRings counts a ring in the row of its middle, which is one further up than that of its least corner.
      this->RowStarts.push_back(this->RowStarts.back() + 2 * full[y] + 6 * rings[y + 1]);
    }
  }

  std::size_t NumberOfTriangles() const { return this->RowStarts.empty() ? 0 : this->RowStarts.back(); }

  /// The points of the horizon that the search still has to know: those that blocks and rings do not cover, which is
  /// to surround them on all sides, and those of the boundary.
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

  /// The triangles of all full blocks and rings, counter-clockwise, row by row: three points each.
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

  /// Calls visit(from, to) for each side of a full block or ring that has no other one on its other side, with the
  /// block to the left. All of them begin and end in `loose` points, which are those of FindLoosePoints.
  template <typename Visitor>
  void ForEachSide(const BoundedHorizon& horizon, const std::vector<PointId>& loose, Visitor&& visit) const
  {
    for (std::size_t n = 0; this->NumberOfTriangles() > 0 && n < loose.size(); ++n)
    {
      const PlanePoint column = this->Frame.Inward(horizon.Plane[loose[n]]);
      this->VisitSides(column.X, column.Y, [&](PointId to) { visit(loose[n], to); });
    }
  }

private:
  enum Block : unsigned char
  {
    Nothing = 0,
    Turn = 1, // the inside of the boundary begins or ends between this block and the one to its left
    Cut = 2, // a boundary edge runs through the block, or close by
    Open = 4, // the block is inside the boundary, and not cut
    Full = 8, // a full block
    Ring = 16, // a quarter of a ring
    Meshed = Full | Ring
  };

  /// Calls work(y) for each row of blocks, on several threads.
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

  /// False when two are in one place.
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

  /// Each edge that crosses the line through the middles of a row of blocks is where the inside begins or ends, for all
  /// blocks whose middles are further to the right. An edge right through a middle does not matter: it cuts that block.
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

  /// Inside the boundary of one patch there should be no points of another one. A block with points of several patches
  /// is left to the search, which refuses such input.
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
      // NoPoint is the only negative number, so the sign of the four combined says whether one of them is missing.
      const bool full = open && (below[x] | below[x + 1] | above[x] | above[x + 1]) >= 0 &&
        (!patches || AreInOnePatch(std::array<PointId, 4>{ below[x], below[x + 1], above[x], above[x + 1] }, patches));
      blocks[x] = (open ? Open : Nothing) | (full ? Full : Nothing);
      count += full ? 1 : 0;
    }
    return count;
  }

  /// A block is in one ring at most, as it has one empty corner and that is the middle of the ring. So threads write to
  /// different blocks here, and read none that another one writes.
  std::size_t FindRings(std::int64_t y, const std::int32_t* patches)
  {
    std::size_t count = 0;
    for (std::int64_t x = 1; y > 0 && x + 1 < this->Width; ++x)
    {
      // Most empty columns have empty neighbours.
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
      bool left = false; // whether both blocks to the left of a column are meshed
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

  /// Where the boundary runs through the inside of a patch and back.
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
    // The middles of the sides that follow the corners.
    const std::array<PointId, 4> middle = { this->At(x + 1, y), this->At(x + 2, y + 1), this->At(x + 1, y + 2),
      this->At(x, y + 1) };
    for (std::size_t n = 0; n < 4; ++n)
    {
      corners = Write(corner[n], middle[n], middle[(n + 3) % 4], corners);
    }
    return WriteSquare(middle, this->RingDiagonal, corners);
  }

  /// Calls visit(to) for the sides that begin in a point, with their other ends.
  template <typename Visitor>
  void VisitSides(std::int64_t x, std::int64_t y, Visitor&& visit) const
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

  /// Whether all four blocks around a column are meshed.
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

  /// Whether a ring has its least corner here.
  bool BeginsRing(std::int64_t x, std::int64_t y) const
  {
    return (this->Blocks[this->Place(x, y)] & Ring) != 0 && this->At(x + 1, y + 1) == NoPoint;
  }

  PlaneFrame Frame;
  std::int64_t Width = 0;
  std::int64_t Height = 0;
  RawVector<PointId> Points; // by column
  std::vector<unsigned char> Blocks; // by the column of the least corner
  std::vector<std::size_t> RowStarts; // for each row how many triangles the rows before it have
  // Which diagonal cuts a square: that between its first and third corner (0) or between the others (1).
  std::size_t BlockDiagonal = 0;
  std::size_t RingDiagonal = 0;
};

// ---- Patches --------------------------------------------------------------------------------------------------------

/// One patch. Its points have numbers of their own, from 0.
struct Patch
{
  std::vector<PointId> Points; // for each of its points the number in the horizon
  std::vector<PlanePoint> Places; // in its frame
  PlaneFrame Frame;
  Loops Boundary;
  std::vector<Edge> BlockSides; // with full blocks to their left, and nothing meshed to their right
};

/// The patches of a horizon one by one.
class PatchList
{
public:
  /// Leaves out the points that blocks cover. `horizon` must outlive the list, and `frame` is that of its points.
  /// Throws InputError on patch numbers that are negative or not less than the number of points.
  PatchList(const BoundedHorizon& horizon, const PlaneFrame& frame, const FullBlocks& blocks)
    : Horizon(horizon)
    , Frame(frame)
    , Patches(CountPatches(horizon.Patch))
    , Loose(blocks.FindLoosePoints(horizon))
    , Points(PointsByPatch(horizon, this->Loose, this->Patches))
    , LoopsOf(LoopsByPatch(horizon, this->Patches))
    , BlockSides(SidesByPatch(horizon, blocks, this->Loose, this->Patches))
    , LocalNumber(horizon.Patch.size())
  {
  }

  /// How many patches there are. Some may have no points.
  std::int64_t Size() const { return this->Patches; }

  /// How many points all patches have.
  std::size_t NumberOfPoints() const { return this->Loose.size(); }

  /// Throws InputError when a loop of the patch leaves it.
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
      // The unit is that of all points, as those that blocks cover may lie between those that are left.
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
    for (const Edge* side = this->BlockSides.begin(number); side != this->BlockSides.end(number); ++side)
    {
      patch.BlockSides.push_back({ this->NumberInPatch(side->From), this->NumberInPatch(side->To) });
    }
    return patch;
  }

  /// The number that a point of the horizon has in its patch, once Get was called for the patch.
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

  static EdgeLists SidesByPatch(
    const BoundedHorizon& horizon, const FullBlocks& blocks, const std::vector<PointId>& loose, std::int64_t patches)
  {
    return EdgeLists(patches,
      [&](auto&& add) {
        blocks.ForEachSide(horizon, loose,
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
  const EdgeLists BlockSides;
  RawVector<PointId> LocalNumber;
};

// ---- Meshing --------------------------------------------------------------------------------------------------------

/// How many items fulfil a condition, by several threads.
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

/// Meshes a patch from its boundary inwards, and from its full blocks outwards.
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
    // The surface lies to the right of each boundary edge, so its reverse waits for a triangle. An edge that the
    // boundary has in both directions has surface on neither side.
    patch.Boundary.ForEachEdge([this](PointId from, PointId to) { this->AddSide(from, to); });
    for (const Edge& side : patch.BlockSides)
    {
      this->AddSide(side.From, side.To);
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

  /// How many edges, by the numbers of the patch, are not Delaunay among its points.
  std::size_t CountNonDelaunay(const std::vector<Edge>& edges) const
  {
    return CountIf(edges,
      [this](const Edge& edge)
      { return !this->Search.IsDelaunay(this->Points.NumberOf(edge.From), this->Points.NumberOf(edge.To)); });
  }

private:
  void AddSide(PointId from, PointId to)
  {
    this->Front.AddSide(this->Points.NumberOf(from), this->Points.NumberOf(to));
  }

  /// Searches once more for the third point of the last edge.
  void TraceLast()
  {
    const Edge edge = this->Front.LastEdge();
    std::vector<WalkedVoxel> walk;
    this->Search.Find(edge.From, edge.To, 0.0f, &walk);
    const CellGrid& voxels = this->Points.Voxels();
    const PlaneFrame& frame = this->Input.Frame;
    this->Result.Walk.clear();
    for (const WalkedVoxel& voxel : walk)
    {
      this->Result.Walk.push_back({ frame.Outward(voxels.CornerOf(voxel.X, voxel.Y)),
        frame.Outward(voxels.CornerOf(voxel.X + 1, voxel.Y + 1)), voxel.Dilatation });
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

/// The boundary edges of a patch that have surface on one side, turned so that it is to their left.
std::vector<Edge> FindBoundaryEdges(const Patch& patch)
{
  AdvancingFront walked(0, PointId(patch.Points.size()));
  patch.Boundary.ForEachEdge([&walked](PointId from, PointId to) { walked.AddSide({ from, to }); });
  std::vector<Edge> edges;
  for (FrontEdge edge; walked.TakeNewest(edge);)
  {
    edges.push_back({ edge.From, edge.To });
  }
  return edges;
}

/// Those that may not be Delaunay: two places that are neighbours, if only across a corner, have no other place in the
/// smallest circle around them.
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

/// Meshes the patches of a horizon one after the other.
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

  /// Counts those of the doubtful edges that are not Delaunay among all points: also those that full blocks cover may
  /// be in their circles.
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

  /// A boundary edge that may not be Delaunay, by the numbers of the horizon.
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
  std::vector<DoubtfulEdge> Doubtful; // patch by patch
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
