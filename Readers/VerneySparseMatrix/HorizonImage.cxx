// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonImage.h"

#include "Common/Horizon/DataModel.h"
#include "Common/VTK/ColumnImage.h"
#include "Common/VTK/HorizonDataSet.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"

#include <limits>

namespace SeismicHorizons
{
namespace
{
void AddPixels(const LatticeHorizon& voxels, const LatticeFrame& frame, vtkImageData* image)
{
  constexpr double missing = std::numeric_limits<double>::quiet_NaN();
  const ColumnPixels pixels({ voxels.Column.data(), voxels.Column.size() }, image);
  std::vector<double> elevation(voxels.Column.size());
  for (std::size_t voxel = 0; voxel < elevation.size(); ++voxel)
  {
    elevation[voxel] = frame.Elevation(voxels, voxel);
  }
  vtkPointData* const data = image->GetPointData();
  AddConstant<vtkIntArray>(data, PointArray::SurfaceId, image->GetNumberOfPoints(), voxels.SurfaceId);
  pixels.Add<vtkDoubleArray>(PointArray::Elevation, elevation, missing);
  pixels.Add<vtkDoubleArray>(PointArray::VerticalIndex, voxels.K, missing);
  pixels.Add<vtkDoubleArray>(PointArray::Thickness, voxels.Thickness, missing);
  pixels.Add<vtkDoubleArray>(PointArray::Amplitude, voxels.Amplitude, missing);
  pixels.Add<vtkDoubleArray>(PointArray::RealZ, voxels.RealZ, missing);
  data->SetActiveScalars(PointArray::Elevation);
}
}

//----------------------------------------------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> MakeHorizonImage(const LatticeHorizon& voxels, const LatticeFrame& frame)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  // The image is at z 0, so that warping it by world z gives the surface.
  PlaceImage(image, MakeMapFrame(frame.ToWorld()));
  AddFrameFields(image->GetFieldData(), frame);
  AddValue<vtkIdTypeArray>(
    image->GetFieldData(), FieldArray::DroppedDuplicates, static_cast<vtkIdType>(voxels.DroppedDuplicates));
  if (!voxels.Column.empty())
  {
    AddPixels(voxels, frame, image);
  }
  return image;
}
}
