// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LayerPlan.h"

#include "Common/Base/Errors.h"
#include "Common/Base/FixedChunks.h"
#include "Common/Base/Parallel.h"
#include "Common/Base/Parameters.h"
#include "Common/Horizon/BoundedHorizon.h"
#include "Common/Horizon/ColumnIndex.h"
#include "Common/Horizon/KeptPoints.h"
#include "Common/Horizon/MeshChecker.h"
#include "Common/Horizon/PlaneGeometry.h"
#include "Common/Horizon/Types.h"
#include "Crossings.h"
#include "Filters/Algorithms/Boundary/ExteriorBoundary.h"
#include "Filters/Algorithms/Decimation/EdgeSizes.h"
#include "Filters/Algorithms/Decimation/HeightFit.h"
#include "Filters/Algorithms/Decimation/HeightMesh.h"
#include "Filters/Algorithms/Decimation/MeshImprover.h"
#include "Filters/Algorithms/Decimation/MeshRefiner.h"
#include "Filters/Algorithms/Decimation/PlaneMesh.h"
#include "Filters/Algorithms/FaultClosing/FaultClosing.h"
#include "Filters/Algorithms/Surface/Surface.h"
#include "LayerRegions.h"
#include "PinchOuts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
namespace
{
// ---- Layers ---------------------------------------------------------------------------------------------------------
constexpr std::int64_t TriangleGrain = 256; // that a thread takes at a time

struct MeshErrors
{
  double OfColumns = 0.0;
  double OfSides = 0.0;

  void Add(const MeshErrors& other)
  {
    this->OfColumns = std::max(this->OfColumns, other.OfColumns);
    this->OfSides = std::max(this->OfSides, other.OfSides);
  }
};

RawVector<PointId> CornersOf(const PlaneMesh& triangles)
{
  RawVector<PointId> corners;
  corners.reserve(3 * std::size_t(triangles.Size()));
  for (TriangleId triangle = 0; triangle < triangles.Size(); ++triangle)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      corners.push_back(PointId(triangles.Corner(triangle, corner)));
    }
  }
  return corners;
}

class LayerMaker
{
public:
  explicit LayerMaker(const LayerOptions& options)
    : Options(options)
    , OutlineTolerance(options.OutlineTolerance.value_or(ToleranceOfOutlines(options.MaximumError)))
    , Horizons(this->Result.Stack.Filled.Views)
  {
  }

  Layers Run(const std::vector<HorizonView>& horizons, const Monitor& monitor)
  {
    this->Result.Stack = MakeStack(horizons, this->Options, monitor.Step(0.0, 0.1));
    this->Result.Plan.Heights.resize(this->Horizons.size());
    this->Result.Plan.HeightsGrowDownwards = this->Options.Crossings.HeightsGrowDownwards;
    this->Result.LargestErrors.resize(this->Horizons.size());
    this->Result.LargestSideErrors.resize(this->Horizons.size());
    this->Result.LargestThicknessErrors.resize(this->Options.BoundThickness ? this->Horizons.size() - 1 : 0);
    ExteriorBoundary boundary = this->FindBoundary(monitor.Step(0.1, 0.2));
    const KeptPoints kept = DropPointsWithoutPatch(boundary);
    if (kept.empty())
    {
      return this->Finish(monitor.Step(0.9, 1.0));
    }
    this->TakeKept(kept);
    this->IndexHorizons();
    this->FindRegions();
    this->IsOnLine.assign(this->Columns.size(), 0);
    PinchOutLines pinchOuts = this->FindLines(boundary, monitor.Step(0.2, 0.25));
    const std::vector<Edge> borders = this->FindBorders(boundary, pinchOuts.OnOutline);
    this->AddThickness();
    this->Fill();
    LayerOutline outline = SimplifyOutline(this->Columns, this->MeshHeights(), this->Known, this->Horizons,
      this->OwnColumns, boundary, this->OutlineOptions(std::move(pinchOuts.OnOutline)), monitor.Step(0.25, 0.3));
    this->AddColumnsInside(kept, outline);
    this->Index.emplace(this->Columns);
    HeightMesh mesh = this->MakeMesh(std::move(outline), monitor.Step(0.3, 0.4));
    this->KeepBorders(mesh, borders);
    KeptLines lines(mesh, *this->Index, this->MeshHeights(), this->Options.MaximumError, this->IsOnLine);
    lines.Keep(pinchOuts);
    this->Refine(mesh, lines, monitor.Step(0.4, 0.9));
    this->Result.PinchOutLines = lines.Size();
    this->Result.LinesLeftOut = lines.LeftOut();
    this->Collect(mesh, boundary.OpenCracks, monitor.Step(0.9, 0.97));
    this->GiveBack(kept);
    return this->Finish(monitor.Step(0.97, 1.0));
  }

private:
  Layers Finish(const Monitor& monitor)
  {
    this->Result.Ledgers =
      MakeLayerLedgers(this->Result.Plan, this->Result.Stack, this->Horizons, this->OwnColumns, monitor);
    this->Result.Stack.Filled = {};
    return std::move(this->Result);
  }

