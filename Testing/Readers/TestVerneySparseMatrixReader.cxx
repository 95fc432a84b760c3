// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The reader of sparse-matrix files: the datasets it makes, its parameters, and its errors.

#include "ReaderFixtures.h"
#include "Tools/Check.h"

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkDataArraySelection.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTestUtilities.h"
#include "vtkVerneySparseMatrixReader.h"

#include <cmath>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

using namespace ReaderFixtures;

namespace
{
// Horizon 2 has two voxels in its first column.
constexpr const char* Small = "2 2 10\n"
                              "3 2 1.5 10 12.5 5 2 2.5 -20 20.5 8 7 1 1 32\n"
                              "4 2 1 1 16\n"
                              "\n"
                              "6 7 3 -3 24.25\n";

/// The folder for files of this test.
std::string Folder;

std::string WriteFile(const std::string& name, const std::string& text)
{
  return WriteText(Folder + "/" + name, text);
}

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
  CHECK(data->GetNumberOfArrays() == 5);
  CHECK(GetArray<vtkIntArray>(data, "SurfaceId", 2, 1)->GetValue(1) == 7);
  CHECK(GetArray<vtkIntArray>(data, "VerticalIndex", 2, 1)->GetValue(1) == 6);
  CHECK(data->GetScalars() == data->GetArray("VerticalIndex"));
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

void ElevationCanBeRealZ()
{
  vtkNew<vtkVerneySparseMatrixReader> reader;
  reader->SetFileName(WriteFile("small.vsm", Small).c_str());
  reader->SetElevationToRealZ();
  reader->SetVerticalStep(2.0);
  reader->Update();
  CHECK(GetHorizon(reader, 1)->GetPoint(1)[2] == -24.25);
  reader->SetElevationToVerticalIndex();
  reader->Update();
  CHECK(GetHorizon(reader, 1)->GetPoint(1)[2] == -12.0);
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
  reader->SetElevationToRealZ();
  CHECK(lastHeight(2.0) == 24.25);
  reader->SetVerticalDirectionToDown();
  CHECK(lastHeight(2.0) == -24.25);
  reader->SetElevationToVerticalIndex();
  CHECK(lastHeight(2.0) == 88.0);
}

/// With real z, a height of 1 on the lattice is one vertical index: z is 4 ms per index here, from 100 ms.
void RealZIsFitted()
{
  vtkNew<vtkVerneySparseMatrixReader> reader;
  reader->SetFileName(
    WriteFile("fit.vsm", "2 2 10\n3 1 1 1 112\n4 1 1 1 116\n7 1 1 1 128 2 5 1 1 108\n9 5 1 1 136\n").c_str());
  reader->SetElevationToRealZ();
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

// ---- Images ------------------------------------------------------------------------------------------------------
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
  Messages errors(reader);
  reader->LeastMemoryOn();
  reader->Update();
  CHECK(errors.WasOne("DuplicatePolicy Sheets with LeastMemory, expected another policy"));
}

// ---- Selection ---------------------------------------------------------------------------------------------------
void SelectionIsObeyed()
{
  vtkNew<vtkVerneySparseMatrixReader> reader;
  reader->SetFileName(WriteFile("small.vsm", Small).c_str());
  reader->UpdateInformation();
  CHECK(reader->GetNumberOfHorizons() == 2);
  CHECK(std::string(reader->GetHorizonName(1)) == "Horizon 7" && !reader->GetHorizonName(2));
  CHECK(reader->GetHorizonStatus("Horizon 2") == 1 && reader->GetHorizonStatus("Horizon 3") == 0);
  reader->SetHorizonStatus("Horizon 2", 0);
  reader->Update();
  CHECK(reader->GetOutput()->GetNumberOfPartitionedDataSets() == 1 && GetName(reader, 0) == "Horizon 7");
  reader->DisableAllHorizons();
  reader->Update();
  CHECK(IsEmpty(reader));
  reader->EnableAllHorizons();
  reader->Update();
  CHECK(reader->GetOutput()->GetNumberOfPartitionedDataSets() == 2);
}

void SelectionMayComeFirstAndOutlivesTheFile()
{
  vtkNew<vtkVerneySparseMatrixReader> reader;
  reader->SetHorizonStatus("Horizon 7", 0);
  reader->SetFileName(WriteFile("small.vsm", Small).c_str());
  reader->Update();
  CHECK(reader->GetOutput()->GetNumberOfPartitionedDataSets() == 1 && GetName(reader, 0) == "Horizon 2");
  reader->SetFileName(WriteFile("other.vsm", "1 1 9\n1 7 1 1 1 2 8 1 1 1\n").c_str());
  reader->Update();
  CHECK(reader->GetNumberOfHorizons() == 2);
  CHECK(reader->GetOutput()->GetNumberOfPartitionedDataSets() == 1 && GetName(reader, 0) == "Horizon 8");
}

/// A window may leave horizons out of the list; they come back as they went.
void SelectionOutlivesAWindow()
{
  vtkNew<vtkVerneySparseMatrixReader> reader;
  reader->SetFileName(WriteFile("window.vsm", "2 1 9\n1 7 1 1 1 2 8 1 1 1\n1 8 1 1 1 3 9 1 1 1\n").c_str());
  reader->Update();
  reader->SetHorizonStatus("Horizon 7", 0);
  reader->SetHorizonStatus("Horizon 8", 0);
  reader->SetColumnRange(1, 1);
  reader->Update();
  CHECK(reader->GetNumberOfHorizons() == 2 && !reader->GetHorizonStatus("Horizon 8"));
  CHECK(reader->GetOutput()->GetNumberOfPartitionedDataSets() == 1 && GetName(reader, 0) == "Horizon 9");
  reader->SetHorizonStatus("Horizon 8", 1);
  const vtkMTimeType before = reader->GetMTime();
  reader->UpdateInformation();
  CHECK(reader->GetMTime() == before); // or the pipeline would run on and on
  reader->SetColumnRange(0, -1);
  reader->Update();
  CHECK(reader->GetOutput()->GetNumberOfPartitionedDataSets() == 2 && GetName(reader, 0) == "Horizon 8");
  reader->SetColumnRange(1, 1);
  reader->Update();
  reader->EnableAllHorizons(); // those that are not listed as well
  reader->SetColumnRange(0, -1);
  reader->Update();
  CHECK(reader->GetOutput()->GetNumberOfPartitionedDataSets() == 3);
}

/// Choosing one of many horizons takes a fraction of a second; comparing all names with all others takes minutes.
void ChoosingAmongManyHorizonsIsQuick()
{
  constexpr int numberOfHorizons = 200000;
  constexpr double mostSeconds = 10.0; // of the processor, so that other programs do not matter
  std::string text = "1 1 " + std::to_string(numberOfHorizons) + '\n';
  for (int id = 0; id < numberOfHorizons; ++id)
  {
    text += std::to_string(id) + ' ' + std::to_string(id) + " 1 1 1 ";
  }
  vtkNew<vtkVerneySparseMatrixReader> reader;
  reader->SetFileName(WriteFile("many.vsm", text).c_str());
  const std::clock_t start = std::clock();
  reader->UpdateInformation();
  reader->DisableAllHorizons();
  reader->SetHorizonStatus("Horizon 7", 1);
  reader->Update();
  CHECK(static_cast<double>(std::clock() - start) < mostSeconds * CLOCKS_PER_SEC);
  CHECK(reader->GetNumberOfHorizons() == numberOfHorizons);
  CHECK(reader->GetOutput()->GetNumberOfPartitionedDataSets() == 1 && GetName(reader, 0) == "Horizon 7");
}

/// By the number, not by the letters of the name, and whatever was chosen before.
void HorizonsComeInNumericalOrder()
{
  vtkNew<vtkVerneySparseMatrixReader> reader;
  reader->SetHorizonStatus("Horizon 10", 1);
  reader->SetFileName(WriteFile("order.vsm", "1 1 9\n1 10 1 1 1 2 2 1 1 1 3 -3 1 1 1 4 1 1 1 1\n").c_str());
  reader->Update();
  const std::vector<std::string> expected = { "Horizon -3", "Horizon 1", "Horizon 2", "Horizon 10" };
  CHECK(reader->GetNumberOfHorizons() == 4);
  for (unsigned int position = 0; position < expected.size(); ++position)
  {
    CHECK(reader->GetHorizonName(static_cast<int>(position)) == expected[position]);
    CHECK(GetName(reader, position) == expected[position]);
  }
}

void FileIsScannedOnlyOnce()
{
  vtkNew<vtkVerneySparseMatrixReader> reader;
  const std::string path = WriteFile("once.vsm", Small);
  reader->SetFileName(path.c_str());
  reader->Update();
  CHECK(reader->GetOutput()->GetNumberOfPartitionedDataSets() == 2);
  int scans = 0;
  vtkNew<vtkCallbackCommand> counter;
  counter->SetClientData(&scans);
  counter->SetCallback([](vtkObject*, unsigned long, void* count, void*) { ++*static_cast<int*>(count); });
  reader->AddObserver(vtkCommand::ProgressEvent, counter);
  reader->Modified();
  reader->UpdateInformation();
  CHECK(scans == 0);
  WriteFile("once.vsm", "1 1 5\n1 33 1 1 1\n"); // another size, should the clock be coarse
  reader->Modified();
  reader->UpdateInformation();
  CHECK(scans > 0);
  CHECK(reader->GetNumberOfHorizons() == 1 && std::string(reader->GetHorizonName(0)) == "Horizon 33");
}

void EqualHorizonsAreDealtOutInTurn()
{
  std::string text = "1 1 9\n";
  for (int id = 1; id <= 5; ++id)
  {
    text += std::to_string(id) + ' ' + std::to_string(id) + " 1 1 1 ";
  }
  vtkNew<vtkVerneySparseMatrixReader> reader;
  reader->SetFileName(WriteFile("five.vsm", text).c_str());
  reader->UpdateInformation();
  reader->SetHorizonStatus("Horizon 1", 0); // 2, 3, 4 and 5 stay
  for (int piece = 0; piece < 3; ++piece)
  {
    reader->UpdatePiece(piece, 3, 0);
    CHECK(reader->GetOutput()->GetNumberOfPartitionedDataSets() == 4);
    for (unsigned int position = 0; position < 4; ++position)
    {
      CHECK(GetName(reader, position) == "Horizon " + std::to_string(position + 2));
      const unsigned int expected = static_cast<int>(position) % 3 == piece ? 1 : 0;
      CHECK(reader->GetOutput()->GetNumberOfPartitions(position) == expected);
      CHECK((GetHorizon(reader, position) != nullptr) == (expected == 1));
    }
  }
}

/// A reader of horizons 1, 2, ... with some numbers of voxels, those of each in the first columns.
vtkSmartPointer<vtkVerneySparseMatrixReader> MakeReaderOfSizes(const std::vector<int>& sizes, bool leastMemory)
{
  const int columns = *std::max_element(sizes.begin(), sizes.end());
  std::string text = std::to_string(columns) + " 2 99\n";
  for (int row = 0; row < 2; ++row)
  {
    for (int column = 0; column < columns; ++column)
    {
      for (std::size_t n = 0; n < sizes.size(); ++n)
      {
        const std::string number = std::to_string(n + 1);
        text += column < sizes[n] ? number + ' ' + number + " 1 1 1 " : "";
      }
      text += '\n';
    }
  }
  auto reader = vtkSmartPointer<vtkVerneySparseMatrixReader>::New();
  reader->SetFileName(WriteFile("sizes.vsm", text).c_str());
  reader->SetLeastMemory(leastMemory);
  reader->UpdateInformation();
  return reader;
}

/// The positions of the horizons that each piece has.
std::vector<std::vector<unsigned int>> Deal(vtkVerneySparseMatrixReader* reader, int pieces)
{
  std::vector<std::vector<unsigned int>> dealt;
  for (int piece = 0; piece < pieces; ++piece)
  {
    reader->UpdatePiece(piece, pieces, 0);
    dealt.emplace_back();
    for (unsigned int n = 0; n < reader->GetOutput()->GetNumberOfPartitionedDataSets(); ++n)
    {
      if (GetHorizon(reader, n))
      {
        dealt.back().push_back(n);
      }
    }
  }
  return dealt;
}

void HorizonsAreDealtOutBySize()
{
  using Positions = std::vector<std::vector<unsigned int>>;
  for (const bool leastMemory : { false, true })
  {
    const auto reader = MakeReaderOfSizes({ 3, 9, 5, 8, 4 }, leastMemory);
    CHECK(Deal(reader, 2) == Positions({ { 0, 1, 4 }, { 2, 3 } }));
    CHECK(Deal(reader, 1) == Positions({ { 0, 1, 2, 3, 4 } }));
    CHECK(Deal(reader, 7) == Positions({ { 1 }, { 3 }, { 2 }, { 4 }, { 0 }, {}, {} }));
    reader->SetHorizonStatus("Horizon 2", 0); // 3, 5, 8 and 4 stay
    CHECK(Deal(reader, 2) == Positions({ { 0, 2 }, { 1, 3 } }));
    reader->EnableAllHorizons();
    reader->SetColumnRange(0, 3); // 3, 4, 4, 4 and 4 in each row
    CHECK(Deal(reader, 2) == Positions({ { 0, 1, 3 }, { 2, 4 } }));
  }
}

// ---- Errors ------------------------------------------------------------------------------------------------------
/// Checks that a path gives one error with its name, at each attempt, and takes the last result away.
void CheckRefused(const std::string& path, const std::string& message)
{
  vtkNew<vtkVerneySparseMatrixReader> reader;
  Messages errors(reader);
  reader->SetFileName(WriteFile("good.vsm", Small).c_str());
  reader->Update();
  CHECK(!IsEmpty(reader));
  reader->SetFileName(path.c_str());
  for (int attempt = 0; attempt < 2; ++attempt)
  {
    reader->Update();
    CHECK(errors.WasOne("): " + path + ": " + message));
    CHECK(IsEmpty(reader));
  }
}

void WrongFilesGiveOneErrorEach()
{
  CheckRefused(Folder + "/missing.vsm", "nothing there, expected a file");
  CheckRefused(Folder, "a directory, expected a file");
  CheckRefused(WriteFile("wrong.vsm", ""), "line 1: empty file, expected three positive integers \"nX nY nZ\"");
  CheckRefused(WriteFile("wrong.vsm", "1 1\n\n"), "line 1: header \"1 1\", expected three positive integers");
  CheckRefused(WriteFile("wrong.vsm", "1 1 5\n1 1 1 1 x\n"), "line 2: real z \"x\", expected a number");
  CheckRefused(
    WriteFile("wrong.vsm", "1 1 5\n5 1 1 1 1\n"), "line 2: vertical index \"5\", expected an integer from 0 to 4");
  CheckRefused(WriteFile("wrong.vsm", "1 1 5\n5 1 1\n"), "line 2: vertical index \"5\"");
  CheckRefused(WriteFile("wrong.vsm", "1 1 5\n4 1 1\n"), "line 2: 3 values, expected a multiple of 5");
  CheckRefused(WriteFile("wrong.vsm", "2 2 5\n\n\n"), "line 4: end of file after 3 columns, expected 4");
}

void MissingFileNameIsAnError()
{
  vtkNew<vtkVerneySparseMatrixReader> reader;
  Messages errors(reader);
  reader->Update();
  CHECK(errors.WasOne("no FileName, expected the path of a file"));
}

void FileThatTurnsWrongIsAnError()
{
  vtkNew<vtkVerneySparseMatrixReader> reader;
  Messages errors(reader);
  const std::string path = WriteFile("turning.vsm", Small);
  reader->SetFileName(path.c_str());
  reader->UpdateInformation();
  std::filesystem::remove(path);
  reader->Update();
  CHECK(errors.WasOne(path + ": nothing there, expected a file"));
  CHECK(IsEmpty(reader));
}

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
  CheckParameterRefused([&](Reader* reader) { reader->SetVerticalStep(infinite); }, "VerticalStep (inf), expected");
  CheckParameterRefused([](Reader* reader) { reader->SetRowStep(-2.0, 0.0); },
    "ColumnStep (1, 0) and RowStep (-2, 0), expected finite vectors that are not parallel");
  CheckParameterRefused([](Reader* reader) { reader->SetColumnStep(0.0, 0.0); }, "ColumnStep (0, 0) and RowStep");
  CheckParameterRefused([&](Reader* reader) { reader->SetColumnStep(infinite, 0.0); }, "ColumnStep (inf, 0) and");
  CheckParameterRefused(
    [&](Reader* reader) { reader->SetOrigin(0.0, infinite, 0.0); }, "Origin (0, inf, 0), expected finite numbers");
}

