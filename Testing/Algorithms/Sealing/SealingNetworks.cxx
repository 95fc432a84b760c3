// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SealingModels.h"

#include "Common/Horizon/Predicates.h"

#include <algorithm>
#include <cmath>

namespace SeismicHorizons
{
using namespace ModelParts;

namespace
{
/// Away from other faults, also where they are not in the model. Nothing if there is no room.
std::optional<Eigen::Vector3d> FindSeedPoint(const TrueModel& model, Random& random)
{
  for (int tries = 0; tries < 200; ++tries)
  {
    const double x = random.Between(300.0, 1700.0), y = random.Between(300.0, 1700.0);
    const Eigen::Vector3d place(x, y, random.Between(-1700.0, -900.0));
    if (std::all_of(model.Distances.begin(), model.Distances.end(),
          [&place](const FaultDistance& distance) { return std::abs(distance(place)) > 150.0; }))
    {
      return place;
    }
  }
  return std::nullopt;
}

/// In the block in which its seed point lies. Picks are a grid in and around the box.
std::optional<WavyFault> AddRandomFault(TrueModel& model, Random& random)
{
  const std::optional<Eigen::Vector3d> seed = FindSeedPoint(model, random);
  if (!seed)
  {
    return std::nullopt;
  }
  const std::vector<int> sides = SidesAt(model, *seed);
  const double dip = random.Between(35.0, 85.0);
  WavyFault shape(*seed, dip, random.Between(0.0, 360.0));
  shape.Amplitude = random.Between(0.0, 40.0);
  shape.WaveLength = random.Between(250.0, 600.0);
  constexpr double step = 100.0, margin = 300.0;
  FaultPicks picks;
  picks.Spacing = step;
  const Eigen::AlignedBox3d box(Eigen::Vector3d(-margin, -margin, model.Input.Base - margin),
    Eigen::Vector3d(Length + margin, Length + margin, model.Input.Top + margin));
  AddSticks(picks, 30, 22,
    [&](int stick, int n) -> std::optional<Eigen::Vector3d>
    {
      const double s = step * stick, t = -step * n;
      const Eigen::Vector3d place = shape.OnPlane(s, t);
      return box.contains(place) ? std::optional<Eigen::Vector3d>(place + shape.Wave(s, t) * shape.Normal)
                                 : std::nullopt;
    });
  SealingFault& fault = AddFault(model, picks, [shape](const Eigen::Vector3d& at) { return shape.Distance(at); });
  for (std::size_t n = 0; n < sides.size(); ++n)
  {
    if (sides[n] != 0)
    {
      fault.Region.push_back({ n, sides[n] > 0 });
    }
  }
  return shape;
}

/// 1 to 4 horizons at least 60 apart; 1 in 4 faults is reverse.
WavyLayers MakeRandomLayers(std::size_t faults, Random& random)
{
  std::vector<double> depths(1 + random.Below(4));
  do
  {
    std::generate(depths.begin(), depths.end(), [&random] { return random.Between(-1600.0, -1000.0); });
    std::sort(depths.rbegin(), depths.rend());
  } while (std::adjacent_find(depths.begin(), depths.end(),
             [](double above, double below) { return above - below < 60.0; }) != depths.end());
  WavyLayers layers;
  layers.Depths = depths;
  for (std::size_t n = 0; n < faults; ++n)
  {
    const double size = random.Between(10.0, 140.0);
    layers.Throws.emplace_back(depths.size(), random.Below(4) == 0 ? -size : size);
  }
  layers.Amplitude = random.Between(5.0, 25.0);
  for (const int axis : { 0, 1 })
  {
    layers.WaveLength(axis) = random.Between(300.0, 700.0);
    layers.Slope(axis) = random.Between(-0.06, 0.06);
  }
  return layers;
}

/// Half of the faults that none ends at die out.
void AddTips(TrueModel& model, const std::vector<WavyFault>& shapes, WavyLayers& layers, Random& random)
{
  std::vector<SealingFault>& faults = model.Input.Faults;
  layers.Tips.resize(faults.size());
  for (std::size_t n = 0; n < faults.size(); ++n)
  {
    const bool isEnd = std::any_of(faults.begin(), faults.end(),
      [n](const SealingFault& other)
      {
        return std::any_of(
          other.Region.begin(), other.Region.end(), [n](const FaultSideOf& side) { return side.Fault == n; });
      });
    if (!isEnd && random.Below(2) == 0)
    {
      TipEllipse& tips = layers.Tips[n].emplace();
      tips.Middle = shapes[n].Origin;
      tips.Along = shapes[n].Along.head<2>();
      tips.HalfLength = random.Between(300.0, 1200.0);
      tips.HalfHeight = random.Between(200.0, 700.0);
      faults[n].TipLoop = MakeTipLoop(faults[n].Plate, shapes[n], tips);
    }
  }
}

/// In 1 of 4 networks walls are a star around the middle of the box.
void AddOutline(SealingInput& input, Random& random)
{
  if (random.Below(4) != 0)
  {
    return;
  }
  const std::size_t corners = 3 + random.Below(8);
  const double middle = 0.5 * input.Greatest.X;
  for (std::size_t n = 0; n < corners; ++n)
  {
    const double angle = -2.0 * Pi * (double(n) + random.Between(0.0, 0.7)) / double(corners);
    const double away = random.Between(0.4, 1.0) * middle;
    input.Outline.push_back({ std::int32_t(std::lround(middle + away * std::cos(angle))),
      std::int32_t(std::lround(middle + away * std::sin(angle))) });
  }
  for (std::size_t n = 0; n < corners; ++n)
  {
    const PlanePoint &a = input.Outline[n], &b = input.Outline[(n + 1) % corners],
                     &c = input.Outline[(n + 2) % corners];
    if (SignedArea(a, b, c) == 0)
    {
      input.Outline.clear();
      return;
    }
  }
}

/// In 1 of 3 networks one horizon is an unconformity, which half of the faults do not cut.
void AddUnconformity(TrueModel& model, WavyLayers& layers, Random& random)
{
  if (random.Below(3) != 0)
  {
    return;
  }
  const std::size_t horizon = random.Below(layers.Depths.size());
  for (std::size_t fault = 0; fault < model.Input.Faults.size(); ++fault)
  {
    if (random.Below(2) == 0)
    {
      model.Input.Faults[fault].EndsBelow = horizon;
      std::fill_n(layers.Throws[fault].begin(), horizon + 1, 0.0);
    }
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
std::optional<TrueModel> MakeRandomNetwork(unsigned seed, int mostFaults)
{
  Random random(seed);
  TrueModel model = MakeBox("random " + std::to_string(seed), 41, -640.0, -1960.0);
  model.Error = 2.0;
  const std::size_t faults = 1 + random.Below(std::size_t(mostFaults));
  std::vector<WavyFault> shapes;
  for (std::optional<WavyFault> shape; shapes.size() < faults && (shape = AddRandomFault(model, random));)
  {
    shapes.push_back(*shape);
  }
  WavyLayers layers = MakeRandomLayers(shapes.size(), random);
  AddUnconformity(model, layers, random);
  AddTips(model, shapes, layers, random);
  AddHorizons(model, layers, PickErrors(), random);
  AddOutline(model.Input, random);
  for (const SealingHorizon& horizon : model.Input.Horizons)
  {
    const auto [least, greatest] = std::minmax_element(horizon.Heights.begin(), horizon.Heights.end());
    if (horizon.Heights.empty() || *least <= model.Input.Base || *greatest >= model.Input.Top)
    {
      return std::nullopt;
    }
  }
  return model;
}
}
