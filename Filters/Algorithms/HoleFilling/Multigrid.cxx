// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Multigrid.h"

#include "GridLevel.h"

#include <cmath>
#include <memory>
#include <numeric>
#include <string>

namespace SeismicHorizons
{
namespace
{
constexpr std::size_t CoarsestSize = 600; // sites, for which a direct solution takes less time than another cycle
constexpr int MostCycles = 500;

double Product(const std::vector<double>& a, const std::vector<double>& b)
{
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

/// Adds `factor` times `b` to `a`.
void AddTo(std::vector<double>& a, double factor, const std::vector<double>& b)
{
  for (std::size_t n = 0; n < a.size(); ++n)
  {
    a[n] += factor * b[n];
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
/// The levels of the grid, the finest first, and a cycle over them.
template <int Radius>
class Multigrid<Radius>::Hierarchy
{
public:
  Hierarchy(const SiteBox& sites, const StencilMatrix<Radius>& matrix)
  {
    this->Levels.push_back(std::make_unique<GridLevel<Radius>>(sites, matrix));
    while (this->Levels.back()->Size() > CoarsestSize)
    {
      auto coarser = this->Levels.back()->MakeCoarser();
      const bool isSmaller = coarser->Size() < this->Levels.back()->Size();
      this->Levels.push_back(std::move(coarser));
      if (!isSmaller)
      {
        break;
      }
    }
    this->Levels.back()->Factor();
  }

  /// An approximate solution for a right side, both by places: symmetric, as conjugate gradients need it.
  void Cycle(const std::vector<double>& side, std::vector<double>& solution)
  {
    this->Levels.front()->Side = side;
    this->Descend(0);
    solution.swap(this->Levels.front()->Solution);
  }

  const GridLevel<Radius>& Finest() const { return *this->Levels.front(); }

private:
  void Descend(std::size_t n)
  {
    GridLevel<Radius>& level = *this->Levels[n];
    if (n + 1 == this->Levels.size())
    {
      level.SolveDirectly();
      return;
    }
    GridLevel<Radius>& coarser = *this->Levels[n + 1];
    level.SmoothFromNothing();
    level.RestrictResidual(coarser);
    this->Descend(n + 1);
    level.AddInterpolated(coarser);
    level.SmoothBackwards();
  }

  std::vector<std::unique_ptr<GridLevel<Radius>>> Levels;
};

//----------------------------------------------------------------------------------------------------------------------
template <int Radius>
Multigrid<Radius>::Multigrid(const SiteBox& sites, const StencilMatrix<Radius>& matrix)
  : Levels(std::make_unique<Hierarchy>(sites, matrix))
{
}

//----------------------------------------------------------------------------------------------------------------------
template <int Radius>
Multigrid<Radius>::~Multigrid() = default;

//----------------------------------------------------------------------------------------------------------------------
template <int Radius>
void Multigrid<Radius>::Solve(std::vector<double>& values, const Monitor& monitor) const
{
  Hierarchy& levels = *this->Levels;
  const GridLevel<Radius>& finest = levels.Finest();
  std::vector<double> residual = finest.AtPlaces(values);
  std::vector<double> solution(residual.size(), 0.0);
  std::vector<double> corrected(residual.size(), 0.0);
  std::vector<double> direction(residual.size(), 0.0);
  std::vector<double> image(residual.size(), 0.0);
  levels.Cycle(residual, corrected);
  double energy = Product(residual, corrected);
  const double enough = MultigridAccuracy * MultigridAccuracy * energy;
  double before = 0.0;
  int cycle = 0;
  for (; energy > enough && cycle < MostCycles; ++cycle)
  {
    monitor.Progress(1.0 - 1.0 / (1.0 + 0.1 * cycle));
    const double part = before > 0.0 ? energy / before : 0.0;
    for (std::size_t n = 0; n < direction.size(); ++n)
    {
      direction[n] = corrected[n] + part * direction[n];
    }
    finest.Multiply(direction, image);
    const double step = energy / Product(direction, image);
    AddTo(solution, step, direction);
    AddTo(residual, -step, image);
    levels.Cycle(residual, corrected);
    before = energy;
    energy = Product(residual, corrected);
  }
  if (!(energy <= enough))
  {
    throw InputError("a gap of " + std::to_string(finest.Size()) + " unknowns whose surface was not found in " +
      std::to_string(MostCycles) +
      " cycles, expected at most a few dozen; Membrane in place of Plate is found quicker");
  }
  values = finest.AtSites(solution);
}

template class Multigrid<1>;
template class Multigrid<2>;
}
