// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Horizons with faulted links through the stages.

#include "FaultFixtures.h"
#include "Tools/Check.h"

#include "vtkCellArray.h"
#include "vtkHorizonBoundarySimplification.h"
#include "vtkHorizonDecimation.h"
#include "vtkHorizonElaborateSimplification.h"
#include "vtkHorizonExteriorBoundary.h"
#include "vtkHorizonRoughSimplification.h"
#include "vtkHorizonSurface.h"
#include "vtkHorizonTriangulation.h"

#include <array>
#include <cmath>
#include <limits>
#include <sstream>

using namespace FaultFixtures;

namespace
{
/// How many triangles lead from one cutoff to the other; on a survey of unit steps.
int CountAcross(vtkPolyData* mesh)
{
  int across = 0;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfPolys(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    mesh->GetPolys()->GetCellAtId(cell, size, corners);
    bool isBelow = false;
    bool isAbove = false;
    for (vtkIdType n = 0; n < size; ++n)
    {
      const double* const place = mesh->GetPoint(corners[n]);
      const bool isBeside = place[0] >= FirstColumn && place[0] <= LastColumn;
      isBelow = isBelow || (isBeside && place[1] <= LastRowBelow);
      isAbove = isAbove || (isBeside && place[1] > LastRowBelow);
    }
    across += isBelow && isAbove ? 1 : 0;
  }
  return across;
}

void TestBoundary()
{
  vtkNew<vtkHorizonExteriorBoundary> boundary;
  boundary->SetInputDataObject(MakeFaulted(HorizonFixtures::RotatedSurvey()));
  boundary->SetSmallestHoleSize(1000);
  CHECK(boundary->GetTearAtFaults());
  vtkPolyData* const output = Update(boundary);
  CHECK_EQUAL(Figure(output, "NumberOfPatches"), 1.0);
  CHECK_EQUAL(Figure(output, "NumberOfHoles"), 1.0);
  CHECK_EQUAL(output->GetLines()->GetCellSize(1), 2 * (LastColumn - FirstColumn + 3) + 1);
  CHECK(output->GetFieldData()->HasArray("FaultedLinks") && output->GetFieldData()->HasArray("FaultThrow"));
  boundary->TearAtFaultsOff();
  boundary->Update();
  CHECK_EQUAL(Figure(output, "NumberOfHoles"), 0.0);
  CHECK(!output->GetFieldData()->HasArray("FaultedLinks") && !output->GetFieldData()->HasArray("FaultThrow"));
  CHECK(vtkPolyData::SafeDownCast(boundary->GetInputDataObject(0, 0))->GetFieldData()->HasArray("FaultedLinks"));
  std::ostringstream text;
  boundary->Print(text);
  CHECK(text.str().find("TearAtFaults: off") != std::string::npos);
}

/// No stage joins the cutoffs, and cuts go on to the last one.
void TestStages()
{
  vtkNew<vtkHorizonExteriorBoundary> boundary;
  boundary->SetInputDataObject(MakeFaulted(HorizonFixtures::UnitSurvey()));
  vtkNew<vtkHorizonBoundarySimplification> outlines;
  outlines->SetInputConnection(boundary->GetOutputPort());
  vtkNew<vtkHorizonRoughSimplification> rough;
  rough->SetInputConnection(outlines->GetOutputPort());
  rough->SetCellSize(4);
  vtkNew<vtkHorizonElaborateSimplification> elaborate;
  elaborate->SetInputConnection(outlines->GetOutputPort());
  vtkNew<vtkHorizonTriangulation> mesh;
  const std::array<vtkAlgorithm*, 3> stages = { outlines.Get(), rough.Get(), elaborate.Get() };
  for (vtkAlgorithm* const stage : stages)
  {
    mesh->SetInputConnection(stage->GetOutputPort());
    vtkPolyData* const output = Update(mesh);
    CHECK(output->GetNumberOfPolys() > 0);
    CHECK_EQUAL(CountAcross(output), 0);
    CHECK(output->GetFieldData()->HasArray("FaultedLinks"));
  }
  vtkNew<vtkHorizonDecimation> decimation;
  decimation->SetMaximumError(0.75);
  decimation->SetInputConnection(outlines->GetOutputPort());
  CHECK_EQUAL(CountAcross(Update(decimation)), 0);
  boundary->TearAtFaultsOff();
  CHECK(CountAcross(Update(decimation)) > 0);
}

/// In the cells that the crack leads through from side to side, points have one height or the other.
void TestCells()
{
  vtkNew<vtkHorizonExteriorBoundary> boundary;
  boundary->SetInputDataObject(MakeFaulted(HorizonFixtures::UnitSurvey()));
  vtkNew<vtkHorizonRoughSimplification> rough;
  rough->SetInputConnection(boundary->GetOutputPort());
  rough->SetCellSize(8);
  const auto countBetween = [&rough]()
  {
    vtkPolyData* const output = Update(rough);
    int between = 0;
    for (vtkIdType point = 0; point < output->GetNumberOfPoints(); ++point)
    {
      const double* const place = output->GetPoint(point);
      between += place[0] > 7.0 && place[0] < 16.0 && place[2] > 10.0 && place[2] < 10.0 + Throw;
    }
    return between;
  };
  CHECK_EQUAL(countBetween(), 0);
  boundary->TearAtFaultsOff();
  CHECK(countBetween() > 0);
}

void TestSurface()
{
  vtkNew<vtkHorizonSurface> surface;
  surface->SetMaximumError(0.75);
  surface->SetInputDataObject(MakeFaulted(HorizonFixtures::UnitSurvey()));
  surface->SetOutlineTolerance(0.0);
  surface->AutomaticOutlineToleranceOff();
  CHECK(surface->GetTearAtFaults());
  vtkPolyData* const mesh = Update(surface);
  CHECK_EQUAL(CountAcross(mesh), 0);
  CHECK(mesh->GetFieldData()->HasArray("FaultedLinks"));
  surface->TearAtFaultsOff();
  surface->Update();
  CHECK(CountAcross(mesh) > 0);
  for (int port = 0; port < 2; ++port)
  {
    CHECK(!vtkPolyData::SafeDownCast(surface->GetOutputDataObject(port))->GetFieldData()->HasArray("FaultedLinks"));
  }
  std::ostringstream text;
  surface->Print(text);
  CHECK(text.str().find("TearAtFaults: off") != std::string::npos);
}

void CheckRefused(vtkPolyData* horizon, int radius, const std::string& message)
{
  vtkNew<vtkHorizonExteriorBoundary> boundary;
  boundary->SetInputDataObject(horizon);
  boundary->SetRadius(radius);
  boundary->SetGrowthStrategyToDistance();
  HorizonFixtures::Errors errors(boundary);
  boundary->Update();
  CHECK_EQUAL(errors.Count(), 1u);
  CHECK(errors.FirstContains(message));
}

/// Links as others may write them: other types, values that are no columns, and cuts far away in a huge lattice.
void TestLinksOfOthers()
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto addDoubles = [](vtkPolyData* horizon, const std::vector<double>& values, int components = 3)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName("FaultedLinks");
    array->SetNumberOfComponents(components);
    for (const double value : values)
    {
      array->InsertNextValue(value);
    }
    horizon->GetFieldData()->AddArray(array);
  };
  auto horizon = MakeFaulted(HorizonFixtures::UnitSurvey());
  for (const double odd : { std::nan(""), infinity, -infinity, 1e300, -1e300, -1.0, 0.5, 2147483648.0, 4294967296.0 })
  {
    for (std::size_t component = 0; component < 3; ++component)
    {
      std::vector<double> link = { 4.0, 4.0, 1.0, 5.0, 5.0, 0.0 };
      link[3 + component] = odd;
      addDoubles(horizon, link);
      CheckRefused(horizon, 1, "faulted link 1 (");
    }
  }
  addDoubles(horizon, { 1.0, 2.0, 2.0 });
  CheckRefused(horizon, 1, "i from 0 to 31 and j from 0 to 31, and a side, 0 or 1");
  addDoubles(horizon, { 1.0, 2.0, 0.0, 1.0 }, 4);
  CheckRefused(horizon, 1, "field data array FaultedLinks with 4 components, expected 3: i, j and the side");
  const auto countLoops = [&horizon]()
  {
    vtkNew<vtkHorizonExteriorBoundary> boundary;
    boundary->SetInputDataObject(horizon);
    boundary->Update();
    return boundary->GetPolyDataOutput()->GetNumberOfLines();
  };
  addDoubles(horizon, {});
  CHECK_EQUAL(countLoops(), 1);
  // A link a million times, and one at the far end of a lattice: bits for all columns between would be many petabytes.
  constexpr int side = (1 << 28) - 1;
  const int dimensions[3] = { side, side, 64 };
  HorizonFixtures::AddLattice(horizon, dimensions, HorizonFixtures::UnitSurvey());
  std::vector<double> links;
  for (int n = 0; n < 1000000; ++n)
  {
    links.insert(links.end(), { 5.0, 5.0, 1.0 });
  }
  links.insert(links.end(), { side - 1.0, side - 1.0, 0.0 });
  addDoubles(horizon, links);
  CHECK_EQUAL(countLoops(), 2);
}

void TestErrors()
{
  CheckRefused(MakeFaulted(HorizonFixtures::UnitSurvey()), 2,
    "faulted links and growth by distance with a radius of 2 columns, expected clockwise growth, or a radius of 1");
  auto beyond = MakeFaulted(HorizonFixtures::UnitSurvey());
  AddLinks(beyond, { { 32, 0, 0 } });
  CheckRefused(beyond, 1, "faulted link 0 (32, 0, 0), expected a column of the lattice");
}
}

int TestHorizonCuts(int, char*[])
{
  TestBoundary();
  TestStages();
  TestCells();
  TestSurface();
  TestLinksOfOthers();
  TestErrors();
  return Check::Result();
}
