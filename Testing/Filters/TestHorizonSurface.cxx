// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The filter from points to mesh: the same as the single stages to the byte, the parameters that it chose, errors.

#include "HorizonFixtures.h"
#include "Tools/Check.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkHorizonBoundarySimplification.h"
#include "vtkHorizonDecimation.h"
#include "vtkHorizonExteriorBoundary.h"
#include "vtkHorizonSurface.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <regex>
#include <sstream>

using namespace HorizonFixtures;

namespace
{
using Data = vtkSmartPointer<vtkPolyData>;

double Wavy(int i, int j)
{
  return std::round(20.0 + 6.0 * std::sin(0.35 * i) * std::cos(0.3 * j));
}

/// 40 by 30 columns with a hole, dropouts, a bay and two small patches.
std::vector<std::string> Picture()
{
  std::vector<std::string> rows = Rectangle(40, 30);
  for (int n = 0; n < 9; ++n)
  {
    rows[std::size_t(8 + n)].replace(20, std::size_t(4 + n / 3), std::string(std::size_t(4 + n / 3), '.'));
    rows[std::size_t(3 * n + 1)][std::size_t(4 * n + 2)] = '.';
    rows[std::size_t(n)].replace(5, std::size_t(9 - n), std::string(std::size_t(9 - n), '.'));
  }
  rows.insert(rows.begin(), 3, std::string(40, '.'));
  rows[0][7] = rows[0][30] = rows[0][31] = '#';
  return rows;
}

/// With attributes of all kinds: numbers of either precision with gaps, several components, texts.
Data MakeHorizon(vtkMatrix4x4* survey)
{
  Data horizon = FromPicture(Picture(), 7, survey, Wavy);
  const vtkIdType size = horizon->GetNumberOfPoints();
  vtkNew<vtkFloatArray> slopes;
  slopes->SetName("Slopes");
  slopes->SetNumberOfComponents(2);
  vtkNew<vtkStringArray> texts;
  texts->SetName("Texts");
  for (vtkIdType point = 0; point < size; ++point)
  {
    slopes->InsertNextTuple2(std::sin(double(point)), point % 7 == 0 ? std::nan("") : 0.1 * double(point));
    texts->InsertNextValue(std::to_string(point));
  }
  horizon->GetPointData()->AddArray(slopes);
  horizon->GetPointData()->AddArray(texts);
  horizon->GetPointData()->SetActiveScalars("Amplitude");
  return horizon;
}

/// The single stages, one after the other.
struct Stages
{
  vtkNew<vtkHorizonExteriorBoundary> Boundary;
  vtkNew<vtkHorizonBoundarySimplification> Straight;
  vtkNew<vtkHorizonDecimation> Mesh;

  explicit Stages(vtkPolyData* horizon)
  {
    this->Boundary->SetInputData(horizon);
    this->Boundary->KeepHolesOn();
    this->Straight->SetInputConnection(this->Boundary->GetOutputPort());
    this->Straight->SetMethodToFewestPoints();
    this->Mesh->SetInputConnection(this->Straight->GetOutputPort());
  }
};

double Figure(vtkDataObject* data, const char* name)
{
  vtkDataArray* const array = data->GetFieldData()->GetArray(name);
  return CHECK(array) ? array->GetTuple1(0) : std::nan("");
}

bool IsSame(vtkAbstractArray* a, vtkAbstractArray* b)
{
  if (!a || !b || a->GetDataType() != b->GetDataType() || a->GetNumberOfValues() != b->GetNumberOfValues() ||
    a->GetNumberOfComponents() != b->GetNumberOfComponents())
  {
    return false;
  }
  if (a->GetNumberOfValues() == 0)
  {
    return true; // there may be no memory to compare
  }
  if (auto* const texts = vtkStringArray::SafeDownCast(a))
  {
    vtkStdString* const values = texts->GetPointer(0);
    return std::equal(values, values + texts->GetNumberOfValues(), vtkStringArray::SafeDownCast(b)->GetPointer(0));
  }
  return std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0),
           std::size_t(a->GetNumberOfValues()) * std::size_t(a->GetDataTypeSize())) == 0;
}

