// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LayerCells.h"

#include "Common/Horizon/Predicates.h"
#include "Common/Horizon/VolumeGrid.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cassert>
#include <limits>

namespace SeismicHorizons
{
namespace
{
using TriangleCorners = std::array<PointId, 3>;

TriangleCorners CornersOf(const RawVector<PointId>& triangles, std::size_t triangle)
{
  const PointId* const first = triangles.data() + 3 * triangle;
  return { first[0], first[1], first[2] };
}

double AreaOf(const LayerPlan& plan, const TriangleCorners& corners)
{
  const auto at = [&](int corner) { return plan.Columns[std::size_t(corners[std::size_t(corner)])]; };
  return 0.5 * double(SignedArea(at(0), at(1), at(2)));
}

std::array<double, 3> ThicknessOf(const LayerPlan& plan, std::size_t layer, const TriangleCorners& corners)
{
  return { plan.Thickness(layer, corners[0]), plan.Thickness(layer, corners[1]), plan.Thickness(layer, corners[2]) };
}

double MeanOf(const std::array<double, 3>& values)
{
  return (values[0] + values[1] + values[2]) / 3.0;
}

void MeasureFaults(const LayerPlan& plan, std::size_t layer, LayerVolume& result)
{
  for (std::size_t triangle = 0; triangle < plan.FaultTriangles.size() / 3; ++triangle)
  {
    if (plan.IsAround.empty() || plan.IsAround[layer][triangle] != 0)
    {
      const TriangleCorners corners = CornersOf(plan.FaultTriangles, triangle);
      const double area = plan.FaultShare * AreaOf(plan, corners);
      result.FaultArea += area;
      result.FaultVolume += area * MeanOf(ThicknessOf(plan, layer, corners));
    }
  }
}

class CellMaker
{
public:
  CellMaker(const LayerPlan& plan, const LayerCellOptions& options)
    : Plan(plan)
    , Options(options)
    , Inside(plan.NumberOfLayers(), std::vector<PointId>(plan.Columns.size(), NoPoint))
  {
  }

  LayerCells Run(const Monitor& monitor)
  {
    this->MakePoints();
    for (std::size_t layer = 0; layer < this->Plan.NumberOfLayers(); ++layer)
    {
      monitor.Progress(double(layer + 1) / double(this->Plan.NumberOfHorizons()));
      for (std::size_t triangle = 0; triangle < this->Plan.NumberOfTriangles(); ++triangle)
      {
        this->AddCells(layer, triangle);
      }
    }
    return std::move(this->Result);
  }

private:
  void MakePoints()
  {
    const std::vector<std::vector<unsigned char>> isUsed = this->FindUsed();
    this->Result.PointsOfHorizons.assign(
      this->Plan.NumberOfHorizons(), std::vector<PointId>(this->Plan.Columns.size(), NoPoint));
    for (std::size_t vertex = 0; vertex < this->Plan.Columns.size(); ++vertex)
    {
      bool isAny = false;
      for (std::size_t horizon = 0; horizon < this->Plan.NumberOfHorizons(); ++horizon)
      {
        const bool isTop = horizon < this->Plan.NumberOfLayers() && isUsed[horizon][vertex] != 0;
        if (!isTop && (horizon == 0 || isUsed[horizon - 1][vertex] == 0))
        {
          continue;
        }
        const double height = this->Plan.Heights[horizon][vertex];
        if (!isAny || height != this->Result.Heights.back())
        {
          this->AddPoint(vertex, height);
        }
        isAny = true;
        this->Result.PointsOfHorizons[horizon][vertex] = PointId(this->Result.Vertices.size() - 1);
        if (isTop && this->Plan.Thickness(horizon, PointId(vertex)) > 0.0)
        {
          this->AddPointsInside(horizon, vertex);
        }
      }
    }
  }

  void AddPoint(std::size_t vertex, double height)
  {
    this->Result.Vertices.push_back(PointId(vertex));
    this->Result.Heights.push_back(height);
  }

  void AddPointsInside(std::size_t layer, std::size_t vertex)
  {
    const double top = this->Plan.Heights[layer][vertex];
    const double thickness = this->Plan.Heights[layer + 1][vertex] - top;
    this->Inside[layer][vertex] = PointId(this->Result.Vertices.size());
    for (int n = 1; n < this->Options.SublayersOf(layer); ++n)
    {
      this->AddPoint(vertex, top + thickness * n / this->Options.SublayersOf(layer));
    }
  }

  /// `level` is 0 for the top of the layer, and the number of sublayers for its base.
  PointId PointAt(std::size_t layer, int level, PointId vertex) const
  {
    const PointId first = this->Inside[layer][std::size_t(vertex)];
    return level > 0 && level < this->Options.SublayersOf(layer) && first != NoPoint
      ? first + level - 1
      : this->Result.PointsOfHorizons[level == 0 ? layer : layer + 1][std::size_t(vertex)];
  }

