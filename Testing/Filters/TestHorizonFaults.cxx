// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The filter around the detection of faults: what is in its outputs, lines that are given, errors. Which links are cut
// is checked in TestFaultDetection and TestFaultPolylines.

#include "HorizonFixtures.h"
#include "Tools/Check.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkHorizonFaults.h"
#include "vtkHorizonHoleFilling.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkStringArray.h"

#include <array>
#include <cmath>
#include <limits>
#include <sstream>

namespace
{
using HorizonFixtures::Errors;

/// A step of 7 downwards between the columns 14 and 15.
double Torn(int i, int)
{
  return i < 15 ? 20.0 : 27.0;
}

double Level(int, int)
{
  return 20.0;
}

vtkSmartPointer<vtkPolyData> Horizon(double (*height)(int, int), vtkMatrix4x4* survey)
{
  return HorizonFixtures::FromPicture(HorizonFixtures::Rectangle(30, 25), 7, survey, height);
}

/// A polyline through places in columns.
vtkSmartPointer<vtkPolyData> Line(
  const std::vector<std::array<double, 2>>& places, vtkMatrix4x4* survey, bool isPolygon)
{
  auto lines = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(int(places.size()));
  for (const std::array<double, 2>& place : places)
  {
    const double lattice[4] = { place[0], place[1], -500.0, 1.0 };
    double world[4];
    survey->MultiplyPoint(lattice, world);
    cells->InsertCellPoint(points->InsertNextPoint(world));
  }
  lines->SetPoints(points);
  isPolygon ? lines->SetPolys(cells) : lines->SetLines(cells);
  return lines;
}

vtkPolyData* Faults(vtkHorizonFaults* filter)
{
  return vtkPolyData::SafeDownCast(filter->GetOutputDataObject(1));
}

void TestOutputs()
{
  const auto survey = HorizonFixtures::RotatedSurvey();
  const auto input = Horizon(Torn, survey);
  vtkNew<vtkHorizonFaults> filter;
  filter->SetInputData(input);
  filter->Update();
  vtkPolyData* const output = filter->GetPolyDataOutput();
  CHECK(output->GetPoints() == input->GetPoints());
  CHECK_EQUAL(output->GetPointData()->GetNumberOfArrays(), input->GetPointData()->GetNumberOfArrays() + 1); // Column
  auto* const links = vtkIntArray::SafeDownCast(output->GetFieldData()->GetAbstractArray("CutLinks"));
  auto* const throws = vtkDoubleArray::SafeDownCast(output->GetFieldData()->GetAbstractArray("CutThrow"));
  auto* const lines = vtkIntArray::SafeDownCast(output->GetFieldData()->GetAbstractArray("CutLine"));
  if (!CHECK(links && throws && lines) || !CHECK_EQUAL(links->GetNumberOfTuples(), 25))
  {
    return;
  }
  CHECK_EQUAL(links->GetNumberOfComponents(), 3);
  for (int j = 0; j < 25; ++j)
  {
    CHECK_EQUAL(links->GetTypedComponent(j, 0), 14);
    CHECK_EQUAL(links->GetTypedComponent(j, 1), j);
    CHECK_EQUAL(links->GetTypedComponent(j, 2), 0);
    CHECK(std::abs(throws->GetValue(j) - 7.0) < 1e-6);
    CHECK_EQUAL(lines->GetValue(j), 0);
  }
  CHECK_EQUAL(filter->GetNumberOfFaultLines(), 1);
  CHECK_EQUAL(filter->GetNumberOfCutLinks(), 25);
  CHECK_EQUAL(filter->GetMeasuredNoise(), 0.408);
  CHECK_EQUAL(output->GetFieldData()->GetArray("FaultNoise")->GetTuple1(0), 0.408);
  // The line goes from corner to corner, half a column beyond the rows, at half the throw. Its left is the side of the
  // larger vertical index: south.
  vtkPolyData* const faults = Faults(filter);
  CHECK_EQUAL(faults->GetNumberOfLines(), 1);
  CHECK_EQUAL(faults->GetNumberOfPoints(), 27);
  const double first[4] = { 14.5, 24.5, 23.5, 1.0 };
  double world[4];
  survey->MultiplyPoint(first, world);
  double found[3];
  faults->GetPoint(0, found);
  CHECK(std::abs(found[0] - world[0]) < 1e-5 && std::abs(found[1] - world[1]) < 1e-5);
  CHECK(std::abs(found[2] - world[2]) < 1e-5);
  CHECK(std::abs(faults->GetPointData()->GetArray("Throw")->GetTuple1(0) - 7.0) < 1e-6);
  CHECK_EQUAL(faults->GetCellData()->GetArray("FaultLine")->GetTuple1(0), 0.0);
}

void TestGivenLines()
{
  const auto survey = HorizonFixtures::RotatedSurvey();
  vtkNew<vtkHorizonFaults> filter;
  filter->SetInputData(Horizon(Torn, survey));
  filter->SetInputData(1, Line({ { 4.5, -3.0 }, { 4.5, 9.5 } }, survey, false));
  filter->DetectOff();
  filter->Update();
  CHECK_EQUAL(filter->GetNumberOfCutLinks(), 10);
  CHECK(!filter->GetPolyDataOutput()->GetFieldData()->HasArray("FaultNoise"));
  filter->DetectOn(); // with what is found
  filter->Update();
  CHECK_EQUAL(filter->GetNumberOfCutLinks(), 35);
  CHECK_EQUAL(filter->GetNumberOfFaultLines(), 2);
  // A polygon is cut all around, a composite dataset gives all it has.
  filter->DetectOff();
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, Line({ { 4.5, 4.5 }, { 6.5, 4.5 }, { 6.5, 6.5 }, { 4.5, 6.5 } }, survey, true));
  blocks->SetBlock(2, Line({ { 20.5, 10.5 }, { 20.5, 13.5 } }, survey, false));
  filter->SetInputData(1, blocks);
  filter->Update();
  CHECK_EQUAL(filter->GetNumberOfCutLinks(), 8 + 3);
  filter->RemoveFaultLines();
  filter->Update();
  CHECK_EQUAL(filter->GetNumberOfCutLinks(), 0);
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
  CHECK_EQUAL(filter->GetNumberOfCutLinks(), 6);
  vtkFieldData* const data = filter->GetPolyDataOutput()->GetFieldData();
  CHECK_EQUAL(data->GetArray("CutLinks")->GetComponent(0, 0), 4.0);
  sticks->GetCellData()->RemoveArray("FaultName"); // now all are of one fault
  sticks->Modified();
  filter->Update();
  CHECK_EQUAL(filter->GetNumberOfCutLinks(), 11);
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
  blocks->SetBlock(2, Line({ { 19.5, 3.5 }, { 22.5, 3.5 }, { 22.5, 5.5 }, { 19.5, 5.5 }, { 19.5, 3.5 } }, survey, false));
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
  const vtkIdType all = filter->GetNumberOfCutLinks();
  CHECK_EQUAL(all, 2 * (4 + 5) + 2 * (4 + 1) + 2 * (3 + 2) + 3);
  filter->SetPolygonsToCut();
  filter->Update();
  CHECK_EQUAL(output->GetNumberOfPoints(), 30 * 25);
  CHECK(!output->GetFieldData()->HasArray("BlankedPoints"));
  CHECK_EQUAL(filter->GetNumberOfCutLinks(), all);
  filter->SetPolygonsToLeave();
  filter->Update();
  CHECK_EQUAL(output->GetNumberOfPoints(), 30 * 25);
  CHECK_EQUAL(filter->GetNumberOfCutLinks(), 3);
  // Between columns: nothing is inside, both sides cut.
  filter->SetPolygonsToBlank();
  filter->SetInputData(1, Line({ { 4.2, 4.5 }, { 4.8, 4.5 }, { 4.8, 9.5 }, { 4.2, 9.5 } }, survey, true));
  filter->Update();
  CHECK_EQUAL(Blanked(filter), 0);
  CHECK_EQUAL(filter->GetNumberOfCutLinks(), 5);
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
  CHECK_EQUAL(filter->GetNumberOfCutLinks(), 2 * 11);
  filter->ExtendSticksOn(); // by five rows to either side
  filter->Update();
  CHECK_EQUAL(block(0)->GetNumberOfPolys(), 8);
  CHECK_EQUAL(filter->GetNumberOfCutLinks(), 2 * 18); // the horizon begins in row 0
}

