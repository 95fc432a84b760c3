// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Tables and point sets of others become horizons: with places, with line numbers, with both, and with names.

#include "HorizonFixtures.h"
#include "Tools/Check.h"

#include "vtkHorizonExteriorBoundary.h"
#include "vtkHorizonFromPoints.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

using namespace HorizonFixtures;

namespace
{
using Numbers = std::vector<double>;
using Table = vtkSmartPointer<vtkTable>;

/// The rows and columns of a small turned survey: inlines 10, 12, 14 and crosslines 5 to 8.
struct Survey
{
  Numbers Inline, Crossline, X, Y, Z;

  Survey()
  {
    for (const double inlineNumber : { 10.0, 12.0, 14.0 })
    {
      for (const double crossline : { 5.0, 6.0, 7.0, 8.0 })
      {
        this->Inline.push_back(inlineNumber);
        this->Crossline.push_back(crossline);
        this->X.push_back(600000.0 + 3.0 * crossline - 4.0 * inlineNumber);
        this->Y.push_back(6000000.0 + 4.0 * crossline + 3.0 * inlineNumber);
        this->Z.push_back(1500.0 + crossline + 10.0 * inlineNumber);
      }
    }
  }
};

Table MakeTable(const std::vector<std::pair<std::string, Numbers>>& columns)
{
  auto table = Table::New();
  for (const auto& [name, values] : columns)
  {
    vtkNew<vtkDoubleArray> column;
    column->SetName(name.c_str());
    for (const double value : values)
    {
      column->InsertNextValue(value);
    }
    table->AddColumn(column);
  }
  return table;
}

vtkPolyData* Horizon(vtkHorizonFromPoints* filter, unsigned int number = 0)
{
  return vtkPolyData::SafeDownCast(filter->GetOutput()->GetPartition(number, 0));
}

std::string Name(vtkHorizonFromPoints* filter, unsigned int number)
{
  return filter->GetOutput()->GetMetaData(number)->Get(vtkCompositeDataSet::NAME());
}

bool IsAt(vtkPolyData* horizon, vtkIdType point, double x, double y, double z)
{
  const double* const place = horizon->GetPoint(point);
  return std::hypot(place[0] - x, place[1] - y, place[2] - z) < 1e-6;
}

void TestLinesAndPlaces()
{
  const Survey survey;
  vtkNew<vtkHorizonFromPoints> filter;
  filter->SetInputDataObject(MakeTable({ { "IL", survey.Inline }, { "XL", survey.Crossline }, { "Easting", survey.X },
    { "Northing", survey.Y }, { "TWT (ms)", survey.Z }, { "Amp", survey.Inline }, { "PointCount", survey.Inline } }));
  filter->SetVerticalStep(2.0);
  filter->Update();
  CHECK_EQUAL(Name(filter, 0), std::string("Horizon 1"));
  vtkPolyData* const horizon = Horizon(filter);
  CHECK_EQUAL(horizon->GetNumberOfPoints(), 12);
  CHECK_EQUAL(horizon->GetNumberOfVerts(), 12);
  CHECK(IsAt(horizon, 5, survey.X[5], survey.Y[5], -survey.Z[5]));
  vtkPointData* const data = horizon->GetPointData();
  CHECK_EQUAL(data->GetArray("Amp")->GetTuple1(5), 12.0);
  CHECK_EQUAL(data->GetArray("RealZ")->GetTuple1(5), survey.Z[5]);
  CHECK_EQUAL(data->GetArray("VerticalIndex")->GetTuple1(5), std::lround((survey.Z[5] - 1604.0) / 2.0));
  CHECK_EQUAL(data->GetArray("SurfaceId")->GetTuple1(5), 1.0);
  CHECK(!data->HasArray("PointCount")); // each represents one, whatever a column says
  const double* const lines = horizon->GetFieldData()->GetArray("LineNumbers")->GetTuple4(0);
  CHECK(Numbers(lines, lines + 4) == Numbers({ 10.0, 2.0, 5.0, 1.0 }));
  const double* const size = horizon->GetFieldData()->GetArray("LatticeDimensions")->GetTuple3(0);
  CHECK(size[0] == 4.0 && size[1] == 3.0);
  // What comes out is what the stages take.
  vtkNew<vtkHorizonExteriorBoundary> boundary;
  boundary->SetInputConnection(filter->GetOutputPort());
  boundary->Update();
  auto* const bounded = vtkPartitionedDataSetCollection::SafeDownCast(boundary->GetOutputDataObject(0));
  CHECK(bounded && bounded->GetNumberOfPoints() == 12);
}

/// Of columns with several points each sheet is a horizon, also when the input changes.
void TestSheets()
{
  Survey survey;
  vtkNew<vtkHorizonFromPoints> filter;
  filter->SetDuplicatePolicyToSheets();
  const auto update = [&]()
  {
    filter->SetInputDataObject(MakeTable({ { "IL", survey.Inline }, { "XL", survey.Crossline }, { "Z", survey.Z } }));
    filter->Update();
    return filter->GetOutput()->GetNumberOfPartitionedDataSets();
  };
  CHECK_EQUAL(update(), 1u);
  survey.Inline.push_back(10.0);
  survey.Crossline.push_back(5.0);
  survey.Z.push_back(1000.0);
  CHECK_EQUAL(update(), 2u);
  CHECK_EQUAL(Name(filter, 1), std::string("Horizon 1 (2)"));
  CHECK_EQUAL(Horizon(filter, 0)->GetNumberOfPoints(), 12);
  CHECK_EQUAL(Horizon(filter, 1)->GetNumberOfPoints(), 1);
  CHECK_EQUAL(Horizon(filter, 1)->GetPointData()->GetArray("RealZ")->GetTuple1(0), 1000.0);
  filter->SetHorizonStatus("Horizon 1", 0);
  filter->Update();
  CHECK_EQUAL(Horizon(filter, 0)->GetNumberOfPoints(), 1);
}

/// Coordinates of points, in the precision and order they come in, with ghosts that are left out.
void TestPointSet()
{
  const Survey survey;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  vtkNew<vtkFloatArray> vectors;
  vectors->SetName("Normals");
  vectors->SetNumberOfComponents(3);
  for (std::size_t n = survey.X.size(); n-- > 0;)
  {
    points->InsertNextPoint(survey.X[n], survey.Y[n], survey.Z[n]);
    ghosts->InsertNextValue(n == 3 ? vtkDataSetAttributes::HIDDENPOINT : 0);
    vectors->InsertNextTuple3(1.0, 2.0, double(n));
  }
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(points);
  cloud->GetPointData()->AddArray(ghosts);
  cloud->GetPointData()->AddArray(vectors);
  vtkNew<vtkHorizonFromPoints> filter;
  filter->SetInputDataObject(cloud);
  filter->SetVerticalDirectionToUp();
  filter->Update();
  vtkPolyData* const horizon = Horizon(filter);
  CHECK_EQUAL(horizon->GetNumberOfPoints(), 11);
  CHECK(horizon->GetPointData()->GetArray("Normals_2") != nullptr);
  CHECK(horizon->GetPointData()->GetArray(vtkDataSetAttributes::GhostArrayName()) == nullptr);
  for (vtkIdType point = 0; point < horizon->GetNumberOfPoints(); ++point)
  {
    const auto n = std::size_t(horizon->GetPointData()->GetArray("Normals_2")->GetTuple1(point));
    CHECK(IsAt(horizon, point, survey.X[n], survey.Y[n], survey.Z[n]));
  }
}

void CheckRefused(vtkHorizonFromPoints* filter, const std::string& message)
{
  const Errors errors(filter);
  filter->Modified();
  filter->Update();
  CHECK_EQUAL(errors.Count(), std::size_t(1));
  CHECK(errors.FirstContains(": " + message));
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfPartitionedDataSets(), 0u);
}

