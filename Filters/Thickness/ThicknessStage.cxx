// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ThicknessStage.h"

#include "Common/Horizon/DataModel.h"
#include "Common/Horizon/KeptPoints.h"
#include "Common/Horizon/LedgerFields.h"
#include "Common/Survey/SurveyFields.h"
#include "Filters/Algorithms/Thickness/Thickness.h"
#include "Filters/Common/HorizonData.h"
#include "Filters/Common/HorizonPoints.h"
#include "Filters/Common/LatticePoints.h"
#include "Filters/Common/PlacedPoints.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr std::int64_t Few = 20; // Crossings in one of 20 columns cause no warning.

const HorizonNames OfOther = { "the other horizon", "the first one" };
const HorizonNames OfFirst = { "the first horizon", "the other one" };

/// Of points the lattice with the smaller bins is used, otherwise the lattice of the first horizon.
const Horizon& WithLattice(const Horizon& horizon, const Horizon& other)
{
  constexpr double smaller = 1.0 - 1e-6; // less than 1 by more than rounding
  const bool hasLattice = other.FieldData.Has(FieldArray::LatticeToWorld);
  const bool isOther = hasLattice && !other.IsMesh() &&
    (horizon.IsMesh() || ReadLattice(other).ColumnArea() < smaller * ReadLattice(horizon).ColumnArea());
  return isOther ? other : horizon;
}

/// The horizon with the array Column; a mesh as it is.
Horizon ReadThicknessPoints(const Horizon& horizon, std::vector<Horizon>& outputs)
{
  if (horizon.IsMesh())
  {
    return horizon;
  }
  LatticePoints points = ReadColumns(WithoutHiddenPoints(horizon), KeptHeights::None);
  WriteDeviation(points, outputs);
  return std::move(points.Horizon);
}

PlacedPoints PlaceInLattice(
  const Horizon& horizon, const Lattice& lattice, const HorizonNames& names, const Monitor& monitor)
{
  return horizon.IsMesh() ? SampleOn(lattice, horizon, names, monitor)
                          : PlaceOn(lattice, WithoutHiddenPoints(horizon), names);
}

/// The lattice may be of the other horizon.
void WriteSampled(const PlacedPoints& sampled, const KeptPoints& kept, const Horizon& withLattice, Horizon& output)
{
  const Lattice lattice = ReadLattice(withLattice);
  output.Places = NewArray<double>("Points", std::int64_t(kept.size()), 3);
  double* place = output.Places.As<double>();
  for (std::size_t n = 0; n < kept.size(); ++n)
  {
    const auto point = std::size_t(kept[n]);
    const PlanePoint& column = sampled.Columns[point];
    const Eigen::Vector3d world = lattice.ToWorld({ double(column.X), double(column.Y), sampled.Height[point] });
    place = std::copy_n(world.data(), 3, place);
  }
  for (const char* const name : { FieldArray::LatticeDimensions, FieldArray::LatticeToWorld })
  {
    output.FieldData.Add(*withLattice.FieldData.Find(name));
  }
  output.Vertices = MakeVertices(output.NumberOfPoints());
  output.PointData = ReadColumns(output, KeptHeights::None).Horizon.PointData;
}

/// `each` is the number of columns of the output that one column of the thickness stands for.
Ledger LedgerOf(const Thickness& found, std::int64_t each)
{
  Ledger ledger;
  ledger[LedgerEntry::Known] = each * found.Columns;
  ledger[LedgerEntry::LeftOut] = each * found.LeftOut;
  return ledger;
}

/// `bin` is the area of a column of the output.
void WriteThicknessFigures(const Thickness& found, double bin, ArrayTable& figures)
{
  AddValue<double>(figures, FieldArray::IsochoreLeast, found.Least);
  AddValue<double>(figures, FieldArray::IsochoreMean, found.Mean);
  AddValue<double>(figures, FieldArray::IsochoreLargest, found.Largest);
  AddValue<std::int64_t>(figures, FieldArray::IsochoreCrossings, found.Crossings);
  WriteLedger(LedgerOf(found, std::int64_t(std::lround(found.Area / bin))), figures);
}

