// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Traces, polygons and sticks as the second input of the filter for faults.

#include "FaultLineFixtures.h"

#include "vtkCellData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkStringArray.h"

#include <cmath>

using namespace FaultLineFixtures;

namespace
{
void TestGivenLines()
{
  const auto survey = HorizonFixtures::RotatedSurvey();
  vtkNew<vtkHorizonFaults> filter;
  filter->SetInputData(Horizon(Torn, survey));
  filter->SetInputData(1, Line({ { 4.5, -3.0 }, { 4.5, 9.5 } }, survey, false));
  filter->DetectOff();
  filter->Update();
  CHECK_EQUAL(filter->GetNumberOfFaultedLinks(), 10);
  CHECK(!filter->GetPolyDataOutput()->GetFieldData()->HasArray("FaultNoise"));
  filter->DetectOn(); // with what is found
  filter->Update();
  CHECK_EQUAL(filter->GetNumberOfFaultedLinks(), 35);
  CHECK_EQUAL(filter->GetNumberOfFaultLines(), 2);
  // A polygon is cut all around, a composite dataset gives all it has.
  filter->DetectOff();
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, Line({ { 4.5, 4.5 }, { 6.5, 4.5 }, { 6.5, 6.5 }, { 4.5, 6.5 } }, survey, true));
  blocks->SetBlock(2, Line({ { 20.5, 10.5 }, { 20.5, 13.5 } }, survey, false));
  filter->SetInputData(1, blocks);
  filter->Update();
  CHECK_EQUAL(filter->GetNumberOfFaultedLinks(), 8 + 3);
  filter->RemoveFaultLines();
  filter->Update();
  CHECK_EQUAL(filter->GetNumberOfFaultedLinks(), 0);
  CHECK_EQUAL(Faults(filter)->GetNumberOfPoints(), 0);
}

/// Two sticks that pass through the horizon between the columns 4 and 5, in the rows 2 and 7, and one of another fault.
void TestSticks()
{
  const auto survey = HorizonFixtures::RotatedSurvey();
  auto sticks = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkStringArray> names;
  names->SetName("FaultName");
  for (const double j : { 2.0, 7.0, 12.0 })
  {
    cells->InsertNextCell(2);
    for (const double k : { 0.0, 40.0 })
    {
      const double lattice[4] = { 4.4 + 0.1 * (k - 20.0) / 20.0, j, k, 1.0 };
      double world[4];
      survey->MultiplyPoint(lattice, world);
      cells->InsertCellPoint(points->InsertNextPoint(world));
    }
    names->InsertNextValue(j > 10.0 ? "G 1" : "F " + std::to_string(int(j)));
  }
  sticks->SetPoints(points);
  sticks->SetLines(cells);
  sticks->GetCellData()->AddArray(names);
  vtkNew<vtkHorizonFaults> filter;
  filter->SetInputData(Horizon(Level, survey));
  filter->SetInputData(1, sticks);
  filter->DetectOff();
  filter->SetLineTypeToSticks();
  filter->Update();
  CHECK_EQUAL(filter->GetNumberOfFaultLines(), 1);
  CHECK_EQUAL(filter->GetNumberOfFaultedLinks(), 6);
  vtkFieldData* const data = filter->GetPolyDataOutput()->GetFieldData();
  CHECK_EQUAL(data->GetArray("FaultedLinks")->GetComponent(0, 0), 4.0);
  sticks->GetCellData()->RemoveArray("FaultName"); // now all are of one fault
  sticks->Modified();
  filter->Update();
  CHECK_EQUAL(filter->GetNumberOfFaultedLinks(), 11);
}

vtkIdType Blanked(vtkHorizonFaults* filter)
{
  return vtkIdType(filter->GetPolyDataOutput()->GetFieldData()->GetArray("BlankedPoints")->GetTuple1(0));
}

