// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonDataSet.h"

#include "ColumnPoints.h"
#include "Common/Horizon/DataModel.h"
#include "Common/Horizon/LedgerFields.h"
#include "SurveyFields.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

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
void AddFrameFields(ArrayTable& data, const LatticeFrame& frame)
{
  const SurveyLattice& lattice = frame.Lattice;
  const std::array<int, 3> dimensions = { lattice.Columns[0], lattice.Columns[1], frame.Sampling.Indices };
  AddTuple<int>(data, FieldArray::LatticeDimensions, dimensions);
  AddTuple<double>(data, FieldArray::LatticeToWorld, frame.ToWorld());
  AddValue<int>(data, FieldArray::VerticalDirection, int(frame.Direction));
  if (lattice.Lines)
  {
    const std::array<double, 4> lines = { lattice.Lines->FirstInline, lattice.Lines->InlineStep,
      lattice.Lines->FirstCrossline, lattice.Lines->CrosslineStep };
    AddTuple<double>(data, FieldArray::LineNumbers, lines);
  }
  if (frame.LatticeDeviation)
  {
    AddValue<double>(data, FieldArray::LatticeDeviation, *frame.LatticeDeviation);
  }
  AddSurveyFields(frame.Survey, data);
}

//----------------------------------------------------------------------------------------------------------------------
Horizon MakeHorizonPoints(LatticeHorizon horizon, const LatticeFrame& frame)
{
  const bool isOfVoxels = !horizon.K.empty();
  if (!isOfVoxels)
  {
    horizon.K = FindIndices(horizon.RealZ, frame.Sampling);
  }
  Horizon points;
  points.Places = MakeColumnPoints({ horizon.Column.data(), horizon.Column.size() }, frame.ToWorld(),
    [&](std::size_t point) { return frame.Elevation(horizon, point); });
  const DataArray columns = MoveToColumnArray(horizon.Column);
  ArrayTable& data = points.PointData;
  for (auto& [name, values] : horizon.Attributes)
  {
    MoveToArray<double>(data, name.c_str(), values);
  }
  for (auto& [name, values] : horizon.Labels)
  {
    MoveToArray<int>(data, name.c_str(), values);
  }
  // Attributes of the same name, added before, are replaced.
  data.Add(columns);
  AddConstant<int>(data, PointArray::SurfaceId, points.NumberOfPoints(), horizon.SurfaceId);
  MoveToArray<int>(data, PointArray::VerticalIndex, horizon.K);
  if (isOfVoxels)
  {
    MoveToArray<double>(data, PointArray::Thickness, horizon.Thickness);
    MoveToArray<double>(data, PointArray::Amplitude, horizon.Amplitude);
  }
  MoveToArray<double>(data, PointArray::RealZ, horizon.RealZ);
  data.Remove(PointArray::PointCount); // Each point represents itself, despite such an attribute.
  data.SetActiveScalars(PointArray::VerticalIndex);
  points.Vertices = MakeVertices(points.NumberOfPoints());

  AddFrameFields(points.FieldData, frame);
  AddValue<std::int64_t>(points.FieldData, FieldArray::DroppedDuplicates, std::int64_t(horizon.DroppedDuplicates));
  if (!isOfVoxels)
  {
    AddValue<std::int64_t>(points.FieldData, FieldArray::DroppedNulls, std::int64_t(horizon.DroppedNulls));
  }
  WriteLedger(CountPoints(points), points.FieldData);
  return points;
}

//----------------------------------------------------------------------------------------------------------------------
Horizon TakeHorizonPoints(SurveyHorizons& survey, const FramedSurvey& framed, std::size_t number)
{
  LatticeFrame frame = framed.Frame;
  frame.Sampling = framed.Samplings[number];
  Horizon points = MakeHorizonPoints(std::move(survey.Horizons[number]), frame);
  if (!survey.Conflicts.empty())
  {
    const ConflictCount& conflicts = survey.Conflicts[number];
    AddValue<std::int64_t>(points.FieldData, FieldArray::DroppedRepeats, conflicts.Repeats);
    AddValue<double>(points.FieldData, FieldArray::LargestConflict, conflicts.Largest);
  }
  if (!survey.IsOnLattice)
  {
    points.PointData.Remove(PointArray::Column);
    points.FieldData.Remove(FieldArray::LatticeDimensions);
    points.FieldData.Remove(FieldArray::LatticeToWorld);
    points.FieldData.Remove(FieldArray::LatticeDeviation);
    points.FieldData.Remove(FieldArray::LedgerColumns);
    points.FieldData.Remove(FieldArray::LedgerArea);
  }
  return points;
}
}
