// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "DecimationOutput.h"

#include "Common/Base/Parameters.h"
#include "Common/Horizon/DataModel.h"
#include "Common/Horizon/PlaneGeometry.h"
#include "Common/VTK/DataArrays.h"
#include "Filters/Marshalling/HorizonCells.h"
#include "Filters/Marshalling/HorizonPoints.h"
#include "Filters/Marshalling/ReducedHorizon.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace SeismicHorizons
{
namespace
{
void WriteMesh(Decimation& decimation, const Lattice& lattice, vtkPolyData* output)
{
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
}

//----------------------------------------------------------------------------------------------------------------------
void WriteDecimation(vtkPolyData* input, const Lattice& lattice, Decimation& decimation, vtkPolyData* output)
{
  output->SetPoints(MakePoints(input, lattice, decimation.Points));
  WriteReduction(input, decimation.Points, output);
  ActivateHeight(output);
  WriteMesh(decimation, lattice, output);
}
}
