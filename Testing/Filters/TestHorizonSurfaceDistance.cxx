// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonFixtures.h"
#include "Tools/Check.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkHorizonBoundarySimplification.h"
#include "vtkHorizonExteriorBoundary.h"
#include "vtkHorizonRoughSimplification.h"
#include "vtkHorizonSurfaceDistance.h"
#include "vtkHorizonTriangulation.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPlaneSource.h"
#include "vtkSMPTools.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <cmath>
#include <cstring>
#include <sstream>

namespace
{
using Data = vtkSmartPointer<vtkPolyData>;

template <typename Filter>
Data Apply(vtkDataObject* input)
{
  vtkNew<Filter> filter;
  filter->SetInputDataObject(input);
  filter->Update();
  return filter->GetPolyDataOutput();
}

Data Horizon(vtkMatrix4x4* survey, int id = 1)
{
  return HorizonFixtures::FromPicture(HorizonFixtures::Rectangle(24, 18), id, survey);
}

Data Simplified(vtkDataObject* horizon)
{
  return Apply<vtkHorizonTriangulation>(Apply<vtkHorizonRoughSimplification>(
    Apply<vtkHorizonBoundarySimplification>(Apply<vtkHorizonExteriorBoundary>(horizon))));
}

/// A copy without lattice, lines and arrays that lies higher by `lift`, as another tool would have made it.
Data Foreign(vtkPolyData* mesh, double lift)
{
  auto copy = Data::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->DeepCopy(mesh->GetPoints());
  for (vtkIdType point = 0; point < points->GetNumberOfPoints(); ++point)
  {
    double* const place = points->GetPoint(point);
    points->SetPoint(point, place[0], place[1], place[2] + lift);
  }
  copy->SetPoints(points);
  copy->SetPolys(mesh->GetPolys());
  return copy;
}

struct Meter
{
  vtkNew<vtkHorizonSurfaceDistance> Filter;

  Meter(vtkDataObject* reference, vtkDataObject* mesh)
  {
    this->Filter->SetInputDataObject(0, reference);
    this->Filter->SetInputDataObject(1, mesh);
  }

