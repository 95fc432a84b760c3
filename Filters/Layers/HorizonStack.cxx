// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonStack.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/DataModel.h"
#include "Common/Horizon/LedgerFields.h"
#include "Common/Survey/SurveyFields.h"
#include "Filters/Common/CutData.h"
#include "Filters/Common/HeightUnit.h"
#include "Filters/Common/HorizonData.h"
#include "Filters/Common/HorizonPoints.h"

#include <algorithm>
#include <cassert>
#include <climits>
#include <cmath>
#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr double StackRounding = 1e-6; // fraction of a step

PlanePoint ColumnAt(const Lattice& lattice, const Eigen::Vector3d& world)
{
  const Eigen::Vector3d place = lattice.ToLattice(world);
  return { std::int32_t(std::lround(place.x())), std::int32_t(std::lround(place.y())) };
}

/// Both columns are on one row or column of the lattice.
void CutStackAlong(const PlanePoint& from, const PlanePoint& to, LinkCuts& cuts)
{
  const PlanePoint least = { std::min(from.X, to.X), std::min(from.Y, to.Y) };
  for (std::int32_t x = least.X; x < std::max(from.X, to.X); ++x)
  {
    cuts.CutEast({ x, least.Y });
  }
  for (std::int32_t y = least.Y; y < std::max(from.Y, to.Y); ++y)
  {
    cuts.CutNorth({ least.X, y });
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
void HorizonStack::Add(const std::string& name, const Horizon& horizon)
{
  CheckArraySizes(horizon);
  const Horizon points = WithoutHiddenPoints(horizon);
  if (points.NumberOfPoints() == 0)
  {
    return;
  }
  RequireAllPoints(points);
  this->Horizons.push_back({ name, ReadColumns(points), {}, {} });
  this->Horizons.back().IsFilled = ReadFilled(points);
}

//----------------------------------------------------------------------------------------------------------------------
void HorizonStack::PlaceTogether()
{
  if (this->Size() < 2)
  {
    throw InputError(
      (this->Size() == 0 ? "no horizon" : "one horizon") + std::string(" with points, expected at least 2"));
  }
  const auto frame = std::min_element(this->Horizons.begin(), this->Horizons.end(),
    [](const StackedHorizon& a, const StackedHorizon& b)
    { return a.Points.Lattice.ColumnArea() < (1.0 - StackRounding) * b.Points.Lattice.ColumnArea(); });
  this->Frame = frame->Points.Horizon;
  this->Dimensions = ReadLatticeDimensions(this->Frame);
  this->Map = ReadLatticeMap(this->Frame);
  this->Survey = ReadSurveyFields(this->Frame.FieldData);
  this->RefineHeights();
  this->Together = Lattice(this->Dimensions, this->Map);
  for (StackedHorizon& horizon : this->Horizons)
  {
    const HorizonNames names = { horizon.Name, frame->Name };
    this->Survey = JoinSurveys(this->Survey, horizon.Points.Horizon, names);
    this->Doubt = this->Doubt.empty() ? WarnOfHeights(this->Frame, horizon.Points.Horizon, names) : this->Doubt;
    horizon.Placed = PlaceOn(this->Together, horizon.Points.Horizon, names);
    for (const PlanePoint& column : horizon.Placed.Columns)
    {
      this->Box.Add(column);
    }
  }
  this->CoverAll();
}

//----------------------------------------------------------------------------------------------------------------------
// The smallest vertical index of all horizons becomes the unit, so that errors in indices hold for each.
void HorizonStack::RefineHeights()
{
  const double step = std::abs(this->Map(2, 2));
  double smallest = step;
  for (const StackedHorizon& horizon : this->Horizons)
  {
    smallest = std::min(smallest, WorldPerIndex(horizon.Points.Lattice));
  }
  if (smallest < (1.0 - StackRounding) * step)
  {
    this->Dimensions[2] = int(std::min(std::ceil(this->Dimensions[2] * step / smallest), double(INT_MAX)));
    this->Map(2, 2) *= smallest / step;
  }
}

//----------------------------------------------------------------------------------------------------------------------
// Extends the lattice to all columns.
void HorizonStack::CoverAll()
{
  if (this->Box.IsEmpty())
  {
    return;
  }
  this->Shift = { std::min(0, this->Box.Least.X), std::min(0, this->Box.Least.Y) };
  const auto move = [this](PlanePoint& column) { column = { column.X - this->Shift.X, column.Y - this->Shift.Y }; };
  move(this->Box.Least);
  move(this->Box.Greatest);
  for (StackedHorizon& horizon : this->Horizons)
  {
    std::for_each(horizon.Placed.Columns.begin(), horizon.Placed.Columns.end(), move);
  }
  this->Map.col(3) += this->Shift.X * this->Map.col(0) + this->Shift.Y * this->Map.col(1);
  this->Dimensions[0] = std::max(this->Dimensions[0] - this->Shift.X, this->Box.Greatest.X + 1);
  this->Dimensions[1] = std::max(this->Dimensions[1] - this->Shift.Y, this->Box.Greatest.Y + 1);
  this->Together = Lattice(this->Dimensions, this->Map);
}

//----------------------------------------------------------------------------------------------------------------------
bool HorizonStack::HeightsGrowDownwards() const
{
  return (this->Together.ToWorld(Eigen::Vector3d::UnitZ()) - this->Together.ToWorld(Eigen::Vector3d::Zero())).z() < 0.0;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::string> HorizonStack::Names() const
{
  std::vector<std::string> names;
  for (const StackedHorizon& horizon : this->Horizons)
  {
    names.push_back(horizon.Name);
  }
  return names;
}

//----------------------------------------------------------------------------------------------------------------------
void HorizonStack::Reorder(const std::vector<std::size_t>& order)
{
  assert(order.size() == this->Horizons.size());
  std::vector<StackedHorizon> ordered;
  for (const std::size_t n : order)
  {
    ordered.push_back(std::move(this->Horizons[n]));
  }
  this->Horizons = std::move(ordered);
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<HorizonView> HorizonStack::Views() const
{
  std::vector<HorizonView> views;
  for (const StackedHorizon& horizon : this->Horizons)
  {
    views.push_back({ horizon.Placed.Columns, horizon.Placed.Height.data() });
    views.back().IsFilled = horizon.IsFilled.empty() ? nullptr : horizon.IsFilled.data();
  }
  return views;
}

//----------------------------------------------------------------------------------------------------------------------
HeightStack HorizonStack::WorldHeights() const
{
  HeightStack heights;
  for (const StackedHorizon& horizon : this->Horizons)
  {
    const Horizon& points = horizon.Points.Horizon;
    heights.emplace_back(std::size_t(points.NumberOfPoints()));
    for (std::int64_t point = 0; point < points.NumberOfPoints(); ++point)
    {
      heights.back()[std::size_t(point)] = points.Place(point).z();
    }
  }
  return heights;
}

//----------------------------------------------------------------------------------------------------------------------
std::optional<LinkCuts> HorizonStack::FindCuts() const
{
  std::optional<LinkCuts> cuts;
  for (const StackedHorizon& horizon : this->Horizons)
  {
    const Lattice& own = horizon.Points.Lattice;
    for (const LatticeLink& link : ReadFaultedLinks(horizon.Points.Horizon))
    {
      const bool isNorth = link.Side == LinkSide::North;
      const Eigen::Vector3d place(link.Column.X, link.Column.Y, 0.0);
      const PlanePoint from = ColumnAt(this->Together, own.ToWorld(place));
      const PlanePoint to =
        ColumnAt(this->Together, own.ToWorld(place + (isNorth ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitX())));
      if (from.X != to.X && from.Y != to.Y)
      {
        throw InputError("faults of " + horizon.Name +
          " on a rotated lattice, expected rows and columns along those of the others: Horizon From Points "
          "grids its points there");
      }
      if (this->Box.Contains(from) && this->Box.Contains(to))
      {
        cuts = cuts ? std::move(cuts) : LinkCuts(this->Box);
        CutStackAlong(from, to, *cuts);
      }
    }
  }
  return cuts;
}

//----------------------------------------------------------------------------------------------------------------------
void HorizonStack::WriteFields(ArrayTable& data) const
{
  const ArrayTable& given = this->Frame.FieldData;
  if (const DataArray* const direction = FindNumbers(given, FieldArray::VerticalDirection))
  {
    data.Add(*direction);
  }
  AddSurveyFields(this->Survey, data);
  std::array<double, 16> map = {};
  Eigen::Map<Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(map.data()) = this->Map;
  AddTuple<int>(data, FieldArray::LatticeDimensions, this->Dimensions);
  AddTuple<double>(data, FieldArray::LatticeToWorld, map);
  const DataArray* const lines = FindNumbers(given, FieldArray::LineNumbers);
  if (lines && lines->Size() == 4)
  {
    std::array<double, 4> shifted = { lines->Value(0), lines->Value(1), lines->Value(2), lines->Value(3) };
    shifted[0] += this->Shift.Y * shifted[1];
    shifted[2] += this->Shift.X * shifted[3];
    AddTuple<double>(data, FieldArray::LineNumbers, shifted);
  }
}
}
