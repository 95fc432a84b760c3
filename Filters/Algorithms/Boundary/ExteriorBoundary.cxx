// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// In this order: clockwise growth; hops to neighbours, with bridges of growth by distance; the scan that finds all
// loops for these; the choice between the two; the classification of points.
//
// Both methods walk around faces of a plane graph. The graph is decided before the walk, which therefore needs no rules
// of its own and cannot cross itself.

#include "ExteriorBoundary.h"

#include "Common/Base/DisjointSets.h"
#include "Common/Base/LargePages.h"
#include "Common/Base/Parallel.h"
#include "Common/Base/Parameters.h"
#include "Common/Horizon/ColumnIndex.h"
#include "Hops.h"
#include "PatchComponents.h"
#include "PlanarHops.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
namespace
{
// ---- Clockwise growth -----------------------------------------------------------------------------------------------
// Boundary by clockwise growth, for k > 1 or with cuts: the outer faces of the graph of admissible hops (PlanarHops.h),
// and on request its inner faces that are holes.

// Most faces are small and enclose no column; walking one again is faster than remembering its hops.
constexpr std::size_t SmallestWalkToRemember = 16;

constexpr std::size_t FacesPerBatch = 256;

/// With cuts, holes without a loop are walked as well, and CutFaces decides which of them stay open. Options are not checked, and MinimumPatchSize is ignored.
class FaceFinder
{
public:
  FaceFinder(const ColumnIndex& index, const BoundaryOptions& options, const Monitor& monitor)
    : Columns(index.Columns())
    , Options(options)
    , Index(index)
    , Hops(options.Radius, this->Index.Width())
    , Blocks(options.Cuts ? std::make_unique<const CutBlocks>(*options.Cuts, this->Columns, this->Index) : nullptr)
    , Graph(this->Index, this->Hops, this->Blocks.get(), monitor)
    , Parts(options.Cuts ? FindHopComponents(this->Index, this->Columns.size(), this->Hops, this->Graph)
                         : FindPatchComponents(this->Index, this->Columns.size(), options.Radius))
    , Walked(this->Graph.Size() + 1, false)
    , WalksHoles(options.KeepHoles || options.Cuts)
  {
    if (options.Cuts)
    {
      this->Cracks.emplace(this->Columns, this->Index, this->Hops, *this->Blocks);
    }
  }

  ExteriorBoundary Run(const Monitor& monitor)
  {
    this->WalkOutlines(monitor.Step(0.0, this->WalksHoles ? 0.4 : 0.9));
    if (this->WalksHoles)
    {
      this->WalkHoles(monitor.Step(0.4, 0.9));
    }
    if (this->Cracks)
    {
      this->Faces = this->Cracks->Select(this->Faces, this->Parts.First);
    }
    return this->Collect();
  }

  std::vector<CrackSide> FindCrackSides() const
  {
    return FindCrackFaces(this->Columns, this->Index, this->Hops, this->Graph);
  }

private:
  void WalkOutlines(const Monitor& monitor)
  {
    const HopId west = this->Hops.Find({ -1, 0 });
    for (std::size_t part = 0; part < this->Parts.First.size(); ++part)
    {
      if (part % 64 == 0)
      {
        monitor.Progress(double(part) / double(this->Parts.First.size()));
      }
      const std::int64_t start = this->Parts.First[part];
      this->Walk(start, this->Graph.Next(start, west));
      if (this->Cracks)
      {
        this->Cracks->AddOutline(this->Steps);
      }
      if (this->WalksHoles)
      {
        this->Remember();
      }
      AppendLoop(this->Hops, this->Steps, this->Faces);
    }
  }

  void WalkHoles(const Monitor& monitor)
  {
    const std::vector<std::int64_t>& places = this->Graph.PlacesBesideGaps();
    for (std::size_t n = 0; n < places.size(); ++n)
    {
      if (n % FacesPerBatch == 0)
      {
        monitor.Progress(double(n) / double(places.size()));
      }
      this->WalkHolesAt(places[n]);
    }
  }

