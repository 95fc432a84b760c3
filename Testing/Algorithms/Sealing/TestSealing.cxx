// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Sealed models against their true bodies, volumes and heights. They are written for the checker of
// Testing/Python/sealed_checker.py, which shares no code with what makes them.

#include "Filters/Algorithms/Sealing/SealedModel.h"

#include "SealingModels.h"
#include "Tools/Check.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <string>
#include <vector>

using namespace SeismicHorizons;

namespace
{
/// As the stage does: picks that do not agree are found first.
SealingInput WithCutoffs(const TrueModel& model)
{
  SealingInput input = model.Input;
  for (std::size_t n = 0; n < input.Horizons.size(); ++n)
  {
    SealingHorizon& horizon = input.Horizons[n];
    HorizonPicks picks;
    picks.Steps = input.Step.asDiagonal();
    picks.Noise = model.Name == "noise" ? 2.0 : 0.0;
    for (std::size_t pick = 0; pick < horizon.Columns.size(); ++pick)
    {
      const PlanePoint& column = horizon.Columns[pick];
      picks.Places.emplace_back(input.Step.x() * column.X, input.Step.y() * column.Y, horizon.Heights[pick]);
    }
    const auto cuts = [n](const SealingFault& fault) { return !fault.EndsBelow || *fault.EndsBelow < n; };
    std::vector<const FaultPlate*> cutting;
    for (const SealingFault& fault : input.Faults)
    {
      cutting.insert(cutting.end(), cuts(fault) ? 1 : 0, &fault.Plate);
    }
    for (const SealingFault& fault : input.Faults) // Plates of random faults are there beyond tips, too.
    {
      horizon.AtFault.push_back(cuts(fault) && fault.TipLoop.empty()
          ? FindCutoffs(fault.Plate, cutting, picks, CutoffFitOptions(), 5.0)
          : HorizonCutoffs());
    }
  }
  return input;
}

void WriteModel(const TrueModel& truth, const SealedModel& model, const std::vector<double>& volumes)
{
  const std::filesystem::path folder = "sealed";
  std::filesystem::create_directories(folder);
  std::ofstream file(folder / (truth.Name + ".txt"));
  file.precision(17);
  const SealingInput& input = truth.Input;
  file << "sealed 1\nbox " << input.Step.x() * input.Least.X << ' ' << input.Step.y() * input.Least.Y << ' '
       << input.Base << ' ' << input.Step.x() * input.Greatest.X << ' ' << input.Step.y() * input.Greatest.Y << ' '
       << input.Top << "\noutline " << input.Corners().size() << '\n';
  for (const Eigen::Vector2d& corner : input.Corners())
  {
    file << corner.x() << ' ' << corner.y() << '\n';
  }
  file << "surfaces " << model.Surfaces.size() << '\n';
  for (const SealedSurface& surface : model.Surfaces)
  {
    file << int(surface.Type) << ' ' << surface.Name << '\n';
  }
  file << "bodies " << model.Bodies.size() << '\n';
  for (const SealedBody& body : model.Bodies)
  {
    file << body.Layer << ' ' << body.Block << ' ' << body.Volume << '\n';
  }
  file << "vertices " << model.Vertices.size() << '\n';
  for (const Eigen::Vector3d& vertex : model.Vertices)
  {
    file << vertex.x() << ' ' << vertex.y() << ' ' << vertex.z() << '\n';
  }
  file << "triangles " << model.Triangles.size() << '\n';
  for (const SealedTriangle& triangle : model.Triangles)
  {
    file << triangle.Corners[0] << ' ' << triangle.Corners[1] << ' ' << triangle.Corners[2] << ' ' << triangle.Surface
         << ' ' << triangle.Body[0] << ' ' << triangle.Body[1] << '\n';
  }
  file << "guessed " << model.Guessed.size() + truth.Eroded + truth.Input.Outline.size() << "\ntruth " << volumes.size()
       << '\n';
  for (const double volume : volumes)
  {
    file << volume << '\n';
  }
}

/// The root mean square of how far points of horizons at faults are from the true horizon of the nearest block.
double MeasureCutoffHeights(const TrueModel& truth, const SealedModel& model)
{
  std::vector<unsigned char> areAtFault(model.Vertices.size(), 0);
  std::map<std::int32_t, std::size_t> horizons; // by vertex
  for (const SealedTriangle& triangle : model.Triangles)
  {
    const SealedSurfaceType type = model.Surfaces[std::size_t(triangle.Surface)].Type;
    for (const std::int32_t corner : triangle.Corners)
    {
      areAtFault[std::size_t(corner)] |= type == SealedSurfaceType::Fault ? 1 : 0;
      if (type == SealedSurfaceType::Horizon)
      {
        horizons[corner] = std::size_t(triangle.Surface);
      }
    }
  }
  double sum = 0.0, count = 0.0;
  for (const auto& [number, horizon] : horizons)
  {
    const Eigen::Vector3d& vertex = model.Vertices[std::size_t(number)];
    double off = 1e300;
    for (const std::vector<signed char>& block : model.Blocks)
    {
      const std::vector<int> sides(block.begin(), block.end());
      off = std::min(off, std::abs(truth.Height(horizon, sides, vertex.x(), vertex.y()) - vertex.z()));
    }
    sum += areAtFault[std::size_t(number)] != 0 ? off * off : 0.0;
    count += areAtFault[std::size_t(number)] != 0 ? 1.0 : 0.0;
  }
  return std::sqrt(sum / std::max(count, 1.0));
}

struct Sealed
{
  SealedModel Model;
  double Off = 0.0; // of the volume of a layer, the largest part
  double Cutoffs = 0.0;
};

Sealed Seal(const TrueModel& truth)
{
  Sealed sealed;
  SealingOptions options;
  options.MaximumError = options.FaultError = truth.Error;
  sealed.Model = SealModel(WithCutoffs(truth), options);
  const SealingInput& input = truth.Input;
  const std::vector<double> volumes = TrueVolumes(truth, 200, 16);
  std::vector<double> found(volumes.size(), 0.0);
  double sum = 0.0;
  for (const SealedBody& body : sealed.Model.Bodies)
  {
    found[body.Layer] += body.Volume;
    sum += body.Volume;
  }
  for (std::size_t layer = 0; layer < volumes.size(); ++layer)
  {
    sealed.Off = std::max(sealed.Off, std::abs(found[layer] / volumes[layer] - 1.0));
  }
  const double box = AreaInWalls(truth) * (input.Top - input.Base);
  CHECK(std::abs(sum / box - 1.0) < 1e-12);
  CHECK(sealed.Model.LargestError <= truth.Error);
  sealed.Cutoffs = MeasureCutoffHeights(truth, sealed.Model);
  WriteModel(truth, sealed.Model, volumes);
  std::cout << truth.Name << ": " << input.Faults.size() << " faults, " << sealed.Model.Bodies.size() << " bodies, "
            << sealed.Model.Vertices.size() << " points, " << sealed.Model.Triangles.size() << " triangles, layers "
            << 100.0 * sealed.Off << " %, error " << sealed.Model.LargestError << ", cutoffs " << sealed.Cutoffs
            << ", least angle " << sealed.Model.LeastAngle << "\n";
  return sealed;
}

/// What one fault makes of three horizons is 8 bodies, and 4 if it dies out.
void TestDesigned()
{
  const std::map<std::string, std::size_t> bodies = { { "scissors", 8 }, { "half", 8 }, { "thin", 14 }, { "tip", 4 },
    { "tipreverse", 4 }, { "tipwall", 4 }, { "unconformity", 7 }, { "Y", 13 }, { "Yoblique", 12 }, { "X", 14 } };
  const std::map<std::string, double> cutoffs = { { "half", 0.4 }, { "tip", 1.0 }, { "tipreverse", 1.0 },
    { "tipwall", 0.4 }, { "listric", 3.5 }, { "noise", 4.0 }, { "Y", 2.0 }, { "X", 2.0 } };
  for (const std::string& name : DesignedModels())
  {
    const Sealed sealed = Seal(MakeDesignedModel(name));
    const auto count = bodies.find(name);
    const auto most = cutoffs.find(name);
    CHECK_EQUAL(sealed.Model.Bodies.size(), count != bodies.end() ? count->second : std::size_t(8));
    CHECK(sealed.Off < (name == "thin" ? 0.003 : 0.001));
    CHECK(sealed.Model.BeyondTips.empty() || name == "tipreverse");
    CHECK(sealed.Cutoffs < (most != cutoffs.end() ? most->second : 0.3));
  }
}

/// Volumes are only judged where each block has picks of each horizon, up to its faults.
void TestNetworks()
{
  constexpr unsigned first = 1, last = 31;
  for (unsigned seed = first; seed < last; ++seed)
  {
    if (const std::optional<TrueModel> truth = MakeRandomNetwork(seed, 8))
    {
      const Sealed sealed = Seal(*truth);
      const double most =
        truth->Input.Outline.empty() ? 0.01 : 0.05; // Outlines may be around a small part of the picks.
      CHECK(!sealed.Model.Guessed.empty() || truth->Eroded > 0 || sealed.Off < most);
    }
  }
}

/// The same bytes each time, on any number of threads.
void TestRepeated()
{
  const TrueModel truth = MakeDesignedModel("Yoblique");
  const SealedModel one = SealModel(truth.Input), two = SealModel(truth.Input);
  CHECK(one.Vertices == two.Vertices);
  CHECK(std::equal(one.Triangles.begin(), one.Triangles.end(), two.Triangles.begin(), two.Triangles.end(),
    [](const SealedTriangle& a, const SealedTriangle& b) { return a.Corners == b.Corners && a.Body == b.Body; }));
}

void TestRefused()
{
  TrueModel truth = MakeDesignedModel("flat");
  truth.Input.Horizons[1].Columns.clear();
  truth.Input.Horizons[1].Heights.clear();
  CHECK_THROWS_WITH(SealModel(truth.Input), "horizon H2 without 6 picks in any block, expected more");
  int calls = 0;
  const Monitor stop([&calls](double) { return ++calls < 3; });
  CHECK_THROWS_WITH(SealModel(MakeDesignedModel("flat").Input, SealingOptions(), stop), "stopped on request");
}
}

int TestSealing(int, char*[])
{
  TestDesigned();
  TestNetworks();
  TestRepeated();
  TestRefused();
  return Check::Result();
}
