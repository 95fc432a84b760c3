// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SeamData.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/CoveredColumns.h"
#include "Common/Horizon/DataModel.h"
#include "Common/VTK/DataArrays.h"
#include "Common/VTK/LedgerFields.h"
#include "Filters/Algorithms/Boundary/ExteriorBoundary.h"
#include "Filters/Marshalling/HorizonCells.h"
#include "Filters/Marshalling/HorizonData.h"
#include "Filters/Marshalling/HorizonPoints.h"
#include "Filters/Marshalling/HorizonTree.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributesFieldList.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr int NoSeam = -1;

std::optional<std::int32_t> FromRow(double row)
{
  return row < 0.0 ? std::optional<std::int32_t>() : std::optional<std::int32_t>(std::int32_t(row));
}

vtkDataArray* RequireSeamRows(vtkPolyData* mesh)
{
  vtkDataArray* const rows = mesh->GetFieldData()->GetArray(FieldArray::SeamRows);
  if (!rows || rows->GetNumberOfValues() < 2)
  {
    throw InputError(std::string("a mesh without the field data array ") + FieldArray::SeamRows +
      ", expected parts of a horizon, as Horizon Surface gives them with SeamRows");
  }
  return rows;
}

/// One each without PointCount.
std::vector<std::int64_t> CountsOf(vtkPolyData* mesh)
{
  std::vector<std::int64_t> counts = ReadCounts(mesh);
  counts.resize(std::size_t(mesh->GetNumberOfPoints()), 1);
  return counts;
}

RawVector<PointId> ReadTrianglesOnLattice(vtkPolyData* mesh, const Lattice& lattice)
{
  RawVector<PointId> triangles;
  for (const std::array<PointId, 3>& triangle : ReadTriangles(mesh))
  {
    triangles.insert(triangles.end(), triangle.begin(), triangle.end());
  }
  FaceUp(lattice, triangles); // FaceUp is its own inverse.
  return triangles;
}

std::vector<PointId> ReadOpenGaps(vtkPolyData* mesh)
{
  std::vector<PointId> gaps;
  vtkDataArray* const marks = mesh->GetPointData()->GetArray(PointArray::SeamGap);
  for (vtkIdType point = 0; marks && point < mesh->GetNumberOfPoints(); ++point)
  {
    if (marks->GetComponent(point, 0) != 0.0)
    {
      gaps.push_back(PointId(point));
    }
  }
  return gaps;
}

void WriteSeamPoints(const std::vector<vtkPolyData*>& meshes, const JoinedSurface& joined, vtkPolyData* output)
{
  vtkDataSetAttributesFieldList arrays(int(meshes.size()));
  for (vtkPolyData* const mesh : meshes)
  {
    arrays.IntersectFieldList(mesh->GetPointData());
  }
  const vtkIdType size = vtkIdType(joined.Sources.size());
  vtkPointData* const data = output->GetPointData();
  arrays.CopyAllocate(data, vtkDataSetAttributes::COPYTUPLE, size, 0);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(size);
  for (vtkIdType point = 0; point < size; ++point)
  {
    const PartItem& source = joined.Sources[point];
    vtkPolyData* const mesh = meshes[source.Part];
    std::array<double, 3> place;
    mesh->GetPoint(source.Item, place.data());
    points->SetPoint(point, place.data());
    arrays.CopyData(source.Part, mesh->GetPointData(), source.Item, data, point);
  }
  output->SetPoints(points);
  data->RemoveArray(PointArray::SeamGap);
}

void WriteSeamBoundary(const JoinedSurface& joined, vtkPolyData* output)
{
  ExteriorBoundary boundary;
  boundary.Boundary = joined.Boundary;
  boundary.Patch = joined.Patch;
  boundary.NumberOfPatches = joined.NumberOfPatches;
  vtkPointData* const data = output->GetPointData();
  AddArray<vtkIdTypeArray>(data, PointArray::PointCount, joined.Count);
  AddArray<vtkIntArray>(data, PointArray::PatchId, joined.Patch);
  AddArray<vtkUnsignedCharArray>(data, PointArray::Boundary, MarkBoundary(BoundaryType::Exterior, {}, boundary),
    [](BoundaryKind kind) { return static_cast<unsigned char>(kind); });
  output->SetLines(MakePolylines(joined.Boundary));
}