  /// By layer and vertex.
  std::vector<std::vector<unsigned char>> FindUsed() const
  {
    std::vector<std::vector<unsigned char>> isUsed(
      this->Plan.NumberOfLayers(), std::vector<unsigned char>(this->Plan.Columns.size(), 0));
    for (std::size_t layer = 0; layer < this->Plan.NumberOfLayers(); ++layer)
    {
      for (std::size_t triangle = 0; triangle < this->Plan.NumberOfTriangles(); ++triangle)
      {
        if (!this->Plan.HasLayer(layer, triangle))
        {
          continue;
        }
        for (const PointId vertex : CornersOf(this->Plan.Triangles, triangle))
        {
          isUsed[layer][std::size_t(vertex)] = 1;
        }
      }
    }
    return isUsed;
  }

  void AddCells(std::size_t layer, std::size_t triangle)
  {
    if (!this->Plan.HasLayer(layer, triangle))
    {
      return;
    }
    const TriangleCorners corners = CornersOf(this->Plan.Triangles, triangle);
    const std::array<double, 3> thickness = ThicknessOf(this->Plan, layer, corners);
    const auto thick = std::count_if(thickness.begin(), thickness.end(), [](double one) { return one > 0.0; });
    if (thick == 0)
    {
      return;
    }
    const bool isTopHigh = !this->Plan.HeightsGrowDownwards;
    const double mean = MeanOf(thickness) / this->Options.SublayersOf(layer);
    for (int sublayer = 0; sublayer < this->Options.SublayersOf(layer); ++sublayer)
    {
      std::vector<PointId> cell;
      AddCorners(
        corners, thickness, int(thick),
        [&](PointId vertex) { return this->PointAt(layer, isTopHigh ? sublayer : sublayer + 1, vertex); },
        [&](PointId vertex) { return this->PointAt(layer, isTopHigh ? sublayer + 1 : sublayer, vertex); }, cell);
      const auto add = [&](const std::vector<PointId>& points, double volume)
      {
        this->Result.Corners.insert(this->Result.Corners.end(), points.begin(), points.end());
        this->Result.Ends.push_back(std::int64_t(this->Result.Corners.size()));
        this->Result.Layers.push_back(std::int32_t(layer));
        this->Result.Sublayers.push_back(sublayer);
        this->Result.Triangles.push_back(std::int32_t(triangle));
        this->Result.Thickness.push_back(mean);
        this->Result.Volumes.push_back(volume);
      };
      if (this->Options.Tetrahedra && thick > 1)
      {
        this->Split(cell, add);
        continue;
      }
      add(cell, AreaOf(this->Plan, corners) * mean);
    }
  }

  /// Tetrahedra from the point with the smallest number to the faces without it. Neighbours split a quadrangle alike,
  /// through its smallest number.
  template <typename Visitor>
  void Split(const std::vector<PointId>& cell, Visitor&& visit) const
  {
    const PointId apex = *std::min_element(cell.begin(), cell.end());
    for (std::vector<std::size_t> face : FacesOfCell(cell.size()))
    {
      std::rotate(face.begin(),
        std::min_element(face.begin(), face.end(), [&](std::size_t a, std::size_t b) { return cell[a] < cell[b]; }),
        face.end());
      for (std::size_t n = 2; n < face.size() && cell[face[0]] != apex; ++n)
      {
        const std::vector<PointId> corners = { cell[face[0]], cell[face[n]], cell[face[n - 1]], apex };
        visit(corners, this->VolumeOf(corners));
      }
    }
  }

  double VolumeOf(const std::vector<PointId>& corners) const
  {
    const auto at = [&](std::size_t n)
    {
      const auto point = std::size_t(corners[n]);
      const PlanePoint& column = this->Plan.Columns[std::size_t(this->Result.Vertices[point])];
      return Eigen::Vector3d(column.X, column.Y, this->Result.Heights[point]);
    };
    return (at(1) - at(0)).cross(at(2) - at(0)).dot(at(3) - at(0)) / 6.0;
  }

