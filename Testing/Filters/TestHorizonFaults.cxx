// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The filter around the detection of faults: what is in its outputs, and errors. Which links are cut is checked in
// TestFaultDetection and TestFaultPolylines.

#include "FaultLineFixtures.h"

#include "vtkCellData.h"
#include "vtkHorizonHoleFilling.h"
#include "vtkMultiBlockDataSet.h"

#include <cmath>
#include <limits>
#include <sstream>

using namespace FaultLineFixtures;

namespace
{
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
  auto* const links = vtkIntArray::SafeDownCast(output->GetFieldData()->GetAbstractArray("FaultedLinks"));
  auto* const throws = vtkDoubleArray::SafeDownCast(output->GetFieldData()->GetAbstractArray("FaultThrow"));
  auto* const lines = vtkIntArray::SafeDownCast(output->GetFieldData()->GetAbstractArray("FaultLine"));
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
  CHECK_EQUAL(filter->GetNumberOfFaultedLinks(), 25);
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
  CHECK_EQUAL(again->GetNumberOfFaultedLinks(), 10);
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
  CHECK_EQUAL(filter->GetNumberOfFaultedLinks(), 45);
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
  CheckError(filter, "fault polygons enclose all 750 points, expected some outside");
  filter->RemoveFaultLines();
  filter->SetLargestRamp(16);
  CheckError(filter, "largest ramp 16, expected 0 to 10 columns");
  filter->SetLargestRamp(7);
  const auto twice = Horizon(Torn, survey);
  twice->GetPoints()->SetPoint(1, twice->GetPoint(0));
  filter->SetInputData(twice);
  CheckError(filter, "points 0 and 1 both in column (0, 0), expected at most one point of a horizon in a column");
  const auto single = HorizonFixtures::FromPicture({ "#" }, 7, survey);
  filter->SetInputData(single);
  filter->Update();
  CHECK_EQUAL(filter->GetPolyDataOutput()->GetNumberOfPoints(), 1);
  CHECK_EQUAL(filter->GetNumberOfFaultedLinks(), 0);
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
      "SmallestBranch: 7", "LargestGap: 3", "LargestRamp: 5", "JoinThroughHoles: off", "ExtendSticks: on",
      "Polygons: Cut", "NumberOfFaultedLinks: 0", "NumberOfFaultLines: 0", "MeasuredNoise: 0" })
  {
    CHECK(text.str().find(line) != std::string::npos);
  }
}
}

int TestHorizonFaults(int, char*[])
{
  TestOutputs();
  TestInPipeline();
  TestSeveralHorizons();
  TestErrors();
  TestThrowUnit();
  TestPrintSelf();
  return Check::Result();
}
