// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SealingModels.h"

#include <algorithm>
#include <utility>

namespace SeismicHorizons
{
using namespace ModelParts;

namespace
{
/// Heights at which a column meets a fault.
void AddCrossings(
  const std::function<double(double)>& distance, const SealingInput& input, int levels, std::vector<double>& heights)
{
  const double step = (input.Top - input.Base) / levels;
  bool isBelow = distance(input.Base) > 0.0;
  for (int level = 0; level < levels; ++level)
  {
    double low = input.Base + level * step, high = low + step;
    const bool isAbove = distance(high) > 0.0;
    if (isAbove != isBelow)
    {
      while (high - low > 1e-6 * step)
      {
        const double middle = 0.5 * (low + high);
        ((distance(middle) > 0.0) == isBelow ? low : high) = middle;
      }
      heights.push_back(low);
    }
    isBelow = isAbove;
  }
}

/// Between heights of faults and of the horizons of all blocks, the layer is one.
void AddColumn(const TrueModel& model, const std::vector<std::vector<int>>& blocks, const Eigen::Vector2d& column,
  int levels, std::vector<double>& lengths)
{
  const SealingInput& input = model.Input;
  const auto at = [&column](double z) { return Eigen::Vector3d(column.x(), column.y(), z); };
  std::vector<double> heights = { input.Base, input.Top };
  for (const FaultDistance& distance : model.Distances)
  {
    AddCrossings([&](double z) { return distance(at(z)); }, input, levels, heights);
  }
  for (std::size_t horizon = 0; horizon < input.Horizons.size(); ++horizon)
  {
    for (const std::vector<int>& sides : blocks)
    {
      heights.push_back(std::clamp(model.Height(horizon, sides, column.x(), column.y()), input.Base, input.Top));
    }
  }
  std::sort(heights.begin(), heights.end());
  for (std::size_t n = 1; n < heights.size(); ++n)
  {
    const double length = heights[n] - heights[n - 1];
    if (length > 0.0)
    {
      lengths[FindTruePlace(model, at(heights[n - 1] + 0.5 * length)).Layer] += length;
    }
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
TruePlace FindTruePlace(const TrueModel& model, const Eigen::Vector3d& place)
{
  TruePlace result = { 0, SidesAt(model, place) };
  while (result.Layer < model.Input.Horizons.size() && IsBelow(model, result.Layer, place))
  {
    ++result.Layer;
  }
  return result;
}

//----------------------------------------------------------------------------------------------------------------------
double AreaInWalls(const TrueModel& model)
{
  const std::vector<Eigen::Vector2d> corners = model.Input.Corners();
  double area = 0.0;
  for (std::size_t n = 0; n < corners.size(); ++n)
  {
    const Eigen::Vector2d &a = corners[n], &b = corners[(n + 1) % corners.size()];
    area += 0.5 * (b.x() * a.y() - a.x() * b.y());
  }
  return area;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<double> TrueVolumes(const TrueModel& model, int columns, int levels)
{
  const SealingInput& input = model.Input;
  const std::vector<std::vector<int>> blocks = BlocksOf(input.Faults);
  const Eigen::Vector2d least = Eigen::Vector2d(input.Least.X, input.Least.Y).cwiseProduct(input.Step);
  const Eigen::Vector2d greatest = Eigen::Vector2d(input.Greatest.X, input.Greatest.Y).cwiseProduct(input.Step);
  const Eigen::Vector2d step = (greatest - least) / columns;
  std::vector<double> volumes(input.Horizons.size() + 1, 0.0);
  const std::vector<Eigen::Vector2d> corners = input.Corners();
  double inside = 0.0;
  for (int j = 0; j < columns; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      const Eigen::Vector2d column = least + step.cwiseProduct(Eigen::Vector2d(i + 0.5, j + 0.5));
      if (IsInside(corners, column))
      {
        AddColumn(model, blocks, column, levels, volumes);
        inside += 1.0;
      }
    }
  }
  for (double& volume : volumes)
  {
    volume *= AreaInWalls(model) / inside;
  }
  return volumes;
}
}
