// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshSampling.h"

#include "Common/Base/Errors.h"
#include "Common/Text/TextNumbers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace SeismicHorizons
{
namespace
{
// In columns; world coordinates are rounded. Within this distance a column is on an edge, and a point on a column.
constexpr double Rounding = 1e-6;

/// Twice the area from above, positive for counterclockwise triangles.
double Area(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c)
{
  return (b.X - a.X) * (c.Y - a.Y) - (b.Y - a.Y) * (c.X - a.X);
}

/// Widens the range by the rounding, and clips it to 0 to `size` - 1.
std::array<int, 2> WholeRange(double least, double most, int size)
{
  const double first = std::max(std::ceil(least - Rounding), 0.0);
  const double last = std::min(std::floor(most + Rounding), size - 1.0);
  return first <= last ? std::array<int, 2>{ int(first), int(last) } : std::array<int, 2>{ 0, -1 };
}

class TriangleRow
{
public:
  TriangleRow(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c)
    : Corners{ &a, &b, &c }
    , FullArea(Area(a, b, c))
  {
  }

  std::array<int, 2> Rows(int size) const
  {
    const auto [least, most] = std::minmax({ this->Corners[0]->Y, this->Corners[1]->Y, this->Corners[2]->Y });
    return this->FullArea == 0.0 ? std::array<int, 2>{ 0, -1 } : WholeRange(least, most, size);
  }

  std::array<int, 2> Columns(int row, int size) const
  {
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (std::size_t side = 0; side < 3; ++side)
    {
      const SpacePoint& from = *this->Corners[side];
      const SpacePoint& to = *this->Corners[(side + 1) % 3];
      if (std::min(from.Y, to.Y) > row + Rounding || std::max(from.Y, to.Y) < row - Rounding)
      {
        continue;
      }
      const double run = to.Y - from.Y;
      const double part = run == 0.0 ? 0.0 : std::clamp((row - from.Y) / run, 0.0, 1.0);
      const double x = from.X + part * (to.X - from.X);
      least = std::min(run == 0.0 ? std::min(from.X, to.X) : x, least);
      most = std::max(run == 0.0 ? std::max(from.X, to.X) : x, most);
    }
    return WholeRange(least, most, size);
  }

  double Height(int i, int j) const
  {
    const SpacePoint column = { double(i), double(j), 0.0 };
    const auto& [a, b, c] = this->Corners;
    const double ofB = Area(*a, column, *c) / this->FullArea;
    const double ofC = Area(*a, *b, column) / this->FullArea;
    return a->Z + ofB * (b->Z - a->Z) + ofC * (c->Z - a->Z);
  }

  /// At a fault another triangle may have another height on the edge.
  bool HasInside(int i, int j) const
  {
    const SpacePoint column = { double(i), double(j), 0.0 };
    const double inward = this->FullArea > 0.0 ? 1.0 : -1.0;
    bool isInside = true;
    for (std::size_t side = 0; side < 3; ++side)
    {
      const SpacePoint& from = *this->Corners[side];
      const SpacePoint& to = *this->Corners[(side + 1) % 3];
      const double length = std::hypot(to.X - from.X, to.Y - from.Y);
      isInside = isInside && inward * Area(from, to, column) > 2.0 * Rounding * length;
    }
    return isInside;
  }

  /// Rounding of the column changes heights by this much.
  double Tolerance() const
  {
    const auto [least, most] = std::minmax({ this->Corners[0]->Z, this->Corners[1]->Z, this->Corners[2]->Z });
    return 1e-3 * (most - least) + 1e-6 * std::max(std::abs(least), std::abs(most));
  }

private:
  std::array<const SpacePoint*, 3> Corners;
  double FullArea;
};
}

//----------------------------------------------------------------------------------------------------------------------
double& MeshSampling::At(int i, int j)
{
  const std::size_t place = this->Tiles.Place(i, j);
  this->Heights.resize(this->Tiles.Size(), std::numeric_limits<double>::quiet_NaN());
  return this->Heights[place];
}

//----------------------------------------------------------------------------------------------------------------------
void MeshSampling::AddBarePoints(
  const std::vector<SpacePoint>& points, const std::function<double(std::size_t point)>& heightOf)
{
  for (std::size_t point = 0; point < points.size(); ++point)
  {
    const double i = std::round(points[point].X);
    const double j = std::round(points[point].Y);
    const bool isOnColumn = std::abs(points[point].X - i) <= Rounding && std::abs(points[point].Y - j) <= Rounding;
    if (isOnColumn && i >= 0.0 && i < this->Columns[0] && j >= 0.0 && j < this->Columns[1])
    {
      double& height = this->At(int(i), int(j));
      height = std::isnan(height) ? heightOf(point) : height;
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
void MeshSampling::AddTriangles(
  const std::vector<SpacePoint>& points, const std::vector<std::array<PointId, 3>>& triangles, const Monitor& monitor)
{
  for (std::size_t number = 0; number < triangles.size(); ++number)
  {
    if (number % 4096 == 0)
    {
      monitor.Progress(double(number) / double(triangles.size()));
    }
    const auto& [a, b, c] = triangles[number];
    const TriangleRow triangle(points[a], points[b], points[c]);
    const std::array<int, 2> rows = triangle.Rows(this->Columns[1]);
    for (int j = rows[0]; j <= rows[1]; ++j)
    {
      const std::array<int, 2> run = triangle.Columns(j, this->Columns[0]);
      for (int i = run[0]; i <= run[1]; ++i)
      {
        double& height = this->At(i, j);
        const double own = triangle.Height(i, j);
        if (std::abs(height - own) > triangle.Tolerance() && triangle.HasInside(i, j))
        {
          throw InputError("heights " + ShortestText(height) + " and " + ShortestText(own) +
            " (vertical indices) of a mesh in column (" + std::to_string(i) + ", " + std::to_string(j) +
            "), expected one in each column: a closed body or a fold is not a horizon");
        }
        height = std::isnan(height) ? own : height;
      }
    }
  }
}
}
