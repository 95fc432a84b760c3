// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GridLevel.h"

#include <algorithm>
#include <array>

namespace SeismicHorizons
{
namespace
{
/// How far a row of the matrix reaches into the coarser level: the sites that stand for its fine ones, side by side.
constexpr int CoarseReach = 4;

/// The coarser sites that a row of fine places from `first` on is a sum of begin with this one.
template <typename Pair>
std::array<double, CoarseReach> ToCoarse(const double* row, int length, std::int64_t first, const Pair& pair)
{
  std::array<double, CoarseReach> result{};
  const std::int64_t begin = pair(first).Low;
  for (int n = 0; n < length; ++n)
  {
    const CoarsePair coarse = pair(first + n);
    result[std::size_t(coarse.Low - begin)] += coarse.LowWeight * row[n];
    if (coarse.HighWeight > 0.0)
    {
      result[std::size_t(coarse.Low - begin + 1)] += coarse.HighWeight * row[n];
    }
  }
  return result;
}

/// Calls visit(place, weight) for the coarser sites that stand for a fine place.
template <typename Pair, typename Visitor>
void ForEachCoarse(std::int64_t x, std::int64_t y, std::int64_t width, const Pair& pair, Visitor&& visit)
{
  const CoarsePair along = pair(x);
  const CoarsePair across = pair(y);
  for (int high = 0; high < 2; ++high)
  {
    const double weight = high == 0 ? across.LowWeight : across.HighWeight;
    if (weight > 0.0)
    {
      const std::int64_t place = (across.Low + high) * width + along.Low;
      visit(place, weight * along.LowWeight);
      if (along.HighWeight > 0.0)
      {
        visit(place + 1, weight * along.HighWeight);
      }
    }
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
template <>
CoarsePair GridLevel<1>::Pair(std::int64_t x)
{
  const std::int64_t low = (x >> 1) + SiteBox::Margin;
  return x % 2 == 0 ? CoarsePair{ low, 1.0, 0.0 } : CoarsePair{ low, 0.5, 0.5 };
}

//----------------------------------------------------------------------------------------------------------------------
template <>
CoarsePair GridLevel<2>::Pair(std::int64_t x)
{
  const std::int64_t low = ((x + 1) >> 1) - 1 + SiteBox::Margin;
  return x % 2 == 0 ? CoarsePair{ low, 0.25, 0.75 } : CoarsePair{ low, 0.75, 0.25 };
}

//----------------------------------------------------------------------------------------------------------------------
template <int Radius>
GridLevel<Radius>::GridLevel(const SiteBox& sites, const StencilMatrix<Radius>& matrix)
  : Sites(&sites)
  , Matrix(&matrix)
{
}

//----------------------------------------------------------------------------------------------------------------------
template <int Radius>
std::unique_ptr<SiteBox> GridLevel<Radius>::MakeCoarserSites() const
{
  auto coarse = std::make_unique<SiteBox>();
  coarse->Width = this->Sites->Width / 2 + 2 * SiteBox::Margin + 2;
  coarse->Height = this->Sites->Height / 2 + 2 * SiteBox::Margin + 2;
  coarse->Number.assign(std::size_t(coarse->Width * coarse->Height), NoSite);
  for (const std::int64_t place : this->Sites->Place)
  {
    ForEachCoarse(place % this->Sites->Width, place / this->Sites->Width, coarse->Width, Pair,
      [&](std::int64_t coarsePlace, double) { coarse->Number[std::size_t(coarsePlace)] = 0; });
  }
  for (std::size_t place = 0; place < coarse->Number.size(); ++place)
  {
    if (coarse->Number[place] != NoSite)
    {
      coarse->Number[place] = std::int32_t(coarse->Place.size());
      coarse->Place.push_back(std::int64_t(place));
    }
  }
  return coarse;
}

//----------------------------------------------------------------------------------------------------------------------
template <int Radius>
void GridLevel<Radius>::AddCoarseRows(std::size_t site, const SiteBox& coarse, StencilMatrix<Radius>& result) const
{
  using Stencil = StencilMatrix<Radius>;
  const std::int64_t x = this->Sites->Place[site] % this->Sites->Width;
  const std::int64_t y = this->Sites->Place[site] / this->Sites->Width;
  // The row of A P, first along x and then along y.
  std::array<std::array<double, CoarseReach>, std::size_t(Stencil::Side)> alongX;
  for (int row = 0; row < Stencil::Side; ++row)
  {
    alongX[std::size_t(row)] =
      ToCoarse((*this->Matrix)[site].data() + row * Stencil::Side, Stencil::Side, x - Radius, Pair);
  }
  const std::int64_t beginX = Pair(x - Radius).Low;
  const std::int64_t beginY = Pair(y - Radius).Low;
  std::array<std::array<double, CoarseReach>, CoarseReach> image;
  for (std::size_t column = 0; column < CoarseReach; ++column)
  {
    std::array<double, std::size_t(Stencil::Side)> values;
    for (std::size_t row = 0; row < values.size(); ++row)
    {
      values[row] = alongX[row][column];
    }
    const std::array<double, CoarseReach> sums = ToCoarse(values.data(), Stencil::Side, y - Radius, Pair);
    for (std::size_t row = 0; row < CoarseReach; ++row)
    {
      image[row][column] = sums[row];
    }
  }
  ForEachCoarse(x, y, coarse.Width, Pair,
    [&](std::int64_t place, double weight)
    {
      typename Stencil::Row& target = result[std::size_t(coarse.Number[std::size_t(place)])];
      const std::int64_t dx = beginX - place % coarse.Width;
      const std::int64_t dy = beginY - place / coarse.Width;
      for (int row = 0; row < CoarseReach; ++row)
      {
        for (int column = 0; column < CoarseReach; ++column)
        {
          if (image[std::size_t(row)][std::size_t(column)] != 0.0)
          {
            target[Stencil::Index(dx + column, dy + row)] += weight * image[std::size_t(row)][std::size_t(column)];
          }
        }
      }
    });
}

//----------------------------------------------------------------------------------------------------------------------
template <int Radius>
std::unique_ptr<GridLevel<Radius>> GridLevel<Radius>::MakeCoarser() const
{
  std::unique_ptr<GridLevel> coarser(new GridLevel());
  coarser->OwnSites = this->MakeCoarserSites();
  coarser->OwnMatrix = std::make_unique<StencilMatrix<Radius>>(*coarser->OwnSites);
  coarser->Sites = coarser->OwnSites.get();
  coarser->Matrix = coarser->OwnMatrix.get();
  for (std::size_t site = 0; site < this->Size(); ++site)
  {
    this->AddCoarseRows(site, *coarser->OwnSites, *coarser->OwnMatrix);
  }
  return coarser;
}

//----------------------------------------------------------------------------------------------------------------------
template <int Radius>
void GridLevel<Radius>::Factor()
{
  constexpr double trifle = 1e-8;
  StencilMatrix<Radius> regular = *this->Matrix;
  for (std::size_t site = 0; site < this->Size(); ++site)
  {
    regular[site][StencilMatrix<Radius>::Centre] *= 1.0 + trifle;
  }
  this->Direct = std::make_unique<BandCholesky>(*this->Sites, regular, BandWidth(*this->Sites, Radius));
}

//----------------------------------------------------------------------------------------------------------------------
template <int Radius>
void GridLevel<Radius>::Multiply(const std::vector<double>& values, std::vector<double>& product) const
{
  for (std::size_t site = 0; site < this->Size(); ++site)
  {
    const std::int64_t place = this->Sites->Place[site];
    product[std::size_t(place)] = this->Matrix->Product(site, values.data() + place);
  }
}

//----------------------------------------------------------------------------------------------------------------------
template <int Radius>
void GridLevel<Radius>::Smooth(std::size_t site)
{
  const std::int64_t place = this->Sites->Place[site];
  const double rest = this->Side[std::size_t(place)] - this->Matrix->Product(site, this->Solution.data() + place);
  this->Solution[std::size_t(place)] += rest / (*this->Matrix)[site][StencilMatrix<Radius>::Centre];
}

//----------------------------------------------------------------------------------------------------------------------
template <int Radius>
void GridLevel<Radius>::SmoothFromNothing()
{
  this->Solution.assign(this->Sites->NumberOfPlaces(), 0.0);
  for (std::size_t site = 0; site < this->Size(); ++site)
  {
    this->Smooth(site);
  }
}

//----------------------------------------------------------------------------------------------------------------------
template <int Radius>
void GridLevel<Radius>::SmoothBackwards()
{
  for (std::size_t site = this->Size(); site-- > 0;)
  {
    this->Smooth(site);
  }
}

//----------------------------------------------------------------------------------------------------------------------
template <int Radius>
void GridLevel<Radius>::RestrictResidual(GridLevel& coarser) const
{
  coarser.Side.assign(coarser.Sites->NumberOfPlaces(), 0.0);
  for (std::size_t site = 0; site < this->Size(); ++site)
  {
    const std::int64_t place = this->Sites->Place[site];
    const double rest = this->Side[std::size_t(place)] - this->Matrix->Product(site, this->Solution.data() + place);
    ForEachCoarse(place % this->Sites->Width, place / this->Sites->Width, coarser.Sites->Width, Pair,
      [&](std::int64_t coarse, double weight) { coarser.Side[std::size_t(coarse)] += weight * rest; });
  }
}

//----------------------------------------------------------------------------------------------------------------------
template <int Radius>
void GridLevel<Radius>::AddInterpolated(const GridLevel& coarser)
{
  for (const std::int64_t place : this->Sites->Place)
  {
    ForEachCoarse(place % this->Sites->Width, place / this->Sites->Width, coarser.Sites->Width, Pair,
      [&](std::int64_t coarse, double weight)
      { this->Solution[std::size_t(place)] += weight * coarser.Solution[std::size_t(coarse)]; });
  }
}

//----------------------------------------------------------------------------------------------------------------------
template <int Radius>
void GridLevel<Radius>::SolveDirectly()
{
  std::vector<double> values = this->AtSites(this->Side);
  this->Direct->Solve(values);
  this->Solution = this->AtPlaces(values);
}

//----------------------------------------------------------------------------------------------------------------------
template <int Radius>
std::vector<double> GridLevel<Radius>::AtPlaces(const std::vector<double>& atSites) const
{
  std::vector<double> result(this->Sites->NumberOfPlaces(), 0.0);
  for (std::size_t site = 0; site < atSites.size(); ++site)
  {
    result[std::size_t(this->Sites->Place[site])] = atSites[site];
  }
  return result;
}

//----------------------------------------------------------------------------------------------------------------------
template <int Radius>
std::vector<double> GridLevel<Radius>::AtSites(const std::vector<double>& atPlaces) const
{
  std::vector<double> result(this->Size());
  for (std::size_t site = 0; site < result.size(); ++site)
  {
    result[site] = atPlaces[std::size_t(this->Sites->Place[site])];
  }
  return result;
}

template class GridLevel<1>;
template class GridLevel<2>;
}
