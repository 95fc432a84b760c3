// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Images become horizons: arrays of all types, blanked points, lattices, windows, what was found, pieces, errors.

#include "HorizonFixtures.h"
#include "Tools/Check.h"

#include "vtkSeismicReflectionExtraction.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkHorizonExteriorBoundary.h"
#include "vtkImageData.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkShortArray.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

using namespace HorizonFixtures;

namespace
{
using Image = vtkSmartPointer<vtkImageData>;
using Filter = vtkSmartPointer<vtkSeismicReflectionExtraction>;

constexpr int Size[3] = { 6, 5, 40 };
constexpr double Missing = std::numeric_limits<double>::quiet_NaN();

/// Two levels in samples, a positive one that dips and a negative one: amplitudes 100, 300, 200 around the peak.
double Amplitude(int i, int k)
{
  const double shape[3] = { 100.0, 300.0, 200.0 };
  const int first = k - (8 + i);
  const int second = k - 27;
  return first >= 0 && first < 3 ? shape[first] : second >= 0 && second < 3 ? -shape[second] : 0.0;
}

template <typename Array>
Image MakeCube(const char* name = "Amplitude")
{
  auto image = Image::New();
  image->SetDimensions(Size);
  vtkNew<Array> array;
  array->SetName(name);
  for (int k = 0; k < Size[2]; ++k)
  {
    for (int n = 0; n < Size[0] * Size[1]; ++n)
    {
      array->InsertNextValue(static_cast<typename Array::ValueType>(Amplitude(n % Size[0], k)));
    }
  }
  image->GetPointData()->AddArray(array);
  return image;
}

Filter MakeFilter(vtkImageData* image)
{
  auto filter = Filter::New();
  filter->SetInputDataObject(image);
  filter->SetSmallestSize(5);
  filter->SetAmplitudePercentile(0.0);
  return filter;
}

vtkPolyData* Horizon(vtkSeismicReflectionExtraction* filter, unsigned int number = 0)
{
  return vtkPolyData::SafeDownCast(filter->GetOutput()->GetPartition(number, 0));
}

double Value(vtkPolyData* horizon, const char* name, vtkIdType point)
{
  return horizon->GetPointData()->GetArray(name)->GetTuple1(point);
}

/// The parabola through 100, 300 and 200 has its vertex a sixth behind the middle.
void CheckLevels(vtkSeismicReflectionExtraction* filter)
{
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfPartitionedDataSets(), 2u);
  vtkPolyData* const dipping = Horizon(filter);
  CHECK_EQUAL(dipping->GetNumberOfPoints(), 30);
  CHECK_EQUAL(dipping->GetNumberOfVerts(), 30);
  CHECK_EQUAL(Value(dipping, "VerticalIndex", 7), 10.0);
  CHECK_EQUAL(Value(dipping, "Thickness", 7), 3.0);
  CHECK_EQUAL(Value(dipping, "Amplitude", 7), 200.0);
  CHECK(std::abs(Value(dipping, "RealZ", 7) - 10.0 - 1.0 / 6.0) < 1e-4);
  CHECK_EQUAL(Value(dipping, "SurfaceId", 7), 1.0);
  CHECK(!dipping->GetPointData()->HasArray("PointCount")); // each point represents itself
  CHECK_EQUAL(dipping->GetPoint(7)[0], 1.0);
  CHECK_EQUAL(dipping->GetPoint(7)[1], 1.0);
  CHECK_EQUAL(dipping->GetPoint(7)[2], Value(dipping, "RealZ", 7));
  CHECK_EQUAL(Value(Horizon(filter, 1), "Amplitude", 0), -200.0);
  CHECK_EQUAL(Value(Horizon(filter, 1), "VerticalIndex", 0), 28.0);
  CHECK_EQUAL(std::string(filter->GetHorizonName(1)), "Horizon 2");
}

/// Numbers of any type; the active scalars, the array Amplitude, or the one that is chosen.
void TestArrays()
{
  Filter floats = MakeFilter(MakeCube<vtkFloatArray>());
  floats->Update();
  CheckLevels(floats);
  Filter shorts = MakeFilter(MakeCube<vtkShortArray>());
  shorts->Update();
  CheckLevels(shorts);
  Image image = MakeCube<vtkDoubleArray>("seismic");
  image->GetPointData()->SetActiveScalars("seismic");
  Filter doubles = MakeFilter(image);
  doubles->Update();
  CheckLevels(doubles);
  image->GetPointData()->SetActiveScalars(nullptr);
  Filter chosen = MakeFilter(image);
  chosen->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "seismic");
  chosen->Update();
  CheckLevels(chosen);
}