  /// Takes the points that have a patch. If all have one, they are lent from the result to save memory.
  void TakeKept(const KeptPoints& kept)
  {
    if (kept.AreAll())
    {
      this->Columns.swap(this->Result.Stack.Columns);
      this->Heights.swap(this->Result.Stack.Heights);
      return;
    }
    this->Columns = kept.Select(this->Result.Stack.Columns);
    for (const std::vector<double>& heights : this->Result.Stack.Heights)
    {
      this->Heights.push_back(kept.Select(heights));
    }
  }

  void GiveBack(const KeptPoints& kept)
  {
    if (kept.AreAll())
    {
      this->Heights.resize(this->Horizons.size());
      this->Columns.swap(this->Result.Stack.Columns);
      this->Heights.swap(this->Result.Stack.Heights);
    }
  }

  void IndexHorizons()
  {
    this->OwnColumns.assign(this->Horizons.size(), ColumnIndex(PlanePoints()));
    ParallelFor(std::int64_t(this->Horizons.size()), 1,
      [this](std::int64_t first, std::int64_t last)
      {
        for (auto horizon = std::size_t(first); horizon < std::size_t(last); ++horizon)
        {
          this->OwnColumns[horizon] = ColumnIndex(this->Horizons[horizon].Columns);
        }
      });
  }

  /// Completes the stack where the boundary passes over points of some horizons, so that these count.
  ExteriorBoundary FindBoundary(const Monitor& monitor)
  {
    OrderedStack& stack = this->Result.Stack;
    BoundaryOptions options;
    options.Radius = this->Options.Radius ? *this->Options.Radius : ChooseRadius(stack.Columns);
    options.KeepHoles = true;
    options.SmallestHoleSize = this->Options.SmallestHoleSize
      ? *this->Options.SmallestHoleSize
      : ChooseSmallestHoleSize(options.Radius, this->OutlineTolerance);
    options.Cuts = this->Options.Cuts;
    ExteriorBoundary boundary = FindExteriorBoundary(stack.Columns, options, monitor);
    if (options.Cuts && options.Radius > 1)
    {
      BoundaryOptions uncut = options;
      uncut.Cuts = nullptr;
      this->StripArea = AreaInside(FindExteriorBoundary(stack.Columns, uncut).Boundary) - AreaInside(boundary.Boundary);
    }
    const bool areWhole = options.Radius == 1 && options.SmallestHoleSize <= 1;
    if (this->Options.Domain == LayerDomain::Common && !areWhole)
    {
      const CompletedColumns inside =
        CompleteColumns(this->Horizons, stack.Columns, boundary.Boundary, true, options.Cuts, this->Options.Crossings);
      const std::size_t first = stack.Columns.size();
      inside.AppendTo(stack.Columns, stack.Heights);
      inside.CountIn(stack);
      boundary.Boundary = PassThrough(boundary.Boundary, stack.Columns, first);
      for (const PointId point : inside.OnLoops)
      {
        boundary.Patch.push_back(boundary.Patch[std::size_t(point)]);
      }
    }
    return boundary;
  }

  /// The area in columns, without holes.
  double AreaInside(const Loops& loops) const
  {
    std::int64_t twice = 0;
    loops.ForEachEdge(
      [&](PointId from, PointId to)
      {
        const PlanePoint& a = this->Result.Stack.Columns[std::size_t(from)];
        const PlanePoint& b = this->Result.Stack.Columns[std::size_t(to)];
        twice += std::int64_t(a.X) * (b.Y - a.Y) - std::int64_t(a.Y) * (b.X - a.X);
      });
    return 0.5 * std::abs(double(twice));
  }