/// A piece of a triangle keeps the triangle's error.
std::vector<double> GatherErrors(const std::vector<vtkPolyData*>& meshes, const JoinedSurface& joined)
{
  std::vector<vtkDataArray*> arrays;
  for (vtkPolyData* const mesh : meshes)
  {
    arrays.push_back(mesh->GetCellData()->GetArray(CellArray::Error));
    if (arrays.back())
    {
      RequireTuples(arrays.back(), mesh->GetNumberOfCells(), "cells");
    }
  }
  std::vector<double> errors;
  for (const PartItem& source : joined.TriangleSources)
  {
    vtkPolyData* const mesh = meshes[source.Part];
    const vtkIdType first = mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();
    errors.push_back(arrays[source.Part] ? arrays[source.Part]->GetComponent(first + source.Item, 0)
                                         : std::numeric_limits<double>::quiet_NaN());
  }
  return errors;
}

void WriteLargest(const std::vector<vtkPolyData*>& meshes, const char* name, vtkFieldData* figures)
{
  double largest = 0.0;
  for (vtkPolyData* const mesh : meshes)
  {
    largest = std::max(largest, FirstValue(mesh->GetFieldData(), name));
  }
  AddValue<vtkDoubleArray>(figures, name, largest);
}

void WriteSum(const std::vector<vtkPolyData*>& meshes, const char* name, vtkFieldData* figures)
{
  double sum = 0.0;
  for (vtkPolyData* const mesh : meshes)
  {
    sum += FirstValue(mesh->GetFieldData(), name);
  }
  AddValue<vtkIdTypeArray>(figures, name, vtkIdType(sum));
}

/// A row shared by two parts is in the ledger of one.
void WriteLedgerOfParts(const std::vector<vtkPolyData*>& meshes, const JoinedSurface& joined, vtkFieldData* figures)
{
  Ledger all;
  for (vtkPolyData* const mesh : meshes)
  {
    all.Add(ReadLedger(mesh->GetFieldData()).value_or(Ledger()));
  }
  all.CoverOnly(CoveredColumns(joined.Vertices, joined.Boundary, 1).Count());
  WriteLedger(all, figures);
}

/// Points on seams count twice.
double FindMeanError(const std::vector<vtkPolyData*>& meshes)
{
  double sum = 0.0;
  double points = 0.0;
  for (vtkPolyData* const mesh : meshes)
  {
    const std::vector<std::int64_t> counts = CountsOf(mesh);
    const double count = double(std::accumulate(counts.begin(), counts.end(), std::int64_t(0)));
    sum += count * FirstValue(mesh->GetFieldData(), FieldArray::MeanError);
    points += count;
  }
  return points > 0.0 ? sum / points : 0.0;
}

void WritePartFigures(
  const std::vector<vtkPolyData*>& meshes, const JoinedSurface& joined, double smallestAngle, vtkPolyData* output)
{
  vtkFieldData* const figures = output->GetFieldData();
  figures->PassData(meshes.front()->GetFieldData());
  figures->RemoveArray(FieldArray::SeamRows);
  figures->RemoveArray(FieldArray::SliverCount); // Seams are meshed anew without a least angle.
  for (const char* const name : { FieldArray::LargestError, FieldArray::LargestLoopError, FieldArray::BoundaryDeviation,
         FieldArray::OutlineDeviation, FieldArray::OutlineHeightDeviation })
  {
    WriteLargest(meshes, name, figures);
  }
  for (const char* const name : { FieldArray::DroppedDuplicates, FieldArray::NumberOfOutsidePoints })
  {
    if (figures->HasArray(name))
    {
      WriteSum(meshes, name, figures);
    }
  }
  AddValue<vtkDoubleArray>(figures, FieldArray::MeanError, FindMeanError(meshes));
  WriteLedgerOfParts(meshes, joined, figures);
  AddValue<vtkDoubleArray>(figures, FieldArray::SmallestAngle, smallestAngle);
  AddValue<vtkIdTypeArray>(figures, FieldArray::TriangleCount, output->GetNumberOfPolys());
  AddValue<vtkIdTypeArray>(figures, FieldArray::NumberOfPatches, vtkIdType(joined.NumberOfPatches));
  AddValue<vtkIdTypeArray>(
    figures, FieldArray::NumberOfHoles, vtkIdType(joined.Boundary.Size() - joined.NumberOfPatches));
  AddValue<vtkIdTypeArray>(figures, FieldArray::DroppedSmallPatchPoints, vtkIdType(joined.DroppedPoints));
  AddValue<vtkIntArray>(figures, FieldArray::NumberOfParts, int(meshes.size()));
  AddValue<vtkIdTypeArray>(figures, FieldArray::SeamPoints, vtkIdType(joined.SeamVertices));
}
}