  vtkPolyData* Update(int port)
  {
    this->Filter->Update();
    return vtkPolyData::SafeDownCast(this->Filter->GetOutputDataObject(port));
  }
  vtkTable* Table() { return vtkTable::SafeDownCast(this->Filter->GetOutputDataObject(2)); }
};

double Figure(vtkPolyData* output, const char* name, int direction, int unit)
{
  return output->GetFieldData()->GetArray(name)->GetComponent(direction, unit);
}

bool IsNear(double a, double b, double tolerance = 1e-9)
{
  return std::abs(a - b) <= tolerance;
}

/// A lattice unit of 5 world units, and a millionth more upwards on request.
vtkSmartPointer<vtkMatrix4x4> UniformSurvey(double more = 0.0)
{
  auto map = HorizonFixtures::UnitSurvey();
  const double values[16] = { 3, -4, 0, 604321.25, 4, 3, 0, 6079543.5, 0, 0, -5 * (1 + more), 100, 0, 0, 0, 1 };
  map->DeepCopy(values);
  return map;
}

/// Lifted by a multiple of the vertical step: everything is known, in every unit and on every survey.
void TestLifted(vtkMatrix4x4* survey)
{
  const double step = survey->GetElement(2, 2);
  Data horizon = Horizon(survey);
  Data flat =
    HorizonFixtures::FromPicture(HorizonFixtures::Rectangle(24, 18), 1, survey, [](int, int) { return 20.0; });
  Data mesh = Foreign(Apply<vtkHorizonTriangulation>(Apply<vtkHorizonExteriorBoundary>(flat)), 3.0 * std::abs(step));
  Meter meter(flat, mesh);
  vtkPolyData* reference = meter.Update(0);
  CHECK_EQUAL(reference->GetNumberOfPolys(), 2 * 23 * 17);
  CHECK(reference->GetPointData()->GetArray("Amplitude") != nullptr);
  vtkPolyData* const output = meter.Update(1);
  for (const char* name : { "LargestDistance", "MeanDistance", "RmsDistance", "DistancePercentile50",
         "DistancePercentile90", "DistancePercentile95", "DistancePercentile99" })
  {
    for (int direction = 0; direction < 3; ++direction)
    {
      CHECK(IsNear(Figure(output, name, direction, 0), 3.0));
      CHECK(IsNear(Figure(output, name, direction, 1), 3.0 * std::abs(step), 1e-7));
      CHECK(IsNear(Figure(output, name, direction, 2), 3.0 / std::hypot(23.0, 17.0)));
    }
  }
  CHECK(IsNear(Figure(output, "OutlineDistance", 2, 0), 0.0));
  CHECK(IsNear(Figure(output, "Grading", 0, 0), std::sqrt(2.0), 2e-3));
  CHECK(IsNear(output->GetPointData()->GetArray("Distance")->GetTuple1(5), 3.0));
  CHECK(IsNear(output->GetPointData()->GetArray("VerticalDistance")->GetTuple1(5), 3.0));
  CHECK(IsNear(reference->GetPointData()->GetArray("VerticalDistance")->GetTuple1(0), -3.0));
  // The inputs stay as they were.
  CHECK(mesh->GetPointData()->GetNumberOfArrays() == 0 && mesh->GetFieldData()->GetNumberOfArrays() == 0);
  CHECK(flat->GetNumberOfPolys() == 0 && !flat->GetFieldData()->HasArray("LargestDistance"));
  meter.Filter->SetDistanceUnitToWorld();
  reference = meter.Update(0);
  CHECK(IsNear(reference->GetPointData()->GetArray("Distance")->GetTuple1(7), 3.0 * std::abs(step), 1e-7));
  CHECK(IsNear(reference->GetPointData()->GetArray("VerticalDistance")->GetTuple1(7), -3.0 * std::abs(step), 1e-7));
}

/// A simplified horizon differs a little, and as much on every survey.
void TestSimplified()
{
  double mean = 0.0;
  for (const auto& survey : { HorizonFixtures::UnitSurvey(), HorizonFixtures::RotatedSurvey() })
  {
    Data horizon = Horizon(survey);
    Meter meter(horizon, Simplified(horizon));
    vtkPolyData* const mesh = meter.Update(1);
    const double found = Figure(mesh, "MeanDistance", 2, 0);
    CHECK(found > 0.01 && found < 1.0 && Figure(mesh, "LargestDistance", 2, 0) < 3.0);
    CHECK(mean == 0.0 || IsNear(found, mean, 0.01 * mean));
    mean = found;
    vtkTable* const table = meter.Table();
    CHECK_EQUAL(table->GetNumberOfRows(), 9);
    CHECK_EQUAL(table->GetValueByName(2, "Horizon").ToString(), std::string("Horizon 1"));
    CHECK_EQUAL(table->GetValueByName(2, "Direction").ToString(), std::string("Two-sided"));
    CHECK_EQUAL(table->GetValueByName(3, "Unit").ToString(), std::string("World"));
    CHECK_EQUAL(table->GetValueByName(2, "MeanDistance").ToDouble(), found);
    CHECK(table->GetValueByName(0, "Samples").ToDouble() > 5000.0);
    // With its loops, or as a mesh, the reference is the same surface.
    for (const Data& same : { Apply<vtkHorizonExteriorBoundary>(horizon),
           Apply<vtkHorizonTriangulation>(Apply<vtkHorizonExteriorBoundary>(horizon)) })
    {
      Meter other(same, Simplified(horizon));
      CHECK_EQUAL(Figure(other.Update(1), "MeanDistance", 2, 0), found);
    }
  }
}

/// World distances follow from those on the lattice where its unit is as long in all directions, and are measured anew
/// where it is not quite.
void TestUniformUnits()
{
  Data horizon = Horizon(UniformSurvey());
  Data nearly = Horizon(UniformSurvey(1e-6));
  Meter meter(horizon, Simplified(horizon));
  Meter nearlyMeter(nearly, Simplified(nearly));
  meter.Filter->SetDistanceUnitToWorld();
  nearlyMeter.Filter->SetDistanceUnitToWorld();
  for (int port = 0; port < 2; ++port)
  {
    vtkPolyData* const output = meter.Update(port);
    vtkPolyData* const other = nearlyMeter.Update(port);
    for (const char* name : { "LargestDistance", "MeanDistance", "RmsDistance", "DistancePercentile90" })
    {
      CHECK(IsNear(Figure(output, name, port, 1), 5.0 * Figure(output, name, port, 0)));
      // Samples lie elsewhere.
      CHECK(IsNear(Figure(output, name, port, 1), Figure(other, name, port, 1), 0.05 * Figure(other, name, port, 1)));
    }
    for (vtkIdType point = 0; point < output->GetNumberOfPoints(); point += 7)
    {
      const double distance = output->GetPointData()->GetArray("Distance")->GetTuple1(point);
      CHECK(IsNear(distance, other->GetPointData()->GetArray("Distance")->GetTuple1(point), 1e-4));
    }
  }
}

/// Without a lattice, all units are those of the world.
void TestPlainMeshes()
{
  Data mesh = Simplified(Horizon(HorizonFixtures::UnitSurvey()));
  Data low = Foreign(mesh, 0.0);
  Data high = Foreign(mesh, 2.5);
  Meter meter(low, high);
  CHECK(IsNear(
    Figure(meter.Update(0), "DistancePercentile99", 0, 1), Figure(meter.Update(0), "DistancePercentile99", 0, 0)));
  CHECK(Figure(meter.Update(0), "LargestDistance", 2, 0) <= 2.5 + 1e-12);
  CHECK(IsNear(meter.Update(0)->GetPointData()->GetArray("VerticalDistance")->GetTuple1(9), -2.5));
}

vtkSmartPointer<vtkPartitionedDataSetCollection> Collection(const std::vector<std::pair<const char*, Data>>& horizons)
{
  auto collection = vtkSmartPointer<vtkPartitionedDataSetCollection>::New();
  for (const auto& [name, horizon] : horizons)
  {
    const unsigned int n = collection->GetNumberOfPartitionedDataSets();
    collection->SetPartition(n, 0, horizon);
    collection->GetMetaData(n)->Set(vtkCompositeDataSet::NAME(), name);
  }
  return collection;
}

/// Horizons find their meshes by name, whatever the order and the kind of dataset.
void TestMatching()
{
  Data first = Horizon(HorizonFixtures::UnitSurvey(), 1);
  Data second = Horizon(HorizonFixtures::UnitSurvey(), 2);
  Data meshOfFirst = Foreign(Simplified(first), 1.0);
  Data meshOfSecond = Foreign(Simplified(second), 40.0);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, meshOfSecond);
  blocks->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "Horizon 2");
  blocks->SetBlock(1, meshOfFirst);
  blocks->GetMetaData(1u)->Set(vtkCompositeDataSet::NAME(), "Horizon 1");
  Meter meter(Collection({ { "Horizon 1", first }, { "Horizon 2", second } }), blocks);
  meter.Filter->Update();
  auto* const meshes = vtkMultiBlockDataSet::SafeDownCast(meter.Filter->GetOutputDataObject(1));
  CHECK(IsNear(Figure(vtkPolyData::SafeDownCast(meshes->GetBlock(0)), "LargestDistance", 2, 0), 40.0, 5.0));
  CHECK(IsNear(Figure(vtkPolyData::SafeDownCast(meshes->GetBlock(1)), "LargestDistance", 2, 0), 2.0, 3.0));
  auto* const references = vtkPartitionedDataSetCollection::SafeDownCast(meter.Filter->GetOutputDataObject(0));
  CHECK_EQUAL(std::string(references->GetMetaData(1u)->Get(vtkCompositeDataSet::NAME())), std::string("Horizon 2"));
  CHECK_EQUAL(meter.Table()->GetNumberOfRows(), 18);

  meter.Filter->SetInputDataObject(1, Collection({ { "Horizon 2", meshOfSecond } }));
  HorizonFixtures::Errors errors(meter.Filter);
  meter.Filter->Update();
  CHECK(errors.FirstContains("no mesh for Horizon 1 of the reference, expected one of that name; there is Horizon 2"));
  CHECK_EQUAL(meter.Table()->GetNumberOfRows(), 0);
  meter.Filter->SetInputDataObject(0, Collection({ { "Horizon 2", second } }));
  meter.Filter->SetInputDataObject(1, Collection({ { "Horizon 2", meshOfSecond }, { "Other", meshOfFirst } }));
  HorizonFixtures::Errors others(meter.Filter);
  meter.Filter->Update();
  CHECK(others.FirstContains("no reference for Other of the mesh, expected one of that name; there is Horizon 2"));
}

