// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceByRows.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/ColumnIndex.h"
#include "Common/Horizon/DataModel.h"
#include "Filters/Algorithms/Surface/RowSurface.h"
#include "Filters/Boundary/BoundaryStage.h"
#include "Filters/Common/CutData.h"
#include "Filters/Common/HeightUnit.h"
#include "Filters/Common/HorizonPoints.h"
#include "Filters/Common/LatticePoints.h"
#include "Filters/Common/LedgerOutput.h"
#include "Filters/Common/ReducedHorizon.h"
#include "SurfaceFigures.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

namespace SeismicHorizons
{
namespace
{
/// Checks points when they are read first.
class CheckedRows : public RowReader
{
public:
  CheckedRows(const HorizonRows& rows, bool tearAtFaults)
    : Rows(rows)
    , TearAtFaults(tearAtFaults)
    , Area(rows.Box())
  {
    this->Starts.push_back(0);
    for (std::int64_t row = this->Area.Least.Y; row <= this->Area.Greatest.Y; ++row)
    {
      this->Starts.push_back(this->Starts.back() + rows.CountPoints(std::int32_t(row), std::int32_t(row)));
    }
    CheckNumberOfPoints(this->NumberOfPoints());
    this->Heights.emplace(this->NumberOfPoints());
  }

  PlaneBox Box() const override { return this->Area; }

  void Read(std::int32_t firstRow, std::int32_t lastRow, std::vector<PlanePoint>& columns,
    std::vector<double>& height) const override
  {
    const std::int64_t most = this->MostRows();
    for (std::int64_t row = firstRow; row <= lastRow; row += most)
    {
      const LatticePoints points =
        this->ReadPart(std::int32_t(row), std::int32_t(std::min<std::int64_t>(row + most - 1, lastRow)));
      columns.insert(columns.end(), points.Column.begin(), points.Column.end());
      height.insert(height.end(), points.Height.begin(), points.Height.end());
    }
  }

  std::int64_t NumberOfPoints() const { return this->Starts.back(); }

  std::int64_t FirstOf(std::int64_t row) const
  {
    const std::int64_t number = row - this->Area.Least.Y;
    return this->Starts[std::size_t(std::clamp<std::int64_t>(number, 0, std::int64_t(this->Starts.size()) - 1))];
  }

  LatticePoints ReadPart(std::int32_t firstRow, std::int32_t lastRow) const
  {
    const std::int32_t first = std::max(firstRow, this->Area.Least.Y);
    const std::int32_t last = std::min(lastRow, this->Area.Greatest.Y);
    LatticePoints points = ReadColumnsOfPart(this->RequireAsRead(this->Rows.Read(first, last)));
    const std::int64_t found = points.Horizon.NumberOfPoints();
    const std::int64_t expected = this->FirstOf(std::int64_t(last) + 1) - this->FirstOf(first);
    if (found != expected)
    {
      throw InputError(std::to_string(found) + " points in rows " + std::to_string(first) + " to " +
        std::to_string(last) + ", expected the " + std::to_string(expected) + " that were there before");
    }
    this->CheckHeightsOf(points, this->FirstOf(first));
    return points;
  }

  /// Calls visit(points, number of the first point, number behind the last) for rows with the points from `first` to
  /// before `end`. They come with `rim` rows beside them, and all points of their rows.
  template <typename Visitor>
  void ForEachPart(
    std::int64_t first, std::int64_t end, std::int32_t rim, const Monitor& monitor, Visitor&& visit) const
  {
    const std::int64_t most = this->MostRows();
    const auto rowOf = [this](std::int64_t point)
    {
      const auto after = std::upper_bound(this->Starts.begin(), this->Starts.end(), point);
      return this->Area.Least.Y + std::int64_t(after - this->Starts.begin()) - 1;
    };
    for (std::int64_t point = first; point < end;)
    {
      monitor.Progress(double(point - first) / double(end - first));
      const std::int64_t row = rowOf(point);
      const std::int64_t next = std::min(end, this->FirstOf(row + most));
      const std::int64_t firstRow = std::max<std::int64_t>(row - rim, this->Area.Least.Y);
      const std::int64_t lastRow = std::min<std::int64_t>(row + most - 1 + rim, this->Area.Greatest.Y);
      const LatticePoints points = this->ReadPart(std::int32_t(firstRow), std::int32_t(lastRow));
      visit(points, this->FirstOf(firstRow), point, next);
      point = next;
    }
  }

private:
  static constexpr std::int64_t ColumnsOfPart = std::int64_t(1) << 19;

