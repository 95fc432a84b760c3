// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Horizons with gaps, and the options of tests.

#ifndef SeismicHorizonsHoleFixtures_h
#define SeismicHorizonsHoleFixtures_h

#include "Filters/Algorithms/HoleFilling/HoleFilling.h"
#include "Tools/Patches.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace HoleFixtures
{
using namespace SeismicHorizons;
using Surface = std::function<double(double, double)>;

struct Horizon
{
  Patches::Columns Columns;
  std::vector<double> Heights;
};

inline Horizon OnSurface(const Patches::Columns& columns, const Surface& surface)
{
  Horizon horizon;
  horizon.Columns = columns;
  for (const PlanePoint& column : columns)
  {
    horizon.Heights.push_back(surface(column.X, column.Y));
  }
  return horizon;
}

/// A square of that size whose columns are missing where isHole(x, y) says so.
template <typename IsGap>
Patches::Columns Square(int size, IsGap&& isHole)
{
  Patches::Columns columns;
  for (std::int32_t y = 0; y < size; ++y)
  {
    for (std::int32_t x = 0; x < size; ++x)
    {
      if (!isHole(x, y))
      {
        columns.push_back({ x, y });
      }
    }
  }
  return columns;
}

inline HoleFillingOptions AllHoles(FillMethod method, double rimSmoothing = 0.0)
{
  HoleFillingOptions options;
  options.LargestHoleSize = std::int64_t(1) << 40;
  options.Method = method;
  options.RimSmoothing = rimSmoothing;
  return options;
}

inline FilledColumns Fill(const Horizon& horizon, const HoleFillingOptions& options, const LinkCuts* cuts = nullptr)
{
  return FillHoles(horizon.Columns, horizon.Heights, {}, options, cuts);
}

/// How far the filled heights are from a surface at most; infinite where they are not numbers.
inline double LargestError(const FilledColumns& filled, const Surface& surface)
{
  double largest = 0.0;
  for (std::size_t n = 0; n < filled.Column.size(); ++n)
  {
    const double error = std::abs(filled.Height[n] - surface(filled.Column[n].X, filled.Column[n].Y));
    largest = std::isfinite(error) ? std::max(largest, error) : HUGE_VAL;
  }
  return largest;
}
}

#endif
