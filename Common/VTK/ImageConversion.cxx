// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ImageConversion.h"

#include "Common/Survey/LatticeImage.h"
#include "HorizonConversion.h"

#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <array>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
void PlaceImage(vtkImageData* image, const ImageFrame& frame)
{
  image->SetOrigin(frame.Origin.data());
  image->SetSpacing(frame.Spacing.data());
  image->SetDirectionMatrix(frame.Direction.data());
}

//----------------------------------------------------------------------------------------------------------------------
void ToVTK(const LatticeImage& image, vtkImageData* output)
{
  std::array<int, 6> extent = image.Extent; // SetExtent takes no const array.
  output->SetExtent(extent.data());
  PlaceImage(output, image.Place);
  ToVTK(image.PointData, output->GetPointData());
  ToVTK(image.FieldData, output->GetFieldData());
}
}
