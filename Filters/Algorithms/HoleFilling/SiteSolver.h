// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Solution of a system on the lattice by the method that suits its size: Cholesky's factors within a band, the same for
// sparse matrices, or multigrid.

#ifndef SeismicHorizonsSiteSolver_h
#define SeismicHorizonsSiteSolver_h

#include "Common/Monitor.h"
#include "GapSystems.h"
#include "Multigrid.h"

#include <memory>
#include <vector>

namespace SeismicHorizons
{
/// From so many sites on, systems are solved by multigrid.
constexpr std::size_t MultigridSize = 10000;

template <int Radius>
class SiteSolver
{
public:
  /// The system has to last as long as the solver.
  explicit SiteSolver(const SiteSystem<Radius>& system);
  ~SiteSolver();

  /// Whether the system has one solution. Not known of systems for multigrid, for which it is always true.
  bool IsDefinite() const;

  /// Replaces a right side by the solution.
  void Solve(std::vector<double>& values, const Monitor& monitor) const;

private:
  struct Factors;

  std::unique_ptr<Factors> Direct; // one of the two
  std::unique_ptr<Multigrid<Radius>> Levels;
};
}

#endif
