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

}
