// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Some places of a box of the lattice, which are the unknowns of a system of equations, and matrices whose rows reach
// no further than a few columns from their site.

#ifndef SeismicHorizonsSiteBox_h
#define SeismicHorizonsSiteBox_h

#include <array>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
constexpr std::int32_t NoSite = -1;

/// Sites are numbered row by row. No site is nearer than Margin places to a side of the box, so that neighbours need no
/// test for its sides.
struct SiteBox
{
  static constexpr int Margin = 2;

  std::size_t Size() const { return this->Place.size(); }
  std::size_t NumberOfPlaces() const { return std::size_t(this->Width * this->Height); }

  std::int64_t Width = 0;
  std::int64_t Height = 0;
  std::vector<std::int32_t> Number; // of the site at each place, or NoSite
  std::vector<std::int64_t> Place; // of each site
};

/// A symmetric matrix with a row of (2 Radius + 1) squared coefficients for each site, row by row of the lattice; those
/// of places without a site are 0.
template <int Radius>
class StencilMatrix
{
public:
  static constexpr int Reach = Radius;
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
        sum += row[std::size_t(dy * Side + dx)] * values[dx];
      }
    }
    return sum;
  }

private:
  std::vector<Row> Rows;
  std::int64_t Width;
};
}

#endif