void CheckError(vtkDataObject* reference, vtkDataObject* mesh, const std::string& message, int radius = 1)
{
  Meter meter(reference, mesh);
  meter.Filter->SetRadius(radius);
  HorizonFixtures::Errors errors(meter.Filter);
  meter.Filter->Update();
  CHECK_EQUAL(errors.Count(), std::size_t(1));
  if (!CHECK(errors.FirstContains(message)))
  {
    std::cerr << errors.First();
  }
  CHECK_EQUAL(meter.Update(1)->GetNumberOfPoints(), 0);
}

void TestErrors()
{
  Data horizon = Horizon(HorizonFixtures::UnitSurvey());
  Data mesh = Simplified(horizon);
  CheckError(horizon, horizon, "Horizon 1: mesh: 432 points and no triangles, expected a triangle mesh");
  CheckError(horizon, Data::New(), "mesh: 0 points and no triangles, expected a triangle mesh");
  CheckError(Data::New(), mesh, "reference: 0 points and no triangles, expected a triangle mesh");
  CheckError(horizon, mesh, "reference: radius", 0);
  Data cloud = Data::New();
  cloud->SetPoints(horizon->GetPoints());
  CheckError(cloud, mesh, "reference: no field data array LatticeDimensions, expected 3 values");
  vtkNew<vtkPlaneSource> plane;
  plane->Update();
  CheckError(horizon, plane->GetOutput(), "mesh: polygon 0 with 4 corners, expected triangles");
  Data strip = Data::New();
  strip->SetPoints(mesh->GetPoints());
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell({ 0, 1, 2, 3 });
  strip->SetStrips(strips);
  CheckError(horizon, strip, "mesh: 1 triangle strips, expected triangles");
  Data broken = Foreign(mesh, 0.0);
  broken->GetPoints()->SetPoint(4, 1.0, std::nan(""), 2.0);
  CheckError(horizon, broken, "mesh: point 4 at (1, nan, 2), expected finite coordinates");
  Data line = Foreign(mesh, 0.0);
  vtkNew<vtkCellArray> none;
  none->InsertNextCell({ 0, 0, 1 });
  line->SetPolys(none);
  CheckError(line, mesh, "reference: 1 triangles without any area, expected a surface");
}

