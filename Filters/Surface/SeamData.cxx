// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SeamData.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/CoveredColumns.h"
#include "Common/Horizon/DataArray.h"
#include "Common/Horizon/DataModel.h"
#include "Common/Horizon/LedgerFields.h"
#include "Filters/Algorithms/Boundary/ExteriorBoundary.h"
#include "Filters/Common/HorizonCells.h"
#include "Filters/Common/HorizonData.h"
#include "Filters/Common/HorizonPoints.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <optional>
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

const DataArray& RequireSeamRows(const Horizon& mesh)
{
  const DataArray* const rows = mesh.FieldData.Find(FieldArray::SeamRows);
  if (!rows || rows->Size() < 2)
  {
    throw InputError(std::string("a mesh without the field data array ") + FieldArray::SeamRows +
      ", expected parts of a horizon, as Horizon Surface gives them with SeamRows");
  }
  return *rows;
}

/// One each without PointCount.
std::vector<std::int64_t> CountsOf(const Horizon& mesh)
{
  std::vector<std::int64_t> counts = ReadCounts(mesh);
  counts.resize(std::size_t(mesh.NumberOfPoints()), 1);
  return counts;
}

RawVector<PointId> ReadTrianglesOnLattice(const Horizon& mesh, const Lattice& lattice)
{
  RawVector<PointId> triangles;
  for (const std::array<PointId, 3>& triangle : ReadTriangles(mesh))
  {
    triangles.insert(triangles.end(), triangle.begin(), triangle.end());
  }
  FaceUp(lattice, triangles); // FaceUp is its own inverse.
  return triangles;
}

std::vector<PointId> ReadOpenGaps(const Horizon& mesh)
{
  std::vector<PointId> gaps;
  const DataArray* const marks = mesh.PointData.Find(PointArray::SeamGap);
  for (std::int64_t point = 0; marks && point < mesh.NumberOfPoints(); ++point)
  {
    if (marks->At(point, 0) != 0.0)
    {
      gaps.push_back(PointId(point));
    }
  }
  return gaps;
}

/// Gathers tuples of the array from each part, where all parts have it.
std::optional<DataArray> GatherArray(
  const DataArray& first, const std::vector<Horizon>& meshes, const std::vector<PartItem>& sources)
{
  std::vector<const DataArray*> arrays;
  for (const Horizon& mesh : meshes)
  {
    arrays.push_back(mesh.PointData.Find(first.Name));
    if (!arrays.back() || arrays.back()->Type() != first.Type() || first.IsText() ||
      arrays.back()->Components() != first.Components())
    {
      return std::nullopt;
    }
  }
  DataArray gathered = first.NewLike(std::int64_t(sources.size()));
  const std::size_t bytes = first.BytesOfTuple();
  auto* to = static_cast<char*>(gathered.Data());
  for (const PartItem& source : sources)
  {
    std::memcpy(to, static_cast<const char*>(arrays[source.Part]->Data()) + std::size_t(source.Item) * bytes, bytes);
    to += bytes;
  }
  return gathered;
}

void WriteSeamPoints(const std::vector<Horizon>& meshes, const JoinedSurface& joined, Horizon& output)
{
  output.Places = NewArray<double>("", std::int64_t(joined.Sources.size()), 3);
  double* to = output.Places.As<double>();
  for (const PartItem& source : joined.Sources)
  {
    const Eigen::Vector3d place = meshes[source.Part].Place(source.Item);
    to = std::copy_n(place.data(), 3, to);
  }
  for (const DataArray& array : meshes.front().PointData)
  {
    if (std::optional<DataArray> gathered = GatherArray(array, meshes, joined.Sources))
    {
      output.PointData.Add(std::move(*gathered));
    }
  }
  output.PointData.Remove(PointArray::SeamGap);
}

