// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SEGYImage.h"

#include "Common/Base/Parallel.h"
#include "Common/Horizon/DataModel.h"
#include "Common/Survey/HorizonDataSet.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace SeismicHorizons
{
namespace
{
std::int64_t CountSamples(const CubeExtent& extent)
{
  std::int64_t size = 1;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    size *= std::max<std::int64_t>(0, std::int64_t(extent[2 * axis + 1]) - extent[2 * axis] + 1);
  }
  return size;
}

/// Hides points without a sample; the amplitudes of nulls become 0, too.
void AddBlanking(const SEGYWindow& window, const CubeExtent& extent, float* amplitudes, ArrayTable& data)
{
  DataArray ghosts = NewArray<unsigned char>(PointArray::Ghosts, CountSamples(extent));
  auto* const marks = ghosts.As<unsigned char>();
  const std::size_t columns = window.Columns.size();
  ParallelFor(std::int64_t(extent[5]) - extent[4] + 1, 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t level = first; level < last; ++level)
      {
        unsigned char* const mark = marks + std::size_t(level) * columns;
        float* const amplitude = amplitudes + std::size_t(level) * columns;
        const int k = extent[4] + int(level);
        for (std::size_t column = 0; column < columns; ++column)
        {
          const SampleRange& range = window.Columns[column];
          const bool isNull = std::isnan(amplitude[column]);
          mark[column] = range.First <= k && k < range.End && !isNull ? 0 : GhostMark::HiddenPoint;
          amplitude[column] = isNull ? 0.0f : amplitude[column];
        }
      }
    });
  data.Add(std::move(ghosts));
}

void AddCubeFields(const SEGYCube& cube, const CubeView& view, ArrayTable& data)
{
  AddFrameFields(data, view.Frame);
  AddValue<double>(data, FieldArray::ImageDeviation, view.Image.Deviation);
  AddValue<double>(data, FieldArray::StrongAmplitude, double(FindStrongAmplitude(cube)));
  data.Add({ FieldArray::TextHeader, cube.Header.Text });
}
}

//----------------------------------------------------------------------------------------------------------------------
CubeView MakeCubeView(
  const SEGYCube& cube, const SurveyDescription& survey, VerticalDirection direction, double tolerance)
{
  CubeView view;
  view.Frame.Survey = survey;
  view.Frame.Lattice = cube.Lattice;
  view.Frame.LatticeDeviation = cube.LargestDistance;
  view.Frame.Sampling = cube.Sampling;
  view.Frame.Direction = direction;
  view.Image = MakeCubeFrame(view.Frame.ToWorld(), cube.Lattice.Columns);
  if (!(view.Image.Deviation <= tolerance))
  {
    std::ostringstream text;
    text.precision(3);
    text << "steps " << ToText(cube.Lattice.ColumnStep) << " and " << ToText(cube.Lattice.RowStep)
         << " that are not perpendicular, so that an image is up to " << view.Image.Deviation
         << " columns off, expected at most " << tolerance << " (ImageTolerance)";
    throw InputError(text.str());
  }
  return view;
}

//----------------------------------------------------------------------------------------------------------------------
CubeImage ReadCubeImage(const SEGYCube& cube, const CubeView& view, const CubeExtent& extent, const Monitor& monitor)
{
  CubeImage read;
  LatticeImage& image = read.Image;
  image.Extent = extent;
  image.Place = view.Image;
  AddCubeFields(cube, view, image.FieldData);
  const std::int64_t size = CountSamples(extent);
  if (size > 0)
  {
    DataArray amplitude = NewArray<float>(PointArray::Amplitude, size);
    float* const values = amplitude.As<float>();
    const SEGYWindow window = ReadSEGYWindow(cube, extent, values, monitor);
    image.PointData.Add(std::move(amplitude));
    image.PointData.SetActiveScalars(PointArray::Amplitude);
    read.Nulls = window.Nulls;
    if (!window.IsFull)
    {
      AddBlanking(window, extent, values, image.PointData);
    }
  }
  return read;
}

//----------------------------------------------------------------------------------------------------------------------
std::string NullsText(std::int64_t nulls)
{
  const char* const text =
    " samples of 1e30 or more, or nan, are read as missing; if they are valid, set SampleFormat";
  return nulls > 0 ? std::to_string(nulls) + text : "";
}

//----------------------------------------------------------------------------------------------------------------------
DataArray PlaceLineSamples(const SEGYCube& cube, const LatticeFrame& frame, const CubeExtent& extent)
{
  DataArray places = NewArray<double>("Points", CountSamples(extent), 3);
  double* place = places.As<double>();
  for (int k = extent[4]; k <= extent[5]; ++k)
  {
    for (int j = extent[2]; j <= extent[3]; ++j)
    {
      for (int i = extent[0]; i <= extent[1]; ++i)
      {
        const Eigen::Vector2d& column = cube.Places[cube.Column(i, j)];
        *place++ = column.x();
        *place++ = column.y();
        *place++ = frame.Elevation(k);
      }
    }
  }
  return places;
}
}
