// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonThickness.h"

#include "Common/DataModel.h"
#include "Common/Errors.h"
#include "Common/KeptPoints.h"
#include "Common/Survey/LatticeFrame.h"
#include "Common/VTK/DataArrays.h"
#include "Common/VTK/HorizonName.h"
#include "Common/VTK/SurveyFields.h"
#include "Marshalling/HorizonPoints.h"
#include "Marshalling/HorizonTree.h"
#include "Marshalling/LatticePoints.h"
#include "Thickness/Thickness.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace SeismicHorizons;

namespace
{
constexpr int OtherPort = 1;
constexpr std::int64_t Few = 20; // one column of so many may be a crossing without a warning

/// How far a point of the other horizon may be from a column, along either axis.
constexpr double LargestDeviation = 0.05;

constexpr double LargestColumn = 1 << 30;

struct OtherPoints
{
  std::vector<PlanePoint> Columns;
  std::vector<double> Height;
};

/// Throws InputError where both say what z is, and it is not the same.
void CheckSameHeights(const SurveyDescription& first, const SurveyDescription& other)
{
  const auto check = [](const std::string& name, const std::string& expected, const std::string& found)
  {
    if (!expected.empty() && !found.empty() && expected != found)
    {
      throw InputError(
        "an other horizon of the " + name + " \"" + found + "\", expected \"" + expected + "\" as of the first one");
    }
  };
  check("VerticalDomain", first.VerticalDomain, other.VerticalDomain);
  check("VerticalUnit", first.VerticalUnit, other.VerticalUnit);
}

/// Of what has points, the one that is not the horizon itself, on the lattice of that.
OtherPoints ReadOther(vtkDataObject* others, vtkPolyData* horizon, const Lattice& grid)
{
  std::vector<HorizonLeaf> leaves = ListHorizons(others, {});
  leaves.erase(std::remove_if(leaves.begin(), leaves.end(),
                 [&](const HorizonLeaf& leaf)
                 { return leaf.Input->GetNumberOfPoints() == 0 || leaf.Input->GetPoints() == horizon->GetPoints(); }),
    leaves.end());
  if (leaves.size() != 1)
  {
    throw InputError(std::to_string(leaves.size()) +
      " other horizons with points, expected one: as the input Other, for instance by Extract Block");
  }
  vtkPolyData* const other = leaves.front().Input;
  CheckArraySizes(other);
  CheckSameHeights(ReadSurveyFields(horizon->GetFieldData()), ReadSurveyFields(other->GetFieldData()));
  const vtkSmartPointer<vtkPolyData> points = WithoutHiddenPoints(other);
  OtherPoints found;
  for (vtkIdType n = 0; n < points->GetNumberOfPoints(); ++n)
  {
    const Eigen::Vector3d world(points->GetPoint(n));
    if (!world.allFinite())
    {
      throw InputError("a point of the other horizon at " + ToText(world) + ", expected finite numbers");
    }
    const Eigen::Vector3d place = grid.ToLattice(world);
    if (!(std::abs(place.z()) <= LargestHeight))
    {
      throw InputError(
        "a point of the other horizon at " + ToText(world) + ", expected at most 2^50 vertical indices up or down");
    }
    const Eigen::Vector2d column(std::floor(place.x() + 0.5), std::floor(place.y() + 0.5));
    if (!((place.head<2>() - column).cwiseAbs().maxCoeff() <= LargestDeviation) ||
      !(column.cwiseAbs().maxCoeff() < LargestColumn))
    {
      throw InputError("a point of the other horizon at " + ToText(world) +
        ", which is on no column of the first one, expected points on one lattice: Horizon From Points grids them "
        "there");
    }
    found.Columns.push_back({ static_cast<std::int32_t>(column.x()), static_cast<std::int32_t>(column.y()) });
    found.Height.push_back(place.z());
  }
  return found;
}

LatticeScale ScaleOf(const Lattice& grid)
{
  const Eigen::Vector3d origin = grid.ToWorld(Eigen::Vector3d::Zero());
  LatticeScale scale;
  scale.Plane.col(0) = (grid.ToWorld(Eigen::Vector3d::UnitX()) - origin).head<2>();
  scale.Plane.col(1) = (grid.ToWorld(Eigen::Vector3d::UnitY()) - origin).head<2>();
  scale.Height = (grid.ToWorld(Eigen::Vector3d::UnitZ()) - origin).z();
  return scale;
}

/// Whether lengths along z and across it can be told together.
bool HasLengths(const SurveyDescription& survey)
{
  return survey.VerticalDomain != "time" &&
    (survey.VerticalUnit.empty() || survey.HorizontalUnit.empty() || survey.VerticalUnit == survey.HorizontalUnit);
}
}

vtkStandardNewMacro(vtkHorizonThickness);

//------------------------------------------------------------------------------
vtkHorizonThickness::vtkHorizonThickness()
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
void vtkHorizonThickness::ProcessHorizon(vtkPolyData* horizon, const Outputs& outputs, const Monitor& monitor)
{
  const LatticePoints points = ReadColumns(WithoutHiddenPoints(horizon), outputs);
  vtkDataObject* const given = this->GetInputDataObject(OtherPort, 0);
  const OtherPoints other = ReadOther(given ? given : this->GetInputDataObject(0, 0), horizon, points.Grid);
  monitor.Progress(0.4);
  const Thickness found = MeasureThickness(
    { points.Column, points.Height }, { other.Columns, other.Height }, ScaleOf(points.Grid), monitor.Step(0.4, 0.9));
  KeptPoints kept(found.Isochore.size());
  for (std::size_t point = 0; point < found.Isochore.size(); ++point)
  {
    kept.AppendRun(PointId(point), std::isnan(found.Isochore[point]) ? 0 : 1);
  }
  vtkPolyData* const output = outputs.front();
  CopyPoints(points.Horizon, kept, output);
  vtkPointData* const data = output->GetPointData();
  data->RemoveArray(PointArray::PatchId);
  data->RemoveArray(PointArray::Boundary);
  AddArray<vtkDoubleArray>(data, PointArray::Isochore, kept.Select(found.Isochore));
  vtkFieldData* const figures = output->GetFieldData();
  if (HasLengths(ReadSurveyFields(horizon->GetFieldData())))
  {
    AddArray<vtkDoubleArray>(data, PointArray::Isopach, kept.Select(found.Isopach));
    AddValue<vtkDoubleArray>(figures, FieldArray::IsochoreVolume, found.Volume);
  }
  data->SetActiveScalars(PointArray::Isochore);
  AddValue<vtkDoubleArray>(figures, FieldArray::IsochoreLeast, found.Least);
  AddValue<vtkDoubleArray>(figures, FieldArray::IsochoreMean, found.Mean);
  AddValue<vtkDoubleArray>(figures, FieldArray::IsochoreLargest, found.Largest);
  AddValue<vtkIdTypeArray>(figures, FieldArray::IsochoreCrossings, vtkIdType(found.Crossings));
  if (Few * found.Crossings > found.Columns)
  {
    const std::string name = NameBySurfaceId(horizon);
    vtkWarningMacro(<< name << (name.empty() ? "" : ": ") << "the horizons cross in " << found.Crossings << " of "
                    << found.Columns << " columns, expected few: their thickness is negative there");
  }
}