/// All arrays, in their order; of field data those that the expected one has. Dropped points count for errors, not here.
void CheckSameArrays(vtkFieldData* found, vtkFieldData* expected, bool mayHaveMore)
{
  CHECK(mayHaveMore || found->GetNumberOfArrays() == expected->GetNumberOfArrays());
  for (int n = 0; n < expected->GetNumberOfArrays(); ++n)
  {
    vtkAbstractArray* const array = expected->GetAbstractArray(n);
    const bool isError = std::regex_match(array->GetName(), std::regex(".*Error"));
    CHECK(isError || (found->GetAbstractArray(n) && IsSame(found->GetAbstractArray(array->GetName()), array)));
    CHECK(mayHaveMore || std::string(found->GetArrayName(n)) == expected->GetArrayName(n));
  }
}

bool IsSame(vtkCellArray* a, vtkCellArray* b)
{
  return IsSame(a->GetOffsetsArray(), b->GetOffsetsArray()) &&
    IsSame(a->GetConnectivityArray(), b->GetConnectivityArray());
}

void CheckSame(vtkDataObject* foundObject, vtkDataObject* expectedObject)
{
  auto* const found = vtkPolyData::SafeDownCast(foundObject);
  auto* const expected = vtkPolyData::SafeDownCast(expectedObject);
  CHECK(IsSame(found->GetPoints()->GetData(), expected->GetPoints()->GetData()));
  CHECK(IsSame(found->GetVerts(), expected->GetVerts()));
  CHECK(IsSame(found->GetLines(), expected->GetLines()));
  CHECK(IsSame(found->GetPolys(), expected->GetPolys()));
  CheckSameArrays(found->GetPointData(), expected->GetPointData(), false);
  CheckSameArrays(found->GetCellData(), expected->GetCellData(), false);
  CheckSameArrays(found->GetFieldData(), expected->GetFieldData(), true);
  CHECK_EQUAL(std::string(found->GetPointData()->GetScalars()->GetName()),
    std::string(expected->GetPointData()->GetScalars()->GetName()));
}

/// What a surface says of its parameters gives the same in the single stages, which know nothing of slivers to come.
void CheckRepeated(vtkHorizonSurface* surface, vtkPolyData* horizon)
{
  surface->SetInputData(horizon);
  surface->SetSmallestAngle(0.0);
  surface->SetCrossingTolerance(vtkHorizonSurface::Unbounded);
  surface->Update();
  vtkPolyData* const mesh = surface->GetPolyDataOutput();
  CHECK(mesh->GetNumberOfPolys() > 0);
  Stages stages(horizon);
  stages.Boundary->SetRadius(int(Figure(mesh, "ChosenRadius")));
  stages.Boundary->SetKeepHoles(surface->GetKeepHoles());
  stages.Boundary->SetSmallestHoleSize(int(Figure(mesh, "ChosenSmallestHoleSize")));
  stages.Boundary->SetMinimumPatchSize(surface->GetMinimumPatchSize());
  stages.Boundary->SetGrowthStrategy(surface->GetGrowthStrategy());
  stages.Straight->SetOutlineTolerance(Figure(mesh, "ChosenOutlineTolerance"));
  stages.Straight->SetDistanceThreshold(Figure(mesh, "ChosenDistanceThreshold"));
  stages.Mesh->SetMaximumError(Figure(mesh, "ChosenMaximumError"));
  stages.Mesh->SetMaximumNumberOfPoints(int(Figure(mesh, "ChosenMaximumNumberOfPoints")));
  stages.Mesh->SetTarget(stages.Mesh->GetMaximumNumberOfPoints() > 0 ? vtkHorizonDecimation::NumberOfPoints
                                                                     : vtkHorizonDecimation::LargestError);
  stages.Mesh->SetFitHeights(surface->GetFitHeights());
  stages.Mesh->SetEffort(surface->GetEffort());
  stages.Mesh->SetPriority(surface->GetPriority());
  stages.Mesh->SetSmallestAngle(surface->GetSmallestAngle());
  stages.Mesh->SetCrossingTolerance(surface->GetCrossingTolerance());
  stages.Mesh->Update();
  CheckSame(mesh, stages.Mesh->GetOutputDataObject(0));
  CheckSame(surface->GetOutputDataObject(1), stages.Boundary->GetOutputDataObject(0));
}

