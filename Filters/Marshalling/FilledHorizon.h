// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A horizon with new points in its gaps.

#ifndef SeismicHorizonsFilledHorizon_h
#define SeismicHorizonsFilledHorizon_h

#include "Common/Lattice.h"
#include "HoleFilling/HoleFilling.h"

#include "vtkSmartPointer.h"

#include <vector>

class vtkDataArray;
class vtkPolyData;

namespace SeismicHorizons
{
/// An array of numbers that new points have in-between values of.
struct FilledArray
{
  vtkSmartPointer<vtkDataArray> Array;
  /// How much its values rise with the height: what is filled is the rest, so that arrays of heights (VerticalIndex,
  /// RealZ) stay those of the surface.
  double Slope = 0.0;
};

/// The arrays of a horizon that are filled by a membrane: VerticalIndex, RealZ, and with `withAttributes` all of
/// floating point numbers.
std::vector<FilledArray> ListFilledArrays(vtkPolyData* horizon, const std::vector<double>& height, bool withAttributes);

/// What is filled of them, component by component.
std::vector<PointValue> ListFilledValues(const std::vector<FilledArray>& arrays, const std::vector<double>& height);

/// Makes `output` the points of `input`, as they are, and after them the new ones. Arrays that are not filled:
/// PointCount is 0 at new points, Filled is 1; other floating point numbers are nan, and everything else that of the
/// nearest point. Arrays of an outline that the horizon had are left out.
void WriteFilledHorizon(vtkPolyData* input, const Lattice& lattice, const std::vector<FilledArray>& arrays,
  const FilledColumns& filled, vtkPolyData* output);
}

#endif