  void WalkHolesAt(std::int64_t place)
  {
    const HopId first = this->Graph.Next(place, this->Hops.Size() - 1);
    HopId hop = first;
    while (hop != NoHop)
    {
      if (!this->Walked[this->Graph.NumberOf(place, hop)])
      {
        this->WalkHole(place, hop);
      }
      hop = this->Graph.Next(place, hop);
      hop = hop == first ? NoHop : hop;
    }
  }

  void WalkHole(std::int64_t place, HopId hop)
  {
    this->Walk(place, hop);
    const std::int64_t inside = ColumnsInside(this->Hops, this->Steps);
    const bool isHole = this->Options.KeepHoles && inside > 0 && inside >= this->Options.SmallestHoleSize;
    const bool hasLoop = this->Cracks ? this->Cracks->AddHole(this->Steps, isHole, inside > 0) : isHole;
    if (hasLoop || inside > 0 || this->Steps.size() >= SmallestWalkToRemember)
    {
      this->Remember();
    }
    if (hasLoop)
    {
      AppendLoop(this->Hops, this->Steps, this->Faces);
    }
  }

  void Walk(std::int64_t start, HopId first)
  {
    const auto next = [this](std::int64_t place, HopId from) { return this->Graph.Next(place, from); };
    WalkFace(this->Index, this->Hops, start, first, next, this->Steps);
  }

  void Remember()
  {
    for (const FaceStep& step : this->Steps)
    {
      this->Walked[this->Graph.NumberOf(this->Index.Place(this->Columns[step.Point]), step.Hop)] = true;
    }
    this->Walked.back() = false; // Hops between points that are not beside empty columns share this number.
  }

  /// Islands that belong to another patch lose their outlines.
  ExteriorBoundary Collect()
  {
    const std::vector<std::int32_t> patchOf = AssignIslands(this->Columns, this->Index, this->Parts.First, this->Faces);
    ExteriorBoundary result;
    std::vector<std::int32_t> number(patchOf.size(), NoPatch);
    for (std::size_t part = 0; part < number.size(); ++part)
    {
      if (patchOf[part] == std::int32_t(part))
      {
        number[part] = std::int32_t(result.Boundary.Size());
        result.Boundary.AppendLoop(this->Faces, part);
      }
    }
    result.NumberOfPatches = result.Boundary.Size();
    for (std::size_t loop = number.size(); loop < this->Faces.Size(); ++loop)
    {
      result.Boundary.AppendLoop(this->Faces, loop);
    }
    result.Patch = std::move(this->Parts.Component);
    for (std::int32_t& patch : result.Patch)
    {
      patch = number[patchOf[patch]];
    }
    return result;
  }

