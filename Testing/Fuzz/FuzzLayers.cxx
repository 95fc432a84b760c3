// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// An input is a stack of horizons on a small lattice, with cuts and options. All that checkers of layers ask must be
// true of what is made, in both domains.

#include "Layers/DomainChecker.h"
#include "Layers/LayerChecker.h"
#include "Require.h"
#include "StageInput.h"

#include <cmath>
#include <cstdint>

using namespace Fuzz;
using namespace SeismicHorizons;

namespace
{
struct Stack
{
  std::vector<LayerChecker::Horizon> Horizons;
  std::optional<LinkCuts> Cuts;
  LayerOptions Options;
};

double Choose(ByteSource& bytes, const std::vector<double>& values)
{
  return values[bytes.TakeNumber(values.size() - 1)];
}

void TakeOptions(ByteSource& bytes, std::size_t horizons, LayerOptions& options)
{
  options.MaximumError = Choose(bytes, { 0.75, 0.0, 0.3, 2.0 });
  options.OutlineTolerance = Choose(bytes, { 0.0, 0.75, 1.5 });
  options.Radius = 1 + int(bytes.TakeNumber(2));
  options.SmallestHoleSize = 1 + std::int64_t(bytes.TakeNumber(8));
  options.FitHeights = bytes.TakeNumber(1) == 0;
  options.Effort = bytes.TakeNumber(1) == 0 ? DecimationEffort::Best : DecimationEffort::Fast;
  options.SmallestAngle = Choose(bytes, { 10.0, 0.0, 30.0, 60.0 });
  options.BoundThickness = bytes.TakeNumber(1) == 1;
  options.PinchOutLines = bytes.TakeNumber(1) == 0;
  options.SmallestPinch = 1 + std::int64_t(bytes.TakeNumber(8));
  options.Crossings.HeightsGrowDownwards = bytes.TakeNumber(1) == 1;
  options.Crossings.MinimumThickness = Choose(bytes, { 0.0, 0.5 });
  options.Crossings.Policies.clear();
  for (std::size_t layer = 0; layer + 1 < horizons; ++layer)
  {
    options.Crossings.Policies.push_back(static_cast<CrossingPolicy>(bytes.TakeNumber(2)));
  }
}

/// A byte for each column of each horizon, 255 for none, then one for the cuts of each.
void TakeStack(ByteSource& bytes, Stack& stack)
{
  stack.Horizons.resize(2 + std::size_t(bytes.TakeNumber(2)));
  const auto width = std::int32_t(2 + bytes.TakeNumber(14));
  const auto height = std::int32_t(2 + bytes.TakeNumber(14));
  TakeOptions(bytes, stack.Horizons.size(), stack.Options);
  const bool hasCuts = bytes.TakeNumber(3) == 0;
  for (LayerChecker::Horizon& horizon : stack.Horizons)
  {
    const std::vector<unsigned char> contents = bytes.TakeContents(std::size_t(width * height));
    for (std::size_t n = 0; n < contents.size(); ++n)
    {
      if (contents[n] != 255)
      {
        horizon.Columns.push_back({ std::int32_t(n) % width - 2, std::int32_t(n) / width + 1 });
        horizon.Heights.push_back(0.25 * contents[n]);
      }
    }
  }
  if (!hasCuts)
  {
    return;
  }
  PlaneBox box;
  box.Add({ -2, 1 });
  box.Add({ width - 3, height });
  stack.Cuts.emplace(box);
  const std::vector<unsigned char> cuts = bytes.TakeContents(std::size_t(width * height));
  for (std::size_t n = 0; n < cuts.size(); ++n)
  {
    const PlanePoint column = { std::int32_t(n) % width - 2, std::int32_t(n) / width + 1 };
    if ((cuts[n] & 7) == 7)
    {
      stack.Cuts->CutEast(column);
    }
    if ((cuts[n] & 56) == 56)
    {
      stack.Cuts->CutNorth(column);
    }
  }
  stack.Options.Cuts = &*stack.Cuts;
}

void TryCommon(const Stack& stack, const std::vector<HorizonView>& views)
{
  const auto layers = RunOn(!FindStackColumns(views, views.size()).Columns.empty(), "MakeLayers",
    [&]() { return MakeLayers(views, stack.Options); });
  if (!layers)
  {
    return;
  }
  LayerChecker::Checker checker(stack.Horizons, *layers, stack.Options);
  RequireNothing(checker.Check(), "layers");
  const bool areGapsOpen = *stack.Options.Radius == 1 && *stack.Options.SmallestHoleSize == 1;
  if (*stack.Options.OutlineTolerance == 0.0 && areGapsOpen)
  {
    RequireNothing(checker.CheckLattice(), "lattice");
  }
}

void TryDomains(Stack& stack, const std::vector<HorizonView>& views)
{
  stack.Options.Domain = LayerDomain::EachLayer;
  stack.Options.OutlineTolerance = 0.0;
  stack.Options.Radius = 1;
  stack.Options.SmallestHoleSize = 1;
  const auto layers = RunOn(!FindStackColumns(views, 2).Columns.empty(), "MakeLayers, each",
    [&]() { return MakeLayers(views, stack.Options); });
  if (layers)
  {
    RequireNothing(LayerChecker::DomainChecker(stack.Horizons, *layers, stack.Options).CheckDomains(), "domains");
  }
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  ByteSource bytes(data, size);
  Stack stack;
  TakeStack(bytes, stack);
  const std::vector<HorizonView> views = LayerChecker::ViewsOf(stack.Horizons);
  TryCommon(stack, views);
  TryDomains(stack, views);
  return 0;
}
