// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The reader of text files: the datasets it makes, its parameters, and its errors.

#include "ReaderFixtures.h"
#include "Tools/Check.h"

#include "vtkDoubleArray.h"
#include "vtkHorizonTextReader.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

#include <cmath>
#include <limits>
#include <sstream>
#include <vector>

using namespace ReaderFixtures;

namespace
{
// Crosslines run to the north, inlines to the east. Columns of crossline 8 and 10, inlines 100, 104 and 108. Top has
// two picks in one column and one without z, Base one pick.
constexpr const char* TwoHorizons = "Name,X,Y,Inline,Crossline,Z,Amplitude\n"
                                    "Top,501250,6000200,100,8,10.5,1\n"
                                    "Top,501250,6000250,100,10,12.25,-3\n"
                                    "Top,501300,6000200,104,8,11.5,*\n"
                                    "Base,501350,6000250,108,10,30,7\n"
                                    "Top,501250,6000250,100,10,9,2\n"
                                    "Top,501350,6000200,108,8,1e30,2\n";

std::string Folder;

std::string WriteFile(const std::string& name, const std::string& text)
{
  return WriteText(Folder + "/" + name, text);
}

vtkSmartPointer<vtkHorizonTextReader> MakeReader(const std::string& name, const std::string& text)
{
  auto reader = vtkSmartPointer<vtkHorizonTextReader>::New();
  reader->SetFileName(WriteFile(name, text).c_str());
  return reader;
}

template <typename Array>
bool HasValues(vtkFieldData* data, const char* name, const std::vector<double>& expected)
{
  auto* const array = Array::SafeDownCast(data->GetAbstractArray(name));
  if (!array || std::size_t(array->GetNumberOfValues()) != expected.size())
  {
    return false;
  }
  for (std::size_t n = 0; n < expected.size(); ++n)
  {
    const double value = array->GetValue(vtkIdType(n));
    if (value != expected[n] && !(std::isnan(value) && std::isnan(expected[n])))
    {
      return false;
    }
  }
  return true;
}

std::string GetText(vtkFieldData* data, const char* name)
{
  auto* const array = vtkStringArray::SafeDownCast(data->GetAbstractArray(name));
  return array && array->GetNumberOfValues() == 1 ? std::string(array->GetValue(0)) : "";
}

// ---- Datasets ----------------------------------------------------------------------------------------------------
void PointsAndArraysAreComplete()
{
  const auto reader = MakeReader("two.csv", TwoHorizons);
  reader->SetVerticalStep(0.5);
  reader->Update();
  CHECK_EQUAL(reader->GetOutput()->GetNumberOfPartitionedDataSets(), 2u);
  CHECK_EQUAL(GetName(reader, 0), std::string("Top"));
  CHECK_EQUAL(GetName(reader, 1), std::string("Base"));
  vtkPolyData* const top = GetHorizon(reader, 0);
  CHECK_EQUAL(top->GetNumberOfPoints(), 3);
  CHECK_EQUAL(top->GetNumberOfVerts(), 3);
  CHECK_EQUAL(top->GetPoints()->GetDataType(), VTK_DOUBLE);
  double point[3];
  top->GetPoint(1, point);
  CHECK(point[0] == 501250.0 && point[1] == 6000250.0 && point[2] == -12.25);
  vtkPointData* const data = top->GetPointData();
  CHECK(HasValues<vtkDoubleArray>(data, "RealZ", { 10.5, 12.25, 11.5 }));
  CHECK(HasValues<vtkDoubleArray>(data, "Amplitude", { 1.0, -3.0, std::nan("") }));
  CHECK(HasValues<vtkIntArray>(data, "VerticalIndex", { 0, 4, 2 })); // index 0 is 10.5; 12.25 is nearer to none: up
  CHECK(HasValues<vtkIntArray>(data, "SurfaceId", { 1, 1, 1 }));
  CHECK(!data->HasArray("PointCount"));
  CHECK(data->GetScalars() == data->GetArray("Depth"));
  CHECK(HasValues<vtkIntArray>(GetHorizon(reader, 1)->GetPointData(), "SurfaceId", { 2 }));
}

void FieldDataDescribeTheSurvey()
{
  const auto reader = MakeReader("two.csv", TwoHorizons);
  reader->SetVerticalStep(0.5);
  reader->SetVerticalUnit("ms");
  reader->SetVerticalDomain("time");
  reader->SetHorizontalUnit("m");
  reader->SetCoordinateSystem("UTM31");
  reader->Update();
  vtkFieldData* const data = GetHorizon(reader, 0)->GetFieldData();
  CHECK(HasValues<vtkIntArray>(data, "LatticeDimensions", { 2, 3, 40 }));
  CHECK(HasValues<vtkIntArray>(data, "VerticalDirection", { -1 }));
  CHECK(HasValues<vtkDoubleArray>(data, "LineNumbers", { 100, 4, 8, 2 }));
  CHECK(HasValues<vtkIdTypeArray>(data, "DroppedDuplicates", { 1 }));
  CHECK(HasValues<vtkIdTypeArray>(data, "DroppedNulls", { 1 }));
  CHECK_EQUAL(GetText(data, "VerticalUnit"), std::string("ms"));
  CHECK_EQUAL(GetText(data, "VerticalDomain"), std::string("time"));
  CHECK_EQUAL(GetText(data, "HorizontalUnit"), std::string("m"));
  CHECK_EQUAL(GetText(data, "CoordinateSystem"), std::string("UTM31"));
  auto* const deviation = GetArray<vtkDoubleArray>(data, "LatticeDeviation", 1, 1);
  CHECK(deviation->GetValue(0) < 1e-9);
  auto* const map = GetArray<vtkDoubleArray>(data, "LatticeToWorld", 1, 16);
  const std::vector<double> expected = { 0, 50, 0, 501250, 50, 0, 0, 6000200, 0, 0, -0.5, -10.5, 0, 0, 0, 1 };
  for (int n = 0; n < 16; ++n)
  {
    CHECK(std::abs(map->GetValue(n) - expected[std::size_t(n)]) < 1e-6);
  }
}

/// What is not known is not there. World z grows with z where it is said to.
void UnknownFieldsAreLeftOut()
{
  const auto reader = MakeReader("plain.txt", "1.5 2 -30\n1.5 4 -31\n3.5 2 -32\n3.5 4 -30.5\n");
  reader->SetVerticalDirectionToUp();
  reader->Update();
  CHECK_EQUAL(GetName(reader, 0), std::string("plain"));
  vtkPolyData* const horizon = GetHorizon(reader, 0);
  CHECK_EQUAL(horizon->GetPoint(0)[2], -30.0);
  vtkFieldData* const data = horizon->GetFieldData();
  for (const char* name : { "LineNumbers", "VerticalUnit", "VerticalDomain", "HorizontalUnit", "CoordinateSystem" })
  {
    CHECK(!data->GetAbstractArray(name));
  }
  CHECK(HasValues<vtkIntArray>(data, "VerticalDirection", { 1 }));
}

void LatticeMayBeGiven()
{
  const auto reader = MakeReader("lines.txt", "100 8 10\n104 10 20\n");
  reader->SetLatticeSourceToOriginAndSteps();
  reader->SetOrigin(1000.0, 2000.0);
  reader->SetColumnStep(0.0, 5.0);
  reader->SetRowStep(7.0, 0.0);
  reader->Update();
  const double* point = GetHorizon(reader, 0)->GetPoint(1);
  CHECK(point[0] == 1007.0 && point[1] == 2005.0);
  reader->SetLatticeSourceToCornerPoints();
  reader->SetFirstCorner(100, 8, 0, 0);
  reader->SetSecondCorner(100, 18, 100, 0);
  reader->SetThirdCorner(110, 8, 0, 1000);
  reader->Update();
  point = GetHorizon(reader, 0)->GetPoint(1);
  CHECK(std::abs(point[0] - 20.0) < 1e-9 && std::abs(point[1] - 400.0) < 1e-9);
  reader->SetLatticeSourceToFromPoints();
  reader->SetColumns("Crossline,Inline,Z");
  reader->Update();
  point = GetHorizon(reader, 0)->GetPoint(1);
  CHECK(point[0] == 104.0 && point[1] == 10.0);
}

/// A few picks stay where they are, in their order, twice in a place as well; without the fields that stages need.
void PicksMayBeOnNoLattice()
{
  const auto reader = MakeReader("picks.txt",
    "Horizon X Y Z\nTop 604964.1 6080030.1 201\nBase 604891.5 6080305.8 396\nTop 605161.1 6081038.8 216\n"
    "Top 604964.1 6080030.1 205\nTop 604000.7 6080000.3 -999.25\n");
  {
    Messages errors(reader);
    reader->Update();
    CHECK(errors.WasOne("NoLattice"));
    reader->SetLatticeSourceToNoLattice();
    reader->SetGriddingToPlate();
    reader->Update();
    CHECK(errors.WasOne("LatticeSource NoLattice with Gridding, expected FromPoints or OriginAndSteps"));
    reader->SetGriddingToNoGridding();
  }
  reader->Update();
  CHECK_EQUAL(reader->GetOutput()->GetNumberOfPartitionedDataSets(), 2u);
  vtkPolyData* const top = GetHorizon(reader, 0);
  CHECK_EQUAL(top->GetNumberOfPoints(), 3);
  const double expected[3][3] = { { 604964.1, 6080030.1, -201.0 }, { 605161.1, 6081038.8, -216.0 },
    { 604964.1, 6080030.1, -205.0 } };
  for (int n = 0; n < 3; ++n)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      CHECK(std::abs(top->GetPoint(n)[axis] - expected[n][axis]) < 1e-5);
    }
  }
  for (const char* name : { "LatticeDimensions", "LatticeToWorld", "LedgerColumns" })
  {
    CHECK(!top->GetFieldData()->GetAbstractArray(name));
  }
  CHECK(!top->GetPointData()->GetArray("Column"));
}

