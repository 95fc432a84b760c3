// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HoleFillingStage.h"

#include "Common/Base/Parallel.h"
#include "Common/Base/Parameters.h"
#include "Common/Horizon/DataModel.h"
#include "Common/Horizon/KeptPoints.h"
#include "Common/Survey/ColumnPoints.h"
#include "Filters/Common/CutData.h"
#include "Filters/Common/HorizonData.h"
#include "Filters/Common/HorizonPoints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <initializer_list>
#include <optional>
#include <utility>

namespace SeismicHorizons
{
namespace
{
/// Values of new points are interpolated.
struct FilledArray
{
  const DataArray* Array;
  /// Change of value per lattice unit of height. Only the residual is filled, so that heights (VerticalIndex, RealZ)
  /// stay on the surface.
  double Slope = 0.0;
};

constexpr std::int64_t BytesPerTask = 1 << 20;

bool HasName(const DataArray& array, std::initializer_list<const char*> names)
{
  return std::find(names.begin(), names.end(), array.Name) != names.end();
}

/// Fits values over heights, at a sample of the points. The slope is 0 if heights are all equal.
double SlopeOverHeight(const DataArray& values, const std::vector<double>& height)
{
  constexpr std::size_t enough = 100000;
  const std::size_t step = height.size() / enough + 1;
  std::vector<Eigen::Vector2d> pairs;
  for (std::size_t point = 0; point < height.size(); point += step)
  {
    const double value = values.At(std::int64_t(point));
    if (std::isfinite(value))
    {
      pairs.emplace_back(height[point], value);
    }
  }
  return FitSlope(pairs, 0.0).value_or(0.0);
}

/// Known values come first; the rest is not initialised.
DataArray CopyKnown(const DataArray& known, std::int64_t tuples)
{
  DataArray copy = known.NewLike(tuples);
  const auto* const source = static_cast<const char*>(known.Data());
  auto* const target = static_cast<char*>(copy.Data());
  ParallelFor(known.Tuples() * std::int64_t(known.BytesOfTuple()), BytesPerTask,
    [&](std::int64_t first, std::int64_t last)
    { std::memcpy(target + first, source + first, std::size_t(last - first)); });
  return copy;
}

/// Components of the array begin at index `first` of the values.
DataArray FillArray(const FilledArray& array, const FilledColumns& filled, std::size_t first)
{
  const std::int64_t known = array.Array->Tuples();
  DataArray output = CopyKnown(*array.Array, known + std::int64_t(filled.Column.size()));
  for (int component = 0; component < output.Components(); ++component)
  {
    const std::vector<double>& values = filled.Attribute[first + std::size_t(component)];
    for (std::size_t n = 0; n < values.size(); ++n)
    {
      const double value = values[n] + array.Slope * filled.Height[n];
      output.Set(known + std::int64_t(n), component, output.IsFloating() ? value : std::round(value));
    }
  }
  return output;
}

DataArray AppendColumns(const DataArray& array, const FilledColumns& filled)
{
  DataArray output = CopyKnown(array, array.Tuples() + std::int64_t(filled.Column.size()));
  std::copy(filled.Column.begin(), filled.Column.end(), ColumnsIn(output) + array.Tuples());
  return output;
}

/// Floating-point values become nan; any other value is copied from the nearest point.
DataArray ExtendArray(const DataArray& array, const FilledColumns& filled)
{
  const std::int64_t known = array.Tuples();
  if (!array.IsFloating())
  {
    KeptPoints from = KeptPoints::All(std::size_t(known));
    std::for_each(filled.Nearest.begin(), filled.Nearest.end(), [&from](PointId point) { from.Append(point); });
    return array.Select(from);
  }
  DataArray output = CopyKnown(array, known + std::int64_t(filled.Column.size()));
  output.WithNumbers(
    [&](auto* values)
    {
      std::fill(values + array.Size(), values + output.Size(),
        static_cast<std::decay_t<decltype(*values)>>(std::numeric_limits<double>::quiet_NaN()));
    });
  return output;
}

/// Points from id `outside` on are extrapolated. Points added by an earlier filling keep their mark.
template <typename T>
void AddMark(const Horizon& input, const char* name, int known, int filled, int extrapolated, std::int64_t outside,
  Horizon& output)
{
  const std::int64_t size = input.NumberOfPoints();
  DataArray marks = NewArray<T>(name, output.NumberOfPoints());
  const DataArray* const before = FindNumbers(input.PointData, name);
  for (std::int64_t point = 0; point < marks.Tuples(); ++point)
  {
    const double mark = point >= outside ? extrapolated : point >= size ? filled : before ? before->At(point) : known;
    marks.As<T>()[point] = static_cast<T>(mark);
  }
  output.PointData.Add(std::move(marks));
}

/// These are VerticalIndex and RealZ, and with `withAttributes` all floating-point arrays.
std::vector<FilledArray> ListFilledArrays(
  const Horizon& horizon, const std::vector<double>& height, bool withAttributes)
{
  std::vector<FilledArray> result;
  for (const DataArray& array : horizon.PointData)
  {
    const bool isHeight =
      !array.IsText() && array.Components() == 1 && HasName(array, { PointArray::VerticalIndex, PointArray::RealZ });
    if (isHeight || (withAttributes && array.IsFloating()))
    {
      result.push_back({ &array, isHeight ? SlopeOverHeight(array, height) : 0.0 });
    }
  }
  return result;
}

std::vector<PointValue> ListFilledValues(const std::vector<FilledArray>& arrays, const std::vector<double>& height)
{
  std::vector<PointValue> result;
  for (const FilledArray& filled : arrays)
  {
    for (int component = 0; component < filled.Array->Components(); ++component)
    {
      result.push_back([array = filled.Array, slope = filled.Slope, component, &height](PointId point)
        { return array->At(point, component) - slope * height[point]; });
    }
  }
  return result;
}

DataArray FillPlaces(const Horizon& input, const Lattice& lattice, const FilledColumns& filled)
{
  const std::int64_t known = input.NumberOfPoints();
  DataArray places = CopyKnown(input.Places, known + std::int64_t(filled.Column.size()));
  for (std::size_t n = 0; n < filled.Column.size(); ++n)
  {
    const Eigen::Vector3d world =
      lattice.ToWorld({ double(filled.Column[n].X), double(filled.Column[n].Y), filled.Height[n] });
    for (int axis = 0; axis < 3; ++axis)
    {
      places.Set(known + std::int64_t(n), axis, world[axis]);
    }
  }
  return places;
}

/// Appends new points. In arrays that are not filled they have PointCount 0, Filled 1, nan in other floating-point
/// arrays, or the value of the nearest point. Arrays of an earlier outline are dropped.
void WriteFilledHorizon(const Horizon& input, const Lattice& lattice, const std::vector<FilledArray>& arrays,
  const FilledColumns& filled, Horizon& output)
{
  output.Places = FillPlaces(input, lattice, filled);
  output.Vertices = MakeVertices(output.NumberOfPoints());
  std::size_t first = 0;
  for (const DataArray& array : input.PointData)
  {
    const auto found =
      std::find_if(arrays.begin(), arrays.end(), [&array](const FilledArray& one) { return one.Array == &array; });
    if (HasName(array, { PointArray::PatchId, PointArray::Boundary }))
    {
      continue;
    }
    if (HasName(array, { PointArray::Column }))
    {
      output.PointData.Add(AppendColumns(array, filled));
    }
    else if (found != arrays.end())
    {
      output.PointData.Add(FillArray(*found, filled, first));
      first += std::size_t(array.Components());
    }
    else
    {
      output.PointData.Add(ExtendArray(array, filled));
    }
  }
  const std::int64_t outside = input.NumberOfPoints() + std::int64_t(filled.FirstOutside);
  AddMark<std::int64_t>(input, PointArray::PointCount, 1, 0, 0, outside, output);
  AddMark<unsigned char>(input, PointArray::Filled, 0, 1, 2, outside, output);
  ArrayTable& figures = output.FieldData;
  AddValue<std::int64_t>(figures, FieldArray::NumberOfFilledHoles, filled.FilledHoles);
  AddValue<std::int64_t>(figures, FieldArray::NumberOfFilledPoints, std::int64_t(filled.Column.size()));
  AddValue<std::int64_t>(figures, FieldArray::NumberOfOpenHoles, filled.OpenHoles);
}

void LimitArea(double columnArea, HoleFillingStageOptions& options)
{
  CheckAtLeast<std::int64_t>("largest hole size", options.LargestHoleSize, 1, " column");
  CheckAtLeast("largest hole area", options.LargestHoleArea, 0.0, " square units of the world");
  // Areas are often whole multiples of a column's area. The quotient may fall short of the whole number by a few
  // roundings (1e-16 each), which must not leave a hole open.
  constexpr double rounding = 1e-12;
  const double columns = std::floor(options.LargestHoleArea / columnArea * (1.0 + rounding));
  if (options.LargestHoleArea > 0.0 && columns < double(options.LargestHoleSize))
  {
    options.LargestHoleSize = std::int64_t(columns);
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
void RunHoleFilling(
  const Horizon& horizon, HoleFillingStageOptions options, std::vector<Horizon>& outputs, const Monitor& monitor)
{
  const LatticePoints points = ReadColumns(WithoutHiddenPoints(horizon));
  WriteDeviation(points, outputs);
  const Horizon& input = points.Horizon;
  LimitArea(points.Lattice.ColumnArea(), options);
  const std::array<int, 3> size = ReadLatticeDimensions(input);
  options.Survey = PlaneBox({ { 0, 0 }, { size[0] - 1, size[1] - 1 } });
  const std::vector<FilledArray> arrays = ListFilledArrays(input, points.Height, options.FillAttributes);
  const std::optional<LinkCuts> cuts = FindCuts(input, PlaneBox(points.Column));
  monitor.Progress(0.2);
  const FilledColumns filled = FillHoles(points.Column, points.Height, ListFilledValues(arrays, points.Height), options,
    cuts ? &*cuts : nullptr, monitor.Step(0.2, 0.9));
  Horizon& output = outputs.front();
  WriteFilledHorizon(input, points.Lattice, arrays, filled, output);
  if (options.Method == FillMethod::Automatic)
  {
    AddValue<double>(output.FieldData, FieldArray::RimSmoothing, filled.RimSmoothing);
    AddValue<std::int64_t>(output.FieldData, FieldArray::RimWidth, filled.RimWidth);
  }
}
}