void TestSameAsStages()
{
  for (const auto& survey : { UnitSurvey(), RotatedSurvey() })
  {
    const Data horizon = MakeHorizon(survey);
    vtkNew<vtkHorizonSurface> surface;
    CheckRepeated(surface, horizon);
    surface->SetMaximumError(0.75);
    CheckRepeated(surface, horizon);
    CHECK_EQUAL(Figure(surface->GetPolyDataOutput(), "ChosenRadius"), 1.0);
    CHECK_EQUAL(Figure(surface->GetPolyDataOutput(), "ChosenSmallestHoleSize"), 9.0);
    CHECK_EQUAL(Figure(surface->GetPolyDataOutput(), "NumberOfHoles"), 1.0);
    surface->SetMinimumPatchSize(2);
    CheckRepeated(surface, horizon);
    CHECK_EQUAL(Figure(surface->GetPolyDataOutput(), "DroppedSmallPatchPoints"), 1.0);
    surface->SetTargetToNumberOfTriangles();
    surface->SetMaximumNumberOfTriangles(500);
    CheckRepeated(surface, horizon);
    surface->SetPriorityToLargestErrors();
    surface->SetEffortToFast();
    surface->FitHeightsOff();
    CheckRepeated(surface, horizon);
  }
}

/// Points of single precision, which stand for several already, some of them hidden.
void TestPlainInput()
{
  const Data horizon = MakeHorizon(UnitSurvey());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  points->DeepCopy(horizon->GetPoints());
  horizon->SetPoints(points);
  vtkNew<vtkIdTypeArray> counts;
  counts->SetName("PointCount");
  counts->SetNumberOfTuples(horizon->GetNumberOfPoints());
  counts->FillValue(3);
  horizon->GetPointData()->AddArray(counts);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfTuples(horizon->GetNumberOfPoints());
  ghosts->FillValue(0);
  ghosts->SetValue(100, vtkDataSetAttributes::HIDDENPOINT);
  horizon->GetPointData()->AddArray(ghosts);
  vtkNew<vtkHorizonSurface> surface;
  CheckRepeated(surface, horizon);
}

/// Each value can be given instead; switched over to what was chosen, nothing changes.
void TestGivenParameters()
{
  const Data horizon = MakeHorizon(UnitSurvey());
  vtkNew<vtkHorizonSurface> surface;
  surface->SetInputData(horizon);
  surface->SetRadius(3);
  surface->SetSmallestHoleSize(2);
  surface->SetOutlineTolerance(0.25);
  surface->SetDistanceThreshold(0.5);
  surface->SetGrowthStrategyToDistance();
  CheckRepeated(surface, horizon);
  CHECK_EQUAL(Figure(surface->GetPolyDataOutput(), "ChosenRadius"), 1.0);
  surface->AutomaticRadiusOff();
  surface->AutomaticSmallestHoleSizeOff();
  surface->AutomaticOutlineToleranceOff();
  surface->AutomaticDistanceThresholdOff();
  CheckRepeated(surface, horizon);
  vtkPolyData* const mesh = surface->GetPolyDataOutput();
  CHECK_EQUAL(Figure(mesh, "ChosenRadius"), 3.0);
  CHECK_EQUAL(Figure(mesh, "ChosenSmallestHoleSize"), 2.0);
  CHECK_EQUAL(Figure(mesh, "ChosenOutlineTolerance"), 0.25);
  CHECK_EQUAL(Figure(mesh, "ChosenDistanceThreshold"), 0.5);
  surface->KeepHolesOff();
  CheckRepeated(surface, horizon);
  CHECK_EQUAL(Figure(surface->GetPolyDataOutput(), "NumberOfHoles"), 0.0);
}