  //       wedge            pyramid           tetrahedron
  //
  //      0-------2        3-------2            3
  //      |\     /|        |\     /|            |\ .
  //      | \   / |        | \   / |            | \ .
  //      |  \ /  |        |  \ /  |            |  \ .
  //      3---1---5        0---4---1            0---\---2
  //       \  |  /          \  |  /              \   \ /
  //        \ | /            \ | /                \   /
  //          4                4                    1
  template <typename High, typename Low>
  static void AddCorners(const TriangleCorners& corners, const std::array<double, 3>& thickness, int thick, High&& high,
    Low&& low, std::vector<PointId>& result)
  {
    const auto add = [&result](const auto& pointAt, PointId vertex) { result.push_back(pointAt(vertex)); };
    if (thick == 3)
    {
      std::for_each(corners.begin(), corners.end(), [&](PointId vertex) { add(high, vertex); });
      std::for_each(corners.begin(), corners.end(), [&](PointId vertex) { add(low, vertex); });
      return;
    }
    // The corner unlike the two others comes first, these follow counter-clockwise.
    std::size_t odd = 0;
    while ((thickness[odd] > 0.0) != (thick == 1))
    {
      ++odd;
    }
    const PointId single = corners[odd];
    const PointId next = corners[(odd + 1) % 3];
    const PointId last = corners[(odd + 2) % 3];
    if (thick == 1)
    {
      add(low, single);
      add(low, next);
      add(low, last);
      add(high, single);
      return;
    }
    add(low, last);
    add(low, next);
    add(high, next);
    add(high, last);
    add(low, single);
  }

  const LayerPlan& Plan;
  const LayerCellOptions& Options;
  std::vector<std::vector<PointId>> Inside; // the first point between sublayers, by layer and vertex
  LayerCells Result;
};
}

//----------------------------------------------------------------------------------------------------------------------
LayerCells MakeLayerCells(const LayerPlan& plan, const LayerCellOptions& options, const Monitor& monitor)
{
  assert(HaveAll(plan.Heights, plan.Columns.size()));
  assert(plan.Triangles.size() % 3 == 0 && plan.FaultTriangles.size() % 3 == 0);
  assert(plan.IsIn.empty() || plan.IsIn.size() == plan.NumberOfLayers());
  return CellMaker(plan, options).Run(monitor);
}

//----------------------------------------------------------------------------------------------------------------------
LayerVolume MeasureLayer(const LayerPlan& plan, std::size_t layer)
{
  assert(layer < plan.NumberOfLayers());
  LayerVolume result;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t triangle = 0; triangle < plan.NumberOfTriangles(); ++triangle)
  {
    if (!plan.HasLayer(layer, triangle))
    {
      continue;
    }
    const TriangleCorners corners = CornersOf(plan.Triangles, triangle);
    const std::array<double, 3> thickness = ThicknessOf(plan, layer, corners);
    const auto thick = std::count_if(thickness.begin(), thickness.end(), [](double one) { return one > 0.0; });
    ++result.Triangles[std::size_t(thick)];
    if (thick > 0)
    {
      const double area = AreaOf(plan, corners);
      result.Area += area;
      result.Volume += area * MeanOf(thickness);
      least = std::min(least, *std::min_element(thickness.begin(), thickness.end()));
      result.LargestThickness =
        std::max(result.LargestThickness, *std::max_element(thickness.begin(), thickness.end()));
    }
  }
  if (result.Area > 0.0)
  {
    result.MeanThickness = result.Volume / result.Area;
    result.LeastThickness = least;
  }
  MeasureFaults(plan, layer, result);
  return result;
}

//----------------------------------------------------------------------------------------------------------------------
double IntegrateAboveZero(double area, std::array<double, 3> values)
{
  assert(area >= 0.0);
  std::sort(values.begin(), values.end());
  const auto [least, middle, most] = values;
  if (most <= 0.0)
  {
    return 0.0;
  }
  if (middle <= 0.0) // a tetrahedron beside the largest value
  {
    return area * most * (most / (most - least)) * (most / (most - middle)) / 3.0;
  }
  const double all = area * MeanOf(values);
  if (least >= 0.0)
  {
    return all;
  }
  return all - area * least * (least / (middle - least)) * (least / (most - least)) / 3.0;
}

//----------------------------------------------------------------------------------------------------------------------
double VolumeAbove(const LayerPlan& plan, std::size_t layer, double contact)
{
  assert(layer < plan.NumberOfLayers());
  const double sign = plan.HeightsGrowDownwards ? -1.0 : 1.0;
  const auto above = [&](std::size_t horizon, PointId vertex)
  { return sign * (plan.Heights[horizon][std::size_t(vertex)] - contact); };
  double volume = 0.0;
  for (std::size_t triangle = 0; triangle < plan.NumberOfTriangles(); ++triangle)
  {
    if (!plan.HasLayer(layer, triangle))
    {
      continue;
    }
    const TriangleCorners corners = CornersOf(plan.Triangles, triangle);
    const double area = AreaOf(plan, corners);
    const auto part = [&](std::size_t horizon)
    {
      return IntegrateAboveZero(
        area, { above(horizon, corners[0]), above(horizon, corners[1]), above(horizon, corners[2]) });
    };
    volume += part(layer) - part(layer + 1);
  }
  return volume;
}
}
