// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CutoffFit.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <optional>

namespace SeismicHorizons
{
namespace
{
constexpr std::int32_t CutoffReach = 2; // columns
constexpr std::size_t FewestColumns = 6; // for a plane

constexpr std::array<PlanePoint, 4> Steps = { PlanePoint{ 1, 0 }, { 0, 1 }, { -1, 0 }, { 0, -1 } };

class CutoffSurroundings
{
public:
  CutoffSurroundings(const ColumnIndex& index, const LinkCuts& cuts)
    : Columns(index.Columns())
    , Index(index)
    , Cuts(cuts)
  {
  }

  bool IsBesideCut(PointId point) const
  {
    return std::any_of(Steps.begin(), Steps.end(),
      [&](const PlanePoint& step) { return this->Cuts.IsCutBeside(this->Columns[std::size_t(point)], step); });
  }

  /// The points around a point on its side of all cuts. Empty around the end of a cut.
  std::vector<PointId> Find(PointId start) const
  {
    const PlanePoint& middle = this->Columns[std::size_t(start)];
    std::vector<PointId> found = { start };
    bool isAtEnd = false;
    for (std::size_t n = 0; n < found.size(); ++n)
    {
      const PlanePoint& column = this->Columns[std::size_t(found[n])];
      for (const PlanePoint& step : Steps)
      {
        const PlanePoint next = { column.X + step.X, column.Y + step.Y };
        const PointId point = this->Index.PointAt(next);
        const bool isNear = std::max(std::abs(next.X - middle.X), std::abs(next.Y - middle.Y)) <= CutoffReach;
        if (isNear && point != NoPoint && !this->Cuts.IsCutBeside(column, step) &&
          std::find(found.begin(), found.end(), point) == found.end())
        {
          found.push_back(point);
        }
      }
    }
    for (const PointId point : found)
    {
      const PlanePoint& column = this->Columns[std::size_t(point)];
      for (const PlanePoint& step : Steps)
      {
        const PointId other = this->Index.PointAt({ column.X + step.X, column.Y + step.Y });
        isAtEnd = isAtEnd ||
          (this->Cuts.IsCutBeside(column, step) && std::find(found.begin(), found.end(), other) != found.end());
      }
    }
    return isAtEnd ? std::vector<PointId>() : found;
  }

private:
  PlanePoints Columns;
  const ColumnIndex& Index;
  const LinkCuts& Cuts;
};

/// The height at the first point of a plane through the points.
std::optional<double> PlaneHeight(
  PlanePoints columns, const std::vector<double>& heights, const std::vector<PointId>& points)
{
  Eigen::MatrixX3d places(points.size(), 3);
  Eigen::VectorXd given(points.size());
  const PlanePoint& first = columns[std::size_t(points.front())];
  for (std::size_t n = 0; n < points.size(); ++n)
  {
    const PlanePoint& column = columns[std::size_t(points[n])];
    places.row(Eigen::Index(n)) << 1.0, double(column.X - first.X), double(column.Y - first.Y);
    given[Eigen::Index(n)] = heights[std::size_t(points[n])];
  }
  const Eigen::ColPivHouseholderQR<Eigen::MatrixX3d> solver(places);
  return points.size() < FewestColumns || solver.rank() < 3 ? std::nullopt
                                                            : std::optional<double>(solver.solve(given)[0]);
}
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<InnerHeights> FitCutoffs(const HeightMesh& mesh, const ColumnIndex& index, const HeightStack& heights,
  const std::vector<std::vector<unsigned char>>& known, const LinkCuts& cuts)
{
  const PlanePoints columns = index.Columns();
  const CutoffSurroundings surroundings(index, cuts);
  std::vector<InnerHeights> fitted(heights.size());
  for (VertexId vertex = 0; vertex < mesh.EndOfVertices(); ++vertex)
  {
    const PointId source = mesh.SourceOf(vertex);
    if (!mesh.IsOnLoop(vertex) || !surroundings.IsBesideCut(source))
    {
      continue;
    }
    const std::vector<PointId> around = surroundings.Find(source);
    if (around.size() < FewestColumns)
    {
      continue;
    }
    for (std::size_t horizon = 0; horizon < heights.size(); ++horizon)
    {
      std::vector<PointId> own = around;
      if (!known.empty())
      {
        own.erase(std::remove_if(
                    own.begin(), own.end(), [&](PointId point) { return known[horizon][std::size_t(point)] == 0; }),
          own.end());
      }
      const bool isKnown = !own.empty() && own.front() == source;
      const std::optional<double> height = isKnown ? PlaneHeight(columns, heights[horizon], own) : std::nullopt;
      fitted[horizon].Vertices.push_back(vertex);
      fitted[horizon].Heights.push_back(height.value_or(mesh.Height(horizon, vertex)));
    }
  }
  return fitted;
}
}
