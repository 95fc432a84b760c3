// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PatchOutlines.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace SeismicHorizons
{
namespace
{
// Short walks around nothing are many, and repeating them costs less than remembering them.
constexpr std::size_t SmallestWalkToRemember = 16;

/// Enters a loop, or leaves it. Few loops lie around a place.
void Toggle(std::vector<std::size_t>& around, std::size_t loop)
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
}

//----------------------------------------------------------------------------------------------------------------------
PatchOutlines::PatchOutlines(
  const std::vector<PlanePoint>& columns, const BoundaryOptions& options, const Monitor& monitor)
  : Columns(columns)
  , Options(options)
  , Raster(columns, 2 * options.Radius)
  , Hops(options.Radius, this->Raster.Width())
  , Graph(this->Raster, columns.size(), this->Hops, monitor)
  , Parts(FindPatchComponents(this->Raster, columns.size(), options.Radius))
  , PatchOf(this->Parts.First.size())
  , Walked(this->Graph.Size() + 1, false)
{
  std::iota(this->PatchOf.begin(), this->PatchOf.end(), 0);
}

//----------------------------------------------------------------------------------------------------------------------
ExteriorBoundary PatchOutlines::Run(const Monitor& monitor)
{
  this->WalkOutlines(monitor.Step(0.0, this->Options.HoleBoundaries ? 0.4 : 0.9));
  if (this->Options.HoleBoundaries)
  {
    this->WalkHoles(monitor.Step(0.4, 0.9));
  }
  this->AbsorbIslands();
  return this->Collect();
}

//----------------------------------------------------------------------------------------------------------------------
void PatchOutlines::WalkOutlines(const Monitor& monitor)
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
    if (this->Options.HoleBoundaries)
    {
      this->Remember();
    }
    AppendLoop(this->Columns, this->Steps, this->Faces);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void PatchOutlines::WalkHoles(const Monitor& monitor)
{
  for (std::int64_t row = 0; row < this->Raster.Height(); ++row)
  {
    if (row % 16 == 0)
    {
      monitor.Progress(double(row) / double(this->Raster.Height()));
    }
    const std::int64_t end = (row + 1) * this->Raster.Width();
    for (std::int64_t place = row * this->Raster.Width(); place < end; ++place)
    {
      if (this->Raster[place] != NoPoint && this->IsOnBorder(place))
      {
        this->WalkFacesAt(place);
      }
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
// Around a point among eight others all faces are triangles between neighbours. An empty column among eight points lies
// on the hop that spans it, and in no face. So every face with a column inside has all its corners beside other empty
// columns.
bool PatchOutlines::IsOnBorder(std::int64_t place) const
{
  return this->HasNeighbour(place,
    [this](std::int64_t column)
    {
      return this->Raster[column] == NoPoint &&
        this->HasNeighbour(column, [this](std::int64_t next) { return this->Raster[next] == NoPoint; });
    });
}

//----------------------------------------------------------------------------------------------------------------------
void PatchOutlines::WalkFacesAt(std::int64_t place)
{
  const HopId first = this->Graph.Next(place, this->Hops.Size() - 1);
  HopId hop = first;
  while (hop != NoHop)
  {
    if (!this->Walked[this->NumberOf({ this->Raster[place], hop })])
    {
      this->WalkFace(place, hop);
    }
    hop = this->Graph.Next(place, hop);
    hop = hop == first ? NoHop : hop;
  }
}

//----------------------------------------------------------------------------------------------------------------------
void PatchOutlines::WalkFace(std::int64_t place, HopId hop)
{
  this->Walk(place, hop);
  const std::int64_t inside = ColumnsInside(this->Hops, this->Steps);
  if (inside > 0 || this->Steps.size() >= SmallestWalkToRemember)
  {
    this->Remember();
  }
  if (inside > 0 && inside >= this->Options.SmallestHoleSize)
  {
    AppendLoop(this->Columns, this->Steps, this->Faces);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void PatchOutlines::Walk(std::int64_t start, HopId first)
{
  const auto sweep = [this](std::int64_t place, HopId from) { return this->Graph.Next(place, from); };
  SeismicHorizons::WalkFace(this->Raster, this->Hops, start, first, sweep, this->Steps);
}

//----------------------------------------------------------------------------------------------------------------------
void PatchOutlines::Remember()
{
  for (const FaceStep& step : this->Steps)
  {
    this->Walked[this->NumberOf(step)] = true;
  }
  this->Walked.back() = false; // the number of hops that have none
}

//----------------------------------------------------------------------------------------------------------------------
// A component lies inside a loop when its first point does. Components are met from below, so that each is met after
// the one around it, and an island inside an island after both.
void PatchOutlines::AbsorbIslands()
{
  if (this->Parts.First.size() < 2)
  {
    return;
  }
  std::vector<std::vector<Crossing>> crossings = this->CrossingsOfFirstRows();
  std::vector<std::size_t> around;
  std::size_t rows = 0;
  std::size_t next = 0;
  std::int64_t row = -1;
  for (std::size_t part = 0; part < this->Parts.First.size(); ++part)
  {
    if (this->RowOf(this->Parts.First[part]) != row)
    {
      row = this->RowOf(this->Parts.First[part]);
      std::sort(
        crossings[rows].begin(), crossings[rows].end(), [](const Crossing& a, const Crossing& b) { return a.X < b.X; });
      ++rows;
      next = 0;
      around.clear();
    }
    const std::vector<Crossing>& ofRow = crossings[rows - 1];
    for (; next < ofRow.size() && ofRow[next].X < double(this->Parts.First[part] % this->Raster.Width()); ++next)
    {
      Toggle(around, ofRow[next].Loop);
    }
    const std::int32_t patch = this->SurroundingPatch(around);
    this->PatchOf[part] = patch < 0 ? std::int32_t(part) : patch;
  }
}

//----------------------------------------------------------------------------------------------------------------------
// From outside to inside, outlines of patches and loops of holes take turns. Outlines of islands that were absorbed are
// left out.
std::int32_t PatchOutlines::SurroundingPatch(const std::vector<std::size_t>& around) const
{
  std::int32_t innermost = -1;
  std::size_t outlines = 0;
  std::size_t holes = 0;
  for (const std::size_t loop : around)
  {
    const bool isHole = this->IsHole(loop);
    holes += isHole ? 1 : 0;
    if (!isHole && this->PatchOf[loop] == std::int32_t(loop))
    {
      ++outlines;
      innermost = std::max(innermost, std::int32_t(loop));
    }
  }
  return outlines > holes ? innermost : -1;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::vector<PatchOutlines::Crossing>> PatchOutlines::CrossingsOfFirstRows() const
{
  std::vector<std::int32_t> rowNumber(std::size_t(this->Raster.Height()), -1);
  std::int32_t rows = 0;
  for (const std::int64_t place : this->Parts.First)
  {
    std::int32_t& number = rowNumber[std::size_t(this->RowOf(place))];
    number = number < 0 ? rows++ : number;
  }
  std::vector<std::vector<Crossing>> crossings{ std::size_t(rows) };
  for (std::size_t loop = 0; loop < this->Faces.Size(); ++loop)
  {
    this->Faces.ForEachEdgeOf(loop,
      [&](PointId from, PointId to)
      {
        const std::int64_t a = this->Raster.Place(this->Columns[std::size_t(from)]);
        const std::int64_t b = this->Raster.Place(this->Columns[std::size_t(to)]);
        this->AddCrossings(std::min(a, b), std::max(a, b), loop, rowNumber, crossings);
      });
  }
  return crossings;
}

//----------------------------------------------------------------------------------------------------------------------
// The upper end of a hop is left to the hop that goes on from there. No hop passes nearer to a point than one part in k
// of a column, so that rounding is no matter.
void PatchOutlines::AddCrossings(std::int64_t low, std::int64_t high, std::size_t loop,
  const std::vector<std::int32_t>& rowNumber, std::vector<std::vector<Crossing>>& crossings) const
{
  const std::int64_t width = this->Raster.Width();
  const double slope =
    double(high % width - low % width) / double(std::max<std::int64_t>(1, this->RowOf(high) - this->RowOf(low)));
  for (std::int64_t row = this->RowOf(low); row < this->RowOf(high); ++row)
  {
    const std::int32_t number = rowNumber[std::size_t(row)];
    if (number >= 0)
    {
      crossings[std::size_t(number)].push_back({ double(low % width) + slope * double(row - this->RowOf(low)), loop });
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
ExteriorBoundary PatchOutlines::Collect()
{
  ExteriorBoundary result;
  std::vector<std::int32_t> number(this->PatchOf.size(), -1);
  for (std::size_t part = 0; part < number.size(); ++part)
  {
    if (this->PatchOf[part] == std::int32_t(part))
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
    patch = number[std::size_t(this->PatchOf[std::size_t(patch)])];
  }
  return result;
}
}
