// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceParts.h"

#include "BandCuts.h"
#include "Common/Base/FreeMemory.h"
#include "Common/Base/SideBySide.h"
#include "Common/Horizon/Predicates.h"
#include "Filters/Algorithms/Decimation/HeightRaster.h"
#include "SurfacePart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
namespace
{
constexpr std::int64_t LeastRows = 64;
constexpr std::int64_t LeastBands = 2;
// Triangles whose centre is so near to a cut, in rows, are made anew, but at most this fraction of a band.
constexpr std::int32_t RowsBesideCut = 128;
constexpr std::int32_t PartBesideCut = 4;
// What is not good yet is made anew with triangles so many columns around, then with more; slivers fewer times.
constexpr std::int32_t LeastAround = 4;
constexpr std::int32_t MostAround = 32;
constexpr std::int32_t MostAroundSlivers = 12;

using EdgeKeys = std::vector<std::uint64_t>;
using Places = std::vector<PlanePoint>;
using Meshes = std::vector<SurfacePart*>;

/// Around triangles that are made anew.
struct StripSides
{
  EdgeKeys Inner; // of other triangles
  EdgeKeys Outer; // of outlines
};

struct Strip
{
  bool IsOpen = true;
  Places Left; // not good yet
};

std::unordered_set<PointId> FindShared(const ExteriorBoundary& boundary)
{
  std::unordered_set<PointId> visited;
  std::unordered_set<PointId> shared;
  boundary.Boundary.ForEachPoint(
    [&](PointId point)
    {
      if (!visited.insert(point).second)
      {
        shared.insert(point);
      }
    });
  const std::vector<PointId> ofCracks = boundary.OpenCracks.PointsOfOpenEnds();
  shared.insert(ofCracks.begin(), ofCracks.end());
  return shared;
}

class PartedSurface
{
public:
  PartedSurface(const PointRows& rows, std::int32_t rowsOfPart, const SurfaceOptions& options, Surface& result)
    : Rows(rows)
    , Options(options)
    , Cuts(rows, rowsOfPart, result.Boundary.Boundary)
    , RowsBeside(std::min(RowsBesideCut, rowsOfPart / PartBesideCut))
    , Shared(FindShared(result.Boundary))
    , Mesher(rows, this->Options, result.Parameters, this->Shared)
    , Whole(rows, this->Options, result)
    , Bands(this->Cuts.NumberOfBands())
    , Strips(this->Cuts.NumberOfCuts())
  {
    this->Options.Radius = result.Parameters.Radius;
  }

  /// Strips of even cuts are independent of each other, and so are those of odd cuts, which follow.
  void Run(const TakeTargets& take, const Monitor& monitor)
  {
    const std::size_t bands = this->Cuts.NumberOfBands();
    const std::size_t step = 2 * ((this->Rows.MostAtOnce() + 1) / 2);
    std::size_t added = 0;
    for (std::size_t first = 0; first < bands; first += step)
    {
      const std::size_t end = std::min(first + step, bands);
      const auto part = [&](double done) { return 0.9 * (double(first) + done * double(end - first)) / double(bands); };
      this->MeshBands(first, end, monitor.Step(part(0.0), part(0.8)));
      this->MeshStrips(first, end, monitor.Step(part(0.8), part(0.9)));
      this->MeshStrips(first == 0 ? 1 : first - 1, end, monitor.Step(part(0.9), part(1.0)));
      this->Improve(end, monitor);
      for (; added < bands && (end == bands || added + 5 < end); ++added) // Others may still change.
      {
        this->Whole.Add(std::exchange(this->Bands[added], SurfacePart()));
      }
      ReturnFreeMemory();
    }
    this->Whole.Finish(take, monitor.Step(0.9, 1.0));
  }

private:
  PlanePoint At(PointId point) const { return this->Rows.ColumnOf(point); }

  // ---- Bands -------------------------------------------------------------------------------------------------------
  void MeshBands(std::size_t first, std::size_t end, const Monitor& monitor)
  {
    for (std::size_t cut = first; cut < std::min(end, this->Cuts.NumberOfCuts()); ++cut)
    {
      this->Cuts.Open(cut, this->Options.MaximumError);
    }
    this->ForEach(end - first, monitor,
      [&](std::size_t n, const Monitor& own) { this->Bands[first + n] = this->MeshBand(first + n, own); });
  }

