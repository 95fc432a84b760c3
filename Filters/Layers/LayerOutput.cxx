// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LayerOutput.h"

#include "Common/Base/Parallel.h"
#include "Common/Horizon/ColumnIndex.h"
#include "Common/Horizon/DataModel.h"
#include "Common/Horizon/KeptPoints.h"
#include "Common/Horizon/LedgerFields.h"
#include "Common/Survey/ColumnPoints.h"
#include "Filters/Common/HeightUnit.h"
#include "Filters/Common/HorizonCells.h"
#include "Filters/Common/HorizonPoints.h"
#include "LayerFigures.h"
#include "NearestColumns.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
namespace
{
template <typename Place>
DataArray MakeLayerPoints(std::size_t size, const Lattice& lattice, Place&& place)
{
  DataArray points = NewArray<double>("Points", std::int64_t(size), 3);
  auto* const coordinates = points.As<double>();
  ParallelFor(std::int64_t(size), Grain,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t point = first; point < last; ++point)
      {
        const Eigen::Vector3d world = lattice.ToWorld(place(std::size_t(point)));
        std::copy(world.data(), world.data() + 3, coordinates + 3 * point);
      }
    });
  return points;
}

Eigen::Vector3d PlaceInWorld(const PlanePoint& column, double height)
{
  return Eigen::Vector3d(column.X, column.Y, height);
}

/// True if outward normals on the lattice point inwards in the world.
bool IsMirrored(const HorizonStack& stack)
{
  return stack.CommonLattice().KeepsOrientation() == stack.HeightsGrowDownwards();
}

/// Corners are in the order of VTK.
void Mirror(std::int64_t* corners, std::size_t size)
{
  if (size == 6) // The triangles of a wedge swap.
  {
    std::swap_ranges(corners, corners + 3, corners + 3);
    return;
  }
  std::swap(corners[size - 4], corners[size - 2]); // quadrangle of a pyramid, or triangle
}

/// By cell, with bit n for face n of FacesOfCell. A vertical face has two vertices of the plan.
std::vector<unsigned char> FindFaultFaces(const LayerPlan& plan, const LayerCells& cells, const std::int64_t* corners)
{
  const std::vector<std::array<PointId, 2>> sides = FindFaultSides(plan);
  const auto has = [&](PointId a, PointId b) {
    return std::binary_search(sides.begin(), sides.end(), std::array<PointId, 2>{ a, b });
  };
  std::vector<unsigned char> found(cells.Size(), 0);
  for (std::size_t cell = 0; !sides.empty() && cell < cells.Size(); ++cell)
  {
    const auto& faces = FacesOfCell(cells.SizeOf(cell));
    for (std::size_t face = 0; face < faces.size(); ++face)
    {
      std::set<PointId> ends;
      for (const std::size_t corner : faces[face])
      {
        ends.insert(cells.Vertices[std::size_t(corners[cells.Begin(cell) + std::int64_t(corner)])]);
      }
      if (ends.size() == 2 && (has(*ends.begin(), *ends.rbegin()) || has(*ends.rbegin(), *ends.begin())))
      {
        found[cell] = static_cast<unsigned char>(found[cell] | 1U << face);
      }
    }
  }
  return found;
}

/// Vertices of the plan at which a horizon has a height.
struct HorizonVertices
{
  std::vector<PointId> Vertices; // vertices of the plan
  std::vector<PointId> Numbers; // index in Vertices by vertex of the plan, or NoPoint
  KeptPoints Points; // of the horizon, the nearest if the column has none
  std::vector<unsigned char> IsFilled; // 1 at computed heights, 2 outside
};

void FindVertices(const Layers& layers, std::size_t horizon, const std::vector<PointId>& pointAt, PlanePoints columns,
  HorizonVertices& found)
{
  const LayerPlan& plan = layers.Plan;
  const ColumnIndex index(columns);
  assert(pointAt.size() <= plan.Columns.size());
  const ColumnIndex all(layers.Stack.Columns);
  std::optional<NearestColumns> locator; // Few horizons need it.
  const auto nearest = [&](const PlanePoint& column)
  { return (locator ? *locator : locator.emplace(columns)).Find(column); };
  found.Points = KeptPoints(columns.size());
  found.Numbers.assign(plan.Columns.size(), NoPoint);
  for (std::size_t vertex = 0; vertex < pointAt.size(); ++vertex)
  {
    if (pointAt[vertex] != NoPoint)
    {
      const PlanePoint& column = plan.Columns[vertex];
      const PointId point = index.PointAt(column);
      found.Numbers[vertex] = PointId(found.Vertices.size());
      found.Vertices.push_back(PointId(vertex));
      const PointId place = all.PointAt(column);
      const HeightOrigin origin =
        place == NoPoint ? HeightOrigin::None : layers.Stack.Origins[horizon][std::size_t(place)];
      const bool isOutside = Follows(origin) || origin == HeightOrigin::ExtrapolatedBefore;
      found.IsFilled.push_back(isOutside ? 2 : origin == HeightOrigin::Known ? 0 : 1);
      found.Points.Append(point == NoPoint ? nearest(column) : point);
    }
  }
}

