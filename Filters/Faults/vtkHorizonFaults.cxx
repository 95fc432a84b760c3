// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonFaults.h"

#include "Common/Horizon/DataModel.h"
#include "Common/VTK/DataArrays.h"
#include "FaultPolyData.h"
#include "Filters/Algorithms/Despiking/Despiking.h"
#include "Filters/Algorithms/Faults/FaultDetection.h"
#include "Filters/Algorithms/Faults/FaultLines.h"
#include "Filters/Algorithms/Faults/FaultPolygons.h"
#include "Filters/Marshalling/CutData.h"
#include "Filters/Marshalling/HeightUnit.h"
#include "Filters/Marshalling/HorizonPoints.h"
#include "Filters/Marshalling/LatticePoints.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

using namespace SeismicHorizons;

namespace
{
constexpr int LinesPort = 1;

/// Terrain and tracking leave steps of a few times the noise, so that throws must be larger. Differences of heights have
/// sqrt(2) times the noise of heights.
double ThrowAboveNoise(const LatticePoints& points, double noiseOfDifferences)
{
  constexpr double factor = 8.0;
  return factor *
    (noiseOfDifferences > 0.0 ? noiseOfDifferences / std::sqrt(2.0) : MeasureNoise(points.Column, points.Height));
}
}

vtkStandardNewMacro(vtkHorizonFaults);

//------------------------------------------------------------------------------
vtkHorizonFaults::vtkHorizonFaults()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(3);
}

//------------------------------------------------------------------------------
FaultDetectionOptions vtkHorizonFaults::MakeOptions() const
{
  FaultDetectionOptions options;
  options.SmallestThrow = this->SmallestThrow;
  options.Noise = this->Noise;
  options.SmallestExtent = this->SmallestExtent;
  options.SmallestBranch = this->SmallestBranch;
  options.LargestGap = this->LargestGap;
  options.LargestRamp = this->LargestRamp;
  options.JoinThroughHoles = this->JoinThroughHoles;
  return options;
}

//------------------------------------------------------------------------------
int vtkHorizonFaults::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->MeasuredNoise = 0.0;
  this->NumberOfFaultLines = 0;
  this->NumberOfFaultedLinks = 0;
  this->NumberOfGivenLines = 0;
  this->DoesGivenLineCut = false;
  const int result = this->Superclass::RequestData(request, inputVector, outputVector);
  if (this->NumberOfGivenLines > 0 && !this->DoesGivenLineCut)
  {
    vtkWarningMacro("none of " << this->NumberOfGivenLines
                               << " fault polylines passes between columns of a horizon, expected lines in the "
                                  "coordinates of its points");
  }
  return result;
}

//------------------------------------------------------------------------------
void vtkHorizonFaults::UsePolygons(std::vector<FaultPolyline>& polylines, LatticePoints& points, const Outputs& outputs)
{
  if (this->Polygons == Leave)
  {
    polylines.erase(std::remove_if(polylines.begin(), polylines.end(), IsClosed), polylines.end());
  }
  if (this->Polygons != Blank)
  {
    return;
  }
  const KeptPoints outside = FindOutside(points.Column, polylines);
  const std::size_t inside = points.Height.size() - outside.size();
  AddValue<vtkIdTypeArray>(outputs[0]->GetFieldData(), FieldArray::BlankedPoints, vtkIdType(inside));
  if (outside.empty())
  {
    throw InputError("fault polygons enclose all " + std::to_string(inside) + " points, expected some outside");
  }
  if (inside > 0)
  {
    this->DoesGivenLineCut = true;
    vtkNew<vtkPolyData> rest;
    CopyPoints(points.Horizon, outside, rest);
    rest->GetFieldData()->PassData(points.Horizon->GetFieldData());
    points = ReadColumns(rest, outputs);
  }
}

//------------------------------------------------------------------------------
void vtkHorizonFaults::ProcessHorizon(vtkPolyData* horizon, const Outputs& outputs, const Monitor& monitor)
{
  FaultDetectionOptions options = this->MakeOptions();
  CheckOptions(options);
  LatticePoints points = ReadColumns(WithoutHiddenPoints(horizon), outputs);
  vtkPolyData* const output = outputs[0];
  std::vector<FaultPolyline> polylines;
  vtkIdType givenLines = 0;
  if (vtkDataObject* const given = this->GetInputDataObject(LinesPort, 0))
  {
    const bool isFirst = this->NumberOfGivenLines == 0;
    const std::vector<FaultStick> lines = ReadPolylines(given);
    givenLines = vtkIdType(lines.size());
    if (this->LineType == Sticks)
    {
      std::vector<FaultSheet> sheets = MakeFaultSheets(lines, this->ExtendSticks);
      if (isFirst) // All horizons have the same fault surfaces.
      {
        WriteFaultSheets(sheets, outputs[2]);
      }
      ToLattice(sheets, points.Lattice);
      polylines = FindTraces(ColumnHeights(points.Column, points.Height), sheets);
    }
    else
    {
      polylines = ToMap(lines, points.Lattice);
      this->UsePolygons(polylines, points, outputs);
    }
  }
  const double indices =
    IndicesPerUnit(static_cast<HeightUnit>(this->ThrowUnit), points.Column, points.Height, points.Lattice);
  options.Noise *= indices;
  options.SmallestThrow =
    this->SmallestThrow > 0.0 ? this->SmallestThrow * indices : ThrowAboveNoise(points, options.Noise);
  const ColumnHeights heights(points.Column, points.Height);
  monitor.Progress(0.2);
  FaultLines lines = CutAlong(heights, polylines);
  this->NumberOfGivenLines = givenLines;
  this->DoesGivenLineCut = this->DoesGivenLineCut || lines.Size() > 0;
  vtkNew<vtkFieldData> figures; // These include figures from ReadColumns.
  figures->ShallowCopy(output->GetFieldData());
  output->ShallowCopy(points.Horizon);
  output->SetFieldData(figures);
  if (this->Detect)
  {
    const FaultDetection detection = DetectFaults(heights, options, monitor.Step(0.2, 0.95));
    lines.Append(detection.Lines);
    this->MeasuredNoise = std::max(this->MeasuredNoise, detection.Noise);
    AddValue<vtkDoubleArray>(output->GetFieldData(), FieldArray::FaultNoise, detection.Noise);
    AddValue<vtkDoubleArray>(output->GetFieldData(), FieldArray::SmallestFaultThrow, detection.High);
  }
  WriteCuts(lines, output->GetFieldData());
  const double sum = std::accumulate(points.Height.begin(), points.Height.end(), 0.0);
  WriteFaultLines(lines, points.Lattice, sum / double(points.Height.size()), outputs[1]);
  this->NumberOfFaultLines += vtkIdType(lines.Size());
  this->NumberOfFaultedLinks += output->GetFieldData()->GetAbstractArray(FieldArray::FaultedLinks)->GetNumberOfTuples();
}