/// Steps of 4 world units downwards.
void TestErrorUnits()
{
  vtkNew<vtkHorizonSurface> surface;
  surface->SetInputData(FromPicture(Rectangle(30, 24), 7, RotatedSurvey(), Wavy));
  surface->SetErrorUnitToWorld();
  surface->SetMaximumError(5.0);
  surface->Update();
  CHECK_EQUAL(Figure(surface->GetPolyDataOutput(), "ChosenMaximumError"), 1.25);
  CHECK_EQUAL(Figure(surface->GetPolyDataOutput(), "ChosenOutlineTolerance"), 0.75);
  surface->SetErrorUnitToDiagonal();
  surface->SetMaximumError(1.25 / std::sqrt(29.0 * 29.0 + 23.0 * 23.0 + 12.0 * 12.0));
  surface->Update();
  CHECK(std::abs(Figure(surface->GetPolyDataOutput(), "ChosenMaximumError") - 1.25) < 1e-12);
}

void TestNumberOfTriangles()
{
  vtkNew<vtkHorizonSurface> surface;
  surface->SetInputData(MakeHorizon(UnitSurvey()));
  surface->SetTargetToNumberOfTriangles();
  for (const int most : { 150, 600, 100000 })
  {
    surface->SetMaximumNumberOfTriangles(most);
    surface->Update();
    const vtkIdType triangles = surface->GetPolyDataOutput()->GetNumberOfPolys();
    CHECK(triangles <= most && (most > 600 || triangles + 1 >= most));
  }
}

/// Nothing is left: a warning, as that of the boundary, and no points; nor of a horizon without any.
void TestNothingLeft()
{
  vtkNew<vtkHorizonSurface> surface;
  Errors warnings(surface, vtkCommand::WarningEvent);
  surface->SetInputData(FromPicture(Rectangle(3, 3), 7, UnitSurvey()));
  surface->SetMinimumPatchSize(10);
  surface->Update();
  CHECK_EQUAL(surface->GetPolyDataOutput()->GetNumberOfPoints(), 0);
  CHECK_EQUAL(Figure(surface->GetPolyDataOutput(), "DroppedSmallPatchPoints"), 9.0);
  CHECK(
    warnings.FirstContains("Horizon 7: none of the 9 points is in a patch of MinimumPatchSize, 10 points, or more"));
  vtkNew<vtkPolyData> empty;
  surface->SetInputData(empty);
  surface->Update();
  CHECK_EQUAL(surface->GetOutputDataObject(1)->GetNumberOfElements(vtkDataObject::POINT), 0);
}

/// Both outputs keep the structure; one horizon that is wrong stops all, or is left out.
void TestComposite()
{
  vtkNew<vtkPartitionedDataSetCollection> horizons;
  horizons->SetPartition(0, 0, FromPicture(Rectangle(9, 9), 7, UnitSurvey()));
  horizons->SetPartition(1, 0, FromPicture({ "##", "##" }, 8, UnitSurvey()));
  horizons->GetPartition(1, 0)->GetFieldData()->RemoveArray("LatticeToWorld");
  vtkNew<vtkHorizonSurface> surface;
  surface->SetInputData(horizons);
  {
    Errors errors(surface);
    surface->Update();
    CHECK(errors.FirstContains("Horizon 8: no field data array LatticeToWorld"));
    CHECK_EQUAL(surface->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::POINT), 0);
  }
  Errors warnings(surface, vtkCommand::WarningEvent);
  surface->SetInvalidHorizonsToLeaveOut();
  surface->Update();
  CHECK_EQUAL(warnings.Count(), 1u);
  for (const int port : { 0, 1 })
  {
    auto* const output = vtkPartitionedDataSetCollection::SafeDownCast(surface->GetOutputDataObject(port));
    CHECK(CHECK(output) && output->GetNumberOfPartitionedDataSets() == 2u);
    CHECK(output->GetPartition(0, 0)->GetNumberOfPoints() > 0);
    CHECK_EQUAL(output->GetPartition(1, 0)->GetNumberOfPoints(), 0);
  }
}

