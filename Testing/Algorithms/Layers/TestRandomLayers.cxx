// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Random stacks, and all that must be true of their layers. Arguments beyond those of all tests are the first seed and
// how many there are.

#include "Common/Base/Errors.h"
#include "Common/Horizon/ColumnIndex.h"
#include "DomainChecker.h"
#include "LayerChecker.h"
#include "RandomStacks.h"
#include "Tools/Check.h"

#include <algorithm>
#include <cmath>
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
  int Filled = 0; // stacks with heights that were put in
  int Followed = 0; // and with horizons that follow others
};

void GiveEachADomain(LayerOptions& options)
{
  options.Domain = LayerDomain::EachLayer;
  options.OutlineTolerance = 0.0;
  options.Radius = 1;
  options.SmallestHoleSize = 1;
}

/// The same stack, each layer in a domain of its own.
std::string TryDomains(RandomStacks::Stack stack, Tally& tally)
{
  GiveEachADomain(stack.Options);
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

/// All heights of a stack as horizons, with the points that are in no layer.
std::vector<LayerChecker::Horizon> HorizonsOf(const OrderedStack& stack, std::vector<LayerChecker::Horizon> horizons)
{
  for (std::size_t n = 0; n < horizons.size(); ++n)
  {
    LayerChecker::Horizon& own = horizons[n];
    const std::vector<PlanePoint> read = own.Columns;
    const ColumnIndex index(read);
    for (std::size_t column = 0; column < stack.Columns.size(); ++column)
    {
      const double height = stack.Heights[n][column];
      const PointId point = index.PointAt(stack.Columns[column]);
      if (!std::isnan(height) && point != NoPoint)
      {
        own.Heights[std::size_t(point)] = height;
      }
      else if (!std::isnan(height))
      {
        own.Columns.push_back(stack.Columns[column]);
        own.Heights.push_back(height);
      }
    }
  }
  return horizons;
}

std::string CompareLedgers(const Layers& layers, const std::vector<LayerChecker::Horizon>& horizons)
{
  for (std::size_t n = 0; n < horizons.size(); ++n)
  {
    const Ledger& own = layers.Ledgers.OfHorizons[n];
    const std::int64_t read = own[LedgerEntry::Known] + own[LedgerEntry::LeftOut];
    if (read != std::int64_t(horizons[n].Columns.size()) ||
      own[LedgerEntry::LeftOut] != layers.Ledgers.PointsOutside[n])
    {
      return "ledger of horizon " + std::to_string(n) + ": " + std::to_string(own[LedgerEntry::LeftOut]) +
        " left out, " + std::to_string(layers.Ledgers.PointsOutside[n]) + " outside";
    }
  }
  return "";
}

/// Where missing heights are put in, layers are those of horizons that have them.
std::string TryMissing(RandomStacks::Stack stack, Tally& tally)
{
  GiveEachADomain(stack.Options);
  stack.Options.Missing = { MissingPolicy::Follow, 20, 3 };
  const Layers layers = MakeLayers(LayerChecker::ViewsOf(stack.Horizons), stack.Options);
  for (const std::vector<HeightOrigin>& own : layers.Stack.Origins)
  {
    tally.Filled += std::count(own.begin(), own.end(), HeightOrigin::Filled) > 0 ? 1 : 0;
    tally.Followed += std::any_of(own.begin(), own.end(), Follows) ? 1 : 0;
  }
  const std::vector<LayerChecker::Horizon> whole = HorizonsOf(layers.Stack, stack.Horizons);
  stack.Options.Missing.Policy = MissingPolicy::Void;
  const Layers again = MakeLayers(LayerChecker::ViewsOf(whole), stack.Options);
  const bool areSame = layers.Plan.Columns == again.Plan.Columns && layers.Plan.Heights == again.Plan.Heights &&
    layers.Plan.IsIn == again.Plan.IsIn &&
    std::equal(layers.Plan.Triangles.begin(), layers.Plan.Triangles.end(), again.Plan.Triangles.begin(),
      again.Plan.Triangles.end());
  const std::string wrong = areSame ? CompareLedgers(layers, stack.Horizons) : "other layers than of whole horizons";
  return wrong.empty() ? LayerChecker::DomainChecker(whole, again, stack.Options).CheckDomains() : wrong;
}

std::string Try(unsigned seed, Tally& tally)
{
  const RandomStacks::Stack stack = RandomStacks::Generator(seed).Run();
  const std::vector<HorizonView> views = LayerChecker::ViewsOf(stack.Horizons);
  const bool areAny = !FindStackColumns(views, 2).Columns.empty();
  std::string ofDomains = areAny ? TryDomains(stack, tally) : "";
  ofDomains = areAny && ofDomains.empty() ? TryMissing(stack, tally) : ofDomains;
  if (!ofDomains.empty())
  {
    return ofDomains;
  }
  if (FindStackColumns(views, views.size()).Columns.empty())
  {
    ++tally.Empty;
    return "";
  }
  const Layers layers = MakeLayers(views, stack.Options);
  LayerChecker::Checker checker(stack.Horizons, layers, stack.Options);
  std::string wrong = checker.Check();
  wrong = wrong.empty() ? CompareLedgers(layers, stack.Horizons) : wrong;
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
            << " with gaps, " << tally.Filled << " horizons with filled holes, " << tally.Followed
            << " that follow others, " << tally.Conflicts << " halves of blocks left out\n";
  CHECK(tally.Empty < int(count / 4));
  CHECK(tally.Whole > int(count / 6));
  CHECK(tally.Pinched > int(count / 6));
  CHECK(tally.Crossed > int(count / 3));
  CHECK(tally.Parts > int(count / 4) && tally.Conflicts > int(count / 10));
  CHECK(tally.Faulted > int(count / 8) && tally.Completed > int(count / 20));
  CHECK(tally.Filled > int(count / 6) && tally.Followed > int(count / 12));
  CHECK(tally.Lines > 10 * count && tally.LeftOut < tally.Lines / 2);
  return Check::Result();
}
