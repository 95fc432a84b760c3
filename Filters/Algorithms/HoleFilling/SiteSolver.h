// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Systems of equations with an unknown for some places of a box of the lattice, their sites, and matrices whose rows
// reach no further than a few columns from their site.

#ifndef SeismicHorizonsSiteSolver_h
#define SeismicHorizonsSiteSolver_h

#include "BoxPlaces.h"
#include "Common/Monitor.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
constexpr std::int32_t NoSite = -1;

/// Sites are numbered row by row. All places up to Margin rows and columns from a site are there, so that neighbours
/// need no test.
struct SiteBox
{
  static constexpr int Margin = 2;

  explicit SiteBox(std::shared_ptr<const BoxPlaces> near)
    : Near(std::move(near))
    , Number(std::size_t(this->Near->Size()), NoSite)
  {
  }

  /// Makes a site at a place beyond those of all others.
  void Add(std::int64_t place)
  {
    this->Number[place] = std::int32_t(this->Place.size());
    this->Place.push_back(place);
  }

  std::size_t Size() const { return this->Place.size(); }

  /// The number of the site so many columns and rows from one, or NoSite.
  std::int32_t Beside(std::size_t site, int dx, int dy) const
  {
    return this->Number[this->Near->Beside(this->Place[site], dx, dy)];
  }

  std::shared_ptr<const BoxPlaces> Near;
  std::vector<std::int32_t> Number; // of the site at each place, or NoSite
  std::vector<std::int64_t> Place; // of each site
};

/// A symmetric matrix with a row of (2 Radius + 1) squared coefficients for each site, row by row of the lattice; those
/// of places without a site are 0.
template <int Radius>
class StencilMatrix
{
public:
  static constexpr int Side = 2 * Radius + 1;
  static constexpr int Length = Side * Side;
  static constexpr int Centre = Length / 2;
  using Row = std::array<double, std::size_t(Length)>;

  explicit StencilMatrix(std::size_t sites)
    : Rows(sites, Row{})
  {
  }

  /// The position in a row of the coefficient for a place that is `dx`, `dy` away.
  static constexpr std::size_t Index(std::int64_t dx, std::int64_t dy) { return std::size_t(Centre + dy * Side + dx); }

  Row& operator[](std::size_t site) { return this->Rows[site]; }
  const Row& operator[](std::size_t site) const { return this->Rows[site]; }

private:
  std::vector<Row> Rows;
};

/// A matrix with its sites; a right side is a number for each of these.
template <int Radius>
struct SiteSystem
{
  using Stencil = StencilMatrix<Radius>;

  explicit SiteSystem(SiteBox sites)
    : Sites(std::move(sites))
    , Matrix(this->Sites.Size())
  {
  }

  /// The number of the site that a position in the row of another one is for, or NoSite.
  std::int32_t SiteAt(std::size_t site, int index) const
  {
    return this->Sites.Beside(site, index % Stencil::Side - Radius, index / Stencil::Side - Radius);
  }

  SiteBox Sites;
  StencilMatrix<Radius> Matrix;
};

/// From so many sites on, systems are solved by multigrid, unless they are narrow.
constexpr std::size_t MultigridSize = 10000;

/// Solves a system for any number of right sides: directly when it is small or narrow, else by multigrid. Those of
/// radius 1 are taken for membranes, of radius 2 for plates.
template <int Radius>
class SiteSolver
{
public:
  /// The system has to last as long as the solver.
  explicit SiteSolver(const SiteSystem<Radius>& system);
  ~SiteSolver();

  /// Whether the matrix is positive definite, beyond rounding. Not known of systems for multigrid, for which it is
  /// always true.
  bool IsDefinite() const;

  /// Replaces a right side by the solution. Throws InputError when multigrid does not converge, which is the case for
  /// nothing that was tried.
  void Solve(std::vector<double>& values, const Monitor& monitor) const;

private:
  struct Method;

  std::unique_ptr<Method> Chosen;
};
}

#endif
