// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SealingModels.h"

#include "Common/Horizon/Predicates.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace SeismicHorizons
{
using namespace ModelParts;

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

/// Once all faults are there.
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

SealingFault& AddFault(TrueModel& model, FaultPicks picks, FaultDistance distance)
{
  picks.Name = "F" + std::to_string(model.Input.Faults.size() + 1);
  model.Distances.push_back(std::move(distance));
  return model.Input.Faults.emplace_back(SealingFault{ FaultPlate(picks), {}, {}, {} });
}

void AddListric(TrueModel& model)
{
  const auto listricAt = [](double z) // 65 degrees at the top, 27 at the base
  {
    const double part = (-700.0 - z) / 1200.0, bent = std::clamp(part, -1.0, 3.0);
    return 500.0 + 550.0 * part + 600.0 * bent * bent * bent;
  };
  FaultPicks picks;
  picks.Spacing = 260.0;
  AddSticks(picks, 5, 20,
    [&](int stick, int n)
    {
      const double z = -1300.0 - 40.0 * n;
      return Eigen::Vector3d(listricAt(z), 0.5 * Length + 260.0 * stick, z);
    });
  AddFault(model, picks, [=](const Eigen::Vector3d& place) { return place.x() - listricAt(place.z()); });
}

/// A plane through (X, 1000, -1200).
struct DesignedFault
{
  double X;
  double Dip;
  double Strike;
  std::vector<double> Throws; // by horizon
  std::vector<FaultSideOf> Region = {};
  std::optional<TipEllipse> Tips = {};
};

struct Design
{
  std::string Name;
  std::vector<DesignedFault> Faults;
};

/// In an X the fault on the other side is not quite opposite.
const std::vector<Design> Designs = {
  { "flat", { { 900.0, 60.0, 0.0, { 90.0, 90.0, 90.0 } } } },
  { "straight", { { 900.0, 60.0, 0.0, { 90.0, 90.0, 90.0 } } } },
  { "steep", { { 900.0, 80.0, 0.0, { 90.0, 90.0, 90.0 } } } },
  { "vertical", { { 900.0, 90.0, 0.0, { 90.0, 90.0, 90.0 } } } },
  { "strike", { { 900.0, 60.0, 25.0, { 90.0, 90.0, 90.0 } } } },
  { "reverse", { { 900.0, 60.0, 0.0, { -90.0, -90.0, -90.0 } } } },
  { "growth", { { 900.0, 60.0, 0.0, { 40.0, 90.0, 160.0 } } } },
  { "scissors", { { 900.0, 60.0, 0.0, { 90.0, 90.0, 90.0 } } } },
  { "half", { { 900.0, 60.0, 0.0, { 90.0, 90.0, 90.0 } } } },
  { "listric", {} },
  { "thin", { { 900.0, 60.0, 0.0, { 100.0, 100.0, 100.0, 100.0, 100.0, 100.0 } } } },
  { "noise", { { 900.0, 60.0, 0.0, { 90.0, 90.0, 90.0 } } } },
  { "tip", { { 900.0, 60.0, 0.0, { 90.0, 90.0, 90.0 }, {}, TipEllipse() } } },
  { "tipreverse", { { 900.0, 60.0, 0.0, { -90.0, -90.0, -90.0 }, {}, TipEllipse() } } },
  { "tipwall",
    { { 900.0, 60.0, 0.0, { 90.0, 90.0, 90.0 }, {},
      TipEllipse{ { 900.0, 0.0, -1200.0 }, Eigen::Vector2d::UnitY(), 1100.0, 450.0 } } } },
  { "outline", { { 900.0, 60.0, 25.0, { 90.0, 90.0, 90.0 } } } },
  { "unconformity", { { 900.0, 60.0, 0.0, { 0.0, 80.0, 80.0 } } } },
  { "Y",
    { { 700.0, 60.0, 0.0, { 120.0, 120.0, 120.0 } }, { 1200.0, 60.0, 180.0, { 60.0, 60.0, 60.0 }, { { 0, true } } } } },
  { "Yoblique",
    { { 700.0, 60.0, 0.0, { 120.0, 120.0, 120.0 } }, { 1200.0, 60.0, 160.0, { 60.0, 60.0, 60.0 }, { { 0, true } } } } },
  { "X",
    { { 700.0, 60.0, 0.0, { 120.0, 120.0, 120.0 } }, { 1200.0, 60.0, 180.0, { 60.0, 60.0, 60.0 }, { { 0, true } } },
      { 1120.0, 60.0, 180.0, { 60.0, 60.0, 60.0 }, { { 0, false } } } } },
};

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

void AddPlane(TrueModel& model, const DesignedFault& plane, double noise, Random& random)
{
  const WavyFault shape({ plane.X, 0.5 * Length, -1200.0 }, plane.Dip, plane.Strike);
  FaultPicks picks;
  picks.Spacing = 320.0;
  AddSticks(picks, 5, 4,
    [&](int stick, int n)
    {
      const double off = noise > 0.0 ? random.Normal(noise) : 0.0;
      return Eigen::Vector3d(shape.OnPlane(320.0 * stick, -275.0 * n) + off * shape.Normal);
    });
  SealingFault& fault = AddFault(model, picks, [shape](const Eigen::Vector3d& place) { return shape.Distance(place); });
  fault.Region = plane.Region;
  if (plane.Tips)
  {
    fault.TipLoop = MakeTipLoop(fault.Plate, shape, *plane.Tips);
  }
}

WavyLayers MakeDesignedLayers(const Design& design)
{
  WavyLayers layers;
  layers.Depths = { -1000.0, -1200.0, -1450.0 };
  for (const DesignedFault& fault : design.Faults)
  {
    layers.Throws.push_back(fault.Throws);
    layers.Tips.push_back(fault.Tips);
  }
  if (design.Name == "flat")
  {
    layers.Amplitude = 0.0;
    layers.Slope = Eigen::Vector2d::Zero();
  }
  else if (design.Name == "listric")
  {
    layers.Throws = { { 130.0, 130.0, 130.0 } };
    layers.Fade = 700.0;
  }
  else if (design.Name == "thin")
  {
    layers.Amplitude = 15.0;
    layers.Depths = { -1000.0, -1030.0, -1060.0, -1090.0, -1120.0, -1150.0 };
  }
  layers.IsScissors = design.Name == "scissors";
  layers.IsHalf = design.Name == "half";
  return layers;
}

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
std::vector<std::string> DesignedModels()
{
  std::vector<std::string> names;
  for (const Design& design : Designs)
  {
    names.push_back(design.Name);
  }
  return names;
}

//----------------------------------------------------------------------------------------------------------------------
TrueModel MakeDesignedModel(const std::string& name)
{
  const auto design =
    std::find_if(Designs.begin(), Designs.end(), [&name](const Design& other) { return other.Name == name; });
  if (design == Designs.end())
  {
    throw std::invalid_argument("no model " + name);
  }
  Random random(7);
  TrueModel model = MakeBox(name, 81, -700.0, -1900.0);
  const bool isNoise = name == "noise";
  for (const DesignedFault& fault : design->Faults)
  {
    AddPlane(model, fault, isNoise ? 4.0 : 0.0, random);
  }
  if (name == "listric")
  {
    AddListric(model);
  }
  if (name == "unconformity")
  {
    model.Input.Faults[0].EndsBelow = 0;
  }
  if (name == "outline")
  {
    model.Input.Outline = { { 10, 5 }, { 5, 70 }, { 40, 75 }, { 45, 40 }, { 75, 35 }, { 70, 8 } };
  }
  model.Error = isNoise ? 6.0 : 1.0;
  AddHorizons(model, MakeDesignedLayers(*design), isNoise ? PickErrors{ 2.0, 40.0 } : PickErrors(), random);
  return model;
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