  SurfacePart MeshBand(std::size_t band, const Monitor& monitor)
  {
    PartBoundary boundary;
    if (band < this->Cuts.NumberOfCuts())
    {
      LockCut(this->Cuts.Cut(band), boundary);
    }
    if (band > 0)
    {
      LockCut(this->Cuts.Cut(band - 1), boundary);
    }
    boundary.Edges = this->Cuts.TakeEdges(band);
    boundary.LoopsOfOne = this->Cuts.LoopsOfOne(band);
    const std::int32_t firstRow = this->Cuts.FirstRow(band);
    const std::int32_t lastRow = this->Cuts.LastRow(band);
    PointWindow window = this->Mesher.Read(firstRow, lastRow);
    const bool isLast = band + 1 == this->Cuts.NumberOfBands();
    this->Whole.AddHeights(window, this->Rows.FirstOf(firstRow), this->Rows.FirstOf(isLast ? lastRow + 1 : lastRow));
    return this->Mesher.Mesh(std::move(window), std::move(boundary), monitor);
  }

  static void LockCut(const BandCut& cut, PartBoundary& boundary)
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

  void ForEach(std::size_t size, const Monitor& monitor, const std::function<void(std::size_t, const Monitor&)>& work)
  {
    RunSideBySide(std::int64_t(size), std::int64_t(this->Rows.MostAtOnce()), monitor,
      [&work](std::int64_t n, const Monitor& own) { work(std::size_t(n), own); });
  }

  // ---- Strips ------------------------------------------------------------------------------------------------------
  /// Meshes strips of each second cut, between bands up to the end.
  void MeshStrips(std::size_t first, std::size_t end, const Monitor& monitor)
  {
    const std::size_t size = first + 1 < end ? (end - first) / 2 : 0;
    this->ForEach(size, monitor,
      [&](std::size_t n, const Monitor& own)
      {
        const std::size_t cut = first + 2 * n;
        const Meshes meshes = this->MeshesOf(cut, cut + 2);
        SurfacePart made = this->Remesh(
          meshes, &this->Cuts.Cut(cut), [&](const PartCorners& corners) { return this->IsBeside(cut, corners); },
          own.Step(0.0, 0.8));
        this->Strips[cut].Left = this->Improve(cut, meshes, std::move(made), {}, own.Step(0.8, 1.0));
      });
    for (std::size_t n = 0; n < size; ++n)
    {
      this->Strips[first + 2 * n].IsOpen = false;
    }
  }

  /// Makes anew what is not good beside triangles of other strips. These are complete then, whatever bands are at hand.
  void Improve(std::size_t end, const Monitor& monitor)
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

  /// Finds triangles beside a cut, if other strips made some of them when links to its points did not count. Bands that
  /// are higher than their triangles have none.
  SurfacePart FindNext(std::size_t cut, const Meshes& meshes) const
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

  Meshes MeshesOf(std::size_t first, std::size_t end)
  {
    Meshes meshes;
    for (std::size_t band = first; band < std::min(end, this->Bands.size()); ++band)
    {
      meshes.push_back(&this->Bands[band]);
    }
    return meshes;
  }

  /// Adds triangles that were made anew to the band above the cut, and makes those around places anew. Returns what is
  /// still not good.
  Places Improve(std::size_t cut, const Meshes& meshes, SurfacePart made, Places places, const Monitor& monitor)
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

  bool IsBeside(std::size_t cut, const PartCorners& corners) const
  {
    std::int64_t sum = 0;
    for (const PointId corner : corners)
    {
      sum += std::int64_t(this->At(corner).Y) - this->Cuts.Cut(cut).Row();
    }
    const bool isNear = std::abs(sum) <= 3 * std::int64_t(this->RowsBeside);
    return this->MayGo(cut, corners) && (isNear || this->IsNext(cut, corners));
  }

  /// Bands drop points of cuts, and edges in the rows beside may be far from links to these.
  bool IsNext(std::size_t cut, const PartCorners& corners) const
  {
    const std::int64_t row = this->Cuts.Cut(cut).Row();
    return std::any_of(
      corners.begin(), corners.end(), [&](PointId corner) { return std::abs(this->At(corner).Y - row) <= 1; });
  }

  /// Triangles along cuts that are still open wait for these.
  bool MayGo(std::size_t cut, const PartCorners& corners) const
  {
    const std::array<PlanePoint, 3> places = { this->At(corners[0]), this->At(corners[1]), this->At(corners[2]) };
    const auto isAlong = [&](std::size_t other)
    {
      const BandCut& open = this->Cuts.Cut(other);
      return this->Strips[other].IsOpen &&
        (open.IsOpen(places[0], places[1]) || open.IsOpen(places[1], places[2]) || open.IsOpen(places[2], places[0]));
    };
    bool may = cut == 0 || !isAlong(cut - 1);
    for (std::size_t above = cut + 1; above < std::min(cut + 3, this->Cuts.NumberOfCuts()); ++above)
    {
      may = may && !isAlong(above);
    }
    return may;
  }

