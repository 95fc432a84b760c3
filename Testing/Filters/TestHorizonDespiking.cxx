// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonFixtures.h"
#include "Tools/Check.h"

#include "vtkHorizonDespiking.h"
#include "vtkHorizonExteriorBoundary.h"
#include "vtkHorizonHoleFilling.h"

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace
{
using HorizonFixtures::FromPicture;

/// A plane with a spike of 12 in column (3, 2), which is point 15 of the square, and of -7 in column (4, 4), point 28.
double Spiky(int i, int j)
{
  return 20.0 + i + (i == 3 && j == 2 ? 12.0 : i == 4 && j == 4 ? -7.0 : 0.0);
}

/// A square of six.
vtkSmartPointer<vtkPolyData> WithSpikes()
{
  return FromPicture(
    { "######", "######", "######", "######", "######", "######" }, 3, HorizonFixtures::RotatedSurvey(), Spiky);
}

double Value(vtkPolyData* horizon, const char* name, vtkIdType point)
{
  vtkDataArray* const array = horizon->GetPointData()->GetArray(name);
  return array ? array->GetComponent(point, 0) : std::nan("");
}

void TestRemove()
{
  auto input = WithSpikes();
  vtkNew<vtkHorizonDespiking> despiking;
  despiking->SetInputDataObject(input);
  despiking->Update();
  vtkPolyData* const output = despiking->GetPolyDataOutput();
  CHECK_EQUAL(output->GetNumberOfPoints(), 34);
  CHECK_EQUAL(output->GetNumberOfVerts(), 34);
  CHECK_EQUAL(despiking->GetNumberOfSpikes(), 2);
  CHECK_EQUAL(despiking->GetNumberOfSpurPoints(), 0);
  CHECK_EQUAL(output->GetFieldData()->GetArray("NumberOfSpikes")->GetTuple1(0), 2.0);
  vtkIdType kept = 0;
  for (vtkIdType point = 0; point < 36; ++point)
  {
    if (point != 15 && point != 28)
    {
      CHECK_EQUAL(output->GetPoint(kept)[2], input->GetPoint(point)[2]);
      CHECK_EQUAL(Value(output, "Amplitude", kept), Value(input, "Amplitude", point));
      ++kept;
    }
  }
  CHECK(!output->GetPointData()->HasArray("Spike"));
  auto* const spikes = vtkPolyData::SafeDownCast(despiking->GetOutputDataObject(1));
  CHECK_EQUAL(spikes->GetNumberOfPoints(), 2);
  CHECK_EQUAL(spikes->GetNumberOfVerts(), 2);
  CHECK(spikes->GetPoint(0)[2] == input->GetPoint(15)[2] && spikes->GetPoint(1)[2] == input->GetPoint(28)[2]);
  CHECK(Value(spikes, "Spike", 0) == 1.0 && Value(spikes, "Spike", 1) == 1.0);
  vtkNew<vtkHorizonHoleFilling> filling;
  filling->SetInputConnection(despiking->GetOutputPort());
  filling->Update();
  CHECK_EQUAL(filling->GetPolyDataOutput()->GetNumberOfPoints(), 36);
  CHECK_EQUAL(Value(filling->GetPolyDataOutput(), "VerticalIndex", 34), 23.0);
  CHECK_EQUAL(Value(filling->GetPolyDataOutput(), "VerticalIndex", 35), 24.0);
}

void TestFlag()
{
  vtkNew<vtkHorizonExteriorBoundary> outline;
  vtkNew<vtkHorizonDespiking> despiking;
  outline->SetInputDataObject(WithSpikes());
  despiking->SetInputConnection(outline->GetOutputPort());
  despiking->SetActionToFlag();
  despiking->SetThreshold(10.0);
  despiking->Update();
  vtkPolyData* const output = despiking->GetPolyDataOutput();
  CHECK_EQUAL(output->GetNumberOfPoints(), 36);
  CHECK_EQUAL(output->GetNumberOfLines(), 0);
  CHECK(!output->GetPointData()->HasArray("PatchId") && !output->GetPointData()->HasArray("Boundary"));
  CHECK(output->GetPointData()->GetArray("Spike")->GetDataType() == VTK_UNSIGNED_CHAR);
  for (vtkIdType point = 0; point < 36; ++point)
  {
    CHECK_EQUAL(Value(output, "Spike", point), point == 15 ? 1.0 : 0.0);
  }
  CHECK_EQUAL(despiking->GetNumberOfSpikes(), 1);
}

void TestSpurs()
{
  vtkNew<vtkHorizonDespiking> despiking;
  despiking->SetInputDataObject(
    FromPicture({ "####.####", "#########", "####.####" }, 3, HorizonFixtures::UnitSurvey()));
  despiking->SetSpurWidth(1);
  despiking->SetThreshold(1000.0);
  despiking->Update();
  CHECK_EQUAL(despiking->GetPolyDataOutput()->GetNumberOfPoints(), 24);
  CHECK_EQUAL(despiking->GetNumberOfSpurPoints(), 1);
  const HorizonFixtures::Errors warnings(despiking, vtkCommand::WarningEvent);
  despiking->SetSpurWidth(3);
  despiking->Update(); // nothing is left
  CHECK_EQUAL(despiking->GetPolyDataOutput()->GetNumberOfPoints(), 0);
  CHECK_EQUAL(despiking->GetNumberOfSpurPoints(), 25);
  CHECK(warnings.FirstContains("Horizon 3: 25 of 25 points are on spurs, expected less than half"));
}

/// In the world, where a vertical index is 4 long, and by the noise: the field data tell the threshold in both.
void TestThresholdUnit()
{
  vtkNew<vtkHorizonDespiking> despiking;
  const HorizonFixtures::Errors warnings(despiking, vtkCommand::WarningEvent);
  despiking->SetInputDataObject(WithSpikes());
  despiking->SetThresholdUnitToWorld();
  const auto threshold = [&]()
  { return despiking->GetPolyDataOutput()->GetFieldData()->GetArray("SpikeThreshold")->GetTuple1(0); };
  for (const auto& [given, spikes] : { std::pair(27.0, 2), std::pair(29.0, 1), std::pair(49.0, 0) })
  {
    despiking->SetThreshold(given);
    despiking->Update();
    CHECK_EQUAL(despiking->GetNumberOfSpikes(), spikes);
    CHECK_EQUAL(threshold(), given / 4.0);
  }
  despiking->SetThreshold(29.0);
  despiking->Update();
  CHECK_EQUAL(std::string(despiking->GetResults()),
    "Horizon 3: 36 points in, 35 out\n  spikes 1\n  threshold of spikes 7.25 vertical indices, 29 in z\n"
    "  columns known 35, area 1.09e+04\n  columns left out 1, area 311.4\n  warning: 2.778 % of the points left out\n");
  CHECK(warnings.FirstContains(
    "Horizon 3: 2 of 36 points are spikes, expected at most 2 %: threshold 6.75 vertical indices"));
  CHECK_EQUAL(warnings.Count(), 3u);
}

void TestErrors()
{
  for (const double threshold : { -1.0, std::nan("") })
  {
    vtkNew<vtkHorizonDespiking> despiking;
    HorizonFixtures::Errors errors(despiking);
    despiking->SetInputDataObject(WithSpikes());
    despiking->SetThreshold(threshold);
    despiking->Update();
    CHECK(errors.FirstContains("at least 0"));
  }
}

/// Nothing to compare with is no spike; what is no place is refused.
void TestBadInput()
{
  for (const std::vector<std::string>& picture : { std::vector<std::string>{ "#" }, { "#.#", "...", "#.#" } })
  {
    auto input = FromPicture(picture, 3, HorizonFixtures::UnitSurvey());
    vtkNew<vtkHorizonDespiking> despiking;
    HorizonFixtures::Errors errors(despiking);
    despiking->SetInputDataObject(input);
    despiking->Update();
    CHECK_EQUAL(errors.Count(), 0u);
    CHECK_EQUAL(despiking->GetPolyDataOutput()->GetNumberOfPoints(), input->GetNumberOfPoints());
  }
  auto input = WithSpikes();
  input->GetPoints()->SetPoint(7, 0.0, 0.0, std::nan(""));
  vtkNew<vtkHorizonDespiking> despiking;
  HorizonFixtures::Errors errors(despiking);
  despiking->SetInputDataObject(input);
  despiking->Update();
  CHECK(errors.FirstContains("height nan, expected a place on the lattice"));
  CHECK_EQUAL(despiking->GetPolyDataOutput()->GetNumberOfPoints(), 0);
}

void TestPrint()
{
  vtkNew<vtkHorizonDespiking> despiking;
  despiking->SetActionToFlag();
  despiking->SetThreshold(2.5);
  despiking->SetThresholdUnitToWorld();
  despiking->SetNeighborhoodRadius(4);
  despiking->SetSpurWidth(6);
  std::ostringstream text;
  despiking->Print(text);
  for (const char* line : { "Action: Flag", "Threshold: 2.5", "ThresholdUnit: World", "NeighborhoodRadius: 4",
         "SpurWidth: 6", "NumberOfSpikes: 0", "NumberOfSpurPoints: 0" })
  {
    CHECK(text.str().find(line) != std::string::npos);
  }
}
}

int TestHorizonDespiking(int, char*[])
{
  TestRemove();
  TestFlag();
  TestSpurs();
  TestThresholdUnit();
  TestErrors();
  TestBadInput();
  TestPrint();
  return Check::Result();
}
