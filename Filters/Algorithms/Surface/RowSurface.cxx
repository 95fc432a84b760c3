// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "RowSurface.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/ColumnIndex.h"
#include "SurfaceParts.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <numeric>
#include <string>
#include <utility>

namespace SeismicHorizons
{
namespace
{
/// Calls visit(columns, heights) for blocks of rows.
template <typename Visitor>
void ForEachBlock(const RowReader& rows, const Monitor& monitor, Visitor&& visit)
{
  const PlaneBox box = rows.Box();
  const std::int32_t step = RowsOfBand(box);
  for (std::int64_t row = box.Least.Y; row <= box.Greatest.Y; row += step)
  {
    monitor.Progress(double(row - box.Least.Y) / (double(box.Greatest.Y) - box.Least.Y + 1.0));
    std::vector<PlanePoint> columns;
    std::vector<double> height;
    rows.Read(std::int32_t(row), std::int32_t(std::min<std::int64_t>(row + step - 1, box.Greatest.Y)), columns, height);
    visit(columns, height);
  }
}

class IndexedRows : public PointRows
{
public:
  IndexedRows(const RowReader& rows, const ColumnIndex& index, const PatchSpans& patches, bool areAllKept,
    std::int32_t rowsOfPart)
    : Rows(rows)
    , Index(index)
    , Patches(patches)
    , AreAllKept(areAllKept)
    , Area(rows.Box())
    , MostRows(21 * std::int64_t(rowsOfPart) / 4)
  {
  }

  PlaneBox Box() const override { return this->Area; }
  PlanePoint ColumnOf(PointId point) const override { return this->Index.ColumnOf(point); }

  PointId FirstOf(std::int32_t row) const override
  {
    return row > this->Area.Greatest.Y
      ? PointId(this->Index.NumberOfPoints())
      : PointId(this->Index.Rank(this->Index.Place({ this->Area.Least.X, std::max(row, this->Area.Least.Y) })));
  }

  PointWindow Read(std::int32_t firstRow, std::int32_t lastRow) const override
  {
    const std::int32_t first = std::max(firstRow, this->Area.Least.Y);
    const std::int32_t last = std::min(lastRow, this->Area.Greatest.Y);
    if (first > last)
    {
      return {};
    }
    std::vector<PlanePoint> columns;
    std::vector<double> height;
    const PointId firstPoint = this->FirstOf(first);
    if (first == last) // of a cut
    {
      this->Rows.Read(first, last, columns, height);
    }
    else
    {
      this->Keep(first, last);
      const std::ptrdiff_t begin = firstPoint - this->FirstPoint;
      const std::ptrdiff_t end = this->FirstOf(last + 1) - this->FirstPoint;
      columns.assign(this->Columns.begin() + begin, this->Columns.begin() + end);
      height.assign(this->Height.begin() + begin, this->Height.begin() + end);
    }
    PointWindow window(firstPoint, std::move(columns), std::move(height));
    if (!this->AreAllKept)
    {
      window.IsLeftOut.assign(window.Columns.size(), 0);
      this->Patches.ForEach(window.First, window.First + PointId(window.Columns.size()),
        [&window](PointId from, PointId to, std::int32_t patch)
        {
          const auto start = window.IsLeftOut.begin() - window.First;
          std::fill(start + from, start + to, patch == NoPatch ? 1 : 0);
        });
    }
    return window;
  }

  std::size_t MostAtOnce() const override { return 1; }

private:
  /// Keeps rows of five bands, as those around cuts are read several times.
  void Keep(std::int32_t first, std::int32_t last) const
  {
    if (first >= this->FirstKept && last <= this->LastKept)
    {
      return;
    }
    const bool isEmpty = this->LastKept < this->FirstKept;
    if (!isEmpty && first < this->FirstKept && last >= this->FirstKept)
    {
      std::vector<PlanePoint> columns;
      std::vector<double> height;
      this->Rows.Read(first, this->FirstKept - 1, columns, height);
      this->Columns.insert(this->Columns.begin(), columns.begin(), columns.end());
      this->Height.insert(this->Height.begin(), height.begin(), height.end());
      this->FirstPoint = this->FirstOf(first);
      this->FirstKept = first;
    }
    if (isEmpty || first < this->FirstKept || first > this->LastKept + 1)
    {
      this->Columns.clear();
      this->Height.clear();
      this->FirstPoint = this->FirstOf(first);
      this->FirstKept = first;
      this->LastKept = first - 1;
    }
    const auto firstLeft = std::int32_t(std::min<std::int64_t>(first, std::int64_t(last) - this->MostRows));
    if (firstLeft > this->FirstKept)
    {
      const std::ptrdiff_t gone = this->FirstOf(firstLeft) - this->FirstPoint;
      this->Columns.erase(this->Columns.begin(), this->Columns.begin() + gone);
      this->Height.erase(this->Height.begin(), this->Height.begin() + gone);
      this->FirstPoint += PointId(gone);
      this->FirstKept = firstLeft;
    }
    if (last > this->LastKept)
    {
      this->Rows.Read(this->LastKept + 1, last, this->Columns, this->Height);
      this->LastKept = last;
    }
    const PointId expected = this->FirstOf(this->LastKept + 1) - this->FirstPoint;
    if (this->Columns.size() != std::size_t(expected))
    {
      throw InputError(std::to_string(this->Columns.size()) + " points in rows " + std::to_string(this->FirstKept) +
        " to " + std::to_string(this->LastKept) + ", expected the " + std::to_string(expected) +
        " that were there before: the file has changed");
    }
  }

