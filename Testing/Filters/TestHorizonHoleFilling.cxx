// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonFixtures.h"
#include "Tools/Check.h"

#include "vtkFloatArray.h"
#include "vtkHorizonExteriorBoundary.h"
#include "vtkHorizonHoleFilling.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkSMPTools.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace
{
using HorizonFixtures::FromPicture;

double Tilted(int i, int j)
{
  return 20.0 + 2 * i + j;
}

/// Three holes: of 1, 4 and 2 columns; points are numbered from the lowest row.
const std::vector<std::string> Picture = { "#########", "#########", "##.##..##", "#####..##", "#########", "###..####",
  "#########", "#########" };

vtkSmartPointer<vtkPolyData> WithHoles(vtkMatrix4x4* survey = HorizonFixtures::UnitSurvey())
{
  return FromPicture(Picture, 3, survey, Tilted);
}

double FieldNumber(vtkPolyData* horizon, const char* name)
{
  vtkDataArray* const array = horizon->GetFieldData()->GetArray(name);
  return array ? array->GetComponent(0, 0) : std::nan("");
}

double Value(vtkPolyData* horizon, const char* name, vtkIdType point)
{
  vtkDataArray* const array = horizon->GetPointData()->GetArray(name);
  return array ? array->GetComponent(point, 0) : std::nan("");
}

/// Adds arrays of several kinds to a horizon.
void AddArrays(vtkPolyData* horizon)
{
  const vtkIdType size = horizon->GetNumberOfPoints();
  vtkNew<vtkFloatArray> vectors;
  vectors->SetName("Vector");
  vectors->SetNumberOfComponents(2);
  vectors->SetNumberOfTuples(size);
  vtkNew<vtkStringArray> names;
  names->SetName("Picker");
  names->SetNumberOfTuples(size);
  vtkNew<vtkDoubleArray> realZ;
  realZ->SetName("RealZ");
  for (vtkIdType point = 0; point < size; ++point)
  {
    vectors->SetTuple2(point, Value(horizon, "Amplitude", point), point == 0 ? std::nan("") : 1.0);
    names->SetValue(point, "p" + std::to_string(point));
    realZ->InsertNextValue(1500.0 + 4.0 * Value(horizon, "VerticalIndex", point));
  }
  horizon->GetPointData()->AddArray(vectors);
  horizon->GetPointData()->AddArray(names);
  horizon->GetPointData()->AddArray(realZ);
  horizon->GetPointData()->SetActiveScalars("Amplitude");
}

void CheckKnownPoints(vtkPolyData* input, vtkPolyData* output)
{
  for (vtkIdType point = 0; point < input->GetNumberOfPoints(); ++point)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      CHECK_EQUAL(output->GetPoint(point)[axis], input->GetPoint(point)[axis]);
    }
    for (int n = 0; n < input->GetPointData()->GetNumberOfArrays(); ++n)
    {
      vtkAbstractArray* const before = input->GetPointData()->GetAbstractArray(n);
      vtkAbstractArray* const after = output->GetPointData()->GetAbstractArray(before->GetName());
      CHECK(after && after->GetDataType() == before->GetDataType());
      for (int component = 0; after && component < before->GetNumberOfComponents(); ++component)
      {
        const vtkIdType value = point * before->GetNumberOfComponents() + component;
        CHECK(before->GetVariantValue(value).ToString() == after->GetVariantValue(value).ToString());
      }
    }
    CHECK_EQUAL(Value(output, "Filled", point), 0.0);
    CHECK_EQUAL(Value(output, "PointCount", point), 1.0);
  }
}

