// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsLatticeImage_h
#define SeismicHorizonsLatticeImage_h

#include "Common/Horizon/DataArray.h"
#include "Common/Horizon/Types.h"
#include "ImageFrame.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
/// A map or a volume; the first index runs fastest.
struct LatticeImage
{
  std::array<int, 6> Extent = { 0, -1, 0, -1, 0, -1 }; // first and last index of each axis
  ImageFrame Place;
  ArrayTable PointData;
  ArrayTable FieldData;
};

/// The columns of a map.
class ColumnPixels
{
public:
  /// Sets the extent to the box of the columns, at least one, and blanks other pixels. Throws InputError if the box is
  /// large and nearly empty.
  ColumnPixels(PlanePoints columns, LatticeImage& image);

  /// of the whole map
  std::int64_t Size() const { return this->Count; }

  /// Pixels without a column get `missing`.
  template <typename T, typename Values>
  void Add(const char* name, const Values& values, T missing) const
  {
    DataArray array = NewArray<T>(name, this->Count);
    T* const pixels = array.As<T>();
    std::fill_n(pixels, this->Count, missing);
    for (std::size_t n = 0; n < this->Pixels.size(); ++n)
    {
      pixels[this->Pixels[n]] = T(values[n]);
    }
    this->Image.PointData.Add(std::move(array));
  }

private:
  LatticeImage& Image;
  std::int64_t Count = 0;
  std::vector<std::int64_t> Pixels; // of the columns
};
}

#endif
