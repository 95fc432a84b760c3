// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonVolume.h"

#include "Common/Base/Errors.h"
#include "Common/Base/HeapArray.h"
#include "Common/Base/Parallel.h"
#include "Common/Horizon/DataModel.h"
#include "Common/Survey/HorizonDataSet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>
#include <string>

namespace SeismicHorizons
{
namespace
{
constexpr double BytesOfMB = 1024.0 * 1024.0;

using VoxelValues = HeapArray<double> LatticeHorizon::*;

class VolumePoints
{
public:
  VolumePoints(const VoxelExtent& extent, int verticalSign)
    : Extent(extent)
    , Sign(verticalSign)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      this->Sizes[axis] = std::max<std::int64_t>(0, std::int64_t(extent[2 * axis + 1]) - extent[2 * axis] + 1);
    }
  }

  const std::array<std::int64_t, 3>& Dimensions() const { return this->Sizes; }
  std::int64_t Number() const { return this->Sizes[0] * this->Sizes[1] * this->Sizes[2]; }

  /// Returns -1 for points outside.
  std::int64_t Find(int i, int j, int k) const
  {
    const std::int64_t x = std::int64_t(i) - this->Extent[0];
    const std::int64_t y = std::int64_t(j) - this->Extent[2];
    const std::int64_t z = std::int64_t(this->Sign) * k - this->Extent[4];
    const bool isInside = x >= 0 && x < this->Sizes[0] && y >= 0 && y < this->Sizes[1] && z >= 0 && z < this->Sizes[2];
    return isInside ? (z * this->Sizes[1] + y) * this->Sizes[0] + x : -1;
  }

private:
  const VoxelExtent Extent;
  const int Sign;
  std::array<std::int64_t, 3> Sizes = {};
};

/// Threads write, and so allocate, the memory in parallel.
template <typename T>
HeapArray<T> Fill(std::int64_t size, T value)
{
  HeapArray<T> values;
  T* const data = values.Extend(std::size_t(size));
  ParallelFor(size, Grain, [=](std::int64_t first, std::int64_t last) { std::fill(data + first, data + last, value); });
  return values;
}

/// Voxels of a horizon have different points, so that threads write independently.
template <typename Write>
void ForEachVoxel(const LatticeHorizon& horizon, const VolumePoints& points, Write&& write)
{
  ParallelFor(std::int64_t(horizon.Column.size()), Grain,
    [&](std::int64_t first, std::int64_t last)
    {
      for (auto voxel = std::size_t(first); voxel < std::size_t(last); ++voxel)
      {
        const std::int64_t point = points.Find(horizon.Column[voxel].X, horizon.Column[voxel].Y, horizon.K[voxel]);
        if (point >= 0)
        {
          write(std::size_t(point), voxel);
        }
      }
    });
}

void CheckBackground(const std::vector<const LatticeHorizon*>& horizons, int background)
{
  for (const LatticeHorizon* horizon : horizons)
  {
    if (horizon->SurfaceId == background)
    {
      throw InputError("BackgroundValue " + std::to_string(background) +
        ", which is the ID of a horizon that is loaded, expected another number");
    }
  }
}

float ToSingle(const LatticeHorizon& horizon, std::size_t voxel, VoxelValues values, const char* name)
{
  const double value = (horizon.*values)[voxel];
  if (std::abs(value) > std::numeric_limits<float>::max())
  {
    std::ostringstream text;
    text << name << ' ' << value << " at (" << horizon.Column[voxel].X << ", " << horizon.Column[voxel].Y << ", "
         << horizon.K[voxel] << "), expected at most " << std::numeric_limits<float>::max() << " for volumes";
    throw InputError(text.str());
  }
  return static_cast<float>(value);
}

