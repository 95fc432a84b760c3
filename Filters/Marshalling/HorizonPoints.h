// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsHorizonPoints_h
#define SeismicHorizonsHorizonPoints_h

#include "Common/Horizon/KeptPoints.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <Eigen/Core>

#include <functional>
#include <optional>
#include <vector>

class vtkAbstractArray;
class vtkPolyData;

namespace SeismicHorizons
{
/// The array vtkGhostType hides points or marks them as copies from another process.
vtkIdType CountVisiblePoints(vtkPolyData* horizon);

/// Returns the horizon itself, or, if points are hidden, its visible points without cells.
vtkSmartPointer<vtkPolyData> WithoutHiddenPoints(vtkPolyData* horizon);

vtkSmartPointer<vtkAbstractArray> CopyTuples(vtkAbstractArray* array, const KeptPoints& kept);

/// Keeps the role, such as active scalars, of the n-th point array of `input`.
void AddPointArray(vtkPolyData* input, int n, vtkAbstractArray* made, vtkPolyData* output);

/// Each point gets a vertex cell. If all points are kept, the arrays are shared.
void CopyPoints(vtkPolyData* input, const KeptPoints& kept, vtkPolyData* output);

/// Throws InputError unless heights, in lattice units, rise with the vertical index: Transform moves points, but not
/// the lattice in the field data.
void CheckHeights(vtkPolyData* horizon, const std::function<double(vtkIdType)>& height);

/// Fits y over x by least squares; empty unless the standard deviation of x exceeds the least one.
std::optional<double> FitSlope(const std::vector<Eigen::Vector2d>& pairs, double leastDeviation);

/// ParaView colours by the active scalars.
void ActivateHeight(vtkPolyData* horizon);
}

#endif
