// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Sheets.h"

#include "Filters/Algorithms/Surface/Surface.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
Sheet MeshSheet(const SheetHeights& heights, double error, const Monitor& monitor)
{
  Sheet sheet;
  sheet.Axes = heights.Axes;
  const auto width = std::size_t(heights.Width);
  SurfacePoints points;
  std::vector<PlanePoint> columns;
  for (std::size_t node = 0; node < heights.Heights.size(); ++node)
  {
    if (std::isfinite(heights.Heights[node]))
    {
      columns.push_back({ std::int32_t(node % width), std::int32_t(node / width) });
      points.Height.push_back(heights.Heights[node]);
    }
  }
  points.Columns = columns;
  SurfaceOptions options;
  options.MaximumError = error;
  options.Radius = 1;
  options.KeepHoles = false;
  options.OutlineTolerance = 0.75; // They are cut off.
  options.FitHeights = false;
  const Surface surface = MakeSurface(points, options, monitor);
  for (std::size_t vertex = 0; vertex < surface.Mesh.Points.Plane.size(); ++vertex)
  {
    const PlanePoint& column = surface.Mesh.Points.Plane[vertex];
    const Eigen::Vector3d place(heights.Origin.x() + heights.Step.x() * column.X,
      heights.Origin.y() + heights.Step.y() * column.Y, surface.Mesh.Points.Height[vertex]);
    sheet.Vertices.emplace_back(heights.Axes.transpose() * place);
  }
  for (std::size_t n = 0; n + 2 < surface.Mesh.Triangles.size(); n += 3)
  {
    sheet.Triangles.push_back({ std::int32_t(surface.Mesh.Triangles[n]), std::int32_t(surface.Mesh.Triangles[n + 1]),
      std::int32_t(surface.Mesh.Triangles[n + 2]) });
  }
  return sheet;
}

//----------------------------------------------------------------------------------------------------------------------
Sheet MakePlaneSheet(
  const Eigen::Vector3d& corner, const Eigen::Vector3d& along, const Eigen::Vector3d& up, double size)
{
  Sheet sheet;
  sheet.IsPlane = true;
  sheet.Axes.row(0) = along.normalized();
  sheet.Axes.row(1) = up.normalized();
  sheet.Axes.row(2) = sheet.Axes.row(0).cross(sheet.Axes.row(1));
  for (int axis = 0; axis < 3; ++axis)
  {
    sheet.LevelAxis = along[axis] == 0.0 && up[axis] == 0.0 ? axis : sheet.LevelAxis;
  }
  const int columns = std::max(1, int(std::round(along.norm() / size))),
            rows = std::max(1, int(std::round(up.norm() / size)));
  for (int row = 0; row <= rows; ++row)
  {
    for (int column = 0; column <= columns; ++column)
    {
      sheet.Vertices.emplace_back(corner + along * column / columns + up * row / rows);
      if (row < rows && column < columns)
      {
        const std::int32_t first = row * (columns + 1) + column, above = first + columns + 1;
        sheet.Triangles.push_back({ first, first + 1, above });
        sheet.Triangles.push_back({ first + 1, above + 1, above });
      }
    }
  }
  return sheet;
}

//----------------------------------------------------------------------------------------------------------------------
void Shake(std::vector<Sheet>& sheets, double distance, unsigned round)
{
  std::uint64_t state = 0x9E3779B97F4A7C15U * (round + 1U);
  const auto next = [&state]
  {
    state = state * 6364136223846793005U + 1442695040888963407U; // Knuth's MMIX
    return double(state >> 33U) / double(1U << 31U) * 2.0 - 1.0;
  };
  constexpr double least = 0.01; // along the normal
  for (Sheet& sheet : sheets)
  {
    const double level = sheet.LevelAxis ? sheet.Level() : 0.0;
    for (Eigen::Vector3d& vertex : sheet.Vertices)
    {
      const Eigen::Vector3d move = distance * Eigen::Vector3d(next(), next(), sheet.IsPlane ? 0.0 : least * next());
      vertex += sheet.Axes.transpose() * move;
      if (sheet.LevelAxis)
      {
        vertex[*sheet.LevelAxis] = level;
      }
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
SheetLocator::SheetLocator(const Sheet& sheet)
  : Given(sheet)
{
  std::vector<BoxTree::Entry> entries;
  for (std::size_t n = 0; n < sheet.Triangles.size(); ++n)
  {
    BoxTree::Entry& entry = entries.emplace_back(BoxTree::Entry{ std::int32_t(n), {} });
    for (const std::int32_t corner : sheet.Triangles[n])
    {
      const Eigen::Vector3d place = sheet.Axes * sheet.Vertices[std::size_t(corner)];
      entry.Box.extend(Eigen::Vector3d(place.x(), place.y(), 0.0));
    }
  }
  this->Triangles = BoxTree(entries);
}

//----------------------------------------------------------------------------------------------------------------------
std::optional<double> SheetLocator::HeightAbove(const Eigen::Vector3d& place) const
{
  const Eigen::Vector3d at = this->Given.Axes * place;
  std::optional<double> height;
  this->Triangles.Any(Eigen::AlignedBox3d(Eigen::Vector3d(at.x(), at.y(), 0.0)),
    [&](std::int32_t n)
    {
      const SheetCorners& corners = this->Given.Triangles[std::size_t(n)];
      const Eigen::Vector3d a = this->Given.Axes * this->Given.Vertices[std::size_t(corners[0])];
      const Eigen::Vector3d b = this->Given.Axes * this->Given.Vertices[std::size_t(corners[1])] - a;
      const Eigen::Vector3d c = this->Given.Axes * this->Given.Vertices[std::size_t(corners[2])] - a;
      const Eigen::Vector3d p = at - a;
      const double area = b.x() * c.y() - b.y() * c.x();
      const double v = (p.x() * c.y() - p.y() * c.x()) / area, w = (b.x() * p.y() - b.y() * p.x()) / area;
      constexpr double rounding = 1e-9;
      if (v >= -rounding && w >= -rounding && v + w <= 1.0 + rounding)
      {
        height = p.z() - v * b.z() - w * c.z();
      }
      return height.has_value();
    });
  return height;
}
}
