// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Sublayers and tetrahedra against the cells that they divide: volumes, and faces that fit together.

#ifndef SeismicHorizonsDivisionChecker_h
#define SeismicHorizonsDivisionChecker_h

#include "Filters/Algorithms/Layers/LayerCells.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace DivisionChecker
{
using namespace SeismicHorizons;

struct Border
{
  double Area = 0.0; // of faces that one cell has
  std::size_t MostCells = 0; // that share a face
};

inline Eigen::Vector3d PlaceOf(const LayerPlan& plan, const LayerCells& cells, PointId point)
{
  const PlanePoint& column = plan.Columns[std::size_t(cells.Vertices[std::size_t(point)])];
  return { double(column.X), double(column.Y), cells.Heights[std::size_t(point)] };
}

inline Border FindBorder(const LayerPlan& plan, const LayerCells& cells)
{
  const std::map<std::size_t, std::vector<std::vector<std::size_t>>> faces = {
    { 4, { { 0, 1, 2 }, { 0, 1, 3 }, { 0, 2, 3 }, { 1, 2, 3 } } },
    { 5, { { 0, 1, 2, 3 }, { 0, 1, 4 }, { 1, 2, 4 }, { 2, 3, 4 }, { 0, 3, 4 } } },
    { 6, { { 0, 1, 2 }, { 3, 4, 5 }, { 0, 1, 4, 3 }, { 1, 2, 5, 4 }, { 0, 2, 5, 3 } } }
  };
  std::map<std::vector<PointId>, std::pair<double, std::size_t>> found;
  for (std::size_t cell = 0; cell < cells.Size(); ++cell)
  {
    for (const std::vector<std::size_t>& corners : faces.at(cells.SizeOf(cell)))
    {
      std::vector<PointId> points;
      for (const std::size_t corner : corners)
      {
        points.push_back(cells.Corners[std::size_t(cells.Begin(cell)) + corner]);
      }
      double area = 0.0;
      const Eigen::Vector3d first = PlaceOf(plan, cells, points[0]);
      for (std::size_t n = 2; n < points.size(); ++n)
      {
        const Eigen::Vector3d edge = PlaceOf(plan, cells, points[n - 1]) - first;
        area += edge.cross(PlaceOf(plan, cells, points[n]) - first).norm() / 2.0;
      }
      std::sort(points.begin(), points.end());
      auto& [own, count] = found[points];
      own = area;
      ++count;
    }
  }
  Border border;
  for (const auto& [points, own] : found)
  {
    border.Area += own.second == 1 ? own.first : 0.0;
    border.MostCells = std::max(border.MostCells, own.second);
  }
  return border;
}

/// Empty if all is as it should be.
inline std::string Check(const LayerPlan& plan, const LayerCells& whole)
{
  std::ostringstream wrong;
  const double area = FindBorder(plan, whole).Area;
  for (const bool tetrahedra : { false, true })
  {
    LayerCellOptions options;
    options.Tetrahedra = tetrahedra;
    for (std::size_t layer = 0; layer < plan.NumberOfLayers(); ++layer)
    {
      options.Sublayers.push_back(1 + int(layer + (tetrahedra ? 1 : 0)) % 3);
    }
    const LayerCells cells = MakeLayerCells(plan, options);
    const Border border = FindBorder(plan, cells);
    if (border.MostCells > 2 || std::abs(border.Area - area) > 1e-9 * (1.0 + area))
    {
      wrong << "a border of " << border.Area << " for " << area << ", a face of " << border.MostCells << " cells; ";
    }
    std::vector<std::vector<double>> volumes(plan.NumberOfLayers(), std::vector<double>(3, 0.0));
    for (std::size_t cell = 0; cell < cells.Size(); ++cell)
    {
      volumes[std::size_t(cells.Layers[cell])][std::size_t(cells.Sublayers[cell])] += cells.Volumes[cell];
      if (!(cells.Volumes[cell] > 0.0) || (tetrahedra && cells.SizeOf(cell) != 4))
      {
        wrong << "a cell of " << cells.SizeOf(cell) << " corners, volume " << cells.Volumes[cell] << "; ";
      }
    }
    for (std::size_t layer = 0; layer < plan.NumberOfLayers(); ++layer)
    {
      const double volume = MeasureLayer(plan, layer).Volume / options.Sublayers[layer];
      for (int n = 0; n < options.Sublayers[layer]; ++n)
      {
        if (std::abs(volumes[layer][std::size_t(n)] - volume) > 1e-9 * (1.0 + volume))
        {
          wrong << "sublayer of " << volumes[layer][std::size_t(n)] << " for " << volume << "; ";
        }
      }
    }
  }
  return wrong.str();
}
}

#endif
