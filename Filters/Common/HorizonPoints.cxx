// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonPoints.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/DataModel.h"

#include <algorithm>
#include <numeric>
#include <sstream>
#include <string>

namespace SeismicHorizons
{
namespace
{
/// Null without marks.
const unsigned char* FindGhosts(const Horizon& horizon)
{
  const DataArray* const ghosts = horizon.PointData.Find(PointArray::Ghosts);
  return ghosts ? ghosts->As<unsigned char>() : nullptr;
}

bool IsVisible(unsigned char ghost)
{
  return (ghost & (GhostMark::Copy | GhostMark::HiddenPoint)) == 0;
}
}

//----------------------------------------------------------------------------------------------------------------------
ArrayTable WithoutMeshFigures(ArrayTable figures)
{
  for (const char* const name :
    { FieldArray::TriangleCount, FieldArray::FaultTriangleCount, FieldArray::BoundaryEdgeCount,
      FieldArray::NonDelaunayEdgeCount, FieldArray::SmallestAngle, FieldArray::SliverCount, FieldArray::LargestError,
      FieldArray::MeanError, FieldArray::LargestEdgeError, FieldArray::LargestLoopError })
  {
    figures.Remove(name);
  }
  return figures;
}

//----------------------------------------------------------------------------------------------------------------------
std::int64_t CountVisiblePoints(const Horizon& horizon)
{
  const unsigned char* const ghosts = FindGhosts(horizon);
  return ghosts ? std::count_if(ghosts, ghosts + horizon.NumberOfPoints(), IsVisible) : horizon.NumberOfPoints();
}

//----------------------------------------------------------------------------------------------------------------------
Horizon WithoutHiddenPoints(const Horizon& horizon)
{
  if (CountVisiblePoints(horizon) == horizon.NumberOfPoints())
  {
    return horizon;
  }
  const unsigned char* const ghosts = FindGhosts(horizon);
  const auto kept = KeptPoints::If(
    std::size_t(horizon.NumberOfPoints()), [ghosts](std::size_t point) { return IsVisible(ghosts[point]); });
  Horizon result;
  CopyPoints(horizon, kept, result);
  result.Vertices = Cells();
  result.PointData.Remove(PointArray::Ghosts);
  result.FieldData = horizon.FieldData;
  return result;
}

//----------------------------------------------------------------------------------------------------------------------
void CopyPoints(const Horizon& input, const KeptPoints& kept, Horizon& output)
{
  output.Places = kept.AreAll() ? input.Places : input.Places.Select(kept);
  for (const DataArray& array : input.PointData)
  {
    output.PointData.Add(kept.AreAll() ? array : array.Select(kept));
  }
  output.Vertices = MakeVertices(output.NumberOfPoints());
}

//----------------------------------------------------------------------------------------------------------------------
void ActivateHeight(Horizon& horizon)
{
  horizon.PointData.SetActiveScalars(PointArray::VerticalIndex);
}

//----------------------------------------------------------------------------------------------------------------------
void CheckHeights(const Horizon& horizon, const std::function<double(std::int64_t)>& height)
{
  HeightCheck check(horizon.NumberOfPoints());
  check.Add(horizon, height, 0, 0, horizon.NumberOfPoints());
  check.Finish();
}

//----------------------------------------------------------------------------------------------------------------------
// Points without indices are right.
void HeightCheck::Add(const Horizon& horizon, const std::function<double(std::int64_t)>& height, std::int64_t before,
  std::int64_t first, std::int64_t end)
{
  const DataArray* const index = FindNumbers(horizon.PointData, PointArray::VerticalIndex);
  if (!index || index->Tuples() != horizon.NumberOfPoints())
  {
    return;
  }
  for (std::int64_t point = (first + this->Step - 1) / this->Step * this->Step; point < end; point += this->Step)
  {
    this->Sample.emplace_back(index->At(point - before, 0), height(point - before));
  }
}

//----------------------------------------------------------------------------------------------------------------------
// Vertical indices must deviate by more than rounding and real z could.
void HeightCheck::Finish() const
{
  constexpr double LeastDeviation = 2.0; // vertical indices
  // RealZ may differ from the vertical index, but in a survey their ratio is about constant.
  constexpr double MostStretch = 2.0;
  const double stretch = this->Sample.empty() ? 1.0 : FitSlope(this->Sample, LeastDeviation).value_or(1.0);
  if (stretch < 1.0 / MostStretch || stretch > MostStretch)
  {
    std::ostringstream text;
    text << "points rise by " << stretch
         << " lattice units for each vertical index, expected 1: where points were moved or scaled, as by Transform, "
            "the lattice in LatticeToWorld is no longer theirs";
    throw InputError(text.str());
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::optional<double> FitSlope(const std::vector<Eigen::Vector2d>& pairs, double leastDeviation)
{
  const Eigen::Vector2d sum = std::accumulate(pairs.begin(), pairs.end(), Eigen::Vector2d(0.0, 0.0));
  const Eigen::Vector2d mean = sum / double(pairs.size());
  double square = 0.0;
  double product = 0.0;
  for (const Eigen::Vector2d& pair : pairs)
  {
    square += (pair.x() - mean.x()) * (pair.x() - mean.x());
    product += (pair.x() - mean.x()) * (pair.y() - mean.y());
  }
  const bool isSpread = square > leastDeviation * leastDeviation * double(pairs.size());
  return isSpread ? std::optional<double>(product / square) : std::nullopt;
}
}
