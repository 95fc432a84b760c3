// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Random lattices with cracks, through all simplifications and both ways to mesh.

#include "DecimationChecker.h"
#include "Filters/Algorithms/CellSimplification/CellSimplification.h"
#include "Tools/BoundaryChecker.h"
#include "Tools/Check.h"
#include "Tools/CrackedPatches.h"
#include "Tools/CutChecker.h"
#include "Tools/ReductionChecker.h"

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <set>
#include <vector>

using namespace TestHorizons;
using CrackedPatches::CrackedPatch;
using DecimationChecker::AtMost;
using DecimationChecker::Best;
using DecimationChecker::Within;

namespace
{
constexpr double Any = std::numeric_limits<double>::infinity();

/// With radius 1 to 3, and with loops for all holes, for large ones, or for those with cuts alone.
BoundedHorizon MakeCracked(const CrackedPatch& patch, int n, Patches::Random& random)
{
  BoundaryOptions options;
  options.Radius = 1 + n % 3;
  options.KeepHoles = n / 3 % 3 != 0;
  options.SmallestHoleSize = n / 3 % 3 == 1 ? 1 : 5;
  options.Cuts = &patch.Cuts;
  BoundedHorizon horizon = MakeHorizon(patch.Columns, MakeHeights(patch.Columns, random), options);
  horizon.Cuts = std::make_shared<const LinkCuts>(patch.Cuts);
  return horizon;
}

/// A sound mesh of the horizon, and none where it is cut. Outlines that moved in plan may have moved over cuts.
std::string CheckMesh(const std::string& stage, const CrackedPatch& patch, const BoundedHorizon& horizon, bool isExact)
{
  std::string wrong;
  try
  {
    wrong = MeshChecker::CheckMesh(horizon, Triangulate(horizon).Triangles);
  }
  catch (const std::exception& error)
  {
    wrong = error.what();
  }
  wrong = wrong.empty() && isExact
    ? CutChecker::CheckCuts(patch, horizon.Plane, horizon.Boundary, horizon.SubVoxelsPerColumn)
    : wrong;
  return wrong.empty() ? wrong : stage + ": " + wrong;
}

/// Whether links that are not cut connect two columns within a square cell.
bool AreJoined(const LinkCuts& cuts, const PlaneBox& cell, const PlanePoint& from, const PlanePoint& to)
{
  std::set<PlanePoint> reached = { from };
  std::vector<PlanePoint> open = { from };
  const auto reach = [&](bool isCut, const PlanePoint& column)
  {
    const bool isInCell = column.X >= cell.Least.X && column.Y >= cell.Least.Y && column.X <= cell.Greatest.X &&
      column.Y <= cell.Greatest.Y;
    if (!isCut && isInCell && reached.insert(column).second)
    {
      open.push_back(column);
    }
  };
  while (!open.empty())
  {
    const PlanePoint at = open.back();
    open.pop_back();
    reach(cuts.IsCutEast(at), { at.X + 1, at.Y });
    reach(cuts.IsCutNorth(at), { at.X, at.Y + 1 });
    reach(cuts.IsCutEast({ at.X - 1, at.Y }), { at.X - 1, at.Y });
    reach(cuts.IsCutNorth({ at.X, at.Y - 1 }), { at.X, at.Y - 1 });
  }
  return reached.count(to) != 0;
}

/// Points are merged on their side of the cuts in a cell, and none is lost.
std::string CheckMerging(
  const CrackedPatch& patch, const BoundedHorizon& horizon, const Reduction& reduction, std::int32_t size)
{
  const PlanePoint least = PlaneBox(horizon.Plane).Least;
  const auto columnOf = [&](std::size_t point)
  {
    const PlanePoint& place = horizon.Plane[point];
    return PlanePoint{ place.X / SubVoxelsPerColumn, place.Y / SubVoxelsPerColumn };
  };
  for (std::size_t point = 0; point < horizon.Plane.size(); ++point)
  {
    const std::size_t target = std::size_t(reduction.Source[std::size_t(reduction.Target[point])]);
    const PlanePoint column = columnOf(point);
    const PlanePoint origin{ least.X / SubVoxelsPerColumn, least.Y / SubVoxelsPerColumn };
    const PlanePoint corner{ column.X - (column.X - origin.X) % size, column.Y - (column.Y - origin.Y) % size };
    const PlaneBox cell({ corner, { corner.X + size - 1, corner.Y + size - 1 } });
    if (!AreJoined(patch.Cuts, cell, column, columnOf(target)))
    {
      return "point " + std::to_string(point) + " merged across a cut";
    }
  }
  return ReductionChecker::CheckPoints(horizon, reduction);
}

std::string CheckSimplifications(const CrackedPatch& patch, const BoundedHorizon& horizon, bool isExact)
{
  std::string wrong = CheckMesh("full mesh", patch, horizon, isExact);
  for (const int size : { 2, 5 })
  {
    const Reduction rough = SimplifyRough(horizon, size);
    wrong = wrong.empty() ? CheckMesh("rough", patch, Reduce(horizon, rough), isExact) : wrong;
    wrong = wrong.empty() ? CheckMerging(patch, horizon, rough, size) : wrong;
    const Reduction elaborate = SimplifyElaborate(horizon, size);
    wrong = wrong.empty() ? CheckMesh("elaborate", patch, Reduce(horizon, elaborate), isExact) : wrong;
    wrong = wrong.empty() ? CheckMerging(patch, horizon, elaborate, size) : wrong;
  }
  return wrong;
}

std::string CheckDecimations(const BoundedHorizon& horizon, Patches::Random& random)
{
  const double bound = std::array<double, 3>{ 0.0, 0.75, 3.0 }[std::size_t(random.Below(3))];
  const std::size_t least = std::max(horizon.Boundary.CountPoints(horizon.Plane.size()), std::size_t(1));
  const std::size_t most = least + std::size_t(random.Below(int(horizon.Plane.size() - least) + 1));
  std::string wrong;
  const auto check = [&](const char* target, const DecimationOptions& options, double error, MeshChecker::Kind kind)
  {
    const Decimation result = Decimate(OnColumns(horizon), options);
    const std::string here = DecimationChecker::Checker(horizon, result).Check(error, kind);
    wrong = wrong.empty() && !here.empty() ? target + (": " + here) : wrong;
  };
  check("within an error", Within(bound), bound, MeshChecker::Kind::Delaunay);
  check("best within an error", Best(Within(bound, true)), bound, MeshChecker::Kind::Any);
  check("so many points", AtMost(most, true), Any, MeshChecker::Kind::Any);
  check("so many points, heights not fitted", AtMost(most), Any, MeshChecker::Kind::Delaunay);
  check("best of so many points", Best(AtMost(most)), Any, MeshChecker::Kind::Any);
  return wrong;
}

std::string CheckAll(const CrackedPatch& patch, const BoundedHorizon& horizon, bool isExact, Patches::Random& random)
{
  try
  {
    const std::string crossings = BoundaryChecker::CheckCrossings(horizon);
    const std::string wrong = crossings.empty() ? CheckSimplifications(patch, horizon, isExact) : crossings;
    return wrong.empty() ? CheckDecimations(horizon, random) : wrong;
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
}

void TestRandomLattices()
{
  Patches::Random random(21);
  for (int n = 0; n < CrackedPatches::NumberOfLattices(); ++n)
  {
    const CrackedPatch patch = CrackedPatches::Make(random);
    const BoundedHorizon horizon = MakeCracked(patch, n, random);
    BoundarySimplificationOptions inPlan;
    inPlan.OutlineTolerance = 1.5;
    inPlan.DistanceThreshold = n % 2 == 0 ? 0.75 : 10.0;
    BoundarySimplificationOptions fewest = inPlan;
    fewest.Method = OutlineMethod::FewestPoints;
    const auto simplified = [&horizon](const BoundarySimplificationOptions& options)
    {
      BoundedHorizon result =
        Drop(horizon, SimplifyBoundary(TestHorizons::OnColumns(horizon), horizon.Boundary, options));
      result.Cuts = horizon.Cuts;
      return result;
    };
    const bool isSound = CHECK_EQUAL(CheckAll(patch, horizon, true, random), std::string()) &&
      CHECK_EQUAL(CheckAll(patch, simplified(BoundarySimplificationOptions()), true, random), std::string()) &&
      CHECK_EQUAL(CheckAll(patch, simplified(inPlan), false, random), std::string()) &&
      CHECK_EQUAL(CheckAll(patch, simplified(fewest), false, random), std::string());
    if (!isSound)
    {
      std::cerr << "lattice " << n << '\n';
    }
  }
}
}

int TestCrackedLattices(int, char*[])
{
  TestRandomLattices();
  return Check::Result();
}
