// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The writer of fault lines: names, numbers and places are read again as they were, and a file of surfaces has one for
// each fault.

#include "Filters/HorizonFixtures.h"
#include "WriterFixtures.h"

#include "vtkFaultLinesReader.h"
#include "vtkFaultLinesWriter.h"
#include "vtkGOCADTSurfReader.h"
#include "vtkGOCADTSurfWriter.h"
#include "vtkHorizonTextWriter.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"

using namespace WriterFixtures;

namespace
{
/// Lines of the faults "B, east" (0), "" (1) and "B, east" (2), the last one a polygon.
vtkSmartPointer<vtkPolyData> MakeLines(bool withNames)
{
  auto lines = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int n = 0; n < 7; ++n)
  {
    points->InsertNextPoint(1000.125 + 10 * n, 6079543.0625 + n * n, -1500.0625 + n);
  }
  vtkNew<vtkCellArray> open;
  vtkNew<vtkCellArray> closed;
  open->InsertNextCell({ 0, 1 });
  open->InsertNextCell({ 2, 3 });
  closed->InsertNextCell({ 4, 5, 6 });
  lines->SetPoints(points);
  lines->SetLines(open);
  lines->SetPolys(closed);
  const std::array<std::array<const char*, 3>, 2> texts = { { { "B, east", "", "B, east" }, { "3", "", "7" } } };
  for (int array = 0; array < 2 && withNames; ++array)
  {
    vtkNew<vtkStringArray> values;
    values->SetName(array == 0 ? "FaultName" : "FaultStick");
    for (const char* const text : texts[array])
    {
      values->InsertNextValue(text);
    }
    lines->GetCellData()->AddArray(values);
  }
  vtkNew<vtkIntArray> direction;
  direction->SetName("VerticalDirection");
  direction->InsertNextValue(-1);
  lines->GetFieldData()->AddArray(direction);
  return lines;
}

std::vector<std::string> Texts(vtkPolyData* lines, const char* name)
{
  std::vector<std::string> texts;
  auto* const array = vtkStringArray::SafeDownCast(lines->GetCellData()->GetAbstractArray(name));
  for (vtkIdType n = 0; array && n < array->GetNumberOfValues(); ++n)
  {
    texts.push_back(array->GetValue(n));
  }
  return texts;
}

void Write(vtkHorizonWriter* writer, vtkDataObject* data, const std::string& name)
{
  writer->SetInputDataObject(data);
  writer->SetFileName((Folder + '/' + name).c_str());
  CHECK_EQUAL(writer->Write(), 1);
}

void LinesComeBack()
{
  const vtkSmartPointer<vtkPolyData> lines = MakeLines(true);
  vtkNew<vtkFaultLinesWriter> writer;
  vtkNew<vtkHorizonTextWriter> tables;
  for (const std::string name : { "out.csv", "out.txt", "out.dat", "out.pl" })
  {
    name == "out.dat" ? Write(tables, lines, name) : Write(writer, lines, name);
    vtkNew<vtkFaultLinesReader> reader;
    reader->SetFileName((Folder + '/' + name).c_str());
    reader->Update();
    vtkPolyData* const read = reader->GetOutput();
    // Lines are in the order of their faults.
    CHECK(Texts(read, "FaultName") == (std::vector<std::string>{ "B, east", "B, east", "" }));
    if (name != "out.pl")
    {
      CHECK(Texts(read, "FaultStick") == (std::vector<std::string>{ "3", "7", "2" }));
    }
    const std::vector<int> order = { 0, 1, 4, 5, 6, 4, 2, 3 };
    CHECK_EQUAL(read->GetNumberOfPoints(), vtkIdType(order.size()));
    for (std::size_t n = 0; n < order.size(); ++n)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        CHECK_EQUAL(read->GetPoint(vtkIdType(n))[axis], lines->GetPoint(order[n])[axis]);
      }
    }
    CHECK_EQUAL(read->GetFieldData()->GetArray("VerticalDirection")->GetTuple1(0), -1.0);
  }
  writer->SetVerticalPositiveToElevation();
  Write(writer, lines, "up.csv");
  CHECK(
    ReadText(Folder + "/up.csv")
      .find(
        "\"Fault\",\"X\",\"Y\",\"Elevation\",\"Stick\",\"Node\"\n\"B, east\",1000.125,6079543.0625,-1500.0625,3,0\n") ==
    0);
}

/// Polygons have no names but those of their files, and tables without names no column for them.
void NamesOfFiles()
{
  vtkNew<vtkFaultLinesWriter> writer;
  Write(writer, MakeLines(true), "all.pol");
  CHECK(ReadText(Folder + "/all_B__east.pol").find("1000.125 6079543.0625 1500.0625\n") == 0);
  Write(writer, MakeLines(false), "one.pol");
  const std::string text = ReadText(Folder + "/one.pol");
  CHECK_EQUAL(std::count(text.begin(), text.end(), '\n'), 11); // of 8 points and 3 ends
  Write(writer, MakeLines(false), "bare.csv");
  CHECK(ReadText(Folder + "/bare.csv").find("\"X\",\"Y\",\"Z\",\"Stick\",\"Node\"\n") == 0);
}

void WithoutLines()
{
  vtkNew<vtkPolyData> points;
  vtkNew<vtkPoints> places;
  places->InsertNextPoint(0.0, 0.0, 0.0);
  points->SetPoints(places);
  vtkNew<vtkFaultLinesWriter> writer;
  writer->SetInputDataObject(points);
  writer->SetFileName((Folder + "/none.csv").c_str());
  const HorizonFixtures::Errors errors(writer);
  CHECK_EQUAL(writer->Write(), 0);
  CHECK(errors.FirstContains("no lines, expected polylines or polygons"));
}

void SurfacesHaveNames()
{
  vtkNew<vtkPolyData> surfaces;
  const vtkSmartPointer<vtkPolyData> lines = MakeLines(false);
  surfaces->SetPoints(lines->GetPoints());
  vtkNew<vtkCellArray> triangles;
  triangles->InsertNextCell({ 0, 1, 3 });
  triangles->InsertNextCell({ 4, 5, 6 });
  triangles->InsertNextCell({ 0, 3, 2 });
  surfaces->SetPolys(triangles);
  vtkNew<vtkStringArray> names;
  names->SetName("FaultName");
  for (const char* const name : { "A", "B", "A" })
  {
    names->InsertNextValue(name);
  }
  surfaces->GetCellData()->AddArray(names);
  vtkNew<vtkGOCADTSurfWriter> writer;
  Write(writer, surfaces, "faults.ts");
  vtkNew<vtkGOCADTSurfReader> reader;
  reader->SetFileName((Folder + "/faults.ts").c_str());
  reader->Update();
  CHECK_EQUAL(GetName(reader->GetOutput(), 0), std::string("A"));
  CHECK_EQUAL(GetHorizon(reader->GetOutput(), 0)->GetNumberOfPolys(), 2);
  CHECK_EQUAL(GetName(reader->GetOutput(), 1), std::string("B"));
  CHECK_EQUAL(GetHorizon(reader->GetOutput(), 1)->GetNumberOfPolys(), 1);
}
}

int TestFaultLinesWriter(int argc, char* argv[])
{
  Folder = MakeFolder(argc, argv, "FaultLinesWriter");
  LinesComeBack();
  NamesOfFiles();
  WithoutLines();
  SurfacesHaveNames();
  return Check::Result();
}
