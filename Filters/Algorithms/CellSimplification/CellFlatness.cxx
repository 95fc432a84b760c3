// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CellFlatness.h"

#include "Flatness.h"

#include <algorithm>
#include <cstddef>

namespace SeismicHorizons
{
namespace
{
constexpr std::ptrdiff_t MostPointsOfPlane = 3; // so many are always on a plane

Eigen::Matrix3d CovarianceOf(const CellLeaves& leaves, const PointId* first, const PointId* last)
{
  Covariance covariance(leaves.Place(*first));
  std::for_each(first, last, [&](PointId point) { covariance.Add(leaves.Place(point), double(leaves.Weight(point))); });
  return covariance.Matrix();
}
}

//----------------------------------------------------------------------------------------------------------------------
double FlatnessOf(const CellLeaves& leaves, const PointId* first, const PointId* last)
{
  return last - first <= MostPointsOfPlane ? 0.0 : QuickFlatness(CovarianceOf(leaves, first, last));
}

//----------------------------------------------------------------------------------------------------------------------
bool AreFlat(const CellLeaves& leaves, const PointId* first, const PointId* last, double threshold)
{
  return last - first <= MostPointsOfPlane || IsFlatWithin(CovarianceOf(leaves, first, last), threshold);
}
}
