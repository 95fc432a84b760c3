// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Meshes whose faults are closed.

#include "FaultFixtures.h"
#include "Tools/Check.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkHorizonBoundarySimplification.h"
#include "vtkHorizonDecimation.h"
#include "vtkHorizonElaborateSimplification.h"
#include "vtkHorizonExteriorBoundary.h"
#include "vtkHorizonRoughSimplification.h"
#include "vtkHorizonSurface.h"
#include "vtkHorizonSurfaceDistance.h"
#include "vtkHorizonTriangulation.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <array>
#include <cmath>
#include <map>
#include <sstream>
#include <utility>

using namespace FaultFixtures;

namespace
{
std::vector<std::array<vtkIdType, 3>> TrianglesOf(vtkPolyData* mesh)
{
  std::vector<std::array<vtkIdType, 3>> triangles;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfPolys(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    mesh->GetPolys()->GetCellAtId(cell, size, corners);
    triangles.push_back({ corners[0], corners[1], corners[2] });
  }
  return triangles;
}

/// Twice the area of a triangle in the plane of the world: positive when it faces up.
double PlanArea(vtkPolyData* mesh, const std::array<vtkIdType, 3>& triangle)
{
  std::array<std::array<double, 3>, 3> at;
  for (std::size_t corner = 0; corner < 3; ++corner)
  {
    mesh->GetPoint(triangle[corner], at[corner].data());
  }
  return (at[1][0] - at[0][0]) * (at[2][1] - at[0][1]) - (at[1][1] - at[0][1]) * (at[2][0] - at[0][0]);
}

/// The area of a mesh in lattice units; all of its triangles face up, and none has a side of another one.
double CheckPlan(vtkPolyData* mesh, double columnArea)
{
  double area = 0.0;
  std::map<std::pair<vtkIdType, vtkIdType>, int> sides;
  for (const std::array<vtkIdType, 3>& triangle : TrianglesOf(mesh))
  {
    CHECK(PlanArea(mesh, triangle) > 0.0);
    area += PlanArea(mesh, triangle) / 2.0;
    for (std::size_t n = 0; n < 3; ++n)
    {
      CHECK_EQUAL(++sides[std::make_pair(triangle[n], triangle[(n + 1) % 3])], 1);
    }
  }
  return area / columnArea;
}

/// The new triangles come after those there are without them, with their own cell data.
void CheckSame(vtkPolyData* open, vtkPolyData* closed)
{
  const vtkIdType before = open->GetNumberOfCells();
  const std::vector<std::array<vtkIdType, 3>> kept = TrianglesOf(open);
  std::vector<std::array<vtkIdType, 3>> triangles = TrianglesOf(closed);
  CHECK_EQUAL(Figure(closed, "FaultTriangleCount"), double(triangles.size() - kept.size()));
  CHECK_EQUAL(Figure(closed, "TriangleCount"), double(kept.size()));
  triangles.resize(kept.size());
  CHECK(kept == triangles);
  CHECK_EQUAL(open->GetNumberOfPoints(), closed->GetNumberOfPoints());
  CHECK(!open->GetCellData()->HasArray("Fault"));
  vtkDataArray* const faults = closed->GetCellData()->GetArray("Fault");
  if (!CHECK(faults))
  {
    return;
  }
  for (vtkIdType cell = 0; cell < closed->GetNumberOfCells(); ++cell)
  {
    CHECK_EQUAL(faults->GetTuple1(cell), cell < before ? 0.0 : 1.0);
  }
  for (int n = 0; n < open->GetCellData()->GetNumberOfArrays(); ++n)
  {
    vtkDataArray* const array = open->GetCellData()->GetArray(n);
    vtkDataArray* const extended = closed->GetCellData()->GetArray(array->GetName());
    CHECK_EQUAL(extended->GetNumberOfTuples(), closed->GetNumberOfCells());
    for (vtkIdType cell = 0; cell < before; ++cell)
    {
      const double value = array->GetTuple1(cell);
      CHECK(value == extended->GetTuple1(cell) || (std::isnan(value) && std::isnan(extended->GetTuple1(cell))));
    }
    const double ofNew = extended->GetTuple1(closed->GetNumberOfCells() - 1);
    CHECK(array->GetName() == std::string("Error") ? std::isnan(ofNew) : ofNew > 0.0 && ofNew <= 1.0);
  }
}

/// Closes what a mesher leaves open: the mesh then covers the whole lattice.
template <typename Mesher>
void CheckClosed(Mesher* mesher, double columnArea)
{
  CHECK(!mesher->GetCloseFaults());
  vtkNew<vtkPolyData> open;
  open->DeepCopy(Update(mesher));
  mesher->CloseFaultsOn();
  vtkPolyData* const closed = Update(mesher);
  CHECK(closed->GetNumberOfPolys() > open->GetNumberOfPolys());
  CheckSame(open, closed);
  constexpr double All = (Side - 1.0) * (Side - 1.0);
  CHECK(CheckPlan(open, columnArea) < All - 1.0);
  CHECK(std::abs(CheckPlan(closed, columnArea) - All) < 1e-6);
  std::ostringstream text;
  mesher->Print(text);
  CHECK(
    text.str().find("CloseFaults: o") != std::string::npos || text.str().find("CloseFaults: O") != std::string::npos);
}

struct Crack
{
  int First;
  int Last;
};

/// One inside, one that is open at the border, and one from side to side.
constexpr std::array<Crack, 3> CrackKinds = { { { FirstColumn, LastColumn }, { 0, 12 }, { 0, Side - 1 } } };

void TestMeshers()
{
  constexpr double ColumnArea = 10.8 * 21.6 + 12.5 * 6.25; // of the survey
  for (const Crack& crack : CrackKinds)
  {
    vtkNew<vtkHorizonExteriorBoundary> boundary;
    boundary->SetInputDataObject(MakeFaulted(HorizonFixtures::RotatedSurvey(), crack.First, crack.Last));
    for (const int method :
      { vtkHorizonBoundarySimplification::Threshold, vtkHorizonBoundarySimplification::FewestPoints })
    {
      vtkNew<vtkHorizonBoundarySimplification> outlines;
      outlines->SetInputConnection(boundary->GetOutputPort());
      outlines->SetMethod(method);
      vtkNew<vtkHorizonRoughSimplification> rough;
      rough->SetInputConnection(outlines->GetOutputPort());
      vtkNew<vtkHorizonElaborateSimplification> elaborate;
      elaborate->SetInputConnection(rough->GetOutputPort());
      const std::array<vtkAlgorithm*, 4> stages = { boundary.Get(), outlines.Get(), rough.Get(), elaborate.Get() };
      for (vtkAlgorithm* const stage : stages)
      {
        vtkNew<vtkHorizonTriangulation> triangulation;
        triangulation->SetInputConnection(stage->GetOutputPort());
        CheckClosed(triangulation.Get(), ColumnArea);
      }
      vtkNew<vtkHorizonDecimation> decimation;
      decimation->SetMaximumError(0.75);
      decimation->SetInputConnection(outlines->GetOutputPort());
      CheckClosed(decimation.Get(), ColumnArea);
    }
    vtkNew<vtkHorizonSurface> surface;
    surface->SetMaximumError(0.75);
    surface->SetInputConnection(0, boundary->GetInputConnection(0, 0));
    CheckClosed(surface.Get(), ColumnArea);
  }
}

/// Where the lattice is mirrored in the world, triangles face up as well.
void TestMirrored()
{
  auto mirrored = HorizonFixtures::UnitSurvey();
  mirrored->SetElement(0, 0, -1.0);
  vtkNew<vtkHorizonSurface> surface;
  surface->SetMaximumError(0.75);
  surface->SetInputDataObject(MakeFaulted(mirrored, 0, 12));
  CheckClosed(surface.Get(), 1.0);
}

/// The surface is that of the stages.
void TestSurface()
{
  auto horizon = MakeFaulted(HorizonFixtures::UnitSurvey(), 0, 12);
  vtkNew<vtkHorizonSurface> surface;
  surface->SetMaximumError(0.75);
  surface->SetInputDataObject(horizon);
  surface->CloseFaultsOn();
  vtkPolyData* const mesh = Update(surface);
  vtkNew<vtkHorizonExteriorBoundary> boundary;
  boundary->SetInputDataObject(horizon);
  boundary->KeepHolesOn();
  vtkNew<vtkHorizonBoundarySimplification> outlines;
  outlines->SetInputConnection(boundary->GetOutputPort());
  outlines->SetMethodToFewestPoints();
  outlines->SetOutlineTolerance(surface->GetMaximumError());
  outlines->SetDistanceThreshold(surface->GetMaximumError());
  vtkNew<vtkHorizonDecimation> decimation;
  decimation->SetMaximumError(0.75);
  decimation->SetInputConnection(outlines->GetOutputPort());
  decimation->CloseFaultsOn();
  CHECK(TrianglesOf(mesh) == TrianglesOf(Update(decimation)));
}

/// What the boundary tells of cracks is that of its own cuts.
void TestFieldData()
{
  vtkNew<vtkHorizonExteriorBoundary> boundary;
  boundary->SetInputDataObject(MakeFaulted(HorizonFixtures::RotatedSurvey(), 0, 12));
  vtkNew<vtkPolyData> cracked;
  cracked->ShallowCopy(Update(boundary));
  vtkDataArray* const openEnds = cracked->GetFieldData()->GetArray("CrackOpenEnds");
  CHECK_EQUAL(openEnds->GetNumberOfTuples(), 1);
  const std::array<double, 4> expected = { 0.0, LastRowBelow + 1.0, 0.0, LastRowBelow };
  for (int n = 0; n < 4; ++n)
  {
    CHECK_EQUAL(openEnds->GetComponent(0, n), expected[std::size_t(n)]);
  }
  CHECK_EQUAL(cracked->GetFieldData()->GetArray("CrackLoops")->GetNumberOfTuples(), 0);
  boundary->TearAtFaultsOff();
  CHECK(!Update(boundary)->GetFieldData()->HasArray("CrackOpenEnds"));
  boundary->TearAtFaultsOn();
  cracked->GetFieldData()->RemoveArray("FaultedLinks");
  boundary->SetInputDataObject(cracked);
  Update(boundary);
  CHECK(!boundary->GetPolyDataOutput()->GetFieldData()->HasArray("CrackOpenEnds"));
  CHECK(!boundary->GetPolyDataOutput()->GetFieldData()->HasArray("CrackLoops"));
  vtkNew<vtkHorizonSurface> surface;
  surface->SetMaximumError(0.75);
  surface->SetInputDataObject(cracked);
  surface->CloseFaultsOn();
  CHECK_EQUAL(Figure(Update(surface), "FaultTriangleCount"), 0.0);
  boundary->SetInputDataObject(MakeFaulted(HorizonFixtures::RotatedSurvey()));
  vtkFieldData* const inner = Update(boundary)->GetFieldData();
  CHECK_EQUAL(inner->GetArray("CrackOpenEnds")->GetNumberOfTuples(), 0);
  CHECK_EQUAL(inner->GetArray("CrackLoops")->GetNumberOfTuples(), 1);
  CHECK_EQUAL(inner->GetArray("CrackLoops")->GetTuple1(0), 1.0);
}

/// Boundaries of version 0.2 have another name for open ends, which is read, and gone once there are new ones.
void TestOldFieldData()
{
  vtkNew<vtkHorizonExteriorBoundary> boundary;
  boundary->SetInputDataObject(MakeFaulted(HorizonFixtures::RotatedSurvey(), 0, 12));
  vtkNew<vtkPolyData> old;
  old->DeepCopy(Update(boundary));
  old->GetFieldData()->GetArray("CrackOpenEnds")->SetName("CutMouths");
  old->GetFieldData()->GetArray("FaultedLinks")->SetName("CutLinks");
  vtkNew<vtkHorizonDecimation> decimation;
  decimation->SetMaximumError(0.75);
  decimation->CloseFaultsOn();
  for (vtkPolyData* const horizon : { boundary->GetPolyDataOutput(), old.Get() })
  {
    vtkNew<vtkHorizonBoundarySimplification> outlines;
    outlines->SetInputDataObject(horizon);
    outlines->SetDistanceThreshold(100.0);
    decimation->SetInputConnection(outlines->GetOutputPort());
    CHECK_EQUAL(Figure(Update(decimation), "FaultTriangleCount"), 2.0);
  }
  boundary->SetInputDataObject(old);
  for (const bool areUsed : { true, false })
  {
    boundary->SetTearAtFaults(areUsed);
    CHECK(!Update(boundary)->GetFieldData()->HasArray("CutMouths"));
    CHECK_EQUAL(boundary->GetPolyDataOutput()->GetFieldData()->HasArray("CutLinks"), int(areUsed));
    CHECK_EQUAL(boundary->GetPolyDataOutput()->GetFieldData()->HasArray("CrackOpenEnds"), int(areUsed));
  }
}

/// Triangles that close faults are no part of what is measured, and a horizon without faults has none.
void TestDistances()
{
  auto horizon = MakeFaulted(HorizonFixtures::UnitSurvey());
  vtkNew<vtkHorizonExteriorBoundary> boundary;
  boundary->SetInputDataObject(horizon);
  vtkNew<vtkHorizonDecimation> decimation;
  decimation->SetMaximumError(0.75);
  decimation->SetInputConnection(boundary->GetOutputPort());
  vtkNew<vtkHorizonSurfaceDistance> distance;
  distance->SetInputConnection(0, boundary->GetOutputPort());
  distance->SetInputConnection(1, decimation->GetOutputPort());
  const auto largest = [&distance]()
  {
    distance->Update();
    return vtkTable::SafeDownCast(distance->GetOutputDataObject(2))->GetValueByName(2, "LargestDistance").ToDouble();
  };
  const double open = largest();
  CHECK(open < 1.0);
  decimation->CloseFaultsOn();
  CHECK_EQUAL(largest(), open);
  boundary->TearAtFaultsOff();
  CHECK_EQUAL(Figure(Update(decimation), "FaultTriangleCount"), 0.0);
  CHECK(decimation->GetPolyDataOutput()->GetCellData()->HasArray("Fault"));
}

void CheckRefused(const char* name, const std::vector<double>& tuple, const std::string& message)
{
  vtkNew<vtkHorizonExteriorBoundary> boundary;
  boundary->SetInputDataObject(MakeFaulted(HorizonFixtures::UnitSurvey()));
  vtkNew<vtkPolyData> cracked;
  cracked->ShallowCopy(Update(boundary));
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(int(tuple.size()));
  array->InsertNextTuple(tuple.data());
  cracked->GetFieldData()->AddArray(array);
  vtkNew<vtkHorizonTriangulation> triangulation;
  triangulation->SetInputDataObject(cracked);
  triangulation->CloseFaultsOn();
  HorizonFixtures::Errors errors(triangulation);
  triangulation->Update();
  CHECK(errors.FirstContains(message));
}

void TestErrors()
{
  CheckRefused("CrackOpenEnds", { 1, 2, 3 }, "field data array CrackOpenEnds with 3 components, expected 4");
  CheckRefused("CrackOpenEnds", { 1, 2, 3, -4 }, "CrackOpenEnds -4 in tuple 0, expected a whole number, at least 0");
  CheckRefused(
    "CrackOpenEnds", { 8, 8, 8, 9 }, "open end of a crack at column (8, 8), expected a point of a boundary loop");
  CheckRefused("CrackLoops", { 2 }, "a crack along loop 2, expected less than the 2 of the boundary");
  CheckRefused("NumberOfHoles", { 2 }, "2 boundary loops with the field data array CrackLoops, expected as many as");
}
}

int TestHorizonFaultClosing(int, char*[])
{
  TestMeshers();
  TestMirrored();
  TestSurface();
  TestFieldData();
  TestOldFieldData();
  TestDistances();
  TestErrors();
  return Check::Result();
}
