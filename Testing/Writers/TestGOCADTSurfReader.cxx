// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The reader of GOCAD files: the datasets it makes, its parameters, and its errors.

#include "Filters/HorizonFixtures.h"
#include "Readers/FileFixtures.h"
#include "Tools/Check.h"

#include "vtkCellData.h"
#include "vtkDataArraySelection.h"
#include "vtkGOCADTSurfReader.h"
#include "vtkInformationStringKey.h"
#include "vtkStringArray.h"

#include <array>
#include <cmath>
#include <sstream>

using namespace FileFixtures;
using HorizonFixtures::Errors;

namespace
{
constexpr const char* Deep = "GOCAD TSurf 1\nHEADER {\nname:deep\n*solid*color:1 0.5 0\n}\n"
                             "GOCAD_ORIGINAL_COORDINATE_SYSTEM\nNAME UTM 31N\nAXIS_UNIT \"ft\" \"ft\" \"ms\"\n"
                             "ZPOSITIVE Depth\nEND_ORIGINAL_COORDINATE_SYSTEM\n"
                             "PROPERTIES p v p\nNO_DATA_VALUES -1 -1 -1\nESIZES 1 3 1\nUNITS km none none\nTFACE\n"
                             "PVRTX 1 459621.05127000005 0 10 5 1 2 3 6\nPVRTX 2 1 0 10 -1 4 5 6 7\n"
                             "PVRTX 3 0 1 10 5 7 8 9 8\nTRGL 1 2 3\nTFACE\nATOM 4 1\nATOM 5 2\nVRTX 6 9 9 9\n"
                             "TRGL 4 5 6\nEND\n";

/// A surface of one vertex, with x.
std::string Tiny(const std::string& name, int x)
{
  return "GOCAD TSurf 1\nHEADER {\nname:" + name + "\n}\nTFACE\nVRTX 1 " + std::to_string(x) + " 0 0\nEND\n";
}

/// The folder for files of this test.
std::string Folder;

vtkSmartPointer<vtkGOCADTSurfReader> Read(const std::string& text)
{
  auto reader = vtkSmartPointer<vtkGOCADTSurfReader>::New();
  reader->SetFileName(WriteText(Folder + "/read.ts", text).c_str());
  reader->Update();
  return reader;
}

std::string FieldText(vtkPolyData* surface, const char* name)
{
  auto* const array = vtkStringArray::SafeDownCast(surface->GetFieldData()->GetAbstractArray(name));
  return array && array->GetNumberOfValues() == 1 ? std::string(array->GetValue(0)) : std::string("(none)");
}

void ArraysAreComplete()
{
  const auto reader = Read(Deep);
  CHECK_EQUAL(reader->GetOutput()->GetNumberOfPartitionedDataSets(), 1u);
  CHECK_EQUAL(GetName(reader->GetOutput(), 0), "deep");
  vtkPolyData* const surface = GetHorizon(reader->GetOutput(), 0);
  CHECK(surface->GetNumberOfPoints() == 6 && surface->GetPoints()->GetDataType() == VTK_DOUBLE);
  CHECK(surface->GetPoint(0)[0] == 459621.05127000005 && surface->GetPoint(0)[2] == -10.0);
  CHECK(surface->GetPoint(3)[0] == 459621.05127000005);
  CHECK(surface->GetNumberOfCells() == 2 && surface->GetCellType(0) == VTK_TRIANGLE);
  vtkIdType size = 0;
  const vtkIdType* corners = nullptr;
  surface->GetCellPoints(0, size, corners);
  CHECK(size == 3 && corners[0] == 0 && corners[1] == 2 && corners[2] == 1); // turned around with z
  vtkPointData* const data = surface->GetPointData();
  CHECK_EQUAL(data->GetNumberOfArrays(), 4);
  CHECK_EQUAL(std::string(data->GetArray(3)->GetName()), "Time (ms)");
  CHECK_EQUAL(data->GetArray(3)->GetComponent(0, 0), 10.0);
  auto* const p = vtkDoubleArray::SafeDownCast(data->GetArray("p"));
  CHECK(p && p->GetValue(0) == 5.0 && std::isnan(p->GetValue(1)) && p->GetValue(3) == 5.0);
  CHECK_EQUAL(std::string(p->GetInformation()->Get(vtkDataArray::UNITS_LABEL())), "km");
  auto* const v = vtkDoubleArray::SafeDownCast(data->GetArray("v"));
  CHECK(v && v->GetNumberOfComponents() == 3 && v->GetComponent(1, 2) == 6.0 && std::isnan(v->GetComponent(5, 0)));
  CHECK(data->GetArray("p (2)") && data->GetArray("p (2)")->GetComponent(2, 0) == 8.0);
  auto* const part = vtkIntArray::SafeDownCast(surface->GetCellData()->GetArray("Part"));
  CHECK(part && part->GetNumberOfValues() == 2 && part->GetValue(0) == 0 && part->GetValue(1) == 1);
}

void FieldDataTellWhatTheFileSays()
{
  vtkPolyData* surface = nullptr;
  const auto direction = [&surface]()
  { return vtkIntArray::SafeDownCast(surface->GetFieldData()->GetArray("VerticalDirection"))->GetValue(0); };
  const auto deep = Read(Deep);
  surface = GetHorizon(deep->GetOutput(), 0);
  CHECK_EQUAL(direction(), -1);
  CHECK_EQUAL(FieldText(surface, "VerticalUnit"), "ms");
  CHECK_EQUAL(FieldText(surface, "VerticalDomain"), "time");
  CHECK_EQUAL(FieldText(surface, "HorizontalUnit"), "ft");
  CHECK_EQUAL(FieldText(surface, "CoordinateSystem"), "UTM 31N");
  vtkDataArray* const colour = surface->GetFieldData()->GetArray("Colour");
  CHECK(colour && colour->GetNumberOfComponents() == 3 && colour->GetComponent(0, 1) == 0.5);
  const auto tiny = Read(Tiny("a", 7));
  surface = GetHorizon(tiny->GetOutput(), 0);
  CHECK_EQUAL(direction(), 1);
  CHECK_EQUAL(surface->GetFieldData()->GetNumberOfArrays(), 1);
  CHECK_EQUAL(surface->GetCellData()->GetNumberOfArrays(), 0);
  CHECK(surface->GetNumberOfPoints() == 1 && surface->GetNumberOfCells() == 0);
}

void NamesAreDistinct()
{
  const auto reader = Read(
    Tiny("a", 1) + Tiny("", 2) + Tiny("a", 3) + Tiny("a (2)", 4) + Tiny("a", 5) + "GOCAD VSet 1\nEND\n" + Tiny("", 6));
  vtkPartitionedDataSetCollection* const output = reader->GetOutput();
  const std::array<const char*, 6> names = { "a", "TSurf 2", "a (3)", "a (2)", "a (4)", "TSurf 6" };
  CHECK_EQUAL(output->GetNumberOfPartitionedDataSets(), 6u);
  for (unsigned int n = 0; n < 6; ++n)
  {
    CHECK_EQUAL(GetName(output, n), names[n]);
    CHECK_EQUAL(GetHorizon(output, n)->GetPoint(0)[0], n + 1.0);
    CHECK_EQUAL(std::string(reader->GetHorizonName(int(n))), names[n]);
  }
}

void SelectionIsObeyed()
{
  const std::string text = Tiny("a", 1) + Tiny("b", 2) + Tiny("c", 3);
  const auto reader = Read(text);
  reader->SetHorizonStatus("b", 0);
  reader->Update();
  CHECK_EQUAL(reader->GetOutput()->GetNumberOfPartitionedDataSets(), 2u);
  CHECK_EQUAL(GetHorizon(reader->GetOutput(), 1)->GetPoint(0)[0], 3.0);
  reader->DisableAllHorizons();
  reader->Update();
  CHECK_EQUAL(reader->GetOutput()->GetNumberOfPartitionedDataSets(), 0u);
  reader->EnableAllHorizons();
  CHECK(reader->GetHorizonStatus("b") == 1 && reader->GetNumberOfHorizons() == 3);
  vtkNew<vtkGOCADTSurfReader> early;
  early->SetHorizonStatus("a", 0);
  early->SetFileName(WriteText(Folder + "/early.ts", text).c_str());
  early->Update();
  CHECK_EQUAL(GetName(early->GetOutput(), 0), "b");
}

void SurfacesAreDealtOutBySize()
{
  const std::string larger = Tiny("b", 2).insert(Tiny("b", 2).find("END"), "\n\n");
  vtkNew<vtkGOCADTSurfReader> sorted;
  sorted->SetFileName(WriteText(Folder + "/sizes.ts", Tiny("a", 1) + larger + Tiny("c", 3)).c_str());
  sorted->UpdatePiece(0, 3, 0);
  CHECK(GetHorizon(sorted->GetOutput(), 1) && !GetHorizon(sorted->GetOutput(), 0));
  vtkNew<vtkGOCADTSurfReader> reader;
  reader->SetFileName(WriteText(Folder + "/pieces.ts", Tiny("a", 1) + Tiny("b", 2) + Tiny("c", 3)).c_str());
  for (int piece = 0; piece < 2; ++piece)
  {
    reader->UpdatePiece(piece, 2, 0);
    CHECK_EQUAL(reader->GetOutput()->GetNumberOfPartitionedDataSets(), 3u);
    for (unsigned int n = 0; n < 3; ++n)
    {
      vtkPolyData* const surface = GetHorizon(reader->GetOutput(), n);
      CHECK((surface != nullptr) == (int(n) % 2 == piece));
      CHECK(!surface || surface->GetPoint(0)[0] == n + 1.0);
    }
  }
}

void FilesOfOthersAreLeftToThem()
{
  vtkNew<vtkGOCADTSurfReader> reader;
  const auto canRead = [&reader](const std::string& text)
  { return reader->CanReadFile(WriteText(Folder + "/maybe.ts", text).c_str()); };
  CHECK(canRead(Deep) == 1 && canRead("# comment\r\nGOCAD PLine 1\nEND\n") == 1);
  CHECK(canRead("import { x } from './y';\n") == 0); // TypeScript
  CHECK(canRead("<?xml version=\"1.0\"?><!DOCTYPE TS>") == 0); // translations
  CHECK(canRead(std::string("G\x40\x11\x10", 4) + std::string(184, '\xFF')) == 0); // video
  CHECK(canRead("") == 0 && reader->CanReadFile(nullptr) == 0 && reader->CanReadFile(Folder.c_str()) == 0);
  CHECK(reader->CanReadFile((Folder + "/none.ts").c_str()) == 0);
}

void WrongFilesGiveOneErrorEach()
{
  const auto check = [](const char* file, const std::string& message)
  {
    vtkNew<vtkGOCADTSurfReader> reader;
    const Errors errors(reader);
    reader->SetFileName(file);
    reader->Update();
    CHECK_EQUAL(errors.Count(), 1u);
    CHECK(errors.FirstContains(message));
    CHECK_EQUAL(reader->GetOutput()->GetNumberOfPartitionedDataSets(), 0u);
  };
  check(nullptr, "no FileName, expected the path of a file");
  check((Folder + "/none.ts").c_str(), "/none.ts: no such file");
  check(Folder.c_str(), ": a directory, expected a file");
  check(WriteText(Folder + "/other.ts", "x\n").c_str(), "other.ts: line 1: \"x\", expected \"GOCAD TSurf 1\"");
  check(WriteText(Folder + "/half.ts", std::string(Deep).substr(0, 300)).c_str(), "half.ts: line ");
  check(WriteText(Folder + "/second.ts", Tiny("a", 1) + "GOCAD TSurf 1\nVRTX x\nEND\n").c_str(),
    "second.ts: line 9: VRTX id \"x\", expected an integer from 0 on");
  check(WriteText(Folder + "/zero.ts", Tiny("a", 1) + Tiny(std::string("b\0c", 3), 2)).c_str(),
    "zero.ts: zero byte in the name of horizon 2, expected text");
}

void AllIsPrinted()
{
  const auto reader = Read(Tiny("a b", 1));
  std::ostringstream text;
  reader->Print(text);
  CHECK(text.str().find("FileName: " + Folder + "/read.ts") != std::string::npos);
  CHECK(text.str().find("a b") != std::string::npos);
}
}

int TestGOCADTSurfReader(int argc, char* argv[])
{
  Folder = MakeFolder(argc, argv, "TestGOCADTSurfReader");
  ArraysAreComplete();
  FieldDataTellWhatTheFileSays();
  NamesAreDistinct();
  SelectionIsObeyed();
  SurfacesAreDealtOutBySize();
  FilesOfOthersAreLeftToThem();
  WrongFilesGiveOneErrorEach();
  AllIsPrinted();
  return Check::Result();
}
