// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How quickly the triangles of a mesh change in size.

#ifndef SeismicHorizonsGrading_h
#define SeismicHorizonsGrading_h

#include "TriangleSurface.h"

namespace SeismicHorizons
{
/// Median and percentile, over the corners of all triangles, of the ratio of the longer to the shorter of the two sides
/// that meet there: 1 where they are equal, infinite where one has no length. Right to 1/1024 of their value.
struct Grading
{
  double Median = 0.0;
  double Percentile95 = 0.0;
};

/// `surface` has at least one triangle.
Grading MeasureGrading(const TriangleSurface& surface);
}

#endif