  void AddColumnsInside(const KeptPoints& kept, LayerOutline& outline)
  {
    if (this->HasRegions() || this->OutlineTolerance == 0.0)
    {
      return;
    }
    const CompletedColumns inside = CompleteColumns(
      this->Horizons, this->Columns, outline.Boundary, false, this->Options.Cuts, this->Options.Crossings);
    for (const PointId point : inside.OnLoops)
    {
      outline.Patch.push_back(outline.Patch[std::size_t(point)]);
    }
    this->IsOnLine.resize(outline.Patch.size(), 0);
    OrderedStack& stack = this->Result.Stack;
    this->Heights.resize(this->Horizons.size());
    inside.AppendTo(this->Columns, this->Heights);
    if (!kept.AreAll())
    {
      inside.AppendTo(stack.Columns, stack.Heights);
    }
    inside.CountIn(stack);
    this->AddThickness();
  }

  // ---- A domain of its own for each layer --------------------------------------------------------------------------
  bool HasRegions() const { return this->Regions.has_value(); }

  void FindRegions()
  {
    if (this->Options.Domain == LayerDomain::Common)
    {
      return;
    }
    for (std::size_t layer = 0; layer + 1 < this->Heights.size(); ++layer)
    {
      std::vector<unsigned char> isIn(this->Columns.size());
      std::transform(this->Heights[layer].begin(), this->Heights[layer].end(), this->Heights[layer + 1].begin(),
        isIn.begin(), [](double above, double below) { return std::isnan(above - below) ? 0 : 1; });
      this->IsIn.push_back(std::move(isIn));
    }
    this->Regions.emplace(this->Columns, this->IsIn, this->Options.Cuts);
  }

  std::vector<Edge> FindBorders(const ExteriorBoundary& boundary, std::vector<PointId>& onOutline) const
  {
    if (!this->HasRegions())
    {
      return {};
    }
    const std::vector<unsigned char> isOnLoop = boundary.Boundary.MarkPoints(this->Columns.size());
    std::vector<Edge> borders = this->Regions->FindBorders(isOnLoop);
    for (const Edge& border : borders)
    {
      for (const PointId end : { border.From, border.To })
      {
        if (isOnLoop[std::size_t(end)] != 0)
        {
          onOutline.push_back(end);
        }
      }
    }
    return borders;
  }

  /// The first horizon of the mesh is level and has the points of all. Where no layer has an area, its horizons have no
  /// errors, and the heights of the next ones.
  void Fill()
  {
    if (!this->HasRegions())
    {
      return;
    }
    const std::size_t horizons = this->Horizons.size();
    this->Filled.emplace_back(this->Columns.size(), 0.0);
    this->Filled.insert(this->Filled.end(), this->Heights.begin(), this->Heights.end());
    this->Known.assign(this->Filled.size(), std::vector<unsigned char>(this->Columns.size(), 0));
    for (std::size_t point = 0; point < this->Columns.size(); ++point)
    {
      for (std::size_t horizon = 1; horizon < horizons; ++horizon)
      {
        this->FillFrom(horizon - 1, horizon, point);
      }
      for (std::size_t horizon = horizons - 1; horizon-- > 0;)
      {
        this->FillFrom(horizon + 1, horizon, point);
      }
      for (std::size_t layer = 0; layer + 1 < horizons; ++layer)
      {
        const unsigned char isIn = this->Regions->HasArea(layer, PointId(point)) ? 1 : 0;
        this->Known[1 + layer][point] |= isIn;
        this->Known[2 + layer][point] |= isIn;
        const std::size_t thickness = 1 + horizons + layer;
        if (thickness < this->Filled.size())
        {
          this->Known[thickness][point] = isIn;
          this->Filled[thickness][point] = this->Filled[1 + layer][point] - this->Filled[2 + layer][point];
        }
      }
    }
  }

  void FillFrom(std::size_t from, std::size_t horizon, std::size_t point)
  {
    double& height = this->Filled[1 + horizon][point];
    height = std::isnan(height) ? this->Filled[1 + from][point] : height;
  }

  const HeightStack& MeshHeights() const { return this->HasRegions() ? this->Filled : this->Heights; }
  std::size_t InMesh(std::size_t horizon) const { return this->HasRegions() ? 1 + horizon : horizon; }