void CheckRefused(vtkSeismicReflectionExtraction* filter, const std::string& message)
{
  const Errors errors(filter);
  filter->Update();
  CHECK_EQUAL(errors.Count(), std::size_t(1));
  if (!CHECK(errors.FirstContains(": " + message)))
  {
    std::cerr << "expected: " << message << '\n';
  }
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfPartitionedDataSets(), 0u);
}

void TestParameters()
{
  Filter filter = MakeFilter(MakeCube<vtkFloatArray>());
  filter->SetPolarity(vtkSeismicReflectionExtraction::Negative);
  filter->SetZFrom(vtkSeismicReflectionExtraction::VerticalIndex);
  filter->Update();
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfPartitionedDataSets(), 1u);
  CHECK_EQUAL(Horizon(filter)->GetPoint(0)[2], 28.0);
  filter->SetPolarity(vtkSeismicReflectionExtraction::Positive);
  filter->SetPosition(vtkSeismicReflectionExtraction::Middle);
  filter->SetThresholdType(vtkSeismicReflectionExtraction::Amplitude);
  filter->SetAmplitudeThreshold(200.0);
  filter->Update();
  CHECK_EQUAL(Value(Horizon(filter), "RealZ", 0), 9.5);
  CHECK_EQUAL(Value(Horizon(filter), "Thickness", 0), 2.0);
  CHECK_EQUAL(Value(Horizon(filter), "Amplitude", 0), 250.0);
  filter->SetJoining(vtkSeismicReflectionExtraction::Components);
  filter->SetConnectivity(vtkSeismicReflectionExtraction::Eight);
  filter->SetLargestStep(0.5); // less than the dip: rows of five
  filter->Update();
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfPartitionedDataSets(), 6u);
  filter->SetLargestNumber(4);
  filter->Update();
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfPartitionedDataSets(), 4u);
  filter->SetSmallestSize(6);
  CheckRefused(filter, "no points, expected those of a horizon");
}

void TestFound()
{
  Filter filter = MakeFilter(MakeCube<vtkFloatArray>());
  CHECK_EQUAL(std::string(filter->GetDescription()), "");
  filter->Update();
  CHECK_EQUAL(filter->GetNumberOfSurfaces(), 2);
  CHECK_EQUAL(filter->GetDominantPeriod(), 6.0);
  const std::string found = filter->GetDescription();
  const auto has = [&found](const char* text) { return found.find(text) != std::string::npos; };
  CHECK(has("1200 samples, 60 picks of an amplitude of 0 or more\n"));
  CHECK(has("dominant period 6 samples, largest step 2\n"));
  CHECK(has("median correlation of links 0.") && !has("median correlation of links 0.0"));
}

/// Hidden points and nan are no samples.
void TestBlanked()
{
  Image image = MakeCube<vtkDoubleArray>();
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfValues(image->GetNumberOfPoints());
  ghosts->FillValue(0);
  for (int k = 0; k < Size[2]; ++k)
  {
    ghosts->SetValue(k * Size[0] * Size[1], vtkDataSetAttributes::HIDDENPOINT); // column (0, 0)
    image->GetPointData()->GetArray("Amplitude")->SetComponent(k * Size[0] * Size[1] + 1, 0, Missing); // column (1, 0)
    ghosts->SetValue(k * Size[0] * Size[1] + 2, vtkDataSetAttributes::DUPLICATEPOINT); // not hidden
  }
  image->GetPointData()->AddArray(ghosts);
  Filter filter = MakeFilter(image);
  filter->Update();
  CHECK(std::string(filter->GetDescription()).find("1120 samples, ") == 0);
  CHECK_EQUAL(Horizon(filter)->GetNumberOfPoints(), 28);
  CHECK_EQUAL(Horizon(filter)->GetPoint(0)[0], 2.0);
}

void CheckMap(vtkPolyData* horizon, const double (&expected)[16])
{
  double found[16];
  horizon->GetFieldData()->GetArray("LatticeToWorld")->GetTuple(0, found);
  for (int n = 0; n < 16; ++n)
  {
    CHECK(std::abs(found[n] - expected[n]) < 1e-9);
  }
}