RawVector<PointId> TrianglesOf(const LayerPlan& plan, std::size_t horizon, const std::vector<PointId>& numbers)
{
  RawVector<PointId> triangles;
  for (std::size_t triangle = 0; triangle < plan.NumberOfTriangles(); ++triangle)
  {
    for (std::size_t corner = 0; plan.HasHorizon(horizon, triangle) && corner < 3; ++corner)
    {
      triangles.push_back(numbers[std::size_t(plan.Triangles[3 * triangle + corner])]);
    }
  }
  return triangles;
}

/// Skips arrays that differ on the plan.
void CopyArrays(const ArrayTable& given, const KeptPoints& points, ArrayTable& output)
{
  constexpr std::array<const char*, 7> others = { PointArray::Column, PointArray::PatchId, PointArray::Boundary,
    PointArray::PointCount, PointArray::VerticalIndex, PointArray::RealZ, PointArray::Filled };
  for (const DataArray& array : given)
  {
    if (!array.Name.empty() && std::find(others.begin(), others.end(), array.Name) == others.end())
    {
      DataArray copy = array.Select(points);
      copy.ComponentNames.clear();
      copy.Role = -1;
      output.Add(std::move(copy));
    }
  }
}

void AddPlaces(const LayerPlan& plan, std::size_t horizon, const HorizonVertices& own, ArrayTable& output)
{
  DataArray columns = NewColumnArray(std::int64_t(own.Vertices.size()));
  std::transform(own.Vertices.begin(), own.Vertices.end(), ColumnsIn(columns),
    [&plan](PointId vertex) { return plan.Columns[std::size_t(vertex)]; });
  output.Add(std::move(columns));
  AddArray<double>(output, PointArray::VerticalIndex, own.Vertices,
    [&](PointId vertex) { return plan.Heights[horizon][std::size_t(vertex)]; });
  if (std::any_of(own.IsFilled.begin(), own.IsFilled.end(), [](unsigned char value) { return value != 0; }))
  {
    AddArray<unsigned char>(output, PointArray::Filled, own.IsFilled);
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
void WriteLayerCells(const LayerCells& cells, const LayerPlan& plan, const HorizonStack& stack, VolumeGrid& output)
{
  output.Places = MakeLayerPoints(cells.Vertices.size(), stack.CommonLattice(),
    [&](std::size_t point)
    { return PlaceInWorld(plan.Columns[std::size_t(cells.Vertices[point])], cells.Heights[point]); });
  const auto size = std::int64_t(cells.Size());
  output.Cells = { NewArray<std::int64_t>("", size + 1),
    NewArray<std::int64_t>("", std::int64_t(cells.Corners.size())) };
  auto* const offsets = output.Cells.Offsets.As<std::int64_t>();
  auto* const corners = output.Cells.Points.As<std::int64_t>();
  output.Types = NewArray<unsigned char>("", size);
  std::copy(cells.Corners.begin(), cells.Corners.end(), corners);
  const bool isMirrored = IsMirrored(stack);
  offsets[0] = 0;
  for (std::int64_t cell = 0; cell < size; ++cell)
  {
    offsets[cell + 1] = cells.Ends[std::size_t(cell)];
    const auto count = std::size_t(offsets[cell + 1] - offsets[cell]);
    output.Types.As<unsigned char>()[cell] = count == 6 ? VolumeType::Wedge
      : count == 5                                      ? VolumeType::Pyramid
                                                        : VolumeType::Tetrahedron;
    if (isMirrored)
    {
      Mirror(corners + offsets[cell], count);
    }
  }
  const double height = WorldPerIndex(stack.CommonLattice());
  const double volume = VolumeOfUnit(stack);
  ArrayTable& data = output.CellData;
  AddArray<int>(data, CellArray::Layer, cells.Layers);
  AddArray<int>(data, CellArray::Sublayer, cells.Sublayers);
  AddArray<unsigned char>(data, CellArray::FaultFaces, FindFaultFaces(plan, cells, corners));
  AddArray<std::int64_t>(data, CellArray::Triangle, cells.Triangles);
  AddArray<double>(
    data, CellArray::Thickness, cells.Thickness, [height](double thickness) { return height * thickness; });
  AddArray<double>(data, CellArray::Volume, cells.Volumes, [volume](double own) { return volume * own; });
  data.SetActiveScalars(CellArray::Layer);
  output.FieldData.Add({ FieldArray::LayerNames, NamesOfLayers(stack) });
  output.FieldData.Add({ FieldArray::HorizonNames, stack.Names() });
  stack.WriteFields(output.FieldData);
}

//----------------------------------------------------------------------------------------------------------------------
void WriteLayerBody(
  LayerBody body, const LayerPlan& plan, std::size_t layer, const HorizonStack& stack, Horizon& output)
{
  output.Places = MakeLayerPoints(body.Vertices.size(), stack.CommonLattice(),
    [&](std::size_t point)
    { return PlaceInWorld(plan.Columns[std::size_t(body.Vertices[point])], body.Heights[point]); });
  for (std::size_t corner = 0; IsMirrored(stack) && corner < body.Triangles.size(); corner += 3)
  {
    std::swap(body.Triangles[corner], body.Triangles[corner + 1]);
  }
  output.Polygons = MakeTriangles(body.Triangles);
  ArrayTable& data = output.CellData;
  AddArray<unsigned char>(
    data, CellArray::Face, body.Faces, [](BodyFace face) { return static_cast<unsigned char>(face); });
  AddConstant<int>(data, CellArray::Layer, output.NumberOfCells(), int(layer));
  data.SetActiveScalars(CellArray::Layer);
  stack.WriteFields(output.FieldData);
}

//----------------------------------------------------------------------------------------------------------------------
void WriteLayerHorizon(
  const Layers& layers, const LayerCells& cells, std::size_t horizon, const HorizonStack& stack, Horizon& output)
{
  const LayerPlan& plan = layers.Plan;
  HorizonVertices own;
  FindVertices(layers, horizon, cells.PointsOfHorizons[horizon], stack[horizon].Placed.Columns, own);
  output.Places = MakeLayerPoints(own.Vertices.size(), stack.CommonLattice(),
    [&](std::size_t n)
    {
      const auto vertex = std::size_t(own.Vertices[n]);
      return PlaceInWorld(plan.Columns[vertex], plan.Heights[horizon][vertex]);
    });
  RawVector<PointId> triangles = TrianglesOf(plan, horizon, own.Numbers);
  FaceUp(stack.CommonLattice(), triangles);
  output.Polygons = MakeTriangles(triangles);
  CopyArrays(stack[horizon].Points.Horizon.PointData, own.Points, output.PointData);
  AddPlaces(plan, horizon, own, output.PointData);
  ActivateHeight(output);
  ArrayTable& figures = output.FieldData;
  stack.WriteFields(figures);
  const double height = WorldPerIndex(stack.CommonLattice());
  const RepairFigures& moved = layers.Stack.Repair.Horizons[horizon];
  AddValue<double>(figures, FieldArray::LargestError, layers.LargestErrors[horizon]);
  AddValue<std::int64_t>(
    figures, FieldArray::NumberOfOutsidePoints, std::int64_t(layers.Ledgers.PointsOutside[horizon]));
  AddValue<std::int64_t>(figures, FieldArray::TriangleCount, output.Polygons.Size());
  Ledger ledger = layers.Ledgers.OfHorizons[horizon];
  const Horizon& given = stack[horizon].Points.Horizon;
  if (const std::optional<Ledger> before = ReadLedger(given.FieldData))
  {
    const std::int64_t known = CountPoints(given)[LedgerEntry::Known];
    ledger[LedgerEntry::LeftOut] += std::max<std::int64_t>(0, before->Read() - known);
  }
  WriteLedger(ledger, figures);
  AddValue<std::int64_t>(figures, FieldArray::MovedColumns, std::int64_t(moved.Columns));
  AddValue<double>(figures, FieldArray::FarthestMove, height * moved.Largest);
}
}