/// The cuts of an earlier run are replaced, and the stages read what is written.
void TestInPipeline()
{
  const auto survey = HorizonFixtures::UnitSurvey();
  vtkNew<vtkHorizonFaults> filter;
  filter->SetInputData(Horizon(Torn, survey));
  vtkNew<vtkHorizonFaults> again;
  again->SetInputConnection(filter->GetOutputPort());
  again->DetectOff();
  again->SetInputData(1, Line({ { 4.5, -3.0 }, { 4.5, 9.5 } }, survey, false));
  again->Update();
  CHECK_EQUAL(again->GetNumberOfCutLinks(), 10);
  vtkNew<vtkHorizonHoleFilling> filling;
  filling->SetInputConnection(again->GetOutputPort());
  const Errors errors(filling);
  filling->Update();
  CHECK_EQUAL(errors.Count(), 0U);
}

void TestSeveralHorizons()
{
  const auto survey = HorizonFixtures::UnitSurvey();
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, Horizon(Torn, survey));
  blocks->SetBlock(1, Horizon(Level, survey));
  vtkNew<vtkHorizonFaults> filter;
  filter->SetInputData(blocks);
  filter->SetInputData(1, Line({ { 4.5, -3.0 }, { 4.5, 9.5 } }, survey, false));
  filter->Update();
  auto* const faults = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(1));
  CHECK_EQUAL(vtkPolyData::SafeDownCast(faults->GetBlock(0))->GetNumberOfLines(), 2);
  CHECK_EQUAL(vtkPolyData::SafeDownCast(faults->GetBlock(1))->GetNumberOfLines(), 1);
  CHECK_EQUAL(filter->GetNumberOfCutLinks(), 45);
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
  CHECK_EQUAL(filter->GetNumberOfCutLinks(), 0);
  CHECK_EQUAL(filter->GetPolyDataOutput()->GetNumberOfPoints(), 750);
}

