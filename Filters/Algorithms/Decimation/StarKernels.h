// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Measures stars, the triangles between a centre and its ring, where the height of the centre is free.
//
// A column in such a triangle has an error e and a weight w of the centre, so its error is e + t w if the centre moves
// by t. Every column bounds t, and sums of powers of all errors are polynomials of t.

#ifndef SeismicHorizonsStarKernels_h
#define SeismicHorizonsStarKernels_h

#include <array>
#include <cstdint>

namespace SeismicHorizons
{
/// Heights row by row, NaN without a point. Seven values beyond the last one are read.
template <typename Real>
struct HeightGrid
{
  const Real* Heights;
  std::int64_t Width;

  std::int64_t Place(std::int32_t x, std::int32_t y) const { return y * this->Width + x; }
  Real At(std::int32_t x, std::int32_t y) const { return this->Heights[this->Place(x, y)]; }
};

template <typename Real>
struct StarCorner
{
  std::int32_t X;
  std::int32_t Y;
  Real Height;
};

/// The ring is counter-clockwise. An open one has no triangle between its last corner and its first.
template <typename Real>
struct Star
{
  StarCorner<Real> Centre;
  const StarCorner<Real>* Ring;
  int Size;
  bool IsClosed;

  int NumberOfTriangles() const { return this->IsClosed ? this->Size : this->Size - 1; }
  const StarCorner<Real>& Next(int n) const { return this->Ring[n + 1 == this->Size ? 0 : n + 1]; }
};

/// The last columns that were in the way of a vertex, its own first. They refuse most stars without a look at others.
template <typename Real>
struct CriticalColumns
{
  static constexpr int Size = 8;

  std::array<Real, Size> X;
  std::array<Real, Size> Y;
  std::array<Real, Size> Height;
  int Next = 1;
};

/// How far the centre may move; no way if the lowest is above the highest. These two columns are at places of the grid.
template <typename Real>
struct FreeRange
{
  Real Lowest;
  Real Highest;
  std::int64_t LowestAt;
  std::int64_t HighestAt;

  bool IsEmpty() const { return this->Lowest > this->Highest; }
};

/// Sums of (e / unit)^(power - n) w^n by n. The power is 2 or 4.
struct StarSums
{
  int Power = 4;
  std::array<double, 5> Sums = {};
  /// The sum falls in the direction of this vector if the centre moves on the map: an error changes by w times the slope
  /// of its triangle.
  std::array<double, 2> Descent = {};

  /// Adds a column, whose error is in units, so often.
  void Add(double error, double weight, double times = 1.0);
  /// Of a move in units.
  double At(double move) const;
  /// The move between two bounds with the least sum.
  double FindBest(double lowest, double highest) const;
};

template <typename Real>
struct StarKernels
{
  using Triangle = std::array<StarCorner<Real>, 3>;

  /// Infinite if an error exceeds the bound.
  Real (*SumTriangle)(const HeightGrid<Real>& grid, const Triangle& triangle, int power, Real perUnit, Real bound);
  FreeRange<Real> (*FindRange)(const HeightGrid<Real>& grid, const Star<Real>& star, Real bound);
  StarSums (*SumStar)(const HeightGrid<Real>& grid, const Star<Real>& star, int power, Real perUnit);
  /// Whether the centre can move, or stay if it is not free, so that all critical columns are within the bound.
  bool (*IsPossible)(const CriticalColumns<Real>& columns, const Star<Real>& star, bool isFree, Real bound);
};

/// Those for this processor, or for any. All give the same numbers.
template <typename Real>
const StarKernels<Real>& KernelsForStars(bool isForAny = false);
}

#endif
