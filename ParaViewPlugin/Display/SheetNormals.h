// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SheetNormals_h
#define SheetNormals_h

#include "vtkSmartPointer.h"

class vtkFloatArray;

namespace SeismicHorizons
{
struct SheetBlocks;

/// Is added to the length of normals, which are as long as the level of the contours.
constexpr float SheetLevels = 500.0f;

/// Returns normals of the points of a sheet. They are as long as the level, from the middle one, of which every fifth is
/// bold; spikes end at the last level. Without an interval they are of length 1.
vtkSmartPointer<vtkFloatArray> MakeNormals(const SheetBlocks& blocks, double interval);
}

#endif
