// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsColumnImage_h
#define SeismicHorizonsColumnImage_h

#include "Common/Base/Errors.h"
#include "Common/Horizon/PlaneGeometry.h"
#include "Common/Horizon/Types.h"
#include "DataArrays.h"

#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace SeismicHorizons
{
class ColumnPixels
{
public:
  /// Sets the extent to the box of the columns, at least one, and blanks other pixels. Throws InputError if the box is
  /// large and nearly empty.
  ColumnPixels(PlanePoints columns, vtkImageData* image)
    : Image(image)
  {
    assert(!columns.empty());
    const PlaneBox box(columns);
    RequireDense(box, columns.size());
    image->SetExtent(box.Least.X, box.Greatest.X, box.Least.Y, box.Greatest.Y, 0, 0);
    const vtkIdType width = vtkIdType(box.Greatest.X) - box.Least.X + 1;
    this->Pixels.reserve(columns.size());
    for (const PlanePoint& column : columns)
    {
      this->Pixels.push_back((vtkIdType(column.Y) - box.Least.Y) * width + column.X - box.Least.X);
    }
    const std::vector<unsigned char> shown(columns.size(), 0);
    this->Add<vtkUnsignedCharArray>(vtkDataSetAttributes::GhostArrayName(), shown, vtkDataSetAttributes::HIDDENPOINT);
  }

  /// Pixels without a column get `missing`.
  template <typename Array, typename Values>
  void Add(const char* name, const Values& values, typename Array::ValueType missing) const
  {
    auto array = NewArray<Array>(name, this->Image->GetNumberOfPoints());
    array->FillValue(missing);
    for (std::size_t n = 0; n < this->Pixels.size(); ++n)
    {
      array->SetValue(this->Pixels[n], values[n]);
    }
    this->Image->GetPointData()->AddArray(array);
  }

private:
  static void RequireDense(const PlaneBox& box, std::size_t columns)
  {
    constexpr double enough = 1 << 24; // pixels
    constexpr double enoughPerColumn = 64;
    const std::int64_t width = std::int64_t(box.Greatest.X) - box.Least.X + 1;
    const std::int64_t height = std::int64_t(box.Greatest.Y) - box.Least.Y + 1;
    if (double(width) * double(height) > std::max(enough, enoughPerColumn * double(columns)))
    {
      throw InputError("an image of " + std::to_string(width) + " x " + std::to_string(height) + " pixels for " +
        std::to_string(columns) +
        " columns, expected at most 64 for each, or 2^24: take one part after the other, as " +
        "by Clip or a window of the reader");
    }
  }

  vtkImageData* Image;
  std::vector<vtkIdType> Pixels;
};
}

#endif
