// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonSheet.h"

#include "Common/Horizon/DataModel.h"
#include "SheetBlocks.h"
#include "SheetNormals.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
namespace
{
/// Returns cells between blocks, each named by the one of least i and j, that a fault crosses.
std::vector<char> FindCuts(const SheetBlocks& blocks, vtkDataArray* links)
{
  std::vector<char> isCut(blocks.Shown.size());
  for (vtkIdType n = 0; links && links->GetNumberOfComponents() == 3 && n < links->GetNumberOfTuples(); ++n)
  {
    const std::array<std::int64_t, 2> column = { std::int64_t(links->GetComponent(n, 0)),
      std::int64_t(links->GetComponent(n, 1)) };
    const auto block = blocks.Find(column[0], column[1]);
    const vtkIdType shown = blocks.At(block[0], block[1]);
    if (column[0] < blocks.First[0] || column[1] < blocks.First[1] || shown < 0)
    {
      continue;
    }
    // The fault may pass before or behind the column that is shown of the block.
    const std::size_t along = links->GetComponent(n, 2) == 0.0 ? 0 : 1, across = 1 - along;
    std::array<std::int64_t, 2> cell = block;
    cell[along] -= blocks.Columns[2 * shown + int(along)] <= column[along] ? 0 : 1;
    for (const std::int64_t back : { 0, 1 })
    {
      const std::int64_t beside = column[across] - blocks.Columns[2 * shown + int(across)];
      cell[across] = block[across] - back;
      if ((back == 0 ? beside >= 0 : beside <= 0) && cell[0] >= 0 && cell[1] >= 0)
      {
        isCut[std::size_t(cell[1] * blocks.Count[0] + cell[0])] = 1;
      }
    }
  }
  return isCut;
}

bool AreClockwise(const std::array<double, 3>& a, const std::array<double, 3>& b, const std::array<double, 3>& c)
{
  return (b[0] - a[0]) * (c[1] - a[1]) < (b[1] - a[1]) * (c[0] - a[0]);
}

/// Returns cells of three or four known corners, in `vertices` the points of none.
vtkSmartPointer<vtkCellArray> MakeCells(
  const SheetBlocks& blocks, const std::vector<char>& isCut, std::vector<vtkIdType>& vertices)
{
  const auto cells = vtkSmartPointer<vtkCellArray>::New();
  const auto size = vtkIdType(blocks.Places.size());
  cells->AllocateExact(size, 4 * size);
  std::vector<char> isUsed(blocks.Places.size());
  std::vector<vtkIdType> corners;
  for (std::int64_t j = 0; j + 1 < blocks.Count[1]; ++j)
  {
    for (std::int64_t i = 0; i + 1 < blocks.Count[0]; ++i)
    {
      corners = { blocks.At(i, j), blocks.At(i + 1, j), blocks.At(i + 1, j + 1), blocks.At(i, j + 1) };
      corners.erase(std::remove(corners.begin(), corners.end(), -1), corners.end());
      if (corners.size() < 3 || isCut[std::size_t(j * blocks.Count[0] + i)])
      {
        continue;
      }
      const auto corner = [&](std::size_t n) { return blocks.Places[std::size_t(corners[n])]; };
      if (AreClockwise(corner(0), corner(1), corner(2)))
      {
        std::reverse(corners.begin() + 1, corners.end()); // The diagonal stays, which starts at the first.
      }
      cells->InsertNextCell(vtkIdType(corners.size()), corners.data());
      std::for_each(corners.begin(), corners.end(), [&](vtkIdType n) { isUsed[std::size_t(n)] = 1; });
    }
  }
  for (std::size_t n = 0; n < isUsed.size(); ++n)
  {
    if (!isUsed[n])
    {
      vertices.push_back(vtkIdType(n));
    }
  }
  return cells;
}

/// Leaves the points that are shown, or all if none need to be left out, and returns their numbers before.
vtkSmartPointer<vtkIdList> TakeShown(SheetBlocks& blocks, bool areAll, vtkPolyData* horizon, vtkPolyData* sheet)
{
  const auto shown = vtkSmartPointer<vtkIdList>::New();
  for (vtkIdType n = 0; areAll && n < horizon->GetNumberOfPoints(); ++n)
  {
    shown->InsertNextId(n);
  }
  for (vtkIdType& point : blocks.Shown)
  {
    point = areAll || point < 0 ? point : shown->InsertNextId(point);
  }
  vtkNew<vtkPoints> places;
  places->SetDataType(horizon->GetPoints()->GetDataType());
  horizon->GetPoints()->GetPoints(shown, places);
  for (vtkIdType n = 0; n < places->GetNumberOfPoints(); ++n)
  {
    places->GetPoint(n, blocks.Places.emplace_back().data());
  }
  for (vtkIdType& point : blocks.Shown)
  {
    point = point >= 0 && std::isfinite(blocks.Places[std::size_t(point)][2]) ? point : -1;
  }
  sheet->SetPoints(places);
  sheet->GetPointData()->CopyAllOn();
  sheet->GetPointData()->CopyAllocate(horizon->GetPointData(), shown->GetNumberOfIds());
  sheet->GetPointData()->CopyData(horizon->GetPointData(), shown);
  // A sheet may be thinned once more.
  vtkDataArray* const known = horizon->GetPointData()->GetArray(SheetIds);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName(SheetIds);
  ids->SetNumberOfValues(shown->GetNumberOfIds());
  for (vtkIdType n = 0; n < shown->GetNumberOfIds(); ++n)
  {
    ids->SetValue(n, known ? vtkIdType(known->GetTuple1(shown->GetId(n))) : shown->GetId(n));
  }
  sheet->GetPointData()->AddArray(ids);
  return shown;
}

/// Returns a cell for each point: its vertex, or in a sheet one that begins with it, or else has it.
std::vector<vtkIdType> FindCells(vtkPolyData* horizon)
{
  std::vector<vtkIdType> cells(std::size_t(horizon->GetNumberOfPoints()), -1);
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < horizon->GetNumberOfCells(); ++cell)
  {
    horizon->GetCellPoints(cell, corners);
    for (vtkIdType n = 0; n < corners->GetNumberOfIds(); ++n)
    {
      vtkIdType& known = cells[std::size_t(corners->GetId(n))];
      known = n == 0 || known < 0 ? cell : known;
    }
  }
  return cells;
}

