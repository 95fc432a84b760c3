// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "BandCholesky.h"

#include <algorithm>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
std::size_t BandWidth(const SiteBox& box, int radius)
{
  // The site of highest number in reach is the one furthest on in the rows of the lattice.
  const auto furthest = [&](std::size_t site)
  {
    for (std::int64_t dy = radius; dy >= 0; --dy)
    {
      for (std::int64_t dx = radius; dx >= -radius; --dx)
      {
        const std::int32_t other = box.Number[std::size_t(box.Place[site] + dy * box.Width + dx)];
        if (other != NoSite)
        {
          return std::size_t(other);
        }
      }
    }
    return site;
  };
  std::size_t width = 0;
  for (std::size_t site = 0; site < box.Size(); ++site)
  {
    width = std::max(width, furthest(site) - site);
  }
  return width;
}

//----------------------------------------------------------------------------------------------------------------------
void BandCholesky::Factor()
{
  const std::size_t band = this->Stride - 1;
  std::vector<double> diagonal(this->Size);
  for (std::size_t n = 0; n < this->Size; ++n)
  {
    diagonal[n] = this->Columns[n * this->Stride];
  }
  for (std::size_t n = 0; n < this->Size; ++n)
  {
    double* const column = this->Columns.data() + n * this->Stride;
    this->Definite = this->Definite && column[0] > SmallestPivot * diagonal[n];
    if (!this->Definite)
    {
      return;
    }
    const std::size_t last = std::min(band, this->Size - 1 - n);
    for (std::size_t k = 1; k <= last; ++k)
    {
      if (column[k] != 0.0)
      {
        const double factor = column[k] / column[0];
        double* const target = column + k * this->Stride;
        for (std::size_t m = k; m <= last; ++m)
        {
          target[m - k] -= factor * column[m];
        }
      }
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
void BandCholesky::Solve(std::vector<double>& values) const
{
  const std::size_t band = this->Stride - 1;
  for (std::size_t n = 0; n < this->Size; ++n)
  {
    const double* const column = this->Columns.data() + n * this->Stride;
    const double factor = values[n] / column[0];
    const std::size_t last = std::min(band, this->Size - 1 - n);
    for (std::size_t k = 1; k <= last; ++k)
    {
      values[n + k] -= factor * column[k];
    }
  }
  for (std::size_t n = this->Size; n-- > 0;)
  {
    const double* const column = this->Columns.data() + n * this->Stride;
    const std::size_t last = std::min(band, this->Size - 1 - n);
    double sum = values[n];
    for (std::size_t k = 1; k <= last; ++k)
    {
      sum -= column[k] * values[n + k];
    }
    values[n] = sum / column[0];
  }
}
}