void DuplicatePolicyChoosesThePick()
{
  const auto reader = MakeReader("two.csv", TwoHorizons);
  const auto kept = [&]()
  {
    reader->Update();
    return GetHorizon(reader, 0)->GetPointData()->GetArray("RealZ")->GetTuple1(1);
  };
  reader->SetDuplicatePolicyToTopmost();
  CHECK_EQUAL(kept(), 9.0);
  reader->SetDuplicatePolicyToLowest();
  CHECK_EQUAL(kept(), 12.25);
  reader->SetVerticalDirectionToUp();
  CHECK_EQUAL(kept(), 9.0);
}

// ---- Selection and pieces ----------------------------------------------------------------------------------------
void SelectionIsObeyed()
{
  const auto reader = MakeReader("two.csv", TwoHorizons);
  CHECK_EQUAL(reader->GetNumberOfHorizons(), 0);
  reader->SetHorizonStatus("Top", 0); // before it is listed
  reader->UpdateInformation();
  CHECK_EQUAL(reader->GetNumberOfHorizons(), 2);
  CHECK_EQUAL(std::string(reader->GetHorizonName(1)), std::string("Base"));
  reader->Update();
  CHECK_EQUAL(reader->GetOutput()->GetNumberOfPartitionedDataSets(), 1u);
  CHECK_EQUAL(GetName(reader, 0), std::string("Base"));
  // Numbers and lattice are those of all horizons.
  CHECK(HasValues<vtkIntArray>(GetHorizon(reader, 0)->GetPointData(), "SurfaceId", { 2 }));
  CHECK(HasValues<vtkDoubleArray>(GetHorizon(reader, 0)->GetFieldData(), "LineNumbers", { 100, 4, 8, 2 }));
  reader->EnableAllHorizons();
  reader->Update();
  CHECK_EQUAL(reader->GetOutput()->GetNumberOfPartitionedDataSets(), 2u);
}

