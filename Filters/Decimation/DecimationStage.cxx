// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "DecimationStage.h"

#include "Common/Base/Parameters.h"
#include "Common/Horizon/BoundedHorizon.h"
#include "Common/Horizon/DataModel.h"
#include "Filters/Common/CrackData.h"
#include "Filters/Common/CutData.h"
#include "Filters/Common/HorizonCells.h"
#include "Filters/Common/HorizonData.h"
#include "Filters/Common/HorizonPoints.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace SeismicHorizons
{
namespace
{
DecimationOptions MakeDecimationOptions(
  const BoundedHorizon& horizon, const DecimationStageOptions& given, const ErrorLimit& limit)
{
  DecimationOptions options;
  static_cast<DecimationQuality&>(options) = given;
  options.MaximumError = limit.Indices;
  if (given.Target == DecimationTarget::NumberOfPoints)
  {
    CheckAtLeast<std::int64_t>("maximum number of points", given.MaximumNumberOfPoints, 1, "");
    options.MaximumNumberOfPoints = std::size_t(given.MaximumNumberOfPoints);
  }
  else if (given.Target == DecimationTarget::Reduction)
  {
    CheckWithin("target reduction", given.TargetReduction, 0.0, 1.0, " of the points");
    const double points = std::ceil((1.0 - given.TargetReduction) * double(horizon.Columns.size()));
    options.MaximumNumberOfPoints =
      std::max({ std::size_t(points), std::size_t(1), horizon.Boundary.CountPoints(horizon.Columns.size()) });
  }
  return options;
}

void WriteTrianglesAndFigures(const Lattice& lattice, Decimation& decimation, Horizon& output)
{
  ActivateHeight(output);
  output.Vertices = Cells();
  const double smallestAngle =
    WriteTriangles(decimation.Points.Plane, lattice, std::move(decimation.Triangles), output);
  AddTriangleArray<double>(CellArray::Error, decimation.Errors, output);
  ArrayTable& figures = output.FieldData;
  AddValue<double>(figures, FieldArray::LargestError, decimation.LargestError);
  AddValue<double>(figures, FieldArray::MeanError, decimation.MeanError);
  AddValue<double>(figures, FieldArray::LargestEdgeError, decimation.LargestEdgeError);
  AddValue<double>(figures, FieldArray::LargestLoopError,
    std::max(decimation.LargestLoopError, FirstValue(figures, FieldArray::OutlineHeightDeviation)));
  AddValue<std::int64_t>(figures, FieldArray::TriangleCount, output.Polygons.Size());
  AddValue<double>(figures, FieldArray::SmallestAngle, smallestAngle);
  AddValue<std::int64_t>(figures, FieldArray::SliverCount, std::int64_t(decimation.NumberOfSlivers));
}
}

//----------------------------------------------------------------------------------------------------------------------
void RunDecimation(
  const Horizon& horizon, const DecimationStageOptions& given, std::vector<Horizon>& outputs, const Monitor& monitor)
{
  RequireAllPoints(horizon);
  LatticePoints points = ReadColumns(horizon);
  WriteDeviation(points, outputs);
  Horizon& output = outputs.front();
  BoundedHorizon bounded;
  bounded.Columns = points.Column;
  bounded.Patch = ReadPatches(points.Horizon);
  bounded.Boundary = ReadBoundary(points.Horizon);
  bounded.Height = std::move(points.Height);
  bounded.Cuts = ShareCuts(points.Horizon, PlaneBox(points.Column));
  ReadCounts(points.Horizon); // Invalid counts are refused before the work.
  monitor.Progress(0.1);
  const ErrorLimit limit = given.Target == DecimationTarget::LargestError
    ? FindMaximumError(given, bounded.Columns, bounded.Height, points.Lattice)
    : ErrorLimit();
  const DecimationOptions options = MakeDecimationOptions(bounded, given, limit);
  Decimation decimation = Decimate(std::move(bounded), options, monitor.Step(0.1, 0.9));
  WriteMesh(points.Horizon, points.Lattice, decimation, output);
  if (limit.Noise)
  {
    AddValue<double>(output.FieldData, FieldArray::ChosenMaximumError, limit.Indices);
    WriteHeightNoise(*limit.Noise, output.FieldData);
  }
  if (given.CloseFaults)
  {
    const Reduction& vertices = decimation.Points;
    CloseMesh(vertices.Plane, points.Lattice, vertices.Boundary, output, monitor.Step(0.95, 1.0));
  }
}

//----------------------------------------------------------------------------------------------------------------------
ErrorLimit FindMaximumError(
  const ReducedMeshOptions& options, PlanePoints columns, const std::vector<double>& height, const Lattice& lattice)
{
  if (!options.MaximumError)
  {
    const HeightNoise noise = MeasureHeightNoise(columns, height);
    return { noise.MaximumError(), noise };
  }
  CheckMaximumError(*options.MaximumError);
  return { *options.MaximumError * IndicesPerUnit(options.ErrorUnit, columns, height, lattice), std::nullopt };
}

//----------------------------------------------------------------------------------------------------------------------
void CheckMaximumError(double error)
{
  CheckAtLeast("maximum error", error, 0.0, ", or -1 for automatic");
}

//----------------------------------------------------------------------------------------------------------------------
void WriteMesh(const Horizon& input, const Lattice& lattice, Decimation& decimation, Horizon& output)
{
  output.Places = MakePoints(input, lattice, decimation.Points);
  WriteReduction(input, decimation.Points, output);
  WriteTrianglesAndFigures(lattice, decimation, output);
}

//----------------------------------------------------------------------------------------------------------------------
void WriteMesh(
  const Horizon& nearest, const MergedParts& merged, const Lattice& lattice, Decimation& decimation, Horizon& output)
{
  std::iota(decimation.Points.Source.begin(), decimation.Points.Source.end(), 0);
  output.Places = MakePoints(nearest, lattice, decimation.Points);
  WriteReduction(nearest, merged, decimation.Points, output);
  WriteTrianglesAndFigures(lattice, decimation, output);
}
}
