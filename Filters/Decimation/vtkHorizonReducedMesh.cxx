// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonReducedMesh.h"

#include "Common/Base/Parameters.h"
#include "Common/Horizon/HeightNoise.h"
#include "Filters/Algorithms/Decimation/Decimation.h"
#include "Filters/Marshalling/HeightUnit.h"

using namespace SeismicHorizons;

//------------------------------------------------------------------------------
DecimationQuality vtkHorizonReducedMesh::MakeQuality() const
{
  DecimationQuality quality;
  quality.FitHeights = this->FitHeights;
  quality.Effort = this->Effort == Fast ? DecimationEffort::Fast : DecimationEffort::Best;
  quality.Priority =
    this->Priority == LargestErrors ? DecimationPriority::LargestError : DecimationPriority::SumOfSquares;
  quality.SmallestAngle = this->SmallestAngle;
  return quality;
}

//------------------------------------------------------------------------------
bool vtkHorizonReducedMesh::IsErrorAutomatic() const
{
  return this->MaximumError == AutomaticError;
}

//------------------------------------------------------------------------------
double vtkHorizonReducedMesh::FindMaximumError(PlanePoints columns, const std::vector<double>& height,
  const SeismicHorizons::Lattice& lattice, vtkFieldData* figures) const
{
  if (this->IsErrorAutomatic())
  {
    const HeightNoise noise = MeasureHeightNoise(columns, height);
    WriteHeightNoise(noise, figures);
    return noise.MaximumError();
  }
  CheckAtLeast("maximum error", this->MaximumError, 0.0, ", or -1 for automatic");
  return this->MaximumError * IndicesPerUnit(static_cast<HeightUnit>(this->ErrorUnit), columns, height, lattice);
}