void WriteSeamBoundary(const JoinedSurface& joined, Horizon& output)
{
  ExteriorBoundary boundary;
  boundary.Boundary = joined.Boundary;
  boundary.Patch = joined.Patch;
  boundary.NumberOfPatches = joined.NumberOfPatches;
  ArrayTable& data = output.PointData;
  AddArray<std::int64_t>(data, PointArray::PointCount, joined.Count);
  AddArray<int>(data, PointArray::PatchId, joined.Patch);
  AddArray<unsigned char>(data, PointArray::Boundary, MarkBoundary(BoundaryType::Exterior, {}, boundary),
    [](BoundaryKind kind) { return static_cast<unsigned char>(kind); });
  output.Lines = MakePolylines(joined.Boundary);
}

/// A piece of a triangle keeps the triangle's error.
std::vector<double> GatherErrors(const std::vector<Horizon>& meshes, const JoinedSurface& joined)
{
  std::vector<const DataArray*> arrays;
  for (const Horizon& mesh : meshes)
  {
    arrays.push_back(mesh.CellData.Find(CellArray::Error));
    if (arrays.back())
    {
      RequireTuples(*arrays.back(), mesh.NumberOfCells(), "cells");
    }
  }
  std::vector<double> errors;
  for (const PartItem& source : joined.TriangleSources)
  {
    const Horizon& mesh = meshes[source.Part];
    const std::int64_t first = mesh.Vertices.Size() + mesh.Lines.Size();
    errors.push_back(
      arrays[source.Part] ? arrays[source.Part]->At(first + source.Item, 0) : std::numeric_limits<double>::quiet_NaN());
  }
  return errors;
}

void WriteLargest(const std::vector<Horizon>& meshes, const char* name, ArrayTable& figures)
{
  double largest = 0.0;
  for (const Horizon& mesh : meshes)
  {
    largest = std::max(largest, FirstValue(mesh.FieldData, name));
  }
  AddValue<double>(figures, name, largest);
}

void WriteSum(const std::vector<Horizon>& meshes, const char* name, ArrayTable& figures)
{
  double sum = 0.0;
  for (const Horizon& mesh : meshes)
  {
    sum += FirstValue(mesh.FieldData, name);
  }
  AddValue<std::int64_t>(figures, name, std::int64_t(sum));
}

/// A row shared by two parts is in the ledger of one.
void WriteLedgerOfParts(const std::vector<Horizon>& meshes, const JoinedSurface& joined, ArrayTable& figures)
{
  Ledger all;
  for (const Horizon& mesh : meshes)
  {
    all.Add(ReadLedger(mesh.FieldData).value_or(Ledger()));
  }
  all.CoverOnly(CoveredColumns(joined.Vertices, joined.Boundary, 1).Count());
  WriteLedger(all, figures);
}

/// Points on seams count twice.
double FindMeanError(const std::vector<Horizon>& meshes)
{
  double sum = 0.0;
  double points = 0.0;
  for (const Horizon& mesh : meshes)
  {
    const std::vector<std::int64_t> counts = CountsOf(mesh);
    const double count = double(std::accumulate(counts.begin(), counts.end(), std::int64_t(0)));
    sum += count * FirstValue(mesh.FieldData, FieldArray::MeanError);
    points += count;
  }
  return points > 0.0 ? sum / points : 0.0;
}

