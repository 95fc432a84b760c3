// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonDataSet.h"

#include "ColumnPoints.h"
#include "Common/Horizon/DataModel.h"
#include "DataArrays.h"
#include "LedgerFields.h"
#include "SurveyFields.h"
#include "VertexCells.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace SeismicHorizons
{
namespace
{
HeapArray<int> FindIndices(const HeapArray<double>& realZ, const VerticalSampling& sampling)
{
  HeapArray<int> indices;
  std::transform(realZ.begin(), realZ.end(), indices.Extend(realZ.size()),
    [&sampling](double z) { return static_cast<int>(std::lround((z - sampling.First) / sampling.Step)); });
  return indices;
}
}

//----------------------------------------------------------------------------------------------------------------------
void AddFrameFields(vtkFieldData* data, const LatticeFrame& frame)
{
  const SurveyLattice& lattice = frame.Lattice;
  const std::array<int, 3> dimensions = { lattice.Columns[0], lattice.Columns[1], frame.Sampling.Indices };
  AddTuple<vtkIntArray>(data, FieldArray::LatticeDimensions, dimensions);
  AddTuple<vtkDoubleArray>(data, FieldArray::LatticeToWorld, frame.ToWorld());
  AddValue<vtkIntArray>(data, FieldArray::VerticalDirection, static_cast<int>(frame.Direction));
  if (lattice.Lines)
  {
    const std::array<double, 4> lines = { lattice.Lines->FirstInline, lattice.Lines->InlineStep,
      lattice.Lines->FirstCrossline, lattice.Lines->CrosslineStep };
    AddTuple<vtkDoubleArray>(data, FieldArray::LineNumbers, lines);
  }
  if (frame.LatticeDeviation)
  {
    AddValue<vtkDoubleArray>(data, FieldArray::LatticeDeviation, *frame.LatticeDeviation);
  }
  AddSurveyFields(frame.Survey, data);
}

//----------------------------------------------------------------------------------------------------------------------
void PlaceImage(vtkImageData* image, const ImageFrame& frame)
{
  image->SetOrigin(frame.Origin.data());
  image->SetSpacing(frame.Spacing.data());
  image->SetDirectionMatrix(frame.Direction.data());
}

//----------------------------------------------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeHorizonPoints(LatticeHorizon horizon, const LatticeFrame& frame)
{
  const bool isOfVoxels = !horizon.K.empty();
  if (!isOfVoxels)
  {
    horizon.K = FindIndices(horizon.RealZ, frame.Sampling);
  }
  auto points = vtkSmartPointer<vtkPolyData>::New();
  points->SetPoints(MakeColumnPoints({ horizon.Column.data(), horizon.Column.size() }, frame.ToWorld(),
    [&](std::size_t point) { return frame.Elevation(horizon, point); }));
  const auto columns = MoveToColumnArray(horizon.Column);

  const vtkIdType numberOfPoints = points->GetNumberOfPoints();
  vtkPointData* const data = points->GetPointData();
  for (auto& [name, values] : horizon.Attributes)
  {
    MoveToArray<vtkDoubleArray>(data, name.c_str(), values);
  }
  // Attributes of the same name, added before, are replaced.
  data->AddArray(columns);
  AddConstant<vtkIntArray>(data, PointArray::SurfaceId, numberOfPoints, horizon.SurfaceId);
  MoveToArray<vtkIntArray>(data, PointArray::VerticalIndex, horizon.K);
  if (isOfVoxels)
  {
    MoveToArray<vtkDoubleArray>(data, PointArray::Thickness, horizon.Thickness);
    MoveToArray<vtkDoubleArray>(data, PointArray::Amplitude, horizon.Amplitude);
  }
  MoveToArray<vtkDoubleArray>(data, PointArray::RealZ, horizon.RealZ);
  data->RemoveArray(PointArray::PointCount); // Each point represents itself, despite such an attribute.
  data->SetActiveScalars(PointArray::VerticalIndex);
  points->SetVerts(MakeVertices(numberOfPoints));

  AddFrameFields(points->GetFieldData(), frame);
  AddValue<vtkIdTypeArray>(
    points->GetFieldData(), FieldArray::DroppedDuplicates, static_cast<vtkIdType>(horizon.DroppedDuplicates));
  if (!isOfVoxels)
  {
    AddValue<vtkIdTypeArray>(
      points->GetFieldData(), FieldArray::DroppedNulls, static_cast<vtkIdType>(horizon.DroppedNulls));
  }
  WriteLedger(CountPoints(points), points->GetFieldData());
  return points;
}
}