  /// Keeps borders before any other lines, so that none crosses them.
  void KeepBorders(HeightMesh& mesh, const std::vector<Edge>& borders) const
  {
    if (borders.empty())
    {
      return;
    }
    std::vector<unsigned char> marks(this->Columns.size(), 0);
    for (const Edge& border : borders)
    {
      marks[std::size_t(border.From)] = 1;
      marks[std::size_t(border.To)] = 1;
    }
    MeshRefiner(mesh, 0, DecimationPriority::LargestError).InsertMarked(marks);
    const std::vector<VertexId> vertices = mesh.VerticesByPoint();
    KeptEdges sides(mesh.Triangles(), std::size_t(mesh.EndOfVertices()));
    for (const Edge& border : borders)
    {
      const VertexId from = vertices[std::size_t(border.From)];
      const VertexId to = vertices[std::size_t(border.To)];
      if (from == NoVertex || to == NoVertex || !sides.Keep(from, to))
      {
        const PlanePoint& place = this->Columns[std::size_t(border.From)];
        throw InputError("the border of a layer at column (" + std::to_string(place.X) + ", " +
          std::to_string(place.Y) + ") is not an edge of the plan, expected layers whose borders do not cross");
      }
    }
    mesh.Triangles().MakeDelaunay();
  }

  void FindTriangles()
  {
    LayerPlan& plan = this->Result.Plan;
    for (std::size_t layer = 0; this->HasRegions() && layer < plan.NumberOfLayers(); ++layer)
    {
      std::vector<unsigned char> isIn(plan.NumberOfTriangles());
      for (std::size_t triangle = 0; triangle < isIn.size(); ++triangle)
      {
        isIn[triangle] = this->Regions->Holds(layer, plan.CornersOf(triangle)) ? 1 : 0;
      }
      plan.IsIn.push_back(std::move(isIn));
    }
  }

  /// Bounds the thickness of layers as if they were more horizons.
  void AddThickness()
  {
    this->Heights.resize(this->Horizons.size());
    for (std::size_t layer = 0; layer < this->Result.LargestThicknessErrors.size(); ++layer)
    {
      std::vector<double> thickness(this->Columns.size());
      std::transform(this->Heights[layer].begin(), this->Heights[layer].end(), this->Heights[layer + 1].begin(),
        thickness.begin(), std::minus<>());
      this->Heights.push_back(std::move(thickness));
    }
  }

  HeightMesh MakeMesh(LayerOutline outline, const Monitor& monitor) const
  {
    BoundedHorizon horizon;
    horizon.Columns = this->Columns;
    horizon.Patch = std::move(outline.Patch);
    horizon.Boundary = std::move(outline.Boundary);
    horizon.Cuts = { std::shared_ptr<const LinkCuts>(), this->Options.Cuts }; // not owned
    HeightMesh mesh(std::move(horizon), monitor, this->MeshHeights().front().data());
    for (std::size_t n = 1; n < this->MeshHeights().size(); ++n)
    {
      mesh.AddHorizon(this->MeshHeights()[n], this->HasRegions() ? &this->Known[n] : nullptr);
    }
    return mesh;
  }

  BoundarySimplificationOptions OutlineOptions(std::vector<PointId> fixed) const
  {
    BoundarySimplificationOptions options;
    options.Method = OutlineMethod::FewestPoints;
    options.DistanceThreshold = this->Options.MaximumError;
    options.OutlineTolerance = this->OutlineTolerance;
    options.LongestEdge = LongestAtLoops(this->Options);
    options.Fixed = std::move(fixed);
    return options;
  }

  PinchOutLines FindLines(const ExteriorBoundary& boundary, const Monitor& monitor) const
  {
    if (!this->Options.PinchOutLines)
    {
      return {};
    }
    PinchOutOptions options;
    options.SmallestPinch = this->Options.SmallestPinch;
    options.Tolerance = this->OutlineTolerance;
    options.MaximumError = this->Options.MaximumError;
    options.LongestEdge = LongestAtLoops(this->Options);
    return FindPinchOutLines(
      this->Columns, this->Heights, boundary.Boundary.MarkPoints(this->Columns.size()), options, monitor);
  }

  void Refine(HeightMesh& mesh, KeptLines& lines, const Monitor& monitor)
  {
    DecimationOptions options;
    static_cast<MeshQuality&>(options) = this->Options;
    options.MaximumError = this->Options.MaximumError;
    const HeightRule rule = [&](std::vector<InnerHeights>& heights) { this->OrderFitted(mesh, heights); };
    lines.DropFar();
    InsertToError(mesh, options, monitor.Step(0.0, 0.3), rule);
    while (lines.DropFar()) // lines with fitted ends, or cut by a vertex
    {
      MeshRefiner refiner(mesh, 0, DecimationPriority::LargestError);
      refiner.InsertWhereFar(options.MaximumError, monitor.Step(0.3, 0.3));
      refiner.InsertAtEdges(options.MaximumError, options.MaximumError, monitor.Step(0.3, 0.3));
    }
    if (IsImproved(options))
    {
      ImproveWithinError(mesh, options, monitor.Step(0.3, 1.0),
        [this](const PlanePoint& column, std::vector<double>& heights)
        { this->OrderAt((*this->Index)[this->Index->Place(column)], heights); });
    }
    this->FitHeightsAtFaults(mesh, rule);
  }

