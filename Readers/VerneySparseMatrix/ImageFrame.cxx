// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ImageFrame.h"

#include "Common/Errors.h"

#include <cmath>
#include <string>

namespace SeismicHorizons
{
namespace
{
// The largest cosine of the angle between the steps of an image. What is left of a shear moves the last of a million
// columns by a thousandth of a column, which no map shows.
constexpr double LargestCosine = 1e-9;

/// The frame with its third axis upwards.
ImageFrame MakeUprightFrame(const LatticeMatrix& toWorld, const std::string& kind)
{
  const double column[2] = { toWorld[0], toWorld[4] };
  const double row[2] = { toWorld[1], toWorld[5] };
  const double columnSize = std::hypot(column[0], column[1]);
  const double rowSize = std::hypot(row[0], row[1]);
  if (std::abs(column[0] * row[0] + column[1] * row[1]) > LargestCosine * columnSize * rowSize)
  {
    throw InputError("ColumnStep and RowStep that are not perpendicular, expected perpendicular ones for " + kind);
  }
  ImageFrame frame;
  frame.Origin = { toWorld[3], toWorld[7], toWorld[11] };
  frame.Spacing = { columnSize, rowSize, std::abs(toWorld[10]) };
  frame.Direction = { column[0] / columnSize, row[0] / rowSize, 0.0, column[1] / columnSize, row[1] / rowSize, 0.0, 0.0,
    0.0, 1.0 };
  return frame;
}
}

//----------------------------------------------------------------------------------------------------------------------
ImageFrame MakeMapFrame(const LatticeMatrix& toWorld)
{
  ImageFrame frame = MakeUprightFrame(toWorld, "images");
  frame.Origin[2] = 0.0;
  return frame;
}

//----------------------------------------------------------------------------------------------------------------------
ImageFrame MakeVolumeFrame(const LatticeMatrix& toWorld)
{
  ImageFrame frame = MakeUprightFrame(toWorld, "volumes");
  const bool isTurned = toWorld[0] * toWorld[5] < toWorld[1] * toWorld[4]; // clockwise from i to j, seen from above
  frame.Direction[8] = isTurned ? -1.0 : 1.0;
  frame.VerticalSign = (toWorld[10] < 0.0) == isTurned ? 1 : -1;
  return frame;
}
}
