// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Random lattices with cracks that are closed, through all simplifications and both ways to mesh.

#include "ClosedFaults.h"
#include "Filters/Algorithms/CellSimplification/CellSimplification.h"
#include "Filters/Algorithms/Decimation/Decimation.h"
#include "Tools/Check.h"
#include "Tools/CrackedPatches.h"

#include <string>

using namespace ClosedFaults;
using ClosingChecker::Outline;

namespace
{
/// With radius 1 to 3, with loops for all holes, for large ones, or for those with cuts alone, and some without small
/// patches.
BoundaryOptions MakeOptions(const CrackedPatch& patch, int n)
{
  BoundaryOptions options;
  options.Radius = 1 + n % 3;
  options.KeepHoles = n / 3 % 3 != 0;
  options.SmallestHoleSize = n / 3 % 3 == 1 ? 1 : 5;
  options.MinimumPatchSize = n / 9 % 4 == 3 ? 3 : 1;
  options.Cuts = &patch.Cuts;
  return options;
}

std::string CheckMesh(const char* stage, const Cracked& cracked, const BoundedHorizon& horizon,
  const RawVector<PointId>& mesh, const Outline& outline)
{
  const std::string wrong = ClosingChecker::CheckClosing(horizon, mesh, Close(cracked, horizon), outline);
  return wrong.empty() ? wrong : stage + (": " + wrong);
}

std::string CheckMeshes(const Cracked& cracked, const BoundedHorizon& horizon, const Outline& outline)
{
  std::string wrong = CheckMesh("full mesh", cracked, horizon, Triangulate(horizon).Triangles, outline);
  const auto checkReduced = [&](const char* stage, const Reduction& reduction)
  {
    const BoundedHorizon reduced = Reduce(horizon, reduction);
    const std::string here = CheckMesh(stage, cracked, reduced, Triangulate(reduced).Triangles, outline);
    wrong = wrong.empty() ? here : wrong;
  };
  checkReduced("rough", SimplifyRough(horizon, 3));
  checkReduced("elaborate", SimplifyElaborate(horizon, 5));
  for (const DecimationEffort effort : { DecimationEffort::Fast, DecimationEffort::Best })
  {
    DecimationOptions options;
    options.Effort = effort;
    const Decimation decimation = Decimate(OnColumns(horizon), options);
    const std::string here =
      CheckMesh("decimation", cracked, Reduce(horizon, decimation.Points), decimation.Triangles, outline);
    wrong = wrong.empty() ? here : wrong;
  }
  return wrong;
}

/// What a lattice with all its points has between its cutoffs: with a radius of 1 it is known block by block.
std::string CheckFull(
  const CrackedPatch& patch, const Cracked& cracked, const BoundaryOptions& options, Outline& outline)
{
  const RawVector<PointId> closing = Close(cracked, cracked.Horizon);
  const bool isKnown = options.Radius == 1 && options.MinimumPatchSize == 1;
  outline = isKnown ? ClosingChecker::FindOutlineOfBlocks(patch, cracked.Horizon)
                    : ClosingChecker::FindOutline(cracked.Horizon, closing);
  return isKnown ? ClosingChecker::CheckBlocks(patch, cracked.Horizon, closing) : std::string();
}

std::string CheckLattice(const CrackedPatch& patch, int n, Patches::Random& random)
{
  const BoundaryOptions options = MakeOptions(patch, n);
  const Cracked cracked = Make(patch, options, MakeHeights(patch.Columns, random));
  if (cracked.Horizon.Plane.empty())
  {
    return {};
  }
  Outline outline;
  std::string wrong = CheckFull(patch, cracked, options, outline);
  wrong = wrong.empty() ? CheckMeshes(cracked, cracked.Horizon, outline) : wrong;
  BoundarySimplificationOptions inPlan;
  inPlan.OutlineTolerance = 1.5;
  inPlan.DistanceThreshold = n % 2 == 0 ? 0.75 : 10.0;
  BoundarySimplificationOptions fewest = inPlan;
  fewest.Method = OutlineMethod::FewestPoints;
  for (const BoundarySimplificationOptions& simplification : { BoundarySimplificationOptions(), inPlan, fewest })
  {
    const BoundedHorizon simplified = Simplify(cracked, simplification);
    const Outline left = ClosingChecker::SimplifyOutline(cracked.Horizon, outline, simplified);
    wrong = wrong.empty() ? CheckMeshes(cracked, simplified, left) : wrong;
  }
  return wrong;
}
}

int TestClosedLattices(int, char*[])
{
  Patches::Random random(5);
  for (int n = 0; n < CrackedPatches::NumberOfLattices(); ++n)
  {
    const CrackedPatch patch = CrackedPatches::Make(random);
    std::string wrong;
    try
    {
      wrong = CheckLattice(patch, n, random);
    }
    catch (const std::exception& error)
    {
      wrong = error.what();
    }
    if (!CHECK_EQUAL(wrong, std::string()))
    {
      std::cerr << "lattice " << n << '\n';
    }
  }
  return Check::Result();
}
