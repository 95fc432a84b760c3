// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the decimation promises, on random patches, for all targets and efforts.

#include "DecimationChecker.h"
#include "Tools/Check.h"

#include <array>
#include <limits>

using namespace SeismicHorizons;
using namespace DecimationChecker;

namespace
{
/// Noise, cliffs, terraces, spikes or a fold.
double HeightOf(int kind, const PlanePoint& column, Patches::Random& random)
{
  switch (kind)
  {
    case 0:
      return std::floor(40.0 * random.Fraction());
    case 1:
      return column.X > column.Y ? 100.0 : 0.0;
    case 2:
      return double(column.X / 4 * 3);
    case 3:
      return random.Chance(0.02) ? 50.0 : 5.0;
    default:
      return 10.0 * std::sin(0.3 * column.X + 0.2 * column.Y) + random.Fraction();
  }
}

/// A patch with holes or without them, its outline as it is or simplified.
BoundedHorizon MakePatch(int n, Patches::Random& random)
{
  const Patches::Columns columns = Patches::Make(Patches::Shape(n % int(Patches::Shape::Count)), random);
  std::vector<double> heights;
  for (const PlanePoint& column : columns)
  {
    heights.push_back(HeightOf(n % 5, column, random));
  }
  BoundaryOptions boundary;
  boundary.KeepHoles = n % 3 == 0;
  boundary.Radius = 1 + n % 2;
  BoundedHorizon horizon = TestHorizons::OnColumns(TestHorizons::MakeHorizon(columns, heights, boundary));
  return n % 2 == 1 ? horizon
                    : TestHorizons::Drop(horizon, SimplifyBoundary(horizon, horizon.Boundary, { 1.0, false, 1.5 }));
}

void CheckTargets(const BoundedHorizon& horizon, int n, Patches::Random& random)
{
  constexpr double Any = std::numeric_limits<double>::infinity();
  const double bound = std::array<double, 5>{ 0.0, 0.3, 0.75, 3.0, 100.0 }[std::size_t(random.Below(5))];
  const double angle = std::array<double, 4>{ 0.0, 5.0, 30.0, 60.0 }[std::size_t(random.Below(4))];
  const std::size_t least = std::max(horizon.Boundary.CountPoints(horizon.Plane.size()), std::size_t(1));
  const std::size_t most = least + std::size_t(random.Below(int(horizon.Plane.size() - least) + 1));
  DecimationOptions toNumber = AtMost(most, n % 4 < 2);
  toNumber.Priority = n % 3 == 0 ? DecimationPriority::LargestError : DecimationPriority::SumOfSquares;
  const DecimationOptions toError = Within(bound, n % 4 < 2);
  const auto check = [&](const DecimationOptions& options, double error, MeshChecker::Kind kind)
  {
    const Decimation result = Decimate(horizon, options);
    CHECK(options.MaximumNumberOfPoints == 0 || result.Points.Source.size() <= options.MaximumNumberOfPoints);
    if (!CHECK_EQUAL(Checker(horizon, result).Check(error, kind), std::string()))
    {
      std::cerr << "patch " << n << ", bound " << bound << ", points " << most << ", angle " << angle << '\n';
    }
  };
  check(toError, bound, MeshChecker::Kind::Delaunay);
  check(toNumber, Any, toNumber.FitHeights ? MeshChecker::Kind::Any : MeshChecker::Kind::Delaunay);
  check(Best(toError, angle), bound, MeshChecker::Kind::Any);
  check(Best(toNumber, angle), Any, MeshChecker::Kind::Any);
}

void TestRandomPatches()
{
  Patches::Random random(41);
  for (int n = 0; n < 10000; ++n)
  {
    CheckTargets(MakePatch(n, random), n, random);
  }
}
}

int TestDecimationPatches(int, char*[])
{
  TestRandomPatches();
  return Check::Result();
}
