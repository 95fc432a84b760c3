// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The writer of sealed models: two tetrahedra with a common base in each format, and what is refused.

#include "Filters/HorizonFixtures.h"
#include "Readers/FileFixtures.h"
#include "Tools/Check.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkErrorCode.h"
#include "vtkSealedModelWriter.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <functional>

using namespace FileFixtures;
using HorizonFixtures::Errors;

namespace
{
/// The folder for files of this test.
std::string Folder;

template <typename Array, typename Value>
void AddValues(vtkFieldData* data, const char* name, const std::vector<Value>& values)
{
  vtkNew<Array> array;
  array->SetName(name);
  for (const Value& value : values)
  {
    array->InsertNextValue(value);
  }
  data->AddArray(array);
}

vtkSmartPointer<vtkPolyData> MakeTetrahedra()
{
  auto surfaces = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(604321.25, 6079543.1, 0.1);
  points->InsertNextPoint(604322.25, 6079543.1, 0.1);
  points->InsertNextPoint(604321.25, 6079544.1, 0.1);
  points->InsertNextPoint(604321.25, 6079543.1, 1.0);
  points->InsertNextPoint(604321.25, 6079543.1, -1.0);
  surfaces->SetPoints(points);
  vtkNew<vtkCellArray> triangles;
  triangles->InsertNextCell({ 0, 1, 2 });
  triangles->InsertNextCell({ 0, 1, 3 });
  triangles->InsertNextCell({ 1, 2, 3 });
  triangles->InsertNextCell({ 2, 0, 3 });
  triangles->InsertNextCell({ 1, 0, 4 });
  triangles->InsertNextCell({ 2, 1, 4 });
  triangles->InsertNextCell({ 0, 2, 4 });
  surfaces->SetPolys(triangles);
  vtkCellData* const data = surfaces->GetCellData();
  AddValues<vtkStringArray, std::string>(data, "SurfaceName", { "Sand", "Box", "Box", "Box", "Box", "Box", "Box" });
  AddValues<vtkUnsignedCharArray, int>(data, "SurfaceType", { 0, 2, 2, 2, 3, 3, 3 });
  AddValues<vtkIntArray, int>(data, "BodyAbove", { 0, -1, -1, -1, -1, -1, -1 });
  AddValues<vtkIntArray, int>(data, "BodyBelow", { 1, 0, 0, 0, 1, 1, 1 });
  AddValues<vtkStringArray, std::string>(surfaces->GetFieldData(), "BodyName", { "Top - Sand", "Sand - Base" });
  AddValues<vtkIntArray, int>(surfaces->GetFieldData(), "BodyLayer", { 0, 1 });
  AddValues<vtkIntArray, int>(surfaces->GetFieldData(), "BodyBlock", { 0, 0 });
  AddValues<vtkStringArray, std::string>(surfaces->GetFieldData(), "HorizontalUnit", { "m" });
  return surfaces;
}

vtkSmartPointer<vtkSealedModelWriter> MakeWriter(vtkDataObject* input, const std::string& path)
{
  auto writer = vtkSmartPointer<vtkSealedModelWriter>::New();
  writer->SetInputDataObject(input);
  writer->SetFileName(path.c_str());
  return writer;
}

void ExtensionsSelectFormats()
{
  const auto check = [](const std::string& name, const std::vector<std::string>& parts)
  {
    const auto writer = MakeWriter(MakeTetrahedra(), Folder + '/' + name);
    CHECK_EQUAL(writer->Write(), 1);
    const std::string text = ReadText(Folder + '/' + name);
    for (const std::string& part : parts)
    {
      CHECK(text.find(part) != std::string::npos);
    }
  };
  check("model.ml",
    { "GOCAD Model3d 1\n", "AXIS_UNIT \"m\" \"m\" \"none\"\n", "TSURF Box_2\n", "REGION 5 Top_-_Sand\n  +1  -2  0\n",
      "VRTX 3 604321.25 6079544.1 0.1\n" });
  check("model.MSH", { "$MeshFormat\n4.1 0 8\n", "\n3 2 \"Sand - Base\"\n", "\n604321.25 6079543.1 -1\n" });
  check("model.stl", { "solid Top - Sand\n", "endsolid Sand - Base\n" });
}

void WrongInputGivesOneErrorEach()
{
  const std::string path = WriteText(Folder + "/kept.ml", "as it was");
  const auto check = [&path](const std::function<void(vtkPolyData*)>& change, const std::string& message)
  {
    const auto surfaces = MakeTetrahedra();
    change(surfaces);
    const auto writer = MakeWriter(surfaces, path);
    const Errors errors(writer);
    CHECK_EQUAL(writer->Write(), 0);
    CHECK_EQUAL(errors.Count(), 1u);
    if (!CHECK(errors.FirstContains(path + ": " + message)))
    {
      std::cerr << errors.First() << '\n';
    }
    CHECK_EQUAL(ReadText(path), "as it was");
  };
  check([](vtkPolyData* surfaces) { surfaces->Initialize(); }, "0 polygons of 0 cells, expected only triangles");
  check(
    [](vtkPolyData* surfaces)
    {
      vtkNew<vtkCellArray> lines;
      lines->InsertNextCell({ 0, 1 });
      surfaces->SetLines(lines);
      surfaces->GetCellData()->Initialize();
    },
    "7 polygons of 8 cells, expected only triangles");
  check(
    [](vtkPolyData* surfaces)
    {
      surfaces->GetPolys()->Reset();
      surfaces->GetPolys()->InsertNextCell({ 0, 1, 2, 3 });
      surfaces->GetCellData()->SetNumberOfTuples(1);
    },
    "polygon 0 of 4 points, SurfaceType 0, expected triangles of the types 0 to 3");
  for (const char* const name : { "SurfaceName", "SurfaceType", "BodyAbove", "BodyBelow" })
  {
    const std::string kind = std::string(name) == "SurfaceName" ? " of texts" : " of whole numbers";
    check([name](vtkPolyData* surfaces) { surfaces->GetCellData()->RemoveArray(name); },
      std::string("no array ") + name + kind + ", expected the surfaces of Horizon Sealed Model");
    check([name](vtkPolyData* surfaces) { surfaces->GetCellData()->GetAbstractArray(name)->SetNumberOfTuples(3); },
      std::string("array ") + name + " of 3 tuples, expected one for each of the 7 cells");
  }
  for (const char* const name : { "BodyName", "BodyLayer", "BodyBlock" })
  {
    check([name](vtkPolyData* surfaces) { surfaces->GetFieldData()->RemoveArray(name); },
      std::string("no array ") + name + (std::string(name) == "BodyName" ? " of texts" : " of whole numbers"));
  }
  check([](vtkPolyData* surfaces) { surfaces->GetFieldData()->GetArray("BodyLayer")->SetNumberOfTuples(1); },
    "array BodyLayer of 1 tuples, expected one for each of the 2 bodies");
  check(
    [](vtkPolyData* surfaces) {
      AddValues<vtkDoubleArray, double>(surfaces->GetFieldData(), "BodyBlock", { 0, 1 });
    },
    "no array BodyBlock of whole numbers");
  check([](vtkPolyData* surfaces) { surfaces->GetCellData()->GetArray("BodyAbove")->SetTuple1(3, 2); },
    "body 2 at triangle 3, expected -1 to 1");
  check(
    [](vtkPolyData* surfaces) {
      surfaces->GetPolys()->ReplaceCellAtId(6, 3, std::vector<vtkIdType>{ 0, 2, 3 }.data());
    },
    "body 1 open at an edge with number of triangles 3 at (604321.25, 6079543.1) and 0.1 up");
}

void FilesThatCannotBeWritten()
{
  const auto check = [](const std::string& path, const std::string& message, unsigned long code)
  {
    const auto writer = MakeWriter(MakeTetrahedra(), path);
    const Errors errors(writer);
    CHECK_EQUAL(writer->Write(), 0);
    CHECK_EQUAL(errors.Count(), 1u);
    CHECK(errors.FirstContains(message));
    CHECK_EQUAL(writer->GetErrorCode(), code);
  };
  const std::string other = Folder + "/model.obj";
  check(other, other + ": extension \"obj\", expected ml, msh or stl", vtkErrorCode::UnknownError);
  CHECK(!std::filesystem::exists(other));
  check("", "no FileName, expected the path of a file", vtkErrorCode::NoFileNameError);
  check(Folder + "/none/model.ml", "does not exist", vtkErrorCode::CannotOpenFileError);
}
}

int TestSealedModelWriter(int argc, char* argv[])
{
  Folder = MakeFolder(argc, argv, "TestSealedModelWriter");
  ExtensionsSelectFormats();
  WrongInputGivesOneErrorEach();
  FilesThatCannotBeWritten();
  return Check::Result();
}
