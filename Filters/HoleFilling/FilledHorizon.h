// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsFilledHorizon_h
#define SeismicHorizonsFilledHorizon_h

#include "Common/Horizon/Lattice.h"
#include "Filters/Algorithms/HoleFilling/HoleFilling.h"

#include "vtkSmartPointer.h"

#include <vector>

class vtkDataArray;
class vtkPolyData;

namespace SeismicHorizons
{
/// Values of new points are interpolated.
struct FilledArray
{
  vtkSmartPointer<vtkDataArray> Array;
  /// Change of value per lattice unit of height. Only the residual is filled, so that heights (VerticalIndex, RealZ)
  /// stay on the surface.
  double Slope = 0.0;
};

/// These are VerticalIndex and RealZ, and with `withAttributes` all floating-point arrays.
std::vector<FilledArray> ListFilledArrays(vtkPolyData* horizon, const std::vector<double>& height, bool withAttributes);

std::vector<PointValue> ListFilledValues(const std::vector<FilledArray>& arrays, const std::vector<double>& height);

/// Appends new points. In arrays that are not filled they have PointCount 0, Filled 1, nan in other floating-point
/// arrays, or the value of the nearest point. Arrays of an earlier outline are dropped.
void WriteFilledHorizon(vtkPolyData* input, const Lattice& lattice, const std::vector<FilledArray>& arrays,
  const FilledColumns& filled, vtkPolyData* output);
}

#endif
