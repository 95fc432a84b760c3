// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Random stacks, and all that must be true of their layers. Arguments beyond those of all tests are the first seed and
// how many there are.

#include "Common/Errors.h"
#include "LayerChecker.h"
#include "RandomStacks.h"
#include "Tools/Check.h"

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
  std::size_t Lines = 0;
  std::size_t LeftOut = 0;
};

std::string Try(unsigned seed, Tally& tally)
{
  const RandomStacks::Stack stack = RandomStacks::Generator(seed).Run();
  const std::vector<HorizonView> views = LayerChecker::ViewsOf(stack.Horizons);
  if (FindCommonColumns(views).Columns.empty())
  {
    ++tally.Empty;
    return "";
  }
  const Layers layers = MakeLayers(views, stack.Options);
  LayerChecker::Checker checker(stack.Horizons, layers, stack.Options);
  std::string wrong = checker.Check();
  if (wrong.empty() && *stack.Options.OutlineTolerance == 0.0)
  {
    ++tally.Whole;
    wrong = checker.CheckLattice();
  }
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
            << " pieces of pinch-out lines, without " << tally.LeftOut << '\n';
  CHECK(tally.Empty < int(count / 4));
  CHECK(tally.Whole > int(count / 6));
  CHECK(tally.Pinched > int(count / 6));
  CHECK(tally.Crossed > int(count / 3));
  CHECK(tally.Lines > 10 * count && tally.LeftOut < tally.Lines / 2);
  return Check::Result();
}