void CanReadFileLooksAtTheHeader()
{
  vtkNew<vtkVerneySparseMatrixReader> reader;
  CHECK(reader->CanReadFile(WriteFile("header.txt", "2 2 10\nwhatever").c_str()) == 1);
  CHECK(reader->CanReadFile(WriteFile("header.txt", "\xEF\xBB\xBF 2 2 10").c_str()) == 1);
  CHECK(reader->CanReadFile(WriteFile("header.txt", "2 2 10 4\n").c_str()) == 0);
  CHECK(reader->CanReadFile(WriteFile("header.txt", "2 2\n").c_str()) == 0);
  CHECK(reader->CanReadFile(WriteFile("header.txt", "").c_str()) == 0);
  CHECK(reader->CanReadFile(Folder.c_str()) == 0);
  CHECK(reader->CanReadFile((Folder + "/missing.txt").c_str()) == 0);
  CHECK(reader->CanReadFile("vsm") == 0);
  CHECK(reader->CanReadFile(nullptr) == 0);
}

/// So that it is the reader that says what is wrong with them.
void CanReadFileTakesAllFilesOfItsName()
{
  vtkNew<vtkVerneySparseMatrixReader> reader;
  CHECK(reader->CanReadFile(WriteFile("empty.vsm", "").c_str()) == 1);
  CHECK(reader->CanReadFile(WriteFile("zipped.VSM", "\x1F\x8B\x08").c_str()) == 1);
  CHECK(reader->CanReadFile((Folder + "/missing.vSm").c_str()) == 1);
}

