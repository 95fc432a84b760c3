// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "BoundaryStage.h"

#include "Common/Base/Parameters.h"
#include "Filters/Common/CrackData.h"
#include "Filters/Common/CutData.h"
#include "Filters/Common/HorizonCells.h"
#include "Filters/Common/HorizonPoints.h"
#include "Filters/Common/LatticePoints.h"
#include "Filters/Common/LedgerOutput.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace SeismicHorizons
{
namespace
{
std::int64_t FindSmallestHoleSize(const BoundaryStageOptions& options, double columnArea)
{
  CheckAtLeast<std::int64_t>("smallest hole size", options.SmallestHoleSize, 1, " column");
  CheckAtLeast("smallest hole area", options.SmallestHoleArea, 0.0, " square units of the world");
  // Areas are often whole multiples of a column's area. The quotient may exceed the whole number by a few roundings
  // (1e-16 each), which must not require another column.
  constexpr double rounding = 1e-12;
  const double columns = std::ceil(options.SmallestHoleArea / columnArea * (1.0 - rounding));
  const double most = double(std::numeric_limits<std::int64_t>::max() / 2);
  return std::max(options.SmallestHoleSize, columns > 0.0 ? std::int64_t(std::min(columns, most)) : 0);
}
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::string> RunBoundary(
  const Horizon& horizon, BoundaryStageOptions options, std::vector<Horizon>& outputs, const Monitor& monitor)
{
  std::vector<std::string> warnings;
  const LatticePoints points = ReadColumns(WithoutHiddenPoints(horizon), KeptHeights::None);
  WriteDeviation(points, outputs);
  const Horizon& input = points.Horizon;
  Horizon& output = outputs.front();
  monitor.Progress(0.3);
  options.SmallestHoleSize = FindSmallestHoleSize(options, points.Lattice.ColumnArea());
  const std::optional<LinkCuts> cuts = options.TearAtFaults ? FindCuts(input, PlaneBox(points.Column)) : std::nullopt;
  options.Cuts = cuts ? &*cuts : nullptr;
  auto found = FindExteriorBoundary(points.Column, OptionsFor(options.Type, options), monitor.Step(0.3, 0.9));
  if (found.NumberOfPatches == 0)
  {
    warnings.push_back(NothingLeft(input.NumberOfPoints(), options.MinimumPatchSize));
  }
  const std::vector<BoundaryKind> marks = MarkBoundary(options.Type, points.Column, found);
  const KeptPoints kept = DropPointsWithoutPatch(found);
  WriteBoundary(input, kept, found, kept.Select(marks), output);
  const Loops loops = found.Boundary.RenumberedBy([&kept](PointId point) { return kept[std::size_t(point)]; });
  WriteLedger(points, kept, CoveredColumns(points.Column, loops, 1), output);
  if (!options.TearAtFaults)
  {
    RemoveCuts(output);
  }
  return warnings;
}

//----------------------------------------------------------------------------------------------------------------------
void WriteBoundary(const Horizon& input, const KeptPoints& kept, const ExteriorBoundary& boundary,
  const std::vector<BoundaryKind>& marks, Horizon& output)
{
  CopyPoints(input, kept, output);
  output.Lines = MakePolylines(boundary.Boundary);
  AddArray<int>(output.PointData, PointArray::PatchId, boundary.Patch);
  AddArray<unsigned char>(
    output.PointData, PointArray::Boundary, marks, [](BoundaryKind kind) { return static_cast<unsigned char>(kind); });
  output.PointData.SetActiveScalars(PointArray::PatchId);
  WriteBoundaryFigures(boundary, input.NumberOfPoints() - std::int64_t(kept.size()), output.FieldData);
  WriteCracks(boundary.OpenCracks, output);
}

//----------------------------------------------------------------------------------------------------------------------
void WriteBoundaryFigures(const ExteriorBoundary& boundary, std::int64_t droppedPoints, ArrayTable& figures)
{
  for (const char* const name : { FieldArray::BoundaryDeviation, FieldArray::OutlineDeviation,
         FieldArray::OutlineHeightDeviation, FieldArray::NumberOfOutsidePoints })
  {
    figures.Remove(name); // These describe an earlier outline.
  }
  AddValue<std::int64_t>(figures, FieldArray::NumberOfPatches, std::int64_t(boundary.NumberOfPatches));
  AddValue<std::int64_t>(
    figures, FieldArray::NumberOfHoles, std::int64_t(boundary.Boundary.Size() - boundary.NumberOfPatches));
  AddValue<std::int64_t>(figures, FieldArray::DroppedSmallPatchPoints, droppedPoints);
}

//----------------------------------------------------------------------------------------------------------------------
void RemoveCuts(Horizon& output)
{
  RemoveFaultedLinks(output.FieldData);
  for (const char* const name : { FieldArray::CrackOpenEnds, FieldArray::OldCrackOpenEnds, FieldArray::CrackLoops })
  {
    output.FieldData.Remove(name);
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::string NothingLeft(std::int64_t numberOfPoints, std::int64_t minimumPatchSize)
{
  return "none of the " + std::to_string(numberOfPoints) + " points is in a patch of MinimumPatchSize, " +
    std::to_string(minimumPatchSize) + " points, or more";
}
}