  const RowReader& Rows;
  const ColumnIndex& Index;
  const PatchSpans& Patches;
  const bool AreAllKept;
  const PlaneBox Area;
  const std::int64_t MostRows;
  // rows that are kept
  mutable PointId FirstPoint = 0;
  mutable std::vector<PlanePoint> Columns;
  mutable std::vector<double> Height;
  mutable std::int32_t FirstKept = 0;
  mutable std::int32_t LastKept = -1;
};

/// Makes the surface of all points.
RowSurface MakeAtOnce(
  const RowReader& rows, const SurfaceOptions& options, const TakeTargets& take, const Monitor& monitor)
{
  std::vector<PlanePoint> columns;
  std::vector<double> height;
  rows.Read(rows.Box().Least.Y, rows.Box().Greatest.Y, columns, height);
  RowSurface result;
  Surface& made = result.Made;
  made = MakeSurface({ columns, std::move(height) }, options, monitor);
  std::vector<PointId> targets(columns.size(), NoPoint);
  result.Patches = PatchSpans(columns.size());
  std::vector<std::int32_t> patches(columns.size(), NoPatch);
  for (std::size_t n = 0; n < made.Kept.size(); ++n)
  {
    const auto point = std::size_t(made.Kept[n]);
    patches[point] = made.Boundary.Patch[n];
    targets[point] = made.Mesh.Points.Target[n];
  }
  for (std::size_t point = 0; point < patches.size(); ++point)
  {
    result.Patches.Append(PointId(point), patches[point]);
  }
  const auto numberOf = [&](PointId point) { return made.Kept[std::size_t(point)]; };
  made.Boundary.Boundary = made.Boundary.Boundary.RenumberedBy(numberOf);
  for (std::vector<PointId>* const points : { &made.Mesh.Points.Source, &made.AddedToOutlines })
  {
    std::transform(points->begin(), points->end(), points->begin(), numberOf);
  }
  result.DroppedPoints = std::int64_t(columns.size() - made.Kept.size());
  made.Boundary.Patch.clear();
  made.Mesh.Points.Target.clear();
  made.Dropped.clear();
  made.Kept = KeptPoints();
  take(0, targets);
  return result;
}
}

//----------------------------------------------------------------------------------------------------------------------
RowSurface MakeSurface(const RowReader& rows, const SurfaceOptions& given, std::int64_t mostAtOnce,
  const TakeTargets& take, const Monitor& monitor)
{
  RowSurface result;
  const PlaneBox box = rows.Box();
  if (box.IsEmpty())
  {
    return result;
  }
  SurfaceOptions options = given;
  constexpr int rim = 2;
  GapCounter gaps(box);
  const ColumnIndex index(box, rim,
    [&](auto&& add)
    {
      ForEachBlock(rows, monitor.Step(0.0, 0.2),
        [&](const std::vector<PlanePoint>& columns, const std::vector<double>&)
        {
          gaps.Add(columns);
          std::for_each(columns.begin(), columns.end(), add);
        });
    });
  options.Radius = options.Radius ? *options.Radius : ChooseRadius(gaps.Counted());
  const std::int32_t rowsOfPart = RowsOfPart(box, options, *options.Radius);
  const auto points = std::int64_t(index.NumberOfPoints());
  if (rowsOfPart == 0)
  {
    if (points > mostAtOnce)
    {
      throw InputError(std::to_string(points) +
        " points to be meshed at once (with a radius above 1, another effort than "
        "Best, a number of triangles, or an edge length), expected at most " +
        std::to_string(mostAtOnce));
    }
    return MakeAtOnce(rows, options, take, monitor.Step(0.2, 1.0));
  }
  Surface& made = result.Made;
  made.Parameters = ParametersFor(options, *options.Radius, options.MaximumError);
  RowBoundary boundary =
    FindExteriorBoundary(index, BoundaryOptionsFor(options, made.Parameters), monitor.Step(0.2, 0.25));
  made.Boundary.Boundary = std::move(boundary.Boundary);
  made.Boundary.NumberOfPatches = boundary.NumberOfPatches;
  result.Patches = std::move(boundary.Patches);
  result.DroppedPoints =
    std::accumulate(boundary.PatchSizes.begin(), boundary.PatchSizes.end(), points, std::minus<>());
  const IndexedRows indexed(rows, index, result.Patches, result.DroppedPoints == 0, rowsOfPart);
  MakeInParts(indexed, rowsOfPart, options, made, take, monitor.Step(0.25, 1.0));
  return result;
}
}