  /// Puts heights back where the plan would not be within the error.
  void FitHeightsAtFaults(HeightMesh& mesh, const HeightRule& rule) const
  {
    if (!this->Options.Cuts || !this->Options.FitHeights)
    {
      return;
    }
    std::vector<InnerHeights> fitted =
      FitCutoffs(mesh, *this->Index, this->MeshHeights(), this->Known, *this->Options.Cuts);
    rule(fitted);
    for (bool isFar = true; isFar && !fitted.front().Vertices.empty();)
    {
      const std::vector<InnerHeights> before = mesh.HeightsOf(fitted.front().Vertices);
      MoveHeightsWithin(mesh, this->Options.MaximumError + mesh.Rounding(), fitted);
      const std::vector<unsigned char> isAtFar = this->MarkFarEdges(mesh);
      isFar = std::any_of(fitted.front().Vertices.begin(), fitted.front().Vertices.end(),
        [&](VertexId vertex) { return isAtFar[std::size_t(vertex)] != 0; });
      if (isFar)
      {
        mesh.SetAllHeights(before);
        std::for_each(fitted.begin(), fitted.end(), [&](InnerHeights& own) { own.Drop(isAtFar); });
      }
    }
  }

  std::vector<unsigned char> MarkFarEdges(const HeightMesh& mesh) const
  {
    std::vector<unsigned char> isAtFar(std::size_t(mesh.EndOfVertices()), 0);
    this->ForEachPassed(mesh,
      [&](const PassedPoint& passed)
      {
        for (const VertexId end : passed.Ends)
        {
          isAtFar[std::size_t(end)] |= passed.Error > this->Options.MaximumError + mesh.Rounding() ? 1 : 0;
        }
      });
    return isAtFar;
  }

  // ---- Order of fitted heights -------------------------------------------------------------------------------------
  /// Fitted heights out of order get their mean, which does not increase the largest error. Horizons stay one if they
  /// are one at the neighbours, too, or on a pinch-out line: else noise would pinch thin layers everywhere.
  void OrderFitted(const HeightMesh& mesh, std::vector<InnerHeights>& fitted) const
  {
    std::vector<double> heights(fitted.size());
    for (std::size_t n = 0; n < fitted.front().Vertices.size(); ++n)
    {
      std::transform(
        fitted.begin(), fitted.end(), heights.begin(), [n](const InnerHeights& own) { return own.Heights[n]; });
      this->OrderAt(mesh.SourceOf(fitted.front().Vertices[n]), heights);
      for (std::size_t horizon = 0; horizon < fitted.size(); ++horizon)
      {
        fitted[horizon].Heights[n] = heights[horizon];
      }
    }
  }

  /// Heights are those of the mesh.
  void OrderAt(PointId point, std::vector<double>& fitted) const
  {
    const std::size_t horizons = this->Horizons.size();
    std::vector<double> heights;
    std::vector<unsigned char> isOne;
    std::vector<std::size_t> known;
    for (std::size_t horizon = 0; horizon < horizons; ++horizon)
    {
      if (!std::isnan(this->Heights[horizon][std::size_t(point)]))
      {
        heights.push_back(fitted[this->InMesh(horizon)]);
        isOne.push_back(horizon + 1 < horizons && this->AreOne(horizon, point) ? 1 : 0);
        known.push_back(horizon);
      }
    }
    OrderColumn(heights, isOne, this->Options.Crossings.HeightsGrowDownwards);
    for (std::size_t horizon = 0, next = 0; horizon < horizons; ++horizon)
    {
      next += next + 1 < known.size() && known[next + 1] == horizon ? 1 : 0; // absent ones get the height above
      fitted[this->InMesh(horizon)] = heights[next];
    }
    for (std::size_t layer = 0; horizons + layer < this->Heights.size(); ++layer)
    {
      fitted[this->InMesh(horizons + layer)] = fitted[this->InMesh(layer)] - fitted[this->InMesh(layer + 1)];
    }
  }

