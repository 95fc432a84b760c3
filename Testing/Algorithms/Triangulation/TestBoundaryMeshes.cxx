// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Every boundary, whatever its radius, rule and holes, is one that the stages after it can work with.

#include "Common/Horizon/MeshChecker.h"
#include "Filters/Algorithms/CellSimplification/CellSimplification.h"
#include "Filters/Algorithms/Triangulation/Triangulation.h"
#include "Tools/Check.h"
#include "Tools/TestHorizons.h"

using namespace TestHorizons;

namespace
{
// Each with every radius from 1 to 5, both rules, and with and without holes.
constexpr int NumberOfPatches = 400;

std::string Check(const BoundedHorizon& horizon)
{
  try
  {
    return MeshChecker::CheckMesh(horizon, Triangulate(horizon).Triangles);
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
}

void TestMeshes()
{
  Patches::Random random(5);
  for (int n = 0; n < NumberOfPatches; ++n)
  {
    const Patches::Columns columns = Patches::Make(Patches::Shape(n % int(Patches::Shape::Count)), random);
    const std::vector<double> heights = MakeHeights(columns, random);
    for (int which = 0; which < 20; ++which)
    {
      BoundaryOptions options;
      options.Radius = 1 + which / 4;
      options.Growth = GrowthStrategy(which % 2);
      options.KeepHoles = which % 4 >= 2;
      const BoundedHorizon horizon = MakeHorizon(columns, heights, options);
      const bool isSound = CHECK_EQUAL(Check(horizon), std::string()) &&
        CHECK_EQUAL(Check(Drop(horizon, SimplifyBoundary(horizon, horizon.Boundary, 0.4))), std::string()) &&
        CHECK_EQUAL(Check(Reduce(horizon, SimplifyRough(horizon, 3))), std::string());
      if (!isSound)
      {
        std::cerr << "patch " << n << ", case " << which << '\n';
      }
    }
  }
}
}

int TestBoundaryMeshes(int, char*[])
{
  TestMeshes();
  return Check::Result();
}
