// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SheetNormals_h
#define SheetNormals_h

#include "vtkSmartPointer.h"

class vtkFloatArray;

namespace SeismicHorizons
{
struct SheetBlocks;

/// The length of a normal at level 0.
constexpr float SheetLevels = 500.0f;

/// Returns normals of the points of a sheet. Their length is the level of contours, counted from a bold one near the
/// middle, plus SheetLevels; without an interval it is 1. Spikes end at the last level.
vtkSmartPointer<vtkFloatArray> MakeNormals(const SheetBlocks& blocks, double interval);
}

#endif
