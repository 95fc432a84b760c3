// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonExteriorBoundary.h"

#include "BoundaryOutput.h"
#include "Common/Base/Parameters.h"
#include "Common/Horizon/DataModel.h"
#include "Filters/Algorithms/Boundary/ExteriorBoundary.h"
#include "Filters/Marshalling/CutData.h"
#include "Filters/Marshalling/HorizonData.h"
#include "Filters/Marshalling/HorizonPoints.h"
#include "Filters/Marshalling/LedgerOutput.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

using namespace SeismicHorizons;

vtkStandardNewMacro(vtkHorizonExteriorBoundary);

//------------------------------------------------------------------------------
std::int64_t vtkHorizonExteriorBoundary::FindSmallestHoleSize(double columnArea) const
{
  CheckAtLeast("smallest hole size", this->SmallestHoleSize, 1, " column");
  CheckAtLeast("smallest hole area", this->SmallestHoleArea, 0.0, " square units of the world");
  // Areas are often whole multiples of a column's area. The quotient may exceed the whole number by a few roundings
  // (1e-16 each), which must not require another column.
  constexpr double rounding = 1e-12;
  const double columns = std::ceil(this->SmallestHoleArea / columnArea * (1.0 - rounding));
  const double most = double(std::numeric_limits<std::int64_t>::max() / 2);
  return std::max(std::int64_t(this->SmallestHoleSize), columns > 0.0 ? std::int64_t(std::min(columns, most)) : 0);
}

//------------------------------------------------------------------------------
void vtkHorizonExteriorBoundary::ProcessHorizon(vtkPolyData* horizon, const Outputs& outputs, const Monitor& monitor)
{
  const LatticePoints points = ReadColumns(WithoutHiddenPoints(horizon), outputs, KeptHeights::None);
  vtkPolyData* const input = points.Horizon;
  monitor.Progress(0.3);
  BoundaryOptions options;
  options.Radius = this->Radius;
  options.Growth = static_cast<SeismicHorizons::GrowthStrategy>(this->GrowthStrategy);
  options.HoleBoundaries = this->HoleBoundaries;
  options.SmallestHoleSize = this->FindSmallestHoleSize(points.Lattice.ColumnArea());
  options.MinimumPatchSize = this->MinimumPatchSize;
  const std::optional<LinkCuts> cuts = this->UseCuts ? FindCuts(input, PlaneBox(points.Column)) : std::nullopt;
  options.Cuts = cuts ? &*cuts : nullptr;
  const auto type = static_cast<SeismicHorizons::BoundaryType>(this->BoundaryType);
  auto found = FindExteriorBoundary(points.Column, OptionsFor(type, options), monitor.Step(0.3, 0.9));
  if (found.NumberOfPatches == 0)
  {
    this->Warn(NothingLeft(input, this->MinimumPatchSize));
  }
  const std::vector<BoundaryKind> marks = MarkBoundary(type, points.Column, found);
  const KeptPoints kept = DropPointsWithoutPatch(found);
  WriteBoundary(input, kept, found, kept.Select(marks), outputs.front());
  const Loops loops = found.Boundary.RenumberedBy([&kept](PointId point) { return kept[std::size_t(point)]; });
  WriteLedger(points, kept, CoveredColumns(points.Column, loops, 1), outputs.front());
  if (!this->UseCuts)
  {
    RemoveCuts(outputs.front());
  }
}