// ---- The rest ----------------------------------------------------------------------------------------------------
void AbortLeavesTheOutputEmpty()
{
  vtkNew<vtkVerneySparseMatrixReader> reader;
  Messages errors(reader);
  reader->SetFileName(WriteFile("small.vsm", Small).c_str());
  reader->Update();
  vtkNew<vtkCallbackCommand> aborter;
  aborter->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { vtkVerneySparseMatrixReader::SafeDownCast(caller)->SetAbortExecute(1); });
  const unsigned long tag = reader->AddObserver(vtkCommand::ProgressEvent, aborter);
  reader->Modified();
  reader->Update();
  CHECK(IsEmpty(reader));
  reader->SetFileName(WriteFile("other.vsm", "1 1 9\n1 7 1 1 1 2 8 1 1 1\n").c_str()); // to be scanned as well
  reader->Update();
  CHECK(IsEmpty(reader));
  reader->RemoveObserver(tag);
  reader->SetAbortExecute(0);
  reader->Modified();
  reader->Update();
  CHECK(reader->GetOutput()->GetNumberOfPartitionedDataSets() == 2);
}

void PrintListsEveryProperty()
{
  vtkNew<vtkVerneySparseMatrixReader> reader;
  reader->SetFileName("some.vsm");
  reader->SetElevationToRealZ();
  reader->SetOrigin(1.5, 2.5, 3.5);
  reader->SetColumnStep(4.5, 5.5);
  reader->SetRowStep(6.5, 7.5);
  reader->SetVerticalStep(8.5);
  reader->SetVerticalDirectionToUp();
  reader->SetDuplicatePolicyToLowest();
  reader->SetHorizonStatus("Horizon 12", 1);
  std::ostringstream stream;
  reader->SetOutputTypeToImages();
  reader->SetVolumeExtentToBoundingBox();
  reader->SetVolumeArrayToThickness();
  reader->Print(stream);
  for (const char* text : { "FileName: some.vsm", "OutputType: Images", "VolumeExtent: BoundingBox",
         "VolumeArray: Thickness", "BackgroundValue: 0", "VolumeMemoryLimit: 2048", "Elevation: RealZ",
         "Origin: (1.5, 2.5, 3.5)", "ColumnStep: (4.5, 5.5)", "RowStep: (6.5, 7.5)", "VerticalStep: 8.5",
         "VerticalDirection: Up", "DuplicatePolicy: Lowest", "SmallestHorizonSize: 1", "ColumnRange: 0 to -1",
         "RowRange: 0 to -1", "HorizonSelection:", "Horizon 12" })
  {
    Check::True(stream.str().find(text) != std::string::npos, text, __FILE__, __LINE__);
  }
}

