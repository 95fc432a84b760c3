// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonBoundarySimplification.h"

#include "BoundarySimplification/BoundarySimplification.h"
#include "Common/DataModel.h"
#include "Common/VTK/DataArrays.h"
#include "Marshalling/HorizonData.h"
#include "Marshalling/ReducedHorizon.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

namespace
{
using namespace SeismicHorizons;

std::vector<SpacePoint> ToSpacePoints(const LatticePoints& points)
{
  std::vector<SpacePoint> places;
  places.reserve(points.Plane.size());
  for (std::size_t point = 0; point < points.Plane.size(); ++point)
  {
    places.push_back({ points.Grid.ToLatticeUnits(points.Plane[point].X),
      points.Grid.ToLatticeUnits(points.Plane[point].Y), points.Height[point] });
  }
  return places;
}

/// Numbers the points that stay from 0.
Reduction ToReduction(const BoundarySimplification& simplified, const LatticePoints& points)
{
  Reduction reduction;
  std::vector<PointId> number(simplified.Target.size(), NoPoint);
  for (std::size_t point = 0; point < number.size(); ++point)
  {
    if (simplified.Target[point] == PointId(point))
    {
      number[point] = PointId(reduction.Source.size());
      reduction.Source.push_back(PointId(point));
      reduction.Plane.push_back(points.Plane[point]);
      reduction.Height.push_back(points.Height[point]);
    }
  }
  reduction.Averaged.assign(reduction.Source.size(), false);
  for (const PointId target : simplified.Target)
  {
    reduction.Target.push_back(number[std::size_t(target)]);
  }
  reduction.Boundary = simplified.Boundary.Renumbered(number);
  return reduction;
}
}

vtkStandardNewMacro(vtkHorizonBoundarySimplification);

//------------------------------------------------------------------------------
void vtkHorizonBoundarySimplification::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << (this->Method == Threshold ? "Threshold" : "FewestPoints") << "\n";
  os << indent << "DistanceThreshold: " << this->DistanceThreshold << "\n";
  os << indent << "BoundDeviation: " << (this->BoundDeviation ? "on" : "off") << "\n";
  os << indent << "OutlineTolerance: " << this->OutlineTolerance << "\n";
}

//------------------------------------------------------------------------------
void vtkHorizonBoundarySimplification::ProcessHorizon(
  vtkPolyData* input, const Outputs& outputs, const Monitor& monitor)
{
  vtkPolyData* const output = outputs.front();
  const LatticePoints points = ReadPoints(input);
  monitor.Progress(0.2);
  BoundarySimplificationOptions options;
  options.Method = this->Method == Threshold ? OutlineMethod::Threshold : OutlineMethod::FewestPoints;
  options.DistanceThreshold = this->DistanceThreshold;
  options.BoundDeviation = this->BoundDeviation;
  options.OutlineTolerance = this->OutlineTolerance;
  const BoundarySimplification simplified =
    SimplifyBoundary(ToSpacePoints(points), ReadBoundary(input), options, monitor.Step(0.2, 0.7));
  WriteReduction(input, points.Grid, ToReduction(simplified, points), Merging::DropsPoints, output);
  AddValue<vtkDoubleArray>(output->GetFieldData(), FieldArray::BoundaryDeviation, simplified.Deviation);
  AddValue<vtkDoubleArray>(output->GetFieldData(), FieldArray::OutlineDeviation, simplified.OutlineDeviation);
}