/// Two polygons that overlap, a closed line, and a line that is not closed.
void TestPolygons()
{
  const auto survey = HorizonFixtures::RotatedSurvey();
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, Line({ { 4.5, 4.5 }, { 8.5, 4.5 }, { 8.5, 9.5 }, { 4.5, 9.5 } }, survey, true));
  blocks->SetBlock(1, Line({ { 6.5, 6.5 }, { 10.5, 6.5 }, { 10.5, 7.5 }, { 6.5, 7.5 } }, survey, true));
  blocks->SetBlock(
    2, Line({ { 19.5, 3.5 }, { 22.5, 3.5 }, { 22.5, 5.5 }, { 19.5, 5.5 }, { 19.5, 3.5 } }, survey, false));
  blocks->SetBlock(3, Line({ { 13.5, 12.5 }, { 13.5, 15.5 } }, survey, false));
  const auto input = Horizon(Level, survey);
  vtkNew<vtkHorizonFaults> filter;
  filter->SetInputData(input);
  filter->SetInputData(1, blocks);
  filter->DetectOff();
  filter->Update();
  vtkPolyData* const output = filter->GetPolyDataOutput();
  CHECK_EQUAL(Blanked(filter), 4 * 5 + 2 + 3 * 2);
  CHECK_EQUAL(output->GetNumberOfPoints(), 30 * 25 - 28);
  CHECK_EQUAL(output->GetPointData()->GetNumberOfArrays(), input->GetPointData()->GetNumberOfArrays() + 1);
  const vtkIdType all = filter->GetNumberOfFaultedLinks();
  CHECK_EQUAL(all, 2 * (4 + 5) + 2 * (4 + 1) + 2 * (3 + 2) + 3);
  filter->SetPolygonsToCut();
  filter->Update();
  CHECK_EQUAL(output->GetNumberOfPoints(), 30 * 25);
  CHECK(!output->GetFieldData()->HasArray("BlankedPoints"));
  CHECK_EQUAL(filter->GetNumberOfFaultedLinks(), all);
  filter->SetPolygonsToLeave();
  filter->Update();
  CHECK_EQUAL(output->GetNumberOfPoints(), 30 * 25);
  CHECK_EQUAL(filter->GetNumberOfFaultedLinks(), 3);
  // Between columns: nothing is inside, both sides cut.
  filter->SetPolygonsToBlank();
  filter->SetInputData(1, Line({ { 4.2, 4.5 }, { 4.8, 4.5 }, { 4.8, 9.5 }, { 4.2, 9.5 } }, survey, true));
  filter->Update();
  CHECK_EQUAL(Blanked(filter), 0);
  CHECK_EQUAL(filter->GetNumberOfFaultedLinks(), 5);
}

/// Two sticks in the wrong order make triangles of their fault, once for all horizons.
void TestSurfaces()
{
  const auto survey = HorizonFixtures::UnitSurvey();
  auto sticks = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkStringArray> names;
  names->SetName("FaultName");
  for (const double j : { 2.0, 12.0, 7.0 })
  {
    cells->InsertNextCell(2);
    for (const double k : { 0.0, 40.0 })
    {
      const double lattice[4] = { 4.4, j, k, 1.0 };
      double world[4];
      survey->MultiplyPoint(lattice, world);
      cells->InsertCellPoint(points->InsertNextPoint(world));
    }
    names->InsertNextValue("F " + std::to_string(int(j)));
  }
  sticks->SetPoints(points);
  sticks->SetLines(cells);
  sticks->GetCellData()->AddArray(names);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, Horizon(Level, survey));
  blocks->SetBlock(1, Horizon(Level, survey));
  vtkNew<vtkHorizonFaults> filter;
  filter->SetInputData(blocks);
  filter->SetInputData(1, sticks);
  filter->DetectOff();
  filter->SetLineTypeToSticks();
  filter->Update();
  const auto block = [&filter](unsigned int number)
  {
    auto* const surfaces = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(2));
    return vtkPolyData::SafeDownCast(surfaces->GetBlock(number));
  };
  vtkPolyData* const surface = block(0);
  CHECK_EQUAL(surface->GetNumberOfPolys(), 4);
  CHECK_EQUAL(surface->GetNumberOfPoints(), 6);
  auto* const fault = vtkStringArray::SafeDownCast(surface->GetCellData()->GetAbstractArray("FaultName"));
  CHECK(fault && fault->GetValue(3) == "F");
  CHECK_EQUAL(block(1)->GetNumberOfPolys(), 0);
  CHECK_EQUAL(filter->GetNumberOfFaultedLinks(), 2 * 11);
  filter->ExtendSticksOn(); // by five rows to either side
  filter->Update();
  CHECK_EQUAL(block(0)->GetNumberOfPolys(), 8);
  CHECK_EQUAL(filter->GetNumberOfFaultedLinks(), 2 * 18); // the horizon begins in row 0
}

