// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "BoundarySimplificationStage.h"

#include "Common/Horizon/DataModel.h"
#include "Filters/Common/CrackData.h"
#include "Filters/Common/HorizonData.h"
#include "Filters/Common/LedgerOutput.h"
#include "Filters/Common/ReducedHorizon.h"

#include <cstdint>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
void RunBoundarySimplification(
  const Horizon& horizon, BoundarySimplificationOptions options, std::vector<Horizon>& outputs, const Monitor& monitor)
{
  Horizon& output = outputs.front();
  // The method needs heights only on loops.
  const auto read = options.Method == OutlineMethod::FewestPoints ? ReadColumns : ReadPoints;
  const LatticePoints points = read(horizon, KeptHeights::None);
  WriteDeviation(points, outputs);
  const Horizon& input = points.Horizon;
  monitor.Progress(0.2);
  const Loops boundary = ReadBoundary(input);
  options.Fixed = ReadPointsOfOpenEnds(input, points.Column, boundary);
  const std::vector<PlanePoint> plane = points.AreMerged ? ToSubVoxels(points) : std::vector<PlanePoint>();
  const auto height = [&points](std::size_t point) { return points.HeightAt(point); };
  const BoundarySimplification simplified =
    SimplifyBoundary(points.AreMerged ? SpacePoints(plane, height, points.Lattice.SubVoxelsPerColumn())
                                      : SpacePoints(points.Column, height, 1),
      boundary, options, monitor.Step(0.2, 0.7));
  WriteDropped(input, simplified.Dropped, simplified.Boundary, output);
  const PlanePoints places = points.AreMerged ? PlanePoints(plane) : points.Column;
  const std::int32_t subVoxels = points.AreMerged ? points.Lattice.SubVoxelsPerColumn() : 1;
  WriteLedger(
    points, KeptPoints::All(points.Column.size()), CoveredColumns(places, simplified.Boundary, subVoxels), output);
  // Points dropped by an earlier simplification are missing, so adding its figures gives upper bounds.
  ArrayTable& figures = output.FieldData;
  const auto add = [&](const char* name, double value)
  { AddValue<double>(figures, name, FirstValue(figures, name) + value); };
  add(FieldArray::BoundaryDeviation, simplified.Deviation);
  add(FieldArray::OutlineDeviation, simplified.OutlineDeviation);
  add(FieldArray::OutlineHeightDeviation, simplified.HeightDeviation);
  AddValue<std::int64_t>(figures, FieldArray::NumberOfOutsidePoints,
    std::int64_t(FirstValue(figures, FieldArray::NumberOfOutsidePoints)) + simplified.NumberOutside);
}
}
