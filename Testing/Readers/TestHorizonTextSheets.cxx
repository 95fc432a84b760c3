// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The reader of text files, where horizons lie above themselves: each sheet is a horizon; and where their z count to.

#include "ReaderFixtures.h"
#include "Tools/Check.h"

#include "vtkDataArray.h"
#include "vtkHorizonTextReader.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

using namespace ReaderFixtures;

namespace
{
std::string Folder;

std::string WriteFile(const std::string& name, const std::string& text)
{
  return WriteText(Folder + "/" + name, text);
}

std::vector<double> ListZ(vtkHorizonTextReader* reader, unsigned int number)
{
  std::vector<double> z;
  vtkDataArray* const array = GetHorizon(reader, number)->GetPointData()->GetArray("RealZ");
  for (vtkIdType point = 0; point < array->GetNumberOfTuples(); ++point)
  {
    z.push_back(array->GetTuple1(point));
  }
  return z;
}

double FirstId(vtkHorizonTextReader* reader, unsigned int number)
{
  return GetHorizon(reader, number)->GetPointData()->GetArray("SurfaceId")->GetTuple1(0);
}

/// Those of a horizon follow each other, and have its number.
void SheetsAreHorizons()
{
  vtkNew<vtkHorizonTextReader> reader;
  reader->SetFileName(WriteFile("sheets.csv",
    "Name,Inline,Crossline,Z\nTop,100,8,10.5\nTop,100,10,12.25\nBase,102,8,30\nTop,102,8,11.5\nTop,100,10,9\n")
                        .c_str());
  reader->SetDuplicatePolicyToSheets();
  reader->UpdateInformation();
  CHECK_EQUAL(reader->GetNumberOfHorizons(), 3);
  CHECK_EQUAL(std::string(reader->GetHorizonName(1)), std::string("Top (2)"));
  reader->Update();
  CHECK_EQUAL(GetName(reader, 0), std::string("Top"));
  CHECK_EQUAL(GetName(reader, 2), std::string("Base"));
  CHECK(ListZ(reader, 0) == std::vector<double>({ 10.5, 9.0, 11.5 }));
  CHECK(ListZ(reader, 1) == std::vector<double>({ 12.25 }));
  CHECK_EQUAL(FirstId(reader, 1), 1.0);
  CHECK_EQUAL(FirstId(reader, 2), 2.0);
  reader->SetHorizonStatus("Top", 0); // the file is read again, with the same sheets
  reader->Update();
  CHECK_EQUAL(GetName(reader, 0), std::string("Top (2)"));
  CHECK(ListZ(reader, 0) == std::vector<double>({ 12.25 }));
  reader->SetDuplicatePolicyToTopmost();
  reader->Update();
  CHECK_EQUAL(reader->GetNumberOfHorizons(), 2);
}

/// The list of sheets is made anew for another file, and for other parameters.
void SheetsFollowFileAndLattice()
{
  vtkNew<vtkHorizonTextReader> reader;
  reader->SetFileName(WriteFile("changing.txt", "1 1 3.5\n1 1 8.5\n1 2 3.5\n").c_str());
  reader->SetDuplicatePolicyToSheets();
  reader->Update();
  CHECK_EQUAL(reader->GetNumberOfHorizons(), 2);
  WriteFile("changing.txt", "1 1 3.5\n1 1 8.5\n1 1 13.5\n1 2 3.5\n");
  reader->Modified();
  reader->Update();
  CHECK_EQUAL(reader->GetNumberOfHorizons(), 3);
  Messages errors(reader);
  reader->SetLatticeTolerance(0.5);
  reader->Update();
  CHECK(errors.WasOne("LatticeTolerance 0.5, expected more than 0 and less than 0.5 columns"));
  CHECK(IsEmpty(reader));
  reader->SetLatticeTolerance(0.1);
  reader->Update();
  CHECK_EQUAL(reader->GetOutput()->GetNumberOfPartitionedDataSets(), 3u);
}

void SheetsAreDealtOutToPieces()
{
  vtkNew<vtkHorizonTextReader> reader;
  reader->SetFileName(WriteFile("pieces.txt", "1 1 3.5\n1 1 8.5\n1 2 3.5\n").c_str());
  reader->SetDuplicatePolicyToSheets();
  reader->UpdateInformation();
  for (int piece = 0; piece < 2; ++piece)
  {
    reader->UpdatePiece(piece, 2, 0);
    CHECK_EQUAL(GetHorizon(reader, 0) != nullptr, piece == 0);
    CHECK_EQUAL(GetHorizon(reader, 1) != nullptr, piece == 1);
  }
}

// ---- Direction and duplicates -------------------------------------------------------------------------------------
vtkSmartPointer<vtkHorizonTextReader> Open(const std::string& name, const std::string& text)
{
  auto reader = vtkSmartPointer<vtkHorizonTextReader>::New();
  reader->SetFileName(WriteFile(name, text).c_str());
  return reader;
}

bool Contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

/// World z of a pick, and the line that says why.
void ZOfOneSignSaysItsDirection()
{
  struct Case
  {
    const char* Text;
    double Z; // of the first pick in the world
    const char* Reason;
  };
  const std::string up = "z increases upwards, ";
  const std::string down = "z increases downwards, ";
  for (const auto& [text, z, reason] :
    { Case{ "1 2 -2\n1 3 0\n2 2 -1\n", -2.0, "as all z are negative; VerticalDirection Down turns it" },
      Case{ "1 2 2\n1 3 0\n2 2 1\n", -2.0, "as depth and time do; VerticalDirection Up turns it" },
      Case{ "1 2 0\n1 3 0\n", 0.0, "as depth and time do; VerticalDirection Up turns it" },
      Case{ "IL XL Elevation_m\n1 2 30\n1 3 -31\n", 30.0, "as its format or name says; VerticalDirection Down" } })
  {
    const auto reader = Open("sign.txt", text);
    Messages warnings(reader, vtkCommand::WarningEvent);
    reader->Update();
    CHECK_EQUAL(warnings.Number(), 0);
    CHECK_EQUAL(GetHorizon(reader, 0)->GetPoint(0)[2], z);
    const std::string description = reader->GetDescription();
    CHECK(Contains(description, (description.find(up) == std::string::npos ? down : up) + reason));
    const bool isUp = Contains(description, up);
    reader->SetVerticalDirection(isUp ? 0 : 1);
    reader->Update();
    CHECK_EQUAL(GetHorizon(reader, 0)->GetPoint(0)[2], -z);
    CHECK(Contains(reader->GetDescription(), (isUp ? down : up) + "as VerticalDirection says"));
  }
  const auto reader = Open("mixed.txt", "1 2 30\n1 3 -31\n2 2 -32\n");
  Messages warnings(reader, vtkCommand::WarningEvent);
  reader->Update();
  CHECK(warnings.WasOne("mixed.txt: 2 of 3 z are negative, so z may be elevation or depth"));
  reader->SetVerticalDirectionToDown();
  reader->Update();
  CHECK_EQUAL(warnings.Number(), 0);
}

/// The upper one of negative z is the larger one, also for the choice of picks.
void DirectionChoosesTheTopmost()
{
  const auto reader = Open("top.csv", "1 2 -30\n1 2 -20\n1 3 -31\n2 2 -32\n");
  reader->Update();
  CHECK_EQUAL(GetHorizon(reader, 0)->GetPoint(0)[2], -20.0);
}

void DuplicatesAreCounted()
{
  const auto reader = Open("twice.txt", "1 2 30\n1 2 30\n1 2 36\n1 3 31\n2 2 32\n");
  reader->SetDuplicatePolicyToMean();
  reader->Update();
  vtkFieldData* const data = GetHorizon(reader, 0)->GetFieldData();
  CHECK_EQUAL(GetHorizon(reader, 0)->GetPoint(0)[2], -32.0);
  CHECK_EQUAL(data->GetArray("DroppedDuplicates")->GetTuple1(0), 2.0);
  CHECK_EQUAL(data->GetArray("DroppedRepeats")->GetTuple1(0), 1.0);
  CHECK_EQUAL(data->GetArray("LargestConflict")->GetTuple1(0), 6.0);
}

void NothingButNullsIsAnError()
{
  const auto reader = Open("nulls.txt", "1 2 -999.25\n1 3 -999.25\n2 2 1e30\n");
  Messages errors(reader);
  reader->Update();
  CHECK(errors.WasOne("nulls.txt: no points, expected those of a horizon: all 3 are without z"));
}
}

int TestHorizonTextSheets(int argc, char* argv[])
{
  Folder = MakeFolder(argc, argv, "TestHorizonTextSheets");
  SheetsAreHorizons();
  SheetsFollowFileAndLattice();
  SheetsAreDealtOutToPieces();
  ZOfOneSignSaysItsDirection();
  DirectionChoosesTheTopmost();
  DuplicatesAreCounted();
  NothingButNullsIsAnError();
  std::filesystem::remove_all(Folder);
  return Check::Result();
}