/// The mesh is told by its triangles, at either input or both at the first one.
void TestOrder()
{
  Data horizon = Horizon(HorizonFixtures::UnitSurvey());
  Data mesh = Simplified(horizon);
  Meter given(horizon, mesh);
  const std::string told = (given.Update(0), given.Filter->GetResults());
  CHECK(told.find("Horizon 1, in columns and vertical indices:\n  largest distance ") == 0);
  Meter swapped(mesh, horizon);
  Meter together(mesh, nullptr);
  together.Filter->AddInputDataObject(0, horizon);
  for (Meter* const meter : { &swapped, &together })
  {
    CHECK_EQUAL(meter->Update(1)->GetNumberOfPolys(), mesh->GetNumberOfPolys());
    CHECK_EQUAL(meter->Filter->GetResults(), told);
  }
  together.Filter->AddInputDataObject(0, horizon);
  HorizonFixtures::Errors errors(together.Filter);
  together.Filter->Update();
  CHECK(errors.FirstContains("3 inputs, expected two: a horizon and the mesh that represents it"));
  together.Filter->RemoveAllInputConnections(0);
  together.Update(0);
}

/// The same bytes on one thread and on several.
void TestThreads()
{
  Data horizon = Horizon(HorizonFixtures::RotatedSurvey());
  Data mesh = Simplified(horizon);
  Meter one(horizon, mesh);
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ 1, "Sequential", false }, [&one]() { one.Filter->Update(); });
  Meter many(horizon, mesh);
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ 4, "STDThread", false }, [&many]() { many.Filter->Update(); });
  for (const char* name : { "Distance", "VerticalDistance" })
  {
    vtkDataArray* const a = one.Update(0)->GetPointData()->GetArray(name);
    vtkDataArray* const b = many.Update(0)->GetPointData()->GetArray(name);
    CHECK_EQUAL(
      std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0), std::size_t(a->GetNumberOfValues()) * sizeof(double)), 0);
  }
  for (vtkIdType column = 3; column < one.Table()->GetNumberOfColumns(); ++column)
  {
    for (vtkIdType row = 0; row < one.Table()->GetNumberOfRows(); ++row)
    {
      const double a = one.Table()->GetValue(row, column).ToDouble();
      const double b = many.Table()->GetValue(row, column).ToDouble();
      CHECK(a == b || (std::isnan(a) && std::isnan(b)));
    }
  }
}

/// A request to stop leaves everything empty, without an error.
void TestStop()
{
  Data horizon = Horizon(HorizonFixtures::UnitSurvey());
  Meter meter(horizon, Simplified(horizon));
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback(
    [](vtkObject* caller, unsigned long, void*, void*) { vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1); });
  meter.Filter->AddObserver(vtkCommand::ProgressEvent, stop);
  HorizonFixtures::Errors errors(meter.Filter);
  meter.Filter->Update();
  CHECK_EQUAL(errors.Count(), std::size_t(0));
  CHECK_EQUAL(vtkPolyData::SafeDownCast(meter.Filter->GetOutputDataObject(1))->GetNumberOfPoints(), 0);
}

void TestPrint()
{
  vtkNew<vtkHorizonSurfaceDistance> filter;
  filter->SetDistanceUnitToWorld();
  filter->SetSamplesPerPoint(12.5);
  filter->SetSeed(77);
  filter->SetRadius(3);
  filter->IncludeFilledPointsOn();
  std::ostringstream text;
  filter->Print(text);
  for (const char* line :
    { "DistanceUnit: World", "SamplesPerPoint: 12.5", "Seed: 77", "Radius: 3", "IncludeFilledPoints: on" })
  {
    CHECK(text.str().find(line) != std::string::npos);
  }
}
}

int TestHorizonSurfaceDistance(int, char*[])
{
  TestLifted(HorizonFixtures::UnitSurvey());
  TestLifted(HorizonFixtures::RotatedSurvey());
  TestLifted(UniformSurvey());
  TestUniformUnits();
  TestSimplified();
  TestPlainMeshes();
  TestMatching();
  TestErrors();
  TestOrder();
  TestThreads();
  TestStop();
  TestPrint();
  return Check::Result();
}