/// Without a lattice: that of the image, from its first point on, turned by a quarter, and downwards.
void TestImageLattice()
{
  Image image = MakeCube<vtkFloatArray>();
  image->SetExtent(10, 15, 20, 24, 30, 69);
  image->SetOrigin(1000.0, 2000.0, -500.0);
  image->SetSpacing(25.0, 12.5, -4.0);
  image->SetDirectionMatrix(0, -1, 0, 1, 0, 0, 0, 0, 1);
  Filter filter = MakeFilter(image);
  filter->Update();
  vtkPolyData* const horizon = Horizon(filter);
  CheckMap(horizon, { 0, -12.5, 0, 750, 25, 0, 0, 2250, 0, 0, -4, -620, 0, 0, 0, 1 });
  CHECK_EQUAL(horizon->GetFieldData()->GetArray("VerticalDirection")->GetTuple1(0), -1.0);
  CHECK_EQUAL(horizon->GetFieldData()->GetArray("LatticeDimensions")->GetComponent(0, 2), 40.0);
  CHECK_EQUAL(Value(horizon, "VerticalIndex", 0), 9.0);
  CHECK(std::abs(Value(horizon, "RealZ", 0) - (620.0 + 4.0 * (9.0 + 1.0 / 6.0))) < 1e-3);
  CHECK_EQUAL(horizon->GetPoint(0)[0], 750.0);
  CHECK_EQUAL(horizon->GetPoint(1)[1], 2275.0);
  CHECK_EQUAL(horizon->GetPoint(0)[2], -Value(horizon, "RealZ", 0));
}

/// The lattice of the survey, of which the image is a window; the description of the survey passes.
Image MakeWindow()
{
  Image image = MakeCube<vtkFloatArray>();
  image->SetExtent(10, 15, 20, 24, 30, 69);
  image->SetOrigin(1000.0, 2000.0, -500.0);
  image->SetSpacing(25.0, 12.5, 4.0);
  image->SetDirectionMatrix(0.6, -0.8, 0, 0.8, 0.6, 0, 0, 0, -1);
  vtkNew<vtkPolyData> carrier;
  vtkNew<vtkMatrix4x4> map;
  const double rows[16] = { 15, -10, 0, 1000, 20, 7.5, 0, 2000, 0, 0, -4, -500, 0, 0, 0, 1 };
  map->DeepCopy(rows);
  const int dimensions[3] = { 100, 50, 70 };
  AddLattice(carrier, dimensions, map);
  vtkNew<vtkStringArray> unit;
  unit->SetName("VerticalUnit");
  unit->InsertNextValue("ms");
  carrier->GetFieldData()->AddArray(unit);
  vtkNew<vtkDoubleArray> lines;
  lines->SetName("LineNumbers");
  lines->SetNumberOfComponents(4);
  lines->InsertNextTuple4(100, 1, 200, 2);
  carrier->GetFieldData()->AddArray(lines);
  image->GetFieldData()->ShallowCopy(carrier->GetFieldData());
  return image;
}

void TestSurveyLattice()
{
  Filter filter = MakeFilter(MakeWindow());
  filter->Update();
  vtkPolyData* const horizon = Horizon(filter);
  CheckMap(horizon, { 15, -10, 0, 1000, 20, 7.5, 0, 2000, 0, 0, -4, -500, 0, 0, 0, 1 });
  CHECK_EQUAL(horizon->GetFieldData()->GetArray("LatticeDimensions")->GetComponent(0, 0), 100.0);
  CHECK_EQUAL(Value(horizon, "VerticalIndex", 0), 39.0);
  CHECK(std::abs(Value(horizon, "RealZ", 0) - (500.0 + 4.0 * (39.0 + 1.0 / 6.0))) < 1e-3);
  CHECK(std::abs(horizon->GetPoint(0)[0] - (1000.0 + 150.0 - 200.0)) < 1e-9);
  auto* const unit = vtkStringArray::SafeDownCast(horizon->GetFieldData()->GetAbstractArray("VerticalUnit"));
  CHECK(unit && unit->GetValue(0) == "ms");
  CHECK(horizon->GetFieldData()->HasArray("LineNumbers"));
  // The stages follow.
  vtkNew<vtkHorizonExteriorBoundary> boundary;
  const Errors errors(boundary);
  boundary->SetInputConnection(filter->GetOutputPort());
  boundary->Update();
  CHECK_EQUAL(errors.Count(), std::size_t(0));
}

/// Horizons are dealt out to pieces, and each is made of the whole cube.
void TestPieces()
{
  Filter filter = MakeFilter(MakeCube<vtkFloatArray>());
  filter->UpdatePiece(1, 2, 0);
  CHECK(Horizon(filter, 0) == nullptr);
  CHECK_EQUAL(Horizon(filter, 1)->GetNumberOfPoints(), 30);
  filter->SetHorizonStatus("Horizon 2", 0);
  filter->UpdatePiece(0, 1, 0);
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfPartitionedDataSets(), 1u);
}

