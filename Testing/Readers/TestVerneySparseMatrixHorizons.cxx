// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The reader of sparse-matrix files: which horizons are read, of those that are chosen, and by which process; and
// horizons and rows at a time, with the least memory.

#include "SparseMatrixFixtures.h"
#include "Tools/Check.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkVerneySparseMatrixReader.h"

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <string>
#include <vector>

using namespace SparseMatrixFixtures;

namespace
{
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

// ---- Several processes -------------------------------------------------------------------------------------------
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
  for (const int source : { vtkVerneySparseMatrixReader::VerticalIndex, vtkVerneySparseMatrixReader::RealZ })
  {
    vtkNew<vtkVerneySparseMatrixReader> plain;
    plain->SetFileName(file.c_str());
    plain->SetZFrom(source);
    plain->Update();
    reader->SetZFrom(source);
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
  Messages errors(reader);
  reader->SetSmallestHorizonSize(3);
  reader->Update();
  CHECK(errors.WasOne("least.vsm: no points, expected those of a horizon"));
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

int TestVerneySparseMatrixHorizons(int argc, char* argv[])
{
  Folder = MakeFolder(argc, argv, "TestVerneySparseMatrixHorizons");
  LeastMemoryGivesTheSame();
  LeastMemoryTakesRowsAndHorizons();
  SelectionIsObeyed();
  SelectionMayComeFirstAndOutlivesTheFile();
  SelectionOutlivesAWindow();
  ChoosingAmongManyHorizonsIsQuick();
  HorizonsComeInNumericalOrder();
  EqualHorizonsAreDealtOutInTurn();
  HorizonsAreDealtOutBySize();
  std::filesystem::remove_all(Folder);
  return Check::Result();
}
