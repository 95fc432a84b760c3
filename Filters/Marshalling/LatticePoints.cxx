// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LatticePoints.h"

#include "Common/Base/Errors.h"
#include "Common/Base/FixedChunks.h"
#include "Common/Base/LargePages.h"
#include "Common/Base/Parallel.h"
#include "Common/Horizon/DataModel.h"
#include "Common/VTK/ColumnPoints.h"
#include "Common/VTK/DataArrays.h"
#include "HorizonData.h"
#include "HorizonPoints.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>

namespace SeismicHorizons
{
namespace
{
void CheckPoints(vtkPolyData* horizon)
{
  const vtkIdType size = horizon->GetNumberOfPoints();
  if (size > std::numeric_limits<PointId>::max() / 4)
  {
    throw InputError(std::to_string(size) + " points, expected less than 2^29 in one horizon");
  }
  const vtkIdType hidden = size - CountVisiblePoints(horizon);
  if (hidden > 0)
  {
    throw InputError(std::to_string(hidden) +
      " points hidden by the array vtkGhostType, expected none: only Horizon Exterior Boundary leaves them out");
  }
  if (horizon->GetCellData()->HasArray(CellArray::CellSize))
  {
    throw InputError("cells of a simplification (ShowCells), expected its points");
  }
}

Eigen::Vector3d WorldOf(vtkPolyData* horizon, std::int64_t point)
{
  Eigen::Vector3d world;
  horizon->GetPoint(point, world.data());
  return world;
}

/// Calls work(world), with direct access to float and double coordinates.
template <typename Work>
void WithCoordinates(vtkPolyData* horizon, Work&& work)
{
  const auto of = [](const auto* numbers)
  {
    return [numbers](std::int64_t point)
    {
      const auto* const place = numbers + 3 * point;
      return Eigen::Vector3d(double(place[0]), double(place[1]), double(place[2]));
    };
  };
  vtkDataArray* const coordinates = horizon->GetNumberOfPoints() > 0 ? horizon->GetPoints()->GetData() : nullptr;
  if (auto* const doubles = vtkDoubleArray::FastDownCast(coordinates))
  {
    work(of(doubles->GetPointer(0)));
  }
  else if (auto* const floats = vtkFloatArray::FastDownCast(coordinates))
  {
    work(of(floats->GetPointer(0)));
  }
  else
  {
    work([horizon](std::int64_t point) { return WorldOf(horizon, point); });
  }
}

bool IsInSinglePrecision(vtkPolyData* horizon)
{
  return horizon->GetNumberOfPoints() > 0 && horizon->GetPoints()->GetDataType() == VTK_FLOAT;
}

/// columns; exceeds the rounding of world coordinates, and is below half the distance to another column.
double FindTolerance(vtkPolyData* horizon, const Lattice& lattice)
{
  constexpr double Hundredth = 0.01;
  constexpr double Most = 0.25;
  if (!IsInSinglePrecision(horizon))
  {
    return Hundredth;
  }
  const double rounding = lattice.LargestCoordinate() * std::numeric_limits<float>::epsilon(); // twice the bound
  const double columns = rounding * lattice.ColumnsPerUnit();
  if (columns > Most)
  {
    std::ostringstream text;
    text << "points in single precision, whose rounding by up to " << rounding / 2.0 << " is " << columns / 2.0
         << " columns of the lattice, expected double precision";
    throw InputError(text.str());
  }
  return std::max(Hundredth, columns);
}

PlanePoint* Columns(vtkIntArray* array)
{
  static_assert(sizeof(PlanePoint) == 2 * sizeof(int), "columns share the memory of the array");
  return reinterpret_cast<PlanePoint*>(array->GetPointer(0));
}

/// Null without a usable array Column.
vtkIntArray* FindGivenColumns(vtkPolyData* horizon)
{
  auto* const given = vtkIntArray::SafeDownCast(horizon->GetPointData()->GetAbstractArray(PointArray::Column));
  const bool fits =
    given && given->GetNumberOfComponents() == 2 && given->GetNumberOfTuples() == horizon->GetNumberOfPoints();
  return fits ? given : nullptr;
}

double DistanceToColumn(const Eigen::Vector3d& place, const PlanePoint& column)
{
  return std::max(std::abs(place.x() - column.X), std::abs(place.y() - column.Y));
}

struct Placement
{
  double Deviation = 0.0; // columns
  bool AreMerged = false; // Some points have no column.

