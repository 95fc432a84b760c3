// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The array Column: which stages give it, and that none believes one that does not fit its points.

#include "HorizonFixtures.h"
#include "Tools/Check.h"
#include "vtkHorizonBoundarySimplification.h"
#include "vtkHorizonDecimation.h"
#include "vtkHorizonDespiking.h"
#include "vtkHorizonElaborateSimplification.h"
#include "vtkHorizonExteriorBoundary.h"
#include "vtkHorizonFaults.h"
#include "vtkHorizonHoleFilling.h"
#include "vtkHorizonRoughSimplification.h"
#include "vtkHorizonSurface.h"
#include "vtkHorizonTriangulation.h"

#include "vtkAppendPolyData.h"

#include <array>
#include <cmath>
#include <string>
#include <vector>

using HorizonFixtures::RotatedSurvey;

namespace
{
const std::vector<std::string> Rows = { "..########..", ".##########.", "############", "#####..#####", "#####..#####",
  "############", ".##########.", "..########.." };

/// The column of a point by the map of its lattice.
std::array<double, 3> PlaceOf(vtkPolyData* horizon, vtkIdType point)
{
  vtkNew<vtkMatrix4x4> toLattice;
  for (int n = 0; n < 16; ++n)
  {
    toLattice->SetElement(n / 4, n % 4, horizon->GetFieldData()->GetArray("LatticeToWorld")->GetComponent(0, n));
  }
  toLattice->Invert();
  double place[4] = { 0, 0, 0, 1 };
  horizon->GetPoint(point, place);
  toLattice->MultiplyPoint(place, place);
  return { place[0], place[1], place[2] };
}

/// How many points have the column that they stand on, how many none (-1, -1), and how many another one.
struct ColumnCount
{
  int Right = 0;
  int None = 0;
  int Wrong = 0;
};

ColumnCount Count(vtkPolyData* horizon)
{
  ColumnCount count;
  auto* const columns = vtkIntArray::SafeDownCast(horizon->GetPointData()->GetAbstractArray("Column"));
  if (!CHECK(columns && columns->GetNumberOfComponents() == 2) ||
    !CHECK_EQUAL(columns->GetNumberOfTuples(), horizon->GetNumberOfPoints()))
  {
    return count;
  }
  for (vtkIdType point = 0; point < horizon->GetNumberOfPoints(); ++point)
  {
    const int i = columns->GetTypedComponent(point, 0);
    const int j = columns->GetTypedComponent(point, 1);
    const std::array<double, 3> place = PlaceOf(horizon, point);
    const bool isRight = std::abs(place[0] - i) < 0.25 && std::abs(place[1] - j) < 0.25;
    ++(i == -1 && j == -1 ? count.None : isRight ? count.Right : count.Wrong);
  }
  return count;
}

template <typename Stage>
vtkSmartPointer<vtkPolyData> Run(vtkPolyData* input)
{
  vtkNew<Stage> stage;
  stage->SetInputData(input);
  stage->Update();
  return stage->GetPolyDataOutput();
}

template <typename Stage>
std::string Refuse(vtkPolyData* input)
{
  vtkNew<Stage> stage;
  const HorizonFixtures::Errors errors(stage);
  stage->SetInputData(input);
  stage->Update();
  CHECK_EQUAL(stage->GetPolyDataOutput()->GetNumberOfPoints(), 0);
  CHECK_EQUAL(errors.Count(), 1u);
  return errors.First();
}

vtkSmartPointer<vtkPolyData> Horizon()
{
  return HorizonFixtures::FromPicture(Rows, 3, RotatedSurvey());
}

/// Moves points by steps of the rotated survey, and leaves all else, as Transform does.
vtkSmartPointer<vtkPolyData> Shift(vtkPolyData* horizon, double i, double j)
{
  auto moved = vtkSmartPointer<vtkPolyData>::New();
  moved->ShallowCopy(horizon);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->DeepCopy(horizon->GetPoints());
  for (vtkIdType point = 0; point < points->GetNumberOfPoints(); ++point)
  {
    double place[3];
    points->GetPoint(point, place);
    points->SetPoint(point, place[0] + 10.8 * i - 12.5 * j, place[1] + 6.25 * i + 21.6 * j, place[2]);
  }
  moved->SetPoints(points);
  return moved;
}

/// All but one is on its column; a stage that merges leaves points without.
void CheckChain(vtkPolyData* input)
{
  const auto all = [](vtkPolyData* horizon)
  {
    const ColumnCount count = Count(horizon);
    CHECK_EQUAL(count.Right, int(horizon->GetNumberOfPoints()));
    return horizon;
  };
  all(Run<vtkHorizonDespiking>(input));
  all(Run<vtkHorizonFaults>(input));
  const auto filled = Run<vtkHorizonHoleFilling>(input);
  CHECK_EQUAL(filled->GetNumberOfPoints(), input->GetNumberOfPoints() + 4);
  all(filled);
  all(Run<vtkHorizonSurface>(input));
  const auto outlines = Run<vtkHorizonExteriorBoundary>(input);
  const auto straight = Run<vtkHorizonBoundarySimplification>(all(outlines));
  all(Run<vtkHorizonDecimation>(all(straight)));
  all(Run<vtkHorizonTriangulation>(straight));
  for (const auto& merged :
    { Run<vtkHorizonRoughSimplification>(straight), Run<vtkHorizonElaborateSimplification>(straight) })
  {
    const ColumnCount count = Count(merged);
    CHECK(count.Right > 0 && count.None > 0 && count.Wrong == 0);
    const ColumnCount meshed = Count(Run<vtkHorizonTriangulation>(merged));
    CHECK(meshed.Right == count.Right && meshed.None == count.None);
  }
}

void TestStages()
{
  const auto input = Horizon();
  CheckChain(input);
  CHECK(!input->GetPointData()->HasArray("Column"));
  // Found once: the stages after the first one have it, and what it told.
  const auto outlines = Run<vtkHorizonExteriorBoundary>(input);
  vtkDataArray* const deviation = outlines->GetFieldData()->GetArray("LatticeDeviation");
  CHECK(deviation && deviation->GetComponent(0, 0) < 1e-6);
  CHECK(Run<vtkHorizonSurface>(input)->GetFieldData()->HasArray("LatticeDeviation"));
  CHECK(Run<vtkHorizonFaults>(input)->GetFieldData()->HasArray("LatticeDeviation"));
  const auto moved = Shift(outlines, 1e-3, 0);
  moved->GetPointData()->RemoveArray("Column");
  const double later =
    Run<vtkHorizonTriangulation>(moved)->GetFieldData()->GetArray("LatticeDeviation")->GetComponent(0, 0);
  CHECK(later > 0.9e-3 && later < 1.1e-3);
  CheckChain(Run<vtkHorizonFaults>(input));
}

/// In UTM metres, floats are rounded by a quarter of a metre.
void TestSinglePrecision()
{
  const auto input = Horizon();
  vtkNew<vtkPoints> floats;
  floats->SetDataTypeToFloat();
  floats->DeepCopy(input->GetPoints());
  CHECK_EQUAL(floats->GetDataType(), VTK_FLOAT);
  input->SetPoints(floats);
  CheckChain(input);
  CHECK_EQUAL(Run<vtkHorizonSurface>(input)->GetNumberOfPolys(), Run<vtkHorizonSurface>(Horizon())->GetNumberOfPolys());
  CHECK_EQUAL(Run<vtkHorizonSurface>(input)->GetPoints()->GetDataType(), VTK_DOUBLE);
  const double deviation =
    Run<vtkHorizonExteriorBoundary>(input)->GetFieldData()->GetArray("LatticeDeviation")->GetComponent(0, 0);
  CHECK(deviation > 1e-4 && deviation < 0.05);

  const auto far = HorizonFixtures::FromPicture(Rows, 3, HorizonFixtures::UnitSurvey());
  vtkNew<vtkPoints> lost;
  lost->SetDataTypeToFloat();
  lost->DeepCopy(far->GetPoints());
  far->SetPoints(lost);
  vtkDataArray* const map = far->GetFieldData()->GetArray("LatticeToWorld");
  map->SetComponent(0, 3, 6e6);
  for (vtkIdType point = 0; point < far->GetNumberOfPoints(); ++point)
  {
    double place[3];
    far->GetPoint(point, place);
    lost->SetPoint(point, place[0] + 6e6, place[1], place[2]);
  }
  for (const std::string& error : { Refuse<vtkHorizonSurface>(far), Refuse<vtkHorizonExteriorBoundary>(far),
         Refuse<vtkHorizonDespiking>(far), Refuse<vtkHorizonFaults>(far), Refuse<vtkHorizonHoleFilling>(far) })
  {
    CHECK(error.find("points in single precision, whose rounding by up to") != std::string::npos);
  }
}

/// Points that were moved keep an array that is not theirs any more.
void TestEdited()
{
  const auto placed = Run<vtkHorizonFaults>(Horizon());
  const auto byColumns = Shift(placed, 0, -1); // the first row stands outside then
  CHECK(Refuse<vtkHorizonExteriorBoundary>(byColumns).find("expected a place on the lattice") != std::string::npos);
  const auto inside = HorizonFixtures::FromPicture({ "......", ".###..", ".###..", "......" }, 1, RotatedSurvey());
  const auto right = Shift(Run<vtkHorizonFaults>(inside), 1, 0);
  const auto outlines = Run<vtkHorizonExteriorBoundary>(right);
  CHECK_EQUAL(Count(outlines).Right, 6);
  CHECK_EQUAL(vtkIntArray::SafeDownCast(outlines->GetPointData()->GetArray("Column"))->GetValue(0), 2);

  const auto beside = Shift(Run<vtkHorizonFaults>(inside), 0.5, 0);
  for (const std::string& error : { Refuse<vtkHorizonExteriorBoundary>(beside), Refuse<vtkHorizonSurface>(beside) })
  {
    CHECK(
      error.find("expected column (1, 1), which its array Column names, or another whole column") != std::string::npos);
  }
  // Also by stages that take merged points.
  const auto moved = Shift(Run<vtkHorizonExteriorBoundary>(inside), 0.5, 0);
  CHECK(Refuse<vtkHorizonTriangulation>(moved).find("which its array Column names") != std::string::npos);
  CHECK(Refuse<vtkHorizonRoughSimplification>(moved).find("which its array Column names") != std::string::npos);

  // An array that was put together with the points of two horizons fits; a column must not be there twice.
  vtkNew<vtkAppendPolyData> both;
  both->AddInputData(Run<vtkHorizonFaults>(inside));
  both->AddInputData(Run<vtkHorizonFaults>(inside));
  both->Update();
  both->GetOutput()->GetFieldData()->ShallowCopy(inside->GetFieldData());
  CHECK(Refuse<vtkHorizonExteriorBoundary>(both->GetOutput()).find("both in column (1, 1)") != std::string::npos);

  // Merged points have counts: without these an array that says that all were is not believed.
  const auto unplaced = Run<vtkHorizonExteriorBoundary>(inside);
  vtkIntArray::SafeDownCast(unplaced->GetPointData()->GetArray("Column"))->FillValue(-1);
  CHECK_EQUAL(Count(Run<vtkHorizonTriangulation>(unplaced)).Right, 6);
  CHECK_EQUAL(Count(Run<vtkHorizonDespiking>(unplaced)).Right, 6);

  // An array of the name that is not ours is replaced.
  vtkNew<vtkDoubleArray> other;
  other->SetName("Column");
  other->SetNumberOfTuples(inside->GetNumberOfPoints());
  other->FillComponent(0, 7.0);
  inside->GetPointData()->AddArray(other);
  CHECK_EQUAL(Count(Run<vtkHorizonExteriorBoundary>(inside)).Right, 6);
}

/// Stages before points are merged say so in one sentence.
void TestMerged()
{
  const auto merged = Run<vtkHorizonRoughSimplification>(Run<vtkHorizonExteriorBoundary>(Horizon()));
  for (const std::string& error : { Refuse<vtkHorizonExteriorBoundary>(merged), Refuse<vtkHorizonSurface>(merged),
         Refuse<vtkHorizonDecimation>(merged), Refuse<vtkHorizonDespiking>(merged), Refuse<vtkHorizonFaults>(merged),
         Refuse<vtkHorizonHoleFilling>(merged) })
  {
    CHECK(error.find(" represents merged points, expected points on whole columns") != std::string::npos);
  }
  // Without the array a point beside columns tells that points were merged.
  merged->GetPointData()->RemoveArray("Column");
  CHECK(Refuse<vtkHorizonDecimation>(merged).find("in lattice units, expected whole columns") != std::string::npos);
  const ColumnCount found = Count(Run<vtkHorizonTriangulation>(merged)); // of others, those that are kept have one
  CHECK(found.Right > 20 && found.None > 0 && found.Wrong == 0);
}
}

int TestHorizonColumns(int, char*[])
{
  TestStages();
  TestSinglePrecision();
  TestEdited();
  TestMerged();
  return Check::Result();
}