  const PlanePoints Columns;
  const BoundaryOptions& Options;
  const ColumnIndex& Index;
  const HopVectors Hops;
  const std::unique_ptr<const CutBlocks> Blocks; // null without cuts
  const PlanarHops Graph;
  PatchComponents Parts;
  Loops Faces; // Outlines of all components come first, loops of holes follow.
  std::vector<bool> Walked; // by number in Graph: the face on its left was walked
  const bool WalksHoles;
  std::optional<CutFaces> Cracks;
  std::vector<FaceStep> Steps;
};

// ---- Hops to neighbours ---------------------------------------------------------------------------------------------
// Growth by distance (thesis Alg. 3.1) has all hops to the eight neighbours, and bridges from short to long between
// parts that these leave separate. Bridges belong to a minimum spanning tree, so that they cross and enclose nothing
// (PlanarHops.h); the walk takes each one out and back.

struct SweepResult
{
  HopId Next;
  // The sweep passed the column to the right or to the left, which is therefore empty.
  bool PassedEast;
  bool PassedWest;
};

/// Of two opposite hops only the rising one is listed. Hops with the nearest ends come first.
std::vector<HopId> FindLongHops(const HopVectors& hops)
{
  std::vector<HopId> result;
  for (HopId hop = 0; hop < hops.Size(); ++hop)
  {
    const PlanePoint& vector = hops.Vector(hop);
    if (LongHops::IsLongAndRising(vector))
    {
      result.push_back(hop);
    }
  }
  std::stable_sort(
    result.begin(), result.end(), [&hops](HopId a, HopId b) { return IsNearer(hops.Vector(a), hops.Vector(b)); });
  return result;
}

std::vector<std::int64_t> FindPlaces(const ColumnIndex& index, const Loops& loops)
{
  std::vector<std::int64_t> places;
  places.reserve(loops.TotalLength());
  loops.ForEachPoint([&](PointId point) { places.push_back(index.PlaceOf(point)); });
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

/// Returns the patch of each point.
std::vector<std::int32_t> ListPatches(const ColumnIndex& index, const PatchSpans& spans)
{
  std::vector<std::int32_t> patches = LargeVector(spans.NumberOfPoints(), NoPatch);
  ParallelFor(std::int64_t(patches.size()), Grain,
    [&](std::int64_t firstPoint, std::int64_t lastPoint)
    {
      spans.ForEach(PointId(firstPoint), PointId(lastPoint),
        [&](PointId first, PointId last, std::int32_t patch)
        {
          for (PointId rank = first; rank < last; ++rank)
          {
            patches[index.PointOf(rank)] = patch;
          }
        });
    });
  return patches;
}

class PatchBridges
{
public:
  /// `parts` is the boundary for k = 1; bridges join its patches.
  PatchBridges(const ColumnIndex& index, const HopVectors& hops, const RowBoundary& parts)
    : Index(index)
    , Hops(hops)
    , HasEnd(index.NumberOfPoints(), false)
  {
    if (parts.NumberOfPatches > 1)
    {
      this->Join(FindPlaces(index, parts.Boundary), parts);
    }
    std::sort(this->Ends.begin(), this->Ends.end(),
      [](const End& a, const End& b) { return a.Place != b.Place ? a.Place < b.Place : a.Hop < b.Hop; });
  }

  bool IsEmpty() const { return this->Ends.empty(); }

  HopId Next(std::int64_t place, HopId from) const
  {
    if (!this->HasEnd[this->Index[place]])
    {
      return NoHop;
    }
    auto end = std::lower_bound(
      this->Ends.begin(), this->Ends.end(), place, [](const End& a, std::int64_t b) { return a.Place < b; });
    HopId best = NoHop;
    for (; end != this->Ends.end() && end->Place == place; ++end)
    {
      best = best == NoHop || this->Hops.Turn(from, end->Hop) < this->Hops.Turn(from, best) ? end->Hop : best;
    }
    return best;
  }

private:
  struct End
  {
    std::int64_t Place;
    HopId Hop;
  };

  void Join(const std::vector<std::int64_t>& onLoops, const RowBoundary& parts)
  {
    const std::vector<std::int32_t> patches = ListPatches(this->Index, parts.Patches);
    const auto part = [&](std::int64_t place) { return patches[this->Index[place]]; };
    DisjointSets joined(parts.NumberOfPatches);
    for (const HopId hop : FindLongHops(this->Hops))
    {
      for (const std::int64_t place : onLoops)
      {
        const std::int64_t end = place + this->Hops.Offset(hop);
        if (this->Index.Has(end) && part(place) != part(end) && joined.Join(part(place), part(end)))
        {
          this->AddEnd(place, hop);
          this->AddEnd(end, this->Hops.Opposite(hop));
        }
      }
    }
  }

  void AddEnd(std::int64_t place, HopId hop)
  {
    this->Ends.push_back({ place, hop });
    this->HasEnd[this->Index[place]] = true;
  }

  const ColumnIndex& Index;
  const HopVectors& Hops;
  std::vector<End> Ends; // sorted by place, then hop
  std::vector<bool> HasEnd;
};

class NeighbourGraph
{
public:
  /// Bridges may be null.
  NeighbourGraph(const ColumnIndex& index, const HopVectors& hops, const PatchBridges* bridges)
    : Index(index)
    , Hops(hops)
    , Bridges(bridges)
    , East(hops.Find({ 1, 0 }))
    , West(hops.Find({ -1, 0 }))
  {
    assert(hops.ToNeighbours().size() == this->Neighbours.size());
    std::copy(hops.ToNeighbours().begin(), hops.ToNeighbours().end(), this->Neighbours.begin());
    for (HopId hop = 0; hop < hops.Size(); ++hop)
    {
      const auto next = std::upper_bound(this->Neighbours.begin(), this->Neighbours.end(), hop);
      this->After.push_back(std::size_t(next - this->Neighbours.begin()));
    }
  }

  /// Returns the first hop after `from` in a clockwise sweep, `from` last.
  SweepResult Sweep(std::int64_t place, HopId from) const
  {
    const HopId bridge = this->Bridges ? this->Bridges->Next(place, from) : NoHop;
    bool passedEast = false;
    bool passedWest = false;
    for (std::size_t n = this->After[from]; n < this->After[from] + this->Neighbours.size(); ++n)
    {
      const HopId next = this->Neighbours[n % this->Neighbours.size()];
      if (bridge != NoHop && this->Hops.Turn(from, bridge) < this->Hops.Turn(from, next))
      {
        break;
      }
      if (this->Index.Has(place + this->Hops.Offset(next)))
      {
        return { next, passedEast, passedWest };
      }
      passedEast = passedEast || next == this->East;
      passedWest = passedWest || next == this->West;
    }
    return { bridge, passedEast, passedWest };
  }

private:
  const ColumnIndex& Index;
  const HopVectors& Hops;
  const PatchBridges* const Bridges;
  const HopId East;
  const HopId West;
  std::array<HopId, 8> Neighbours;
  std::vector<std::size_t> After; // by hop: position in Neighbours of the next one in a sweep
};

// ---- The scan -------------------------------------------------------------------------------------------------------
// Finds all loops in one pass over the lattice if hops lead to neighbours (Suzuki and Abe, "Topological structural
// analysis of digitized binary images by border following", 1985). Where a row comes from outside to an unvisited
// point, the outline of a new patch is walked. The walk marks runs of adjacent points with the outside to their right,
// where rows leave the patch, and numbers runs with the outside to their left, where rows enter it. A hole is walked
// where a row first meets it, and its inside then counts as outside; without a loop it belongs to the patch, islands
// included.
//
//     . . # # # . .        The middle row enters the patch at its first point and leaves it at its second, which the
//     . . # . # . .        walk around the patch has marked. The empty column between them is in a hole.
//     . . # # # . .

/// Numbers the runs of adjacent points in rows, in their order. The index needs an empty rim.
class RunNumbers
{
public:
  explicit RunNumbers(const ColumnIndex& index)
    : Points(index.Occupied())
  {
    this->Before.reserve(std::size_t(index.NumberOfPlaces() / PlaceSet::WordBits + 1));
    for (std::int64_t place = 0; place < index.NumberOfPlaces(); place += PlaceSet::WordBits)
    {
      this->Before.push_back(this->Count);
      this->Count += std::uint32_t(CountBits(this->FirstPlaces(place)));
    }
  }

  std::size_t Size() const { return this->Count; }

  /// The place must have a point.
  std::size_t operator[](std::int64_t place) const
  {
    const std::uint64_t upTo = ~std::uint64_t(0) >> (PlaceSet::WordBits - 1 - place % PlaceSet::WordBits);
    return this->Before[std::size_t(place / PlaceSet::WordBits)] +
      std::size_t(CountBits(this->FirstPlaces(place) & upTo)) - 1;
  }

private:
  /// Returns the first places of runs, of 64 from the multiple of 64 at or below `place`.
  std::uint64_t FirstPlaces(std::int64_t place) const
  {
    const std::uint64_t word = this->Points.WordAt(place);
    const std::uint64_t wordBefore = this->Points.WordAt(place - PlaceSet::WordBits);
    return word & ~(word << 1U | wordBefore >> (PlaceSet::WordBits - 1));
  }

  const PlaceSet& Points;
  std::vector<std::uint32_t> Before; // number of runs before each 64 places
  std::uint32_t Count = 0;
};

class BorderScan
{
public:
  BorderScan(
    const ColumnIndex& index, const HopVectors& hops, const NeighbourGraph& graph, const BoundaryOptions& options)
    : Index(index)
    , Hops(hops)
    , HopGraph(graph)
    , Options(options)
    , West(hops.Find({ -1, 0 }))
    , East(hops.Find({ 1, 0 }))
    , Runs(index)
    , PatchOfRun(this->Runs.Size(), NoPatch)
    , OutsideEast(this->Runs.Size(), false)
    , FilledHoleEast(options.KeepHoles ? this->Runs.Size() : 0, false)
  {
    this->Result.Patches = PatchSpans(index.NumberOfPoints());
  }

  RowBoundary Run(const Monitor& monitor)
  {
    for (std::int64_t row = 0; row < this->Index.Height(); ++row)
    {
      if (row % 64 == 0)
      {
        monitor.Progress(double(row) / double(this->Index.Height()));
      }
      this->ScanRow(row * this->Index.Width(), (row + 1) * this->Index.Width());
    }
    this->Result.NumberOfPatches = this->Result.Boundary.Size();
    this->Result.PatchSizes = this->Result.Patches.CountPoints(this->Result.NumberOfPatches);
    for (std::size_t loop = 0; loop < this->HoleLoops.Size(); ++loop)
    {
      this->Result.Boundary.AppendLoop(this->HoleLoops, loop);
    }
    return std::move(this->Result);
  }

private:
  /// The outside can only begin beside an empty column.
  void ScanRow(std::int64_t first, std::int64_t end)
  {
    const auto point = [](std::uint64_t word, std::uint64_t) { return word; };
    const auto lastOfRun = [](std::uint64_t word, std::uint64_t east) { return word & ~east; };
    for (std::int64_t place = this->FindNext(first, end, point); place < end; place = this->FindNext(place, end, point))
    {
      if (this->PatchOfRun[this->Scanned] == NoPatch)
      {
        this->WalkOutline(place);
      }
      const std::int32_t inside = this->PatchOfRun[this->Scanned];
      this->Result.Patches.Append(PointId(this->Index.Rank(place)), inside);
      for (bool isInside = true; isInside; ++this->Scanned)
      {
        place = this->FindNext(place, end, lastOfRun);
        assert(place < end);
        isInside = !this->OutsideEast[this->Scanned] && !this->EntersHole(place, inside);
        ++place;
      }
    }
  }

  /// Returns the first place with a bit in bitsOf(64 places, the places east of them), or `end`.
  template <typename BitsOf>
  std::int64_t FindNext(std::int64_t place, std::int64_t end, BitsOf&& bitsOf) const
  {
    for (; place < end; place += PlaceSet::WordBits)
    {
      const PlaceSet::Window window = this->Index.Occupied().From(place);
      const std::uint64_t bits = bitsOf(std::uint64_t(window), std::uint64_t(window >> 1));
      if (bits != 0)
      {
        return std::min(place + LowestBit(bits), end);
      }
    }
    return end;
  }

  void WalkOutline(std::int64_t start)
  {
    this->Walk(start, this->West);
    this->MarkOutside(std::int32_t(this->Result.Boundary.Size()));
    AppendLoop(this->Hops, this->Steps, this->Result.Boundary);
  }

  /// Runs beside a hole without a loop are marked, so that it is walked once. So are islands in it: their outlines run
  /// clockwise and have no size.
  bool EntersHole(std::int64_t place, std::int32_t patch)
  {
    if (!this->Options.KeepHoles || this->FilledHoleEast[this->Scanned])
    {
      return false;
    }
    this->Walk(place, this->East);
    const std::int64_t size = ColumnsInside(this->Hops, this->Steps);
    const bool isKept = size > 0 && size >= this->Options.SmallestHoleSize;
    if (isKept)
    {
      this->MarkOutside(patch);
      AppendLoop(this->Hops, this->Steps, this->HoleLoops);
    }
    else
    {
      this->MarkEast(this->FilledHoleEast);
    }
    return isKept;
  }

  void Walk(std::int64_t start, HopId from)
  {
    this->PastEast.clear();
    this->PastWest.clear();
    const auto next = [this](std::int64_t place, HopId last)
    {
      const SweepResult result = this->HopGraph.Sweep(place, last);
      if (result.PassedEast)
      {
        this->PastEast.push_back(place);
      }
      if (result.PassedWest)
      {
        this->PastWest.push_back(place);
      }
      return result.Next;
    };
    WalkFace(this->Index, this->Hops, start, next(start, from), next, this->Steps);
  }

  void MarkOutside(std::int32_t patch)
  {
    this->MarkEast(this->OutsideEast);
    for (const std::int64_t place : this->PastWest)
    {
      this->PatchOfRun[this->Runs[place]] = patch;
    }
  }

  void MarkEast(std::vector<bool>& marks) const
  {
    for (const std::int64_t place : this->PastEast)
    {
      marks[this->Runs[place]] = true;
    }
  }

  const ColumnIndex& Index;
  const HopVectors& Hops;
  const NeighbourGraph& HopGraph;
  const BoundaryOptions& Options;
  const HopId West;
  const HopId East;
  const RunNumbers Runs;
  RowBoundary Result;
  Loops HoleLoops;
  std::size_t Scanned = 0; // number of runs
  std::vector<std::int32_t> PatchOfRun; // NoPatch unless a walk passed the left end of the run
  std::vector<bool> OutsideEast; // The outside of the patch begins to the right of the run.
  std::vector<bool> FilledHoleEast; // A hole without a loop begins to the right of the run.
  std::vector<FaceStep> Steps;
  std::vector<std::int64_t> PastEast;
  std::vector<std::int64_t> PastWest;
};

// ---- The boundary --------------------------------------------------------------------------------------------------
RowBoundary GrowByDistance(const ColumnIndex& index, const BoundaryOptions& options, const Monitor& monitor)
{
  BoundaryOptions allHoles = options;
  allHoles.SmallestHoleSize = 1;
  const HopVectors neighbours(1, index.Width());
  const NeighbourGraph parted(index, neighbours, nullptr);
  RowBoundary parts = BorderScan(index, neighbours, parted, allHoles).Run(monitor.Step(0.0, 0.4));
  const HopVectors hops(options.Radius, index.Width());
  const PatchBridges bridges(index, hops, parts);
  monitor.Progress(0.5);
  if (bridges.IsEmpty() && options.SmallestHoleSize <= 1)
  {
    return parts;
  }
  const NeighbourGraph bridged(index, hops, &bridges);
  return BorderScan(index, hops, bridged, options).Run(monitor.Step(0.5, 1.0));
}

/// Returns the new number of each patch, NoPatch below the minimum size.
std::vector<std::int32_t> NumberLargePatches(const std::vector<std::int64_t>& sizes, std::int64_t minimumSize)
{
  std::vector<std::int32_t> numbers;
  std::int32_t count = 0;
  for (const std::int64_t size : sizes)
  {
    numbers.push_back(size < minimumSize ? NoPatch : count++);
  }
  return numbers;
}

/// Returns the loops of the patches with a number.
template <typename PatchAt>
Loops SelectLoops(const Loops& all, const std::vector<std::int32_t>& numbers, PatchAt&& patchAt)
{
  Loops kept;
  for (std::size_t loop = 0; loop < all.Size(); ++loop)
  {
    if (numbers[patchAt(*all.begin(loop))] != NoPatch)
    {
      kept.AppendLoop(all, loop);
    }
  }
  return kept;
}

void DropSmallPatches(const ColumnIndex& index, std::int64_t minimumSize, RowBoundary& boundary)
{
  std::vector<std::int64_t>& sizes = boundary.PatchSizes;
  const std::vector<std::int32_t> numbers = NumberLargePatches(sizes, minimumSize);
  boundary.Boundary = SelectLoops(boundary.Boundary, numbers,
    [&](PointId point) { return boundary.Patches.PatchAt(PointId(index.Rank(index.PlaceOf(point)))); });
  boundary.Patches = boundary.Patches.Renumbered(numbers);
  sizes.erase(
    std::remove_if(sizes.begin(), sizes.end(), [&](std::int64_t size) { return size < minimumSize; }), sizes.end());
  boundary.NumberOfPatches = sizes.size();
}

void DropSmallPatches(std::int64_t minimumSize, ExteriorBoundary& boundary)
{
  std::vector<std::int64_t> sizes(boundary.NumberOfPatches, 0);
  for (const std::int32_t patch : boundary.Patch)
  {
    ++sizes[patch];
  }
  const std::vector<std::int32_t> numbers = NumberLargePatches(sizes, minimumSize);
  boundary.Boundary = SelectLoops(boundary.Boundary, numbers, [&](PointId point) { return boundary.Patch[point]; });
  for (std::int32_t& patch : boundary.Patch)
  {
    patch = numbers[patch];
  }
  boundary.NumberOfPatches -= std::size_t(std::count(numbers.begin(), numbers.end(), NoPatch));
}

/// All hops lead to neighbours, or are bridges between patches of these.
RowBoundary FindByNeighbours(const ColumnIndex& index, const BoundaryOptions& options, const Monitor& monitor)
{
  const HopVectors hops(1, index.Width());
  RowBoundary result = options.Radius > 1
    ? GrowByDistance(index, options, monitor)
    : BorderScan(index, hops, NeighbourGraph(index, hops, nullptr), options).Run(monitor);
  if (options.MinimumPatchSize > 1)
  {
    DropSmallPatches(index, options.MinimumPatchSize, result);
  }
  return result;
}

ExteriorBoundary FindByPlanarHops(const ColumnIndex& index, const BoundaryOptions& options, const Monitor& monitor)
{
  FaceFinder finder(index, options, monitor.Step(0.0, 0.5));
  std::vector<CrackSide> cracks = finder.FindCrackSides();
  ExteriorBoundary result = finder.Run(monitor.Step(0.5, 1.0));
  if (options.MinimumPatchSize > 1)
  {
    DropSmallPatches(options.MinimumPatchSize, result);
  }
  result.OpenCracks = FindCracks(std::move(cracks), result.Boundary, result.Patch);
  return result;
}

void CheckCuts(const BoundaryOptions& options)
{
  if (options.Cuts && options.Growth == GrowthStrategy::Distance && options.Radius > 1)
  {
    throw InputError("faulted links and growth by distance with a radius of " + std::to_string(options.Radius) +
      " columns, expected clockwise growth, or a radius of 1");
  }
}

void CheckBoundaryOptions(const BoundaryOptions& options)
{
  CheckWithin("radius", options.Radius, 1, LargestRadius, " columns");
  CheckAtLeast<std::int64_t>("smallest hole size", options.SmallestHoleSize, 1, " column");
  CheckAtLeast<std::int64_t>("minimum patch size", options.MinimumPatchSize, 1, " point");
  CheckCuts(options);
}

void CheckRowOptions(const BoundaryOptions& options)
{
  if (options.Radius > 1)
  {
    throw InputError("a radius of " + std::to_string(options.Radius) +
      " columns for a horizon that is larger than memory, expected 1");
  }
  if (options.Cuts)
  {
    throw InputError("faulted links for a horizon that is larger than memory, expected none");
  }
}

std::vector<BoundaryKind> MarkLoops(const ExteriorBoundary& boundary)
{
  std::vector<BoundaryKind> marks(boundary.Patch.size(), BoundaryKind::Inside);
  // Holes come first, so that a point on loops of both kinds counts as exterior.
  for (std::size_t loop = boundary.Boundary.Size(); loop-- > 0;)
  {
    const BoundaryKind kind = loop < boundary.NumberOfPatches ? BoundaryKind::Exterior : BoundaryKind::Hole;
    std::for_each(
      boundary.Boundary.begin(loop), boundary.Boundary.end(loop), [&](PointId point) { marks[point] = kind; });
  }
  return marks;
}

/// A point on no loop is classified like the points that share the empty column at its corner.
BoundaryKind KindOfCorner(const ColumnIndex& index, const std::vector<BoundaryKind>& marks, std::int64_t place)
{
  const std::int64_t up = index.Width();
  BoundaryKind kind = BoundaryKind::Inside;
  for (const std::int64_t aside : { std::int64_t(-1), std::int64_t(1) })
  {
    for (const std::int64_t upright : { -up, up })
    {
      if (index.Has(place + aside + upright))
      {
        continue;
      }
      for (const std::int64_t beside : { place + aside, place + upright })
      {
        const BoundaryKind other = marks[index[beside]];
        kind = kind == BoundaryKind::Exterior ? kind : other;
      }
    }
  }
  return kind;
}

void MarkCorners(const ColumnIndex& index, const std::vector<std::int32_t>& patches, std::vector<BoundaryKind>& marks)
{
  const std::vector<BoundaryKind> loops = marks;
  const PlanePoints columns = index.Columns();
  for (std::size_t point = 0; point < columns.size(); ++point)
  {
    if (loops[point] == BoundaryKind::Inside && patches[point] != NoPatch)
    {
      marks[point] = KindOfCorner(index, loops, index.Place(columns[point]));
    }
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
ColumnIndex IndexForBoundary(PlanePoints columns, const BoundaryOptions& options)
{
  CheckBoundaryOptions(options);
  // Cuts refer to columns by position, so that empty bands must not be removed.
  return ColumnIndex(columns, 2 * options.Radius, options.Cuts ? ColumnIndex::AllBands : ColumnIndex::LongestReach);
}

//----------------------------------------------------------------------------------------------------------------------
ExteriorBoundary FindExteriorBoundary([[maybe_unused]] PlanePoints columns, const ColumnIndex& index,
  const BoundaryOptions& options, const Monitor& monitor)
{
  CheckBoundaryOptions(options);
  assert(columns.size() == index.Columns().size());
  if (options.Cuts || (options.Radius > 1 && options.Growth == GrowthStrategy::Clockwise))
  {
    return FindByPlanarHops(index, options, monitor);
  }
  RowBoundary found = FindByNeighbours(index, options, monitor);
  return { std::move(found.Boundary), ListPatches(index, found.Patches), found.NumberOfPatches, {} };
}

//----------------------------------------------------------------------------------------------------------------------
RowBoundary FindExteriorBoundary(const ColumnIndex& index, const BoundaryOptions& options, const Monitor& monitor)
{
  CheckBoundaryOptions(options);
  CheckRowOptions(options);
  assert(index.IsRowMajor());
  return FindByNeighbours(index, options, monitor);
}

//----------------------------------------------------------------------------------------------------------------------
ExteriorBoundary FindExteriorBoundary(PlanePoints columns, const BoundaryOptions& options, const Monitor& monitor)
{
  return FindExteriorBoundary(columns, IndexForBoundary(columns, options), options, monitor);
}

//----------------------------------------------------------------------------------------------------------------------
KeptPoints DropPointsWithoutPatch(ExteriorBoundary& boundary)
{
  const auto kept =
    KeptPoints::If(boundary.Patch.size(), [&](std::size_t point) { return boundary.Patch[point] != NoPatch; });
  if (!kept.AreAll())
  {
    const std::vector<PointId> numbers = kept.Numbers();
    boundary.Boundary = boundary.Boundary.Renumbered(numbers);
    for (Edge& openEnd : boundary.OpenCracks.OpenEnds)
    {
      openEnd = { numbers[openEnd.From], numbers[openEnd.To] };
    }
    boundary.Patch = kept.Select(boundary.Patch);
  }
  return kept;
}

//----------------------------------------------------------------------------------------------------------------------
BoundaryOptions OptionsFor(BoundaryType type, const BoundaryOptions& options)
{
  BoundaryOptions result = options;
  if (type != BoundaryType::Exterior)
  {
    result.Radius = 1;
    result.KeepHoles = true;
    result.SmallestHoleSize = 1;
  }
  return result;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<BoundaryKind> MarkBoundary(BoundaryType type, PlanePoints columns, const ExteriorBoundary& boundary)
{
  std::vector<BoundaryKind> marks = MarkLoops(boundary);
  if (type == BoundaryType::Topological8)
  {
    MarkCorners(ColumnIndex(columns, 1, 1), boundary.Patch, marks);
  }
  return marks;
}
}
