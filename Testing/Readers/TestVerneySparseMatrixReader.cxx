// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The reader of sparse-matrix files: the datasets it makes, and its parameters.

#include "SparseMatrixFixtures.h"
#include "Tools/Check.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTestUtilities.h"
#include "vtkVerneySparseMatrixReader.h"

#include <cmath>
#include <filesystem>
#include <limits>
#include <sstream>
#include <string>

using namespace SparseMatrixFixtures;

namespace
{
// ---- Datasets ----------------------------------------------------------------------------------------------------
void ArraysAreComplete()
{
  vtkNew<vtkVerneySparseMatrixReader> reader;
  reader->SetFileName(WriteFile("small.vsm", Small).c_str());
  reader->Update();
  CHECK(reader->GetOutput()->GetNumberOfPartitionedDataSets() == 2);
  CHECK(GetName(reader, 0) == "Horizon 2" && GetName(reader, 1) == "Horizon 7");
  vtkPolyData* const horizon = GetHorizon(reader, 1);
  vtkPointData* const data = horizon->GetPointData();
  CHECK(horizon->GetNumberOfPoints() == 2 && horizon->GetPoints()->GetDataType() == VTK_DOUBLE);
  CHECK(data->GetNumberOfArrays() == 7);
  CHECK(GetArray<vtkFloatArray>(data, "Depth", 2, 1)->GetValue(1) == float(-horizon->GetPoint(1)[2]));
  const auto* const column = GetArray<vtkIntArray>(data, "Column", 2, 2)->GetPointer(2);
  CHECK(column[0] == 1 && column[1] == 1);
  CHECK(GetArray<vtkIntArray>(data, "SurfaceId", 2, 1)->GetValue(1) == 7);
  CHECK(GetArray<vtkIntArray>(data, "VerticalIndex", 2, 1)->GetValue(1) == 6);
  CHECK(data->GetScalars() == data->GetArray("Depth"));
  CHECK(GetArray<vtkDoubleArray>(data, "Thickness", 2, 1)->GetValue(1) == 3.0);
  CHECK(GetArray<vtkDoubleArray>(data, "Amplitude", 2, 1)->GetValue(1) == -3.0);
  CHECK(GetArray<vtkDoubleArray>(data, "RealZ", 2, 1)->GetValue(1) == 24.25);
  CHECK(horizon->GetNumberOfCells() == 2 && horizon->GetNumberOfVerts() == 2);
  CHECK(horizon->GetCellType(1) == VTK_VERTEX && !horizon->GetVerts()->IsStorage64Bit());
  double point[3];
  horizon->GetPoint(1, point);
  CHECK(point[0] == 1.0 && point[1] == 1.0 && point[2] == -6.0);
}

void FieldDataDescribeTheLattice()
{
  vtkNew<vtkVerneySparseMatrixReader> reader;
  reader->SetFileName(WriteFile("small.vsm", Small).c_str());
  reader->Update();
  vtkFieldData* const data = GetHorizon(reader, 0)->GetFieldData();
  auto dimensions = GetArray<vtkIntArray>(data, "LatticeDimensions", 1, 3);
  CHECK(dimensions->GetValue(0) == 2 && dimensions->GetValue(1) == 2 && dimensions->GetValue(2) == 10);
  auto toWorld = GetArray<vtkDoubleArray>(data, "LatticeToWorld", 1, 16);
  for (int entry = 0; entry < 16; ++entry)
  {
    CHECK(toWorld->GetValue(entry) == (entry == 10 ? -1.0 : entry % 5 == 0 ? 1.0 : 0.0));
  }
  CHECK(GetArray<vtkIntArray>(data, "VerticalDirection", 1, 1)->GetValue(0) == -1);
  CHECK(GetArray<vtkIdTypeArray>(data, "DroppedDuplicates", 1, 1)->GetValue(0) == 1);
  CHECK(GetArray<vtkIdTypeArray>(GetHorizon(reader, 1)->GetFieldData(), "DroppedDuplicates", 1, 1)->GetValue(0) == 0);
}

void RotatedSurveyKeepsDoublePrecision()
{
  const double angle = 0.3;
  const double columnStep[2] = { 25.0 * std::cos(angle), 25.0 * std::sin(angle) };
  const double rowStep[2] = { -12.5 * std::sin(angle), 12.5 * std::cos(angle) };
  vtkNew<vtkVerneySparseMatrixReader> reader;
  reader->SetFileName(WriteFile("small.vsm", Small).c_str());
  reader->SetOrigin(736012.125, 4890345.0625, -100.5);
  reader->SetColumnStep(columnStep[0], columnStep[1]);
  reader->SetRowStep(rowStep[0], rowStep[1]);
  reader->SetVerticalStep(4.25);
  reader->Update();
  vtkPolyData* const horizon = GetHorizon(reader, 1);
  double point[3];
  horizon->GetPoint(1, point); // i = 1, j = 1, k = 6
  CHECK(std::abs(point[0] - (736012.125 + columnStep[0] + rowStep[0])) < 1e-9);
  CHECK(std::abs(point[1] - (4890345.0625 + columnStep[1] + rowStep[1])) < 1e-9);
  CHECK(point[2] == -100.5 - 6 * 4.25);
  const double expected[16] = { columnStep[0], rowStep[0], 0, 736012.125, columnStep[1], rowStep[1], 0, 4890345.0625, 0,
    0, -4.25, -100.5, 0, 0, 0, 1 };
  auto toWorld = GetArray<vtkDoubleArray>(horizon->GetFieldData(), "LatticeToWorld", 1, 16);
  for (int entry = 0; entry < 16; ++entry)
  {
    CHECK(toWorld->GetValue(entry) == expected[entry]);
  }
}

void ZCanBeReal()
{
  vtkNew<vtkVerneySparseMatrixReader> reader;
  reader->SetFileName(WriteFile("small.vsm", Small).c_str());
  reader->SetZFromToRealZ();
  reader->SetVerticalStep(2.0);
  reader->Update();
  CHECK(GetHorizon(reader, 1)->GetPoint(1)[2] == -24.25);
  reader->SetZFromToVerticalIndex();
  reader->Update();
  CHECK(GetHorizon(reader, 1)->GetPoint(1)[2] == -12.0);
  reader->SetZFromToRealZ();
  CHECK(reader->GetZFrom() == vtkVerneySparseMatrixReader::RealZ);
}

void DirectionCanBeUp()
{
  vtkNew<vtkVerneySparseMatrixReader> reader;
  reader->SetFileName(WriteFile("small.vsm", Small).c_str());
  reader->SetOrigin(0.0, 0.0, 100.0);
  reader->SetVerticalDirectionToUp();
  const auto lastHeight = [&reader](double verticalStep)
  {
    reader->SetVerticalStep(verticalStep);
    reader->Update();
    return GetHorizon(reader, 1)->GetPoint(1)[2];
  };
  CHECK(lastHeight(2.0) == 112.0);
  CHECK(lastHeight(-2.0) == 88.0);
  vtkFieldData* const data = GetHorizon(reader, 1)->GetFieldData();
  CHECK(GetArray<vtkIntArray>(data, "VerticalDirection", 1, 1)->GetValue(0) == 1);
  reader->SetZFromToRealZ();
  CHECK(lastHeight(2.0) == 24.25);
  reader->SetVerticalDirectionToDown();
  CHECK(lastHeight(2.0) == -24.25);
  reader->SetZFromToVerticalIndex();
  CHECK(lastHeight(2.0) == 88.0);
}

/// With real z, a height of 1 on the lattice is one vertical index: z is 4 ms per index here, from 100 ms.
void RealZIsFitted()
{
  vtkNew<vtkVerneySparseMatrixReader> reader;
  reader->SetFileName(
    WriteFile("fit.vsm", "2 2 10\n3 1 1 1 112\n4 1 1 1 116\n7 1 1 1 128 2 5 1 1 108\n9 5 1 1 136\n").c_str());
  reader->SetZFromToRealZ();
  reader->SetOrigin(10.0, 20.0, 30.0);
  reader->Update();
  auto toWorld = GetArray<vtkDoubleArray>(GetHorizon(reader, 0)->GetFieldData(), "LatticeToWorld", 1, 16);
  CHECK(std::abs(toWorld->GetValue(10) + 4.0) < 1e-12);
  CHECK(std::abs(toWorld->GetValue(11) + 100.0) < 1e-12);
  CHECK(toWorld->GetValue(3) == 10.0 && toWorld->GetValue(7) == 20.0);
  // It is the same line for all horizons, and it is not there when real z is the same everywhere.
  auto other = GetArray<vtkDoubleArray>(GetHorizon(reader, 1)->GetFieldData(), "LatticeToWorld", 1, 16);
  CHECK(other->GetValue(10) == toWorld->GetValue(10) && other->GetValue(11) == toWorld->GetValue(11));
  reader->SetFileName(WriteFile("flat.vsm", "2 1 10\n3 1 1 1 0\n4 1 1 1 0\n").c_str());
  reader->Update();
  toWorld = GetArray<vtkDoubleArray>(GetHorizon(reader, 0)->GetFieldData(), "LatticeToWorld", 1, 16);
  CHECK(toWorld->GetValue(10) == -1.0 && toWorld->GetValue(11) == 30.0);
}

void ImagesAreMaps()
{
  vtkNew<vtkVerneySparseMatrixReader> reader;
  reader->SetFileName(WriteFile("map.vsm", "4 3 10\n\n\n\n\n\n3 1 1.5 10 12.5\n\n\n\n\n5 1 2 20 20.5\n\n").c_str());
  reader->SetOutputTypeToImages();
  reader->SetOrigin(1000.0, 2000.0, 50.0);
  reader->SetColumnStep(0.0, 25.0);
  reader->SetRowStep(-12.5, 0.0);
  reader->SetVerticalStep(4.0);
  reader->Update();
  auto image = vtkImageData::SafeDownCast(reader->GetOutput()->GetPartitionAsDataObject(0, 0));
  CHECK(image != nullptr);
  // Columns (1, 1) and (2, 2), and the two blank ones beside them.
  int extent[6];
  image->GetExtent(extent);
  CHECK(extent[0] == 1 && extent[1] == 2 && extent[2] == 1 && extent[3] == 2 && extent[4] == 0 && extent[5] == 0);
  vtkPointData* const data = image->GetPointData();
  CHECK(GetArray<vtkDoubleArray>(data, "Elevation", 4, 1)->GetValue(0) == 50.0 - 3 * 4.0);
  CHECK(data->GetScalars() == data->GetArray("Elevation"));
  CHECK(GetArray<vtkDoubleArray>(data, "Amplitude", 4, 1)->GetValue(3) == 20.0);
  CHECK(std::isnan(GetArray<vtkDoubleArray>(data, "RealZ", 4, 1)->GetValue(1)));
  CHECK(GetArray<vtkIntArray>(data, "SurfaceId", 4, 1)->GetValue(3) == 1);
  CHECK(image->IsPointVisible(0) && !image->IsPointVisible(1) && image->IsPointVisible(3));
  CHECK(GetArray<vtkDoubleArray>(image->GetFieldData(), "LatticeToWorld", 1, 16)->GetValue(1) == -12.5);
  double point[3];
  image->GetPoint(3, point); // i = 2, j = 2
  CHECK(std::abs(point[0] - 975.0) < 1e-9 && std::abs(point[1] - 2050.0) < 1e-9 && point[2] == 0.0);

  Messages errors(reader);
  reader->SetRowStep(-12.5, 1.0);
  reader->Update();
  CHECK(errors.WasOne("ColumnStep and RowStep that are not perpendicular, expected perpendicular ones for images"));
  CHECK(IsEmpty(reader));
}

void DuplicatePolicyChoosesTheVoxel()
{
  vtkNew<vtkVerneySparseMatrixReader> reader;
  reader->SetFileName(WriteFile("small.vsm", Small).c_str());
  const auto keptIndex = [&reader]()
  {
    reader->Update();
    CHECK(GetHorizon(reader, 0)->GetNumberOfPoints() == 2);
    return -GetHorizon(reader, 0)->GetPoint(0)[2];
  };
  CHECK(keptIndex() == 5.0);
  reader->SetDuplicatePolicyToTopmost();
  CHECK(keptIndex() == 3.0);
  reader->SetDuplicatePolicyToLowest();
  CHECK(keptIndex() == 5.0);
  reader->SetDuplicatePolicyToStrongestAmplitude();
  CHECK(keptIndex() == 5.0);
  reader->SetFileName(WriteFile("mean.vsm", "2 1 20\n3 1 1 2 5 4 1 3 4 7 8 1 5 6 12\n5 1 1 2 5 6 1 1 1 1\n").c_str());
  reader->SetDuplicatePolicyToMean();
  CHECK(keptIndex() == 5.0); // of 3, 4 and 8
  const auto first = [&reader](const char* name)
  { return GetHorizon(reader, 0)->GetPointData()->GetArray(name)->GetTuple1(0); };
  CHECK(first("Thickness") == 3.0 && first("Amplitude") == 4.0 && first("RealZ") == 8.0);
  CHECK_EQUAL(GetHorizon(reader, 0)->GetFieldData()->GetArray("DroppedDuplicates")->GetTuple1(0), 3.0);
}

void SheetsAreHorizons()
{
  vtkNew<vtkVerneySparseMatrixReader> reader;
  reader->SetFileName(
    WriteFile("sheets.vsm", "3 1 20\n5 3 1 1 5 15 3 1 9 15\n5 3 1 1 5 15 3 1 9 15\n5 3 1 1 5\n").c_str());
  reader->SetDuplicatePolicyToSheets();
  reader->Update();
  CHECK(reader->GetNumberOfHorizons() == 2);
  CHECK(GetName(reader, 0) == "Horizon 3" && GetName(reader, 1) == "Horizon 3 (2)");
  CHECK(GetHorizon(reader, 0)->GetNumberOfPoints() == 3);
  CHECK(GetHorizon(reader, 1)->GetNumberOfPoints() == 2);
  reader->SetHorizonStatus("Horizon 3", 0); // the file is read again, with the same sheets
  reader->Update();
  CHECK(GetHorizon(reader, 0)->GetPoint(0)[2] == -15.0);
  reader->SetHorizonStatus("Horizon 3", 1);
  const auto dropped = [&reader](unsigned n)
  { return GetHorizon(reader, n)->GetFieldData()->GetArray("DroppedDuplicates")->GetTuple1(0); };
  reader->Update();
  CHECK(dropped(0) == 0.0 && dropped(1) == 0.0);
  reader->SetSmallestHorizonSize(3);
  reader->Update();
  CHECK(reader->GetNumberOfHorizons() == 1 && dropped(0) == 2.0);
  Messages errors(reader);
  reader->LeastMemoryOn();
  reader->Update();
  CHECK(errors.WasOne("DuplicatePolicy Sheets with LeastMemory, expected another policy"));
}

void SampleIsRead(const std::string& path)
{
  vtkNew<vtkVerneySparseMatrixReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  CHECK(reader->GetOutput()->GetNumberOfPartitionedDataSets() == 3);
  CHECK(reader->GetOutput()->GetNumberOfPoints() == 6282 + 5957 + 6019);
}

// ---- Parameters --------------------------------------------------------------------------------------------------
template <typename Set>
void CheckParameterRefused(Set set, const std::string& message)
{
  vtkNew<vtkVerneySparseMatrixReader> reader;
  Messages errors(reader);
  reader->SetFileName(WriteFile("small.vsm", Small).c_str());
  set(reader.Get());
  reader->Update();
  CHECK(errors.WasOne(message));
  CHECK(IsEmpty(reader));
}

/// The file has no units, and the user may say them.
void UnitsCanBeGiven()
{
  const std::string file = WriteFile("small.vsm", Small);
  const auto texts = [&file](const char* unit, const char* domain)
  {
    vtkNew<vtkVerneySparseMatrixReader> reader;
    reader->SetFileName(file.c_str());
    reader->SetVerticalUnit(unit);
    reader->SetVerticalDomain(domain);
    reader->Update();
    std::string all;
    for (const char* const name : { "VerticalUnit", "VerticalDomain" })
    {
      auto* const text = vtkStringArray::SafeDownCast(GetHorizon(reader, 0)->GetFieldData()->GetAbstractArray(name));
      all += (text ? std::string(text->GetValue(0)) : "none") + ' ';
    }
    return all;
  };
  CHECK(texts(nullptr, nullptr) == "none none ");
  CHECK(texts("", "") == "none none ");
  CHECK(texts("ms", nullptr) == "ms time ");
  CHECK(texts("metres", nullptr) == "m depth ");
  CHECK(texts("stones", "depth") == "stones depth ");
  CHECK(texts(nullptr, "time") == "none time ");
}

void WrongParametersGiveOneErrorEach()
{
  using Reader = vtkVerneySparseMatrixReader;
  const double infinite = std::numeric_limits<double>::infinity();
  CheckParameterRefused(
    [](Reader* reader) { reader->SetVerticalStep(0.0); }, "VerticalStep (0), expected a finite number other than 0");
  CheckParameterRefused(
    [](Reader* reader) { reader->SetSmallestHorizonSize(0); }, "SmallestHorizonSize 0, expected at least 1 point");
  CheckParameterRefused([](Reader* reader) { reader->SetColumnRange(3, 2); }, "ColumnRange 3 to 2, expected a first");
  CheckParameterRefused([](Reader* reader) { reader->SetRowRange(-1, 2); }, "RowRange -1 to 2, expected a first");
  CheckParameterRefused(
    [](Reader* reader) { reader->SetColumnRange(90, -1); }, "ColumnRange from 90, expected a first");
  CheckParameterRefused([](Reader* reader) { reader->SetRowRange(90, 99); }, "RowRange from 90, expected a first");
  CheckParameterRefused([&](Reader* reader) { reader->SetVerticalStep(infinite); }, "VerticalStep (inf), expected");
  CheckParameterRefused([](Reader* reader) { reader->SetRowStep(-2.0, 0.0); },
    "ColumnStep (1, 0) and RowStep (-2, 0), expected finite vectors that are not parallel");
  CheckParameterRefused([](Reader* reader) { reader->SetColumnStep(0.0, 0.0); }, "ColumnStep (0, 0) and RowStep");
  CheckParameterRefused([&](Reader* reader) { reader->SetColumnStep(infinite, 0.0); }, "ColumnStep (inf, 0) and");
  CheckParameterRefused(
    [&](Reader* reader) { reader->SetOrigin(0.0, infinite, 0.0); }, "Origin (0, inf, 0), expected finite numbers");
}

void PrintListsEveryProperty()
{
  vtkNew<vtkVerneySparseMatrixReader> reader;
  reader->SetFileName("some.vsm");
  reader->SetZFromToRealZ();
  reader->SetOrigin(1.5, 2.5, 3.5);
  reader->SetColumnStep(4.5, 5.5);
  reader->SetRowStep(6.5, 7.5);
  reader->SetVerticalStep(8.5);
  reader->SetVerticalDirectionToUp();
  reader->SetDuplicatePolicyToLowest();
  reader->SetVerticalUnit("ms");
  reader->SetVerticalDomain("time");
  reader->SetHorizonStatus("Horizon 12", 1);
  std::ostringstream stream;
  reader->SetOutputTypeToImages();
  reader->SetVolumeExtentToBoundingBox();
  reader->SetVolumeArrayToThickness();
  reader->Print(stream);
  for (const char* text : { "FileName: some.vsm", "OutputType: Images", "VolumeExtent: BoundingBox",
         "VolumeArray: Thickness", "BackgroundValue: 0", "VolumeMemoryLimit: 2048", "ZFrom: RealZ",
         "Origin: 1.5 2.5 3.5", "ColumnStep: 4.5 5.5", "RowStep: 6.5 7.5", "VerticalStep: 8.5", "VerticalDirection: Up",
         "VerticalUnit: ms", "VerticalDomain: time", "DuplicatePolicy: Lowest", "SmallestHorizonSize: 1",
         "ColumnRange: 0 -1", "RowRange: 0 -1", "HorizonSelection:", "Horizon 12" })
  {
    Check::True(stream.str().find(text) != std::string::npos, text, __FILE__, __LINE__);
  }
}
}

int TestVerneySparseMatrixReader(int argc, char* argv[])
{
  Folder = MakeFolder(argc, argv, "TestVerneySparseMatrixReader");
  ArraysAreComplete();
  FieldDataDescribeTheLattice();
  RotatedSurveyKeepsDoublePrecision();
  ZCanBeReal();
  DirectionCanBeUp();
  RealZIsFitted();
  ImagesAreMaps();
  DuplicatePolicyChoosesTheVoxel();
  SheetsAreHorizons();
  UnitsCanBeGiven();
  WrongParametersGiveOneErrorEach();
  PrintListsEveryProperty();
  SampleIsRead(TakeString(vtkTestUtilities::ExpandDataFileName(argc, argv, "blobs.vsm")));
  std::filesystem::remove_all(Folder);
  return Check::Result();
}
