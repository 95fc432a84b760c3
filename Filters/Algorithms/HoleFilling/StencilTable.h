// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A matrix for sweeps over its sites. Most rows, inside the hole, are equal and stored once, so that they stay in the
// cache. Sites are grouped in stretches whose neighbours are at equal offsets.

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
template <int Radius>
class StencilTable
{
public:
  static constexpr int Side = StencilMatrix<Radius>::Side;
  using Steps = std::array<std::ptrdiff_t, std::size_t(Side)>;

  struct Row
  {
    typename StencilMatrix<Radius>::Row Coefficients;
    double InverseCentre = 0.0;

    double operator[](int dx) const { return this->Coefficients[std::size_t(StencilMatrix<Radius>::Centre + dx)]; }

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

    double Before(const Steps& steps, const double* values) const
    {
      double sum = this->Rows(-Radius, -1, steps, values);
      for (int dx = -Radius; dx < 0; ++dx)
      {
        sum += (*this)[dx] * values[dx]; // The nearest value comes last, as it was computed last.
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
  struct Stretch
  {
    std::size_t First;
    std::size_t End;
    std::int64_t Place;
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

  /// A small hash table of recent rows replaces a full search.
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
        hash = (hash ^ std::hash<double>()(coefficient)) * 0x9E3779B97F4A7C15U; // The multiplier is the golden ratio.
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
  std::vector<std::int32_t> RowOf; // by site, in Distinct
  std::vector<Row> Distinct;
};
}

#endif
