// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LatticePoints.h"

#include "Common/Base/Errors.h"
#include "Common/Base/FixedChunks.h"
#include "Common/Base/LargePages.h"
#include "Common/Base/Parallel.h"
#include "Common/Horizon/DataModel.h"
#include "Common/Survey/ColumnPoints.h"
#include "HorizonData.h"
#include "HorizonPoints.h"

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
void CheckPoints(const Horizon& horizon)
{
  const std::int64_t size = horizon.NumberOfPoints();
  CheckNumberOfPoints(size);
  const std::int64_t hidden = size - CountVisiblePoints(horizon);
  if (hidden > 0)
  {
    throw InputError(std::to_string(hidden) +
      " points hidden by the array vtkGhostType, expected none: only Horizon Exterior Boundary leaves them out");
  }
  if (horizon.CellData.Has(CellArray::CellSize))
  {
    throw InputError("cells of a simplification (ShowCells), expected its points");
  }
}

/// Calls work(world), with direct access to float and double coordinates.
template <typename Work>
void WithCoordinates(const Horizon& horizon, Work&& work)
{
  const auto of = [](const auto* numbers)
  {
    return [numbers](std::int64_t point)
    {
      const auto* const place = numbers + 3 * point;
      return Eigen::Vector3d(double(place[0]), double(place[1]), double(place[2]));
    };
  };
  if (const auto* const doubles = horizon.Places.As<double>())
  {
    work(of(doubles));
  }
  else if (const auto* const floats = horizon.Places.As<float>())
  {
    work(of(floats));
  }
  else
  {
    work([&horizon](std::int64_t point) { return horizon.Place(point); });
  }
}

bool IsInSinglePrecision(const Horizon& horizon)
{
  return horizon.NumberOfPoints() > 0 && horizon.Places.Type() == ValueType::Float;
}

/// columns; exceeds the rounding of world coordinates, and is below half the distance to another column.
double FindTolerance(const Horizon& horizon, const Lattice& lattice)
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

/// Null without a usable array Column.
const PlanePoint* FindGivenColumns(const Horizon& horizon)
{
  const DataArray* const given = horizon.PointData.Find(PointArray::Column);
  const bool fits =
    given && given->As<int>() && given->Components() == 2 && given->Tuples() == horizon.NumberOfPoints();
  return fits ? ColumnsIn(*given) : nullptr;
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
  ColumnFinder(const Horizon& horizon, bool mayBeMerged, KeptHeights heights)
    : MayBeMerged(mayBeMerged)
    , Given(FindGivenColumns(horizon))
    , Size(horizon.NumberOfPoints())
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
    return std::move(this->Result);
  }

  LatticePoints RunAndCheck()
  {
    LatticePoints points = this->Run();
    CheckHeights(points.Horizon, [&points](std::int64_t point) { return points.HeightAt(std::size_t(point)); });
    return points;
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
    const PlanePoint* const columns = this->Given;
    const Placement placement = this->Place(
      [&](Placement& part, std::int64_t point, const Eigen::Vector3d& place)
      {
        const bool isMerged = columns[point] == NoColumn;
        part.Add({ isMerged ? 0.0 : DistanceToColumn(place, columns[point]), isMerged });
      });
    // Only points that represent merged points have counts.
    const bool mayHaveMerged = this->Result.Horizon.PointData.Has(PointArray::PointCount);
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
    DataArray array = NewColumnArray(this->Size);
    PlanePoint* const columns = ColumnsIn(array);
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
    this->Result.Horizon.PointData.Add(std::move(array));
    if (placement.AreMerged)
    {
      this->LeaveMerged(columns);
    }
    else
    {
      this->Result.Deviation = placement.Deviation;
    }
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

  /// The next stage must find points exactly at their columns, so coordinates become double.
  void MakeExactPoints()
  {
    DataArray exact = NewArray<double>("Points", this->Size, 3);
    auto* const places = exact.As<double>();
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
    this->Result.Horizon.Places = std::move(exact);
  }

  InputError BesideColumn(std::int64_t point, const Eigen::Vector3d& place) const
  {
    std::ostringstream text;
    text << "point " << point << " at (" << place.x() << ", " << place.y() << ") in lattice units, expected ";
    if (this->Given)
    {
      const PlanePoint column = this->Given[point];
      text << "column (" << column.X << ", " << column.Y << "), which its array Column names, or another whole column";
    }
    else
    {
      text << "whole columns, as points have them before they are merged";
    }
    return InputError(text.str());
  }

  const bool MayBeMerged;
  const PlanePoint* const Given; // null without a usable array
  const std::int64_t Size;
  double Tolerance = 0.0; // columns
  LatticePoints Result;
};
}

//----------------------------------------------------------------------------------------------------------------------
double LatticePoints::HeightAt(std::size_t point) const
{
  assert(std::int64_t(point) < this->Horizon.NumberOfPoints());
  return this->Lattice.ToLattice(this->Horizon.Place(std::int64_t(point))).z();
}

//----------------------------------------------------------------------------------------------------------------------
LatticePoints ReadColumns(const Horizon& horizon, KeptHeights heights)
{
  return ColumnFinder(horizon, false, heights).RunAndCheck();
}

//----------------------------------------------------------------------------------------------------------------------
LatticePoints ReadPoints(const Horizon& horizon, KeptHeights heights)
{
  return ColumnFinder(horizon, true, heights).RunAndCheck();
}

//----------------------------------------------------------------------------------------------------------------------
void CheckNumberOfPoints(std::int64_t size)
{
  if (size > std::numeric_limits<PointId>::max() / 4)
  {
    throw InputError(std::to_string(size) + " points, expected less than 2^29 in one horizon");
  }
}

//----------------------------------------------------------------------------------------------------------------------
LatticePoints ReadColumnsOfPart(const Horizon& part)
{
  return ColumnFinder(part, false, KeptHeights::All).Run();
}

//----------------------------------------------------------------------------------------------------------------------
void WriteDeviation(const LatticePoints& points, std::vector<Horizon>& outputs)
{
  for (Horizon& output : outputs)
  {
    if (points.Deviation && FirstValue(output.FieldData, FieldArray::LatticeDeviation, -1.0) < *points.Deviation)
    {
      AddValue<double>(output.FieldData, FieldArray::LatticeDeviation, *points.Deviation);
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
PlanePoints ColumnsOf(const Horizon& horizon)
{
  const PlanePoint* const columns = FindGivenColumns(horizon); // null only without points
  return columns ? PlanePoints(columns, std::size_t(horizon.NumberOfPoints())) : PlanePoints();
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<PlanePoint> ToSubVoxels(const LatticePoints& points)
{
  assert(std::int64_t(points.Column.size()) == points.Horizon.NumberOfPoints());
  std::vector<PlanePoint> plane = LargeVector<PlanePoint>(points.Column.size());
  const std::int32_t size = points.Lattice.SubVoxelsPerColumn();
  ParallelFor(std::int64_t(plane.size()), Grain,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t point = first; point < last; ++point)
      {
        const PlanePoint column = points.Column[point];
        plane[point] = column == NoColumn
          ? points.Lattice.ToSubVoxels(points.Lattice.ToLattice(points.Horizon.Place(point)), PointId(point))
          : PlanePoint{ column.X * size, column.Y * size };
      }
    });
  return plane;
}
}