void TestLinesBesideTheHorizon()
{
  const auto survey = HorizonFixtures::UnitSurvey();
  vtkNew<vtkHorizonFaults> filter;
  filter->SetInputData(Horizon(Level, survey));
  filter->SetInputData(1, Line({ { 604321.0, 6079543.0 }, { 604400.0, 6079600.0 } }, survey, false));
  const Errors warnings(filter, vtkCommand::WarningEvent);
  filter->Update();
  CHECK(warnings.FirstContains(
    "none of 1 fault polylines passes between columns of a horizon, expected lines in the coordinates of its points"));
  CHECK_EQUAL(filter->GetNumberOfFaultedLinks(), 0);
  CHECK_EQUAL(filter->GetPolyDataOutput()->GetNumberOfPoints(), 750);
}

/// Lines of a million places: far away, to and fro across the horizon, and in circles over it.
void TestEndlessLines()
{
  const auto survey = HorizonFixtures::UnitSurvey();
  constexpr int size = 1000000;
  const auto makeLine = [&survey](auto&& placeOf)
  {
    std::vector<std::array<double, 2>> places;
    for (int n = 0; n < size; ++n)
    {
      places.push_back(placeOf(n));
    }
    return Line(places, survey, false);
  };
  vtkNew<vtkHorizonFaults> filter;
  filter->SetInputData(Horizon(Level, survey));
  filter->DetectOff();
  for (const bool areSticks : { false, true })
  {
    areSticks ? filter->SetLineTypeToSticks() : filter->SetLineTypeToTraces();
    filter->SetInputData(1, makeLine([](int n) { return std::array<double, 2>{ n % 2 == 0 ? -1e9 : 1e9, 40.0 + n }; }));
    filter->Update();
    CHECK_EQUAL(filter->GetNumberOfFaultedLinks(), 0);
    filter->SetInputData(1,
      makeLine(
        [](int n) {
          return std::array<double, 2>{ 9.5 + 0.2 * std::sin(0.01 * n), 9.5 + 0.2 * std::cos(n) };
        }));
    filter->Update();
    CHECK_EQUAL(filter->GetNumberOfFaultedLinks(), 0); // within one block
  }
  filter->SetLineTypeToTraces();
  filter->SetInputData(1,
    makeLine(
      [](int n) {
        return std::array<double, 2>{ n % 2 == 0 ? -1e9 : 1e9, 24.0 * n / size };
      }));
  CheckError(filter, "links of a horizon of 750 columns, expected at most 1000000");
}

void TestCellsWithoutPoints()
{
  const auto survey = HorizonFixtures::UnitSurvey();
  vtkNew<vtkHorizonFaults> filter;
  filter->SetInputData(Horizon(Torn, survey));
  const auto lines = Line({ { 1.0, 1.0 }, { 9.0, 2.0 } }, survey, false);
  lines->GetLines()->InsertNextCell({ 0, 2 });
  filter->SetInputData(1, lines);
  CheckError(filter, "point id 2 in fault polyline 1, expected 0 to 1");
  lines->SetPoints(nullptr);
  CheckError(filter, "point id 0 in fault polyline 0, expected 0 to -1");
  vtkNew<vtkPolyData> empty;
  filter->SetInputData(1, empty);
  filter->Update();
  CHECK_EQUAL(filter->GetNumberOfFaultLines(), 1); // that is found
}
}

int TestHorizonFaultLines(int, char*[])
{
  TestGivenLines();
  TestSticks();
  TestPolygons();
  TestSurfaces();
  TestLinesBesideTheHorizon();
  TestEndlessLines();
  TestCellsWithoutPoints();
  return Check::Result();
}