void CheckError(vtkHorizonFaults* filter, const std::string& message)
{
  const Errors errors(filter);
  filter->Modified();
  filter->Update();
  CHECK_EQUAL(errors.Count(), 1U);
  if (!CHECK(errors.FirstContains(message)))
  {
    std::cerr << errors.First() << '\n';
  }
  CHECK_EQUAL(filter->GetPolyDataOutput()->GetNumberOfPoints(), 0);
}

void TestErrors()
{
  const auto survey = HorizonFixtures::UnitSurvey();
  vtkNew<vtkHorizonFaults> filter;
  filter->SetInputData(Horizon(Torn, survey));
  filter->SetSmallestThrow(std::numeric_limits<double>::infinity());
  CheckError(filter, "Horizon 7: smallest throw inf, expected a finite number, at least 0 vertical indices");
  filter->SetSmallestThrow(4.0);
  filter->SetNoise(std::nan(""));
  CheckError(filter, "noise nan, expected a finite number, at least 0 vertical indices");
  filter->SetNoise(0.0);
  filter->SetInputData(1, Line({ { 1.0, 1.0 }, { std::nan(""), 2.0 } }, survey, false));
  CheckError(filter, "fault polyline 0 with a point at (nan, ");
  filter->SetInputData(1, Line({ { -1.0, -1.0 }, { 40.0, -1.0 }, { 40.0, 40.0 }, { -1.0, 40.0 } }, survey, true));
  CheckError(filter, "fault polygons around all 750 points, expected some outside");
  filter->RemoveFaultLines();
  filter->SetLargestRamp(16);
  CheckError(filter, "largest ramp 16, expected 0 to 15 columns");
  filter->SetLargestRamp(7);
  const auto twice = Horizon(Torn, survey);
  twice->GetPoints()->SetPoint(1, twice->GetPoint(0));
  filter->SetInputData(twice);
  CheckError(filter, "points 0 and 1 both in column (0, 0), expected at most one point of a horizon in a column");
  const auto single = HorizonFixtures::FromPicture({ "#" }, 7, survey);
  filter->SetInputData(single);
  filter->Update();
  CHECK_EQUAL(filter->GetPolyDataOutput()->GetNumberOfPoints(), 1);
  CHECK_EQUAL(filter->GetNumberOfCutLinks(), 0);
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
    CHECK_EQUAL(filter->GetNumberOfCutLinks(), 0);
    filter->SetInputData(1,
      makeLine(
        [](int n) {
          return std::array<double, 2>{ 9.5 + 0.2 * std::sin(0.01 * n), 9.5 + 0.2 * std::cos(n) };
        }));
    filter->Update();
    CHECK_EQUAL(filter->GetNumberOfCutLinks(), 0); // within one block
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

/// A vertical index is 4 long: a step of 7 is one of 28. Of no throw, that of eight times the noise, here of rounding.
void TestThrowUnit()
{
  vtkNew<vtkHorizonFaults> filter;
  filter->SetInputData(Horizon(Torn, HorizonFixtures::RotatedSurvey()));
  const auto figure = [&](const char* name)
  { return filter->GetPolyDataOutput()->GetFieldData()->GetArray(name)->GetTuple1(0); };
  filter->Update();
  CHECK_EQUAL(filter->GetNumberOfFaultLines(), 1);
  filter->SetNoise(0.5);
  filter->Update();
  CHECK(std::abs(figure("SmallestFaultThrow") - 8.0 * 0.5 / std::sqrt(2.0)) < 1e-12);
  filter->SetThrowUnitToWorld();
  filter->SetNoise(2.0);
  filter->Update();
  CHECK_EQUAL(figure("FaultNoise"), 0.5);
  CHECK(std::abs(figure("SmallestFaultThrow") - 8.0 * 0.5 / std::sqrt(2.0)) < 1e-12);
  for (const auto& [given, lines] : { std::pair(27.0, 1), std::pair(29.0, 0) })
  {
    filter->SetSmallestThrow(given);
    filter->Update();
    CHECK_EQUAL(filter->GetNumberOfFaultLines(), lines);
    CHECK_EQUAL(figure("SmallestFaultThrow"), given / 4.0);
  }
  CHECK(std::string(filter->GetResults()).find("links cut") == std::string::npos);
  filter->SetSmallestThrow(27.0);
  filter->Update();
  CHECK(std::string(filter->GetResults()).find("fault lines 1\n  links cut 25\n  noise 0.5") != std::string::npos);
  filter->SetSmallestThrow(29.0);
  filter->Update();
  CHECK(std::string(filter->GetResults()).find("smallest throw 7.25 vertical indices, 29 in z") != std::string::npos);
}

void TestPrintSelf()
{
  vtkNew<vtkHorizonFaults> filter;
  filter->SetSmallestThrow(2.5);
  filter->SetNoise(0.75);
  filter->SetThrowUnitToWorld();
  filter->SetSmallestExtent(11);
  filter->SetSmallestBranch(7);
  filter->SetLargestGap(3);
  filter->SetLargestRamp(5);
  filter->JoinThroughHolesOff();
  filter->ExtendSticksOn();
  filter->SetPolygonsToCut();
  filter->DetectOff();
  filter->SetLineTypeToSticks();
  std::ostringstream text;
  filter->Print(text);
  for (const char* const line :
    { "LineType: Sticks", "Detect: off", "SmallestThrow: 2.5", "Noise: 0.75", "ThrowUnit: World", "SmallestExtent: 11",
      "SmallestBranch: 7", "LargestGap: 3", "LargestRamp: 5",
      "JoinThroughHoles: off", "ExtendSticks: on", "Polygons: Cut", "NumberOfCutLinks: 0", "NumberOfFaultLines: 0", "MeasuredNoise: 0" })
  {
    CHECK(text.str().find(line) != std::string::npos);
  }
}
}

int TestHorizonFaults(int, char*[])
{
  TestOutputs();
  TestGivenLines();
  TestSticks();
  TestPolygons();
  TestSurfaces();
  TestInPipeline();
  TestSeveralHorizons();
  TestLinesBesideTheHorizon();
  TestErrors();
  TestEndlessLines();
  TestCellsWithoutPoints();
  TestThrowUnit();
  TestPrintSelf();
  return Check::Result();
}
