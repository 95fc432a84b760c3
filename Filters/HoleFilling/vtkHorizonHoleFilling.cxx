// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonHoleFilling.h"

#include "Common/Base/Parameters.h"
#include "Common/Horizon/DataModel.h"
#include "Common/VTK/DataArrays.h"
#include "Filters/Algorithms/HoleFilling/HoleFilling.h"
#include "Filters/Marshalling/CutData.h"
#include "Filters/Marshalling/HorizonData.h"
#include "Filters/Marshalling/HorizonPoints.h"

#include "Common/Base/Parallel.h"
#include "Common/Horizon/Lattice.h"
#include "Common/VTK/VertexCells.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

using namespace SeismicHorizons;

namespace SeismicHorizons
{
namespace
{
/// Values of new points are interpolated.
struct FilledArray
{
  vtkSmartPointer<vtkDataArray> Array;
  /// Change of value per lattice unit of height. Only the residual is filled, so that heights (VerticalIndex, RealZ)
  /// stay on the surface.
  double Slope = 0.0;
};

constexpr std::int64_t BytesPerTask = 1 << 20;

bool IsFloating(vtkAbstractArray* array)
{
  return array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE;
}

bool HasName(vtkAbstractArray* array, std::initializer_list<const char*> names)
{
  const std::string name = array->GetName() ? array->GetName() : "";
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Fits values over heights, at a sample of the points. The slope is 0 if heights are all equal.
double SlopeOverHeight(vtkDataArray* values, const std::vector<double>& height)
{
  constexpr std::size_t enough = 100000;
  const std::size_t step = height.size() / enough + 1;
  std::vector<Eigen::Vector2d> pairs;
  for (std::size_t point = 0; point < height.size(); point += step)
  {
    const double value = values->GetComponent(vtkIdType(point), 0);
    if (std::isfinite(value))
    {
      pairs.emplace_back(height[point], value);
    }
  }
  return FitSlope(pairs, 0.0).value_or(0.0);
}

void CopyRange(vtkAbstractArray* from, vtkAbstractArray* to)
{
  vtkDataArray* const numbers = vtkDataArray::FastDownCast(from);
  if (numbers && numbers->HasStandardMemoryLayout() && from->GetDataTypeSize() > 0)
  {
    const auto* const source = static_cast<const char*>(from->GetVoidPointer(0));
    auto* const target = static_cast<char*>(to->GetVoidPointer(0));
    ParallelFor(from->GetNumberOfValues() * from->GetDataTypeSize(), BytesPerTask,
      [&](std::int64_t first, std::int64_t last)
      { std::memcpy(target + first, source + first, std::size_t(last - first)); });
    return;
  }
  to->InsertTuples(0, from->GetNumberOfTuples(), 0, from);
}

/// Components of the array begin at index `first` of the values.
void WriteFilledValues(const FilledArray& array, const FilledColumns& filled, std::size_t first, vtkDataArray* output)
{
  const vtkIdType known = array.Array->GetNumberOfTuples();
  const bool isFloating = IsFloating(output);
  assert(first + std::size_t(output->GetNumberOfComponents()) <= filled.Attribute.size());
  for (int component = 0; component < output->GetNumberOfComponents(); ++component)
  {
    const std::vector<double>& values = filled.Attribute[first + std::size_t(component)];
    for (std::size_t n = 0; n < values.size(); ++n)
    {
      const double value = values[n] + array.Slope * filled.Height[n];
      output->SetComponent(known + vtkIdType(n), component, isFloating ? value : std::round(value));
    }
  }
}

/// Floating-point values become nan; any other value is copied from the nearest point.
void WriteOtherValues(vtkAbstractArray* input, const FilledColumns& filled, vtkAbstractArray* output)
{
  const vtkIdType known = input->GetNumberOfTuples();
  if (vtkDataArray* const numbers = vtkDataArray::FastDownCast(output); numbers && IsFloating(output))
  {
    for (int component = 0; component < numbers->GetNumberOfComponents(); ++component)
    {
      for (vtkIdType point = known; point < numbers->GetNumberOfTuples(); ++point)
      {
        numbers->SetComponent(point, component, std::numeric_limits<double>::quiet_NaN());
      }
    }
    return;
  }
  vtkNew<vtkIdList> from;
  vtkNew<vtkIdList> to;
  from->SetNumberOfIds(vtkIdType(filled.Nearest.size()));
  to->SetNumberOfIds(from->GetNumberOfIds());
  for (vtkIdType n = 0; n < from->GetNumberOfIds(); ++n)
  {
    from->SetId(n, filled.Nearest[n]);
    to->SetId(n, known + n);
  }
  output->InsertTuples(to, from, input);
}

void WriteFilledPoints(vtkPolyData* input, const Lattice& lattice, const FilledColumns& filled, vtkPolyData* output)
{
  const vtkIdType known = input->GetNumberOfPoints();
  vtkNew<vtkPoints> points;
  points->SetDataType(input->GetPoints()->GetDataType());
  points->SetNumberOfPoints(known + vtkIdType(filled.Column.size()));
  CopyRange(input->GetPoints()->GetData(), points->GetData());
  for (std::size_t n = 0; n < filled.Column.size(); ++n)
  {
    const Eigen::Vector3d place(filled.Column[n].X, filled.Column[n].Y, filled.Height[n]);
    points->SetPoint(known + vtkIdType(n), lattice.ToWorld(place).data());
  }
  output->SetPoints(points);
}

/// Points from id `outside` on are extrapolated. Points added by an earlier filling keep their mark.
template <typename Array>
void AddMark(
  vtkPolyData* input, const char* name, int known, int filled, int extrapolated, vtkIdType outside, vtkPolyData* output)
{
  const vtkIdType size = input->GetNumberOfPoints();
  auto marks = NewArray<Array>(name, output->GetNumberOfPoints());
  vtkDataArray* const before = input->GetPointData()->GetArray(name);
  for (vtkIdType point = 0; point < marks->GetNumberOfTuples(); ++point)
  {
    const double mark = point >= outside ? extrapolated
      : point >= size                    ? filled
      : before                           ? before->GetComponent(point, 0)
                                         : known;
    marks->SetValue(point, static_cast<typename Array::ValueType>(mark));
  }
  output->GetPointData()->AddArray(marks);
}

/// These are VerticalIndex and RealZ, and with `withAttributes` all floating-point arrays.
std::vector<FilledArray> ListFilledArrays(vtkPolyData* horizon, const std::vector<double>& height, bool withAttributes)
{
  std::vector<FilledArray> result;
  for (int n = 0; n < horizon->GetPointData()->GetNumberOfArrays(); ++n)
  {
    vtkDataArray* const array = horizon->GetPointData()->GetArray(n);
    if (!array)
    {
      continue;
    }
    const bool isHeight =
      HasName(array, { PointArray::VerticalIndex, PointArray::RealZ }) && array->GetNumberOfComponents() == 1;
    if (isHeight || (withAttributes && IsFloating(array)))
    {
      result.push_back({ array, isHeight ? SlopeOverHeight(array, height) : 0.0 });
    }
  }
  return result;
}

std::vector<PointValue> ListFilledValues(const std::vector<FilledArray>& arrays, const std::vector<double>& height)
{
  std::vector<PointValue> result;
  for (const FilledArray& filled : arrays)
  {
    for (int component = 0; component < filled.Array->GetNumberOfComponents(); ++component)
    {
      result.push_back([array = filled.Array.Get(), slope = filled.Slope, component, &height](PointId point)
        { return array->GetComponent(point, component) - slope * height[point]; });
    }
  }
  return result;
}

/// Appends new points. In arrays that are not filled they have PointCount 0, Filled 1, nan in other floating-point
/// arrays, or the value of the nearest point. Arrays of an earlier outline are dropped.
void WriteFilledHorizon(vtkPolyData* input, const Lattice& lattice, const std::vector<FilledArray>& arrays,
  const FilledColumns& filled, vtkPolyData* output)
{
  WriteFilledPoints(input, lattice, filled, output);
  output->SetVerts(MakeVertices(output->GetNumberOfPoints()));
  vtkPointData* const data = input->GetPointData();
  std::size_t first = 0;
  for (int n = 0; n < data->GetNumberOfArrays(); ++n)
  {
    vtkAbstractArray* const array = data->GetAbstractArray(n);
    if (HasName(array, { PointArray::PatchId, PointArray::Boundary }))
    {
      continue;
    }
    const auto result = NewArrayLike(array, output->GetNumberOfPoints());
    CopyRange(array, result);
    const auto found =
      std::find_if(arrays.begin(), arrays.end(), [array](const FilledArray& one) { return one.Array == array; });
    if (HasName(array, { PointArray::Column }))
    {
      int* to = vtkIntArray::SafeDownCast(result)->GetPointer(2 * input->GetNumberOfPoints());
      for (const PlanePoint& column : filled.Column)
      {
        *to++ = column.X;
        *to++ = column.Y;
      }
    }
    else if (found != arrays.end())
    {
      WriteFilledValues(*found, filled, first, vtkDataArray::FastDownCast(result));
      first += std::size_t(array->GetNumberOfComponents());
    }
    else
    {
      WriteOtherValues(array, filled, result);
    }
    AddPointArray(input, n, result, output);
  }
  const vtkIdType outside = input->GetNumberOfPoints() + vtkIdType(filled.FirstOutside);
  AddMark<vtkIdTypeArray>(input, PointArray::PointCount, 1, 0, 0, outside, output);
  AddMark<vtkUnsignedCharArray>(input, PointArray::Filled, 0, 1, 2, outside, output);
  vtkFieldData* const figures = output->GetFieldData();
  AddValue<vtkIdTypeArray>(figures, FieldArray::NumberOfFilledHoles, vtkIdType(filled.FilledHoles));
  AddValue<vtkIdTypeArray>(figures, FieldArray::NumberOfFilledPoints, vtkIdType(filled.Column.size()));
  AddValue<vtkIdTypeArray>(figures, FieldArray::NumberOfOpenHoles, vtkIdType(filled.OpenHoles));
}
}
}

vtkStandardNewMacro(vtkHorizonHoleFilling);

//------------------------------------------------------------------------------
HoleFillingOptions vtkHorizonHoleFilling::MakeOptions(double columnArea) const
{
  CheckAtLeast<vtkIdType>("largest hole size", this->LargestHoleSize, 1, " column");
  CheckAtLeast("largest hole area", this->LargestHoleArea, 0.0, " square units of the world");
  HoleFillingOptions options;
  options.LargestHoleSize = this->LargestHoleSize;
  // Areas are often whole multiples of a column's area. The quotient may fall short of the whole number by a few
  // roundings (1e-16 each), which must not leave a hole open.
  constexpr double rounding = 1e-12;
  const double columns = std::floor(this->LargestHoleArea / columnArea * (1.0 + rounding));
  if (this->LargestHoleArea > 0.0 && columns < double(this->LargestHoleSize))
  {
    options.LargestHoleSize = std::int64_t(columns);
  }
  options.Method = static_cast<FillMethod>(this->Method);
  options.RimSmoothing = this->RimSmoothing;
  options.RimWidth = this->RimWidth;
  options.ExtrapolationDistance = this->ExtrapolationDistance;
  return options;
}

//------------------------------------------------------------------------------
int vtkHorizonHoleFilling::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->NumberOfFilledHoles = 0;
  this->NumberOfFilledPoints = 0;
  this->NumberOfOpenHoles = 0;
  return this->Superclass::RequestData(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
void vtkHorizonHoleFilling::ProcessHorizon(vtkPolyData* horizon, const Outputs& outputs, const Monitor& monitor)
{
  const LatticePoints points = ReadColumns(WithoutHiddenPoints(horizon), outputs);
  vtkPolyData* const input = points.Horizon;
  HoleFillingOptions options = this->MakeOptions(points.Lattice.ColumnArea());
  const std::array<int, 3> size = ReadLatticeDimensions(input);
  options.Survey = PlaneBox({ { 0, 0 }, { size[0] - 1, size[1] - 1 } });
  const std::vector<FilledArray> arrays = ListFilledArrays(input, points.Height, this->Attributes == FromRim);
  const std::optional<LinkCuts> cuts = FindCuts(input, PlaneBox(points.Column));
  monitor.Progress(0.2);
  const FilledColumns filled = FillHoles(points.Column, points.Height, ListFilledValues(arrays, points.Height), options,
    cuts ? &*cuts : nullptr, monitor.Step(0.2, 0.9));
  WriteFilledHorizon(input, points.Lattice, arrays, filled, outputs.front());
  if (this->Method == Automatic)
  {
    AddValue<vtkDoubleArray>(outputs.front()->GetFieldData(), FieldArray::RimSmoothing, filled.RimSmoothing);
    AddValue<vtkIdTypeArray>(outputs.front()->GetFieldData(), FieldArray::RimWidth, vtkIdType(filled.RimWidth));
  }
  this->NumberOfFilledHoles += vtkIdType(filled.FilledHoles);
  this->NumberOfFilledPoints += vtkIdType(filled.Column.size());
  this->NumberOfOpenHoles += vtkIdType(filled.OpenHoles);
}
