// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonHoleFilling.h"

#include "Common/Base/Parameters.h"
#include "Common/Horizon/DataModel.h"
#include "Common/VTK/DataArrays.h"
#include "FilledHorizon.h"
#include "Filters/Algorithms/HoleFilling/HoleFilling.h"
#include "Filters/Marshalling/CutData.h"
#include "Filters/Marshalling/HorizonData.h"
#include "Filters/Marshalling/HorizonPoints.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

using namespace SeismicHorizons;

vtkStandardNewMacro(vtkHorizonHoleFilling);

//------------------------------------------------------------------------------
HoleFillingOptions vtkHorizonHoleFilling::MakeOptions(double columnArea) const
{
  CheckAtLeast<vtkIdType>("largest hole size", this->LargestHoleSize, 1, " column");
  CheckAtLeast("largest hole area", this->LargestHoleArea, 0.0, " square units of the world");
  HoleFillingOptions options;
  options.LargestHoleSize = this->LargestHoleSize;
  // Areas are often whole multiples of a column's area. The quotient may fall short of the whole number by a few
  // roundings (1e-16 each), which must not leave a hole open.
  constexpr double rounding = 1e-12;
  const double columns = std::floor(this->LargestHoleArea / columnArea * (1.0 + rounding));
  if (this->LargestHoleArea > 0.0 && columns < double(this->LargestHoleSize))
  {
    options.LargestHoleSize = std::int64_t(columns);
  }
  options.Method = static_cast<FillMethod>(this->Method);
  options.RimSmoothing = this->RimSmoothing;
  options.RimWidth = this->RimWidth;
  options.ExtrapolationDistance = this->ExtrapolationDistance;
  return options;
}

//------------------------------------------------------------------------------
int vtkHorizonHoleFilling::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->NumberOfFilledHoles = 0;
  this->NumberOfFilledPoints = 0;
  this->NumberOfOpenHoles = 0;
  return this->Superclass::RequestData(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
void vtkHorizonHoleFilling::ProcessHorizon(vtkPolyData* horizon, const Outputs& outputs, const Monitor& monitor)
{
  const LatticePoints points = ReadColumns(WithoutHiddenPoints(horizon), outputs);
  vtkPolyData* const input = points.Horizon;
  HoleFillingOptions options = this->MakeOptions(points.Lattice.ColumnArea());
  const std::array<int, 3> size = ReadLatticeDimensions(input);
  options.Survey = PlaneBox({ { 0, 0 }, { size[0] - 1, size[1] - 1 } });
  const std::vector<FilledArray> arrays = ListFilledArrays(input, points.Height, this->Attributes == FromRim);
  const std::optional<LinkCuts> cuts = FindCuts(input, PlaneBox(points.Column));
  monitor.Progress(0.2);
  const FilledColumns filled = FillHoles(points.Column, points.Height, ListFilledValues(arrays, points.Height), options,
    cuts ? &*cuts : nullptr, monitor.Step(0.2, 0.9));
  WriteFilledHorizon(input, points.Lattice, arrays, filled, outputs.front());
  if (this->Method == Automatic)
  {
    AddValue<vtkDoubleArray>(outputs.front()->GetFieldData(), FieldArray::RimSmoothing, filled.RimSmoothing);
    AddValue<vtkIdTypeArray>(outputs.front()->GetFieldData(), FieldArray::RimWidth, vtkIdType(filled.RimWidth));
  }
  this->NumberOfFilledHoles += vtkIdType(filled.FilledGaps);
  this->NumberOfFilledPoints += vtkIdType(filled.Column.size());
  this->NumberOfOpenHoles += vtkIdType(filled.OpenGaps);
}