/// Points of a plane that stand on no lattice, on one that is given.
void TestGridding()
{
  Numbers x, y, z;
  for (int n = 0; n < 200; ++n)
  {
    x.push_back(600000.0 + 1000.0 * std::fmod(0.618034 * n * n, 1.0));
    y.push_back(6000000.0 + 5.0 * n);
    z.push_back(1500.0 + 0.1 * (x.back() - 600000.0) - 0.2 * (y.back() - 6000000.0));
  }
  vtkNew<vtkHorizonFromPoints> filter;
  filter->SetInputDataObject(MakeTable({ { "X", x }, { "Y", y }, { "Z", z } }));
  CheckRefused(filter, "200 points without a lattice");
  filter->SetLatticeSourceToOriginAndSteps();
  filter->SetOrigin(600000.0, 6000000.0);
  filter->SetColumnStep(30.0, 40.0);
  filter->SetRowStep(-40.0, 30.0);
  filter->SetGriddingToPlate();
  filter->Update();
  vtkPolyData* const horizon = Horizon(filter);
  CHECK(horizon->GetNumberOfPoints() > 300);
  double off = 0.0;
  for (vtkIdType point = 0; point < horizon->GetNumberOfPoints(); ++point)
  {
    const double* const place = horizon->GetPoint(point);
    off = std::max(off, std::abs(-place[2] - 1500.0 - 0.1 * (place[0] - 600000.0) + 0.2 * (place[1] - 6000000.0)));
  }
  CHECK(off < 1e-6);
  CHECK(horizon->GetPointData()->GetArray("PickDistance") != nullptr);
  const vtkIdType points = horizon->GetNumberOfPoints();
  filter->SetGriddingRadius(10.0);
  filter->SetGriddingToNearest();
  filter->Update();
  // The columns of picks stay, of others those within the radius.
  vtkPointData* const near = Horizon(filter)->GetPointData();
  CHECK(Horizon(filter)->GetNumberOfPoints() < points);
  for (vtkIdType point = 0; point < Horizon(filter)->GetNumberOfPoints(); ++point)
  {
    CHECK(
      near->GetArray("PickCount")->GetTuple1(point) > 0.0 || near->GetArray("PickDistance")->GetTuple1(point) <= 10.0);
  }
  filter->SetGriddingRadius(-1.0);
  CheckRefused(filter, "GriddingRadius -1, expected 0 to 1e+12");
  filter->SetGriddingRadius(0.0);
  filter->SetDuplicatePolicyToSheets();
  CheckRefused(filter, "DuplicatePolicy Sheets with Gridding, expected one z");
}

