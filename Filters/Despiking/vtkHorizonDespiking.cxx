// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonDespiking.h"

#include "Common/Base/Parameters.h"
#include "Common/Horizon/DataModel.h"
#include "Common/Horizon/KeptPoints.h"
#include "Common/VTK/DataArrays.h"
#include "Common/VTK/SurveyFields.h"
#include "Common/VTK/VertexCells.h"
#include "Filters/Algorithms/Despiking/Despiking.h"
#include "Filters/Marshalling/HeightUnit.h"
#include "Filters/Marshalling/HorizonData.h"
#include "Filters/Marshalling/HorizonPoints.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using namespace SeismicHorizons;

namespace
{
constexpr double FewPercent = 2.0; // percent of points; picks of a tracker have fewer spikes
}

vtkStandardNewMacro(vtkHorizonDespiking);

//------------------------------------------------------------------------------
int vtkHorizonDespiking::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->NumberOfSpikes = 0;
  this->NumberOfSpurPoints = 0;
  return this->Superclass::RequestData(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
void vtkHorizonDespiking::ProcessHorizon(vtkPolyData* horizon, const Outputs& outputs, const Monitor& monitor)
{
  const LatticePoints points = ReadColumns(WithoutHiddenPoints(horizon), outputs);
  vtkPolyData* const input = points.Horizon;
  monitor.Progress(0.2);
  CheckAtLeast("threshold", this->Threshold, 0.0, "");
  const double threshold = this->Threshold *
    IndicesPerUnit(static_cast<HeightUnit>(this->ThresholdUnit), points.Column, points.Height, points.Lattice);
  const Spikes found = FindSpikes(
    points.Column, points.Height, { threshold, this->NeighborhoodRadius, this->SpurWidth }, monitor.Step(0.2, 0.9));
  const std::vector<SpikeKind>& kinds = found.Kind;
  vtkPolyData* const output = outputs.front();
  if (this->Action == Remove)
  {
    const auto isOther = [&kinds](std::size_t point) { return kinds[point] == SpikeKind::None; };
    CopyPoints(input, KeptPoints::If(kinds.size(), isOther), output);
  }
  else
  {
    output->SetPoints(input->GetPoints());
    output->GetPointData()->PassData(input->GetPointData());
    output->SetVerts(MakeVertices(output->GetNumberOfPoints()));
    AddArray<vtkUnsignedCharArray>(output->GetPointData(), PointArray::Spike, kinds,
      [](SpikeKind kind) { return static_cast<unsigned char>(kind); });
  }
  output->GetPointData()->RemoveArray(PointArray::PatchId);
  output->GetPointData()->RemoveArray(PointArray::Boundary);
  const vtkIdType spikes = std::count(kinds.begin(), kinds.end(), SpikeKind::Spike);
  const vtkIdType spurs = std::count(kinds.begin(), kinds.end(), SpikeKind::Spur);
  AddValue<vtkIdTypeArray>(output->GetFieldData(), FieldArray::NumberOfSpikes, spikes);
  AddValue<vtkIdTypeArray>(output->GetFieldData(), FieldArray::NumberOfSpurPoints, spurs);
  AddValue<vtkDoubleArray>(output->GetFieldData(), FieldArray::SpikeThreshold, found.Threshold);
  const double percent = 100.0 * double(spikes) / double(kinds.size());
  if (percent > FewPercent)
  {
    const std::string unit = ReadSurveyFields(input->GetFieldData()).VerticalUnit;
    std::ostringstream text;
    text << spikes << " of " << kinds.size() << " points are spikes, expected at most " << FewPercent
         << " %: threshold " << found.Threshold << " vertical indices, "
         << found.Threshold * WorldPerIndex(points.Lattice) << ' ' << (unit.empty() ? "in z" : unit)
         << "; terrain and faults may be mistaken for spikes";
    this->Warn(text.str());
  }
  if (2 * spurs > vtkIdType(kinds.size()))
  {
    this->Warn(std::to_string(spurs) + " of " + std::to_string(kinds.size()) +
      " points are on spurs, expected less than half: picks of every second line, or with many holes, look like spurs");
  }
  this->NumberOfSpikes += spikes;
  this->NumberOfSpurPoints += spurs;
}