  bool AreOne(std::size_t layer, PointId point) const
  {
    const auto thickness = [&](PointId at) {
      return this->Heights[layer][std::size_t(at)] - this->Heights[layer + 1][std::size_t(at)];
    }; // nan without the layer
    if (thickness(point) != 0.0 || this->IsOnLine[std::size_t(point)] != 0)
    {
      return thickness(point) == 0.0;
    }
    const std::int64_t width = this->Index->Width();
    const std::int64_t place = this->Index->Place(this->Columns[std::size_t(point)]);
    for (std::int64_t row = place - width; row <= place + width; row += width)
    {
      for (std::int64_t neighbour = row - 1; neighbour <= row + 1; ++neighbour)
      {
        const PointId other = (*this->Index)[neighbour];
        if (other != NoPoint && std::abs(thickness(other)) > 0.0)
        {
          return false;
        }
      }
    }
    return true;
  }

  // ---- The result --------------------------------------------------------------------------------------------------
  void Collect(HeightMesh& mesh, const Cracks& cracks, const Monitor& monitor)
  {
    mesh.SortVertices();
    LayerPlan& plan = this->Result.Plan;
    RawVector<PointId> corners = CornersOf(mesh.Triangles());
    RawVector<PointId> ofFaults = this->CloseCracks(mesh, cracks);
    this->MeasureStrips(mesh, ofFaults);
    std::vector<PointId> numbers(std::size_t(mesh.EndOfVertices()), NoPoint);
    for (const RawVector<PointId>* const some : { &corners, &ofFaults })
    {
      std::for_each(some->begin(), some->end(), [&numbers](PointId vertex) { numbers[std::size_t(vertex)] = 0; });
    }
    for (VertexId vertex = 0; vertex < mesh.EndOfVertices(); ++vertex)
    {
      if (numbers[std::size_t(vertex)] != NoPoint)
      {
        numbers[std::size_t(vertex)] = PointId(plan.Columns.size());
        plan.Columns.push_back(mesh.Raised(vertex).Column);
        for (std::size_t horizon = 0; horizon < plan.Heights.size(); ++horizon)
        {
          plan.Heights[horizon].push_back(mesh.Height(this->InMesh(horizon), vertex));
        }
      }
    }
    for (RawVector<PointId>* const some : { &corners, &ofFaults })
    {
      std::for_each(some->begin(), some->end(), [&numbers](PointId& vertex) { vertex = numbers[std::size_t(vertex)]; });
    }
    plan.Triangles = std::move(corners);
    plan.FaultTriangles = std::move(ofFaults);
    this->OrderToTheLastDigit(mesh.Rounding());
    this->FindTriangles();
    if (MeshChecker::IsOn)
    {
      this->RequireMesh(mesh);
    }
    this->MeasureErrors(mesh, monitor);
  }

  void MeasureStrips(const HeightMesh& mesh, const RawVector<PointId>& ofFaults)
  {
    const auto point = [&](std::size_t corner) { return std::size_t(mesh.SourceOf(ofFaults[corner])); };
    for (const std::vector<unsigned char>& isIn : this->IsIn)
    {
      std::vector<unsigned char> isAround(ofFaults.size() / 3, 1);
      for (std::size_t corner = 0; corner < ofFaults.size(); ++corner)
      {
        isAround[corner / 3] &= isIn[point(corner)];
      }
      this->Result.Plan.IsAround.push_back(std::move(isAround));
    }
    std::int64_t twice = 0;
    for (std::size_t corner = 0; corner < ofFaults.size(); corner += 3)
    {
      twice +=
        SignedArea(this->Columns[point(corner)], this->Columns[point(corner + 1)], this->Columns[point(corner + 2)]);
    }
    if (this->StripArea && twice != 0)
    {
      this->Result.Plan.FaultShare = std::clamp(2.0 * *this->StripArea / double(twice), 0.0, 1.0);
    }
  }

  RawVector<PointId> CloseCracks(const HeightMesh& mesh, Cracks cracks) const
  {
    const std::vector<VertexId> vertices = mesh.VerticesByPoint();
    const auto vertexOf = [&vertices](PointId point) { return PointId(vertices[std::size_t(point)]); };
    std::vector<PlanePoint> places;
    for (VertexId vertex = 0; vertex < mesh.EndOfVertices(); ++vertex)
    {
      places.push_back(mesh.Raised(vertex).Column);
    }
    for (Edge& openEnd : cracks.OpenEnds)
    {
      openEnd = { vertexOf(openEnd.From), vertexOf(openEnd.To) };
    }
    return CloseFaults(places, mesh.Boundary().RenumberedBy(vertexOf), cracks);
  }