  /// Points with all of their arrays take more memory than their columns and heights.
  std::int64_t MostRows() const
  {
    const std::int64_t width = std::int64_t(this->Area.Greatest.X) - this->Area.Least.X + 1;
    return std::max<std::int64_t>(1, ColumnsOfPart / width);
  }

  const Horizon& RequireAsRead(const Horizon& points) const
  {
    const bool isTorn = this->TearAtFaults && FindFaultedLinks(points.FieldData);
    if (isTorn || points.IsMesh() || points.PointData.Has(PointArray::PointCount))
    {
      throw InputError(std::string("rows of points with ") +
        (isTorn               ? "faults"
            : points.IsMesh() ? "triangles"
                              : PointArray::PointCount) +
        ", expected points as they are read");
    }
    return points;
  }

  void CheckHeightsOf(const LatticePoints& points, std::int64_t first) const
  {
    const std::int64_t end = first + points.Horizon.NumberOfPoints();
    if (this->Checked < first || this->Checked >= end)
    {
      return;
    }
    this->Heights->Add(
      points.Horizon, [&points](std::int64_t point) { return points.Height[std::size_t(point)]; }, first, this->Checked,
      end);
    this->Checked = end;
    if (this->Checked == this->NumberOfPoints())
    {
      this->Heights->Finish();
    }
  }

  const HorizonRows& Rows;
  const bool TearAtFaults;
  const PlaneBox Area;
  std::vector<std::int64_t> Starts; // the first point of each row, and the number of all
  mutable std::optional<HeightCheck> Heights;
  mutable std::int64_t Checked = 0; // points
};

HeightNoise MeasureNoiseByRows(const CheckedRows& rows, const Monitor& monitor)
{
  NoiseSampler sampler(std::size_t(rows.NumberOfPoints()));
  do
  {
    rows.ForEachPart(0, rows.NumberOfPoints(), sampler.Rim(), monitor,
      [&](const LatticePoints& points, std::int64_t before, std::int64_t first, std::int64_t end)
      {
        sampler.Add(ColumnIndex(points.Column, 1, sampler.Rim()), points.Height, std::size_t(before),
          std::size_t(first), std::size_t(end));
      });
  } while (!sampler.Finish());
  return sampler.Noise();
}

double MeasureDiagonalByRows(const CheckedRows& rows, const Monitor& monitor)
{
  double least = std::numeric_limits<double>::infinity();
  double greatest = -least;
  rows.ForEachPart(0, rows.NumberOfPoints(), 0, monitor,
    [&](const LatticePoints& points, std::int64_t, std::int64_t, std::int64_t)
    {
      const auto ends = std::minmax_element(points.Height.begin(), points.Height.end());
      least = std::min(least, *ends.first);
      greatest = std::max(greatest, *ends.second);
    });
  return LengthOfDiagonal(rows.Box(), least, greatest);
}

ErrorLimit FindErrorByRows(
  const SurfaceStageOptions& given, const CheckedRows& rows, const Lattice& lattice, const Monitor& monitor)
{
  if (!given.MaximumError)
  {
    const HeightNoise noise = MeasureNoiseByRows(rows, monitor);
    return { noise.MaximumError(), noise };
  }
  CheckMaximumError(*given.MaximumError);
  const double indices = given.ErrorUnit == HeightUnit::Diagonal ? MeasureDiagonalByRows(rows, monitor)
                                                                 : IndicesPerUnit(given.ErrorUnit, {}, {}, lattice);
  return { *given.MaximumError * indices, std::nullopt };
}

/// The input points of vertices, the field data of all points, and the ledger.
class VertexPoints
{
public:
  VertexPoints(const std::vector<PointId>& sources, const CoveredColumns& covered)
    : Sources(sources)
    , Order(sources.size())
    , Ledger(covered)
  {
    std::iota(this->Order.begin(), this->Order.end(), 0);
    std::sort(this->Order.begin(), this->Order.end(),
      [&sources](std::size_t a, std::size_t b) { return sources[a] < sources[b]; });
  }

