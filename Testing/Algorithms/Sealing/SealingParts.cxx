// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SealingModels.h"

#include <cmath>
#include <utility>

namespace SeismicHorizons
{
namespace ModelParts
{
namespace
{
/// Above an unconformity a lower horizon is eroded.
bool IsEroded(const TrueModel& model, std::size_t horizon, const Eigen::Vector3d& place)
{
  for (std::size_t upper = 0; upper < horizon; ++upper)
  {
    if (!IsBelow(model, upper, place))
    {
      return true;
    }
  }
  return false;
}

/// On a fault there are no picks.
std::vector<double> PickColumn(TrueModel& model, const std::vector<std::vector<int>>& blocks, std::size_t horizon,
  const Eigen::Vector2d& column, const PickErrors& errors, Random& random)
{
  std::vector<double> heights;
  for (const std::vector<int>& sides : blocks)
  {
    const double height = model.Height(horizon, sides, column.x(), column.y());
    const Eigen::Vector3d place(column.x(), column.y(), height);
    const double inside = DistanceInside(model, sides, place);
    const bool isIn = inside > 0.0 && SidesOn(model, horizon, place) == sides;
    if (isIn && IsEroded(model, horizon, place))
    {
      ++model.Eroded;
    }
    else if (isIn || (inside <= 0.0 && inside > -errors.WrongSide && random.Fraction() < 0.5))
    {
      heights.push_back(height);
    }
  }
  if (errors.WrongSide > 0.0 && !heights.empty()) // one per column, as of tracked horizons
  {
    heights = { heights[random.Below(heights.size())] };
  }
  for (double& height : heights)
  {
    height += errors.Noise > 0.0 ? random.Normal(errors.Noise) : 0.0;
  }
  return heights;
}
}

//----------------------------------------------------------------------------------------------------------------------
void AddHorizons(TrueModel& model, const WavyLayers& layers, const PickErrors& errors, Random& random)
{
  model.Height = [layers](std::size_t n, const std::vector<int>& sides, double x, double y)
  { return layers.Height(n, sides, x, y); };
  SealingInput& input = model.Input;
  const std::vector<std::vector<int>> blocks = BlocksOf(input.Faults);
  for (std::size_t n = 0; n < layers.Depths.size(); ++n)
  {
    SealingHorizon horizon;
    horizon.Name = "H" + std::to_string(n + 1);
    for (PlanePoint column = input.Least; column.Y <= input.Greatest.Y; ++column.Y)
    {
      for (column.X = input.Least.X; column.X <= input.Greatest.X; ++column.X)
      {
        const Eigen::Vector2d place = Eigen::Vector2d(column.X, column.Y).cwiseProduct(input.Step);
        for (const double height : PickColumn(model, blocks, n, place, errors, random))
        {
          horizon.Columns.push_back(column);
          horizon.Heights.push_back(height);
        }
      }
    }
    input.Horizons.push_back(std::move(horizon));
  }
}

//----------------------------------------------------------------------------------------------------------------------
SealingFault& AddFault(TrueModel& model, FaultPicks picks, FaultDistance distance)
{
  picks.Name = "F" + std::to_string(model.Input.Faults.size() + 1);
  model.Distances.push_back(std::move(distance));
  return model.Input.Faults.emplace_back(SealingFault{ FaultPlate(picks), {}, {}, {} });
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<Eigen::Vector2d> MakeTipLoop(const FaultPlate& plate, const WavyFault& shape, const TipEllipse& tips)
{
  std::vector<Eigen::Vector2d> loop;
  constexpr int corners = 32;
  for (int n = 0; n < corners; ++n)
  {
    const double angle = 2.0 * Pi * (n + 0.3) / corners;
    const double z = tips.Middle.z() + tips.HalfHeight * std::sin(angle);
    const Eigen::Vector2d along = tips.HalfLength * std::cos(angle) * tips.Along;
    const double s = (tips.Middle.head<2>() + along - shape.Origin.head<2>()).dot(shape.Along.head<2>());
    const FaultPlace place = plate.ToPlace(shape.OnPlane(s, (z - shape.Origin.z()) / shape.Up.z()));
    loop.emplace_back(place.S, place.Z);
  }
  return loop;
}
}
}
