// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "BandMesher.h"

#include "Common/Base/SideBySide.h"
#include "Common/Horizon/Predicates.h"
#include "PartAssembly.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <unordered_map>

namespace SeismicHorizons
{
namespace
{
// Triangles whose centre is so near to a cut, in rows, are made anew, but at most this fraction of a band.
constexpr std::int32_t RowsBesideCut = 128;
constexpr std::int32_t PartBesideCut = 4;
// What is not good yet is made anew with triangles so many columns around, then with more; slivers fewer times.
constexpr std::int32_t LeastAround = 4;
constexpr std::int32_t MostAround = 32;
constexpr std::int32_t MostAroundSlivers = 12;
}

//----------------------------------------------------------------------------------------------------------------------
BandMesher::BandMesher(const PointRows& rows, std::int32_t rowsOfBand, const SurfaceOptions& options,
  const SurfaceParameters& parameters, const Loops& boundary, const std::unordered_set<PointId>& shared,
  TakePoints take)
  : Rows(rows)
  , Options(options)
  , AllCuts(rows, rowsOfBand, boundary)
  , RowsBeside(std::min(RowsBesideCut, rowsOfBand / PartBesideCut))
  , Parts(rows, this->Options, parameters, shared)
  , Take(std::move(take))
  , Bands(this->AllCuts.NumberOfBands())
  , Strips(this->AllCuts.NumberOfCuts())
{
}

//----------------------------------------------------------------------------------------------------------------------
void BandMesher::MeshBands(std::size_t first, std::size_t end, const Monitor& monitor)
{
  for (std::size_t cut = first; cut < std::min(end, this->AllCuts.NumberOfCuts()); ++cut)
  {
    this->OpenCut(cut);
  }
  this->ForEach(end - first, monitor,
    [&](std::size_t n, const Monitor& own) { this->Bands[first + n] = this->MeshBand(first + n, own); });
}

//----------------------------------------------------------------------------------------------------------------------
SurfacePart BandMesher::MeshBand(std::size_t band, const Monitor& monitor)
{
  PartBoundary boundary;
  if (band < this->AllCuts.NumberOfCuts())
  {
    LockCut(this->AllCuts.Cut(band), boundary);
  }
  if (band > 0)
  {
    LockCut(this->AllCuts.Cut(band - 1), boundary);
  }
  boundary.Edges = this->AllCuts.TakeEdges(band);
  boundary.LoopsOfOne = this->AllCuts.LoopsOfOne(band);
  const std::int32_t firstRow = this->AllCuts.FirstRow(band);
  const std::int32_t lastRow = this->AllCuts.LastRow(band);
  PointWindow window = this->Parts.Read(firstRow, lastRow);
  const bool isLast = band + 1 == this->AllCuts.NumberOfBands();
  this->Take(window, this->Rows.FirstOf(firstRow), this->Rows.FirstOf(isLast ? lastRow + 1 : lastRow));
  return this->Parts.Mesh(std::move(window), std::move(boundary), monitor);
}

//----------------------------------------------------------------------------------------------------------------------
void BandMesher::LockCut(const BandCut& cut, PartBoundary& boundary)
{
  for (const Edge& edge : cut.Edges())
  {
    boundary.Fixed.insert({ edge.From, edge.To });
  }
  for (const LockedHeight& node : cut.Nodes())
  {
    boundary.Locked.emplace(node.Point, node.Height);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void BandMesher::ForEach(
  std::size_t size, const Monitor& monitor, const std::function<void(std::size_t, const Monitor&)>& work)
{
  RunSideBySide(std::int64_t(size), std::int64_t(this->Rows.MostAtOnce()), monitor,
    [&work](std::int64_t n, const Monitor& own) { work(std::size_t(n), own); });
}

//----------------------------------------------------------------------------------------------------------------------
void BandMesher::MeshStrips(std::size_t first, std::size_t end, const Monitor& monitor)
{
  const std::size_t size = first + 1 < end ? (end - first) / 2 : 0;
  this->ForEach(size, monitor,
    [&](std::size_t n, const Monitor& own)
    {
      const std::size_t cut = first + 2 * n;
      const Meshes meshes = this->MeshesOf(cut, cut + 2);
      SurfacePart made = this->Remesh(
        meshes, &this->AllCuts.Cut(cut), [&](const PartCorners& corners) { return this->IsBeside(cut, corners); },
        own.Step(0.0, 0.8));
      this->Strips[cut].Left = this->Improve(cut, meshes, std::move(made), {}, own.Step(0.8, 1.0));
    });
  for (std::size_t n = 0; n < size; ++n)
  {
    this->Strips[first + 2 * n].IsOpen = false;
  }
}

//----------------------------------------------------------------------------------------------------------------------
void BandMesher::Improve(std::size_t end, const Monitor& monitor)
{
  for (; this->Improved + 1 < end && (this->Improved + 5 <= end || end == this->Bands.size()); ++this->Improved)
  {
    const std::size_t cut = this->Improved;
    const Meshes meshes = this->MeshesOf(cut == 0 ? 0 : cut - 1, cut + 3);
    Places places = std::exchange(this->Strips[cut].Left, Places());
    this->AddFar(this->FindNext(cut, meshes), meshes, places);
    this->Improve(cut, meshes, SurfacePart(), std::move(places), monitor);
  }
}

//----------------------------------------------------------------------------------------------------------------------
SurfacePart BandMesher::FindNext(std::size_t cut, const Meshes& meshes) const
{
  SurfacePart next;
  bool areOfOthers = false;
  for (const SurfacePart* const mesh : meshes)
  {
    const bool isOwn = mesh == &this->Bands[cut] || mesh == &this->Bands[cut + 1];
    for (const PartCorners& corners : mesh->Triangles)
    {
      if (this->IsNext(cut, corners))
      {
        areOfOthers = areOfOthers || !isOwn;
        next.Triangles.push_back(corners);
        std::for_each(corners.begin(), corners.end(),
          [&](PointId corner) { next.Heights.emplace(corner, mesh->Heights.at(corner)); });
      }
    }
  }
  return areOfOthers ? next : SurfacePart();
}

//----------------------------------------------------------------------------------------------------------------------
BandMesher::Meshes BandMesher::MeshesOf(std::size_t first, std::size_t end)
{
  Meshes meshes;
  for (std::size_t band = first; band < std::min(end, this->Bands.size()); ++band)
  {
    meshes.push_back(&this->Bands[band]);
  }
  return meshes;
}

//----------------------------------------------------------------------------------------------------------------------
BandMesher::Places BandMesher::Improve(
  std::size_t cut, const Meshes& meshes, SurfacePart made, Places places, const Monitor& monitor)
{
  for (std::int32_t around = LeastAround;; around += LeastAround)
  {
    this->AddFar(made, meshes, places);
    if (around <= MostAroundSlivers)
    {
      this->AddSlivers(made, places);
    }
    std::sort(places.begin(), places.end(), PrecedesByRow);
    this->Bands[cut + 1].Add(made);
    if (places.empty() || around > MostAround)
    {
      return places;
    }
    made = this->Remesh(
      meshes, nullptr,
      [&](const PartCorners& corners) { return this->MayGo(cut, corners) && this->IsNear(places, corners, around); },
      monitor);
    places.clear();
  }
}

//----------------------------------------------------------------------------------------------------------------------
bool BandMesher::IsBeside(std::size_t cut, const PartCorners& corners) const
{
  std::int64_t sum = 0;
  for (const PointId corner : corners)
  {
    sum += std::int64_t(this->At(corner).Y) - this->AllCuts.Cut(cut).Row();
  }
  const bool isNear = std::abs(sum) <= 3 * std::int64_t(this->RowsBeside);
  return this->MayGo(cut, corners) && (isNear || this->IsNext(cut, corners));
}

//----------------------------------------------------------------------------------------------------------------------
bool BandMesher::IsNext(std::size_t cut, const PartCorners& corners) const
{
  const std::int64_t row = this->AllCuts.Cut(cut).Row();
  return std::any_of(
    corners.begin(), corners.end(), [&](PointId corner) { return std::abs(this->At(corner).Y - row) <= 1; });
}

//----------------------------------------------------------------------------------------------------------------------
bool BandMesher::MayGo(std::size_t cut, const PartCorners& corners) const
{
  const std::array<PlanePoint, 3> places = { this->At(corners[0]), this->At(corners[1]), this->At(corners[2]) };
  const auto isAlong = [&](std::size_t other)
  {
    const BandCut& open = this->AllCuts.Cut(other);
    return this->Strips[other].IsOpen &&
      (open.IsOpen(places[0], places[1]) || open.IsOpen(places[1], places[2]) || open.IsOpen(places[2], places[0]));
  };
  bool may = cut == 0 || !isAlong(cut - 1);
  for (std::size_t above = cut + 1; above < std::min(cut + 3, this->AllCuts.NumberOfCuts()); ++above)
  {
    may = may && !isAlong(above);
  }
  return may;
}

//----------------------------------------------------------------------------------------------------------------------
bool BandMesher::IsNear(const Places& places, const PartCorners& corners, std::int32_t distance) const
{
  PlaneBox box;
  std::for_each(corners.begin(), corners.end(), [&](PointId point) { box.Add(this->At(point)); });
  const auto first = std::lower_bound(places.begin(), places.end(), box.Least.Y - distance,
    [](const PlanePoint& place, std::int32_t row) { return place.Y < row; });
  return std::any_of(first, places.end(),
    [&](const PlanePoint& place)
    {
      return place.Y <= box.Greatest.Y + distance && place.X >= box.Least.X - distance &&
        place.X <= box.Greatest.X + distance;
    });
}

//----------------------------------------------------------------------------------------------------------------------
void BandMesher::AddFar(const SurfacePart& made, const Meshes& others, Places& places) const
{
  const double bound = MaximumCrossingError(this->Options.MaximumError, this->Options.Crossings);
  if (made.Triangles.empty() || bound == std::numeric_limits<double>::infinity())
  {
    return;
  }
  const auto [first, last] = this->RowsOf(made.Triangles);
  const PointWindow window = this->Rows.Read(first - 1, last + 1);
  const HeightRaster raster = this->MakeRaster(window, made, others);
  const double rounding = UnitsOfRounding * std::max(std::abs(raster.LowestHeight()), std::abs(raster.HighestHeight()));
  std::unordered_set<std::uint64_t> seen;
  for (const PartCorners& corners : made.Triangles)
  {
    for (std::size_t n = 0; n < 3; ++n)
    {
      const PointId from = corners[n];
      const PointId to = corners[(n + 1) % 3];
      seen.insert(EdgeKeyOf(from, to));
      if (seen.count(EdgeKeyOf(to, from)) > 0)
      {
        const RaisedPoint start{ this->At(from), made.Heights.at(from) };
        const RaisedPoint end{ this->At(to), made.Heights.at(to) };
        if (raster.MeasureCrossings(start, end).Inside > bound + rounding)
        {
          places.push_back({ (start.Column.X + end.Column.X) / 2, (start.Column.Y + end.Column.Y) / 2 });
        }
      }
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
HeightRaster BandMesher::MakeRaster(const PointWindow& window, const SurfacePart& made, const Meshes& others) const
{
  std::vector<PointId> dropped;
  const auto add = [&](const SurfacePart& part)
  {
    for (const PointId point : part.Dropped)
    {
      const PointId n = point - window.First;
      if (n >= 0 && std::size_t(n) < window.Columns.size())
      {
        dropped.push_back(n);
      }
    }
  };
  add(made);
  std::for_each(others.begin(), others.end(), [&](const SurfacePart* part) { add(*part); });
  return RasterOfWindow(window, dropped, this->Options.Cuts);
}

//----------------------------------------------------------------------------------------------------------------------
std::pair<std::int32_t, std::int32_t> BandMesher::RowsOf(const std::vector<PartCorners>& triangles) const
{
  PlaneBox box;
  for (const PartCorners& corners : triangles)
  {
    std::for_each(corners.begin(), corners.end(), [&](PointId point) { box.Add(this->At(point)); });
  }
  return { box.Least.Y, box.Greatest.Y };
}

//----------------------------------------------------------------------------------------------------------------------
void BandMesher::AddSlivers(const SurfacePart& made, Places& places) const
{
  const double sine = SineOfDegrees(this->Options.SmallestAngle);
  for (const PartCorners& corners : made.Triangles)
  {
    const PlanePoint place = this->At(corners[0]);
    const bool isBesideOther =
      std::any_of(corners.begin(), corners.end(), [&made](PointId corner) { return made.Locked.count(corner) > 0; });
    if (isBesideOther && SineOfSmallestAngle(place, this->At(corners[1]), this->At(corners[2])) < sine)
    {
      places.push_back(place);
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
SurfacePart BandMesher::Remesh(const Meshes& meshes, const BandCut* cut,
  const std::function<bool(const PartCorners&)>& isChosen, const Monitor& monitor) const
{
  SurfacePart taken;
  std::for_each(meshes.begin(), meshes.end(), [&](SurfacePart* mesh) { mesh->MoveTriangles(isChosen, taken); });
  const StripSides sides = this->FindSides(cut, taken.Triangles, meshes);
  PartBoundary boundary = this->BoundaryOf(sides, taken, meshes);
  for (SurfacePart* const mesh : meshes)
  {
    mesh->LetGo(sides.Outer, boundary.Dropped);
    for (auto chain = mesh->Chains.begin(); cut && chain != mesh->Chains.end();)
    {
      const bool isGone = cut->IsOpen(this->At(chain->second.front()), this->At(chain->second.back()));
      chain = isGone ? mesh->Chains.erase(chain) : std::next(chain);
    }
  }
  if (taken.Triangles.empty())
  {
    return {};
  }
  PlaneBox box;
  std::for_each(boundary.Edges.begin(), boundary.Edges.end(), [&](const Edge& edge) { box.Add(this->At(edge.From)); });
  std::for_each(boundary.Dropped.begin(), boundary.Dropped.end(), [&](PointId point) { box.Add(this->At(point)); });
  SurfacePart made = this->Parts.Mesh(this->Parts.Read(box.Least.Y, box.Greatest.Y), std::move(boundary), monitor);
  for (const std::uint64_t key : sides.Inner)
  {
    made.Chains.erase(key);
    made.Locked.insert({ FromOf(key), ToOf(key) });
  }
  for (SurfacePart* const mesh : meshes)
  {
    for (const auto& [point, height] : made.Heights)
    {
      const auto known = mesh->Heights.find(point);
      if (known != mesh->Heights.end())
      {
        known->second = height;
      }
    }
  }
  return made;
}

//----------------------------------------------------------------------------------------------------------------------
BandMesher::StripSides BandMesher::FindSides(
  const BandCut* cut, const std::vector<PartCorners>& triangles, const Meshes& meshes) const
{
  EdgeKeys edges;
  for (const PartCorners& corners : triangles)
  {
    for (std::size_t n = 0; n < 3; ++n)
    {
      edges.push_back(EdgeKeyOf(corners[(n + 1) % 3], corners[n])); // loops have the surface to their right
    }
  }
  std::sort(edges.begin(), edges.end());
  StripSides sides;
  for (const std::uint64_t key : edges)
  {
    const bool isInside = std::binary_search(edges.begin(), edges.end(), EdgeKeyOf(ToOf(key), FromOf(key)));
    if (!isInside && !(cut && cut->IsOpen(this->At(FromOf(key)), this->At(ToOf(key)))))
    {
      const bool isOuter = std::any_of(
        meshes.begin(), meshes.end(), [key](const SurfacePart* mesh) { return mesh->Chains.count(key) > 0; });
      (isOuter ? sides.Outer : sides.Inner).push_back(key);
    }
  }
  return sides;
}

//----------------------------------------------------------------------------------------------------------------------
PartBoundary BandMesher::BoundaryOf(const StripSides& sides, const SurfacePart& taken, const Meshes& meshes) const
{
  PartBoundary boundary;
  std::map<std::int32_t, EdgeKeys> byRow;
  const auto lock = [&](std::uint64_t key)
  {
    for (const PointId end : { FromOf(key), ToOf(key) })
    {
      boundary.Fixed.insert(end);
      boundary.Locked.emplace(end, taken.Heights.at(end));
    }
    boundary.Edges.push_back({ FromOf(key), ToOf(key) });
  };
  for (const std::uint64_t key : sides.Inner)
  {
    lock(key);
    const std::int32_t from = this->At(FromOf(key)).Y;
    const std::int32_t to = this->At(ToOf(key)).Y;
    for (std::int32_t row = std::min(from, to); row <= std::max(from, to); ++row)
    {
      byRow[row].push_back(key);
    }
  }
  const std::set<PointId> stay = boundary.Fixed;
  for (const std::uint64_t key : sides.Outer)
  {
    const SurfacePart& mesh = **std::find_if(
      meshes.begin(), meshes.end(), [key](const SurfacePart* one) { return one->Chains.count(key) > 0; });
    const std::vector<PointId>& chain = mesh.Chains.at(key);
    const bool staysSimple = this->Meets(chain, stay, byRow);
    if (staysSimple)
    {
      lock(key);
    }
    for (std::size_t n = 1; n < chain.size(); ++n)
    {
      if (!staysSimple)
      {
        boundary.Edges.push_back({ chain[n - 1], chain[n] });
      }
      else if (n + 1 < chain.size() && mesh.Dropped.count(chain[n]) > 0)
      {
        boundary.Dropped.insert(chain[n]);
      }
    }
  }
  return boundary;
}

//----------------------------------------------------------------------------------------------------------------------
bool BandMesher::Meets(const std::vector<PointId>& chain, const std::set<PointId>& stay,
  const std::map<std::int32_t, EdgeKeys>& edgesByRow) const
{
  for (std::size_t n = 1; n < chain.size(); ++n)
  {
    if (n + 1 < chain.size() && stay.count(chain[n]) > 0)
    {
      return true;
    }
    const PlanePoint a = this->At(chain[n - 1]);
    const PlanePoint b = this->At(chain[n]);
    const auto last = edgesByRow.upper_bound(std::max(a.Y, b.Y));
    for (auto edges = edgesByRow.lower_bound(std::min(a.Y, b.Y)); edges != last; ++edges)
    {
      const bool meets = std::any_of(edges->second.begin(), edges->second.end(),
        [&](std::uint64_t key)
        {
          const PlanePoint c = this->At(FromOf(key));
          const PlanePoint d = this->At(ToOf(key));
          return ProperlyCross(a, b, c, d) || OnOpenSegment(c, d, a) || OnOpenSegment(c, d, b) ||
            OnOpenSegment(a, b, c) || OnOpenSegment(a, b, d);
        });
      if (meets)
      {
        return true;
      }
    }
  }
  return false;
}
}