  /// Calls of this are in the order of points.
  void Add(const LatticePoints& points, PointId first, const PatchSpans& patches)
  {
    const Horizon& part = points.Horizon;
    const auto end = first + PointId(part.NumberOfPoints());
    KeptPoints kept(points.Column.size());
    patches.ForEach(first, end,
      [&](PointId from, PointId to, std::int32_t patch)
      { kept.AppendRun(from - first, patch == NoPatch ? 0 : std::size_t(to - from)); });
    this->Ledger.Add(part, points.Column, kept);
    this->AddFields(part.FieldData);
    std::size_t next = this->Filled;
    while (next < this->Order.size() && this->Sources[this->Order[next]] < end)
    {
      ++next;
    }
    this->Copy(part.Places, first, next, this->Points.Places);
    for (const DataArray& array : part.PointData)
    {
      if (!this->Points.PointData.Has(array.Name))
      {
        this->Points.PointData.Add(array.NewLike(std::int64_t(this->Order.size())));
      }
      this->Copy(array, first, next, *this->Points.PointData.Find(array.Name));
    }
    this->Filled = next;
  }

  Horizon Points;
  ArrayTable Fields;

  void WriteLedger(ArrayTable& figures) const { this->Ledger.Write(figures); }

  std::vector<std::pair<PointId, std::size_t>> Numbers() const
  {
    std::vector<std::pair<PointId, std::size_t>> numbers;
    for (const std::size_t vertex : this->Order)
    {
      numbers.emplace_back(this->Sources[vertex], vertex);
    }
    return numbers;
  }

private:
  void AddFields(const ArrayTable& fields)
  {
    if (this->Fields.Size() == 0)
    {
      this->Fields = fields;
      return;
    }
    const auto sum = std::int64_t(FirstValue(this->Fields, FieldArray::DroppedDuplicates)) +
      std::int64_t(FirstValue(fields, FieldArray::DroppedDuplicates));
    if (fields.Has(FieldArray::DroppedDuplicates))
    {
      AddValue<std::int64_t>(this->Fields, FieldArray::DroppedDuplicates, sum);
    }
  }

  void Copy(const DataArray& from, PointId first, std::size_t next, DataArray& to) const
  {
    if (to.Tuples() == 0)
    {
      to = from.NewLike(std::int64_t(this->Order.size()));
    }
    const std::size_t bytes = from.BytesOfTuple();
    for (std::size_t n = this->Filled; n < next; ++n)
    {
      const std::size_t vertex = this->Order[n];
      std::memcpy(static_cast<char*>(to.Data()) + vertex * bytes,
        static_cast<const char*>(from.Data()) + std::size_t(this->Sources[vertex] - first) * bytes, bytes);
    }
  }