void WritePartFigures(
  const std::vector<Horizon>& meshes, const JoinedSurface& joined, double smallestAngle, Horizon& output)
{
  ArrayTable& figures = output.FieldData;
  figures.AddAll(meshes.front().FieldData);
  figures.Remove(FieldArray::SeamRows);
  figures.Remove(FieldArray::SliverCount); // Seams are meshed anew without a least angle.
  for (const char* const name : { FieldArray::LargestError, FieldArray::LargestEdgeError, FieldArray::LargestLoopError,
         FieldArray::BoundaryDeviation, FieldArray::OutlineDeviation, FieldArray::OutlineHeightDeviation })
  {
    WriteLargest(meshes, name, figures);
  }
  for (const char* const name : { FieldArray::DroppedDuplicates, FieldArray::NumberOfOutsidePoints })
  {
    if (figures.Has(name))
    {
      WriteSum(meshes, name, figures);
    }
  }
  AddValue<double>(figures, FieldArray::MeanError, FindMeanError(meshes));
  WriteLedgerOfParts(meshes, joined, figures);
  AddValue<double>(figures, FieldArray::SmallestAngle, smallestAngle);
  AddValue<std::int64_t>(figures, FieldArray::TriangleCount, output.Polygons.Size());
  AddValue<std::int64_t>(figures, FieldArray::NumberOfPatches, std::int64_t(joined.NumberOfPatches));
  AddValue<std::int64_t>(
    figures, FieldArray::NumberOfHoles, std::int64_t(joined.Boundary.Size() - joined.NumberOfPatches));
  AddValue<std::int64_t>(figures, FieldArray::DroppedSmallPatchPoints, std::int64_t(joined.DroppedPoints));
  AddValue<int>(figures, FieldArray::NumberOfParts, int(meshes.size()));
  AddValue<std::int64_t>(figures, FieldArray::SeamPoints, std::int64_t(joined.SeamVertices));
}
}

//----------------------------------------------------------------------------------------------------------------------
void WriteSeams(const Horizon& points, const Lattice& lattice, const Surface& surface, const SeamRows& seams,
  const std::vector<PointId>& onLowerSeam, Horizon& mesh)
{
  AddTuple<int>(mesh.FieldData, FieldArray::SeamRows,
    std::array<int, 2>{ seams.Lower.value_or(NoSeam), seams.Upper.value_or(NoSeam) });
  const Reduction& vertices = surface.Mesh.Points;
  std::vector<unsigned char> isBesideGap(std::size_t(mesh.NumberOfPoints()), 0);
  for (const PointId point : surface.OpenGaps)
  {
    isBesideGap[vertices.Target[point]] = 1;
  }
  AddArray<unsigned char>(mesh.PointData, PointArray::SeamGap, isBesideGap);
  for (const SeamPin& pin : surface.Pins)
  {
    const PointId vertex = vertices.Target[pin.Point];
    const PlanePoint& place = vertices.Plane[vertex];
    const Eigen::Vector3d world = lattice.ToWorld({ double(place.X), double(place.Y), pin.Height });
    std::copy_n(world.data(), 3, mesh.Places.As<double>() + 3 * std::size_t(vertex));
  }
  const std::vector<std::int64_t> counts = ReadCounts(points);
  std::vector<std::int64_t> sums = CountsOf(mesh);
  for (const PointId point : onLowerSeam)
  {
    const std::size_t vertex = std::size_t(vertices.Target[point]);
    sums[vertex] -= counts.empty() ? 1 : counts[point];
  }
  AddArray<std::int64_t>(mesh.PointData, PointArray::PointCount, sums);
}

//----------------------------------------------------------------------------------------------------------------------
SurfacePart ReadSurfacePart(const Horizon& mesh)
{
  const DataArray& rows = RequireSeamRows(mesh);
  CheckArraySizes(mesh);
  LatticePoints points = ReadColumns(mesh);
  SurfacePart part;
  part.Seams.Lower = FromRow(rows.Value(0));
  part.Seams.Upper = FromRow(rows.Value(1));
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
  const std::vector<Horizon>& meshes, const Lattice& lattice, const JoinedSurface& joined, Horizon& output)
{
  assert(!meshes.empty() && joined.Sources.size() == joined.Vertices.size());
  WriteSeamPoints(meshes, joined, output);
  WriteSeamBoundary(joined, output);
  const double smallestAngle = WriteTriangles(joined.Vertices, lattice, joined.Triangles, output);
  AddTriangleArray<double>(CellArray::Error, GatherErrors(meshes, joined), output);
  WritePartFigures(meshes, joined, smallestAngle, output);
  ActivateHeight(output);
}
}