void TestWrongArrays()
{
  auto bare = Image::New();
  bare->SetDimensions(Size);
  CheckRefused(MakeFilter(bare), "no active scalars and no array Amplitude at the points of the image");
  Filter named = MakeFilter(bare);
  named->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "none");
  CheckRefused(named, "no point array none of numbers, expected one with amplitudes");
  // That of another source, which scripts of ParaView name, is not there: the cube has its own.
  Filter other = MakeFilter(MakeCube<vtkFloatArray>());
  other->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "VerticalIndex");
  Errors warnings(other, vtkCommand::WarningEvent);
  other->Update();
  CHECK(warnings.FirstContains("no point array VerticalIndex in the image: amplitudes are those of Amplitude"));
  CHECK_EQUAL(Horizon(other)->GetNumberOfPoints(), 30);
  Filter cells = MakeFilter(MakeCube<vtkFloatArray>());
  cells->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Amplitude");
  CheckRefused(cells, "amplitudes of cells, expected a point array");
  Image vectors = Image::New();
  vectors->SetDimensions(Size);
  vectors->AllocateScalars(VTK_FLOAT, 3);
  CheckRefused(MakeFilter(vectors), "array ImageScalars of 3 components, expected amplitudes, one for each point");
  Image few = MakeCube<vtkFloatArray>();
  few->GetPointData()->GetArray("Amplitude")->SetNumberOfTuples(7);
  CheckRefused(MakeFilter(few), "array Amplitude of 7 tuples, expected one for each of the 1200 points");
  Image blank = MakeCube<vtkDoubleArray>();
  blank->GetPointData()->GetArray("Amplitude")->Fill(Missing);
  CheckRefused(MakeFilter(blank), "no amplitude: all samples of the cube are blanked or not finite, expected numbers");
}

void TestWrongImages()
{
  Image map = Image::New();
  map->SetDimensions(6, 5, 1);
  map->AllocateScalars(VTK_FLOAT, 1);
  CheckRefused(MakeFilter(map), "an image of 6 x 5 x 1 points, expected traces of two samples or more along k");
  Image tilted = MakeCube<vtkFloatArray>();
  tilted->SetDirectionMatrix(1, 0, 0, 0, 0, -1, 0, 1, 0);
  CheckRefused(MakeFilter(tilted), "an image whose k axis is not vertical");
  Image flat = MakeCube<vtkFloatArray>();
  flat->SetSpacing(1.0, 0.0, 1.0);
  CheckRefused(MakeFilter(flat), "");
  Image beyond = MakeWindow();
  beyond->SetExtent(10, 15, 20, 24, 31, 70);
  CheckRefused(MakeFilter(beyond), "an image of the extent 31 to 70 along axis 2, expected 0 to 69 as");
  Image moved = MakeWindow();
  moved->SetOrigin(1020.0, 2000.0, -500.0);
  CheckRefused(MakeFilter(moved), "a point of the image is ");
  Image half = MakeWindow();
  half->GetFieldData()->RemoveArray("LatticeDimensions");
  CheckRefused(MakeFilter(half), "no field data array LatticeDimensions");
}

void TestWrongParameters()
{
  const auto refuse = [](auto&& change, const std::string& message)
  {
    Filter filter = MakeFilter(MakeCube<vtkFloatArray>());
    change(filter);
    CheckRefused(filter, message);
  };
  refuse([](Filter& filter) { filter->SetAmplitudePercentile(100.5); }, "AmplitudePercentile 100.5, expected 0 to 100");
  refuse([](Filter& filter) { filter->SetAmplitudeThreshold(Missing); }, "AmplitudeThreshold nan, expected a finite");
  refuse([](Filter& filter) { filter->SetLargestStep(-1.0); }, "LargestStep -1, expected 0 to 262143 samples");
  refuse([](Filter& filter) { filter->SetSmallestCorrelation(2.0); }, "SmallestCorrelation 2, expected 0 to 1");
  refuse([](Filter& filter) { filter->SetSmallestContact(Missing); }, "SmallestContact nan, expected 0 to 1");
  refuse([](Filter& filter) { filter->SetSmallestSize(-1); }, "SmallestSize -1, expected at least 0 picks");
  refuse([](Filter& filter) { filter->SetGuideTolerance(-1.0); }, "GuideTolerance -1, expected 0 to 262143 samples");
  refuse([](Filter& filter) { filter->SetGrowthCorrelation(2.0); }, "GrowthCorrelation 2, expected 0 to 1");
  refuse([](Filter& filter) { filter->SetGrowthReach(-1); }, "GrowthReach -1, expected at least 0 columns");
  refuse([](Filter& filter) { filter->SetLargestNumber(-3); }, "LargestNumber -3, expected at least 1 surface");
}
}

int TestSeismicReflectionExtraction(int, char*[])
{
  TestArrays();
  TestParameters();
  TestFound();
  TestBlanked();
  TestImageLattice();
  TestSurveyLattice();
  TestPieces();
  TestWrongArrays();
  TestWrongImages();
  TestWrongParameters();
  return Check::Result();
}
