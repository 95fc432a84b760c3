// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonDecimation.h"

#include "Common/DataModel.h"
#include "Common/Parameters.h"
#include "Common/PlaneGeometry.h"
#include "Common/VTK/DataArrays.h"
#include "Decimation/Decimation.h"
#include "Marshalling/HorizonCells.h"
#include "Marshalling/HorizonData.h"
#include "Marshalling/HorizonPoints.h"
#include "Marshalling/ReducedHorizon.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

using namespace SeismicHorizons;

namespace
{
std::size_t CountLoopPoints(const BoundedHorizon& horizon)
{
  const std::vector<unsigned char> marks = horizon.Boundary.MarkPoints(horizon.Plane.size());
  return std::size_t(std::count(marks.begin(), marks.end(), 1));
}

void WriteMesh(Decimation& decimation, const Lattice& grid, vtkPolyData* output)
{
  output->SetVerts(nullptr);
  const double smallestAngle = WriteTriangles(decimation.Points.Plane, grid, std::move(decimation.Triangles), output);
  AddTriangleArray<vtkDoubleArray>(CellArray::Error, decimation.Errors, output);
  vtkFieldData* const figures = output->GetFieldData();
  AddValue<vtkDoubleArray>(figures, FieldArray::LargestError, decimation.LargestError);
  AddValue<vtkDoubleArray>(figures, FieldArray::MeanError, decimation.MeanError);
  AddValue<vtkDoubleArray>(figures, FieldArray::LargestLoopError, decimation.LargestLoopError);
  AddValue<vtkIdTypeArray>(figures, FieldArray::TriangleCount, output->GetNumberOfPolys());
  AddValue<vtkDoubleArray>(figures, FieldArray::SmallestAngle, smallestAngle);
}
}

vtkStandardNewMacro(vtkHorizonDecimation);

//------------------------------------------------------------------------------
void vtkHorizonDecimation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const char* const targets[] = { "LargestError", "NumberOfPoints", "Reduction" };
  const char* const units[] = { "Lattice", "World", "Diagonal" };
  os << indent << "Target: " << targets[this->Target] << "\n";
  os << indent << "MaximumError: " << this->MaximumError << "\n";
  os << indent << "ErrorUnit: " << units[this->ErrorUnit] << "\n";
  os << indent << "MaximumNumberOfPoints: " << this->MaximumNumberOfPoints << "\n";
  os << indent << "TargetReduction: " << this->TargetReduction << "\n";
  os << indent << "FitHeights: " << (this->FitHeights ? "On" : "Off") << "\n";
  os << indent << "Effort: " << (this->Effort == Fast ? "Fast" : "Best") << "\n";
  os << indent << "Priority: " << (this->Priority == LargestErrors ? "LargestErrors" : "SumOfSquares") << "\n";
  os << indent << "SmallestAngle: " << this->SmallestAngle << "\n";
}

//------------------------------------------------------------------------------
double vtkHorizonDecimation::FindError(const BoundedHorizon& horizon, const SeismicHorizons::Lattice& grid) const
{
  CheckAtLeast("maximum error", this->MaximumError, 0.0, "");
  if (this->ErrorUnit == World)
  {
    const Eigen::Vector3d up(0.0, 0.0, 1.0);
    return this->MaximumError / std::abs((grid.ToWorld(up) - grid.ToWorld(Eigen::Vector3d::Zero())).z());
  }
  if (this->ErrorUnit == Diagonal)
  {
    const PlaneBox box(horizon.Plane);
    const auto ends = std::minmax_element(horizon.Height.begin(), horizon.Height.end());
    const Eigen::Vector3d diagonal(grid.ToLatticeUnits(box.Greatest.X) - grid.ToLatticeUnits(box.Least.X),
      grid.ToLatticeUnits(box.Greatest.Y) - grid.ToLatticeUnits(box.Least.Y), *ends.second - *ends.first);
    return this->MaximumError * diagonal.norm();
  }
  return this->MaximumError;
}

//------------------------------------------------------------------------------
DecimationOptions vtkHorizonDecimation::MakeOptions(
  const BoundedHorizon& horizon, const SeismicHorizons::Lattice& grid) const
{
  DecimationOptions options;
  options.MaximumError = 0.0;
  options.FitHeights = this->FitHeights;
  options.Effort = this->Effort == Fast ? DecimationEffort::Fast : DecimationEffort::Best;
  options.Priority =
    this->Priority == LargestErrors ? DecimationPriority::LargestError : DecimationPriority::SumOfSquares;
  options.SmallestAngle = this->SmallestAngle;
  if (this->Target == LargestError)
  {
    options.MaximumError = this->FindError(horizon, grid);
  }
  else if (this->Target == NumberOfPoints)
  {
    CheckAtLeast("maximum number of points", this->MaximumNumberOfPoints, 1, "");
    options.MaximumNumberOfPoints = std::size_t(this->MaximumNumberOfPoints);
  }
  else
  {
    CheckWithin("target reduction", this->TargetReduction, 0.0, 1.0, " of the points");
    const double points = std::ceil((1.0 - this->TargetReduction) * double(horizon.Plane.size()));
    options.MaximumNumberOfPoints = std::max({ std::size_t(points), std::size_t(1), CountLoopPoints(horizon) });
  }
  return options;
}

//------------------------------------------------------------------------------
void vtkHorizonDecimation::ProcessHorizon(vtkPolyData* input, const Outputs& outputs, const Monitor& monitor)
{
  vtkPolyData* const output = outputs.front();
  LatticePoints points = ReadPoints(input);
  const SeismicHorizons::Lattice grid = points.Grid;
  const BoundedHorizon horizon = ReadBoundedHorizon(input, std::move(points));
  monitor.Progress(0.1);
  Decimation decimation = Decimate(horizon, this->MakeOptions(horizon, grid), monitor.Step(0.1, 0.9));
  WriteReduction(input, grid, decimation.Points, Merging::AveragesPoints, output);
  ActivateHeight(output);
  WriteMesh(decimation, grid, output);
}