void SampleIsRead(const std::string& path)
{
  vtkNew<vtkVerneySparseMatrixReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  CHECK(reader->GetOutput()->GetNumberOfPartitionedDataSets() == 3);
  CHECK(reader->GetOutput()->GetNumberOfPoints() == 6282 + 5957 + 6019);
}

// ---- Least memory ------------------------------------------------------------------------------------------------
void LeastMemoryGivesTheSame()
{
  const std::string file = WriteFile("least.vsm", Small);
  vtkNew<vtkVerneySparseMatrixReader> reader;
  reader->SetFileName(file.c_str());
  CHECK(!reader->GetLeastMemory() && reader->GetNumberOfRows() == 0);
  reader->LeastMemoryOn();
  CHECK(reader->GetNumberOfPointsInRows("Horizon 2", 0, 1) == 0);
  reader->UpdateInformation();
  CHECK(reader->GetNumberOfHorizons() == 2 && reader->GetNumberOfRows() == 2);
  CHECK(reader->GetNumberOfPointsInRows("Horizon 2", 0, 1) == 2);
  CHECK(reader->GetNumberOfPointsInRows("Horizon 7", 0, 0) == 1);
  CHECK(reader->GetNumberOfPointsInRows("Horizon 7", 1, 1) == 1);
  CHECK(reader->GetNumberOfPointsInRows("Horizon 7", 1, 0) == 0);
  CHECK(reader->GetNumberOfPointsInRows("Horizon 3", 0, 1) == 0);
  CHECK(reader->GetNumberOfPointsInRows(nullptr, 0, 1) == 0);
  for (const int elevation : { vtkVerneySparseMatrixReader::VerticalIndex, vtkVerneySparseMatrixReader::RealZ })
  {
    vtkNew<vtkVerneySparseMatrixReader> plain;
    plain->SetFileName(file.c_str());
    plain->SetElevation(elevation);
    plain->Update();
    reader->SetElevation(elevation);
    reader->Update();
    for (int number = 0; number < 2; ++number)
    {
      vtkPolyData* const found = GetHorizon(reader, number);
      vtkPolyData* const expected = GetHorizon(plain, number);
      CHECK(found->GetNumberOfPoints() == expected->GetNumberOfPoints());
      CHECK(std::string(found->GetPointData()->GetArrayName(2)) == expected->GetPointData()->GetArrayName(2));
      for (vtkIdType point = 0; point < found->GetNumberOfPoints(); ++point)
      {
        CHECK(found->GetPoint(point)[2] == expected->GetPoint(point)[2]);
      }
      for (int n = 0; n < 16; ++n)
      {
        CHECK(found->GetFieldData()->GetArray("LatticeToWorld")->GetComponent(0, n) ==
          expected->GetFieldData()->GetArray("LatticeToWorld")->GetComponent(0, n));
      }
      CHECK(found->GetFieldData()->GetArray("DroppedDuplicates")->GetTuple1(0) ==
        expected->GetFieldData()->GetArray("DroppedDuplicates")->GetTuple1(0));
    }
  }
}

