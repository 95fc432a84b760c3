// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonDecimation.h"

#include "Common/Base/Parameters.h"
#include "Common/Horizon/DataModel.h"
#include "Common/VTK/DataArrays.h"
#include "Filters/Algorithms/Decimation/Decimation.h"
#include "Filters/Marshalling/CrackData.h"
#include "Filters/Marshalling/CutData.h"
#include "Filters/Marshalling/HeightUnit.h"
#include "Filters/Marshalling/HorizonData.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <utility>

using namespace SeismicHorizons;

vtkStandardNewMacro(vtkHorizonDecimation);

//------------------------------------------------------------------------------
DecimationOptions vtkHorizonDecimation::MakeOptions(const BoundedHorizon& horizon, const ErrorLimit& limit) const
{
  DecimationOptions options;
  static_cast<DecimationQuality&>(options) = this->MakeQuality();
  options.MaximumError = limit.Indices;
  if (this->Target == NumberOfPoints)
  {
    CheckAtLeast("maximum number of points", this->MaximumNumberOfPoints, 1, "");
    options.MaximumNumberOfPoints = std::size_t(this->MaximumNumberOfPoints);
  }
  else if (this->Target == Reduction)
  {
    CheckWithin("target reduction", this->TargetReduction, 0.0, 1.0, " of the points");
    const double points = std::ceil((1.0 - this->TargetReduction) * double(horizon.Columns.size()));
    options.MaximumNumberOfPoints =
      std::max({ std::size_t(points), std::size_t(1), horizon.Boundary.CountPoints(horizon.Columns.size()) });
  }
  return options;
}

//------------------------------------------------------------------------------
void vtkHorizonDecimation::ProcessHorizon(vtkPolyData* horizon, const Outputs& outputs, const Monitor& monitor)
{
  RequireAllPoints(horizon);
  LatticePoints points = ReadColumns(horizon, outputs);
  const SeismicHorizons::Lattice& lattice = points.Lattice;
  BoundedHorizon bounded;
  bounded.Columns = points.Column;
  bounded.Patch = ReadPatches(points.Horizon);
  bounded.Boundary = ReadBoundary(points.Horizon);
  bounded.Height = std::move(points.Height);
  bounded.Cuts = ShareCuts(points.Horizon, PlaneBox(points.Column));
  ReadCounts(points.Horizon); // Invalid counts are refused before the work.
  monitor.Progress(0.1);
  const ErrorLimit limit =
    this->Target == LargestError ? this->FindMaximumError(bounded.Columns, bounded.Height, lattice) : ErrorLimit();
  const DecimationOptions options = this->MakeOptions(bounded, limit);
  Decimation decimation = Decimate(std::move(bounded), options, monitor.Step(0.1, 0.9));
  WriteMesh(points.Horizon, lattice, decimation, outputs.front());
  if (limit.Noise)
  {
    AddValue<vtkDoubleArray>(outputs.front()->GetFieldData(), FieldArray::ChosenMaximumError, limit.Indices);
    WriteHeightNoise(*limit.Noise, outputs.front()->GetFieldData());
  }
  if (this->GetCloseFaults())
  {
    const auto& vertices = decimation.Points;
    CloseMesh(vertices.Plane, lattice, vertices.Boundary, outputs.front(), monitor.Step(0.95, 1.0));
  }
}
