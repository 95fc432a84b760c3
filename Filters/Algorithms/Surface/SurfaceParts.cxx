// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// In this order: cuts between bands; meshes of parts; strips; the whole.

#include "SurfaceParts.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/ColumnIndex.h"
#include "Common/Horizon/CoveredColumns.h"
#include "Common/Horizon/EdgeLoops.h"
#include "Common/Horizon/MeshChecker.h"
#include "Common/Horizon/Predicates.h"
#include "Filters/Algorithms/BoundarySimplification/BoundarySimplification.h"
#include "Filters/Algorithms/Decimation/HeightRaster.h"
#include "Filters/Algorithms/Decimation/MeshErrors.h"
#include "Filters/Algorithms/Decimation/PlaneMesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace SeismicHorizons
{
namespace
{
// A band has about so many columns: fewer leave more vertices along cuts, more take memory.
constexpr std::int64_t ColumnsOfBand = std::int64_t(1) << 22;
constexpr std::int64_t LeastRows = 64;
constexpr std::int64_t LeastBands = 2;
// Triangles whose centre is so near to a cut, in rows, are made anew, but at most this fraction of a band.
constexpr std::int32_t RowsBesideCut = 128;
constexpr std::int32_t PartBesideCut = 4;
// Edges that are too far from links, and slivers beside edges that stay, are made anew with triangles so many columns
// around, then with more.
constexpr std::int32_t LeastAround = 4;
constexpr std::int32_t MostAround = 32;
constexpr std::int32_t MostAroundSlivers = 12;

using Corners = std::array<PointId, 3>;

std::int32_t RowsOfBand(const PlaneBox& box)
{
  const std::int64_t width = std::int64_t(box.Greatest.X) - box.Least.X + 1;
  return std::int32_t(std::max(LeastRows, (ColumnsOfBand + width - 1) / width));
}

std::uint64_t KeyOf(PointId from, PointId to)
{
  return std::uint64_t(std::uint32_t(from)) << 32U | std::uint32_t(to);
}

// ---- Cuts ----------------------------------------------------------------------------------------------------------
struct Range
{
  std::int32_t First;
  std::int32_t Last;
};

/// A row between two bands.
struct Cut
{
  std::int32_t Row = 0;
  std::vector<std::array<std::int32_t, 2>> Above; // edges of loops that start here: columns in this row and the next
  std::vector<std::array<std::int32_t, 2>> Below; // that end here
  std::vector<Range> Open; // columns with surface on both sides, ascending
  std::vector<Edge> Edges; // between points of the row, to the right

  bool IsOpen(const PlanePoint& a, const PlanePoint& b) const
  {
    const auto [least, greatest] = std::minmax(a.X, b.X);
    const auto after = std::upper_bound(this->Open.begin(), this->Open.end(), least,
      [](std::int32_t x, const Range& range) { return x < range.First; });
    return a.Y == this->Row && b.Y == this->Row && after != this->Open.begin() && greatest <= after[-1].Last;
  }
};

/// The surface is between each odd edge and the next one.
std::vector<Range> RangesBetween(std::vector<std::array<std::int32_t, 2>> edges)
{
  std::sort(edges.begin(), edges.end());
  std::vector<Range> ranges;
  for (std::size_t n = 0; n + 1 < edges.size(); n += 2)
  {
    if (edges[n][0] < edges[n + 1][0])
    {
      ranges.push_back({ edges[n][0], edges[n + 1][0] });
    }
  }
  return ranges;
}

std::vector<Range> Intersect(const std::vector<Range>& some, const std::vector<Range>& others)
{
  std::vector<Range> both;
  for (std::size_t a = 0, b = 0; a < some.size() && b < others.size();)
  {
    const Range range{ std::max(some[a].First, others[b].First), std::min(some[a].Last, others[b].Last) };
    if (range.First < range.Last)
    {
      both.push_back(range);
    }
    some[a].Last < others[b].Last ? ++a : ++b;
  }
  return both;
}

// ---- Parts ---------------------------------------------------------------------------------------------------------
/// The mesh of a part in points of the horizon.
struct PartMesh
{
  std::vector<Corners> Triangles;
  std::unordered_map<PointId, double> Heights; // of vertices
  std::unordered_map<std::uint64_t, std::vector<PointId>> Chains; // the boundary between the ends of edges of outlines
  std::unordered_set<PointId> Dropped;
  std::vector<PointId> AddedToOutlines;
  std::unordered_set<PointId> Locked; // of edges of other parts

  /// Outlines there are simplified anew, apart from points that stay dropped.
  void LetGo(const std::vector<std::uint64_t>& edges, const std::set<PointId>& stay)
  {
    for (const std::uint64_t key : edges)
    {
      const auto chain = this->Chains.find(key);
      if (chain != this->Chains.end())
      {
        for (const PointId point : chain->second)
        {
          if (stay.count(point) == 0)
          {
            this->Dropped.erase(point);
          }
        }
        this->Chains.erase(chain);
      }
    }
  }

  void Add(const PartMesh& other)
  {
    this->Triangles.insert(this->Triangles.end(), other.Triangles.begin(), other.Triangles.end());
    for (const auto& [point, height] : other.Heights)
    {
      this->Heights[point] = height;
    }
    this->Chains.insert(other.Chains.begin(), other.Chains.end());
    this->Dropped.insert(other.Dropped.begin(), other.Dropped.end());
    this->AddedToOutlines.insert(
      this->AddedToOutlines.end(), other.AddedToOutlines.begin(), other.AddedToOutlines.end());
  }
};

struct PartInput
{
  std::vector<Edge> Edges; // of the boundary
  std::vector<PointId> Alone; // loops of one point
  std::set<PointId> Fixed;
  std::map<PointId, double> Locked;
  std::set<PointId> Dropped; // beside edges that stay
};

class PartedSurface
{
public:
  PartedSurface(const PointRows& rows, std::int32_t rowsOfPart, const SurfaceOptions& options, Surface& result)
    : Rows(rows)
    , Options(options)
    , Result(result)
    , Exact(result.Boundary.Boundary)
    , Box(rows.Box())
  {
    this->Options.Radius = result.Parameters.Radius;
    const std::int64_t height = std::int64_t(this->Box.Greatest.Y) - this->Box.Least.Y + 1;
    const std::int64_t bands = std::max<std::int64_t>(1, (height + rowsOfPart / 2) / rowsOfPart);
    for (std::int64_t band = 1; band < bands; ++band)
    {
      this->Cuts.emplace_back();
      this->Cuts.back().Row = std::int32_t(this->Box.Least.Y + band * height / bands);
    }
    this->RowsBeside = std::min(RowsBesideCut, rowsOfPart / PartBesideCut);
    this->Edges.resize(this->Cuts.size() + 1);
    this->Alone.resize(this->Cuts.size() + 1);
  }

  void Run(const TakeTargets& take, const Monitor& monitor)
  {
    this->ShareEdges();
    PartMesh before;
    for (std::size_t band = 0; band <= this->Cuts.size(); ++band)
    {
      const auto progress = [&](double part) { return 0.9 * (double(band) + part) / double(this->Cuts.size() + 1); };
      if (band < this->Cuts.size())
      {
        this->OpenCut(this->Cuts[band]);
      }
      PartMesh now = this->MeshBand(band, monitor.Step(progress(0.0), progress(0.8)));
      if (band > 0)
      {
        this->MeshStrip(band - 1, before, now, monitor.Step(progress(0.8), progress(1.0)));
        this->Finish(before);
      }
      before = std::move(now);
    }
    this->Finish(before);
    this->Assemble(take, monitor.Step(0.9, 1.0));
  }

private:
  PlanePoint At(PointId point) const { return this->Rows.ColumnOf(point); }

  std::size_t BandOf(std::int32_t row) const
  {
    const auto after = std::upper_bound(
      this->Cuts.begin(), this->Cuts.end(), row, [](std::int32_t own, const Cut& cut) { return own < cut.Row; });
    return std::size_t(after - this->Cuts.begin());
  }

  Cut* FindCut(std::int32_t row)
  {
    const std::size_t band = this->BandOf(row);
    return band > 0 && this->Cuts[band - 1].Row == row ? &this->Cuts[band - 1] : nullptr;
  }

  // ---- Bands -------------------------------------------------------------------------------------------------------
  /// Edges along a cut belong to the side of their surface, those without surface to the band above.
  void ShareEdges()
  {
    std::unordered_map<PointId, unsigned char> visits;
    std::unordered_set<std::uint64_t> alongCuts;
    this->Exact.ForEachPoint([&](PointId point) { ++visits[point]; });
    this->Exact.ForEachEdge(
      [&](PointId from, PointId to)
      {
        if (this->At(from).Y == this->At(to).Y && this->FindCut(this->At(from).Y))
        {
          alongCuts.insert(KeyOf(from, to));
        }
      });
    this->Exact.ForEachEdge(
      [&](PointId from, PointId to)
      {
        const PlanePoint a = this->At(from);
        const PlanePoint b = this->At(to);
        const PlanePoint& low = a.Y <= b.Y ? a : b;
        const PlanePoint& high = a.Y <= b.Y ? b : a;
        std::size_t band = this->BandOf(low.Y);
        if (low.Y == high.Y)
        {
          const bool isBelow = b.X > a.X && this->FindCut(low.Y) && alongCuts.count(KeyOf(to, from)) == 0;
          band -= isBelow ? 1 : 0;
        }
        else
        {
          if (Cut* const cut = this->FindCut(low.Y))
          {
            cut->Above.push_back({ low.X, high.X });
          }
          if (Cut* const cut = this->FindCut(high.Y))
          {
            cut->Below.push_back({ high.X, low.X });
          }
        }
        this->Edges[band].push_back({ from, to });
      });
    for (std::size_t loop = 0; loop < this->Exact.Size(); ++loop)
    {
      if (this->Exact.Length(loop) == 1)
      {
        const PointId point = *this->Exact.begin(loop);
        this->Alone[this->BandOf(this->At(point).Y)].push_back(point);
      }
    }
    for (const auto& [point, number] : visits)
    {
      this->LoopPoints.push_back(point);
      if (number > 1)
      {
        this->Shared.insert(point);
      }
    }
    for (const PointId point : this->Result.Boundary.OpenCracks.PointsOfOpenEnds())
    {
      this->Shared.insert(point);
    }
    std::sort(this->LoopPoints.begin(), this->LoopPoints.end());
    this->LoopHeights.assign(this->LoopPoints.size(), 0.0);
  }

  void OpenCut(Cut& cut) const
  {
    cut.Open = Intersect(RangesBetween(std::move(cut.Above)), RangesBetween(std::move(cut.Below)));
    const PointWindow row = this->Rows.Read(cut.Row, cut.Row);
    for (std::size_t n = 1; n < row.Columns.size(); ++n)
    {
      if (cut.IsOpen(row.Columns[n - 1], row.Columns[n]))
      {
        cut.Edges.push_back({ row.First + PointId(n - 1), row.First + PointId(n) });
      }
    }
  }

  PartMesh MeshBand(std::size_t band, const Monitor& monitor)
  {
    std::vector<Edge> edges = std::move(this->Edges[band]);
    PartInput input;
    const auto addCut = [&](const Cut& cut, bool isBelow)
    {
      std::unordered_set<std::int32_t> ends;
      for (const Range& range : cut.Open)
      {
        ends.insert({ range.First, range.Last });
      }
      for (const Edge& edge : cut.Edges)
      {
        edges.push_back(isBelow ? Edge{ edge.To, edge.From } : edge);
        for (const PointId end : { edge.From, edge.To })
        {
          if (ends.count(this->At(end).X) > 0)
          {
            input.Fixed.insert(end);
          }
        }
      }
    };
    const std::int32_t first = band == 0 ? this->Box.Least.Y : this->Cuts[band - 1].Row;
    const std::int32_t last = band == this->Cuts.size() ? this->Box.Greatest.Y : this->Cuts[band].Row;
    if (band > 0)
    {
      addCut(this->Cuts[band - 1], true);
    }
    if (band < this->Cuts.size())
    {
      addCut(this->Cuts[band], false);
    }
    input.Edges = std::move(edges);
    input.Alone = this->Alone[band];
    PointWindow window;
    PartMesh mesh = this->MeshPart(std::move(input), first, last, window, monitor);
    this->TakeLoopHeights(window);
    return mesh;
  }

  void TakeLoopHeights(const PointWindow& window)
  {
    const auto first = std::lower_bound(this->LoopPoints.begin(), this->LoopPoints.end(), window.First);
    const auto last =
      std::lower_bound(first, this->LoopPoints.end(), window.First + PointId(window.Columns.size()));
    for (auto point = first; point != last; ++point)
    {
      this->LoopHeights[std::size_t(point - this->LoopPoints.begin())] = window.Height[std::size_t(*point - window.First)];
    }
  }

  // ---- A part ------------------------------------------------------------------------------------------------------
  /// Reads the rows around the part.
  PartMesh MeshPart(
    PartInput input, std::int32_t firstRow, std::int32_t lastRow, PointWindow& window, const Monitor& monitor) const
  {
    PartMesh mesh;
    const auto reach = std::int32_t(std::ceil(this->Result.Parameters.OutlineTolerance)) + 1;
    window = this->Rows.Read(firstRow - reach, lastRow + reach);
    Loops loops = JoinEdges(input.Edges);
    for (const PointId point : input.Alone)
    {
      loops.Append(point);
      loops.Close();
    }
    if (loops.Size() == 0)
    {
      return mesh;
    }
    const auto inWindow = [&](PointId point) { return point - window.First; };
    const std::vector<PointState> states = this->FindStates(window, loops.RenumberedBy(inWindow), input, reach);
    std::vector<PointId> own; // points of the horizon
    std::vector<PointId> number(states.size(), NoPoint);
    std::vector<PlanePoint> columns;
    SurfacePoints points;
    PartOfSurface part;
    for (std::size_t n = 0; n < states.size(); ++n)
    {
      if (states[n] != PointState::Away)
      {
        number[n] = PointId(own.size());
        own.push_back(window.First + PointId(n));
        columns.push_back(window.Columns[n]);
        points.Height.push_back(window.Height[n]);
      }
      if (states[n] == PointState::Beside)
      {
        part.Dropped.push_back({ number[n], NoPoint });
      }
    }
    points.Columns = columns;
    const auto inPart = [&](PointId point) { return number[std::size_t(inWindow(point))]; };
    loops.ForEachPoint(
      [&](PointId point)
      {
        if (this->Shared.count(point) != 0)
        {
          input.Fixed.insert(point);
        }
      });
    part.Boundary = loops.RenumberedBy(inPart);
    std::transform(input.Fixed.begin(), input.Fixed.end(), std::back_inserter(part.Fixed), inPart);
    for (const auto& [point, height] : input.Locked)
    {
      part.Locked.push_back({ inPart(point), height });
    }
    const Loops exact = part.Boundary;
    const Surface made = MakePart(std::move(points), this->Options, std::move(part), monitor);
    const std::vector<PointId>& sources = made.Mesh.Points.Source;
    for (std::size_t corner = 0; corner < made.Mesh.Triangles.size(); corner += 3)
    {
      Corners corners;
      std::transform(made.Mesh.Triangles.begin() + std::ptrdiff_t(corner),
        made.Mesh.Triangles.begin() + std::ptrdiff_t(corner) + 3, corners.begin(),
        [&](PointId vertex) { return own[std::size_t(sources[std::size_t(vertex)])]; });
      mesh.Triangles.push_back(corners);
    }
    for (std::size_t vertex = 0; vertex < sources.size(); ++vertex)
    {
      mesh.Heights.emplace(own[std::size_t(sources[vertex])], made.Mesh.Points.Height[vertex]);
    }
    const Loops simplified =
      made.Mesh.Points.Boundary.RenumberedBy([&](PointId vertex) { return sources[std::size_t(vertex)]; });
    ForEachChain(exact, simplified, own.size(),
      [&](std::vector<PointId> chain)
      {
        std::transform(
          chain.begin(), chain.end(), chain.begin(), [&](PointId point) { return own[std::size_t(point)]; });
        const std::uint64_t key = KeyOf(chain.front(), chain.back());
        mesh.Chains.emplace(key, std::move(chain));
      });
    for (const DroppedPoint& dropped : made.Dropped)
    {
      if (states[std::size_t(inWindow(own[std::size_t(dropped.Point)]))] == PointState::Inside)
      {
        mesh.Dropped.insert(own[std::size_t(dropped.Point)]);
      }
    }
    std::transform(made.AddedToOutlines.begin(), made.AddedToOutlines.end(), std::back_inserter(mesh.AddedToOutlines),
      [&](PointId point) { return own[std::size_t(point)]; });
    return mesh;
  }

  static bool IsLeftOut(const PointWindow& window, std::size_t point)
  {
    return !window.IsLeftOut.empty() && window.IsLeftOut[point] != 0;
  }

  enum class PointState : unsigned char
  {
    Away,
    Beside, // seen by outlines, and by edges that cross links to it
    Inside
  };

  std::vector<PointState> FindStates(
    const PointWindow& window, const Loops& loops, const PartInput& input, std::int32_t reach) const
  {
    const std::vector<unsigned char> isCovered = CoveredColumns(window.Columns, loops, 1).Mark(window.Columns);
    std::vector<PointState> states(window.Columns.size(), PointState::Away);
    const auto begin = window.Columns.begin();
    loops.ForEachEdge(
      [&](PointId from, PointId to)
      {
        PlaneBox box;
        const PlanePoint a = window.Columns[std::size_t(from)];
        const PlanePoint b = window.Columns[std::size_t(to)];
        box.Add(a);
        box.Add(b);
        const double slope = a.Y == b.Y ? 0.0 : (double(b.X) - a.X) / (double(b.Y) - a.Y);
        for (std::int32_t row = box.Least.Y - reach; row <= box.Greatest.Y + reach; ++row)
        {
          const auto xAt = [&](std::int32_t y)
          { return a.X + slope * (double(std::clamp(y, box.Least.Y, box.Greatest.Y)) - a.Y); };
          const auto [left, right] = a.Y == b.Y
            ? std::make_pair(double(box.Least.X), double(box.Greatest.X))
            : std::make_pair(std::min(xAt(row - reach), xAt(row + reach)), std::max(xAt(row - reach), xAt(row + reach)));
          const PlanePoint first{ std::int32_t(std::floor(left)) - reach, row };
          for (auto column = std::lower_bound(begin, window.Columns.end(), first, PrecedesByRow);
               column != window.Columns.end() && column->Y == row && column->X <= right + reach; ++column)
          {
            const auto point = std::size_t(column - begin);
            states[point] = IsLeftOut(window, point) ? PointState::Away : PointState::Beside;
          }
        }
      });
    for (std::size_t n = 0; n < states.size(); ++n)
    {
      states[n] = isCovered[n] != 0 ? PointState::Inside : states[n];
    }
    for (const PointId point : input.Dropped)
    {
      states[std::size_t(point - window.First)] = PointState::Beside;
    }
    loops.ForEachEdge(
      [&](PointId from, PointId to)
      {
        ForEachColumnBetween(window.Columns[std::size_t(from)], window.Columns[std::size_t(to)],
          [&](const PlanePoint& between, double)
          {
            const auto column = std::lower_bound(begin, window.Columns.end(), between, PrecedesByRow);
            if (column != window.Columns.end() && *column == between)
            {
              states[std::size_t(column - begin)] = PointState::Beside;
            }
          });
      });
    loops.ForEachPoint([&](PointId point) { states[std::size_t(point)] = PointState::Inside; });
    return states;
  }

  // ---- Strips ------------------------------------------------------------------------------------------------------
  /// Triangles along the next cut wait for it.
  bool MayGo(std::size_t number, const Corners& corners) const
  {
    if (number + 1 == this->Cuts.size())
    {
      return true;
    }
    const Cut& cut = this->Cuts[number + 1];
    const std::array<PlanePoint, 3> places = { this->At(corners[0]), this->At(corners[1]), this->At(corners[2]) };
    return !cut.IsOpen(places[0], places[1]) && !cut.IsOpen(places[1], places[2]) && !cut.IsOpen(places[2], places[0]);
  }

  /// Edges in the rows beside a cut may be far from links to its points, which bands drop.
  bool IsBeside(std::size_t number, const Corners& corners) const
  {
    const Cut& cut = this->Cuts[number];
    std::int64_t sum = 0;
    bool isNext = false;
    for (const PointId corner : corners)
    {
      const std::int64_t rows = std::int64_t(this->At(corner).Y) - cut.Row;
      sum += rows;
      isNext = isNext || std::abs(rows) <= 1;
    }
    return this->MayGo(number, corners) && (isNext || std::abs(sum) <= 3 * std::int64_t(this->RowsBeside));
  }

  /// Takes triangles from both bands, and adds the strip to the second one.
  void MeshStrip(std::size_t number, PartMesh& below, PartMesh& above, const Monitor& monitor)
  {
    const std::vector<PartMesh*> meshes = { &below, &above };
    PointWindow window;
    PartMesh made = this->Remesh(
      meshes, &this->Cuts[number], [&](const Corners& corners) { return this->IsBeside(number, corners); }, window,
      monitor.Step(0.0, 0.8));
    for (std::int32_t around = LeastAround;; around += LeastAround)
    {
      this->AddFar(window, made, meshes);
      if (around <= MostAroundSlivers)
      {
        this->AddSlivers(made);
      }
      std::sort(this->Far.begin(), this->Far.end(), PrecedesByRow);
      above.Add(made);
      if (this->Far.empty() || around > MostAround)
      {
        return; // The next strip tries what is left.
      }
      const std::vector<PlanePoint> far = std::exchange(this->Far, std::vector<PlanePoint>());
      made = this->Remesh(
        meshes, nullptr,
        [&](const Corners& corners) { return this->MayGo(number, corners) && this->IsNear(far, corners, around); },
        window, monitor.Step(0.8, 1.0));
    }
  }

  /// Whether the box of a triangle is so near to one of the places, which ascend by rows.
  bool IsNear(const std::vector<PlanePoint>& places, const Corners& corners, std::int32_t distance) const
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

  /// Edges inside a part cannot always stay near links that leave the part.
  void AddFar(const PointWindow& window, const PartMesh& made, const std::vector<PartMesh*>& others)
  {
    const double bound = MaximumCrossingError(this->Options.MaximumError, this->Options.Crossings);
    if (made.Triangles.empty() || bound == std::numeric_limits<double>::infinity())
    {
      return;
    }
    const auto isDropped = [&](std::int64_t n)
    {
      const PointId point = window.First + PointId(n);
      return IsLeftOut(window, std::size_t(n)) || made.Dropped.count(point) > 0 ||
        std::any_of(
          others.begin(), others.end(), [&](const PartMesh* mesh) { return mesh->Dropped.count(point) > 0; });
    };
    const HeightRaster raster(std::int64_t(window.Columns.size()),
      [&](std::int64_t n) { return isDropped(n) ? NoPoint : PointId(n); }, window.Columns, window.Height.data(),
      this->Options.Cuts);
    const double rounding =
      UnitsOfRounding * std::max(std::abs(raster.LowestHeight()), std::abs(raster.HighestHeight()));
    std::unordered_set<std::uint64_t> edges;
    for (const Corners& corners : made.Triangles)
    {
      for (std::size_t n = 0; n < 3; ++n)
      {
        const PointId from = corners[n];
        const PointId to = corners[(n + 1) % 3];
        edges.insert(KeyOf(from, to));
        if (edges.count(KeyOf(to, from)) > 0)
        {
          const RaisedPoint start{ this->At(from), made.Heights.at(from) };
          const RaisedPoint end{ this->At(to), made.Heights.at(to) };
          if (raster.MeasureCrossings(start, end).Inside > bound + rounding)
          {
            this->Far.push_back({ (start.Column.X + end.Column.X) / 2, (start.Column.Y + end.Column.Y) / 2 });
          }
        }
      }
    }
  }

  void AddSlivers(const PartMesh& made)
  {
    const double sine = SineOfDegrees(this->Options.SmallestAngle);
    for (const Corners& corners : made.Triangles)
    {
      const PlanePoint a = this->At(corners[0]);
      const bool isBesideOther = std::any_of(
        corners.begin(), corners.end(), [&made](PointId corner) { return made.Locked.count(corner) > 0; });
      if (isBesideOther && SineOfSmallestAngle(a, this->At(corners[1]), this->At(corners[2])) < sine)
      {
        this->Far.push_back(a);
      }
    }
  }

  /// Takes the triangles that are chosen, and meshes their area anew. Edges along an open cut go.
  template <typename IsChosen>
  PartMesh Remesh(const std::vector<PartMesh*>& meshes, const Cut* cut, IsChosen&& isChosen, PointWindow& window,
    const Monitor& monitor) const
  {
    std::vector<Corners> taken;
    for (PartMesh* const mesh : meshes)
    {
      const auto first = std::stable_partition(mesh->Triangles.begin(), mesh->Triangles.end(),
        [&](const Corners& corners) { return !isChosen(corners); });
      taken.insert(taken.end(), first, mesh->Triangles.end());
      mesh->Triangles.erase(first, mesh->Triangles.end());
    }
    const StripSides sides = this->FindSides(cut, taken, meshes);
    PartInput input = this->MakeStrip(sides, meshes);
    for (PartMesh* const mesh : meshes)
    {
      mesh->LetGo(sides.Outer, input.Dropped);
    }
    if (cut)
    {
      for (PartMesh* const mesh : meshes)
      {
        for (auto chain = mesh->Chains.begin(); chain != mesh->Chains.end();)
        {
          const bool isGone = cut->IsOpen(this->At(chain->second.front()), this->At(chain->second.back()));
          chain = isGone ? mesh->Chains.erase(chain) : std::next(chain);
        }
      }
    }
    if (taken.empty())
    {
      return {};
    }
    std::int32_t first = std::numeric_limits<std::int32_t>::max();
    std::int32_t last = std::numeric_limits<std::int32_t>::min();
    const auto addRow = [&](PointId point)
    {
      first = std::min(first, this->At(point).Y);
      last = std::max(last, this->At(point).Y);
    };
    std::for_each(input.Edges.begin(), input.Edges.end(), [&](const Edge& edge) { addRow(edge.From); });
    std::for_each(input.Dropped.begin(), input.Dropped.end(), addRow);
    PartMesh made = this->MeshPart(std::move(input), first, last, window, monitor);
    for (const std::uint64_t key : sides.Inner)
    {
      made.Chains.erase(key);
      made.Locked.insert({ FromOf(key), ToOf(key) });
    }
    return made;
  }

  /// Keys of edges of the loops around a strip, ascending.
  struct StripSides
  {
    std::vector<std::uint64_t> Inner;
    std::vector<std::uint64_t> Outer; // of outlines
  };

  StripSides FindSides(
    const Cut* cut, const std::vector<Corners>& triangles, const std::vector<PartMesh*>& meshes) const
  {
    std::vector<std::uint64_t> edges;
    for (const Corners& corners : triangles)
    {
      for (std::size_t n = 0; n < 3; ++n)
      {
        edges.push_back(KeyOf(corners[(n + 1) % 3], corners[n])); // loops have the surface to their right
      }
    }
    std::sort(edges.begin(), edges.end());
    StripSides sides;
    for (const std::uint64_t key : edges)
    {
      const PointId from = FromOf(key);
      const PointId to = ToOf(key);
      if (std::binary_search(edges.begin(), edges.end(), KeyOf(to, from)) ||
        (cut && cut->IsOpen(this->At(from), this->At(to))))
      {
        continue;
      }
      const bool isOuter = std::any_of(
        meshes.begin(), meshes.end(), [key](const PartMesh* mesh) { return mesh->Chains.count(key) > 0; });
      (isOuter ? sides.Outer : sides.Inner).push_back(key);
    }
    return sides;
  }

  /// Outlines are simplified anew, unless the boundary there crosses edges that stay.
  PartInput MakeStrip(const StripSides& sides, const std::vector<PartMesh*>& meshes) const
  {
    PartInput input;
    std::vector<Edge>& edges = input.Edges;
    std::map<std::int32_t, std::vector<std::uint64_t>> byRow;
    const auto lock = [&](std::uint64_t key)
    {
      for (const PointId end : { FromOf(key), ToOf(key) })
      {
        const auto mesh = std::find_if( // the last one knows what has changed
          meshes.rbegin(), meshes.rend(), [end](const PartMesh* one) { return one->Heights.count(end) > 0; });
        input.Fixed.insert(end);
        input.Locked.emplace(end, (*mesh)->Heights.at(end));
      }
      edges.push_back({ FromOf(key), ToOf(key) });
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
    for (const std::uint64_t key : sides.Outer)
    {
      const PartMesh& mesh = **std::find_if(
        meshes.begin(), meshes.end(), [key](const PartMesh* one) { return one->Chains.count(key) > 0; });
      const std::vector<PointId>& chain = mesh.Chains.at(key);
      if (this->Crosses(chain, input.Fixed, byRow))
      {
        lock(key);
        for (std::size_t n = 1; n + 1 < chain.size(); ++n)
        {
          if (mesh.Dropped.count(chain[n]) > 0)
          {
            input.Dropped.insert(chain[n]);
          }
        }
        continue;
      }
      for (std::size_t n = 1; n < chain.size(); ++n)
      {
        edges.push_back({ chain[n - 1], chain[n] });
      }
    }
    return input;
  }

  bool Crosses(const std::vector<PointId>& chain, const std::set<PointId>& stay,
    const std::map<std::int32_t, std::vector<std::uint64_t>>& byRow) const
  {
    for (std::size_t n = 1; n < chain.size(); ++n)
    {
      const PlanePoint a = this->At(chain[n - 1]);
      const PlanePoint b = this->At(chain[n]);
      if (n + 1 < chain.size() && stay.count(chain[n]) > 0)
      {
        return true;
      }
      for (std::int32_t row = std::min(a.Y, b.Y); row <= std::max(a.Y, b.Y); ++row)
      {
        const auto edges = byRow.find(row);
        if (edges == byRow.end())
        {
          continue;
        }
        for (const std::uint64_t key : edges->second)
        {
          const PlanePoint c = this->At(FromOf(key));
          const PlanePoint d = this->At(ToOf(key));
          if (ProperlyCross(a, b, c, d) || OnOpenSegment(c, d, a) || OnOpenSegment(c, d, b) || OnOpenSegment(a, b, c) ||
            OnOpenSegment(a, b, d))
          {
            return true;
          }
        }
      }
    }
    return false;
  }

  // ---- The whole ---------------------------------------------------------------------------------------------------
  struct Piece
  {
    std::int32_t FirstRow = std::numeric_limits<std::int32_t>::max();
    std::int32_t LastRow = std::numeric_limits<std::int32_t>::min();
    std::size_t End = 0; // of its triangles
  };

  void Finish(const PartMesh& mesh)
  {
    Piece piece;
    for (const Corners& corners : mesh.Triangles)
    {
      for (const PointId point : corners)
      {
        const std::int32_t row = this->At(point).Y;
        piece.FirstRow = std::min(piece.FirstRow, row);
        piece.LastRow = std::max(piece.LastRow, row);
        this->Vertices.emplace_back(point, mesh.Heights.at(point));
      }
      this->Triangles.push_back(corners);
    }
    for (const auto& [key, chain] : mesh.Chains)
    {
      this->OnOutlines.push_back(chain.front());
      this->OnOutlines.push_back(chain.back());
    }
    piece.End = this->Triangles.size();
    if (!mesh.Triangles.empty())
    {
      this->Pieces.push_back(piece);
    }
    std::vector<PointId>& added = this->Result.AddedToOutlines;
    added.insert(added.end(), mesh.AddedToOutlines.begin(), mesh.AddedToOutlines.end());
  }

  void Assemble(const TakeTargets& take, const Monitor& monitor)
  {
    std::sort(this->Vertices.begin(), this->Vertices.end());
    this->Vertices.erase(std::unique(this->Vertices.begin(), this->Vertices.end()), this->Vertices.end());
    this->SimplifyLoops();
    Decimation& mesh = this->Result.Mesh;
    std::vector<RaisedPoint> raised;
    for (const auto& [point, height] : this->Vertices)
    {
      mesh.Points.Source.push_back(point);
      mesh.Points.Plane.push_back(this->At(point));
      mesh.Points.Height.push_back(height);
      raised.push_back({ mesh.Points.Plane.back(), height });
    }
    mesh.Points.Averaged.assign(this->Vertices.size(), 0);
    mesh.Points.Boundary = this->Outlines.RenumberedBy([this](PointId point) { return this->VertexOf(point); });
    for (const Corners& corners : this->Triangles)
    {
      for (const PointId point : corners)
      {
        mesh.Triangles.push_back(this->VertexOf(point));
      }
    }
    const PlaneMesh plane(mesh.Points.Plane, mesh.Triangles);
    const double sine = SineOfDegrees(this->Options.SmallestAngle);
    for (TriangleId triangle = 0; triangle < plane.Size(); ++triangle)
    {
      mesh.NumberOfSlivers += plane.SineOf(triangle) < sine ? 1 : 0;
    }
    this->Measure(plane, raised, take, monitor);
    if (MeshChecker::IsOn)
    {
      MeshChecker::Require(
        "MakeInParts", mesh.Points.Plane, mesh.Points.Boundary, mesh.Triangles, MeshChecker::Kind::Any);
    }
  }

  void SimplifyLoops()
  {
    const auto numberOf = [this](PointId point)
    {
      return PointId(
        std::lower_bound(this->LoopPoints.begin(), this->LoopPoints.end(), point) - this->LoopPoints.begin());
    };
    const auto pointOf = [this](PointId number) { return this->LoopPoints[std::size_t(number)]; };
    std::vector<PlanePoint> columns;
    std::transform(this->LoopPoints.begin(), this->LoopPoints.end(), std::back_inserter(columns),
      [this](PointId point) { return this->At(point); });
    std::vector<unsigned char> isKept(columns.size(), 0);
    for (const PointId point : this->OnOutlines)
    {
      isKept[std::size_t(numberOf(point))] = 1;
    }
    for (const std::vector<PointId>& alone : this->Alone)
    {
      std::for_each(alone.begin(), alone.end(), [&](PointId point) { isKept[std::size_t(numberOf(point))] = 1; });
    }
    const BoundarySimplification simplified =
      KeepOnly(SpacePoints(columns, this->LoopHeights, 1), this->Exact.RenumberedBy(numberOf), isKept);
    this->Outlines = simplified.Boundary.RenumberedBy(pointOf);
    for (const DroppedPoint& dropped : simplified.Dropped)
    {
      this->Dropped.push_back({ pointOf(dropped.Point), pointOf(dropped.Target) });
    }
    this->Result.BoundaryDeviation = simplified.Deviation;
    this->Result.OutlineDeviation = simplified.OutlineDeviation;
    this->Result.OutlineHeightDeviation = simplified.HeightDeviation;
    this->Result.NumberOutside = simplified.NumberOutside;
    for (std::size_t n = 0; n < isKept.size(); ++n) // those without a triangle
    {
      if (isKept[n] != 0)
      {
        const PointId point = pointOf(PointId(n));
        const auto place = std::lower_bound(this->Vertices.begin(), this->Vertices.end(), point, PrecedesPoint);
        if (place == this->Vertices.end() || place->first != point)
        {
          this->Single.emplace_back(point, this->LoopHeights[n]);
        }
      }
    }
    const auto middle = std::ptrdiff_t(this->Vertices.size());
    this->Vertices.insert(this->Vertices.end(), this->Single.begin(), this->Single.end());
    std::inplace_merge(this->Vertices.begin(), this->Vertices.begin() + middle, this->Vertices.end());
  }

  static bool PrecedesPoint(const std::pair<PointId, double>& vertex, PointId point) { return vertex.first < point; }

  PointId VertexOf(PointId point) const
  {
    return PointId(
      std::lower_bound(this->Vertices.begin(), this->Vertices.end(), point, PrecedesPoint) - this->Vertices.begin());
  }

  /// Pieces follow each other, so that rows before the next ones are complete.
  void Measure(
    const PlaneMesh& plane, const std::vector<RaisedPoint>& raised, const TakeTargets& take, const Monitor& monitor)
  {
    MeshErrors errors(plane, raised);
    TargetRows targets(*this, take);
    std::vector<unsigned char>& averaged = this->Result.Mesh.Points.Averaged;
    std::size_t first = 0;
    for (std::size_t n = 0; n < this->Pieces.size(); ++n)
    {
      const Piece& piece = this->Pieces[n];
      const PointWindow window = this->Rows.Read(piece.FirstRow, piece.LastRow);
      targets.Add(window);
      const auto size = PointId(window.Columns.size());
      std::vector<PointId> dropped;
      std::vector<unsigned char> isDropped(std::size_t(size), 0);
      const auto begin = std::lower_bound(this->Dropped.begin(), this->Dropped.end(), window.First,
        [](const DroppedPoint& one, PointId point) { return one.Point < point; });
      for (auto one = begin; one != this->Dropped.end() && one->Point < window.First + size; ++one)
      {
        dropped.push_back(one->Point - window.First);
        isDropped[std::size_t(dropped.back())] = 1;
      }
      const HeightRaster raster(
        size,
        [&](std::int64_t point)
        {
          const auto n = std::size_t(point);
          return isDropped[n] != 0 || IsLeftOut(window, n) ? NoPoint : PointId(point);
        },
        window.Columns, window.Height.data(), this->Options.Cuts, dropped);
      errors.Measure(
        TriangleId(first), TriangleId(piece.End), [&](TriangleId) -> const HeightRaster& { return raster; },
        [&](PointId point, VertexId vertex) { targets.Set(window.First + point, PointId(vertex)); },
        monitor.Step(double(n) / double(this->Pieces.size()), double(n + 1) / double(this->Pieces.size())));
      for (PointId vertex = this->FirstVertexFrom(window.First); vertex < this->FirstVertexFrom(window.First + size); ++vertex)
      {
        const auto& [point, height] = this->Vertices[std::size_t(vertex)];
        const double own = window.Height[std::size_t(point - window.First)];
        if (averaged[std::size_t(vertex)] == 0 && height != own)
        {
          averaged[std::size_t(vertex)] = 1;
          errors.Sum += std::abs(height - own);
        }
      }
      first = piece.End;
      std::int32_t next = std::numeric_limits<std::int32_t>::max();
      for (std::size_t later = n + 1; later < this->Pieces.size(); ++later)
      {
        next = std::min(next, this->Pieces[later].FirstRow);
      }
      targets.Complete(n + 1 < this->Pieces.size() ? this->Rows.FirstOf(next) : window.First + size);
    }
    targets.Complete(this->Rows.FirstOf(this->Box.Greatest.Y + 1));
    WriteErrors(std::move(errors), this->Vertices.size(), this->Result.Mesh);
  }

  PointId FirstVertexFrom(PointId point) const { return this->VertexOf(point); }

  /// Targets of points that are not complete yet.
  class TargetRows
  {
  public:
    TargetRows(const PartedSurface& surface, const TakeTargets& take)
      : Whole(surface)
      , Take(take)
    {
    }

    void Add(const PointWindow& window)
    {
      const auto end = std::size_t(window.First - this->First) + window.Columns.size();
      this->Targets.resize(std::max(this->Targets.size(), end), NoPoint);
    }

    void Set(PointId point, PointId vertex) { this->Targets[std::size_t(point - this->First)] = vertex; }

    void Complete(PointId end)
    {
      if (end <= this->First)
      {
        return;
      }
      std::vector<PointId> whole(std::size_t(end - this->First), NoPoint);
      std::copy_n(this->Targets.begin(), std::min(whole.size(), this->Targets.size()), whole.begin());
      for (PointId vertex = this->Whole.VertexOf(this->First); vertex < this->Whole.VertexOf(end); ++vertex)
      {
        whole[std::size_t(this->Whole.Vertices[std::size_t(vertex)].first - this->First)] = vertex;
      }
      const auto begin = std::lower_bound(this->Whole.Dropped.begin(), this->Whole.Dropped.end(), this->First,
        [](const DroppedPoint& one, PointId point) { return one.Point < point; });
      for (auto one = begin; one != this->Whole.Dropped.end() && one->Point < end; ++one)
      {
        whole[std::size_t(one->Point - this->First)] = this->Whole.VertexOf(one->Target);
      }
      this->Take(this->First, whole);
      this->Targets.erase(
        this->Targets.begin(), this->Targets.begin() + std::ptrdiff_t(std::min(whole.size(), this->Targets.size())));
      this->First = end;
    }

  private:
    const PartedSurface& Whole;
    const TakeTargets& Take;
    PointId First = 0;
    std::vector<PointId> Targets;
  };

  static PointId FromOf(std::uint64_t key) { return PointId(std::uint32_t(key >> 32U)); }
  static PointId ToOf(std::uint64_t key) { return PointId(std::uint32_t(key)); }

  const PointRows& Rows;
  SurfaceOptions Options;
  Surface& Result;
  const Loops& Exact;
  const PlaneBox Box;
  std::vector<Cut> Cuts;
  std::int32_t RowsBeside = 0;
  std::vector<std::vector<Edge>> Edges; // of loops, by band
  std::vector<std::vector<PointId>> Alone; // loops of one point, by band
  std::unordered_set<PointId> Shared; // stay on outlines
  std::vector<PointId> LoopPoints; // ascending
  std::vector<double> LoopHeights;
  std::vector<PlanePoint> Far; // where a strip is not good yet, ascending by rows
  std::vector<Piece> Pieces;
  std::vector<Corners> Triangles;
  std::vector<std::pair<PointId, double>> Vertices; // ascending, with heights
  std::vector<std::pair<PointId, double>> Single;
  std::vector<PointId> OnOutlines;
  Loops Outlines;
  DroppedPoints Dropped;
};
}

//----------------------------------------------------------------------------------------------------------------------
RowsInMemory::RowsInMemory(PlanePoints columns, const std::vector<double>& height, const PlaneBox& box)
  : Columns(columns)
  , Height(height)
  , Area(box)
{
}

//----------------------------------------------------------------------------------------------------------------------
PointId RowsInMemory::FirstOf(std::int32_t row) const
{
  const auto first = std::partition_point(
    this->Columns.begin(), this->Columns.end(), [row](const PlanePoint& column) { return column.Y < row; });
  return PointId(first - this->Columns.begin());
}

//----------------------------------------------------------------------------------------------------------------------
PointWindow RowsInMemory::Read(std::int32_t firstRow, std::int32_t lastRow) const
{
  PointWindow window;
  window.First = this->FirstOf(firstRow);
  const PointId end = this->FirstOf(lastRow + 1);
  window.Columns.assign(this->Columns.begin() + window.First, this->Columns.begin() + end);
  window.Height.assign(this->Height.begin() + window.First, this->Height.begin() + end);
  return window;
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
  const Monitor& monitor, const TakeTargets& take)
{
  const TakeTargets fill = [&](PointId, const std::vector<PointId>& targets)
  {
    RawVector<PointId>& all = surface.Mesh.Points.Target;
    all.insert(all.end(), targets.begin(), targets.end());
  };
  PartedSurface(rows, rowsOfPart, options, surface).Run(take ? take : fill, monitor);
}

namespace
{
/// Calls visit(columns, heights) for blocks of rows.
template <typename Visitor>
void ForEachBlock(const RowReader& rows, const Monitor& monitor, Visitor&& visit)
{
  const PlaneBox box = rows.Box();
  const std::int32_t step = RowsOfBand(box);
  for (std::int64_t row = box.Least.Y; row <= box.Greatest.Y; row += step)
  {
    monitor.Progress(double(row - box.Least.Y) / (double(box.Greatest.Y) - box.Least.Y + 1.0));
    std::vector<PlanePoint> columns;
    std::vector<double> height;
    rows.Read(std::int32_t(row), std::int32_t(std::min<std::int64_t>(row + step - 1, box.Greatest.Y)), columns, height);
    visit(columns, height);
  }
}

class IndexedRows : public PointRows
{
public:
  IndexedRows(const RowReader& rows, const ColumnIndex& index, const PatchSpans& patches, bool areAllKept)
    : Rows(rows)
    , Index(index)
    , Patches(patches)
    , AreAllKept(areAllKept)
    , Area(rows.Box())
  {
  }

  PlaneBox Box() const override { return this->Area; }
  PlanePoint ColumnOf(PointId point) const override { return this->Index.ColumnOf(point); }

  PointId FirstOf(std::int32_t row) const override
  {
    return row > this->Area.Greatest.Y
      ? PointId(this->Index.NumberOfPoints())
      : PointId(this->Index.Rank(this->Index.Place({ this->Area.Least.X, std::max(row, this->Area.Least.Y) })));
  }

  PointWindow Read(std::int32_t firstRow, std::int32_t lastRow) const override
  {
    PointWindow window;
    window.First = this->FirstOf(firstRow);
    this->Rows.Read(std::max(firstRow, this->Area.Least.Y), std::min(lastRow, this->Area.Greatest.Y), window.Columns,
      window.Height);
    if (window.Columns.size() != std::size_t(this->FirstOf(lastRow + 1) - window.First))
    {
      throw InputError(std::to_string(window.Columns.size()) + " points in rows " + std::to_string(firstRow) + " to " +
        std::to_string(lastRow) + ", expected the " + std::to_string(this->FirstOf(lastRow + 1) - window.First) +
        " that were there before: the file has changed");
    }
    if (!this->AreAllKept)
    {
      window.IsLeftOut.assign(window.Columns.size(), 0);
      this->Patches.ForEach(window.First, window.First + PointId(window.Columns.size()),
        [&window](PointId first, PointId last, std::int32_t patch)
        {
          const auto begin = window.IsLeftOut.begin() - window.First;
          std::fill(begin + first, begin + last, patch == NoPatch ? 1 : 0);
        });
    }
    return window;
  }

private:
  const RowReader& Rows;
  const ColumnIndex& Index;
  const PatchSpans& Patches;
  const bool AreAllKept;
  const PlaneBox Area;
};

/// Makes the surface of all points.
RowSurface MakeAtOnce(
  const RowReader& rows, const SurfaceOptions& options, const TakeTargets& take, const Monitor& monitor)
{
  std::vector<PlanePoint> columns;
  std::vector<double> height;
  rows.Read(rows.Box().Least.Y, rows.Box().Greatest.Y, columns, height);
  RowSurface result;
  Surface& made = result.Made;
  made = MakeSurface({ columns, std::move(height) }, options, monitor);
  std::vector<PointId> targets(columns.size(), NoPoint);
  result.Patches = PatchSpans(columns.size());
  std::vector<std::int32_t> patches(columns.size(), NoPatch);
  for (std::size_t n = 0; n < made.Kept.size(); ++n)
  {
    const auto point = std::size_t(made.Kept[n]);
    patches[point] = made.Boundary.Patch[n];
    targets[point] = made.Mesh.Points.Target[n];
  }
  for (std::size_t point = 0; point < patches.size(); ++point)
  {
    result.Patches.Append(PointId(point), patches[point]);
  }
  const auto numberOf = [&](PointId point) { return made.Kept[std::size_t(point)]; };
  made.Boundary.Boundary = made.Boundary.Boundary.RenumberedBy(numberOf);
  for (std::vector<PointId>* const points : { &made.Mesh.Points.Source, &made.AddedToOutlines })
  {
    std::transform(points->begin(), points->end(), points->begin(), numberOf);
  }
  result.DroppedPoints = std::int64_t(columns.size() - made.Kept.size());
  made.Boundary.Patch.clear();
  made.Mesh.Points.Target.clear();
  made.Dropped.clear();
  made.Kept = KeptPoints();
  take(0, targets);
  return result;
}
}

//----------------------------------------------------------------------------------------------------------------------
RowSurface MakeSurface(const RowReader& rows, const SurfaceOptions& given, std::int64_t mostAtOnce,
  const TakeTargets& take, const Monitor& monitor)
{
  RowSurface result;
  const PlaneBox box = rows.Box();
  if (box.IsEmpty())
  {
    return result;
  }
  SurfaceOptions options = given;
  constexpr int rim = 2;
  GapCounter gaps(box);
  const ColumnIndex index(box, rim,
    [&](auto&& add)
    {
      ForEachBlock(rows, monitor.Step(0.0, 0.2),
        [&](const std::vector<PlanePoint>& columns, const std::vector<double>&)
        {
          gaps.Add(columns);
          std::for_each(columns.begin(), columns.end(), add);
        });
    });
  options.Radius = options.Radius ? *options.Radius : ChooseRadius(gaps.Counted());
  const std::int32_t rowsOfPart = RowsOfPart(box, options, *options.Radius);
  const auto points = std::int64_t(index.NumberOfPoints());
  if (rowsOfPart == 0)
  {
    if (points > mostAtOnce)
    {
      throw InputError(std::to_string(points) + " points to be meshed at once (with a radius above 1, another effort than "
        "Best, a number of triangles, or an edge length), expected at most " + std::to_string(mostAtOnce));
    }
    return MakeAtOnce(rows, options, take, monitor.Step(0.2, 1.0));
  }
  Surface& made = result.Made;
  made.Parameters = ParametersWithin(options);
  BoundaryOptions ofBoundary;
  ofBoundary.Growth = options.Growth;
  ofBoundary.KeepHoles = options.KeepHoles;
  ofBoundary.MinimumPatchSize = options.MinimumPatchSize;
  ofBoundary.SmallestHoleSize = made.Parameters.SmallestHoleSize;
  RowBoundary boundary = FindExteriorBoundary(index, ofBoundary, monitor.Step(0.2, 0.25));
  made.Boundary.Boundary = std::move(boundary.Boundary);
  made.Boundary.NumberOfPatches = boundary.NumberOfPatches;
  result.Patches = std::move(boundary.Patches);
  result.DroppedPoints =
    std::accumulate(boundary.PatchSizes.begin(), boundary.PatchSizes.end(), points, std::minus<>());
  const IndexedRows indexed(rows, index, result.Patches, result.DroppedPoints == 0);
  MakeInParts(indexed, rowsOfPart, options, made, monitor.Step(0.25, 1.0), take);
  return result;
}
}