/// On a plane everything about new points is known beforehand.
void TestNewPoints(vtkMatrix4x4* survey)
{
  auto input = WithHoles(survey);
  AddArrays(input);
  vtkNew<vtkHorizonHoleFilling> filling;
  filling->SetInputDataObject(input);
  filling->Update();
  vtkPolyData* const output = filling->GetPolyDataOutput();
  CHECK_EQUAL(output->GetNumberOfPoints(), 72);
  CHECK_EQUAL(output->GetNumberOfVerts(), 72);
  CHECK_EQUAL(output->GetNumberOfCells(), 72);
  CheckKnownPoints(input, output);
  const int columns[7][2] = { { 3, 2 }, { 4, 2 }, { 5, 4 }, { 6, 4 }, { 5, 5 }, { 6, 5 }, { 2, 5 } };
  for (vtkIdType n = 0; n < 7; ++n)
  {
    const vtkIdType point = 65 + n;
    const double k = Tilted(columns[n][0], columns[n][1]);
    const double place[4] = { double(columns[n][0]), double(columns[n][1]), k, 1.0 };
    double world[4];
    survey->MultiplyPoint(place, world);
    for (int axis = 0; axis < 3; ++axis)
    {
      CHECK(std::abs(output->GetPoint(point)[axis] - world[axis]) < 1e-6);
    }
    CHECK_EQUAL(Value(output, "Filled", point), 1.0);
    CHECK_EQUAL(Value(output, "PointCount", point), 0.0);
    CHECK_EQUAL(Value(output, "SurfaceId", point), 3.0);
    CHECK_EQUAL(Value(output, "VerticalIndex", point), k);
    CHECK(std::abs(Value(output, "RealZ", point) - (1500.0 + 4.0 * k)) < 1e-6);
    CHECK(std::abs(Value(output, "Amplitude", point) - (place[0] + 100.0 * place[1])) < 1e-6);
    CHECK(std::abs(Value(output, "Vector", point) - (place[0] + 100.0 * place[1])) < 1e-3);
  }
  auto* const names = vtkStringArray::SafeDownCast(output->GetPointData()->GetAbstractArray("Picker"));
  CHECK(names && names->GetValue(65) == "p12"); // below the first new point, before the one to the left
  CHECK(output->GetPointData()->GetArray("Filled")->GetDataType() == VTK_UNSIGNED_CHAR);
  CHECK(output->GetPointData()->GetScalars() == output->GetPointData()->GetArray("Amplitude"));
  CHECK_EQUAL(FieldNumber(output, "NumberOfFilledHoles"), 3.0);
  CHECK_EQUAL(FieldNumber(output, "NumberOfFilledPoints"), 7.0);
  CHECK_EQUAL(FieldNumber(output, "NumberOfOpenHoles"), 0.0);
  CHECK(output->GetFieldData()->GetArray("LatticeToWorld") != nullptr);
}

void TestLimitsAndAttributes()
{
  vtkNew<vtkHorizonHoleFilling> filling;
  filling->SetInputDataObject(WithHoles(HorizonFixtures::RotatedSurvey())); // 311.405 square metres a column
  for (const auto& [size, area, points] : { std::tuple<vtkIdType, double, vtkIdType>(1, 0.0, 1), { 2, 0.0, 3 },
         { 4, 0.0, 7 }, { 4, 622.81, 3 }, { 4, 622.0, 1 }, { 1, 1e300, 1 }, { 9, 300.0, 0 } })
  {
    filling->SetLargestHoleSize(size);
    filling->SetLargestHoleArea(area);
    filling->Update();
    CHECK_EQUAL(filling->GetNumberOfFilledPoints(), points);
    CHECK_EQUAL(filling->GetNumberOfFilledHoles() + filling->GetNumberOfOpenHoles(), 3);
    CHECK_EQUAL(FieldNumber(filling->GetPolyDataOutput(), "NumberOfFilledPoints"), double(points));
  }
  filling->SetLargestHoleSize(9);
  filling->SetLargestHoleArea(0.0);
  filling->SetAttributesToNotANumber();
  filling->SetMethodToMembrane();
  filling->Update();
  vtkPolyData* const output = filling->GetPolyDataOutput();
  for (vtkIdType point = 65; point < 72; ++point)
  {
    CHECK(std::isnan(Value(output, "Amplitude", point)));
    CHECK_EQUAL(Value(output, "SurfaceId", point), 3.0);
    CHECK(std::isfinite(Value(output, "VerticalIndex", point)) && std::isfinite(output->GetPoint(point)[2]));
  }
}

