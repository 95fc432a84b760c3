// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonMap.h"

#include "Common/Horizon/DataModel.h"
#include "Common/Survey/HorizonDataSet.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
namespace
{
void AddPixels(const LatticeHorizon& voxels, const LatticeFrame& frame, LatticeImage& map)
{
  const ColumnPixels pixels({ voxels.Column.data(), voxels.Column.size() }, map);
  std::vector<double> elevation(voxels.Column.size());
  for (std::size_t voxel = 0; voxel < elevation.size(); ++voxel)
  {
    elevation[voxel] = frame.Elevation(voxels, voxel);
  }
  AddConstant<int>(map.PointData, PointArray::SurfaceId, pixels.Size(), voxels.SurfaceId);
  pixels.Add<double>(PointArray::Elevation, elevation, NoValue);
  pixels.Add<double>(PointArray::VerticalIndex, voxels.K, NoValue);
  pixels.Add<double>(PointArray::Thickness, voxels.Thickness, NoValue);
  pixels.Add<double>(PointArray::Amplitude, voxels.Amplitude, NoValue);
  pixels.Add<double>(PointArray::RealZ, voxels.RealZ, NoValue);
  map.PointData.SetActiveScalars(PointArray::Elevation);
}
}

//----------------------------------------------------------------------------------------------------------------------
LatticeImage MakeHorizonMap(const LatticeHorizon& voxels, const LatticeFrame& frame)
{
  LatticeImage map;
  // The map is at z 0, so that warping it by world z gives the surface.
  map.Place = MakeMapFrame(frame.ToWorld());
  AddFrameFields(map.FieldData, frame);
  AddValue<std::int64_t>(map.FieldData, FieldArray::DroppedDuplicates, std::int64_t(voxels.DroppedDuplicates));
  if (!voxels.Column.empty())
  {
    AddPixels(voxels, frame, map);
  }
  return map;
}
}
