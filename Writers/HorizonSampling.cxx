// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonSampling.h"

#include "Common/DataModel.h"
#include "Common/Errors.h"
#include "Common/Lattice.h"
#include "Common/LatticePlacement.h"
#include "Common/Survey/MeshSampling.h"
#include "Common/VTK/DataArrays.h"
#include "Common/VTK/SurveyFields.h"
#include "Marshalling/HorizonData.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace SeismicHorizons
{
namespace
{
constexpr double Null = std::numeric_limits<double>::quiet_NaN();
// Arrays of real numbers that say nothing of the horizon itself.
constexpr std::array<const char*, 5> OwnArrays = { PointArray::RealZ, PointArray::Elevation, PointArray::Flatness,
  PointArray::Distance, PointArray::VerticalDistance };

void CheckLines(const LineNumbering& lines)
{
  const Eigen::Vector4d numbers(lines.FirstInline, lines.InlineStep, lines.FirstCrossline, lines.CrosslineStep);
  if (!numbers.allFinite() || lines.InlineStep == 0.0 || lines.CrosslineStep == 0.0)
  {
    throw InputError("LineNumbers " + ToText(numbers) + ", expected finite numbers, and steps other than 0");
  }
}

SurveyLattice ReadSurveyLattice(vtkPolyData* horizon)
{
  ReadLattice(horizon); // refuses what is no lattice
  vtkFieldData* const data = horizon->GetFieldData();
  const auto toWorld = [data](int n) { return FieldValue(data->GetArray(FieldArray::LatticeToWorld), n); };
  const std::array<int, 3> dimensions = ReadLatticeDimensions(horizon);
  SurveyLattice lattice;
  lattice.Columns = { dimensions[0], dimensions[1] };
  lattice.Origin = { toWorld(3), toWorld(7) };
  lattice.ColumnStep = { toWorld(0), toWorld(4) };
  lattice.RowStep = { toWorld(1), toWorld(5) };
  vtkDataArray* const lines = data->GetArray(FieldArray::LineNumbers);
  if (lines && lines->GetNumberOfValues() == 4)
  {
    lattice.Lines =
      LineNumbering{ FieldValue(lines, 2), FieldValue(lines, 3), FieldValue(lines, 0), FieldValue(lines, 1) };
    CheckLines(*lattice.Lines);
  }
  return lattice;
}

/// The horizon as it is being sampled.
class Sampler
{
public:
  Sampler(vtkPolyData* horizon, int sign)
    : Horizon(horizon)
    , Sign(sign)
  {
    this->Grid.Lattice = ReadSurveyLattice(horizon);
    this->Grid.Survey = ReadSurveyFields(horizon->GetFieldData());
    this->Grid.Z.assign(CountColumns(this->Grid.Lattice.Columns[0], this->Grid.Lattice.Columns[1]), Null);
  }

  HorizonGrid SamplePoints()
  {
    LatticePoints points = ReadPoints(this->Horizon);
    const std::vector<PlanePoint> columns = ToColumns(std::move(points.Plane), points.Grid);
    for (std::size_t point = 0; point < columns.size(); ++point)
    {
      this->Grid.Z[this->Node(columns[point])] = this->Sign * this->Horizon->GetPoint(vtkIdType(point))[2];
    }
    vtkPointData* const data = this->Horizon->GetPointData();
    for (int n = 0; n < data->GetNumberOfArrays(); ++n)
    {
      if (IsAttribute(data->GetArray(n)))
      {
        this->AddAttribute(data->GetArray(n), columns);
      }
    }
    return this->Grid;
  }

  HorizonGrid SampleTriangles(const Monitor& monitor)
  {
    const Lattice lattice = ReadLattice(this->Horizon);
    std::vector<SpacePoint> points;
    for (vtkIdType point = 0; point < this->Horizon->GetNumberOfPoints(); ++point)
    {
      const Eigen::Vector3d place = lattice.ToLattice(Eigen::Vector3d(this->Horizon->GetPoint(point)));
      points.push_back({ place.x(), place.y(), place.z() });
    }
    const std::vector<double> heights =
      SampleMesh(points, ReadTriangles(this->Horizon), this->Grid.Lattice.Columns, monitor);
    for (std::size_t node = 0; node < heights.size(); ++node)
    {
      this->Grid.Z[node] = this->Sign * lattice.ToWorld({ 0.0, 0.0, heights[node] }).z();
    }
    this->AddBarePoints(points);
    return this->Grid;
  }

private:
  std::size_t Node(const PlanePoint& column) const
  {
    return std::size_t(column.X) + std::size_t(column.Y) * std::size_t(this->Grid.Lattice.Columns[0]);
  }

  /// Spurs of a horizon have no triangles.
  void AddBarePoints(const std::vector<SpacePoint>& points)
  {
    constexpr double nearness = 1e-6; // columns: what world coordinates of surveys are rounded by
    const auto [columns, rows] = this->Grid.Lattice.Columns;
    for (std::size_t point = 0; point < points.size(); ++point)
    {
      const double i = std::round(points[point].X);
      const double j = std::round(points[point].Y);
      const bool isOnColumn = std::abs(points[point].X - i) <= nearness && std::abs(points[point].Y - j) <= nearness &&
        i >= 0.0 && i < columns && j >= 0.0 && j < rows;
      double* const z = isOnColumn ? &this->Grid.Z[this->Node({ int(i), int(j) })] : nullptr;
      if (z && std::isnan(*z))
      {
        *z = this->Sign * this->Horizon->GetPoint(vtkIdType(point))[2];
      }
    }
  }

  static bool IsAttribute(vtkDataArray* array)
  {
    const bool isReal = vtkDoubleArray::SafeDownCast(array) || vtkFloatArray::SafeDownCast(array);
    return isReal && array->GetName() && array->GetNumberOfComponents() == 1 &&
      std::none_of(
        OwnArrays.begin(), OwnArrays.end(), [array](const char* own) { return array->GetName() == std::string(own); });
  }

  void AddAttribute(vtkDataArray* array, const std::vector<PlanePoint>& columns)
  {
    RequireTuples(array, this->Horizon->GetNumberOfPoints(), "points");
    PickAttribute attribute = { array->GetName(), std::vector<double>(this->Grid.Z.size(), Null) };
    for (std::size_t point = 0; point < columns.size(); ++point)
    {
      attribute.Values[this->Node(columns[point])] = array->GetComponent(vtkIdType(point), 0);
    }
    this->Grid.Attributes.push_back(std::move(attribute));
  }

  vtkPolyData* const Horizon;
  const int Sign;
  HorizonGrid Grid;
};
}

//----------------------------------------------------------------------------------------------------------------------
std::size_t CountColumns(int columns, int rows)
{
  const std::int64_t count = std::int64_t(columns) * rows;
  if (count > std::numeric_limits<std::int32_t>::max())
  {
    throw InputError("lattice of " + std::to_string(columns) + " x " + std::to_string(rows) +
      " columns, expected less than 2^31 in all for a file that lists them");
  }
  return std::size_t(count);
}

//----------------------------------------------------------------------------------------------------------------------
HorizonGrid SampleHorizon(vtkPolyData* horizon, int sign, const Monitor& monitor)
{
  monitor.Progress(0.0);
  Sampler sampler(horizon, sign);
  return horizon->GetNumberOfPolys() > 0 ? sampler.SampleTriangles(monitor) : sampler.SamplePoints();
}
}