void LeastMemoryTakesRowsAndHorizons()
{
  vtkNew<vtkVerneySparseMatrixReader> reader;
  reader->SetFileName(WriteFile("least.vsm", Small).c_str());
  reader->LeastMemoryOn();
  reader->SetRowRange(1, 1);
  reader->Update();
  CHECK(reader->GetNumberOfHorizons() == 1 && GetName(reader, 0) == "Horizon 7");
  CHECK(GetHorizon(reader, 0)->GetNumberOfPoints() == 1);
  reader->SetRowRange(0, -1);
  reader->Update(); // the list is that of all rows again
  CHECK(reader->GetNumberOfHorizons() == 2);
  reader->SetSmallestHorizonSize(3);
  reader->Update();
  CHECK(reader->GetOutput()->GetNumberOfPartitionedDataSets() == 0);
  reader->SetSmallestHorizonSize(1);
  reader->UpdateInformation();
  reader->EnableAllHorizons();
  reader->SetHorizonStatus("Horizon 7", 0);
  reader->Update();
  CHECK(reader->GetOutput()->GetNumberOfPartitionedDataSets() == 1 && GetName(reader, 0) == "Horizon 2");
  reader->DisableAllHorizons();
  reader->Update();
  CHECK(reader->GetOutput()->GetNumberOfPartitionedDataSets() == 0);
  reader->EnableAllHorizons();
  reader->LeastMemoryOff();
  reader->Update();
  CHECK(reader->GetOutput()->GetNumberOfPartitionedDataSets() == 2 && reader->GetNumberOfRows() == 0);
}
}

