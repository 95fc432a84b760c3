// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GapSystems.h"

#include <array>

namespace SeismicHorizons
{
namespace
{
/// A term of a stencil: a coefficient for the place so far from the stencil's own.
struct Term
{
  int X;
  int Y;
  double Coefficient;
};

/// Calls visit(place, terms, weight) for each stencil of the plate's energy.
template <typename Visitor>
void ForEachStencil(const GapRegion& region, Visitor&& visit)
{
  static constexpr std::array<Term, 3> alongX = { { { -1, 0, 1.0 }, { 0, 0, -2.0 }, { 1, 0, 1.0 } } };
  static constexpr std::array<Term, 3> alongY = { { { 0, -1, 1.0 }, { 0, 0, -2.0 }, { 0, 1, 1.0 } } };
  static constexpr std::array<Term, 4> twist = { { { 0, 0, 1.0 }, { 1, 0, -1.0 }, { 0, 1, -1.0 }, { 1, 1, 1.0 } } };
  const std::int64_t width = region.Width;
  const auto isIn = [&](std::int64_t place) { return region.Kind[std::size_t(place)] != PlaceKind::Other; };
  const auto isLine = [&](std::int64_t place, std::int64_t step)
  {
    return isIn(place - step) && isIn(place + step) && region.IsLinked(place - step, place) &&
      region.IsLinked(place, place + step);
  };
  const std::int64_t last = std::int64_t(region.Kind.size()) - width - 1;
  for (std::int64_t place = width + 1; place < last; ++place)
  {
    if (!isIn(place))
    {
      continue;
    }
    if (isLine(place, 1))
    {
      visit(place, alongX, 1.0);
    }
    if (isLine(place, width))
    {
      visit(place, alongY, 1.0);
    }
    if (isIn(place + 1) && isIn(place + width) && isIn(place + width + 1) && region.IsWholeBlock(place))
    {
      visit(place, twist, 2.0);
    }
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
PlateSystem MakePlate(const GapRegion& region, double ringWeight)
{
  PlateSystem plate(region.MakeSites(ringWeight > 0.0));
  ForEachStencil(region,
    [&](std::int64_t place, const auto& terms, double weight)
    {
      for (const Term& a : terms)
      {
        const std::int32_t site = plate.Sites.Number[std::size_t(place + a.Y * region.Width + a.X)];
        for (const Term& b : terms)
        {
          const std::int32_t other = plate.Sites.Number[std::size_t(place + b.Y * region.Width + b.X)];
          if (site != NoSite && other != NoSite)
          {
            plate.Matrix[std::size_t(site)][StencilMatrix<2>::Index(b.X - a.X, b.Y - a.Y)] +=
              weight * a.Coefficient * b.Coefficient;
          }
        }
      }
    });
  for (std::size_t site = 0; site < plate.Sites.Size(); ++site)
  {
    if (region.Kind[std::size_t(plate.Sites.Place[site])] == PlaceKind::Ring)
    {
      plate.Matrix[site][StencilMatrix<2>::Centre] += ringWeight;
    }
  }
  return plate;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<double> PlateRightSide(
  const GapRegion& region, const PlateSystem& plate, double ringWeight, const std::vector<double>& height)
{
  std::vector<double> side(plate.Sites.Size(), 0.0);
  if (ringWeight > 0.0)
  {
    for (std::size_t site = 0; site < side.size(); ++site)
    {
      const std::size_t place = std::size_t(plate.Sites.Place[site]);
      side[site] = region.Kind[place] == PlaceKind::Ring ? ringWeight * height[place] : 0.0;
    }
    return side;
  }
  ForEachStencil(region,
    [&](std::int64_t place, const auto& terms, double weight)
    {
      double known = 0.0;
      for (const Term& term : terms)
      {
        const std::size_t at = std::size_t(place + term.Y * region.Width + term.X);
        known += region.Kind[at] == PlaceKind::Ring ? term.Coefficient * height[at] : 0.0;
      }
      for (const Term& term : terms)
      {
        const std::int32_t site = plate.Sites.Number[std::size_t(place + term.Y * region.Width + term.X)];
        if (site != NoSite)
        {
          side[std::size_t(site)] -= weight * term.Coefficient * known;
        }
      }
    });
  return side;
}

//----------------------------------------------------------------------------------------------------------------------
MembraneSystem MakeMembrane(const GapRegion& region, const std::vector<bool>& isKnown)
{
  using Stencil = StencilMatrix<1>;
  static constexpr std::array<std::size_t, 4> besides = { Stencil::Index(0, -1), Stencil::Index(-1, 0),
    Stencil::Index(1, 0), Stencil::Index(0, 1) }; // in the order of GapRegion::Neighbours
  MembraneSystem membrane(region.MakeSites(false));
  for (std::size_t site = 0; site < membrane.Sites.Size(); ++site)
  {
    const std::int64_t place = membrane.Sites.Place[site];
    const std::array<std::int64_t, 4> neighbours = region.Neighbours(place);
    for (std::size_t n = 0; n < neighbours.size(); ++n)
    {
      const bool isGap = region.Kind[std::size_t(neighbours[n])] == PlaceKind::Gap;
      if ((isGap || isKnown[std::size_t(neighbours[n])]) && region.IsLinked(place, neighbours[n]))
      {
        membrane.Matrix[site][Stencil::Centre] += 1.0;
        membrane.Matrix[site][besides[n]] = isGap ? -1.0 : 0.0;
      }
    }
  }
  return membrane;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<double> MembraneRightSide(const GapRegion& region, const MembraneSystem& membrane,
  const std::vector<bool>& isKnown, const std::vector<double>& value)
{
  std::vector<double> side(membrane.Sites.Size(), 0.0);
  for (std::size_t site = 0; site < side.size(); ++site)
  {
    const std::int64_t place = membrane.Sites.Place[site];
    for (const std::int64_t neighbour : region.Neighbours(place))
    {
      if (isKnown[std::size_t(neighbour)] && region.IsLinked(place, neighbour))
      {
        side[site] += value[std::size_t(neighbour)];
      }
    }
  }
  return side;
}
}