  void RequireMesh(const HeightMesh& mesh) const
  {
    std::vector<PlanePoint> places;
    std::vector<PointId> numbers(this->Columns.size(), NoPoint); // by point
    for (VertexId vertex = 0; vertex < mesh.EndOfVertices(); ++vertex)
    {
      numbers[std::size_t(mesh.SourceOf(vertex))] = PointId(vertex);
      places.push_back(mesh.Raised(vertex).Column);
    }
    MeshChecker::Require(
      "MakeLayers", places, mesh.Boundary().Renumbered(numbers), CornersOf(mesh.Triangles()), MeshChecker::Kind::Any);
  }

  /// Makes heights one that are out of order, or differ, by rounding only.
  void OrderToTheLastDigit(double rounding)
  {
    LayerPlan& plan = this->Result.Plan;
    for (std::size_t horizon = 1; horizon < plan.Heights.size(); ++horizon)
    {
      for (std::size_t vertex = 0; vertex < plan.Columns.size(); ++vertex)
      {
        const double above = plan.Heights[horizon - 1][vertex];
        double& height = plan.Heights[horizon][vertex];
        height = plan.Thickness(horizon - 1, PointId(vertex)) <= rounding ? above : height;
      }
    }
  }

  /// `horizon` may stand for the thickness of a layer, here and below.
  double& LargestErrorOf(std::size_t horizon)
  {
    const std::size_t horizons = this->Horizons.size();
    return horizon < horizons ? this->Result.LargestErrors[horizon]
                              : this->Result.LargestThicknessErrors[horizon - horizons];
  }

  bool IsHorizonIn(std::size_t horizon, std::size_t triangle) const
  {
    const LayerPlan& plan = this->Result.Plan;
    const std::size_t horizons = this->Horizons.size();
    return horizon < horizons ? plan.HasHorizon(horizon, triangle) : plan.HasLayer(horizon - horizons, triangle);
  }

  void MeasureErrors(const HeightMesh& mesh, const Monitor& monitor)
  {
    const auto horizons = double(this->Heights.size());
    for (std::size_t horizon = 0; horizon < this->Heights.size(); ++horizon)
    {
      const auto largest = AddUpChunks<MeshErrors>(mesh.Triangles().Size(), TriangleGrain,
        monitor.Step(double(horizon) / horizons, double(horizon + 1) / horizons),
        [&](MeshErrors& part, std::int64_t first, std::int64_t last)
        {
          for (auto triangle = TriangleId(first); triangle < TriangleId(last); ++triangle)
          {
            if (this->IsHorizonIn(horizon, std::size_t(triangle)))
            {
              AddErrors(mesh, this->InMesh(horizon), triangle, part);
            }
          }
        });
      this->LargestErrorOf(horizon) = largest.OfColumns;
      if (horizon < this->Horizons.size())
      {
        this->Result.LargestSideErrors[horizon] = largest.OfSides;
      }
    }
    this->ForEachPassed(mesh,
      [&](const PassedPoint& passed)
      {
        double& largest = this->LargestErrorOf(passed.Horizon);
        largest = std::max(largest, passed.Error);
      });
  }

  /// Measures a triangle exactly if its error is larger.
  static void AddErrors(const HeightMesh& mesh, std::size_t horizon, TriangleId triangle, MeshErrors& largest)
  {
    const HeightRaster& raster = mesh.RasterOf(horizon, triangle);
    const RaisedTriangle corners = mesh.RaisedCorners(horizon, triangle);
    if (!raster.IsWithin(corners, largest.OfColumns))
    {
      largest.OfColumns = raster.Measure(corners).Largest;
    }
    for (int side = 0; side < 3; ++side)
    {
      const RaisedPoint& from = corners[std::size_t(side)];
      const RaisedPoint& to = corners[std::size_t(NextCorner(side))];
      const bool isInner = mesh.Triangles().Neighbour(triangle, side) > triangle;
      if (isInner && !raster.IsEdgeWithin(from, to, largest.OfSides))
      {
        largest.OfSides = raster.MeasureCrossings(from, to).Largest();
      }
    }
  }

  /// A point below an edge of an outline that the mesh does not count, as its column was dropped from the loop.
  struct PassedPoint
  {
    std::size_t Horizon;
    std::array<VertexId, 2> Ends;
    double Error;
  };

