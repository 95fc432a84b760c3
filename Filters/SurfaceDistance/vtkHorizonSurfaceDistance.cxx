// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonSurfaceDistance.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Parameters.h"
#include "Common/Horizon/DataModel.h"
#include "Common/VTK/DataArrays.h"
#include "Common/VTK/PipelineRequest.h"
#include "Common/VTK/Ranks.h"
#include "Filters/Marshalling/HorizonPairs.h"
#include "Filters/Marshalling/HorizonTree.h"
#include "Filters/Marshalling/SurfacePair.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>
#include <string>
#include <vector>

namespace
{
using namespace SeismicHorizons;

constexpr int ReferencePort = 0;
constexpr int MeasuredPort = 1;
constexpr int FiguresPort = 2;
constexpr int HistogramPort = 3;

void AddArrays(PointDistances& points, double upwards, vtkPolyData* output)
{
  std::transform(points.Vertical.begin(), points.Vertical.end(), points.Vertical.begin(),
    [upwards](double distance) { return upwards * distance; });
  MoveToArray<vtkDoubleArray>(output->GetPointData(), PointArray::Distance, points.Distance);
  MoveToArray<vtkDoubleArray>(output->GetPointData(), PointArray::VerticalDistance, points.Vertical);
  output->GetPointData()->SetActiveScalars(PointArray::Distance);
}
}

vtkStandardNewMacro(vtkHorizonSurfaceDistance);

//------------------------------------------------------------------------------
vtkHorizonSurfaceDistance::vtkHorizonSurfaceDistance()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(4);
}

//------------------------------------------------------------------------------
int vtkHorizonSurfaceDistance::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port >= FiguresPort ? "vtkTable" : "vtkDataObject");
  return 1;
}

//------------------------------------------------------------------------------
int vtkHorizonSurfaceDistance::RequestDataObject(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  for (const int port : { ReferencePort, MeasuredPort }) // The executive makes the tables.
  {
    MakeOutputLike(vtkDataObject::GetData(inputVector[port], 0), outputVector->GetInformationObject(port));
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkHorizonSurfaceDistance::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* const reference = vtkDataObject::GetData(inputVector[ReferencePort], 0);
  vtkDataObject* const mesh = vtkDataObject::GetData(inputVector[MeasuredPort], 0);
  const std::vector<vtkDataObject*> outputs = ListOutputs(outputVector);
  const Ranks ranks(this->GetController(), request, outputVector);
  const auto work = [&](std::string& subject, const Monitor& monitor)
  {
    auto* const figures = vtkTable::SafeDownCast(outputs[FiguresPort]);
    auto* const histogram = vtkTable::SafeDownCast(outputs[HistogramPort]);
    MakeColumns(figures);
    MakeBinColumns(histogram);
    HorizonPairs pairs(reference, mesh, outputs[ReferencePort], outputs[MeasuredPort], ranks);
    const std::vector<HorizonPair>& own = pairs.OwnPairs();
    const auto measure = [&]()
    {
      const double size = double(own.size());
      for (std::size_t n = 0; n < own.size(); ++n)
      {
        subject = own[n].Name;
        const Monitor step = monitor.Step(double(n) / size, double(n + 1) / size);
        RunPart(this, this->GetInvalidHorizons() == LeaveOut, subject, { own[n].ReferenceOutput, own[n].MeshOutput },
          [&]() { this->MeasurePair(own[n], step); });
      }
    };
    ranks.Together(measure);
    pairs.Deliver({ figures, histogram });
  };
  return RunRequest(this, outputs, NotEnoughMemory, work, ranks);
}

//------------------------------------------------------------------------------
void vtkHorizonSurfaceDistance::MeasurePair(const HorizonPair& pair, const Monitor& monitor) const
{
  if (pair.Reference->GetNumberOfPoints() + pair.Mesh->GetNumberOfPoints() == 0)
  {
    return;
  }
  CheckWithin("samples per point", this->SamplesPerPoint, 0.01, 1000.0, "");
  CheckAtLeast("seed", this->Seed, 0, "");
  PrefixErrors("reference", [&]() { CheckArraySizes(pair.Reference); });
  PrefixErrors("mesh", [&]() { CheckArraySizes(pair.Mesh); });
  WriteReference(pair, this->Radius, monitor.Step(0.0, 0.1));
  pair.MeshOutput->ShallowCopy(pair.Mesh);
  SurfaceDistanceOptions options;
  options.SamplesPerPoint = this->SamplesPerPoint;
  options.Seed = std::uint64_t(this->Seed);
  MeasuredPair measured =
    MeasureSurfaces(pair, options, this->DistanceUnit == World, this->IncludeFilledPoints, monitor.Step(0.1, 0.95));
  AddArrays(measured.Points.Reference, measured.Upwards, pair.ReferenceOutput);
  AddArrays(measured.Points.Mesh, measured.Upwards, pair.MeshOutput);
  WriteFieldData(measured.Report, measured.Report.Surfaces[0], pair.ReferenceOutput);
  WriteFieldData(measured.Report, measured.Report.Surfaces[1], pair.MeshOutput);
  MakeColumns(pair.Rows[0]);
  AppendRows(measured.Report, pair.Name, pair.Rows[0]);
  MakeBinColumns(pair.Rows[1]);
  AppendBins(measured.Report, this->DistanceUnit == World, pair.Name, pair.Rows[1]);
}