/// Empty without a warning.
std::string ReportWarnings(const Thickness& found)
{
  std::ostringstream text;
  if (Few * found.Crossings > found.Columns)
  {
    text << "the horizons cross in " << found.Crossings << " of " << found.Columns
         << " columns, expected few: their thickness is negative there";
  }
  if (!FindWarnings(LedgerOf(found, 1)).empty())
  {
    text << (text.str().empty() ? "" : "; ") << "one horizon alone is in " << found.LeftOut << " of "
         << found.Columns + found.LeftOut << " columns, an area of " << double(found.LeftOut) * found.Area
         << ", expected both: these columns are left out";
  }
  return text.str();
}

/// z must have the unit of x and y.
bool HasLengths(const SurveyDescription& survey)
{
  return survey.VerticalDomain != "time" &&
    (survey.VerticalUnit.empty() || survey.HorizontalUnit.empty() || survey.VerticalUnit == survey.HorizontalUnit);
}
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::string> RunThickness(
  const Horizon& horizon, const Horizon& other, std::vector<Horizon>& outputs, const Monitor& monitor)
{
  CheckArraySizes(other);
  Horizon& output = outputs.front();
  const Horizon& withLattice = WithLattice(horizon, other);
  const SurveyDescription survey = JoinSurveys(ReadSurveyFields(horizon.FieldData), other, OfOther);
  const Lattice lattice = ReadLattice(withLattice);
  monitor.Progress(0.0);
  const Horizon points = ReadThicknessPoints(horizon, outputs);
  monitor.Progress(0.1);
  const PlacedPoints first = PlaceInLattice(points, lattice, OfFirst, monitor.Step(0.1, 0.3));
  monitor.Progress(0.3);
  const PlacedPoints second = PlaceInLattice(other, lattice, OfOther, monitor.Step(0.3, 0.5));
  const Thickness found = MeasureThickness({ first.Columns, first.Height.data() },
    { second.Columns, second.Height.data() }, ScaleOf(lattice), monitor.Step(0.5, 0.9));
  const auto kept =
    KeptPoints::If(found.Isochore.size(), [&found](std::size_t point) { return !std::isnan(found.Isochore[point]); });
  if (horizon.IsMesh())
  {
    WriteSampled(first, kept, withLattice, output);
  }
  else
  {
    CopyPoints(points, kept, output);
  }
  monitor.Progress(0.95);
  ArrayTable& data = output.PointData;
  data.Remove(PointArray::PatchId);
  data.Remove(PointArray::Boundary);
  AddArray<double>(data, PointArray::Isochore, kept.Select(found.Isochore));
  if (HasLengths(survey))
  {
    AddArray<double>(data, PointArray::Isopach, kept.Select(found.Isopach));
    AddValue<double>(output.FieldData, FieldArray::IsochoreVolume, found.Volume);
  }
  data.SetActiveScalars(PointArray::Isochore);
  WriteThicknessFigures(found, ReadLattice(output).ColumnArea(), output.FieldData);
  std::vector<std::string> warnings = { ReportWarnings(found), WarnOfHeights(horizon, other, OfOther) };
  warnings.erase(std::remove(warnings.begin(), warnings.end(), std::string()), warnings.end());
  return warnings;
}

//----------------------------------------------------------------------------------------------------------------------
LatticeImage MakeThicknessMap(const Horizon& thickness)
{
  LatticeImage map;
  map.FieldData = thickness.FieldData;
  if (thickness.NumberOfPoints() == 0)
  {
    return map;
  }
  LatticeMatrix toWorld;
  Eigen::Map<Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(toWorld.data()) = ReadLatticeMap(thickness);
  map.Place = MakeMapFrame(toWorld);
  const ColumnPixels pixels(ColumnsOf(thickness), map);
  for (const char* const name : { PointArray::Isochore, PointArray::Isopach })
  {
    const DataArray* const array = thickness.PointData.Find(name);
    if (const double* const values = array ? array->As<double>() : nullptr)
    {
      pixels.Add<double>(name, values, NoValue);
    }
  }
  map.PointData.SetActiveScalars(PointArray::Isochore);
  return map;
}
}
