// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonImage.h"

#include "Common/DataModel.h"
#include "Common/PlaneGeometry.h"
#include "Common/VTK/DataArrays.h"
#include "Common/VTK/HorizonDataSet.h"

#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <limits>

namespace SeismicHorizons
{
namespace
{
/// The pixel of each voxel, in an image whose extent is the bounding box of their columns.
class HorizonPixels
{
public:
  HorizonPixels(const LatticeHorizon& voxels, vtkImageData* image)
  {
    const PlaneBox box({ voxels.Column.data(), voxels.Column.size() });
    image->SetExtent(box.Least.X, box.Greatest.X, box.Least.Y, box.Greatest.Y, 0, 0);
    this->Size = image->GetNumberOfPoints();
    const vtkIdType width = vtkIdType(box.Greatest.X) - box.Least.X + 1;
    for (const PlanePoint& column : voxels.Column)
    {
      this->Pixels.push_back((vtkIdType(column.Y) - box.Least.Y) * width + column.X - box.Least.X);
    }
  }

  /// Adds an array with the values of the voxels at their pixels, and another value where there is none.
  template <typename Array, typename Values>
  void Add(vtkFieldData* data, const char* name, const Values& values, typename Array::ValueType missing) const
  {
    auto array = NewArray<Array>(name, this->Size);
    array->FillValue(missing);
    for (std::size_t voxel = 0; voxel < this->Pixels.size(); ++voxel)
    {
      array->SetValue(this->Pixels[voxel], values[voxel]);
    }
    data->AddArray(array);
  }

private:
  vtkIdType Size = 0;
  std::vector<vtkIdType> Pixels;
};

/// Adds the point data of an image. There is at least one voxel.
void AddPixels(const LatticeHorizon& voxels, const LatticeFrame& frame, vtkImageData* image)
{
  constexpr double missing = std::numeric_limits<double>::quiet_NaN();
  const HorizonPixels pixels(voxels, image);
  std::vector<double> elevation(voxels.Column.size());
  for (std::size_t voxel = 0; voxel < elevation.size(); ++voxel)
  {
    elevation[voxel] = frame.Elevation(voxels, voxel);
  }
  vtkPointData* const data = image->GetPointData();
  AddConstant<vtkIntArray>(data, PointArray::SurfaceId, image->GetNumberOfPoints(), voxels.SurfaceId);
  pixels.Add<vtkDoubleArray>(data, PointArray::Elevation, elevation, missing);
  pixels.Add<vtkDoubleArray>(data, PointArray::VerticalIndex, voxels.K, missing);
  pixels.Add<vtkDoubleArray>(data, PointArray::Thickness, voxels.Thickness, missing);
  pixels.Add<vtkDoubleArray>(data, PointArray::Amplitude, voxels.Amplitude, missing);
  pixels.Add<vtkDoubleArray>(data, PointArray::RealZ, voxels.RealZ, missing);
  data->SetActiveScalars(PointArray::Elevation); // what ParaView colours by at first
  const std::vector<unsigned char> shown(voxels.Column.size(), 0);
  pixels.Add<vtkUnsignedCharArray>(
    data, vtkDataSetAttributes::GhostArrayName(), shown, vtkDataSetAttributes::HIDDENPOINT);
}
}

//----------------------------------------------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> MakeHorizonImage(const LatticeHorizon& voxels, const LatticeFrame& frame)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  PlaceImage(image, MakeMapFrame(frame.ToWorld())); // below the columns: warping it by world z gives the surface
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