  const std::vector<PointId>& Sources;
  std::vector<std::size_t> Order; // vertices by ascending sources
  std::size_t Filled = 0;
  PointLedger Ledger;
};

/// Adds the patches and marks of vertices.
void WriteBoundaryOfVertices(const RowSurface& surface, const VertexPoints& vertices, Horizon& points)
{
  const std::vector<std::pair<PointId, std::size_t>> numbers = vertices.Numbers();
  ExteriorBoundary ofVertices;
  for (const PointId source : surface.Made.Mesh.Points.Source)
  {
    ofVertices.Patch.push_back(surface.Patches.PatchAt(source));
  }
  AddArray<int>(points.PointData, PointArray::PatchId, ofVertices.Patch);
  const auto others = PointId(numbers.size()); // stands for all other points
  ofVertices.Patch.push_back(NoPatch);
  ofVertices.NumberOfPatches = surface.Made.Boundary.NumberOfPatches;
  ofVertices.Boundary = surface.Made.Boundary.Boundary.RenumberedBy(
    [&](PointId point)
    {
      const auto found = std::lower_bound(numbers.begin(), numbers.end(), std::make_pair(point, std::size_t(0)));
      return found != numbers.end() && found->first == point ? PointId(found->second) : others;
    });
  std::vector<BoundaryKind> marks = MarkBoundary(BoundaryType::Exterior, {}, ofVertices);
  marks.pop_back();
  AddArray<unsigned char>(
    points.PointData, PointArray::Boundary, marks, [](BoundaryKind kind) { return static_cast<unsigned char>(kind); });
  points.PointData.SetActiveScalars(PointArray::PatchId);
}
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::string> RunSurfaceByRows(const HorizonRows& given, const SurfaceStageOptions& stage,
  std::int64_t mostAtOnce, Horizon& mesh, const Monitor& monitor)
{
  const CheckedRows rows(given, stage.TearAtFaults);
  const PlaneBox box = rows.Box();
  if (box.IsEmpty())
  {
    return { NothingLeft(0, stage.MinimumPatchSize) };
  }
  const Lattice lattice = rows.ReadPart(box.Least.Y, box.Least.Y).Lattice;
  const ErrorLimit limit =
    HasErrorTarget(stage) ? FindErrorByRows(stage, rows, lattice, monitor.Step(0.0, 0.1)) : ErrorLimit();
  MergedParts merged;
  // Targets come for whole rows, so that parts begin with their first point.
  const TakeTargets take = [&](PointId first, const std::vector<PointId>& targets)
  {
    rows.ForEachPart(first, first + std::int64_t(targets.size()), 0, Monitor(),
      [&](const LatticePoints& points, std::int64_t, std::int64_t begin, std::int64_t end)
      { merged.Add(points.Horizon.PointData, targets.data() + (begin - first), end - begin); });
  };
  RowSurface surface = MakeSurface(rows, MakeSurfaceOptions(stage, limit), mostAtOnce, take, monitor.Step(0.1, 0.9));
  Surface& made = surface.Made;
  Reduction& reduced = made.Mesh.Points;
  const CoveredColumns covered(reduced.Plane, reduced.Boundary, 1);
  VertexPoints vertices(reduced.Source, covered);
  rows.ForEachPart(0, rows.NumberOfPoints(), 0, monitor.Step(0.9, 0.95),
    [&](const LatticePoints& points, std::int64_t, std::int64_t begin, std::int64_t)
    { vertices.Add(points, PointId(begin), surface.Patches); });
  mesh.FieldData = WithoutMeshFigures(vertices.Fields);
  RemoveCuts(mesh);
  WriteBoundaryFigures(made.Boundary, surface.DroppedPoints, mesh.FieldData);
  std::vector<std::string> warnings;
  if (surface.DroppedPoints == rows.NumberOfPoints())
  {
    vertices.WriteLedger(mesh.FieldData);
    warnings.push_back(NothingLeft(rows.NumberOfPoints(), stage.MinimumPatchSize));
  }
  else
  {
    WriteDeviations(made, mesh.FieldData);
    WriteBoundaryOfVertices(surface, vertices, vertices.Points);
    WriteMesh(vertices.Points, merged, lattice, made.Mesh, mesh);
    vertices.WriteLedger(mesh.FieldData);
    CloseIfWanted(stage, lattice, reduced, monitor, mesh);
  }
  WriteParameters(made.Parameters, limit, mesh.FieldData);
  return warnings;
}
}