//----------------------------------------------------------------------------------------------------------------------
void WriteSeams(vtkPolyData* points, const Lattice& lattice, const Surface& surface, const SeamRows& seams,
  const std::vector<PointId>& onLowerSeam, vtkPolyData* mesh)
{
  AddTuple<vtkIntArray>(mesh->GetFieldData(), FieldArray::SeamRows,
    std::array<int, 2>{ seams.Lower.value_or(NoSeam), seams.Upper.value_or(NoSeam) });
  const Reduction& vertices = surface.Mesh.Points;
  std::vector<unsigned char> isBesideGap(std::size_t(mesh->GetNumberOfPoints()), 0);
  for (const PointId point : surface.OpenGaps)
  {
    isBesideGap[vertices.Target[point]] = 1;
  }
  AddArray<vtkUnsignedCharArray>(mesh->GetPointData(), PointArray::SeamGap, isBesideGap);
  for (const SeamPin& pin : surface.Pins)
  {
    const PointId vertex = vertices.Target[pin.Point];
    const PlanePoint& place = vertices.Plane[vertex];
    const Eigen::Vector3d world = lattice.ToWorld({ double(place.X), double(place.Y), pin.Height });
    mesh->GetPoints()->SetPoint(vertex, world.data());
  }
  const std::vector<std::int64_t> counts = ReadCounts(points);
  std::vector<std::int64_t> sums = CountsOf(mesh);
  for (const PointId point : onLowerSeam)
  {
    const std::size_t vertex = std::size_t(vertices.Target[point]);
    sums[vertex] -= counts.empty() ? 1 : counts[point];
  }
  AddArray<vtkIdTypeArray>(mesh->GetPointData(), PointArray::PointCount, sums);
}

//----------------------------------------------------------------------------------------------------------------------
SurfacePart ReadSurfacePart(vtkPolyData* mesh)
{
  vtkDataArray* const rows = RequireSeamRows(mesh);
  CheckArraySizes(mesh);
  LatticePoints points = ReadColumns(mesh, {});
  SurfacePart part;
  part.Seams.Lower = FromRow(FieldValue(rows, 0));
  part.Seams.Upper = FromRow(FieldValue(rows, 1));
  part.Vertices.assign(points.Column.begin(), points.Column.end());
  part.Height = std::move(points.Height);
  part.Count = CountsOf(mesh);
  part.Boundary = ReadBoundary(mesh);
  part.Triangles = ReadTrianglesOnLattice(mesh, points.Lattice);
  part.OpenGaps = ReadOpenGaps(mesh);
  return part;
}

//----------------------------------------------------------------------------------------------------------------------
void WriteJoinedSurface(
  const std::vector<vtkPolyData*>& meshes, const Lattice& lattice, const JoinedSurface& joined, vtkPolyData* output)
{
  assert(!meshes.empty() && joined.Sources.size() == joined.Vertices.size());
  WriteSeamPoints(meshes, joined, output);
  WriteSeamBoundary(joined, output);
  const double smallestAngle = WriteTriangles(joined.Vertices, lattice, joined.Triangles, output);
  AddTriangleArray<vtkDoubleArray>(CellArray::Error, GatherErrors(meshes, joined), output);
  WritePartFigures(meshes, joined, smallestAngle, output);
  ActivateHeight(output);
}
}
