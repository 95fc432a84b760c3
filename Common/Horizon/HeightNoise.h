// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The error within which a mesh passes over the noise of a horizon, where none is given.

#ifndef SeismicHorizonsHeightNoise_h
#define SeismicHorizonsHeightNoise_h

#include "Types.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
class ColumnIndex;

/// The value of a maximum error that stands for one that is chosen.
constexpr double AutomaticError = -1.0;

/// Heights scatter by this much around what a mesh can follow.
struct HeightNoise
{
  double Deviation = 0.0; // standard deviation, in the unit of the heights
  bool IsRounding = false; // steps of heights scatter more than their noise

  /// Few points of normal noise are farther off than three deviations, on both sides of the mesh.
  double MaximumError() const { return 6.0 * this->Deviation; }
};

/// Second differences give the noise along the rougher axis, as interpolated lines are smooth along the other. Rounding
/// is the least difference of neighbours, at most 1, over the root of 12.
HeightNoise MeasureHeightNoise(PlanePoints columns, const std::vector<double>& heights);

/// Measures the same of points that are added in parts, row by row, several times if neighbours are far apart.
class NoiseSampler
{
public:
  explicit NoiseSampler(std::size_t points);

  /// The points that are measured, from `first` to before `end`, need so many rows beside them.
  std::int32_t Rim() const { return std::max(this->AlongX.Stride, this->AlongY.Stride); }
  /// The points of the index are numbered from `before` on.
  void Add(const ColumnIndex& index, const std::vector<double>& heights, std::size_t before, std::size_t first,
    std::size_t end);
  /// Called after all points; returns false if they must be added again.
  bool Finish();
  HeightNoise Noise() const;

private:
  struct Differences
  {
    explicit Differences(PlanePoint axis)
      : Axis(axis)
    {
    }

    PlanePoint Axis;
    std::int32_t Stride = 1; // of the neighbours
    bool IsMeasured = false;
    std::vector<double> Second; // absolute values
    std::vector<double> Steps; // between neighbours
  };

  void Measure(const ColumnIndex& index, const std::vector<double>& heights, std::size_t before, std::size_t point,
    Differences& along) const;
  void Widen(Differences& along) const;
  double LeastStep(const Differences& along) const;

  std::vector<std::size_t> Sample; // ascending
  double LargestHeight = 0.0; // absolute value
  Differences AlongX{ PlanePoint{ 1, 0 } };
  Differences AlongY{ PlanePoint{ 0, 1 } };
};
}

#endif
