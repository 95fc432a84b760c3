// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ContoursStage.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Parameters.h"
#include "Common/Horizon/ColumnIndex.h"
#include "Common/Horizon/ContourInterval.h"
#include "Common/Horizon/DataModel.h"
#include "Common/Survey/DerivedArrays.h"
#include "Filters/Algorithms/Contours/Contours.h"
#include "Filters/Common/CellWriter.h"
#include "Filters/Common/CutData.h"
#include "Filters/Common/HorizonData.h"
#include "Filters/Common/HorizonPoints.h"
#include "Filters/Common/LatticePoints.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iomanip>
#include <locale>
#include <optional>
#include <sstream>
#include <string>
#include <utility>

namespace SeismicHorizons
{
namespace
{
std::vector<double> ReadHeights(const Horizon& horizon)
{
  std::vector<double> heights(std::size_t(horizon.NumberOfPoints()));
  for (std::size_t n = 0; n < heights.size(); ++n)
  {
    heights[n] = horizon.Places.At(std::int64_t(n), 2);
    if (!std::isfinite(heights[n]))
    {
      throw InputError("point " + std::to_string(n) + " without a finite z, expected one at each point");
    }
  }
  return heights;
}

/// Turns triangles counter-clockwise, and drops upright ones, which have no contours on a map.
PlanTriangles ReadPlan(const Horizon& mesh)
{
  PlanTriangles triangles = ReadOpenTriangles(mesh);
  const auto area = [&mesh](const std::array<PointId, 3>& triangle)
  {
    const Eigen::Vector3d a = mesh.Place(triangle[0]);
    const Eigen::Vector3d ab = mesh.Place(triangle[1]) - a, ac = mesh.Place(triangle[2]) - a;
    return ab.x() * ac.y() - ab.y() * ac.x();
  };
  triangles.erase(std::remove_if(triangles.begin(), triangles.end(),
                    [&area](const std::array<PointId, 3>& triangle) { return area(triangle) == 0.0; }),
    triangles.end());
  for (std::array<PointId, 3>& triangle : triangles)
  {
    if (area(triangle) < 0.0)
    {
      std::swap(triangle[1], triangle[2]);
    }
  }
  return triangles;
}

PlanTriangles JoinPoints(const LatticePoints& points, const std::vector<double>& heights)
{
  const std::optional<LinkCuts> cuts = FindCuts(points.Horizon, ColumnRows::Of(points.Column).Box);
  return JoinColumns(points.Column, heights, cuts ? &*cuts : nullptr);
}

double ChooseInterval(const std::vector<double>& heights)
{
  const auto [least, largest] = std::minmax_element(heights.begin(), heights.end());
  return *least < *largest ? ChooseContourInterval(*largest - *least) : 1.0;
}

/// A contour through a point of the surface crosses several edges there, at one place.
std::vector<Eigen::Vector2d> PlanOf(const Contour& contour, const Horizon& horizon)
{
  std::vector<Eigen::Vector2d> plan;
  for (const ContourPoint& point : contour.Points)
  {
    const Eigen::Vector2d from = horizon.Place(point.Crossed.From).head<2>();
    const Eigen::Vector2d to = horizon.Place(point.Crossed.To).head<2>();
    const Eigen::Vector2d place = point.Fraction == 0.0 ? from
      : point.Fraction == 1.0                           ? to
                                                        : Eigen::Vector2d(from + point.Fraction * (to - from));
    if (plan.empty() || plan.back() != place)
    {
      plan.push_back(place);
    }
  }
  return plan;
}

/// Returns how many there are.
std::int64_t WriteContours(
  const std::vector<Contour>& contours, const Horizon& horizon, double interval, Horizon& output)
{
  CellWriter cells;
  const VerticalAxis axis = ReadVerticalAxis(horizon.FieldData);
  const bool isDownwards = !axis.Name.empty() && axis.IsDownwards;
  std::vector<double> levels;
  std::vector<unsigned char> areIndex;
  std::vector<std::string> labels;
  for (const Contour& contour : contours)
  {
    const double height = double(contour.Level) * interval;
    const std::vector<Eigen::Vector2d> plan = PlanOf(contour, horizon);
    if (plan.size() < 2) // A single point at the level.
    {
      continue;
    }
    for (const Eigen::Vector2d& place : plan)
    {
      cells.Add({ place.x(), place.y(), height });
    }
    cells.Close();
    areIndex.push_back(contour.Level % IndexContours == 0);
    levels.push_back(isDownwards ? 0.0 - height : height);
    std::ostringstream label;
    label.imbue(std::locale::classic());
    label << std::setprecision(12) << levels.back();
    labels.push_back(label.str());
  }
  cells.Finish(output, &Horizon::Lines);
  AddArray<double>(output.CellData, CellArray::Level, levels);
  AddArray<unsigned char>(output.CellData, CellArray::IndexContour, areIndex);
  output.CellData.Add({ CellArray::Label, std::move(labels) });
  return output.Lines.Size();
}
}

//----------------------------------------------------------------------------------------------------------------------
void RunContours(const Horizon& horizon, double interval, std::vector<Horizon>& outputs, const Monitor& monitor)
{
  CheckAtLeast("interval", interval, 0.0, "");
  Horizon& output = outputs.front();
  Horizon surface = horizon;
  PlanTriangles triangles;
  std::vector<double> heights;
  if (horizon.IsMesh())
  {
    heights = ReadHeights(surface);
    triangles = ReadPlan(surface);
  }
  else
  {
    LatticePoints points = ReadColumns(WithoutHiddenPoints(horizon), KeptHeights::None);
    WriteDeviation(points, outputs);
    heights = ReadHeights(points.Horizon);
    triangles = JoinPoints(points, heights);
    surface = std::move(points.Horizon);
  }
  monitor.Progress(0.4);
  interval = interval > 0.0 ? interval : ChooseInterval(heights);
  const std::vector<Contour> contours = FindContours(triangles, heights, interval, monitor.Step(0.4, 0.9));
  const std::int64_t number = WriteContours(contours, surface, interval, output);
  output.FieldData.Remove(FieldArray::LedgerColumns);
  output.FieldData.Remove(FieldArray::LedgerArea);
  AddValue<double>(output.FieldData, FieldArray::ContourInterval, interval);
  AddValue<std::int64_t>(output.FieldData, FieldArray::NumberOfContours, number);
}
}