void TestNames()
{
  Survey survey;
  Table table = MakeTable({ { "inline", survey.Inline }, { "crossline", survey.Crossline }, { "z", survey.Z } });
  vtkNew<vtkStringArray> names;
  names->SetName("Horizon");
  for (std::size_t n = 0; n < survey.Z.size(); ++n)
  {
    names->InsertNextValue(n % 3 == 0 ? "Top Reek" : "Base");
  }
  table->AddColumn(names);
  vtkNew<vtkHorizonFromPoints> filter;
  filter->SetInputDataObject(table);
  filter->Update();
  CHECK_EQUAL(filter->GetNumberOfHorizons(), 2);
  CHECK_EQUAL(Name(filter, 0), std::string("Top Reek"));
  CHECK_EQUAL(Horizon(filter, 0)->GetNumberOfPoints(), 4);
  CHECK_EQUAL(Horizon(filter, 1)->GetNumberOfPoints(), 8);
  CHECK_EQUAL(Horizon(filter, 1)->GetPointData()->GetArray("SurfaceId")->GetTuple1(0), 2.0);
  filter->SetHorizonStatus("Base", 0);
  filter->Update();
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfPartitionedDataSets(), 1u);
}

/// Names that are the same, here that of a horizon without one, are told apart.
void TestEqualNames()
{
  const Survey survey;
  Table table = MakeTable({ { "inline", survey.Inline }, { "crossline", survey.Crossline }, { "z", survey.Z } });
  vtkNew<vtkStringArray> names;
  names->SetName("Horizon");
  for (std::size_t n = 0; n < survey.Z.size(); ++n)
  {
    names->InsertNextValue(n % 3 == 0 ? "" : "Horizon 1");
  }
  table->AddColumn(names);
  vtkNew<vtkHorizonFromPoints> filter;
  filter->SetInputDataObject(table);
  filter->Update();
  CHECK_EQUAL(filter->GetNumberOfHorizons(), 2);
  CHECK_EQUAL(Name(filter, 0), std::string("Horizon 1"));
  CHECK_EQUAL(Name(filter, 1), std::string("Horizon 1 (2)"));
  CHECK_EQUAL(Horizon(filter, 1)->GetNumberOfPoints(), 8);
}

