// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The layer between the two horizons of Penobscot, where these are at hand: one plan for both against a mesh of each,
// and its volume against that over blocks of columns.

#include "Filters/Algorithms/Surface/Surface.h"
#include "LayerChecker.h"
#include "Tools/Check.h"
#include "Tools/RealHorizons.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>

using namespace SeismicHorizons;
using LayerChecker::Horizon;

namespace
{
constexpr int Skipped = 77;

/// Times in samples of 4 ms. Horizon B begins nine columns and three rows after the sea bed.
std::vector<Horizon> Read()
{
  std::vector<Horizon> horizons(2);
  for (const std::filesystem::path& file : RealHorizons::Files())
  {
    const bool isSeaBed = file.filename() == "seabed.ijz";
    if (isSeaBed || file.filename() == "horizon_b.ijz")
    {
      Horizon& horizon = horizons[isSeaBed ? 0 : 1];
      horizon.Columns = RealHorizons::Read(file, &horizon.Heights);
      for (std::size_t n = 0; n < horizon.Columns.size(); ++n)
      {
        horizon.Heights[n] /= 4.0;
        horizon.Columns[n].X += isSeaBed ? 0 : 9;
        horizon.Columns[n].Y += isSeaBed ? 0 : 3;
      }
    }
  }
  return horizons;
}

std::size_t SeparateVertices(const OrderedStack& stack, std::size_t horizon, const LayerOptions& layers)
{
  SurfaceOptions options;
  options.MaximumError = layers.MaximumError;
  options.OutlineTolerance = layers.OutlineTolerance;
  options.SmallestAngle = layers.SmallestAngle;
  return MakeSurface({ stack.Columns, stack.Heights[horizon] }, options).Mesh.Points.Source.size();
}

void TestError(const std::vector<Horizon>& horizons, double error, double tolerance, double volumeError)
{
  LayerOptions options;
  options.MaximumError = error;
  options.OutlineTolerance = tolerance;
  options.SmallestAngle = 2.0;
  options.Crossings.HeightsGrowDownwards = true;
  const Layers layers = MakeLayers(LayerChecker::ViewsOf(horizons), options);
  LayerChecker::Checker checker(horizons, layers, options);
  CHECK_EQUAL(layers.Stack.Columns.size() - layers.Stack.Completed, std::size_t(240039));
  CHECK_EQUAL(checker.Check(), std::string());
  const std::size_t one = SeparateVertices(layers.Stack, 0, options);
  const std::size_t other = SeparateVertices(layers.Stack, 1, options);
  const auto shared = double(layers.Plan.Columns.size());
  const double volume = MeasureLayer(layers.Plan, 0).Volume / checker.LatticeVolume(0)[0] - 1.0;
  std::cout << "error " << error << ": " << shared << " vertices, " << one << " and " << other
            << " in meshes of their own; volume off by " << 100.0 * volume << " %\n";
  CHECK(shared <= 0.85 * double(one + other));
  CHECK(shared <= 1.3 * double(std::max(one, other)));
  CHECK(std::abs(volume) <= volumeError);
}
}

int TestRealLayers(int, char*[])
{
  const std::vector<Horizon> horizons = Read();
  if (horizons[0].Columns.empty() || horizons[1].Columns.empty())
  {
    return Skipped;
  }
  TestError(horizons, 0.75, 0.75, 5e-4);
  TestError(horizons, 1.0, 1.0, 5e-4);
  TestError(horizons, 1.0, 0.0, 1e-4);
  return Check::Result();
}
