// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonFixtures.h"
#include "Tools/Check.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkHorizonContours.h"
#include "vtkHorizonSurface.h"
#include "vtkStringArray.h"

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace
{
/// A roof: vertical indices rise with i to the middle, and world z falls with them.
double Roof(int i, int)
{
  return 30.0 - std::abs(i - 5) * 2.0;
}

/// Depth in metres below z = 100, in a turned survey; steps of 8 between columns along i.
vtkSmartPointer<vtkPolyData> MakeRoof()
{
  auto horizon =
    HorizonFixtures::FromPicture(std::vector<std::string>(5, "###########"), 3, HorizonFixtures::RotatedSurvey(), Roof);
  vtkNew<vtkIntArray> direction;
  direction->SetName("VerticalDirection");
  direction->InsertNextValue(-1);
  horizon->GetFieldData()->AddArray(direction);
  vtkNew<vtkStringArray> unit;
  unit->SetName("VerticalUnit");
  unit->InsertNextValue("m");
  horizon->GetFieldData()->AddArray(unit);
  return horizon;
}

std::vector<std::string> LabelsOf(vtkPolyData* contours)
{
  auto* const labels = vtkStringArray::SafeDownCast(contours->GetCellData()->GetAbstractArray("Label"));
  std::vector<std::string> texts;
  for (vtkIdType n = 0; labels && n < labels->GetNumberOfValues(); ++n)
  {
    texts.push_back(labels->GetValue(n));
  }
  return texts;
}

/// Depths are from 20 in the middle to -20 at both sides, which are columns at a level.
void TestPoints()
{
  vtkNew<vtkHorizonContours> contours;
  contours->SetInputDataObject(MakeRoof());
  contours->SetInterval(10.0);
  contours->Update();
  vtkPolyData* const output = contours->GetPolyDataOutput();
  CHECK(LabelsOf(output) == std::vector<std::string>({ "10", "10", "0", "0", "-10", "-10", "-20", "-20" }));
  CHECK_EQUAL(output->GetNumberOfLines(), output->GetNumberOfCells());
  vtkDataArray* const levels = output->GetCellData()->GetArray("Level");
  vtkDataArray* const index = output->GetCellData()->GetArray("IndexContour");
  vtkDataArray* const heights = output->GetPointData()->GetArray("Depth (m)");
  CHECK(levels && index && heights);
  vtkNew<vtkIdList> line;
  for (vtkIdType n = 0; n < output->GetNumberOfLines(); ++n)
  {
    output->GetCellPoints(n, line);
    CHECK(line->GetNumberOfIds() >= 5);
    CHECK_EQUAL(index->GetTuple1(n), levels->GetTuple1(n) == 0.0 ? 1.0 : 0.0);
    for (vtkIdType place = 0; place < line->GetNumberOfIds(); ++place)
    {
      CHECK_EQUAL(-output->GetPoint(line->GetId(place))[2], levels->GetTuple1(n));
      CHECK_EQUAL(heights->GetTuple1(line->GetId(place)), levels->GetTuple1(n));
    }
  }
  CHECK_EQUAL(output->GetFieldData()->GetArray("ContourInterval")->GetTuple1(0), 10.0);
  CHECK(!output->GetFieldData()->HasArray("LedgerColumns"));
  CHECK(std::string(contours->GetResults()).find("\n  contours ") != std::string::npos);
  CHECK(std::string(contours->GetResults()).find("\n  interval 10 m\n") != std::string::npos);
}

/// By itself 40 m are a contour every 5 m; a mesh gives the same lines as its points, and a fault opens them.
void TestChosen()
{
  const auto input = MakeRoof();
  vtkNew<vtkHorizonContours> contours;
  contours->SetInputDataObject(input);
  contours->Update();
  CHECK_EQUAL(contours->GetPolyDataOutput()->GetFieldData()->GetArray("ContourInterval")->GetTuple1(0), 5.0);
  const std::vector<std::string> ofPoints = LabelsOf(contours->GetPolyDataOutput());
  vtkNew<vtkHorizonSurface> surface;
  surface->SetInputDataObject(input);
  contours->SetInputConnection(surface->GetOutputPort());
  contours->Update();
  CHECK(LabelsOf(contours->GetPolyDataOutput()) == ofPoints);
  vtkNew<vtkIntArray> links;
  links->SetName("FaultedLinks");
  links->SetNumberOfComponents(3);
  for (const int j : { 1, 2, 3 })
  {
    const int link[3] = { 2, j, 0 };
    links->InsertNextTypedTuple(link);
  }
  input->GetFieldData()->AddArray(links);
  contours->SetInputDataObject(input);
  contours->SetInterval(100.0);
  contours->Update();
  CHECK(LabelsOf(contours->GetPolyDataOutput()) == std::vector<std::string>({ "0" })); // of the other side of the roof
}

void TestErrors()
{
  vtkNew<vtkHorizonContours> contours;
  contours->SetInputDataObject(MakeRoof());
  for (const double interval : { -1.0, std::nan(""), 1e-4 })
  {
    HorizonFixtures::Errors errors(contours);
    contours->SetInterval(interval);
    contours->Update();
    CHECK(errors.FirstContains("Horizon 3: ") && errors.FirstContains("interval") && errors.FirstContains("expected"));
    CHECK_EQUAL(contours->GetPolyDataOutput()->GetNumberOfPoints(), 0);
  }
  const auto level =
    HorizonFixtures::FromPicture({ "###", "###" }, 3, HorizonFixtures::UnitSurvey(), [](int, int) { return 7.0; });
  contours->SetInputDataObject(level);
  contours->SetInterval(0.0);
  contours->Update();
  CHECK_EQUAL(contours->GetPolyDataOutput()->GetNumberOfLines(), 0);
}
}

int TestHorizonContours(int, char*[])
{
  TestPoints();
  TestChosen();
  TestErrors();
  return Check::Result();
}
