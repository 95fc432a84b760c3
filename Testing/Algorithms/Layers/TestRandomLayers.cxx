// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Random stacks, and all that must be true of their layers. Arguments beyond those of all tests are the first seed and
// how many there are.

#include "Common/Errors.h"
#include "DomainChecker.h"
#include "LayerChecker.h"
#include "RandomStacks.h"
#include "Tools/Check.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string>

using namespace SeismicHorizons;

namespace
{
/// What became of random stacks, so that a generator which makes nothing of interest is seen.
struct Tally
{
  int Empty = 0;
  int Pinched = 0;
  int Whole = 0;
  int Crossed = 0;
  int Parts = 0; // layers that are not all over the plan
  int Conflicts = 0;
  std::size_t Lines = 0;
  std::size_t LeftOut = 0;
  int Faulted = 0; // plans with cracks
  int Completed = 0; // stacks with gaps in some horizons
};

/// The same stack, each layer in a domain of its own.
std::string TryDomains(RandomStacks::Stack stack, Tally& tally)
{
  stack.Options.Domain = LayerDomain::EachLayer;
  stack.Options.OutlineTolerance = 0.0;
  stack.Options.Radius = 1;
  stack.Options.SmallestHoleSize = 1;
  const Layers layers = MakeLayers(LayerChecker::ViewsOf(stack.Horizons), stack.Options);
  LayerChecker::DomainChecker checker(stack.Horizons, layers, stack.Options);
  const std::string wrong = checker.CheckDomains();
  tally.Conflicts += checker.NumberOfConflicts();
  for (std::size_t layer = 0; layer < layers.Plan.IsIn.size(); ++layer)
  {
    const std::vector<unsigned char>& isIn = layers.Plan.IsIn[layer];
    tally.Parts += std::count(isIn.begin(), isIn.end(), 0) > 0 && std::count(isIn.begin(), isIn.end(), 1) > 0 ? 1 : 0;
  }
  return wrong.empty() ? wrong : "domains: " + wrong;
}

std::string Try(unsigned seed, Tally& tally)
{
  const RandomStacks::Stack stack = RandomStacks::Generator(seed).Run();
  const std::vector<HorizonView> views = LayerChecker::ViewsOf(stack.Horizons);
  const std::string ofDomains = FindColumnsOfLayers(views).Columns.empty() ? "" : TryDomains(stack, tally);
  if (!ofDomains.empty())
  {
    return ofDomains;
  }
  if (FindCommonColumns(views).Columns.empty())
  {
    ++tally.Empty;
    return "";
  }
  const Layers layers = MakeLayers(views, stack.Options);
  LayerChecker::Checker checker(stack.Horizons, layers, stack.Options);
  std::string wrong = checker.Check();
  const bool areGapsOpen = *stack.Options.Radius == 1 && *stack.Options.SmallestHoleSize == 1;
  tally.Completed += layers.Stack.Completed > 0 ? 1 : 0;
  if (wrong.empty() && *stack.Options.OutlineTolerance == 0.0 && areGapsOpen)
  {
    ++tally.Whole;
    wrong = checker.CheckLattice();
  }
  tally.Faulted += layers.Plan.FaultTriangles.empty() ? 0 : 1;
  tally.Lines += layers.PinchOutLines;
  tally.LeftOut += layers.LinesLeftOut;
  for (std::size_t layer = 0; layer < layers.Plan.NumberOfLayers(); ++layer)
  {
    const auto triangles = MeasureLayer(layers.Plan, layer).Triangles;
    tally.Pinched += triangles[0] > 0 && triangles[1] > 0 && triangles[2] > 0 && triangles[3] > 0 ? 1 : 0;
    tally.Crossed += layers.Stack.Repair.Interfaces[layer].Columns > 0 ? 1 : 0;
  }
  return wrong;
}
}

int TestRandomLayers(int argc, char* argv[])
{
  const unsigned first = argc > 3 ? unsigned(std::atoi(argv[3])) : 1;
  const unsigned count = argc > 4 ? unsigned(std::atoi(argv[4])) : 300;
  Tally tally;
  for (unsigned seed = first; seed < first + count; ++seed)
  {
    std::string wrong;
    try
    {
      wrong = Try(seed, tally);
    }
    catch (const std::exception& error)
    {
      wrong = std::string("throws ") + error.what();
    }
    if (!wrong.empty())
    {
      std::cerr << "seed " << seed << ": " << wrong << '\n';
    }
    CHECK(wrong.empty());
  }
  std::cout << tally.Empty << " empty, " << tally.Whole << " with whole outlines, " << tally.Pinched
            << " layers that pinch out, " << tally.Crossed << " crossed, " << tally.Lines
            << " pieces of pinch-out lines, without " << tally.LeftOut << ", " << tally.Parts
            << " layers in a part of the plan, " << tally.Faulted << " plans with cracks, " << tally.Completed
            << " with gaps, " << tally.Conflicts << " halves of blocks left out\n";
  CHECK(tally.Empty < int(count / 4));
  CHECK(tally.Whole > int(count / 6));
  CHECK(tally.Pinched > int(count / 6));
  CHECK(tally.Crossed > int(count / 3));
  CHECK(tally.Parts > int(count / 4) && tally.Conflicts > int(count / 10));
  CHECK(tally.Faulted > int(count / 8) && tally.Completed > int(count / 20));
  CHECK(tally.Lines > 10 * count && tally.LeftOut < tally.Lines / 2);
  return Check::Result();
}
