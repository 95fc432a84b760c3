// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonSurface.h"

#include "SurfaceStage.h"

#include "vtkObjectFactory.h"

#include <optional>

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