  void Add(const Placement& other)
  {
    this->Deviation = std::max(this->Deviation, other.Deviation);
    this->AreMerged = this->AreMerged || other.AreMerged;
  }
};

/// The array Column is used if points are there, and nearest columns otherwise.
class ColumnFinder
{
public:
  ColumnFinder(vtkPolyData* horizon, bool mayBeMerged, const std::vector<vtkPolyData*>& outputs, KeptHeights heights)
    : MayBeMerged(mayBeMerged)
    , Outputs(outputs)
    , Given(FindGivenColumns(horizon))
    , Size(horizon->GetNumberOfPoints())
  {
    CheckPoints(horizon);
    this->Result.Horizon = horizon;
    this->Result.Lattice = ReadLattice(horizon);
    this->Result.Height = LargeVector<double>(heights == KeptHeights::All ? std::size_t(this->Size) : 0);
    this->Tolerance = FindTolerance(horizon, this->Result.Lattice);
  }

  LatticePoints Run()
  {
    if (!this->Given || !this->TakeGiven())
    {
      this->FindNearest();
    }
    if (IsInSinglePrecision(this->Result.Horizon))
    {
      this->MakeExactPoints();
    }
    CheckHeights(this->Result.Horizon, [this](vtkIdType point) { return this->Result.HeightAt(std::size_t(point)); });
    return std::move(this->Result);
  }

private:
  /// Calls visit(placement, point, place), in parallel, with places in lattice units, and writes heights if they are
  /// kept.
  template <typename Visit>
  Placement Place(Visit&& visit)
  {
    Placement all;
    double* const heights = this->Result.Height.empty() ? nullptr : this->Result.Height.data();
    WithCoordinates(this->Result.Horizon,
      [&](auto&& world)
      {
        all = AddUpChunks<Placement>(this->Size, Grain, Monitor(),
          [&](Placement& placement, std::int64_t first, std::int64_t last)
          {
            const Lattice lattice = this->Result.Lattice; // Writes cannot change a copy.
            for (std::int64_t point = first; point < last; ++point)
            {
              const Eigen::Vector3d place = lattice.ToLattice(world(point));
              lattice.CheckInside(place, PointId(point));
              if (heights)
              {
                heights[point] = place.z();
              }
              visit(placement, point, place);
            }
          });
      });
    return all;
  }

  /// False if points are not at the given columns, as after Transform or with the array of another horizon.
  bool TakeGiven()
  {
    const PlanePoint* const columns = Columns(this->Given);
    const Placement placement = this->Place(
      [&](Placement& part, std::int64_t point, const Eigen::Vector3d& place)
      {
        const bool isMerged = columns[point] == NoColumn;
        part.Add({ isMerged ? 0.0 : DistanceToColumn(place, columns[point]), isMerged });
      });
    // Only points that represent merged points have counts.
    const bool mayHaveMerged = this->Result.Horizon->GetPointData()->HasArray(PointArray::PointCount);
    if (placement.Deviation > this->Tolerance || (placement.AreMerged && !mayHaveMerged))
    {
      return false;
    }
    this->Result.Column = { columns, std::size_t(this->Size) };
    this->Result.AreMerged = placement.AreMerged;
    if (placement.AreMerged && !this->MayBeMerged)
    {
      const auto merged = std::find(this->Result.Column.begin(), this->Result.Column.end(), NoColumn);
      throw InputError("point " + std::to_string(merged - this->Result.Column.begin()) +
        " represents merged points, expected points on whole columns, as before a simplification");
    }
    return true;
  }

  void FindNearest()
  {
    const vtkSmartPointer<vtkIntArray> array = NewColumnArray();
    SetNumberOfTuples(array, this->Result.Horizon->GetNumberOfPoints());
    PlanePoint* const columns = Columns(array);
    const Placement placement = this->Place(
      [&](Placement& part, std::int64_t point, const Eigen::Vector3d& place)
      {
        columns[point] = { std::int32_t(std::floor(place.x() + 0.5)), std::int32_t(std::floor(place.y() + 0.5)) };
        const double distance = DistanceToColumn(place, columns[point]);
        const bool isBeside = distance > this->Tolerance;
        if (isBeside && (!this->MayBeMerged || this->Given))
        {
          throw this->BesideColumn(point, place);
        }
        part.Add({ distance, isBeside });
      });
    vtkNew<vtkPolyData> horizon;
    horizon->ShallowCopy(this->Result.Horizon);
    horizon->GetPointData()->AddArray(array);
    if (placement.AreMerged)
    {
      this->LeaveMerged(columns);
    }
    else
    {
      this->ReportDeviation(placement.Deviation);
    }
    this->Result.Horizon = horizon;
    this->Result.Column = { columns, std::size_t(this->Size) };
    this->Result.AreMerged = placement.AreMerged;
  }

