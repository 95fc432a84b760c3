// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonPoints.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Parallel.h"
#include "Common/Horizon/DataModel.h"
#include "Common/VTK/DataArrays.h"
#include "Common/VTK/VertexCells.h"
#include "HorizonData.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cassert>
#include <cstring>
#include <numeric>
#include <sstream>
#include <vector>

namespace SeismicHorizons
{
namespace
{
bool IsVisible(unsigned char ghost)
{
  return (ghost & (vtkDataSetAttributes::HIDDENPOINT | vtkDataSetAttributes::DUPLICATEPOINT)) == 0;
}

/// Runs of consecutive points are copied at once.
void CopyBytes(const char* from, std::size_t bytes, const KeptPoints& kept, char* to)
{
  ParallelFor(std::int64_t(kept.size()), Grain,
    [&](std::int64_t first, std::int64_t last)
    {
      kept.ForEachRun(std::size_t(first), std::size_t(last),
        [&](std::size_t n, PointId point, std::size_t length)
        { std::memcpy(to + n * bytes, from + std::size_t(point) * bytes, length * bytes); });
    });
}

void GetTuples(vtkAbstractArray* from, const KeptPoints& kept, vtkAbstractArray* to)
{
  vtkNew<vtkIdList> ids;
  ids->SetNumberOfIds(vtkIdType(kept.size()));
  kept.ForEachRun(0, kept.size(),
    [&](std::size_t n, PointId point, std::size_t length)
    { std::iota(ids->begin() + n, ids->begin() + n + length, vtkIdType(point)); });
  from->GetTuples(ids, to);
}

bool HasPlainTuples(vtkAbstractArray* array)
{
  return vtkDataArray::SafeDownCast(array) && array->HasStandardMemoryLayout() && array->GetDataType() != VTK_BIT;
}

/// Slope of height over vertical index, in a sample of the points; 1 without indices, or if points are too level.
double MeasureStretch(vtkPolyData* horizon, const std::function<double(vtkIdType)>& height)
{
  vtkDataArray* const index = FindNumbers(horizon->GetPointData(), PointArray::VerticalIndex);
  const vtkIdType size = horizon->GetNumberOfPoints();
  if (!index || index->GetNumberOfTuples() != size)
  {
    return 1.0;
  }
  constexpr vtkIdType Enough = 1000;
  std::vector<Eigen::Vector2d> pairs;
  for (vtkIdType point = 0; point < size; point += size / Enough + 1)
  {
    pairs.emplace_back(index->GetComponent(point, 0), height(point));
  }
  constexpr double LeastDeviation = 2.0; // vertical indices; below this, rounding and real z could dominate.
  return FitSlope(pairs, LeastDeviation).value_or(1.0);
}
}

//----------------------------------------------------------------------------------------------------------------------
vtkIdType CountVisiblePoints(vtkPolyData* horizon)
{
  vtkUnsignedCharArray* const ghosts = horizon->GetPointGhostArray();
  return ghosts ? std::count_if(ghosts->Begin(), ghosts->End(), IsVisible) : horizon->GetNumberOfPoints();
}

//----------------------------------------------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> WithoutHiddenPoints(vtkPolyData* horizon)
{
  const vtkIdType visible = CountVisiblePoints(horizon);
  if (visible == horizon->GetNumberOfPoints())
  {
    return horizon;
  }
  vtkUnsignedCharArray* const ghosts = horizon->GetPointGhostArray();
  const auto kept = KeptPoints::If(std::size_t(horizon->GetNumberOfPoints()),
    [ghosts](std::size_t point) { return IsVisible(ghosts->GetValue(vtkIdType(point))); });
  auto result = vtkSmartPointer<vtkPolyData>::New();
  CopyPoints(horizon, kept, result);
  result->SetVerts(nullptr);
  result->GetPointData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  result->GetFieldData()->PassData(horizon->GetFieldData());
  return result;
}

//----------------------------------------------------------------------------------------------------------------------
vtkSmartPointer<vtkAbstractArray> CopyTuples(vtkAbstractArray* array, const KeptPoints& kept)
{
  const vtkSmartPointer<vtkAbstractArray> copy = NewArrayLike(array, vtkIdType(kept.size()));
  if (HasPlainTuples(array) && HasPlainTuples(copy))
  {
    const std::size_t bytes = std::size_t(array->GetNumberOfComponents()) * std::size_t(array->GetDataTypeSize());
    CopyBytes(
      static_cast<const char*>(array->GetVoidPointer(0)), bytes, kept, static_cast<char*>(copy->GetVoidPointer(0)));
  }
  else
  {
    GetTuples(array, kept, copy);
  }
  return copy;
}

//----------------------------------------------------------------------------------------------------------------------
void AddPointArray(vtkPolyData* input, int n, vtkAbstractArray* made, vtkPolyData* output)
{
  assert(made->GetNumberOfTuples() == output->GetNumberOfPoints());
  const int index = output->GetPointData()->AddArray(made);
  const int attribute = input->GetPointData()->IsArrayAnAttribute(n);
  if (attribute >= 0)
  {
    output->GetPointData()->SetActiveAttribute(index, attribute);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void CopyPoints(vtkPolyData* input, const KeptPoints& kept, vtkPolyData* output)
{
  if (kept.AreAll())
  {
    output->SetPoints(input->GetPoints());
    output->GetPointData()->PassData(input->GetPointData());
    output->SetVerts(HasAllVertices(input->GetVerts(), input->GetNumberOfPoints())
        ? input->GetVerts()
        : MakeVertices(input->GetNumberOfPoints()).Get());
    return;
  }
  vtkNew<vtkPoints> points;
  points->SetData(vtkDataArray::SafeDownCast(CopyTuples(input->GetPoints()->GetData(), kept)));
  output->SetPoints(points);
  for (int n = 0; n < input->GetPointData()->GetNumberOfArrays(); ++n)
  {
    AddPointArray(input, n, CopyTuples(input->GetPointData()->GetAbstractArray(n), kept), output);
  }
  output->SetVerts(MakeVertices(output->GetNumberOfPoints()));
}

//----------------------------------------------------------------------------------------------------------------------
void ActivateHeight(vtkPolyData* horizon)
{
  if (horizon->GetPointData()->HasArray(PointArray::VerticalIndex))
  {
    horizon->GetPointData()->SetActiveScalars(PointArray::VerticalIndex);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void CheckHeights(vtkPolyData* horizon, const std::function<double(vtkIdType)>& height)
{
  // RealZ may differ from the vertical index, but in a survey their ratio is about constant.
  constexpr double MostStretch = 2.0;
  const double stretch = MeasureStretch(horizon, height);
  if (stretch < 1.0 / MostStretch || stretch > MostStretch)
  {
    std::ostringstream text;
    text << "points rise by " << stretch
         << " lattice units for each vertical index, expected 1: where points were moved or scaled, as by Transform, "
            "the lattice in LatticeToWorld is no longer theirs";
    throw InputError(text.str());
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::optional<double> FitSlope(const std::vector<Eigen::Vector2d>& pairs, double leastDeviation)
{
  const Eigen::Vector2d sum = std::accumulate(pairs.begin(), pairs.end(), Eigen::Vector2d(0.0, 0.0));
  const Eigen::Vector2d mean = sum / double(pairs.size());
  double square = 0.0;
  double product = 0.0;
  for (const Eigen::Vector2d& pair : pairs)
  {
    square += (pair.x() - mean.x()) * (pair.x() - mean.x());
    product += (pair.x() - mean.x()) * (pair.y() - mean.y());
  }
  const bool isSpread = square > leastDeviation * leastDeviation * double(pairs.size());
  return isSpread ? std::optional<double>(product / square) : std::nullopt;
}
}
