// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonSheet.h"

#include "Common/Horizon/DataModel.h"
#include "SheetBlocks.h"

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
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <vector>

namespace SeismicHorizons
{
namespace
{
using Vector = std::array<double, 3>;

template <class Function>
void ForRows(const SheetBlocks& blocks, const Function& function)
{
  vtkSMPTools::For(0, vtkIdType(blocks.Count[1]),
    [&](vtkIdType first, vtkIdType last)
    {
      for (std::int64_t j = first; j < last; ++j)
      {
        for (std::int64_t i = 0; i < blocks.Count[0]; ++i)
        {
          function(i, j);
        }
      }
    });
}

/// Returns cells, each named by the block of least i and j, that a fault crosses.
std::vector<char> FindCuts(const SheetBlocks& blocks, vtkDataArray* links)
{
  std::vector<char> isCut(blocks.Shown.size());
  const auto cut = [&](std::int64_t i, std::int64_t j)
  {
    if (i >= 0 && j >= 0 && i < blocks.Count[0] && j < blocks.Count[1])
    {
      isCut[std::size_t(j * blocks.Count[0] + i)] = 1;
    }
  };
  for (vtkIdType n = 0; links && links->GetNumberOfComponents() == 3 && n < links->GetNumberOfTuples(); ++n)
  {
    const auto i = std::int64_t(links->GetComponent(n, 0)), j = std::int64_t(links->GetComponent(n, 1));
    const std::int64_t side = links->GetComponent(n, 2) == 0.0 ? 0 : 1;
    if (i < blocks.First[0] || j < blocks.First[1])
    {
      continue;
    }
    const auto block = blocks.Find(i, j);
    cut(block[0], block[1]);
    if (block != blocks.Find(i + 1 - side, j + side))
    {
      cut(block[0] - side, block[1] - 1 + side);
    }
  }
  return isCut;
}

/// Heights at full precision repeat in few neighbours, vertical indices in many.
bool AreCoarse(const SheetBlocks& blocks)
{
  std::int64_t pairs = 0, same = 0;
  for (std::int64_t j = 0; j < blocks.Count[1]; ++j)
  {
    for (std::int64_t i = 0; i + 1 < blocks.Count[0]; ++i)
    {
      const vtkIdType a = blocks.At(i, j), b = blocks.At(i + 1, j);
      if (a >= 0 && b >= 0)
      {
        ++pairs;
        same += blocks.Places[std::size_t(a)][2] == blocks.Places[std::size_t(b)][2] ? 1 : 0;
      }
    }
  }
  return same > pairs / 5;
}

/// Heights are averaged with those around, but scarps of more than `largestStep` remain.
std::vector<double> SmoothHeights(const SheetBlocks& blocks, double largestStep)
{
  constexpr int radius = 3, passes = 2;
  std::vector<double> heights(blocks.Places.size()), averages;
  std::transform(blocks.Places.begin(), blocks.Places.end(), std::back_inserter(averages),
    [](const Vector& place) { return place[2]; });
  for (int pass = 0; pass < passes; ++pass)
  {
    heights = averages;
    ForRows(blocks,
      [&](std::int64_t i, std::int64_t j)
      {
        const vtkIdType here = blocks.At(i, j);
        double sum = 0.0, count = 0.0;
        for (std::int64_t n = 0; here >= 0 && n < (2 * radius + 1) * (2 * radius + 1); ++n)
        {
          const vtkIdType other = blocks.At(i + n % (2 * radius + 1) - radius, j + n / (2 * radius + 1) - radius);
          if (other >= 0 && std::fabs(heights[std::size_t(other)] - heights[std::size_t(here)]) <= largestStep)
          {
            sum += heights[std::size_t(other)];
            ++count;
          }
        }
        if (here >= 0)
        {
          averages[std::size_t(here)] = sum / count;
        }
      });
  }
  return averages;
}

/// Returns unit vectors, upwards, by differences of neighbours; `smooth` heights may take the place of those of points.
std::vector<Vector> FindNormals(const SheetBlocks& blocks, const std::vector<double>& smooth)
{
  std::vector<Vector> normals(blocks.Places.size(), Vector{ 0.0, 0.0, 1.0 });
  const auto place = [&](vtkIdType n)
  {
    Vector found = blocks.Places[std::size_t(n)];
    found[2] = smooth.empty() ? found[2] : smooth[std::size_t(n)];
    return found;
  };
  ForRows(blocks,
    [&](std::int64_t i, std::int64_t j)
    {
      const vtkIdType here = blocks.At(i, j);
      const auto side = [&](std::int64_t di, std::int64_t dj)
      {
        const vtkIdType next = blocks.At(i + di, j + dj), last = blocks.At(i - di, j - dj);
        const Vector a = place(last >= 0 ? last : here), b = place(next >= 0 ? next : here);
        return Vector{ b[0] - a[0], b[1] - a[1], b[2] - a[2] };
      };
      const Vector u = here >= 0 ? side(1, 0) : Vector(), v = here >= 0 ? side(0, 1) : Vector();
      const Vector normal = { u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0] };
      const double length = std::copysign(std::hypot(normal[0], normal[1], normal[2]), normal[2]);
      if (length != 0.0)
      {
        normals[std::size_t(here)] = { normal[0] / length, normal[1] / length, normal[2] / length };
      }
    });
  return normals;
}

vtkSmartPointer<vtkFloatArray> MakeNormals(const SheetBlocks& blocks, double interval)
{
  const auto [least, largest] = std::minmax_element(
    blocks.Places.begin(), blocks.Places.end(), [](const Vector& a, const Vector& b) { return a[2] < b[2]; });
  const double range = (*largest)[2] - (*least)[2], mostLevels = 2000.0;
  const bool hasLevels = interval > 0.0 && range / interval < mostLevels, areCoarse = AreCoarse(blocks);
  const std::vector<double> smooth =
    hasLevels || areCoarse ? SmoothHeights(blocks, hasLevels ? interval / 2.0 : range / 24.0) : std::vector<double>();
  const std::vector<Vector> unit = FindNormals(blocks, areCoarse ? smooth : std::vector<double>());
  // Every fifth contour is bold, so that the first level is a multiple of five.
  const double first = hasLevels ? 5.0 * std::floor((*least)[2] / interval / 5.0) : 0.0;
  const auto normals = vtkSmartPointer<vtkFloatArray>::New();
  normals->SetName("HorizonSheetNormals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(vtkIdType(unit.size()));
  for (std::size_t n = 0; n < unit.size(); ++n)
  {
    const double level = hasLevels ? SheetLevels + smooth[n] / interval - first : 1.0;
    normals->SetTuple3(vtkIdType(n), level * unit[n][0], level * unit[n][1], level * unit[n][2]);
  }
  return normals;
}

bool AreClockwise(const Vector& a, const Vector& b, const Vector& c)
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

/// Leaves the points that are shown, and returns their numbers before. All are left if each has a block of its own.
vtkSmartPointer<vtkIdTypeArray> TakeShown(SheetBlocks& blocks, vtkPolyData* horizon, vtkPolyData* sheet)
{
  const auto shown = vtkSmartPointer<vtkIdList>::New();
  const bool areAll = blocks.Step == std::array<std::int64_t, 2>{ 1, 1 };
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
  sheet->SetPoints(places);
  sheet->GetPointData()->CopyAllOn();
  sheet->GetPointData()->CopyAllocate(horizon->GetPointData(), shown->GetNumberOfIds());
  sheet->GetPointData()->CopyData(horizon->GetPointData(), shown);
  // A sheet may be thinned once more.
  vtkDataArray* const known = horizon->GetPointData()->GetArray(SheetIds);
  const auto ids = vtkSmartPointer<vtkIdTypeArray>::New();
  ids->SetName(SheetIds);
  ids->SetNumberOfValues(shown->GetNumberOfIds());
  for (vtkIdType n = 0; n < shown->GetNumberOfIds(); ++n)
  {
    ids->SetValue(n, known ? vtkIdType(known->GetTuple1(shown->GetId(n))) : shown->GetId(n));
  }
  sheet->GetPointData()->AddArray(ids);
  return ids;
}

/// A cell stands for the vertex of its first corner.
void AddCellArrays(vtkPolyData* horizon, vtkPolyData* sheet, vtkIdTypeArray* points)
{
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName(SheetIds);
  vtkNew<vtkIdList> corners, from;
  for (vtkIdType n = 0; n < sheet->GetNumberOfCells(); ++n)
  {
    sheet->GetCellPoints(n, corners);
    ids->InsertNextValue(points->GetValue(corners->GetId(0)));
    from->InsertNextId(ids->GetValue(n));
  }
  if (!horizon->GetPointData()->HasArray(SheetIds) && horizon->GetNumberOfCells() == horizon->GetNumberOfPoints())
  {
    sheet->GetCellData()->CopyAllocate(horizon->GetCellData(), from->GetNumberOfIds());
    sheet->GetCellData()->CopyData(horizon->GetCellData(), from);
  }
  sheet->GetCellData()->AddArray(ids);
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
  if (!columns || columns->GetNumberOfComponents() != 2 || horizon->GetNumberOfPoints() < 4 ||
    horizon->GetNumberOfLines() > 0 || horizon->GetNumberOfStrips() > 0 ||
    (horizon->GetNumberOfPolys() > 0 && !isSheet))
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
  const vtkSmartPointer<vtkIdTypeArray> ids = TakeShown(blocks, horizon, sheet);
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
  AddCellArrays(horizon, sheet, ids);
  vtkNew<vtkIntArray> steps;
  steps->SetName(SheetStep);
  steps->InsertNextValue(step * ReadStep(horizon));
  sheet->GetFieldData()->ShallowCopy(horizon->GetFieldData());
  sheet->GetFieldData()->AddArray(steps);
  horizon->ShallowCopy(sheet);
  return true;
}
}
