// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A level of a multigrid (Multigrid.h). Vectors have a number for each place of the box, 0 where there is no site, so
// that rows of the matrix need no indices.

#ifndef SeismicHorizonsGridLevel_h
#define SeismicHorizonsGridLevel_h

#include "BandCholesky.h"
#include "SiteBox.h"

#include <memory>
#include <vector>

namespace SeismicHorizons
{
/// The two coarse sites that stand for a fine one along an axis, neighbours, and their weights.
struct CoarsePair
{
  std::int64_t Low;
  double LowWeight;
  double HighWeight;
};

template <int Radius>
class GridLevel
{
public:
  /// The matrix has to last as long as the level.
  GridLevel(const SiteBox& sites, const StencilMatrix<Radius>& matrix);

  std::size_t Size() const { return this->Sites->Size(); }

  /// The next level, whose surfaces are interpolated to this one.
  std::unique_ptr<GridLevel> MakeCoarser() const;

  /// Prepares the direct solution. Coarse surfaces that are the same on all fine sites make the matrix singular, which
  /// does no harm to what is interpolated; a diagonal that is larger by a trifle makes it regular.
  void Factor();

  void Multiply(const std::vector<double>& values, std::vector<double>& product) const;

  /// Steps of a cycle, by Side and Solution: a Gauss-Seidel sweep over a solution of 0; the rest of the right side to
  /// the coarser level; the coarser solution to this one; a sweep in the opposite order.
  void SmoothFromNothing();
  void RestrictResidual(GridLevel& coarser) const;
  void AddInterpolated(const GridLevel& coarser);
  void SmoothBackwards();
  void SolveDirectly();

  std::vector<double> AtPlaces(const std::vector<double>& atSites) const;
  std::vector<double> AtSites(const std::vector<double>& atPlaces) const;

  std::vector<double> Side;
  std::vector<double> Solution;

private:
  GridLevel() = default;

  /// Coordinates of this level's box to those of the coarser one.
  static CoarsePair Pair(std::int64_t x);

  std::unique_ptr<SiteBox> MakeCoarserSites() const;
  void AddCoarseRows(std::size_t site, const SiteBox& coarse, StencilMatrix<Radius>& result) const;
  void Smooth(std::size_t site);

  std::unique_ptr<SiteBox> OwnSites; // not those of the finest level
  std::unique_ptr<StencilMatrix<Radius>> OwnMatrix;
  const SiteBox* Sites = nullptr;
  const StencilMatrix<Radius>* Matrix = nullptr;
  std::unique_ptr<BandCholesky> Direct;
};
}

#endif
