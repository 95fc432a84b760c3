// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonReducedMesh.h"

#include "Common/Base/Parameters.h"
#include "Common/Horizon/DataModel.h"
#include "Common/Horizon/HeightNoise.h"
#include "Common/VTK/DataArrays.h"
#include "Filters/Algorithms/Decimation/Decimation.h"
#include "Filters/Marshalling/HeightUnit.h"
#include "Filters/Marshalling/HorizonCells.h"
#include "Filters/Marshalling/HorizonPoints.h"
#include "Filters/Marshalling/ReducedHorizon.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <optional>
#include <utility>

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
ErrorLimit vtkHorizonReducedMesh::FindMaximumError(
  PlanePoints columns, const std::vector<double>& height, const SeismicHorizons::Lattice& lattice) const
{
  if (this->IsErrorAutomatic())
  {
    const HeightNoise noise = MeasureHeightNoise(columns, height);
    return { noise.MaximumError(), noise };
  }
  CheckAtLeast("maximum error", this->MaximumError, 0.0, ", or -1 for automatic");
  return { this->MaximumError * IndicesPerUnit(static_cast<HeightUnit>(this->ErrorUnit), columns, height, lattice),
    std::nullopt };
}

//------------------------------------------------------------------------------
void vtkHorizonReducedMesh::WriteMesh(
  vtkPolyData* input, const SeismicHorizons::Lattice& lattice, Decimation& decimation, vtkPolyData* output)
{
  output->SetPoints(MakePoints(input, lattice, decimation.Points));
  WriteReduction(input, decimation.Points, output);
  ActivateHeight(output);
  output->SetVerts(nullptr);
  const double smallestAngle =
    WriteTriangles(decimation.Points.Plane, lattice, std::move(decimation.Triangles), output);
  AddTriangleArray<vtkDoubleArray>(CellArray::Error, decimation.Errors, output);
  vtkFieldData* const figures = output->GetFieldData();
  AddValue<vtkDoubleArray>(figures, FieldArray::LargestError, decimation.LargestError);
  AddValue<vtkDoubleArray>(figures, FieldArray::MeanError, decimation.MeanError);
  AddValue<vtkDoubleArray>(figures, FieldArray::LargestLoopError,
    std::max(decimation.LargestLoopError, FirstValue(figures, FieldArray::OutlineHeightDeviation)));
  AddValue<vtkIdTypeArray>(figures, FieldArray::TriangleCount, output->GetNumberOfPolys());
  AddValue<vtkDoubleArray>(figures, FieldArray::SmallestAngle, smallestAngle);
  AddValue<vtkIdTypeArray>(figures, FieldArray::SliverCount, vtkIdType(decimation.NumberOfSlivers));
}
