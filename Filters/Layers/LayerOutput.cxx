// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LayerOutput.h"

#include "Common/Base/Parallel.h"
#include "Common/Horizon/ColumnIndex.h"
#include "Common/Horizon/DataModel.h"
#include "Common/VTK/ColumnPoints.h"
#include "Common/VTK/DataArrays.h"
#include "Common/VTK/LedgerFields.h"
#include "Filters/Marshalling/HeightUnit.h"
#include "Filters/Marshalling/HorizonCells.h"
#include "Filters/Marshalling/HorizonPoints.h"
#include "LayerFigures.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStaticPointLocator.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <optional>
#include <string>
#include <utility>

namespace SeismicHorizons
{
namespace
{
template <typename Place>
vtkSmartPointer<vtkPoints> MakeLayerPoints(std::size_t size, const Lattice& lattice, Place&& place)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(vtkIdType(size));
  double* const coordinates = vtkDoubleArray::SafeDownCast(points->GetData())->GetPointer(0);
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
void Mirror(vtkIdType* corners, std::size_t size)
{
  if (size == 6) // The triangles of a wedge swap.
  {
    std::swap_ranges(corners, corners + 3, corners + 3);
    return;
  }
  std::swap(corners[size - 4], corners[size - 2]); // quadrangle of a pyramid, or triangle
}

/// Finds points on the map.
vtkSmartPointer<vtkStaticPointLocator> MakeLocator(PlanePoints columns)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const PlanePoint& column : columns)
  {
    points->InsertNextPoint(column.X, column.Y, 0.0);
  }
  vtkNew<vtkPolyData> places;
  places->SetPoints(points);
  auto locator = vtkSmartPointer<vtkStaticPointLocator>::New();
  locator->SetDataSet(places);
  locator->BuildLocator();
  return locator;
}

/// Vertices of the plan at which a horizon has a height.
struct HorizonVertices
{
  std::vector<PointId> Vertices; // vertices of the plan
  std::vector<PointId> Numbers; // index in Vertices by vertex of the plan, or NoPoint
  vtkNew<vtkIdList> Points; // point of the horizon, the nearest if the column has none
  std::vector<unsigned char> IsFilled; // 1 at computed heights, 2 outside
};