int TestVerneySparseMatrixReader(int argc, char* argv[])
{
  Folder = MakeFolder(argc, argv, "TestVerneySparseMatrixReader");
  ArraysAreComplete();
  LeastMemoryGivesTheSame();
  LeastMemoryTakesRowsAndHorizons();
  FieldDataDescribeTheLattice();
  RotatedSurveyKeepsDoublePrecision();
  ElevationCanBeRealZ();
  DirectionCanBeUp();
  RealZIsFitted();
  ImagesAreMaps();
  DuplicatePolicyChoosesTheVoxel();
  SheetsAreHorizons();
  SelectionIsObeyed();
  SelectionMayComeFirstAndOutlivesTheFile();
  SelectionOutlivesAWindow();
  ChoosingAmongManyHorizonsIsQuick();
  HorizonsComeInNumericalOrder();
  FileIsScannedOnlyOnce();
  EqualHorizonsAreDealtOutInTurn();
  HorizonsAreDealtOutBySize();
  WrongFilesGiveOneErrorEach();
  MissingFileNameIsAnError();
  FileThatTurnsWrongIsAnError();
  WrongParametersGiveOneErrorEach();
  CanReadFileLooksAtTheHeader();
  CanReadFileTakesAllFilesOfItsName();
  AbortLeavesTheOutputEmpty();
  PrintListsEveryProperty();
  SampleIsRead(TakeString(vtkTestUtilities::ExpandDataFileName(argc, argv, "sample.vsm")));
  std::filesystem::remove_all(Folder);
  return Check::Result();
}