/// Filled again, new points are known, and still say that they are new; an outline before is forgotten.
void TestTwice()
{
  vtkNew<vtkHorizonHoleFilling> some;
  vtkNew<vtkHorizonExteriorBoundary> outline;
  vtkNew<vtkHorizonHoleFilling> all;
  some->SetInputDataObject(WithHoles());
  some->SetLargestHoleSize(1);
  outline->SetInputConnection(some->GetOutputPort());
  all->SetInputConnection(outline->GetOutputPort());
  all->Update();
  vtkPolyData* const output = all->GetPolyDataOutput();
  CHECK_EQUAL(output->GetNumberOfPoints(), 72);
  CHECK_EQUAL(output->GetNumberOfLines(), 0);
  CHECK(!output->GetPointData()->HasArray("PatchId") && !output->GetPointData()->HasArray("Boundary"));
  double filled = 0.0;
  double counts = 0.0;
  for (vtkIdType point = 0; point < 72; ++point)
  {
    filled += Value(output, "Filled", point);
    counts += Value(output, "PointCount", point);
  }
  CHECK_EQUAL(filled, 7.0);
  CHECK_EQUAL(counts, 65.0);
}

/// A hole of 4 x 2 columns with 10 on its left and 50 on its right, and a fault along its middle.
vtkSmartPointer<vtkPolyData> WithFault(const std::vector<std::array<int, 3>>& links)
{
  auto horizon = FromPicture({ "########", "########", "##....##", "##....##", "########", "########" }, 3,
    HorizonFixtures::UnitSurvey(), [](int i, int) { return i < 4 ? 10.0 : 50.0; });
  vtkNew<vtkIntArray> cuts;
  cuts->SetName("FaultedLinks");
  cuts->SetNumberOfComponents(3);
  for (const std::array<int, 3>& link : links)
  {
    cuts->InsertNextTypedTuple(link.data());
  }
  horizon->GetFieldData()->AddArray(cuts);
  return horizon;
}

/// Each side of a fault is filled alone, and the cuts go on to the next stage.
void TestCuts()
{
  std::vector<std::array<int, 3>> links;
  for (int j = 0; j < 6; ++j)
  {
    links.push_back({ 3, j, 0 });
  }
  for (const auto method : { vtkHorizonHoleFilling::Plate, vtkHorizonHoleFilling::Membrane })
  {
    vtkNew<vtkHorizonHoleFilling> filling;
    filling->SetMethod(method);
    filling->SetInputDataObject(WithFault(links));
    filling->Update();
    vtkPolyData* const output = filling->GetPolyDataOutput();
    CHECK_EQUAL(filling->GetNumberOfFilledPoints(), 8);
    for (vtkIdType point = 40; point < output->GetNumberOfPoints(); ++point)
    {
      const double* const place = output->GetPoint(point);
      CHECK(std::abs(place[2] - (place[0] < 4.0 ? 10.0 : 50.0)) < 1e-6);
    }
    vtkDataArray* const kept = output->GetFieldData()->GetArray("FaultedLinks");
    CHECK(kept && kept->GetNumberOfTuples() == 6);
    // Without cuts the two sides are joined.
    filling->SetInputDataObject(WithFault({}));
    filling->Update();
    CHECK(std::abs(filling->GetPolyDataOutput()->GetPoint(41)[2] - 10.0) > 1.0);
  }
  for (const auto& [link, text] : { std::pair<std::array<int, 3>, std::string>({ 8, 0, 0 }, "(8, 0, 0)"),
         { { 0, 6, 0 }, "(0, 6, 0)" }, { { 0, -1, 0 }, "(0, -1, 0)" }, { { 7, 5, 2 }, "(7, 5, 2)" } })
  {
    vtkNew<vtkHorizonHoleFilling> filling;
    HorizonFixtures::Errors errors(filling);
    filling->SetInputDataObject(WithFault({ { 7, 5, 1 }, link }));
    filling->Update();
    CHECK(errors.FirstContains(
      "faulted link 1 " + text + ", expected a column of the lattice, i from 0 to 7 and j from 0 to 5"));
  }
  vtkNew<vtkHorizonHoleFilling> filling;
  HorizonFixtures::Errors errors(filling);
  auto horizon = WithFault({ { 7, 5, 1 } });
  horizon->GetFieldData()->GetArray("FaultedLinks")->SetNumberOfComponents(1);
  filling->SetInputDataObject(horizon);
  filling->Update();
  CHECK(errors.FirstContains("field data array FaultedLinks with 1 components, expected 3: i, j and the side"));
}