void FindVertices(const Layers& layers, std::size_t horizon, const std::vector<PointId>& pointAt, PlanePoints columns,
  HorizonVertices& found)
{
  const LayerPlan& plan = layers.Plan;
  const ColumnIndex index(columns);
  assert(pointAt.size() <= plan.Columns.size());
  const ColumnIndex all(layers.Stack.Columns);
  vtkSmartPointer<vtkStaticPointLocator> locator; // Few horizons need it.
  const auto nearest = [&](const PlanePoint& column)
  {
    locator = locator ? locator : MakeLocator(columns);
    return vtkIdType(locator->FindClosestPoint(column.X, column.Y, 0.0));
  };
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
      found.Points->InsertNextId(point == NoPoint ? nearest(column) : point);
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
void CopyArrays(vtkPointData* given, vtkIdList* points, vtkPointData* output)
{
  constexpr std::array<const char*, 7> others = { PointArray::Column, PointArray::PatchId, PointArray::Boundary,
    PointArray::PointCount, PointArray::VerticalIndex, PointArray::RealZ, PointArray::Filled };
  for (int n = 0; n < given->GetNumberOfArrays(); ++n)
  {
    vtkAbstractArray* const array = given->GetAbstractArray(n);
    const std::string name = array->GetName() ? array->GetName() : "";
    if (!name.empty() && std::find(others.begin(), others.end(), name) == others.end())
    {
      const auto copy = vtkSmartPointer<vtkAbstractArray>::Take(array->NewInstance());
      copy->SetName(array->GetName());
      copy->SetNumberOfComponents(array->GetNumberOfComponents());
      copy->SetNumberOfTuples(points->GetNumberOfIds());
      array->GetTuples(points, copy);
      output->AddArray(copy);
    }
  }
}

void AddPlaces(const LayerPlan& plan, std::size_t horizon, const HorizonVertices& own, vtkPointData* output)
{
  auto columns = NewColumnArray();
  for (const PointId vertex : own.Vertices)
  {
    const PlanePoint& column = plan.Columns[std::size_t(vertex)];
    columns->InsertNextTuple2(column.X, column.Y);
  }
  output->AddArray(columns);
  AddArray<vtkDoubleArray>(output, PointArray::VerticalIndex, own.Vertices,
    [&](PointId vertex) { return plan.Heights[horizon][std::size_t(vertex)]; });
  if (std::any_of(own.IsFilled.begin(), own.IsFilled.end(), [](unsigned char value) { return value != 0; }))
  {
    AddArray<vtkUnsignedCharArray>(output, PointArray::Filled, own.IsFilled);
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
void WriteLayerCells(
  const LayerCells& cells, const LayerPlan& plan, const HorizonStack& stack, vtkUnstructuredGrid* output)
{
  output->SetPoints(MakeLayerPoints(cells.Vertices.size(), stack.CommonLattice(),
    [&](std::size_t point)
    { return PlaceInWorld(plan.Columns[std::size_t(cells.Vertices[point])], cells.Heights[point]); }));
  const auto size = vtkIdType(cells.Size());
  auto offsets = NewArray<vtkIdTypeArray>(nullptr, size + 1);
  auto corners = NewArray<vtkIdTypeArray>(nullptr, vtkIdType(cells.Corners.size()));
  vtkNew<vtkUnsignedCharArray> types;
  types->SetNumberOfTuples(size);
  std::copy(cells.Corners.begin(), cells.Corners.end(), corners->GetPointer(0));
  const bool isMirrored = IsMirrored(stack);
  offsets->SetValue(0, 0);
  for (vtkIdType cell = 0; cell < size; ++cell)
  {
    const vtkIdType first = offsets->GetValue(cell);
    const auto count = std::size_t(cells.Ends[std::size_t(cell)] - first);
    offsets->SetValue(cell + 1, cells.Ends[std::size_t(cell)]);
    types->SetValue(cell, count == 6 ? VTK_WEDGE : count == 5 ? VTK_PYRAMID : VTK_TETRA);
    if (isMirrored)
    {
      Mirror(corners->GetPointer(first), count);
    }
  }
  vtkNew<vtkCellArray> list;
  list->SetData(offsets, corners);
  output->SetCells(types, list);
  const double height = WorldPerIndex(stack.CommonLattice());
  const double volume = VolumeOfUnit(stack);
  vtkCellData* const data = output->GetCellData();
  AddArray<vtkIntArray>(data, CellArray::Layer, cells.Layers);
  AddArray<vtkIdTypeArray>(data, CellArray::Triangle, cells.Triangles);
  AddArray<vtkDoubleArray>(
    data, CellArray::Thickness, cells.Thickness, [height](double thickness) { return height * thickness; });
  AddArray<vtkDoubleArray>(data, CellArray::Volume, cells.Volumes, [volume](double own) { return volume * own; });
  data->SetActiveScalars(CellArray::Layer);
  output->GetFieldData()->AddArray(MakeTexts(FieldArray::LayerNames, NamesOfLayers(stack)));
  stack.WriteFields(output->GetFieldData());
}

//----------------------------------------------------------------------------------------------------------------------
void WriteLayerBody(
  LayerBody body, const LayerPlan& plan, std::size_t layer, const HorizonStack& stack, vtkPolyData* output)
{
  output->SetPoints(MakeLayerPoints(body.Vertices.size(), stack.CommonLattice(),
    [&](std::size_t point)
    { return PlaceInWorld(plan.Columns[std::size_t(body.Vertices[point])], body.Heights[point]); }));
  for (std::size_t corner = 0; IsMirrored(stack) && corner < body.Triangles.size(); corner += 3)
  {
    std::swap(body.Triangles[corner], body.Triangles[corner + 1]);
  }
  output->SetPolys(MakeTriangles(body.Triangles));
  vtkCellData* const data = output->GetCellData();
  AddArray<vtkUnsignedCharArray>(
    data, CellArray::Face, body.Faces, [](BodyFace face) { return static_cast<unsigned char>(face); });
  auto layers = NewArray<vtkIntArray>(CellArray::Layer, output->GetNumberOfCells());
  layers->FillValue(int(layer));
  data->AddArray(layers);
  data->SetActiveScalars(CellArray::Layer);
  stack.WriteFields(output->GetFieldData());
}

//----------------------------------------------------------------------------------------------------------------------
void WriteLayerHorizon(
  const Layers& layers, const LayerCells& cells, std::size_t horizon, const HorizonStack& stack, vtkPolyData* output)
{
  const LayerPlan& plan = layers.Plan;
  HorizonVertices own;
  FindVertices(layers, horizon, cells.PointsOfHorizons[horizon], stack[horizon].Placed.Columns, own);
  output->SetPoints(MakeLayerPoints(own.Vertices.size(), stack.CommonLattice(),
    [&](std::size_t n)
    {
      const auto vertex = std::size_t(own.Vertices[n]);
      return PlaceInWorld(plan.Columns[vertex], plan.Heights[horizon][vertex]);
    }));
  RawVector<PointId> triangles = TrianglesOf(plan, horizon, own.Numbers);
  FaceUp(stack.CommonLattice(), triangles);
  output->SetPolys(MakeTriangles(triangles));
  CopyArrays(stack[horizon].Points.Horizon->GetPointData(), own.Points, output->GetPointData());
  AddPlaces(plan, horizon, own, output->GetPointData());
  ActivateHeight(output);
  vtkFieldData* const figures = output->GetFieldData();
  stack.WriteFields(figures);
  const double height = WorldPerIndex(stack.CommonLattice());
  const RepairFigures& moved = layers.Stack.Repair.Horizons[horizon];
  AddValue<vtkDoubleArray>(figures, FieldArray::LargestError, layers.LargestErrors[horizon]);
  AddValue<vtkIdTypeArray>(
    figures, FieldArray::NumberOfOutsidePoints, vtkIdType(layers.Ledgers.PointsOutside[horizon]));
  AddValue<vtkIdTypeArray>(figures, FieldArray::TriangleCount, output->GetNumberOfPolys());
  Ledger ledger = layers.Ledgers.OfHorizons[horizon];
  vtkPolyData* const given = stack[horizon].Points.Horizon;
  if (const std::optional<Ledger> before = ReadLedger(given->GetFieldData()))
  {
    const std::int64_t known = CountPoints(given)[LedgerEntry::Known];
    ledger[LedgerEntry::LeftOut] += std::max<std::int64_t>(0, before->Read() - known);
  }
  WriteLedger(ledger, figures);
  AddValue<vtkIdTypeArray>(figures, FieldArray::MovedColumns, vtkIdType(moved.Columns));
  AddValue<vtkDoubleArray>(figures, FieldArray::FarthestMove, height * moved.Largest);
}
}
