// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Bending energy of a thin plate on the lattice: the sum of u_xx^2 + 2 u_xy^2 + u_yy^2 over stencils.

#ifndef SeismicHorizonsPlateEnergy_h
#define SeismicHorizonsPlateEnergy_h

#include "SiteSolver.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace SeismicHorizons
{
struct PlateTerm
{
  int X;
  int Y;
  double Coefficient;
};

/// Second differences along the axes.
inline constexpr std::array<PlateTerm, 3> PlateAlongX = { { { -1, 0, 1.0 }, { 0, 0, -2.0 }, { 1, 0, 1.0 } } };
inline constexpr std::array<PlateTerm, 3> PlateAlongY = { { { 0, -1, 1.0 }, { 0, 0, -2.0 }, { 0, 1, 1.0 } } };

/// All places of a stencil must satisfy isIn(place); lines must be linked, and blocks of four whole.
template <typename IsIn, typename IsLinked, typename IsWholeBlock, typename Visitor>
void ForEachPlateStencil(
  const BoxPlaces& near, IsIn&& isIn, IsLinked&& isLinked, IsWholeBlock&& isWholeBlock, Visitor&& visit)
{
  static constexpr std::array<PlateTerm, 4> twist = { { { 0, 0, 1.0 }, { 1, 0, -1.0 }, { 0, 1, -1.0 },
    { 1, 1, 1.0 } } };
  const auto isLine = [&](std::int64_t before, std::int64_t place, std::int64_t beyond)
  { return isIn(before) && isIn(beyond) && isLinked(before, place) && isLinked(place, beyond); };
  for (std::int64_t place = 0; place < near.Size(); ++place)
  {
    if (!isIn(place))
    {
      continue;
    }
    const std::int64_t above = near.Above(place);
    if (isLine(place - 1, place, place + 1))
    {
      visit(place, PlateAlongX, 1.0);
    }
    if (isLine(near.Below(place), place, above))
    {
      visit(place, PlateAlongY, 1.0);
    }
    if (isIn(place + 1) && isIn(above) && isIn(above + 1) && isWholeBlock(place))
    {
      visit(place, twist, 2.0);
    }
  }
}

/// Terms without a site are left out.
template <typename Terms>
void AddSquare(SiteSystem<2>& system, std::int64_t place, const Terms& terms, double weight)
{
  std::array<std::int32_t, 4> sites;
  std::transform(terms.begin(), terms.end(), sites.begin(),
    [&](const PlateTerm& term) { return system.Sites.Number[system.Sites.Near->Beside(place, term.X, term.Y)]; });
  for (std::size_t n = 0; n < terms.size(); ++n)
  {
    for (std::size_t other = 0; other < terms.size() && sites[n] != NoSite; ++other)
    {
      if (sites[other] != NoSite)
      {
        system.Matrix[sites[n]][StencilMatrix<2>::Index(terms[other].X - terms[n].X, terms[other].Y - terms[n].Y)] +=
          weight * terms[n].Coefficient * terms[other].Coefficient;
      }
    }
  }
}
}

#endif
