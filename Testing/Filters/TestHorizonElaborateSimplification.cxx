// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonFixtures.h"
#include "Tools/Check.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkHorizonElaborateSimplification.h"
#include "vtkHorizonExteriorBoundary.h"
#include "vtkHorizonRoughSimplification.h"
#include "vtkHorizonTriangulation.h"
#include "vtkMath.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace
{
double Slope(int i, int j)
{
  return i + 2 * j;
}

double Fold(int i, int j)
{
  return std::round(10.0 + 6.0 * std::sin(0.1 * i) * std::cos(0.07 * j));
}

vtkSmartPointer<vtkPolyData> Bounded(int size, vtkMatrix4x4* survey, double (*height)(int, int))
{
  vtkNew<vtkHorizonExteriorBoundary> boundary;
  boundary->SetInputDataObject(HorizonFixtures::FromPicture(HorizonFixtures::Rectangle(size, size), 5, survey, height));
  boundary->Update();
  return boundary->GetPolyDataOutput();
}

/// 24 by 24 in cells of 8: the middle cell, the only one of the second ring, becomes its middle, (11.5, 11.5).
void TestAttributes(vtkMatrix4x4* survey)
{
  vtkNew<vtkHorizonElaborateSimplification> elaborate;
  elaborate->SetInputDataObject(Bounded(24, survey, [](int, int) { return 5.0; }));
  elaborate->Update();
  vtkPolyData* const output = elaborate->GetPolyDataOutput();
  CHECK_EQUAL(output->GetNumberOfPoints(), 92 + 9);
  CHECK_EQUAL(output->GetNumberOfVerts(), 92 + 9);
  CHECK_EQUAL(output->GetNumberOfLines(), 1);
  vtkPointData* const data = output->GetPointData();
  vtkDataArray* const origin = data->GetArray("CellOrigin");
  CHECK_EQUAL(origin->GetDataType(), VTK_INT);
  CHECK_EQUAL(std::string(origin->GetComponentName(0)), "Level");
  CHECK_EQUAL(std::string(origin->GetComponentName(1)), "Ring");
  CHECK_EQUAL(std::string(origin->GetComponentName(2)), "Kind");
  CHECK_EQUAL(origin->GetComponent(0, 2), 0.0);
  const vtkIdType middle = 92 + 4;
  CHECK_EQUAL(origin->GetComponent(middle, 0), 0.0);
  CHECK_EQUAL(origin->GetComponent(middle, 1), 2.0);
  CHECK_EQUAL(origin->GetComponent(middle, 2), 1.0);
  CHECK_EQUAL(data->GetArray("PointCount")->GetTuple1(middle), 64.0);
  CHECK_EQUAL(data->GetArray("Flatness")->GetDataType(), VTK_DOUBLE);
  CHECK_EQUAL(data->GetArray("Flatness")->GetTuple1(middle), 0.0);
  CHECK_EQUAL(data->GetArray("VerticalIndex")->GetDataType(), VTK_DOUBLE);
  CHECK_EQUAL(data->GetArray("Amplitude")->GetTuple1(middle), 11.5 + 1150.0);
  CHECK_EQUAL(data->GetArray("SurfaceId")->GetTuple1(middle), 5.0);
  const double place[4] = { 11.5, 11.5, 5, 1 };
  double world[4];
  survey->MultiplyPoint(place, world);
  for (int axis = 0; axis < 3; ++axis)
  {
    CHECK(std::abs(output->GetPoint(middle)[axis] - world[axis]) < 1e-6);
  }
}

/// Every property reaches the method: each of these values changes the number of points.
void TestPropertiesCount()
{
  auto input = Bounded(60, HorizonFixtures::UnitSurvey(), Fold);
  const auto points = [&](void (*change)(vtkHorizonElaborateSimplification*))
  {
    vtkNew<vtkHorizonElaborateSimplification> elaborate;
    elaborate->SetInputDataObject(input);
    elaborate->SetFlatnessThreshold(0.03);
    change(elaborate);
    elaborate->Update();
    return elaborate->GetPolyDataOutput()->GetNumberOfPoints();
  };
  using Filter = vtkHorizonElaborateSimplification*;
  const vtkIdType usual = points([](Filter) {});
  CHECK(points([](Filter filter) { filter->SetCellSize(16); }) < usual);
  CHECK(points([](Filter filter) { filter->SetFlatnessThreshold(0.0); }) > usual);
  CHECK(points([](Filter filter) { filter->SetBoundaryDensityThreshold(3.0); }) > usual);
  CHECK(points([](Filter filter) { filter->SetBoundaryExtentThreshold(100.0); }) > usual);
  CHECK(points([](Filter filter) { filter->SetBoundaryCellSizeThreshold(100.0); }) < usual);
  CHECK(points([](Filter filter) { filter->SetSmallestCellSize(4.0); }) < usual);
  CHECK(points([](Filter filter) { filter->SetNeighbourMeanToOverPieces(); }) > usual);
  const auto sparse = [](Filter filter) { filter->SetBoundaryDensityThreshold(3.0); };
  const auto growing = [](Filter filter)
  {
    filter->SetBoundaryDensityThreshold(3.0);
    filter->SetGrowthPerRing(2.0);
  };
  CHECK(points(growing) < points(sparse));
}

void TestNearestPoint()
{
  auto input = Bounded(40, HorizonFixtures::RotatedSurvey(), Slope);
  vtkNew<vtkHorizonElaborateSimplification> elaborate;
  elaborate->SetInputDataObject(input);
  elaborate->SetRepresentativeToNearestPoint();
  elaborate->Update();
  vtkPolyData* const output = elaborate->GetPolyDataOutput();
  for (vtkIdType point = 0; point < output->GetNumberOfPoints(); ++point)
  {
    double place[3];
    output->GetPoint(point, place);
    double nearest[3];
    input->GetPoint(input->FindPoint(place), nearest);
    CHECK(std::equal(place, place + 3, nearest));
    const double kind = output->GetPointData()->GetArray("CellOrigin")->GetComponent(point, 2);
    CHECK(kind == 0.0 || kind == 2.0);
  }
}

void TestShowCells()
{
  vtkNew<vtkHorizonElaborateSimplification> elaborate;
  const auto bump = [](int i, int j) { return i == 12 && j == 12 ? 6.0 : 5.0; };
  elaborate->SetInputDataObject(Bounded(24, HorizonFixtures::UnitSurvey(), bump));
  elaborate->ShowCellsOn();
  elaborate->Update();
  vtkPolyData* const boxes = elaborate->GetPolyDataOutput();
  CHECK_EQUAL(boxes->GetNumberOfLines(), 9);
  CHECK_EQUAL(boxes->GetNumberOfPoints(), 72);
  const double bounds[6] = { 0, 24, 0, 24, 5, 13 };
  CHECK(std::equal(bounds, bounds + 6, boxes->GetBounds()));
  CHECK_EQUAL(boxes->GetCellData()->GetArray("CellSize")->GetTuple1(4), 8.0);
  CHECK_EQUAL(boxes->GetCellData()->GetArray("PointCount")->GetTuple1(4), 64.0);
  CHECK_EQUAL(boxes->GetCellData()->GetArray("PatchId")->GetTuple1(4), 0.0);
  CHECK_EQUAL(boxes->GetCellData()->GetArray("CellOrigin")->GetComponent(4, 1), 2.0);
  CHECK_EQUAL(boxes->GetCellData()->GetArray("Flatness")->GetTuple1(3), 0.0);
  CHECK(boxes->GetCellData()->GetArray("Flatness")->GetTuple1(4) > 0.001);
  // Each of the twelve edges of a box is walked, and nothing else.
  vtkIdType size = 0;
  const vtkIdType* corners = nullptr;
  boxes->GetLines()->GetCellAtId(4, size, corners);
  std::vector<std::pair<vtkIdType, vtkIdType>> edges;
  for (vtkIdType n = 1; n < size; ++n)
  {
    edges.emplace_back(std::minmax(corners[n - 1], corners[n]));
    double a[3];
    double b[3];
    boxes->GetPoint(corners[n - 1], a);
    boxes->GetPoint(corners[n], b);
    CHECK_EQUAL(vtkMath::Distance2BetweenPoints(a, b), 64.0);
  }
  std::sort(edges.begin(), edges.end());
  CHECK_EQUAL(std::unique(edges.begin(), edges.end()) - edges.begin(), 12);

  vtkNew<vtkHorizonTriangulation> mesh;
  mesh->SetInputData(boxes);
  HorizonFixtures::Errors errors(mesh);
  mesh->Update();
  CHECK(errors.FirstContains("cells of a simplification (ShowCells), expected its points"));

  vtkNew<vtkHorizonRoughSimplification> rough;
  rough->SetInputDataObject(Bounded(9, HorizonFixtures::UnitSurvey(), Slope));
  rough->SetShowCells(true);
  rough->Update();
  CHECK_EQUAL(rough->GetPolyDataOutput()->GetNumberOfLines(), 9);
  CHECK(!rough->GetPolyDataOutput()->GetCellData()->HasArray("Flatness"));
  CHECK_EQUAL(rough->GetPolyDataOutput()->GetPoint(4 * 4)[2], 12.0);
}

bool AreSame(vtkPolyData* a, vtkPolyData* b)
{
  const auto same = [](vtkDataArray* x, vtkDataArray* y)
  {
    return x->GetNumberOfValues() == y->GetNumberOfValues() &&
      !std::memcmp(x->GetVoidPointer(0), y->GetVoidPointer(0),
        std::size_t(x->GetNumberOfValues()) * std::size_t(x->GetDataTypeSize()));
  };
  bool result = same(a->GetPoints()->GetData(), b->GetPoints()->GetData());
  for (int n = 0; n < a->GetPointData()->GetNumberOfArrays(); ++n)
  {
    result = result && same(a->GetPointData()->GetArray(n), b->GetPointData()->GetArray(n));
  }
  return result;
}

/// The same bytes from every back-end, for any number of threads.
void TestThreads()
{
  auto input = Bounded(300, HorizonFixtures::RotatedSurvey(), Fold);
  const auto run = [&](const char* backend, int threads)
  {
    vtkSMPTools::SetBackend(backend); // a VTK built without it warns, and keeps the one it has
    vtkSMPTools::Initialize(threads);
    vtkNew<vtkHorizonRoughSimplification> rough;
    rough->SetInputDataObject(input);
    vtkNew<vtkHorizonElaborateSimplification> elaborate;
    elaborate->SetInputDataObject(input);
    elaborate->SetFlatnessThreshold(0.002);
    vtkNew<vtkHorizonElaborateSimplification> second;
    second->SetInputConnection(rough->GetOutputPort());
    second->Update();
    elaborate->Update();
    return std::vector<vtkSmartPointer<vtkPolyData>>{ rough->GetPolyDataOutput(), elaborate->GetPolyDataOutput(),
      second->GetPolyDataOutput() };
  };
  const std::string usual = vtkSMPTools::GetBackend();
  const auto expected = run("Sequential", 1);
  for (const int threads : { 1, 2, 8 })
  {
    const auto found = run("STDThread", threads);
    for (std::size_t n = 0; n < expected.size(); ++n)
    {
      CHECK(AreSame(expected[n], found[n]));
    }
  }
  vtkSMPTools::SetBackend(usual.c_str());
  vtkSMPTools::Initialize(0);
}

void CheckRefused(void (*change)(vtkHorizonElaborateSimplification*), const std::string& message)
{
  vtkNew<vtkHorizonElaborateSimplification> elaborate;
  HorizonFixtures::Errors errors(elaborate);
  elaborate->SetInputDataObject(Bounded(5, HorizonFixtures::UnitSurvey(), Slope));
  change(elaborate);
  elaborate->Update();
  CHECK_EQUAL(errors.Count(), 1u);
  CHECK(errors.FirstContains("Horizon 5: " + message));
  CHECK_EQUAL(elaborate->GetPolyDataOutput()->GetNumberOfPoints(), 0);
}

void TestErrors()
{
  using Filter = vtkHorizonElaborateSimplification*;
  CheckRefused([](Filter filter) { filter->SetCellSize(0); }, "cell size 0, expected at least 1");
  CheckRefused([](Filter filter) { filter->SetFlatnessThreshold(-1); }, "flatness threshold -1, expected at least 0");
  CheckRefused([](Filter filter) { filter->SetGrowthPerRing(0.5); }, "growth per ring 0.5, expected at least 1");
}

void TestPrint()
{
  vtkNew<vtkHorizonElaborateSimplification> elaborate;
  CHECK_EQUAL(elaborate->GetCellSize(), 8);
  elaborate->SetCellSize(17);
  elaborate->SetFlatnessThreshold(0.5);
  elaborate->SetBoundaryDensityThreshold(1.5);
  elaborate->SetBoundaryExtentThreshold(2.5);
  elaborate->SetBoundaryCellSizeThreshold(3.5);
  elaborate->SetGrowthPerRing(4.5);
  elaborate->SetSmallestCellSize(5.5);
  elaborate->SetNeighbourMean(3); // clamped
  elaborate->SetRepresentative(7); // clamped
  std::ostringstream text;
  elaborate->Print(text);
  for (const char* line : { "CellSize: 17", "FlatnessThreshold: 0.5", "BoundaryDensityThreshold: 1.5",
         "BoundaryExtentThreshold: 2.5", "BoundaryCellSizeThreshold: 3.5", "GrowthPerRing: 4.5",
         "SmallestCellSize: 5.5", "NeighbourMean: OverPieces", "Representative: NearestPoint", "ShowCells: off" })
  {
    CHECK(text.str().find(line) != std::string::npos);
  }
}
}

int TestHorizonElaborateSimplification(int, char*[])
{
  TestAttributes(HorizonFixtures::UnitSurvey());
  TestAttributes(HorizonFixtures::RotatedSurvey());
  TestPropertiesCount();
  TestNearestPoint();
  TestShowCells();
  TestThreads();
  TestErrors();
  TestPrint();
  return Check::Result();
}
