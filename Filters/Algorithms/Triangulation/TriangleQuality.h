// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Similarity of triangles to equilateral triangles, in plan.

#ifndef SeismicHorizonsTriangleQuality_h
#define SeismicHorizonsTriangleQuality_h

#include "Common/Base/RawVector.h"
#include "Common/Horizon/Lattice.h"
#include "Common/Horizon/Types.h"

#include <vector>

namespace SeismicHorizons
{
struct TriangleQuality
{
  /// Compactness is 4 sqrt(3) area / (sum of squared edges) (Gueziec; thesis eq. 5.9): 1 for equilateral triangles,
  /// towards 0 for thin triangles.
  RawVector<float> Compactness;
  /// Shape is 2 sqrt(3) area / (longest edge x half the perimeter) (Frey and Borouchaki; thesis eq. 5.10), with the
  /// same range.
  RawVector<float> Shape;
  /// This is in degrees, and 180 without triangles.
  double SmallestAngle = 180.0;
};

/// Reverses triangles, counter-clockwise on the lattice, if the lattice is mirrored in the world.
void FaceUp(const Lattice& lattice, RawVector<PointId>& triangles);

TriangleQuality MeasureQuality(const std::vector<PlanePoint>& places, const RawVector<PointId>& triangles);
}

#endif
