// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CutTraces.h"

#include "Common/Horizon/DataModel.h"
#include "Filters/Algorithms/Faults/ColumnHeights.h"
#include "Filters/Common/CutData.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace SeismicHorizons
{
namespace
{
/// By fault; names in the order of the first cuts.
struct HorizonTraces
{
  std::vector<std::string> Names;
  std::map<std::string, std::vector<std::vector<TraceCut>>> ByFault;
  std::map<std::string, std::vector<std::size_t>> Horizons; // by fault
};

/// Heights are those of the nearest columns with a point along the link. Cuts without one on both sides are left out.
std::map<int, std::vector<TraceCut>> ReadTraceCuts(const LatticePoints& points, const DataArray& numbers, double gap)
{
  const std::vector<LatticeLink> links = ReadFaultedLinks(points.Horizon);
  RequireTuples(numbers, std::int64_t(links.size()), "faulted links");
  const ColumnHeights heights(points.Column, points.Height);
  const LinkGrid& grid = heights.Grid();
  const auto find = [&](PlanePoint column, const PlanePoint& step) -> std::optional<Eigen::Vector3d>
  {
    for (double n = 0.0; n <= gap; ++n, column = { column.X + step.X, column.Y + step.Y })
    {
      const std::int64_t x = std::int64_t(column.X) - grid.Origin().X, y = std::int64_t(column.Y) - grid.Origin().Y;
      const bool isIn = x >= 0 && y >= 0 && x < grid.Width() && y < grid.Height();
      if (!isIn)
      {
        return std::nullopt;
      }
      const double height = heights[grid.ColumnOf(column)];
      if (!std::isnan(height))
      {
        return points.Lattice.ToWorld(Eigen::Vector3d(column.X, column.Y, height));
      }
    }
    return std::nullopt;
  };
  std::map<int, std::vector<TraceCut>> lines;
  for (std::size_t n = 0; n < links.size(); ++n)
  {
    const PlanePoint from = links[n].Column, to = links[n].Beyond();
    const PlanePoint step = { to.X - from.X, to.Y - from.Y };
    const auto before = find(from, { -step.X, -step.Y }), beyond = find(to, step);
    if (before && beyond)
    {
      const Eigen::Vector2d way = (*beyond - *before).head<2>();
      const double link = (points.Lattice.ToWorld({ double(to.X), double(to.Y), 0.0 }) -
        points.Lattice.ToWorld({ double(from.X), double(from.Y), 0.0 }))
                            .head<2>()
                            .norm();
      lines[int(numbers.Value(std::int64_t(n)))].push_back(
        { 0.5 * (*before + *beyond), (before->z() - beyond->z()) * way.normalized(), way.norm() - link });
    }
  }
  return lines;
}

void AddTraces(const CutInput& horizon, std::size_t own, double gap, HorizonTraces& traces)
{
  const LatticePoints& points = horizon.Points;
  const DataArray* const numbers = FindNumbers(points.Horizon.FieldData, FieldArray::FaultLine);
  const DataArray* const faults = points.Horizon.FieldData.Find(FieldArray::FaultNames);
  if (!numbers)
  {
    return;
  }
  for (auto& [number, cuts] : ReadTraceCuts(points, *numbers, gap))
  {
    constexpr std::size_t fewest = 3;
    if (cuts.size() < fewest)
    {
      continue;
    }
    const bool isNamed = faults && faults->IsText() && number >= 0 && number < int(faults->Texts().size());
    std::string fault = isNamed ? faults->Texts()[std::size_t(number)] : "fault " + std::to_string(number + 1);
    if (fault.rfind("fault ", 0) == 0) // Numbers of detected faults are those of one horizon.
    {
      fault = horizon.Name + " " + fault;
    }
    std::vector<std::vector<TraceCut>>& ofFault = traces.ByFault[fault];
    if (ofFault.empty())
    {
      traces.Names.push_back(fault);
    }
    ofFault.push_back(std::move(cuts));
    traces.Horizons[fault].push_back(own);
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<FaultPicks> PickCuts(const std::vector<CutInput>& horizons, const CutoffStageOptions& options)
{
  HorizonTraces traces;
  double column = 0.0, index = 0.0;
  for (std::size_t n = 0; n < horizons.size(); ++n)
  {
    index = std::max(index, WorldPerIndex(horizons[n].Points.Lattice));
    AddTraces(horizons[n], n, options.LargestGap, traces);
    column = std::max(column, std::sqrt(horizons[n].Points.Lattice.ColumnArea()));
  }
  std::vector<FaultPicks> picks;
  for (const std::string& fault : traces.Names)
  {
    picks.push_back(PickTraces(fault, traces.ByFault[fault], options.Dip, column, index));
    picks.back().Horizons = traces.Horizons[fault];
  }
  return picks;
}
}
