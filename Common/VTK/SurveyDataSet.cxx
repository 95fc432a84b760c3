// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SurveyDataSet.h"

#include "ColumnPoints.h"
#include "Common/DataModel.h"
#include "DataArrays.h"
#include "SurveyFields.h"
#include "VertexCells.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <array>
#include <cmath>

namespace SeismicHorizons
{
namespace
{
void AddFields(vtkFieldData* data, const LatticeHorizon& horizon, const SurveyAxes& axes)
{
  AddSurveyAxes(axes, data);
  AddValue<vtkIdTypeArray>(data, FieldArray::DroppedDuplicates, static_cast<vtkIdType>(horizon.DroppedDuplicates));
  AddValue<vtkIdTypeArray>(data, FieldArray::DroppedNulls, static_cast<vtkIdType>(horizon.DroppedNulls));
}
}

//----------------------------------------------------------------------------------------------------------------------
LatticeMatrix SurveyAxes::ToWorld() const
{
  LatticePlacement placement;
  const double first = static_cast<int>(this->Direction) * this->Sampling.First;
  placement.Origin = Eigen::Vector3d(this->Lattice.Origin.x(), this->Lattice.Origin.y(), first);
  placement.ColumnStep = this->Lattice.ColumnStep;
  placement.RowStep = this->Lattice.RowStep;
  placement.VerticalStep = this->Sampling.Step;
  placement.Direction = this->Direction;
  return placement.ToWorld();
}

//----------------------------------------------------------------------------------------------------------------------
void AddSurveyAxes(const SurveyAxes& axes, vtkFieldData* data)
{
  const SurveyLattice& lattice = axes.Lattice;
  const std::array<int, 3> dimensions = { lattice.Columns[0], lattice.Columns[1], axes.Sampling.Indices };
  AddTuple<vtkIntArray>(data, FieldArray::LatticeDimensions, dimensions);
  AddTuple<vtkDoubleArray>(data, FieldArray::LatticeToWorld, axes.ToWorld());
  AddValue<vtkIntArray>(data, FieldArray::VerticalDirection, static_cast<int>(axes.Direction));
  if (lattice.Lines)
  {
    const std::array<double, 4> lines = { lattice.Lines->FirstInline, lattice.Lines->InlineStep,
      lattice.Lines->FirstCrossline, lattice.Lines->CrosslineStep };
    AddTuple<vtkDoubleArray>(data, FieldArray::LineNumbers, lines);
  }
  AddValue<vtkDoubleArray>(data, FieldArray::LatticeDeviation, axes.LatticeDeviation);
  AddSurveyFields(axes.Survey, data);
}

//----------------------------------------------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeSurveyPoints(LatticeHorizon horizon, int surfaceId, const SurveyAxes& axes)
{
  auto points = vtkSmartPointer<vtkPolyData>::New();
  const int sign = static_cast<int>(axes.Direction);
  points->SetPoints(
    MakeColumnPoints(horizon.Column, axes.ToWorld(), [&](std::size_t point) { return sign * horizon.Z[point]; }));
  const auto columns = MoveToColumnArray(horizon.Column);

  const vtkIdType numberOfPoints = points->GetNumberOfPoints();
  vtkPointData* const data = points->GetPointData();
  const VerticalSampling& sampling = axes.Sampling;
  for (PickAttribute& attribute : horizon.Attributes)
  {
    MoveToArray<vtkDoubleArray>(data, attribute.Name.c_str(), attribute.Values);
  }
  // After the attributes, so that none of them takes the place of one of these.
  data->AddArray(columns);
  AddConstant<vtkIntArray>(data, PointArray::SurfaceId, numberOfPoints, surfaceId);
  AddArray<vtkIntArray>(data, PointArray::VerticalIndex, horizon.Z,
    [&sampling](double z) { return static_cast<int>(std::lround((z - sampling.First) / sampling.Step)); });
  MoveToArray<vtkDoubleArray>(data, PointArray::RealZ, horizon.Z);
  data->RemoveArray(PointArray::PointCount); // each point stands for one, whatever an attribute of that name says
  data->SetActiveScalars(PointArray::VerticalIndex); // what ParaView colours by at first
  points->SetVerts(MakeVertices(numberOfPoints));
  AddFields(points->GetFieldData(), horizon, axes);
  return points;
}
}