/// A cell stands for the vertex of its first corner. `before` has the numbers of points in the horizon.
void AddCellArrays(vtkPolyData* horizon, vtkPolyData* sheet, vtkIdList* before)
{
  auto* const points = vtkIdTypeArray::SafeDownCast(sheet->GetPointData()->GetArray(SheetIds));
  const int ownArrays = horizon->GetCellData()->HasArray(SheetIds) ? 1 : 0;
  const std::vector<vtkIdType> cells =
    horizon->GetCellData()->GetNumberOfArrays() > ownArrays ? FindCells(horizon) : std::vector<vtkIdType>();
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName(SheetIds);
  vtkNew<vtkIdList> corners, from;
  for (vtkIdType n = 0; n < sheet->GetNumberOfCells(); ++n)
  {
    sheet->GetCellPoints(n, corners);
    ids->InsertNextValue(points->GetValue(corners->GetId(0)));
    if (!cells.empty())
    {
      from->InsertNextId(cells[std::size_t(before->GetId(corners->GetId(0)))]);
    }
  }
  if (!cells.empty())
  {
    sheet->GetCellData()->CopyAllocate(horizon->GetCellData(), from->GetNumberOfIds());
    sheet->GetCellData()->CopyData(horizon->GetCellData(), from);
  }
  sheet->GetCellData()->AddArray(ids);
}

/// Whether each point has a vertex, in order, and there are no other cells.
bool HasVertices(vtkPolyData* horizon)
{
  if (horizon->GetNumberOfVerts() != horizon->GetNumberOfPoints() ||
    horizon->GetNumberOfCells() != horizon->GetNumberOfVerts() ||
    horizon->GetVerts()->GetNumberOfConnectivityIds() != horizon->GetNumberOfVerts())
  {
    return false;
  }
  vtkNew<vtkIdList> point;
  bool areInOrder = true;
  for (vtkIdType n = 0; areInOrder && n < horizon->GetNumberOfVerts(); ++n)
  {
    horizon->GetVerts()->GetCellAtId(n, point);
    areInOrder = point->GetNumberOfIds() == 1 && point->GetId(0) == n;
  }
  return areInOrder;
}

int ReadStep(vtkPolyData* horizon)
{
  vtkDataArray* const known = horizon->GetFieldData()->GetArray(SheetStep);
  return known ? int(known->GetTuple1(0)) : 1;
}
}

//----------------------------------------------------------------------------------------------------------------------
bool MakeSheet(vtkPolyData* horizon, int step, double interval)
{
  auto* const columns = vtkIntArray::SafeDownCast(horizon->GetPointData()->GetArray(PointArray::Column));
  const bool isSheet = horizon->GetPointData()->HasArray(SheetIds);
  if (!columns || columns->GetNumberOfComponents() != 2 ||
    columns->GetNumberOfTuples() != horizon->GetNumberOfPoints() || horizon->GetNumberOfPoints() < 4 ||
    !(isSheet || HasVertices(horizon)))
  {
    return false;
  }
  SheetBlocks blocks;
  blocks.Columns = columns->GetPointer(0);
  if (!ChooseShown(horizon->GetNumberOfPoints(), step, blocks))
  {
    return false;
  }
  const std::vector<char> isCut = FindCuts(blocks, horizon->GetFieldData()->GetArray(FieldArray::FaultedLinks));
  vtkNew<vtkPolyData> sheet;
  const vtkSmartPointer<vtkIdList> before = TakeShown(blocks, step == 1, horizon, sheet);
  std::vector<vtkIdType> vertices;
  sheet->SetPolys(MakeCells(blocks, isCut, vertices));
  if (2 * std::int64_t(vertices.size()) > sheet->GetNumberOfPoints())
  {
    return false;
  }
  vtkNew<vtkCellArray> others;
  std::for_each(vertices.begin(), vertices.end(), [&](vtkIdType n) { others->InsertNextCell(1, &n); });
  sheet->SetVerts(others);
  sheet->GetPointData()->SetNormals(MakeNormals(blocks, interval));
  AddCellArrays(horizon, sheet, before);
  vtkNew<vtkIntArray> steps;
  steps->SetName(SheetStep);
  steps->InsertNextValue(step * ReadStep(horizon));
  sheet->GetFieldData()->ShallowCopy(horizon->GetFieldData());
  sheet->GetFieldData()->AddArray(steps);
  horizon->ShallowCopy(sheet);
  return true;
}
}