void HorizonsAreDealtOutToPieces()
{
  const auto reader = MakeReader("two.csv", TwoHorizons);
  reader->UpdateInformation();
  for (int piece = 0; piece < 2; ++piece)
  {
    reader->UpdatePiece(piece, 2, 0);
    CHECK_EQUAL(reader->GetOutput()->GetNumberOfPartitionedDataSets(), 2u);
    CHECK_EQUAL(GetHorizon(reader, 0) != nullptr, piece == 0);
    CHECK_EQUAL(GetHorizon(reader, 1) != nullptr, piece == 1);
  }
}

// ---- What it says ------------------------------------------------------------------------------------------------
void DescriptionTellsWhatWasFound()
{
  const auto reader = MakeReader("two.csv", TwoHorizons);
  CHECK_EQUAL(std::string(reader->GetDescription()), std::string());
  reader->Update();
  const std::string description = reader->GetDescription();
  for (const char* text : { "plain text, separated by commas: Name, X, Y, Inline, Crossline, Z, Amplitude\n",
         "2 x 3 columns from (501250, 6000200) in steps of (", "crosslines from 8 in steps of 2, inlines from 100 in",
         "points at most ", "vertical indices in steps of 1 to 2 (unit unknown) to smaller world z, as suits each" })
  {
    if (!CHECK(description.find(text) != std::string::npos))
    {
      std::cerr << text << " is not in\n" << description << '\n';
    }
  }
}

void PrintListsEveryProperty()
{
  vtkNew<vtkHorizonTextReader> reader;
  reader->SetFileName("some.dat");
  reader->SetColumns("X,Y,Z");
  reader->SetVerticalStep(8.5);
  reader->SetVerticalDirectionToUp();
  reader->SetVerticalUnit("ft");
  reader->SetLatticeSourceToCornerPoints();
  reader->SetThirdCorner(1.5, 2.5, 3.5, 4.5);
  reader->SetOrigin(1.5, 2.5);
  reader->SetLatticeTolerance(0.25);
  reader->SetDuplicatePolicyToSheets();
  reader->SetHorizonStatus("Top", 1);
  std::ostringstream stream;
  reader->Print(stream);
  for (const char* text : { "FileName: some.dat", "Columns: X,Y,Z", "NullValues: -999.25 -99999 9999900",
         "HeaderLines: 0", "VerticalStep: 8.5", "VerticalDirection: Up", "VerticalUnit: ft", "VerticalDomain: (none)",
         "LatticeSource: CornerPoints", "ThirdCorner: 1.5 2.5 3.5 4.5", "Origin: 1.5 2.5", "LatticeTolerance: 0.25",
         "DuplicatePolicy: Sheets", "Description: ", "Top" })
  {
    CHECK(stream.str().find(text) != std::string::npos);
  }
}

