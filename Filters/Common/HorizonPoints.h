// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsHorizonPoints_h
#define SeismicHorizonsHorizonPoints_h

#include "Common/Horizon/Horizon.h"
#include "Common/Horizon/KeptPoints.h"

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace SeismicHorizons
{
/// The field data for an output without triangles, or with different ones.
ArrayTable WithoutMeshFigures(ArrayTable figures);

/// The array vtkGhostType hides points or marks them as copies from another process.
std::int64_t CountVisiblePoints(const Horizon& horizon);

/// Returns the horizon itself, or, if points are hidden, its visible points without cells.
Horizon WithoutHiddenPoints(const Horizon& horizon);

/// Each point gets a vertex cell. If all points are kept, the arrays are shared.
void CopyPoints(const Horizon& input, const KeptPoints& kept, Horizon& output);

/// Throws InputError unless heights, in lattice units, rise with the vertical index: Transform moves points, but not
/// the lattice in the field data.
void CheckHeights(const Horizon& horizon, const std::function<double(std::int64_t)>& height);

/// Checks the same for points that are added in parts, in their order.
class HeightCheck
{
public:
  /// of all parts
  explicit HeightCheck(std::int64_t points)
    : Step(points / EnoughPoints + 1)
  {
  }

  /// Adds the points from number `first` to before `end`, which are numbered from `before` on.
  void Add(const Horizon& horizon, const std::function<double(std::int64_t)>& height, std::int64_t before,
    std::int64_t first, std::int64_t end);
  /// Throws InputError.
  void Finish() const;

private:
  static constexpr std::int64_t EnoughPoints = 1000;

  std::int64_t Step;
  std::vector<Eigen::Vector2d> Sample; // vertical indices and heights
};

/// Fits y over x by least squares; empty unless the standard deviation of x exceeds the least one.
std::optional<double> FitSlope(const std::vector<Eigen::Vector2d>& pairs, double leastDeviation);

/// ParaView colours by the active scalars.
void ActivateHeight(Horizon& horizon);
}

#endif