void TestChoiceAndNulls()
{
  Survey survey;
  Numbers depth = survey.Z;
  depth[4] = -999.25;
  depth[5] = 1e30;
  depth[6] = std::nan("");
  Numbers attribute = survey.Z;
  attribute[0] = -999.25;
  vtkNew<vtkHorizonFromPoints> filter;
  filter->SetInputDataObject(
    MakeTable({ { "a", survey.X }, { "b", survey.Y }, { "time", survey.Z }, { "c", depth }, { "extra", attribute } }));
  filter->SetXArray("a");
  filter->SetYArray("b");
  filter->SetZArray("c");
  filter->SetNullValues("-999.25");
  filter->Update();
  vtkPolyData* const horizon = Horizon(filter);
  CHECK_EQUAL(horizon->GetNumberOfPoints(), 9);
  CHECK_EQUAL(horizon->GetFieldData()->GetArray("DroppedNulls")->GetTuple1(0), 3.0);
  CHECK(horizon->GetPointData()->GetArray("time") != nullptr); // no longer z, so an attribute
  int missing = 0;
  for (vtkIdType point = 0; point < 9; ++point)
  {
    missing += std::isnan(horizon->GetPointData()->GetArray("extra")->GetTuple1(point)) ? 1 : 0;
  }
  CHECK_EQUAL(missing, 1);
}

/// One error that has the text, and an empty output.
void TestRefusals()
{
  const Survey survey;
  vtkNew<vtkHorizonFromPoints> filter;
  filter->SetInputDataObject(MakeTable({ { "X", survey.X }, { "Z", survey.Z } }));
  CheckRefused(filter, "arrays X, Z, expected Z, and X and Y or Inline and Crossline");
  filter->SetYArray("Q");
  CheckRefused(filter, "no array of numbers Q for Y, expected one of X, Z");
  filter->SetYArray(nullptr);
  filter->SetInputDataObject(Table::New());
  CheckRefused(filter, "no points, expected at least one");
  for (const Numbers& wrong : { Numbers(), Numbers(5), Numbers(13) })
  {
    const Table table = MakeTable({ { "X", survey.X }, { "Y", survey.Y }, { "Z", survey.Z } });
    table->GetRowData()->AddArray(MakeTable({ { "Amp", wrong } })->GetColumn(0)); // unlike AddColumn not looked at
    filter->SetInputDataObject(table);
    CheckRefused(
      filter, "array Amp of " + std::to_string(wrong.size()) + " tuples, expected one for each of the 12 rows");
  }
  Numbers infinite = survey.X;
  infinite[2] = std::numeric_limits<double>::infinity();
  filter->SetInputDataObject(MakeTable({ { "X", infinite }, { "Y", survey.Y }, { "Z", survey.Z } }));
  CheckRefused(filter, "point 2 at X inf, Y 6000058");
  filter->SetInputDataObject(MakeTable({ { "X", survey.X }, { "Y", survey.Y }, { "Z", survey.Z } }));
  filter->SetVerticalStep(-1.0);
  CheckRefused(filter, "VerticalStep -1, expected a positive number, or 0");
  filter->SetVerticalStep(0.0);
  filter->SetLatticeTolerance(0.7);
  CheckRefused(filter, "LatticeTolerance 0.7, expected more than 0");
}
}

int TestHorizonFromPoints(int, char*[])
{
  TestLinesAndPlaces();
  TestSheets();
  TestPointSet();
  TestGridding();
  TestNames();
  TestEqualNames();
  TestChoiceAndNulls();
  TestRefusals();
  return Check::Result();
}