/// Nothing known, or next to nothing: there is no hole, and nothing comes out that was not there.
void TestNothingToFill()
{
  for (const std::vector<std::string>& picture :
    { std::vector<std::string>{ "#" }, { "###", "###" }, { "#..", "...", "..#" }, { "###", "#.#", "#.#" } })
  {
    auto input = FromPicture(picture, 3, HorizonFixtures::UnitSurvey());
    vtkNew<vtkHorizonHoleFilling> filling;
    HorizonFixtures::Errors errors(filling);
    filling->SetInputDataObject(input);
    filling->Update();
    vtkPolyData* const output = filling->GetPolyDataOutput();
    CHECK_EQUAL(errors.Count(), 0u);
    CHECK_EQUAL(output->GetNumberOfPoints(), input->GetNumberOfPoints());
    CHECK_EQUAL(FieldNumber(output, "NumberOfFilledHoles") + FieldNumber(output, "NumberOfOpenHoles"), 0.0);
    CHECK_EQUAL(Value(output, "Filled", 0), 0.0);
  }
}

/// Several horizons; the figures are those of all.
void TestBlocks()
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, WithHoles());
  blocks->SetBlock(1, FromPicture({ "###", "#.#", "###" }, 4, HorizonFixtures::UnitSurvey()));
  blocks->SetBlock(2, vtkSmartPointer<vtkPolyData>::New());
  blocks->SetBlock(3, FromPicture({ "#" }, 5, HorizonFixtures::UnitSurvey()));
  vtkNew<vtkHorizonHoleFilling> filling;
  filling->SetInputDataObject(blocks);
  for (int run = 0; run < 2; ++run)
  {
    filling->Modified();
    filling->Update();
    CHECK_EQUAL(filling->GetNumberOfFilledHoles(), 4);
    CHECK_EQUAL(filling->GetNumberOfFilledPoints(), 8);
    CHECK_EQUAL(filling->GetNumberOfOpenHoles(), 0);
  }
  auto* const output = vtkMultiBlockDataSet::SafeDownCast(filling->GetOutputDataObject(0));
  CHECK_EQUAL(vtkPolyData::SafeDownCast(output->GetBlock(1))->GetNumberOfPoints(), 9);
  CHECK_EQUAL(vtkPolyData::SafeDownCast(output->GetBlock(3))->GetNumberOfPoints(), 1);
}

void TestErrors()
{
  vtkNew<vtkHorizonHoleFilling> filling;
  auto input = WithHoles();
  input->GetPoints()->SetPoint(7, 7.0, 0.0, std::nan(""));
  HorizonFixtures::Errors errors(filling);
  filling->SetInputDataObject(input);
  filling->Update();
  CHECK_EQUAL(errors.Count(), 1u);
  CHECK(errors.FirstContains("Horizon 3: point 7 at column (nan, nan), height nan, expected a place on the lattice"));
  CHECK_EQUAL(filling->GetPolyDataOutput()->GetNumberOfPoints(), 0);
  CHECK_EQUAL(filling->GetNumberOfFilledHoles(), 0);
}

