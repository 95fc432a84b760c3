// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Systems of equations with unknowns at sites, places of a box of the lattice, whose matrix rows reach a few columns.

#ifndef SeismicHorizonsSiteSolver_h
#define SeismicHorizonsSiteSolver_h

#include "BoxPlaces.h"
#include "Common/Base/Monitor.h"

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
constexpr std::int32_t NoSite = -1;

/// All places within Margin of a site exist, so that neighbours need no test.
struct SiteBox
{
  static constexpr int Margin = 2;

  explicit SiteBox(std::shared_ptr<const BoxPlaces> near)
    : Near(std::move(near))
    , Number(std::size_t(this->Near->Size()), NoSite)
  {
  }

  /// Makes all places of the runs sites.
  static SiteBox Fill(const std::vector<BoxRun>& runs)
  {
    SiteBox box(std::make_shared<const BoxPlaces>(runs, Margin));
    for (const BoxRun& run : runs)
    {
      const std::int64_t first = box.Near->Find({ run.First, run.Row });
      for (std::int64_t place = first; place <= first + run.Last - run.First; ++place)
      {
        box.Add(place);
      }
    }
    return box;
  }

  /// Sites must be added in ascending order.
  void Add(std::int64_t place)
  {
    assert(this->Place.empty() || this->Place.back() < place);
    this->Number[place] = std::int32_t(this->Place.size());
    this->Place.push_back(place);
  }

  std::size_t Size() const { return this->Place.size(); }

  std::int32_t Beside(std::size_t site, int dx, int dy) const
  {
    return this->Number[this->Near->Beside(this->Place[site], dx, dy)];
  }

  std::shared_ptr<const BoxPlaces> Near;
  std::vector<std::int32_t> Number; // by place, or NoSite
  std::vector<std::int64_t> Place; // by site
};

/// The matrix is symmetric. Each site has a row of (2 Radius + 1)^2 coefficients, 0 for places without a site.
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

  static constexpr std::size_t Index(std::int64_t dx, std::int64_t dy) { return std::size_t(Centre + dy * Side + dx); }

  Row& operator[](std::size_t site) { return this->Rows[site]; }
  const Row& operator[](std::size_t site) const { return this->Rows[site]; }

private:
  std::vector<Row> Rows;
};

template <int Radius>
struct SiteSystem
{
  using Stencil = StencilMatrix<Radius>;

  explicit SiteSystem(SiteBox sites)
    : Sites(std::move(sites))
    , Matrix(this->Sites.Size())
  {
  }

  std::int32_t SiteAt(std::size_t site, int index) const
  {
    return this->Sites.Beside(site, index % Stencil::Side - Radius, index / Stencil::Side - Radius);
  }

  SiteBox Sites;
  StencilMatrix<Radius> Matrix;
};

/// Larger systems use multigrid, unless they are narrow.
constexpr std::size_t MultigridSize = 10000;

class SiteSolver
{
public:
  virtual ~SiteSolver() = default;

  /// This is always true for multigrid, which cannot test it.
  virtual bool IsDefinite() const { return true; }

  /// Replaces the right side by the solution. Throws InputError if multigrid does not converge, which was never
  /// observed.
  virtual void Solve(std::vector<double>& values, const Monitor& monitor) const = 0;
};

/// A radius of 1 implies a membrane, 2 a plate. The system must outlive the solver.
template <int Radius>
std::unique_ptr<const SiteSolver> MakeSiteSolver(const SiteSystem<Radius>& system);
}

#endif