// ---- Errors ------------------------------------------------------------------------------------------------------
void WrongParametersGiveOneErrorEach()
{
  const auto reader = MakeReader("two.csv", TwoHorizons);
  Messages errors(reader);
  reader->SetVerticalStep(-1.0);
  reader->Update();
  CHECK(errors.WasOne("VerticalStep -1, expected a positive number, or 0 for one that suits the data"));
  reader->SetVerticalStep(1e-12);
  reader->Update();
  CHECK(errors.WasOne("expected one that makes less than 2^31 vertical indices"));
  reader->SetVerticalStep(0.0);
  reader->SetLatticeTolerance(0.5);
  reader->Update();
  CHECK(errors.WasOne("LatticeTolerance 0.5, expected more than 0 and less than 0.5 columns"));
  reader->SetLatticeTolerance(0.1);
  reader->SetColumns("X,Y,Z");
  reader->Update();
  CHECK(errors.WasOne("two.csv: line 2: 7 fields, expected one for each of the columns X, Y, Z"));
  reader->SetColumns("");
  reader->SetHeaderLines(100);
  reader->Update();
  CHECK(errors.WasOne("two.csv: no picks after 100 lines, expected lines of numbers"));
  reader->SetHeaderLines(0);
  reader->SetNullValues("10.5");
  reader->Update();
  CHECK(HasValues<vtkIdTypeArray>(GetHorizon(reader, 0)->GetFieldData(), "DroppedNulls", { 2 }));
}

void AbortLeavesTheOutputEmpty()
{
  const auto reader = MakeReader("two.csv", TwoHorizons);
  reader->Update();
  vtkNew<vtkCallbackCommand> aborter;
  aborter->SetCallback(
    [](vtkObject* caller, unsigned long, void*, void*) { vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1); });
  const unsigned long tag = reader->AddObserver(vtkCommand::ProgressEvent, aborter);
  reader->Modified();
  reader->Update();
  CHECK(IsEmpty(reader));
  reader->RemoveObserver(tag);
  reader->SetAbortExecute(0);
  reader->Modified();
  reader->Update();
  CHECK_EQUAL(reader->GetOutput()->GetNumberOfPartitionedDataSets(), 2u);
}

// ---- The rest ----------------------------------------------------------------------------------------------------
void ChangedFileIsReadAgain()
{
  const auto reader = MakeReader("changing.txt", "1 2 3.5\n");
  reader->Update();
  CHECK_EQUAL(GetHorizon(reader, 0)->GetNumberOfPoints(), 1);
  WriteFile("changing.txt", "a 1 2 3.5\nb 1 3 4.5\n"); // of another size, should the clock be coarse
  reader->Modified();
  reader->Update();
  CHECK_EQUAL(reader->GetOutput()->GetNumberOfPartitionedDataSets(), 2u);
  CHECK_EQUAL(reader->GetNumberOfHorizons(), 2);
}

/// Names with blanks, and the name of the file where there is none.
void NamesComeFromTheFile()
{
  const auto reader = MakeReader("top chalk.v2.dat", "1 2 3.5\n1 3 4.5\n");
  reader->Update();
  CHECK_EQUAL(GetName(reader, 0), std::string("top chalk.v2"));
  reader->SetFileName(WriteFile("named.dat", "#Horizon_name____-> A b\n1 2 3.5\n1 3 4.5\n").c_str());
  reader->Update();
  CHECK_EQUAL(GetName(reader, 0), std::string("A b"));
}
}

int TestHorizonTextReader(int argc, char* argv[])
{
  Folder = MakeFolder(argc, argv, "TestHorizonTextReader");
  PointsAndArraysAreComplete();
  FieldDataDescribeTheSurvey();
  UnknownFieldsAreLeftOut();
  LatticeMayBeGiven();
  PicksMayBeOnNoLattice();
  DuplicatePolicyChoosesThePick();
  SelectionIsObeyed();
  HorizonsAreDealtOutToPieces();
  DescriptionTellsWhatWasFound();
  PrintListsEveryProperty();
  WrongParametersGiveOneErrorEach();
  AbortLeavesTheOutputEmpty();
  ChangedFileIsReadAgain();
  NamesComeFromTheFile();
  std::filesystem::remove_all(Folder);
  return Check::Result();
}
