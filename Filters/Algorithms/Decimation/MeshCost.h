// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a change to a mesh may cost: the sum of powers of its errors, at columns and where inner sides cross the lines
// between columns, which slivers between columns do too.

#ifndef SeismicHorizonsMeshCost_h
#define SeismicHorizonsMeshCost_h

#include "Common/Predicates.h"
#include "Decimation.h"
#include "HeightMesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace SeismicHorizons
{
struct MeshCost
{
  /// Errors are divided by the unit; the angle is in degrees.
  MeshCost(DecimationPriority priority, double unit, double smallestAngle)
    : Power{ priority == DecimationPriority::LargestError ? 4 : 2, unit }
    , SmallestSine(std::sin(smallestAngle * std::atan(1.0) / 45.0))
  {
  }

  ErrorPower Power;
  /// No change may make a smaller angle in plan than this sine's, but where there was a smaller one before.
  double SmallestSine;
  /// No change may make an error larger than this, but where it was larger before.
  double LargestError = std::numeric_limits<double>::infinity();

  /// Of a side, where it crosses lines between columns. The sum counts for a part: at a cliff, where a mesh is far from
  /// such lines whatever it does, points would be given up for them.
  HeightError MeasureSide(const HeightRaster& raster, const RaisedPoint& from, const RaisedPoint& to) const
  {
    HeightError error = raster.MeasureCrossings(from, to, this->Power);
    error.Sum *= PartOfSides;
    return error;
  }

  /// Of the smallest angle of a triangle in plan, which is between its two longer sides; at most 0 when it is flat or
  /// turned over.
  static double SmallestSineOf(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c)
  {
    const double ab = SquaredLength(a, b);
    const double bc = SquaredLength(b, c);
    const double ca = SquaredLength(c, a);
    const double longer = std::max({ ab * bc, bc * ca, ca * ab });
    return longer > 0.0 ? double(SignedArea(a, b, c)) / std::sqrt(longer) : 0.0;
  }

private:
  static constexpr double PartOfSides = 0.1;

  static double SquaredLength(const PlanePoint& a, const PlanePoint& b)
  {
    const double x = double(b.X) - a.X;
    const double y = double(b.Y) - a.Y;
    return x * x + y * y;
  }
};
}

#endif
