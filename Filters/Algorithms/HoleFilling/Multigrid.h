// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Solution of large systems on the lattice: conjugate gradients, preconditioned by a multigrid cycle. Each coarser
// level has half the sites along each axis, and the matrix P^T A P of the space that the interpolation P spans
// (Galerkin). So gaps may have any shape. Time and memory are linear in the sites.
//
// What matters is that the interpolation spans surfaces of a low energy. For membranes these are bilinear. The bending
// energy of bilinear surfaces however sits in their creases, and grows with each level; plates are interpolated by
// quadratic splines (Chaikin's weights 1 3 3 1), which have none. The number of cycles hardly depends on the size then.
// Both keep the reach of the matrix, on all levels.

#ifndef SeismicHorizonsMultigrid_h
#define SeismicHorizonsMultigrid_h

#include "Common/Monitor.h"
#include "SiteBox.h"

#include <memory>
#include <vector>

namespace SeismicHorizons
{
/// By what the residual, measured as the error in energy that the preconditioner expects, has to fall.
constexpr double MultigridAccuracy = 1e-11;

/// A system whose levels are made once, for any number of right sides. Matrices of radius 1 are taken for membranes, of
/// radius 2 for plates.
template <int Radius>
class Multigrid
{
public:
  /// Sites and matrix have to last as long as this.
  Multigrid(const SiteBox& sites, const StencilMatrix<Radius>& matrix);
  ~Multigrid();

  /// Replaces a right side by the solution. Throws InputError when it does not converge, which is the case for nothing
  /// that was tried.
  void Solve(std::vector<double>& values, const Monitor& monitor) const;

private:
  class Hierarchy;

  std::unique_ptr<Hierarchy> Levels;
};
}

#endif
