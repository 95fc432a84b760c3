// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonDespiking.h"

#include "Common/DataModel.h"
#include "Common/KeptPoints.h"
#include "Common/VTK/DataArrays.h"
#include "Common/VTK/VertexCells.h"
#include "Despiking/Despiking.h"
#include "Marshalling/HorizonData.h"
#include "Marshalling/HorizonPoints.h"

#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <utility>
#include <vector>

using namespace SeismicHorizons;

namespace
{
/// The points of the input that are neither spikes nor on threads.
void CopyOthers(vtkPolyData* input, const std::vector<SpikeKind>& kinds, vtkPolyData* output)
{
  KeptPoints kept(kinds.size());
  for (std::size_t point = 0; point < kinds.size(); ++point)
  {
    if (kinds[point] == SpikeKind::None)
    {
      kept.Append(PointId(point));
    }
  }
  CopyPoints(input, kept, output);
}
}

vtkStandardNewMacro(vtkHorizonDespiking);

//------------------------------------------------------------------------------
void vtkHorizonDespiking::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Action: " << (this->Action == Remove ? "Remove" : "Flag") << "\n";
  os << indent << "Threshold: " << this->Threshold << "\n";
  os << indent << "NeighborhoodRadius: " << this->NeighborhoodRadius << "\n";
  os << indent << "ThreadWidth: " << this->ThreadWidth << "\n";
  os << indent << "NumberOfSpikes: " << this->NumberOfSpikes << "\n";
  os << indent << "NumberOfThreadPoints: " << this->NumberOfThreadPoints << "\n";
}

//------------------------------------------------------------------------------
int vtkHorizonDespiking::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->NumberOfSpikes = 0;
  this->NumberOfThreadPoints = 0;
  return this->Superclass::RequestData(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
void vtkHorizonDespiking::ProcessHorizon(vtkPolyData* horizon, const Outputs& outputs, const Monitor& monitor)
{
  const LatticePoints points = ReadColumns(WithoutHiddenPoints(horizon), outputs);
  vtkPolyData* const input = points.Horizon;
  monitor.Progress(0.2);
  const std::vector<SpikeKind> kinds = FindSpikes(points.Column, points.Height,
    { this->Threshold, this->NeighborhoodRadius, this->ThreadWidth }, monitor.Step(0.2, 0.9));
  vtkPolyData* const output = outputs.front();
  if (this->Action == Remove)
  {
    CopyOthers(input, kinds, output);
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
  const vtkIdType threads = std::count(kinds.begin(), kinds.end(), SpikeKind::Thread);
  AddValue<vtkIdTypeArray>(output->GetFieldData(), FieldArray::NumberOfSpikes, spikes);
  AddValue<vtkIdTypeArray>(output->GetFieldData(), FieldArray::NumberOfThreadPoints, threads);
  this->NumberOfSpikes += spikes;
  this->NumberOfThreadPoints += threads;
}
