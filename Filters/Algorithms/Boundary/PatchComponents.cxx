// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Points of a run follow each other by hops. Each column from k before a run to k after it is at most k columns from a
// point of the run, so that two runs in rows at most k apart are connected if one of them, extended by k, overlaps the
// other.
//
// A component is inside a loop if its first point is. Rows with first points are scanned from left to right, while the
// scan tracks the loops that it enters and leaves.

#include "PatchComponents.h"

#include "Common/Base/DisjointSets.h"
#include "ExteriorBoundary.h"
#include "Hops.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <tuple>
#include <utility>

namespace SeismicHorizons
{
namespace
{
struct PointRun
{
  std::int32_t First;
  std::int32_t Last;
};

/// The sets have the numbers of the runs, which begin at `a` and at `b` in two rows.
void JoinRows(
  const std::vector<PointRun>& runs, std::size_t a, std::size_t endOfA, std::size_t b, int radius, DisjointSets& sets)
{
  while (a < endOfA && b < runs.size())
  {
    if (runs[a].First <= runs[b].Last + radius && runs[b].First <= runs[a].Last + radius)
    {
      sets.Join(std::int32_t(a), std::int32_t(b));
    }
    // The next run of the other row begins more than k columns after the run that ends first.
    ++(runs[a].Last < runs[b].Last ? a : b);
  }
}

/// Numbers sets in the order of calls.
std::int32_t ComponentOf(
  std::int32_t set, std::int64_t place, std::vector<std::int32_t>& numbers, PatchComponents& result)
{
  std::int32_t& component = numbers[set];
  if (component < 0)
  {
    component = std::int32_t(result.First.size());
    result.First.push_back(place);
  }
  return component;
}

struct HopCrossing
{
  double X;
  std::size_t Loop;
};

void EnterOrLeave(std::vector<std::size_t>& around, std::size_t loop)
{
  const auto found = std::find(around.begin(), around.end(), loop);
  if (found == around.end())
  {
    around.push_back(loop);
  }
  else
  {
    around.erase(found);
  }
}

/// Outlines and holes alternate from outside to inside, once outlines of islands of other patches are ignored.
std::int32_t InnermostPatch(const std::vector<std::size_t>& around, const std::vector<std::int32_t>& patchOf)
{
  std::int32_t innermost = -1;
  std::size_t outlines = 0;
  std::size_t holes = 0;
  for (const std::size_t loop : around)
  {
    const bool isHole = loop >= patchOf.size();
    holes += isHole ? 1 : 0;
    if (!isHole && patchOf[loop] == std::int32_t(loop))
    {
      ++outlines;
      innermost = std::max(innermost, std::int32_t(loop));
    }
  }
  return outlines > holes ? innermost : -1;
}
}

//----------------------------------------------------------------------------------------------------------------------
PatchComponents FindPatchComponents(const ColumnIndex& index, std::size_t points, int radius)
{
  assert(radius >= 1);
  std::vector<PointRun> runs;
  std::vector<std::size_t> rowEnds(1, 0);
  DisjointSets sets; // of runs
  for (std::int64_t row = 0; row < index.Height(); ++row)
  {
    const std::int64_t first = row * index.Width();
    index.ForEachPoint(first, first + index.Width(),
      [&](std::int64_t place, PointId)
      {
        const auto x = std::int32_t(place - first);
        if (runs.size() > rowEnds.back() && x - runs.back().Last <= radius)
        {
          runs.back().Last = x;
        }
        else
        {
          runs.push_back({ x, x });
          sets.Add();
        }
      });
    for (std::int64_t below = std::max<std::int64_t>(0, row - radius); below < row; ++below)
    {
      JoinRows(runs, rowEnds[below], rowEnds[below + 1], rowEnds.back(), radius, sets);
    }
    rowEnds.push_back(runs.size());
  }
  PatchComponents result;
  result.Component.resize(points, -1);
  std::vector<std::int32_t> numbers(runs.size(), -1);
  for (std::int64_t row = 0; row < index.Height(); ++row)
  {
    for (std::size_t run = rowEnds[row]; run < rowEnds[row + 1]; ++run)
    {
      const std::int64_t first = row * index.Width() + runs[run].First;
      const std::int32_t component = ComponentOf(sets.Find(std::int32_t(run)), first, numbers, result);
      index.ForEachPoint(first, row * index.Width() + runs[run].Last + 1,
        [&](std::int64_t, PointId point) { result.Component[point] = component; });
    }
  }
  return result;
}

//----------------------------------------------------------------------------------------------------------------------
PatchComponents FindHopComponents(
  const ColumnIndex& index, std::size_t points, const HopVectors& hops, const PlanarHops& graph)
{
  DisjointSets sets(points);
  index.ForEachPoint(0, index.NumberOfPlaces(),
    [&](std::int64_t place, PointId point)
    {
      graph.ForEachConnection(
        place, [&](HopId hop) { sets.Join(std::int32_t(point), std::int32_t(index[place + hops.Offset(hop)])); });
    });
  PatchComponents result;
  result.Component.resize(points);
  std::vector<std::int32_t> numbers(points, -1);
  index.ForEachPoint(0, index.NumberOfPlaces(),
    [&](std::int64_t place, PointId point)
    { result.Component[point] = ComponentOf(sets.Find(std::int32_t(point)), place, numbers, result); });
  return result;
}

//----------------------------------------------------------------------------------------------------------------------
// The hop that continues at the upper end adds the crossing of that row. Rounding is harmless, as hops miss points by at
// least 1 / k columns.
void ForEachPlaceInLoops(PlanePoints columns, const ColumnIndex& index, const std::vector<std::int64_t>& places,
  const Loops& loops, const std::function<void(std::size_t, const std::vector<std::size_t>&)>& visit)
{
  assert(std::is_sorted(places.begin(), places.end()));
  const std::int64_t width = index.Width();
  std::vector<bool> hasPlace(std::size_t(index.Height()), false); // by row
  for (const std::int64_t place : places)
  {
    hasPlace[place / width] = true;
  }
  std::vector<std::vector<HopCrossing>> crossings(hasPlace.size());
  for (std::size_t loop = 0; loop < loops.Size(); ++loop)
  {
    loops.ForEachEdgeOf(loop,
      [&](PointId from, PointId to)
      {
        const auto [low, high] = std::minmax({ index.Place(columns[from]), index.Place(columns[to]) });
        const std::int64_t lowRow = low / width;
        const std::int64_t rows = std::max<std::int64_t>(1, high / width - lowRow);
        const double slope = double(high % width - low % width) / double(rows);
        for (std::int64_t row = lowRow; row < high / width; ++row)
        {
          if (hasPlace[row])
          {
            crossings[row].push_back({ double(low % width) + slope * double(row - lowRow), loop });
          }
        }
      });
  }
  for (std::size_t n = 0; n < places.size();)
  {
    const std::int64_t row = places[n] / width;
    std::vector<HopCrossing>& ofRow = crossings[row];
    std::sort(ofRow.begin(), ofRow.end(), [](const HopCrossing& a, const HopCrossing& b) { return a.X < b.X; });
    std::vector<std::size_t> around;
    auto next = ofRow.begin();
    for (; n < places.size() && places[n] / width == row; ++n)
    {
      for (; next != ofRow.end() && next->X < double(places[n] % width); ++next)
      {
        EnterOrLeave(around, next->Loop);
      }
      visit(n, around);
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
// Components are numbered from below, so that each follows the component around it, and nested islands follow both.
std::vector<std::int32_t> AssignIslands(
  PlanePoints columns, const ColumnIndex& index, const std::vector<std::int64_t>& first, const Loops& loops)
{
  std::vector<std::int32_t> patchOf(first.size());
  std::iota(patchOf.begin(), patchOf.end(), 0);
  if (first.size() > 1)
  {
    ForEachPlaceInLoops(columns, index, first, loops,
      [&patchOf](std::size_t part, const std::vector<std::size_t>& around)
      {
        const std::int32_t patch = InnermostPatch(around, patchOf);
        patchOf[part] = patch < 0 ? std::int32_t(part) : patch;
      });
  }
  return patchOf;
}

// ---- Faces at cuts --------------------------------------------------------------------------------------------------

namespace
{
/// Admissible hops and hops across cuts form one plane graph.
class WholeGraph
{
public:
  static constexpr std::size_t None = static_cast<std::size_t>(-1);

  WholeGraph(const HopVectors& hops, const PlanarHops& graph)
    : Hops(hops)
    , Graph(graph)
    , Across(graph.HopsAcrossCuts())
  {
  }

  HopId Next(std::int64_t place, HopId from) const
  {
    const HopId admissible = this->Graph.Next(place, from);
    const HopId across = this->NextAcross(place, from);
    if (admissible == NoHop || across == NoHop)
    {
      return admissible == NoHop ? across : admissible;
    }
    return this->Hops.Turn(from, across) < this->Hops.Turn(from, admissible) ? across : admissible;
  }

  std::size_t NumberOf(std::int64_t place, HopId hop) const
  {
    const auto found = std::lower_bound(this->Across.begin(), this->Across.end(), HopAcrossCut{ place, hop });
    const bool isThere = found != this->Across.end() && found->Place == place && found->Hop == hop;
    return isThere ? std::size_t(found - this->Across.begin()) : None;
  }

private:
  HopId NextAcross(std::int64_t place, HopId from) const
  {
    const auto first = std::lower_bound(this->Across.begin(), this->Across.end(), HopAcrossCut{ place, 0 });
    const auto last = std::lower_bound(first, this->Across.end(), HopAcrossCut{ place + 1, 0 });
    const auto next = std::upper_bound(first, last, HopAcrossCut{ place, from });
    return next != last ? next->Hop : first != last ? first->Hop : NoHop;
  }

  const HopVectors& Hops;
  const PlanarHops& Graph;
  const std::vector<HopAcrossCut>& Across;
};

/// The columns inside hold no points, since a hop would connect a point to the face.
bool IsCrack(const HopVectors& hops, const std::vector<FaceStep>& steps)
{
  const std::int64_t most = std::int64_t(hops.Radius() - 1) * (hops.Radius() - 1);
  return MeasureFace(hops, steps).TwiceArea > 0 && ColumnsInside(hops, steps) <= most;
}

bool IsCrackBefore(const CrackSide& a, const CrackSide& b)
{
  return std::tie(a.From, a.To) < std::tie(b.From, b.To);
}

/// Sides must be sorted by IsCrackBefore(). Any side from the point will do without an end.
const CrackSide* FindSide(const std::vector<CrackSide>& sides, PointId from, PointId to = NoPoint)
{
  const auto found =
    std::lower_bound(sides.begin(), sides.end(), CrackSide{ from, to, 0, CrackSide::Kind::Cutoff }, IsCrackBefore);
  const bool isFound = found != sides.end() && found->From == from && (to == NoPoint || found->To == to);
  return isFound ? &*found : nullptr;
}

template <typename Condition>
void KeepFaces(std::vector<CrackSide>& sides, Condition&& condition)
{
  sides.erase(std::remove_if(sides.begin(), sides.end(), [&](const CrackSide& side) { return !condition(side.Face); }),
    sides.end());
}

/// A loop of one point has no edges; any side that begins at the point represents it.
template <typename Visitor>
void ForEachSideOnLoops(const std::vector<CrackSide>& sides, const Loops& boundary, Visitor&& visit)
{
  for (std::size_t loop = 0; loop < boundary.Size(); ++loop)
  {
    const auto visitIfThere = [&](const CrackSide* side) { side ? visit(loop, *side) : void(); };
    if (boundary.Length(loop) == 1)
    {
      visitIfThere(FindSide(sides, *boundary.begin(loop)));
    }
    boundary.ForEachEdgeOf(loop, [&](PointId from, PointId to) { visitIfThere(FindSide(sides, from, to)); });
  }
}

/// The two faces along a hop across a cut are open or covered together. A face is open if a loop runs along it or if it
/// has a short hop across a cut.
void KeepOpen(std::vector<CrackSide>& sides, const Loops& boundary, std::int32_t faces)
{
  DisjointSets regions{ std::size_t(faces) };
  std::vector<bool> isOpen(std::size_t(faces), false);
  ForEachSideOnLoops(sides, boundary, [&](std::size_t, const CrackSide& side) { isOpen[side.Face] = true; });
  for (const CrackSide& side : sides)
  {
    const CrackSide* const beyond =
      side.What == CrackSide::Kind::Cutoff ? nullptr : FindSide(sides, side.To, side.From);
    if (beyond)
    {
      regions.Join(side.Face, beyond->Face);
    }
    if (side.What == CrackSide::Kind::Short)
    {
      isOpen[side.Face] = true;
    }
  }
  std::vector<bool> isRegionOpen(std::size_t(faces), false);
  for (std::int32_t face = 0; face < faces; ++face)
  {
    const std::size_t region = std::size_t(regions.Find(face));
    isRegionOpen[region] = isRegionOpen[region] || isOpen[face];
  }
  KeepFaces(sides, [&](std::int32_t face) { return isRegionOpen[regions.Find(face)]; });
}
}

//----------------------------------------------------------------------------------------------------------------------
CutFaces::CutFaces(PlanePoints columns, const ColumnIndex& index, const HopVectors& hops, const CutBlocks& blocks)
  : Columns(columns)
  , Index(index)
  , Hops(hops)
  , Blocks(blocks)
  , Sides({ hops.Find({ 1, 0 }), hops.Find({ 0, 1 }), hops.Find({ -1, 0 }), hops.Find({ 0, -1 }) })
{
}

//----------------------------------------------------------------------------------------------------------------------
void CutFaces::AddOutline(const std::vector<FaceStep>& steps)
{
  if (this->PassesCut(steps))
  {
    this->CutOutlines.push_back(this->Faces.size());
  }
  this->Faces.push_back({ -MeasureFace(this->Hops, steps).TwiceArea, true });
}

//----------------------------------------------------------------------------------------------------------------------
bool CutFaces::AddHole(const std::vector<FaceStep>& steps, bool hasLoop, bool hasColumns)
{
  const bool stays = hasLoop || this->PassesCut(steps);
  if (stays || hasColumns)
  {
    this->Faces.push_back({ MeasureFace(this->Hops, steps).TwiceArea, stays });
  }
  return stays || hasColumns;
}

//----------------------------------------------------------------------------------------------------------------------
bool CutFaces::PassesCut(const std::vector<FaceStep>& steps) const
{
  HopId from = steps.back().Hop == NoHop ? this->Hops.Size() - 1 : this->Hops.Opposite(steps.back().Hop);
  for (const FaceStep& step : steps)
  {
    const std::int64_t place = this->Index.Place(this->Columns[step.Point]);
    if (this->Blocks.IsBesideOpen(place))
    {
      const HopId to = step.Hop == NoHop ? from : step.Hop;
      const auto isPassed = [&](HopId side)
      {
        return this->Blocks.IsBarred(place, this->Hops.Vector(side)) &&
          (side == from || this->Hops.Turn(from, side) < this->Hops.Turn(from, to));
      };
      if (std::any_of(this->Sides.begin(), this->Sides.end(), isPassed))
      {
        return true;
      }
    }
    from = step.Hop == NoHop ? from : this->Hops.Opposite(step.Hop);
  }
  return false;
}

//----------------------------------------------------------------------------------------------------------------------
// The cuts that an outline passes lie in the hole around its component. No walk passes cuts between empty columns.
std::vector<std::int64_t> CutFaces::PlacesInOpenFaces(const std::vector<std::int64_t>& first) const
{
  std::vector<std::int64_t> places;
  for (const std::size_t outline : this->CutOutlines)
  {
    places.push_back(first[outline]);
  }
  const std::int64_t end = this->Index.NumberOfPlaces();
  const auto isEmpty = [this](std::int64_t place) { return !this->Index.Has(place); };
  for (std::int64_t place = 0; place < end; ++place)
  {
    if (isEmpty(place) && this->Blocks.IsBesideOpen(place) &&
      ((this->Blocks.IsBarred(place, { 1, 0 }) && isEmpty(place + 1)) ||
        (this->Blocks.IsBarred(place, { 0, 1 }) && isEmpty(place + this->Index.Width()))))
    {
      places.push_back(place);
    }
  }
  std::sort(places.begin(), places.end());
  return places;
}

//----------------------------------------------------------------------------------------------------------------------
Loops CutFaces::Select(const Loops& loops, const std::vector<std::int64_t>& first)
{
  // The innermost loop has the least area. A hole inside an outline of the same area has the greater number.
  const auto isFartherOut = [this](std::size_t a, std::size_t b)
  {
    const std::int64_t areaA = this->Faces[a].TwiceArea;
    const std::int64_t areaB = this->Faces[b].TwiceArea;
    return areaA != areaB ? areaA > areaB : a < b;
  };
  ForEachPlaceInLoops(this->Columns, this->Index, this->PlacesInOpenFaces(first), loops,
    [&](std::size_t, const std::vector<std::size_t>& around)
    {
      if (!around.empty())
      {
        this->Faces[*std::max_element(around.begin(), around.end(), isFartherOut)].Stays = true;
      }
    });
  Loops result;
  for (std::size_t loop = 0; loop < loops.Size(); ++loop)
  {
    if (this->Faces[loop].Stays)
    {
      result.AppendLoop(loops, loop);
    }
  }
  return result;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<CrackSide> FindCrackFaces(
  PlanePoints columns, const ColumnIndex& index, const HopVectors& hops, const PlanarHops& graph)
{
  const WholeGraph whole(hops, graph);
  const std::vector<HopAcrossCut>& across = graph.HopsAcrossCuts();
  const auto next = [&whole](std::int64_t place, HopId from) { return whole.Next(place, from); };
  std::vector<bool> walked(across.size(), false);
  std::vector<CrackSide> sides;
  std::vector<FaceStep> steps;
  std::int32_t faces = 0;
  for (std::size_t first = 0; first < across.size(); ++first)
  {
    if (walked[first])
    {
      continue;
    }
    WalkFace(index, hops, across[first].Place, across[first].Hop, next, steps);
    const bool isCrack = IsCrack(hops, steps);
    for (std::size_t n = 0; n < steps.size(); ++n)
    {
      const FaceStep& step = steps[n];
      const std::size_t number = whole.NumberOf(index.Place(columns[step.Point]), step.Hop);
      CrackSide::Kind kind = CrackSide::Kind::Cutoff;
      if (number != WholeGraph::None)
      {
        walked[number] = true;
        kind = ChebyshevLength(hops.Vector(step.Hop)) == 1 ? CrackSide::Kind::Short : CrackSide::Kind::Long;
      }
      if (isCrack)
      {
        sides.push_back({ step.Point, steps[(n + 1) % steps.size()].Point, faces, kind });
      }
    }
    faces += isCrack ? 1 : 0;
  }
  return sides;
}

//----------------------------------------------------------------------------------------------------------------------
Cracks FindCracks(std::vector<CrackSide> sides, const Loops& boundary, const std::vector<std::int32_t>& patches)
{
  const std::int32_t faces = sides.empty() ? 0 : sides.back().Face + 1;
  std::vector<bool> isWhole(std::size_t(faces), true);
  for (const CrackSide& side : sides)
  {
    isWhole[side.Face] = isWhole[side.Face] && patches[side.From] != NoPatch;
  }
  std::sort(sides.begin(), sides.end(), IsCrackBefore);
  KeepFaces(sides, [&isWhole](std::int32_t face) { return isWhole[face]; });
  KeepOpen(sides, boundary, faces);
  Cracks cracks;
  for (const CrackSide& side : sides)
  {
    if (side.What != CrackSide::Kind::Cutoff && !FindSide(sides, side.To, side.From))
    {
      cracks.OpenEnds.push_back({ side.From, side.To });
    }
  }
  std::vector<std::size_t> cutoffs(boundary.Size(), 0);
  ForEachSideOnLoops(sides, boundary, [&cutoffs](std::size_t loop, const CrackSide&) { ++cutoffs[loop]; });
  for (std::size_t loop = 0; loop < boundary.Size(); ++loop)
  {
    if (cutoffs[loop] == boundary.Length(loop))
    {
      cracks.Loops.push_back(loop);
    }
  }
  return cracks;
}
}
