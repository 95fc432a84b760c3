// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The equations of the surfaces that close a gap.

#ifndef SeismicHorizonsGapSystems_h
#define SeismicHorizonsGapSystems_h

#include "GapRegion.h"
#include "SiteBox.h"

#include <vector>

namespace SeismicHorizons
{
/// A system with a number of right sides, of a number for each site each.
template <int Radius>
struct SiteSystem
{
  explicit SiteSystem(SiteBox sites)
    : Sites(std::move(sites))
    , Matrix(this->Sites)
  {
  }

  SiteBox Sites;
  StencilMatrix<Radius> Matrix;
};

using PlateSystem = SiteSystem<2>;
using MembraneSystem = SiteSystem<1>;

/// The matrix of a thin plate: that of the sum of u_xx^2 + 2 u_xy^2 + u_yy^2 over all stencils whose places are of the
/// gap or the ring, and that no cut crosses. So the rim of the ring is a free edge. With a `ringWeight` above 0 the
/// ring has unknowns, too, each held at its height by a spring of that strength; else its heights are kept.
PlateSystem MakePlate(const GapRegion& region, double ringWeight);

/// Its right side for heights known at the places of the ring.
std::vector<double> PlateRightSide(
  const GapRegion& region, const PlateSystem& plate, double ringWeight, const std::vector<double>& height);

/// The matrix of a membrane over the gap: each column is the mean of those of its four neighbours that are of the gap
/// or known, and to which no link is cut. `isKnown` tells for each place which of the ring are.
MembraneSystem MakeMembrane(const GapRegion& region, const std::vector<bool>& isKnown);

/// Its right side for values at known places.
std::vector<double> MembraneRightSide(const GapRegion& region, const MembraneSystem& membrane,
  const std::vector<bool>& isKnown, const std::vector<double>& value);
}

#endif