  /// After merging only points exactly at a column, such as boundary points, are known to be unmerged; any merged point
  /// may be nearly at one.
  void LeaveMerged(PlanePoint* columns)
  {
    constexpr double rounding = 1e-6; // columns; rounding of double-precision world coordinates of surveys
    const double nearest = IsInSinglePrecision(this->Result.Horizon) ? this->Tolerance : rounding;
    this->Place(
      [&](Placement&, std::int64_t point, const Eigen::Vector3d& place)
      {
        if (DistanceToColumn(place, columns[point]) > nearest)
        {
          columns[point] = NoColumn;
        }
      });
  }

  void ReportDeviation(double deviation) const
  {
    for (vtkPolyData* const output : this->Outputs)
    {
      vtkFieldData* const figures = output->GetFieldData();
      vtkDataArray* const before = figures->GetArray(FieldArray::LatticeDeviation);
      if (!before || before->GetNumberOfValues() < 1 || before->GetComponent(0, 0) < deviation)
      {
        AddValue<vtkDoubleArray>(figures, FieldArray::LatticeDeviation, deviation);
      }
    }
  }

  /// The next stage must find points exactly at their columns, so coordinates become double.
  void MakeExactPoints()
  {
    auto exact = NewArray<vtkDoubleArray>("Points", this->Size, 3);
    double* const places = exact->GetPointer(0);
    WithCoordinates(this->Result.Horizon,
      [&](auto&& world)
      {
        ParallelFor(this->Size, Grain,
          [&](std::int64_t first, std::int64_t last)
          {
            for (std::int64_t point = first; point < last; ++point)
            {
              const PlanePoint column = this->Result.Column[point];
              Eigen::Vector3d place = world(point);
              if (column != NoColumn)
              {
                place.head<2>() = this->Result.Lattice.ToWorld({ double(column.X), double(column.Y), 0.0 }).head<2>();
              }
              std::copy_n(place.data(), 3, places + 3 * point);
            }
          });
      });
    vtkNew<vtkPoints> points;
    points->SetData(exact);
    vtkNew<vtkPolyData> horizon;
    horizon->ShallowCopy(this->Result.Horizon);
    horizon->SetPoints(points);
    this->Result.Horizon = horizon;
  }

  InputError BesideColumn(std::int64_t point, const Eigen::Vector3d& place) const
  {
    std::ostringstream text;
    text << "point " << point << " at (" << place.x() << ", " << place.y() << ") in lattice units, expected ";
    if (this->Given)
    {
      const PlanePoint column = Columns(this->Given)[point];
      text << "column (" << column.X << ", " << column.Y << "), which its array Column names, or another whole column";
    }
    else
    {
      text << "whole columns, as points have them before they are merged";
    }
    return InputError(text.str());
  }

  const bool MayBeMerged;
  const std::vector<vtkPolyData*>& Outputs;
  vtkIntArray* const Given;
  const vtkIdType Size;
  double Tolerance = 0.0; // columns
  LatticePoints Result;
};
}

//----------------------------------------------------------------------------------------------------------------------
double LatticePoints::HeightAt(std::size_t point) const
{
  assert(vtkIdType(point) < this->Horizon->GetNumberOfPoints());
  return this->Lattice.ToLattice(WorldOf(this->Horizon, std::int64_t(point))).z();
}

//----------------------------------------------------------------------------------------------------------------------
LatticePoints ReadColumns(vtkPolyData* horizon, const std::vector<vtkPolyData*>& outputs, KeptHeights heights)
{
  return ColumnFinder(horizon, false, outputs, heights).Run();
}

//----------------------------------------------------------------------------------------------------------------------
LatticePoints ReadPoints(vtkPolyData* horizon, const std::vector<vtkPolyData*>& outputs, KeptHeights heights)
{
  return ColumnFinder(horizon, true, outputs, heights).Run();
}

//----------------------------------------------------------------------------------------------------------------------
PlanePoints ColumnsOf(vtkPolyData* horizon)
{
  vtkIntArray* const array = FindGivenColumns(horizon); // null only without points
  return array ? PlanePoints(Columns(array), std::size_t(array->GetNumberOfTuples())) : PlanePoints();
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<PlanePoint> ToSubVoxels(const LatticePoints& points)
{
  assert(vtkIdType(points.Column.size()) == points.Horizon->GetNumberOfPoints());
  std::vector<PlanePoint> plane = LargeVector<PlanePoint>(points.Column.size());
  const std::int32_t size = points.Lattice.SubVoxelsPerColumn();
  ParallelFor(std::int64_t(plane.size()), Grain,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t point = first; point < last; ++point)
      {
        const PlanePoint column = points.Column[point];
        plane[point] = column == NoColumn
          ? points.Lattice.ToSubVoxels(points.Lattice.ToLattice(WorldOf(points.Horizon, point)), PointId(point))
          : PlanePoint{ column.X * size, column.Y * size };
      }
    });
  return plane;
}
}
