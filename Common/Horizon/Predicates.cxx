// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Predicates.h"

#include <cmath>

namespace SeismicHorizons
{
namespace
{
/// Coordinates are relative to d.
struct ThreePlaces
{
  std::int64_t X[3];
  std::int64_t Y[3];
};

ThreePlaces SeenFrom(const PlanePoint& d, const PlanePoint& a, const PlanePoint& b, const PlanePoint& c)
{
  const std::int64_t x = d.X;
  const std::int64_t y = d.Y;
  return { { a.X - x, b.X - x, c.X - x }, { a.Y - y, b.Y - y, c.Y - y } };
}

/// The rows of the determinant are (x, y, lift).
template <typename Lift>
int DeterminantSign(const ThreePlaces& t, Lift&& lift)
{
  Int128 sum = 0;
  for (int n = 0; n < 3; ++n)
  {
    const int next = (n + 1) % 3;
    const int last = (n + 2) % 3;
    sum += Int128(t.X[next] * t.Y[last] - t.X[last] * t.Y[next]) * lift(t.X[n], t.Y[n]);
  }
  return Sign(sum);
}

// Terms of the determinant are rounded at most seven times and their sum twice, each by 2^-53 of the sum of absolute
// terms; 16 is a safe bound.
constexpr double DeterminantRounding = 16.0 / 9007199254740992.0;

/// Uses doubles and the lift x^2 + y^2; returns 0 if rounding may have changed the sign.
int FilteredDeterminantSign(const ThreePlaces& t)
{
  double sum = 0.0;
  double size = 0.0;
  for (int n = 0; n < 3; ++n)
  {
    const int next = (n + 1) % 3;
    const int last = (n + 2) % 3;
    const double left = double(t.X[next]) * double(t.Y[last]);
    const double right = double(t.X[last]) * double(t.Y[next]);
    const double lift = double(t.X[n]) * double(t.X[n]) + double(t.Y[n]) * double(t.Y[n]);
    sum += (left - right) * lift;
    size += (std::abs(left) + std::abs(right)) * lift;
  }
  const double bound = size * DeterminantRounding;
  return sum > bound ? 1 : (sum < -bound ? -1 : 0);
}
}

//----------------------------------------------------------------------------------------------------------------------
int InCircle(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, const PlanePoint& d)
{
  const ThreePlaces seen = SeenFrom(d, a, b, c);
  if (const int sign = FilteredDeterminantSign(seen))
  {
    return sign;
  }
  if (const int sign = DeterminantSign(seen, [](std::int64_t x, std::int64_t y) { return x * x + y * y; }))
  {
    return sign;
  }
  if (const int sign = DeterminantSign(seen, [](std::int64_t x, std::int64_t y) { return x * y; }))
  {
    return sign;
  }
  return DeterminantSign(seen, [](std::int64_t x, std::int64_t) { return x * x; });
}
}
