// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LatticeImage.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/DataModel.h"
#include "Common/Horizon/PlaneGeometry.h"

#include <cassert>
#include <string>

namespace SeismicHorizons
{
namespace
{
void RequireDense(std::int64_t width, std::int64_t height, std::size_t columns)
{
  constexpr double enough = 1 << 24; // pixels
  constexpr double enoughPerColumn = 64;
  if (double(width) * double(height) > std::max(enough, enoughPerColumn * double(columns)))
  {
    throw InputError("an image of " + std::to_string(width) + " x " + std::to_string(height) + " pixels for " +
      std::to_string(columns) +
      " columns, expected at most 64 for each, or 2^24: take one part after the other, as "
      "by Clip or a window of the reader");
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
ColumnPixels::ColumnPixels(PlanePoints columns, LatticeImage& image)
  : Image(image)
{
  assert(!columns.empty());
  const PlaneBox box(columns);
  const std::int64_t width = std::int64_t(box.Greatest.X) - box.Least.X + 1;
  const std::int64_t height = std::int64_t(box.Greatest.Y) - box.Least.Y + 1;
  RequireDense(width, height, columns.size());
  image.Extent = { box.Least.X, box.Greatest.X, box.Least.Y, box.Greatest.Y, 0, 0 };
  this->Count = width * height;
  this->Pixels.reserve(columns.size());
  for (const PlanePoint& column : columns)
  {
    this->Pixels.push_back((std::int64_t(column.Y) - box.Least.Y) * width + column.X - box.Least.X);
  }
  const std::vector<unsigned char> shown(columns.size(), 0);
  this->Add<unsigned char>(PointArray::Ghosts, shown, GhostMark::HiddenPoint);
}
}
