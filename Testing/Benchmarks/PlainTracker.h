// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A peer of guided extraction: a plain tracker from all picks at once, best correlation first, which is given the true
// period. It shares no code with the product.

#ifndef SeismicHorizonsPlainTracker_h
#define SeismicHorizonsPlainTracker_h

#include "Common/Survey/LatticeHorizon.h"
#include "Filters/Algorithms/Reflections/GuidedJoining.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <queue>
#include <tuple>
#include <vector>

namespace SeismicHorizons
{
/// Cubic between samples (Keys 1981).
inline double SampleAt(const float* trace, int samples, double place)
{
  const int k = int(std::floor(place));
  const auto sample = [&](int n) { return n < 0 || n >= samples || std::isnan(trace[n]) ? 0.0 : double(trace[n]); };
  const double t = place - k, a = sample(k - 1), b = sample(k), c = sample(k + 1), d = sample(k + 2);
  return b + 0.5 * t * (c - a + t * (2.0 * a - 5.0 * b + 4.0 * c - d + t * (3.0 * (b - c) + d - a)));
}

inline double CorrelateAt(
  const float* one, double onePlace, const float* other, double otherPlace, int samples, long half)
{
  double ab = 0.0, aa = 0.0, bb = 0.0;
  for (long k = -half; k <= half; ++k)
  {
    const double a = SampleAt(one, samples, onePlace + double(k));
    const double b = SampleAt(other, samples, otherPlace + double(k));
    ab += a * b;
    aa += a * a;
    bb += b * b;
  }
  return aa * bb > 0.0 ? ab / std::sqrt(aa * bb) : 0.0;
}

inline LatticeHorizon TrackPlainly(
  const std::vector<float>& traces, const std::array<int, 3>& size, double period, const Guide& guide)
{
  const auto trace = [&](int column) { return traces.data() + std::ptrdiff_t(column) * size[2]; };
  double vote = 0.0;
  for (const GuidePick& pick : guide.Picks)
  {
    vote += SampleAt(trace(pick.I + size[0] * pick.J), size[2], pick.Place);
  }
  const double step = std::max(2.0, 0.3 * period);
  std::vector<double> found(std::size_t(size[0] * size[1]), std::nan(""));
  std::priority_queue<std::tuple<double, int, double>> rim; // correlation, column and place
  const auto addPeaks = [&](int column, double place, auto&& score)
  {
    const auto at = [&](int k) { return std::copysign(1.0, vote) * double(trace(column)[k]); };
    for (int k = std::max(1, int(place - step)); k <= std::min(size[2] - 2, int(place + step) + 1); ++k)
    {
      const double peak = k + 0.5 * (at(k - 1) - at(k + 1)) / (at(k - 1) - 2.0 * at(k) + at(k + 1));
      if (at(k) > 0.0 && at(k) >= at(k - 1) && at(k) > at(k + 1) && std::abs(peak - place) <= step)
      {
        rim.emplace(score(peak), column, peak);
      }
    }
  };
  for (const GuidePick& pick : guide.Picks)
  {
    addPeaks(
      pick.I + size[0] * pick.J, pick.Place, [&](double peak) { return 3.0 - std::abs(peak - pick.Place) / step; });
  }
  while (!rim.empty())
  {
    const auto [score, column, place] = rim.top();
    rim.pop();
    for (int n = 0; n < 9 && score >= 0.6 && std::isnan(found[std::size_t(column)]); ++n)
    {
      const int i = column % size[0] + n % 3 - 1, j = column / size[0] + n / 3 - 1;
      if (n != 4 && i >= 0 && i < size[0] && j >= 0 && j < size[1] && std::isnan(found[std::size_t(i + size[0] * j)]))
      {
        const float *const from = trace(column), *const to = trace(i + size[0] * j);
        addPeaks(i + size[0] * j, place,
          [&, depth = place](double peak)
          { return CorrelateAt(from, depth, to, peak, size[2], std::lround(1.5 * period)); });
      }
    }
    found[std::size_t(column)] =
      score >= 0.6 && std::isnan(found[std::size_t(column)]) ? place : found[std::size_t(column)];
  }
  LatticeHorizon horizon;
  for (int column = 0; column < size[0] * size[1]; ++column)
  {
    if (!std::isnan(found[std::size_t(column)]))
    {
      horizon.Column.push_back({ column % size[0], column / size[0] });
      horizon.RealZ.push_back(found[std::size_t(column)]);
    }
  }
  return horizon;
}
}

#endif
