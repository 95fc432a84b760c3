// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A matrix as sweeps over its sites need it. Most rows, those inside the hole, are the same and kept once: so they stay
// in the cache, where the matrix itself would come from memory at each sweep. Sites go by stretches, for each of which
// it is looked up once where the neighbours are.

#ifndef SeismicHorizonsStencilTable_h
#define SeismicHorizonsStencilTable_h

#include "SiteSolver.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace SeismicHorizons
{
/// `Radius` as that of the matrix.
template <int Radius>
class StencilTable
{
public:
  static constexpr int Side = StencilMatrix<Radius>::Side;
  /// From a place to those above and below, by rows of the stencil.
  using Steps = std::array<std::ptrdiff_t, std::size_t(Side)>;

  /// A row of the matrix, seen from its place in a vector.
  struct Row
  {
    typename StencilMatrix<Radius>::Row Coefficients;
    double InverseCentre = 0.0;

    double operator[](int dx) const { return this->Coefficients[std::size_t(StencilMatrix<Radius>::Centre + dx)]; }

    /// The part of the product that rows of the stencil have, from -Radius on.
    double Rows(int first, int last, const Steps& steps, const double* values) const
    {
      double sum = 0.0;
      for (int dy = first; dy <= last; ++dy)
      {
        const double* const coefficients = this->Coefficients.data() + (dy + Radius) * Side + Radius;
        const double* const beside = values + steps[std::size_t(dy + Radius)];
        double part = 0.0;
        for (int dx = -Radius; dx <= Radius; ++dx)
        {
          part += coefficients[dx] * beside[dx];
        }
        sum += part;
      }
      return sum;
    }

    /// The same of the sites before, or after, that of the row.
    double Before(const Steps& steps, const double* values) const
    {
      double sum = this->Rows(-Radius, -1, steps, values);
      for (int dx = -Radius; dx < 0; ++dx)
      {
        sum += (*this)[dx] * values[dx]; // the nearest last, as it was found last
      }
      return sum;
    }
    double After(const Steps& steps, const double* values) const
    {
      double sum = this->Rows(1, Radius, steps, values);
      for (int dx = Radius; dx > 0; --dx)
      {
        sum += (*this)[dx] * values[dx];
      }
      return sum;
    }
  };

  explicit StencilTable(const SiteSystem<Radius>& system)
  {
    this->FindStretches(system.Sites);
    this->FindRows(system);
  }

  /// Calls visit(site, place, row, steps) for all sites.
  template <typename Visitor>
  void ForEach(Visitor&& visit) const
  {
    for (const Stretch& stretch : this->Stretches)
    {
      for (std::size_t site = stretch.First; site < stretch.End; ++site)
      {
        visit(
          site, stretch.Place + std::int64_t(site - stretch.First), this->Distinct[this->RowOf[site]], stretch.Next);
      }
    }
  }

  template <typename Visitor>
  void ForEachBackwards(Visitor&& visit) const
  {
    for (auto stretch = this->Stretches.rbegin(); stretch != this->Stretches.rend(); ++stretch)
    {
      for (std::size_t site = stretch->End; site-- > stretch->First;)
      {
        visit(
          site, stretch->Place + std::int64_t(site - stretch->First), this->Distinct[this->RowOf[site]], stretch->Next);
      }
    }
  }

private:
  /// Successive sites of a row of the box.
  struct Stretch
  {
    std::size_t First;
    std::size_t End;
    std::int64_t Place; // of the first one
    Steps Next;
  };

  void FindStretches(const SiteBox& sites)
  {
    for (std::size_t site = 0; site < sites.Size(); ++site)
    {
      const std::int64_t place = sites.Place[site];
      Steps next;
      for (int dy = -Radius; dy <= Radius; ++dy)
      {
        next[std::size_t(dy + Radius)] = sites.Near->Beside(place, 0, dy) - place;
      }
      if (site == 0 || sites.Place[site - 1] != place - 1 || this->Stretches.back().Next != next)
      {
        this->Stretches.push_back({ site, site, place, next });
      }
      this->Stretches.back().End = site + 1;
    }
  }

  /// A row is looked for where the last one of its hash was put.
  void FindRows(const SiteSystem<Radius>& system)
  {
    constexpr int hashBits = 12;
    std::vector<std::int32_t> recent(std::size_t(1) << hashBits, 0);
    this->RowOf.reserve(system.Sites.Size());
    for (std::size_t site = 0; site < system.Sites.Size(); ++site)
    {
      const typename StencilMatrix<Radius>::Row& row = system.Matrix[site];
      if (site > 0 && this->Distinct[this->RowOf.back()].Coefficients == row)
      {
        this->RowOf.push_back(this->RowOf.back());
        continue;
      }
      std::uint64_t hash = 0;
      for (const double coefficient : row)
      {
        hash = (hash ^ std::hash<double>()(coefficient)) * 0x9E3779B97F4A7C15U; // the golden ratio
      }
      std::int32_t& known = recent[hash >> (64 - hashBits)];
      if (this->Distinct.empty() || this->Distinct[known].Coefficients != row)
      {
        known = std::int32_t(this->Distinct.size());
        this->Distinct.push_back({ row, 1.0 / row[StencilMatrix<Radius>::Centre] });
      }
      this->RowOf.push_back(known);
    }
  }

  std::vector<Stretch> Stretches;
  std::vector<std::int32_t> RowOf; // of each site, in Distinct
  std::vector<Row> Distinct;
};
}

#endif
