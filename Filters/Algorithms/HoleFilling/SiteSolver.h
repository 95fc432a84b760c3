// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Systems of equations with an unknown for some places of a box of the lattice, their sites, and matrices whose rows
// reach no further than a few columns from their site.

#ifndef SeismicHorizonsSiteSolver_h
#define SeismicHorizonsSiteSolver_h

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

/// Sites are numbered row by row. No site is nearer than Margin places to a side of the box, so that neighbours need no
/// test for its sides.
struct SiteBox
{
  static constexpr int Margin = 2;

  SiteBox(std::int64_t width, std::int64_t height)
    : Width(width)
    , Height(height)
    , Number(std::size_t(width * height), NoSite)
  {
  }

  /// Makes a site at a place beyond those of all others.
  void Add(std::int64_t place)
  {
    this->Number[place] = std::int32_t(this->Place.size());
    this->Place.push_back(place);
  }

  std::size_t Size() const { return this->Place.size(); }

  std::int64_t Width;
  std::int64_t Height;
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

  explicit StencilMatrix(const SiteBox& box)
    : Rows(box.Size(), Row{})
    , Width(box.Width)
  {
  }

  /// The position in a row of the coefficient for a place that is `dx`, `dy` away.
  static constexpr std::size_t Index(std::int64_t dx, std::int64_t dy) { return std::size_t(Centre + dy * Side + dx); }

  /// How much further a place is than that of the row, for a position in it.
  std::int64_t Step(int index) const
  {
    return std::int64_t(index / Side - Radius) * this->Width + (index % Side - Radius);
  }

  Row& operator[](std::size_t site) { return this->Rows[site]; }
  const Row& operator[](std::size_t site) const { return this->Rows[site]; }

  /// Of the row of the site at `place`, times values given for each place.
  double Product(std::size_t site, const double* atPlace) const
  {
    const Row& row = this->Rows[site];
    double sum = 0.0;
    for (int dy = 0; dy < Side; ++dy)
    {
      const double* const values = atPlace + (dy - Radius) * this->Width - Radius;
      for (int dx = 0; dx < Side; ++dx)
      {
        sum += row[dy * Side + dx] * values[dx];
      }
    }
    return sum;
  }

private:
  std::vector<Row> Rows;
  std::int64_t Width;
};

/// A matrix with its sites; a right side is a number for each of these.
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
