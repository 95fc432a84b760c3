// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Direct solution of small systems on the lattice: Cholesky's factors L D L^T within the band around the diagonal. For
// a few hundred sites it takes a tenth of the time of a sparse method, which has to find an order of the sites first.

#ifndef SeismicHorizonsBandCholesky_h
#define SeismicHorizonsBandCholesky_h

#include "SiteBox.h"

#include <cstddef>
#include <vector>

namespace SeismicHorizons
{
/// A pivot this much smaller than its diagonal element shows that the sites are not held by anything known: of plates
/// of 10^5 columns that are held, the least are near 1e-4, of others near 1e-15.
constexpr double SmallestPivot = 1e-9;

/// How far from the diagonal the matrices of these sites have coefficients.
std::size_t BandWidth(const SiteBox& box, int radius);

class BandCholesky
{
public:
  template <int Radius>
  BandCholesky(const SiteBox& box, const StencilMatrix<Radius>& matrix, std::size_t bandWidth)
    : Size(box.Size())
    , Stride(bandWidth + 1)
    , Columns(Size * Stride, 0.0)
  {
    for (std::size_t site = 0; site < this->Size; ++site)
    {
      for (int n = StencilMatrix<Radius>::Centre; n < StencilMatrix<Radius>::Length; ++n)
      {
        const std::int32_t other = box.Number[std::size_t(box.Place[site] + matrix.Step(n))];
        if (other != NoSite)
        {
          this->Columns[site * this->Stride + (std::size_t(other) - site)] = matrix[site][std::size_t(n)];
        }
      }
    }
    this->Factor();
  }

  /// Whether the matrix is positive definite, beyond rounding.
  bool IsDefinite() const { return this->Definite; }

  /// Replaces the right side, a number for each site, by the solution.
  void Solve(std::vector<double>& values) const;

private:
  void Factor();

  std::size_t Size;
  std::size_t Stride;
  std::vector<double> Columns; // each from its diagonal element down
  bool Definite = true;
};
}

#endif
