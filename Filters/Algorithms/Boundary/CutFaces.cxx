// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CutFaces.h"

#include "Common/DisjointSets.h"
#include "Islands.h"

#include <algorithm>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
PatchComponents FindHopComponents(
  const std::vector<PlanePoint>& columns, const ColumnRaster& raster, const HopVectors& hops, const PlanarHops& graph)
{
  DisjointSets sets(columns.size());
  for (std::size_t point = 0; point < columns.size(); ++point)
  {
    const std::int64_t place = raster.Place(columns[point]);
    graph.ForEachConnection(
      place, [&](HopId hop) { sets.Join(std::int32_t(point), std::int32_t(raster[place + hops.Offset(hop)])); });
  }
  PatchComponents result;
  result.Component.resize(columns.size());
  std::vector<std::int32_t> number(columns.size(), -1);
  for (std::int64_t place = 0; place < raster.Width() * raster.Height(); ++place)
  {
    const PointId point = raster[place];
    if (point == NoPoint)
    {
      continue;
    }
    std::int32_t& component = number[std::size_t(sets.Find(std::int32_t(point)))];
    if (component < 0)
    {
      component = std::int32_t(result.First.size());
      result.First.push_back(place);
    }
    result.Component[std::size_t(point)] = component;
  }
  return result;
}

//----------------------------------------------------------------------------------------------------------------------
CutFaces::CutFaces(
  const std::vector<PlanePoint>& columns, const ColumnRaster& raster, const HopVectors& hops, const CutBlocks& blocks)
  : Columns(columns)
  , Raster(raster)
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
// Whether a sweep of a walk passes a cut link.
bool CutFaces::PassesCut(const std::vector<FaceStep>& steps) const
{
  HopId from = steps.back().Hop == NoHop ? this->Hops.Size() - 1 : this->Hops.Opposite(steps.back().Hop);
  for (const FaceStep& step : steps)
  {
    const std::int64_t place = this->Raster.Place(this->Columns[std::size_t(step.Point)]);
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
// Whether a clockwise sweep from one hop to the next one meets a hop that the graph has not: a full turn when there is
// one hop only.
bool CutFaces::IsSwept(HopId hop, HopId from, HopId to) const
{
  const HopId size = this->Hops.Size();
  const HopId turn = (to - from + size) % size;
  return turn == 0 || (hop - from + size) % size < turn;
}

//----------------------------------------------------------------------------------------------------------------------
// A place in every hole that holds cuts which no walk around it passes, row by row.
std::vector<std::int64_t> CutFaces::PlacesInOpenFaces(const std::vector<std::int64_t>& first) const
{
  std::vector<std::int64_t> places;
  for (const std::size_t outline : this->CutOutlines)
  {
    places.push_back(first[outline]);
  }
  const std::int64_t end = this->Raster.Width() * this->Raster.Height();
  const auto isEmpty = [this](std::int64_t place) { return this->Raster[place] == NoPoint; };
  for (std::int64_t place = 0; place < end; ++place)
  {
    if (isEmpty(place) && this->Blocks.IsBesideOpen(place) &&
      ((this->Blocks.IsBarred(place, { 1, 0 }) && isEmpty(place + 1)) ||
        (this->Blocks.IsBarred(place, { 0, 1 }) && isEmpty(place + this->Raster.Width()))))
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
  // Of loops around a place that of the least area is innermost; where an outline and a hole have the same one, the
  // hole, which has the greater number.
  const auto isFartherOut = [this](std::size_t a, std::size_t b)
  {
    const std::int64_t areaA = this->Faces[a].TwiceArea;
    const std::int64_t areaB = this->Faces[b].TwiceArea;
    return areaA != areaB ? areaA > areaB : a < b;
  };
  ForEachPlaceInLoops(this->Columns, this->Raster, this->PlacesInOpenFaces(first), loops,
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
}
