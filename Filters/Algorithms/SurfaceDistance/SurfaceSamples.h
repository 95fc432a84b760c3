// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Places spread evenly over triangles and edges. They follow from a random number alone, which the caller makes out of
// a seed and the triangle or edge: so they are the same for any number of threads.

#ifndef SeismicHorizonsSurfaceSamples_h
#define SeismicHorizonsSurfaceSamples_h

#include <Eigen/Core>

#include <cmath>
#include <cstdint>

namespace SeismicHorizons
{
/// A pseudo-random number of 64 bits for each counter (Steele, Lea and Flood 2014, the last step of SplitMix64).
inline std::uint64_t Scramble(std::uint64_t counter)
{
  std::uint64_t bits = counter * 0x9e3779b97f4a7c15ULL;
  bits = (bits ^ (bits >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  bits = (bits ^ (bits >> 27U)) * 0x94d049bb133111ebULL;
  return bits ^ (bits >> 31U);
}

/// From 0 to below 1.
inline double Fraction(std::uint64_t bits)
{
  return double(bits >> 11U) * 0x1.0p-53;
}

/// Calls visit(place) for `count` places on a triangle: those of the sequence R2 (Roberts 2018), which fills the unit
/// square evenly for any count, shifted at random, and folded from the square onto the triangle.
template <typename Visitor>
void SampleTriangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, std::int64_t count,
  std::uint64_t random, Visitor&& visit)
{
  constexpr double StepU = 0.7548776662466927; // 1 / g and 1 / g^2, where g^3 = g + 1
  constexpr double StepV = 0.5698402909980532;
  double u = Fraction(random);
  double v = Fraction(Scramble(random));
  for (std::int64_t n = 0; n < count; ++n)
  {
    const bool beyond = u + v > 1.0; // in the half of the square that is folded
    visit(Eigen::Vector3d(a + (beyond ? 1.0 - u : u) * (b - a) + (beyond ? 1.0 - v : v) * (c - a)));
    u += u + StepU < 1.0 ? StepU : StepU - 1.0;
    v += v + StepV < 1.0 ? StepV : StepV - 1.0;
  }
}

/// Calls visit(place) for `count` places on an edge: a random one on each of so many equal pieces.
template <typename Visitor>
void SampleEdge(
  const Eigen::Vector3d& a, const Eigen::Vector3d& b, std::int64_t count, std::uint64_t random, Visitor&& visit)
{
  for (std::int64_t n = 0; n < count; ++n)
  {
    const double part = (double(n) + Fraction(Scramble(random + std::uint64_t(n)))) / double(count);
    visit(Eigen::Vector3d(a + part * (b - a)));
  }
}
}

#endif
