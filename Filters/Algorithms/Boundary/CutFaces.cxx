// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CutFaces.h"

#include "Common/Base/DisjointSets.h"
#include "ExteriorBoundary.h"
#include "Hops.h"
#include "PatchComponents.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace SeismicHorizons
{
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
    return this->Turn(from, across) < this->Turn(from, admissible) ? across : admissible;
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

  HopId Turn(HopId from, HopId to) const { return (to - from - 1 + this->Hops.Size()) % this->Hops.Size(); }

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

class SideTable
{
public:
  explicit SideTable(std::vector<CrackSide> sides)
    : Sides(std::move(sides))
  {
    std::sort(this->Sides.begin(), this->Sides.end(), IsCrackBefore);
  }

  const CrackSide* Find(PointId from, PointId to) const
  {
    const auto found = std::lower_bound(
      this->Sides.begin(), this->Sides.end(), CrackSide{ from, to, 0, CrackSide::Kind::Cutoff }, IsCrackBefore);
    return found != this->Sides.end() && found->From == from && found->To == to ? &*found : nullptr;
  }

  const CrackSide* FindFrom(PointId from) const
  {
    const auto found = std::lower_bound(
      this->Sides.begin(), this->Sides.end(), CrackSide{ from, 0, 0, CrackSide::Kind::Cutoff }, IsCrackBefore);
    return found != this->Sides.end() && found->From == from ? &*found : nullptr;
  }

  template <typename Condition>
  void KeepIf(Condition&& condition)
  {
    this->Sides.erase(std::remove_if(this->Sides.begin(), this->Sides.end(),
                        [&](const CrackSide& side) { return !condition(side.Face); }),
      this->Sides.end());
  }

  const std::vector<CrackSide>& All() const { return this->Sides; }

private:
  std::vector<CrackSide> Sides;
};

/// A loop of one point has no edges; any side that begins at the point represents it.
template <typename Visitor>
void ForEachSideOnLoops(const SideTable& sides, const Loops& boundary, Visitor&& visit)
{
  for (std::size_t loop = 0; loop < boundary.Size(); ++loop)
  {
    const auto visitIfThere = [&](const CrackSide* side) { side ? visit(loop, *side) : void(); };
    if (boundary.Length(loop) == 1)
    {
      visitIfThere(sides.FindFrom(*boundary.begin(loop)));
    }
    boundary.ForEachEdgeOf(loop, [&](PointId from, PointId to) { visitIfThere(sides.Find(from, to)); });
  }
}

/// The two faces along a hop across a cut are open or covered together. A face is open if a loop runs along it or if it
/// has a short hop across a cut.
void KeepOpen(SideTable& sides, const Loops& boundary, std::int32_t faces)
{
  DisjointSets regions{ std::size_t(faces) };
  std::vector<bool> isOpen(std::size_t(faces), false);
  ForEachSideOnLoops(sides, boundary, [&](std::size_t, const CrackSide& side) { isOpen[side.Face] = true; });
  for (const CrackSide& side : sides.All())
  {
    const CrackSide* const beyond = side.What == CrackSide::Kind::Cutoff ? nullptr : sides.Find(side.To, side.From);
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
  sides.KeepIf([&](std::int32_t face) { return isRegionOpen[regions.Find(face)]; });
}
}

//----------------------------------------------------------------------------------------------------------------------
PatchComponents FindHopComponents(
  PlanePoints columns, const ColumnIndex& index, const HopVectors& hops, const PlanarHops& graph)
{
  DisjointSets sets(columns.size());
  for (std::size_t point = 0; point < columns.size(); ++point)
  {
    const std::int64_t place = index.Place(columns[point]);
    graph.ForEachConnection(
      place, [&](HopId hop) { sets.Join(std::int32_t(point), std::int32_t(index[place + hops.Offset(hop)])); });
  }
  PatchComponents result;
  result.Component.resize(columns.size());
  std::vector<std::int32_t> number(columns.size(), -1);
  for (std::int64_t place = 0; place < index.Width() * index.Height(); ++place)
  {
    const PointId point = index[place];
    if (point == NoPoint)
    {
      continue;
    }
    std::int32_t& component = number[sets.Find(std::int32_t(point))];
    if (component < 0)
    {
      component = std::int32_t(result.First.size());
      result.First.push_back(place);
    }
    result.Component[point] = component;
  }
  return result;
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
      { return this->Blocks.IsBarred(place, this->Hops.Vector(side)) && this->IsSwept(side, from, to); };
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
// A turn of 0 is a full turn: the point has only one hop.
bool CutFaces::IsSwept(HopId hop, HopId from, HopId to) const
{
  const HopId size = this->Hops.Size();
  const HopId turn = (to - from + size) % size;
  return turn == 0 || (hop - from + size) % size < turn;
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
  const std::int64_t end = this->Index.Width() * this->Index.Height();
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
  SideTable table(std::move(sides));
  table.KeepIf([&isWhole](std::int32_t face) { return isWhole[face]; });
  KeepOpen(table, boundary, faces);
  Cracks cracks;
  for (const CrackSide& side : table.All())
  {
    if (side.What != CrackSide::Kind::Cutoff && !table.Find(side.To, side.From))
    {
      cracks.OpenEnds.push_back({ side.From, side.To });
    }
  }
  std::vector<std::size_t> cutoffs(boundary.Size(), 0);
  ForEachSideOnLoops(table, boundary, [&cutoffs](std::size_t loop, const CrackSide&) { ++cutoffs[loop]; });
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