  template <typename Visit>
  void ForEachPassed(const HeightMesh& mesh, Visit&& visit) const
  {
    const PlaneMesh& triangles = mesh.Triangles();
    for (TriangleId triangle = 0; triangle < triangles.Size(); ++triangle)
    {
      for (int side = 0; side < 3; ++side)
      {
        if (triangles.Neighbour(triangle, side) == NoTriangle)
        {
          const std::array<VertexId, 2> ends = { triangles.Corner(triangle, side),
            triangles.Corner(triangle, NextCorner(side)) };
          ForEachColumnBetween(mesh.Raised(ends[0]).Column, mesh.Raised(ends[1]).Column,
            [&](const PlanePoint& place, double part)
            { this->VisitPassed(mesh, triangle, ends, part, place, this->Index->PointAt(place), visit); });
        }
      }
    }
  }

  template <typename Visit>
  void VisitPassed(const HeightMesh& mesh, TriangleId triangle, const std::array<VertexId, 2>& ends, double part,
    const PlanePoint& place, PointId point, Visit&& visit) const
  {
    for (std::size_t horizon = 0; horizon < this->Heights.size(); ++horizon)
    {
      const bool isOfLayers =
        point == NoPoint || !this->HasRegions() || this->Known[1 + horizon][std::size_t(point)] != 0;
      const PointId own =
        point == NoPoint && horizon < this->OwnColumns.size() ? this->OwnColumns[horizon].PointAt(place) : NoPoint;
      if (!this->IsHorizonIn(horizon, std::size_t(triangle)) || !isOfLayers || (point == NoPoint && own == NoPoint))
      {
        continue; // no layer begins or ends amid an edge
      }
      const double given =
        own == NoPoint ? this->Heights[horizon][std::size_t(point)] : this->Horizons[horizon].Heights[own];
      const double start = mesh.Height(this->InMesh(horizon), ends[0]);
      const double height = start + (mesh.Height(this->InMesh(horizon), ends[1]) - start) * part;
      visit(PassedPoint{ horizon, ends, std::abs(height - given) });
    }
  }

  const LayerOptions& Options;
  const double OutlineTolerance; // columns
  Layers Result;
  const std::vector<HorizonView>& Horizons; // with the filled points that the policy allows
  std::vector<PlanePoint> Columns; // with a patch
  HeightStack Heights; // of horizons, and of the thickness of layers if it is bound, by Columns
  std::vector<std::vector<unsigned char>> IsIn; // by layer and Columns: 1 where both horizons are
  std::optional<LayerRegions> Regions; // if each layer has a domain of its own
  HeightStack Filled; // with regions: a level horizon, and then Heights without gaps
  std::vector<std::vector<unsigned char>> Known; // 1 where Filled counts
  std::optional<ColumnIndex> Index; // of Columns, with an empty rim
  std::vector<ColumnIndex> OwnColumns; // by horizon
  std::optional<double> StripArea; // that cuts leave out, if gaps may lie along them
  std::vector<unsigned char> IsOnLine; // by Columns: 1 on pinch-out lines
};
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::array<PointId, 2>> FindFaultSides(const LayerPlan& plan)
{
  const RawVector<PointId>& corners = plan.FaultTriangles;
  std::vector<std::array<PointId, 2>> sides;
  for (std::size_t corner = 0; corner < corners.size(); ++corner)
  {
    sides.push_back({ corners[corner], corners[corner % 3 == 2 ? corner - 2 : corner + 1] });
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

//----------------------------------------------------------------------------------------------------------------------
Layers MakeLayers(const std::vector<HorizonView>& horizons, const LayerOptions& options, const Monitor& monitor)
{
  CheckAtLeast("maximum error", options.MaximumError, 0.0, " lattice units");
  CheckQuality(options, false);
  CheckAtLeast("outline tolerance", options.OutlineTolerance.value_or(0.0), 0.0, " columns");
  if (options.Domain == LayerDomain::EachLayer)
  {
    const bool areLeft = options.Radius.value_or(1) == 1 && options.SmallestHoleSize.value_or(1) == 1 &&
      options.OutlineTolerance.value_or(0.0) == 0.0;
    if (!areLeft)
    {
      throw InputError(
        "outlines that are simplified or holes that are closed where each layer has a domain of its own, "
        "expected a radius and a smallest hole of 1, and a tolerance of 0");
    }
    LayerOptions exact = options;
    exact.Radius = 1;
    exact.SmallestHoleSize = 1;
    exact.OutlineTolerance = 0.0;
    return LayerMaker(exact).Run(horizons, monitor);
  }
  return LayerMaker(options).Run(horizons, monitor);
}
}