/// The setter is that of the filter or of a class it is derived from.
template <typename Filter, typename Value>
void CheckRefused(void (Filter::*set)(Value), Value value, const std::string& message, bool isByNumber = false)
{
  vtkNew<vtkHorizonSurface> surface;
  surface->SetInputData(MakeHorizon(UnitSurvey()));
  surface->SetTarget(isByNumber ? vtkHorizonSurface::NumberOfTriangles : vtkHorizonSurface::LargestError);
  surface->SetAutomaticRadius(false);
  surface->SetAutomaticSmallestHoleSize(false);
  surface->SetAutomaticDistanceThreshold(false);
  surface->SetAutomaticOutlineTolerance(false);
  (surface->*set)(value);
  Errors errors(surface);
  surface->Update();
  CHECK_EQUAL(errors.Count(), 1u);
  if (!CHECK(errors.FirstContains("Horizon 7: " + message)))
  {
    std::cerr << "expected \"" << message << "\", found: " << errors.First();
  }
  CHECK_EQUAL(surface->GetPolyDataOutput()->GetNumberOfPoints(), 0);
}

void TestErrors()
{
  using Surface = vtkHorizonSurface;
  const double infinity = std::numeric_limits<double>::infinity();
  CheckRefused(&Surface::SetMaximumError, -0.5, "maximum error -0.5, expected at least 0, or -1 for automatic");
  CheckRefused(&Surface::SetMaximumError, infinity, "maximum error inf, expected a finite number");
  CheckRefused(&Surface::SetMaximumNumberOfTriangles, 0, "maximum number of triangles 0, expected at least 1", true);
  CheckRefused(&Surface::SetMaximumNumberOfTriangles, 3, "maximum number of triangles 3, expected at least the ", true);
  CheckRefused(&Surface::SetRadius, 33, "radius 33, expected 1 to 32 columns");
  CheckRefused(&Surface::SetSmallestHoleSize, 0, "smallest hole size 0, expected at least 1 column");
  CheckRefused(&Surface::SetMinimumPatchSize, -2, "minimum patch size -2, expected at least 1 point");
  CheckRefused(&Surface::SetOutlineTolerance, -1.0, "outline tolerance -1, expected at least 0 columns");
  CheckRefused(&Surface::SetDistanceThreshold, -0.5, "distance threshold -0.5, expected at least 0 lattice units");
  CheckRefused(&Surface::SetSmallestAngle, 61.0, "smallest angle 61, expected 0 to 60 degrees");
}

void TestPrint()
{
  vtkNew<vtkHorizonSurface> surface;
  std::ostringstream text;
  surface->Print(text);
  for (const char* const line : { "Target: LargestError", "MaximumError: -1", "ErrorUnit: Steps",
         "MaximumNumberOfTriangles: 20000", "AutomaticRadius: on", "Radius: 1", "GrowthStrategy: Clockwise",
         "KeepHoles: on", "AutomaticSmallestHoleSize: on", "SmallestHoleSize: 1", "MinimumPatchSize: 1",
         "AutomaticOutlineTolerance: on", "OutlineTolerance: 0", "AutomaticDistanceThreshold: on",
         "DistanceThreshold: 0.4", "FitHeights: on", "Effort: Best", "Priority: SumOfSquares", "SmallestAngle: 2" })
  {
    CHECK(text.str().find(line) != std::string::npos);
  }
}
}

int TestHorizonSurface(int, char*[])
{
  TestSameAsStages();
  TestPlainInput();
  TestGivenParameters();
  TestErrorUnits();
  TestNumberOfTriangles();
  TestNothingLeft();
  TestComposite();
  TestErrors();
  TestPrint();
  return Check::Result();
}