  /// Whether the box of a triangle is so near to one of the places, which ascend by rows.
  bool IsNear(const Places& places, const PartCorners& corners, std::int32_t distance) const
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

  /// Finds edges inside a part that are too far from links.
  void AddFar(const SurfacePart& made, const Meshes& others, Places& places) const
  {
    const double bound = MaximumCrossingError(this->Options.MaximumError, this->Options.Crossings);
    if (made.Triangles.empty() || bound == std::numeric_limits<double>::infinity())
    {
      return;
    }
    const auto [first, last] = this->RowsOf(made.Triangles);
    const PointWindow window = this->Rows.Read(first - 1, last + 1);
    const HeightRaster raster = this->MakeRaster(window, made, others);
    const double rounding =
      UnitsOfRounding * std::max(std::abs(raster.LowestHeight()), std::abs(raster.HighestHeight()));
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

  HeightRaster MakeRaster(const PointWindow& window, const SurfacePart& made, const Meshes& others) const
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

  std::pair<std::int32_t, std::int32_t> RowsOf(const std::vector<PartCorners>& triangles) const
  {
    PlaneBox box;
    for (const PartCorners& corners : triangles)
    {
      std::for_each(corners.begin(), corners.end(), [&](PointId point) { box.Add(this->At(point)); });
    }
    return { box.Least.Y, box.Greatest.Y };
  }

  /// Finds slivers beside edges that stay.
  void AddSlivers(const SurfacePart& made, Places& places) const
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

  // ---- Triangles that are made anew --------------------------------------------------------------------------------
  /// Takes the triangles that are chosen, and meshes their area anew. Edges along an open cut go.
  SurfacePart Remesh(const Meshes& meshes, const BandCut* cut, const std::function<bool(const PartCorners&)>& isChosen,
    const Monitor& monitor) const
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
    std::for_each(
      boundary.Edges.begin(), boundary.Edges.end(), [&](const Edge& edge) { box.Add(this->At(edge.From)); });
    std::for_each(boundary.Dropped.begin(), boundary.Dropped.end(), [&](PointId point) { box.Add(this->At(point)); });
    SurfacePart made = this->Mesher.Mesh(this->Mesher.Read(box.Least.Y, box.Greatest.Y), std::move(boundary), monitor);
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

  StripSides FindSides(const BandCut* cut, const std::vector<PartCorners>& triangles, const Meshes& meshes) const
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

  /// Outlines are simplified anew, unless the boundary there meets edges that stay.
  PartBoundary BoundaryOf(const StripSides& sides, const SurfacePart& taken, const Meshes& meshes) const
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

  /// Ends of the chain do not count.
  bool Meets(const std::vector<PointId>& chain, const std::set<PointId>& stay,
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

  const PointRows& Rows;
  SurfaceOptions Options;
  BandCuts Cuts;
  const std::int32_t RowsBeside;
  const std::unordered_set<PointId> Shared;
  const PartMesher Mesher;
  PartAssembly Whole;
  std::vector<SurfacePart> Bands; // until they are in the whole
  std::vector<Strip> Strips; // by cut
  std::size_t Improved = 0; // strips
};
}

//----------------------------------------------------------------------------------------------------------------------
std::int32_t RowsOfBand(const PlaneBox& box)
{
  const std::int64_t width = std::int64_t(box.Greatest.X) - box.Least.X + 1;
  return std::int32_t(std::max(LeastRows, (ColumnsOfBand + width - 1) / width));
}

//----------------------------------------------------------------------------------------------------------------------
std::int32_t RowsOfPart(const PlaneBox& box, const SurfaceOptions& options, int radius)
{
  const bool isImproved = options.Effort == DecimationEffort::Best && options.EdgeLength == 0.0 &&
    options.MaximumNumberOfTriangles == 0 && options.MaximumError > 0.0;
  if (box.IsEmpty() || radius > 1 || !isImproved)
  {
    return 0;
  }
  if (options.RowsOfPart > 0)
  {
    return options.RowsOfPart;
  }
  const std::int64_t height = std::int64_t(box.Greatest.Y) - box.Least.Y + 1;
  const std::int32_t rows = RowsOfBand(box);
  return height >= LeastBands * rows ? rows : 0;
}

//----------------------------------------------------------------------------------------------------------------------
void MakeInParts(const PointRows& rows, std::int32_t rowsOfPart, const SurfaceOptions& options, Surface& surface,
  const TakeTargets& take, const Monitor& monitor)
{
  PartedSurface(rows, rowsOfPart, options, surface).Run(take, monitor);
}
}