/// The plate that was chosen is told, also in the panel; one that is given is not.
void TestAutomatic()
{
  vtkNew<vtkHorizonHoleFilling> filling;
  CHECK_EQUAL(filling->GetMethod(), vtkHorizonHoleFilling::Automatic);
  filling->SetInputDataObject(WithHoles());
  filling->Update();
  vtkFieldData* const figures = filling->GetPolyDataOutput()->GetFieldData();
  CHECK_EQUAL(figures->GetArray("RimSmoothing")->GetTuple1(0), 0.0); // a plane
  CHECK_EQUAL(figures->GetArray("RimWidth")->GetTuple1(0), 3.0);
  CHECK(std::string(filling->GetResults()).find("rim smoothing 0\n  rim width 3 columns\n") != std::string::npos);
  filling->SetMethodToPlate();
  filling->Update();
  CHECK(!filling->GetPolyDataOutput()->GetFieldData()->HasArray("RimSmoothing"));
}

/// The bay of a patch at the edge of the survey, and its hole, apart by their marks; columns off the survey are none.
void TestExtrapolation()
{
  vtkNew<vtkHorizonHoleFilling> filling;
  filling->SetInputDataObject(HorizonFixtures::FromPicture(
    { "#######", "###.###", "#######", "###....", "#######" }, 3, HorizonFixtures::RotatedSurvey()));
  filling->SetExtrapolationDistance(2);
  filling->Update();
  vtkPolyData* const output = filling->GetPolyDataOutput();
  const vtkIdType known = 30;
  CHECK_EQUAL(output->GetNumberOfPoints(), 35);
  vtkDataArray* const filled = output->GetPointData()->GetArray("Filled");
  for (vtkIdType point = 0; point < output->GetNumberOfPoints(); ++point)
  {
    CHECK_EQUAL(filled->GetTuple1(point), point < known ? 0.0 : point == known ? 1.0 : 2.0);
  }
  CHECK_EQUAL(filling->GetNumberOfFilledHoles(), 1);
  CHECK_EQUAL(filling->GetNumberOfFilledPoints(), 5);
  filling->SetExtrapolationDistance(-1);
  HorizonFixtures::Errors errors(filling);
  filling->Update();
  CHECK(errors.FirstContains("extrapolation distance -1, expected 0 to 10000 columns"));
}

void TestPrint()
{
  vtkNew<vtkHorizonHoleFilling> filling;
  filling->SetLargestHoleSize(7);
  filling->SetLargestHoleArea(12.5);
  filling->SetMethodToMembrane();
  filling->SetRimSmoothing(0.25);
  filling->SetRimWidth(9);
  filling->SetExtrapolationDistance(6);
  filling->SetAttributesToNotANumber();
  std::ostringstream text;
  filling->Print(text);
  for (const char* line : { "LargestHoleSize: 7", "LargestHoleArea: 12.5", "Method: Membrane", "RimSmoothing: 0.25",
         "RimWidth: 9", "ExtrapolationDistance: 6", "Attributes: NotANumber", "NumberOfFilledHoles: 0",
         "NumberOfFilledPoints: 0", "NumberOfOpenHoles: 0" })
  {
    CHECK(text.str().find(line) != std::string::npos);
  }
}
}

int TestHorizonHoleFilling(int, char*[])
{
  TestNewPoints(HorizonFixtures::UnitSurvey());
  TestNewPoints(HorizonFixtures::RotatedSurvey());
  TestLimitsAndAttributes();
  TestTwice();
  TestCuts();
  TestNothingToFill();
  TestBlocks();
  TestErrors();
  TestAutomatic();
  TestExtrapolation();
  TestPrint();
  return Check::Result();
}