void AddSurfaceIds(const std::vector<const LatticeHorizon*>& horizons, const VolumePoints& points, int background,
  ArrayTable& data, const Monitor& monitor)
{
  HeapArray<int> ids = Fill(points.Number(), background);
  for (std::size_t n = 0; n < horizons.size(); ++n)
  {
    monitor.Progress(double(n) / double(horizons.size()));
    ForEachVoxel(*horizons[n], points, [&](std::size_t point, std::size_t) { ids[point] = horizons[n]->SurfaceId; });
  }
  MoveToArray<int>(data, PointArray::SurfaceId, ids);
  data.SetActiveScalars(PointArray::SurfaceId);
}

void AddAttribute(const std::vector<const LatticeHorizon*>& horizons, const VolumePoints& points, VoxelValues values,
  const char* name, ArrayTable& data, const Monitor& monitor)
{
  HeapArray<float> numbers = Fill(points.Number(), 0.0f);
  for (std::size_t n = 0; n < horizons.size(); ++n)
  {
    monitor.Progress(double(n) / double(horizons.size()));
    ForEachVoxel(*horizons[n], points,
      [&](std::size_t point, std::size_t voxel) { numbers[point] = ToSingle(*horizons[n], voxel, values, name); });
  }
  MoveToArray<float>(data, name, numbers);
  data.SetActiveScalars(name);
}

std::int64_t CountDroppedDuplicates(const std::vector<const LatticeHorizon*>& horizons)
{
  std::int64_t count = 0;
  for (const LatticeHorizon* horizon : horizons)
  {
    count += horizon->DroppedDuplicates;
  }
  return count;
}
}

//----------------------------------------------------------------------------------------------------------------------
VoxelExtent ToImageExtent(const VoxelExtent& extent, const ImageFrame& frame)
{
  if (frame.VerticalSign > 0 || extent == EmptyExtent)
  {
    return extent;
  }
  return { extent[0], extent[1], extent[2], extent[3], -extent[5], -extent[4] };
}

//----------------------------------------------------------------------------------------------------------------------
void CheckVolumeMemory(const VoxelExtent& imageExtent, const VolumeOptions& options)
{
  const double bytesPerPoint = options.Attribute == VolumeAttribute::None ? sizeof(int) : sizeof(int) + sizeof(float);
  const std::array<std::int64_t, 3> sizes = VolumePoints(imageExtent, 1).Dimensions();
  const double size = double(sizes[0]) * double(sizes[1]) * double(sizes[2]) * bytesPerPoint / BytesOfMB;
  if (size > options.MemoryLimit)
  {
    std::ostringstream text;
    text.precision(0);
    text << std::fixed << "a volume of " << sizes[0] << " x " << sizes[1] << " x " << sizes[2] << " points that takes "
         << std::ceil(size) << " MB, expected at most VolumeMemoryLimit, " << options.MemoryLimit << " MB";
    throw InputError(text.str());
  }
}

//----------------------------------------------------------------------------------------------------------------------
LatticeImage MakeHorizonVolume(const std::vector<const LatticeHorizon*>& horizons, const LatticeFrame& frame,
  const VoxelExtent& imageExtent, const VolumeOptions& options, const Monitor& monitor)
{
  LatticeImage volume;
  volume.Extent = imageExtent;
  volume.Place = MakeVolumeFrame(frame.ToWorld());
  const VolumePoints points(imageExtent, volume.Place.VerticalSign);
  CheckBackground(horizons, options.Background);
  AddFrameFields(volume.FieldData, frame);
  AddValue<std::int64_t>(volume.FieldData, FieldArray::DroppedDuplicates, CountDroppedDuplicates(horizons));
  ArrayTable& data = volume.PointData;
  AddSurfaceIds(horizons, points, options.Background, data, monitor.Step(0.0, 0.5));
  if (options.Attribute == VolumeAttribute::Amplitude)
  {
    AddAttribute(horizons, points, &LatticeHorizon::Amplitude, PointArray::Amplitude, data, monitor.Step(0.5, 1.0));
  }
  else if (options.Attribute == VolumeAttribute::Thickness)
  {
    AddAttribute(horizons, points, &LatticeHorizon::Thickness, PointArray::Thickness, data, monitor.Step(0.5, 1.0));
  }
  monitor.Progress(1.0);
  return volume;
}
}
