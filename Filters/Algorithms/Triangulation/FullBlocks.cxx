// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FullBlocks.h"

#include "Common/CellGrid.h"
#include "Common/Parallel.h"
#include "Common/Predicates.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace SeismicHorizons
{
namespace
{
// How many columns a thread takes at a time.
constexpr std::int64_t Grain = 32768;

// Where fewer points than one in so many columns are left, looking at all columns takes longer than full blocks save.
constexpr std::int64_t MostColumnsPerPoint = 8;

/// Whether an edge leads to the next column in a row, or to the next row: it runs between blocks and cuts none.
bool RunsBetweenBlocks(const PlanePoint& a, const PlanePoint& b)
{
  return std::abs(a.X - b.X) + std::abs(a.Y - b.Y) == 1;
}

bool AreAllEqual(const std::vector<std::int32_t>& values)
{
  return std::all_of(values.begin(), values.end(), [&](std::int32_t value) { return value == values.front(); });
}

template <std::size_t Size>
bool AreInOnePatch(const std::array<PointId, Size>& points, const std::int32_t* patches)
{
  return std::all_of(points.begin(), points.end(),
    [&](PointId point) { return patches[std::size_t(point)] == patches[std::size_t(points.front())]; });
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
}

//----------------------------------------------------------------------------------------------------------------------
FullBlocks::FullBlocks(const BoundedHorizon& horizon, const PlaneFrame& frame)
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
  const std::int32_t* const patches = AreAllEqual(horizon.Patch) ? nullptr : horizon.Patch.data();
  std::vector<std::size_t> full(std::size_t(this->Height), 0);
  std::vector<std::size_t> rings(std::size_t(this->Height), 0);
  this->ForEachRow([&](std::int64_t y) { full[std::size_t(y)] = this->FindFull(y, patches); });
  this->ForEachRow([&](std::int64_t y) { rings[std::size_t(y)] = this->FindRings(y, patches); });
  this->RowStarts.push_back(0);
  for (std::size_t y = 0; y + 1 < full.size(); ++y)
  {
    // FindRings counts a ring in the row of its middle, which is one further up than that of its least corner.
    this->RowStarts.push_back(this->RowStarts.back() + 2 * full[y] + 6 * rings[y + 1]);
  }
}

//----------------------------------------------------------------------------------------------------------------------
template <typename Work>
void FullBlocks::ForEachRow(Work&& work) const
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

//----------------------------------------------------------------------------------------------------------------------
bool FullBlocks::PlacePoints(const std::vector<PlanePoint>& points)
{
  this->Points.resize(std::size_t(this->Width * this->Height));
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

//----------------------------------------------------------------------------------------------------------------------
void FullBlocks::MarkCutBlocks(const BoundedHorizon& horizon)
{
  const CellGrid blocks({ { 0, 0 }, this->Frame.Inward(this->Frame.Greatest) }, 1, 1);
  horizon.Boundary.ForEachEdge(
    [&](PointId from, PointId to)
    {
      const PlanePoint a = this->Frame.Inward(horizon.Plane[std::size_t(from)]);
      const PlanePoint b = this->Frame.Inward(horizon.Plane[std::size_t(to)]);
      if (!RunsBetweenBlocks(a, b))
      {
        blocks.ForEachCellAlong(a, b, [this](std::int64_t block) { this->Blocks[std::size_t(block)] |= Cut; });
      }
    });
}

//----------------------------------------------------------------------------------------------------------------------
// Each edge that crosses the line through the middles of a row of blocks is where the inside begins or ends, for all
// blocks whose middles are further to the right. An edge right through a middle does not matter: it cuts that block.
void FullBlocks::MarkTurns(const BoundedHorizon& horizon)
{
  horizon.Boundary.ForEachEdge(
    [&](PointId from, PointId to)
    {
      const PlanePoint a = this->Frame.Inward(horizon.Plane[std::size_t(from)]);
      const PlanePoint b = this->Frame.Inward(horizon.Plane[std::size_t(to)]);
      for (std::int32_t y = std::min(a.Y, b.Y); y < std::max(a.Y, b.Y); ++y)
      {
        const double x = a.X + (double(b.X) - a.X) * (y + 0.5 - a.Y) / (double(b.Y) - a.Y);
        this->Blocks[this->Place(std::int64_t(std::floor(x + 0.5)), y)] ^= Turn;
      }
    });
}

//----------------------------------------------------------------------------------------------------------------------
// Inside the boundary of one patch there should be no points of another one. A block with points of several patches is
// left to the search, which refuses such input.
std::size_t FullBlocks::FindFull(std::int64_t y, const std::int32_t* patches)
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

//----------------------------------------------------------------------------------------------------------------------
// A block is in one ring at most, as it has one empty corner and that is the middle of the ring. So threads write to
// different blocks here, and read none that another one writes.
std::size_t FullBlocks::FindRings(std::int64_t y, const std::int32_t* patches)
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

//----------------------------------------------------------------------------------------------------------------------
bool FullBlocks::IsRing(std::int64_t x, std::int64_t y, const std::int32_t* patches) const
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

//----------------------------------------------------------------------------------------------------------------------
std::vector<PointId> FullBlocks::FindLoosePoints(const BoundedHorizon& horizon) const
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

//----------------------------------------------------------------------------------------------------------------------
std::vector<PointId> FullBlocks::FindUncovered() const
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

//----------------------------------------------------------------------------------------------------------------------
// Where the boundary runs through the inside of a patch and back.
std::vector<PointId> FullBlocks::FindCoveredBoundary(const BoundedHorizon& horizon) const
{
  std::vector<PointId> covered;
  horizon.Boundary.ForEachPoint(
    [&](PointId point)
    {
      const PlanePoint column = this->Frame.Inward(horizon.Plane[std::size_t(point)]);
      if (this->Covers(column.X, column.Y))
      {
        covered.push_back(point);
      }
    });
  std::sort(covered.begin(), covered.end());
  covered.erase(std::unique(covered.begin(), covered.end()), covered.end());
  return covered;
}

//----------------------------------------------------------------------------------------------------------------------
void FullBlocks::WriteTriangles(PointId* corners) const
{
  if (this->NumberOfTriangles() > 0)
  {
    this->ForEachRow([&](std::int64_t y) { this->WriteRow(y, corners + 3 * this->RowStarts[std::size_t(y)]); });
  }
}

//----------------------------------------------------------------------------------------------------------------------
void FullBlocks::WriteRow(std::int64_t y, PointId* corners) const
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
}

//----------------------------------------------------------------------------------------------------------------------
PointId* FullBlocks::WriteBlock(std::int64_t x, std::int64_t y, PointId* corners) const
{
  const std::array<PointId, 4> corner = { this->At(x, y), this->At(x + 1, y), this->At(x + 1, y + 1),
    this->At(x, y + 1) };
  return WriteSquare(corner, this->BlockDiagonal, corners);
}

//----------------------------------------------------------------------------------------------------------------------
PointId* FullBlocks::WriteRing(std::int64_t x, std::int64_t y, PointId* corners) const
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
}
