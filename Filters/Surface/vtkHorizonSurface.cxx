// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonSurface.h"

#include "Common/Horizon/HeightNoise.h"
#include "Common/VTK/HorizonConversion.h"
#include "Common/VTK/HorizonTree.h"
#include "Common/VTK/PipelineRequest.h"
#include "Filters/Algorithms/Surface/Surface.h"
#include "Filters/Common/HorizonPoints.h"
#include "Filters/Common/LatticePoints.h"
#include "SurfaceStage.h"

#include "vtkFieldData.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <optional>
#include <string>

using namespace SeismicHorizons;

namespace
{
template <typename Value, typename Given>
std::optional<Value> UnlessAutomatic(bool isAutomatic, Given value)
{
  return isAutomatic ? std::nullopt : std::optional<Value>(value);
}
}

vtkStandardNewMacro(vtkHorizonSurface);

//------------------------------------------------------------------------------
vtkHorizonSurface::vtkHorizonSurface()
{
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
void vtkHorizonSurface::Choose(vtkPolyData* horizon, const std::function<void(const LatticePoints&)>& choose)
{
  RunRequest(this, {}, NotEnoughMemory,
    [&](std::string&, const Monitor&)
    {
      if (horizon && horizon->GetNumberOfPoints() > 0)
      {
        const Horizon points = FromVTK(horizon);
        CheckArraySizes(points);
        choose(ReadColumns(WithoutHiddenPoints(points)));
      }
    });
}

//------------------------------------------------------------------------------
int vtkHorizonSurface::ChooseRadius(vtkPolyData* horizon)
{
  int radius = 0;
  this->Choose(horizon, [&](const LatticePoints& points) { radius = SeismicHorizons::ChooseRadius(points.Column); });
  return radius;
}

//------------------------------------------------------------------------------
double vtkHorizonSurface::ChooseMaximumError(vtkPolyData* horizon, vtkFieldData* figures)
{
  HeightNoise noise;
  this->Choose(horizon, [&](const LatticePoints& points) { noise = MeasureHeightNoise(points.Column, points.Height); });
  if (figures)
  {
    ArrayTable measured;
    WriteHeightNoise(noise, measured);
    ToVTK(measured, figures);
  }
  return noise.MaximumError();
}

//------------------------------------------------------------------------------
void vtkHorizonSurface::ProcessHorizon(const Horizon& horizon, Outputs& outputs, const Monitor& monitor)
{
  SurfaceStageOptions options;
  static_cast<ReducedMeshOptions&>(options) = this->MakeMeshOptions(this->Target == LargestError);
  if (this->Target == NumberOfTriangles)
  {
    options.MaximumNumberOfTriangles = this->MaximumNumberOfTriangles;
  }
  options.Radius = UnlessAutomatic<int>(this->AutomaticRadius, this->Radius);
  options.Growth = static_cast<SeismicHorizons::GrowthStrategy>(this->GrowthStrategy);
  options.KeepHoles = this->KeepHoles;
  options.TearAtFaults = this->TearAtFaults;
  options.SmallestHoleSize = UnlessAutomatic<std::int64_t>(this->AutomaticSmallestHoleSize, this->SmallestHoleSize);
  options.MinimumPatchSize = this->MinimumPatchSize;
  options.OutlineTolerance = UnlessAutomatic<double>(this->AutomaticOutlineTolerance, this->OutlineTolerance);
  options.DistanceThreshold = UnlessAutomatic<double>(this->AutomaticDistanceThreshold, this->DistanceThreshold);
  this->Warn(RunSurface(horizon, options, outputs, monitor));
}
