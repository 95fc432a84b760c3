// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LatticePoints.h"

#include "Common/DataModel.h"
#include "Common/Errors.h"
#include "Common/Parallel.h"
#include "HorizonData.h"
#include "HorizonPoints.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <sstream>
#include <string>

namespace SeismicHorizons
{
namespace
{
constexpr std::int64_t Grain = 16384; // points that a thread takes at a time

/// How many lattice units points rise for each vertical index, by a line through some of them; 1 when they are too
/// level to tell, or there are no vertical indices.
double MeasureStretch(vtkPolyData* horizon, const std::vector<double>& height)
{
  vtkDataArray* const index = FindNumbers(horizon->GetPointData(), PointArray::VerticalIndex);
  if (!index || index->GetNumberOfTuples() != vtkIdType(height.size()))
  {
    return 1.0;
  }
  constexpr std::size_t Enough = 1000;
  std::vector<Eigen::Vector2d> pairs;
  for (std::size_t point = 0; point < height.size(); point += height.size() / Enough + 1)
  {
    pairs.emplace_back(index->GetComponent(vtkIdType(point), 0), height[point]);
  }
  const Eigen::Vector2d sum = std::accumulate(pairs.begin(), pairs.end(), Eigen::Vector2d(0.0, 0.0));
  const Eigen::Vector2d mean = sum / double(pairs.size());
  double square = 0.0;
  double product = 0.0;
  for (const Eigen::Vector2d& pair : pairs)
  {
    square += (pair.x() - mean.x()) * (pair.x() - mean.x());
    product += (pair.x() - mean.x()) * (pair.y() - mean.y());
  }
  constexpr double LeastDeviation = 2.0; // vertical indices: with less, rounding and real z could decide
  return square > LeastDeviation * LeastDeviation * double(pairs.size()) ? product / square : 1.0;
}

/// Transform moves points, and leaves the lattice in the field data as it is.
void CheckHeights(vtkPolyData* horizon, const std::vector<double>& height)
{
  // Real z is not a multiple of the vertical index, but in a survey about as long everywhere.
  constexpr double MostStretch = 2.0;
  const double stretch = MeasureStretch(horizon, height);
  if (stretch < 1.0 / MostStretch || stretch > MostStretch)
  {
    std::ostringstream text;
    text << "points rise by " << stretch
         << " lattice units for each vertical index, expected 1: where points were moved or scaled, as by Transform, "
            "the lattice in LatticeToWorld is no longer theirs";
    throw InputError(text.str());
  }
}
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
      " hidden points by the array vtkGhostType, expected none: only Horizon Exterior Boundary leaves them out");
  }
  if (horizon->GetCellData()->HasArray(CellArray::CellSize))
  {
    throw InputError("the cells of a simplification, as ShowCells gives them to look at, expected its points");
  }
}

/// Puts points on the lattice, on threads. `world(point)` gives the coordinates of one.
template <typename World>
void PutOnLattice(LatticePoints& points, World&& world)
{
  ParallelFor(std::int64_t(points.Plane.size()), Grain,
    [&](std::int64_t first, std::int64_t last)
    {
      const Lattice grid = points.Grid; // a copy, which no write to the arrays can change
      for (std::int64_t point = first; point < last; ++point)
      {
        const Eigen::Vector3d place = grid.ToLattice(world(point));
        points.Plane[std::size_t(point)] = grid.ToSubVoxels(place, PointId(point));
        points.Height[std::size_t(point)] = place.z();
      }
    });
}

/// The coordinates in an array, three numbers for each point.
template <typename Number>
auto Coordinates(const Number* numbers)
{
  return [numbers](std::int64_t point)
  {
    const Number* const place = numbers + 3 * point;
    return Eigen::Vector3d(double(place[0]), double(place[1]), double(place[2]));
  };
}

/// What is wrong with a point that is on no column.
InputError BesideColumn(std::size_t point, const PlanePoint& place, const Lattice& grid)
{
  return InputError("point " + std::to_string(point) + " at (" + std::to_string(grid.ToLatticeUnits(place.X)) + ", " +
    std::to_string(grid.ToLatticeUnits(place.Y)) +
    ") in lattice units, expected whole columns, as points have them before they are merged");
}
}

//----------------------------------------------------------------------------------------------------------------------
LatticePoints ReadPoints(vtkPolyData* horizon)
{
  CheckPoints(horizon);
  LatticePoints points;
  points.Grid = ReadLattice(horizon);
  points.Plane.resize(std::size_t(horizon->GetNumberOfPoints()));
  points.Height.resize(points.Plane.size());
  vtkDataArray* const coordinates = horizon->GetNumberOfPoints() > 0 ? horizon->GetPoints()->GetData() : nullptr;
  if (auto* const doubles = vtkDoubleArray::FastDownCast(coordinates))
  {
    PutOnLattice(points, Coordinates(doubles->GetPointer(0)));
  }
  else if (auto* const floats = vtkFloatArray::FastDownCast(coordinates))
  {
    PutOnLattice(points, Coordinates(floats->GetPointer(0)));
  }
  else
  {
    PutOnLattice(points,
      [horizon](std::int64_t point)
      {
        Eigen::Vector3d world;
        horizon->GetPoint(point, world.data());
        return world;
      });
  }
  CheckHeights(horizon, points.Height);
  return points;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<PlanePoint> ToColumns(std::vector<PlanePoint> plane, const Lattice& grid, ColumnTolerance tolerance)
{
  const std::int32_t size = grid.SubVoxelsPerColumn();
  const std::int32_t farthest = size / 100;
  ParallelFor(std::int64_t(plane.size()), Grain,
    [&](std::int64_t first, std::int64_t last)
    {
      for (auto point = std::size_t(first); point < std::size_t(last); ++point)
      {
        const PlanePoint place = plane[point];
        const PlanePoint column = grid.NearestColumn(place);
        if (std::abs(place.X - column.X * size) > farthest || std::abs(place.Y - column.Y * size) > farthest)
        {
          throw BesideColumn(point, place, grid);
        }
        if (tolerance == ColumnTolerance::None && (place.X != column.X * size || place.Y != column.Y * size))
        {
          throw InputError("point " + std::to_string(point) + " stands beside its column, expected whole columns");
        }
        plane[point] = column;
      }
    });
  return plane;
}
}
