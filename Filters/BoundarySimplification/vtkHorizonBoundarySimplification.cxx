// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonBoundarySimplification.h"

#include "Common/Horizon/DataModel.h"
#include "Common/VTK/DataArrays.h"
#include "Filters/Algorithms/BoundarySimplification/BoundarySimplification.h"
#include "Filters/Marshalling/CrackData.h"
#include "Filters/Marshalling/HorizonData.h"
#include "Filters/Marshalling/LedgerOutput.h"
#include "Filters/Marshalling/ReducedHorizon.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

using namespace SeismicHorizons;

vtkStandardNewMacro(vtkHorizonBoundarySimplification);

//------------------------------------------------------------------------------
void vtkHorizonBoundarySimplification::ProcessHorizon(
  vtkPolyData* horizon, const Outputs& outputs, const Monitor& monitor)
{
  vtkPolyData* const output = outputs.front();
  // The method needs heights only on loops.
  const auto read = this->Method == FewestPoints ? ReadColumns : ReadPoints;
  const LatticePoints points = read(horizon, outputs, KeptHeights::None);
  vtkPolyData* const input = points.Horizon;
  monitor.Progress(0.2);
  BoundarySimplificationOptions options;
  options.Method = this->Method == Threshold ? OutlineMethod::Threshold : OutlineMethod::FewestPoints;
  options.DistanceThreshold = this->DistanceThreshold;
  options.BoundDeviation = this->BoundDeviation;
  options.OutlineTolerance = this->OutlineTolerance;
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
  vtkFieldData* const figures = output->GetFieldData();
  const auto add = [&](const char* name, double value)
  { AddValue<vtkDoubleArray>(figures, name, FirstValue(figures, name) + value); };
  add(FieldArray::BoundaryDeviation, simplified.Deviation);
  add(FieldArray::OutlineDeviation, simplified.OutlineDeviation);
  add(FieldArray::OutlineHeightDeviation, simplified.HeightDeviation);
  AddValue<vtkIdTypeArray>(figures, FieldArray::NumberOfOutsidePoints,
    vtkIdType(FirstValue(figures, FieldArray::NumberOfOutsidePoints)) + vtkIdType(simplified.NumberOutside));
}
