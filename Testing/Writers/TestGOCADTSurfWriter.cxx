// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The writer of GOCAD files: what it makes of datasets, that it comes back from the reader, and its errors.

#include "Filters/HorizonFixtures.h"
#include "Readers/FileFixtures.h"
#include "Tools/Check.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkErrorCode.h"
#include "vtkFloatArray.h"
#include "vtkGOCADTSurfReader.h"
#include "vtkGOCADTSurfWriter.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <limits>
#include <sstream>

using namespace FileFixtures;
using HorizonFixtures::Errors;

namespace
{
/// The folder for files of this test.
std::string Folder;

template <typename Array>
void AddPointArray(vtkPolyData* mesh, const char* name, std::vector<typename Array::ValueType> values, int components)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  for (const auto value : values)
  {
    array->InsertNextValue(value);
  }
  mesh->GetPointData()->AddArray(array);
}

/// Two triangles over four points, with a vertex cell, a line, and three arrays.
vtkSmartPointer<vtkPolyData> MakeMesh(double x)
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(x, 0.1, -10);
  points->InsertNextPoint(x + 1.0 / 3.0, 0, -10.5);
  points->InsertNextPoint(x + 1, 1, -10);
  points->InsertNextPoint(x, 1, 0);
  mesh->SetPoints(points);
  vtkNew<vtkCellArray> triangles;
  triangles->InsertNextCell({ 0, 1, 2 });
  triangles->InsertNextCell({ 0, 2, 3 });
  mesh->SetPolys(triangles);
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell({ 0 });
  mesh->SetVerts(vertices);
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 1 });
  mesh->SetLines(lines);
  AddPointArray<vtkIntArray>(mesh, "SurfaceId", { 7, 7, 7, 7 }, 1);
  AddPointArray<vtkDoubleArray>(mesh, "Mean Amplitude", { 0.1, std::nan(""), 3, -99999 }, 1);
  AddPointArray<vtkFloatArray>(mesh, "normal", { 0, 0, 1, 0, 0.1f, 1, 0, 0, 1, 0, 0, 1 }, 3);
  return mesh;
}

vtkSmartPointer<vtkPartitionedDataSetCollection> ReadBack(const std::string& path)
{
  vtkNew<vtkGOCADTSurfReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

vtkSmartPointer<vtkGOCADTSurfWriter> MakeWriter(vtkDataObject* input, const std::string& name)
{
  auto writer = vtkSmartPointer<vtkGOCADTSurfWriter>::New();
  writer->SetInputData(input);
  writer->SetFileName((Folder + '/' + name).c_str());
  return writer;
}

std::string Write(vtkGOCADTSurfWriter* writer)
{
  CHECK_EQUAL(writer->Write(), 1);
  return ReadText(writer->GetFileName());
}

bool Has(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

void CheckSamePoints(vtkPolyData* a, vtkPolyData* b)
{
  CHECK_EQUAL(a->GetNumberOfPoints(), b->GetNumberOfPoints());
  for (vtkIdType point = 0; point < a->GetNumberOfPoints(); ++point)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      CHECK_EQUAL(
        a->GetPoints()->GetData()->GetComponent(point, axis), b->GetPoints()->GetData()->GetComponent(point, axis));
    }
  }
}

void CheckSameTriangles(vtkPolyData* a, vtkPolyData* b)
{
  CHECK_EQUAL(a->GetNumberOfPolys(), b->GetNumberOfPolys());
  for (vtkIdType triangle = 0; triangle < a->GetNumberOfPolys(); ++triangle)
  {
    vtkNew<vtkIdList> corners[2];
    a->GetPolys()->GetCellAtId(triangle, corners[0]);
    b->GetPolys()->GetCellAtId(triangle, corners[1]);
    for (vtkIdType n = 0; n < 3; ++n)
    {
      CHECK_EQUAL(corners[0]->GetId(n), corners[1]->GetId(n));
    }
  }
}

void CheckSameArrays(vtkPolyData* a, vtkPolyData* b)
{
  // What was read has its heights as an array, too.
  CHECK_EQUAL(a->GetPointData()->GetNumberOfArrays() + 1, b->GetPointData()->GetNumberOfArrays());
  for (int n = 0; n < a->GetPointData()->GetNumberOfArrays(); ++n)
  {
    vtkDataArray* const before = a->GetPointData()->GetArray(n);
    vtkDataArray* const after = b->GetPointData()->GetArray(before->GetName());
    CHECK(after && after->GetNumberOfComponents() == before->GetNumberOfComponents());
    for (vtkIdType value = 0; after && value < before->GetNumberOfValues(); ++value)
    {
      const int size = before->GetNumberOfComponents();
      const double expected = before->GetComponent(value / size, int(value % size));
      const double found = after->GetComponent(value / size, int(value % size));
      CHECK(found == expected || (std::isnan(found) && std::isnan(expected)));
    }
  }
}

void MeshesComeBack()
{
  const auto mesh = MakeMesh(459621.05127000005);
  const auto writer = MakeWriter(mesh, "mesh.ts");
  for (const int positive : { vtkGOCADTSurfWriter::Elevation, vtkGOCADTSurfWriter::Depth })
  {
    writer->SetVerticalPositive(positive);
    writer->SetWriteAttributesToAllArrays();
    writer->WriteBordersOn();
    const std::string text = Write(writer);
    CHECK(Has(text, positive == vtkGOCADTSurfWriter::Depth ? "ZPOSITIVE Depth\n" : "ZPOSITIVE Elevation\n"));
    CHECK(Has(text, positive == vtkGOCADTSurfWriter::Depth ? " 0.1 10 7 " : " 0.1 -10 7 "));
    CHECK(Has(text, positive == vtkGOCADTSurfWriter::Depth ? "TRGL 1 3 2\n" : "TRGL 1 2 3\n"));
    CHECK(Has(text, positive == vtkGOCADTSurfWriter::Depth ? "BORDER 5 1 2\n" : "BORDER 5 1 4\n"));
    CHECK(Has(text, "PROPERTIES SurfaceId \"Mean Amplitude\" normal\n"));
    CHECK(Has(text, "NO_DATA_VALUES -99999 -999999 -99999\n"));
    const auto back = ReadBack(writer->GetFileName());
    CHECK_EQUAL(GetName(back, 0), "Horizon 7");
    CheckSamePoints(mesh, GetHorizon(back, 0));
    CheckSameTriangles(mesh, GetHorizon(back, 0));
    CheckSameArrays(mesh, GetHorizon(back, 0));
    const auto again = MakeWriter(back, "again.ts");
    again->SetVerticalPositive(positive);
    again->SetWriteAttributesToAllArrays();
    again->WriteBordersOn();
    CHECK_EQUAL(Write(again), text);
  }
}

void ParametersAreObeyed()
{
  const auto mesh = MakeMesh(0);
  const auto writer = MakeWriter(mesh, "parameters.ts");
  CHECK(Has(Write(writer), "NAME Default\nAXIS_NAME \"X\" \"Y\" \"Z\"\nAXIS_UNIT \"none\" \"none\" \"none\"\n"));
  vtkNew<vtkGOCADTSurfReader> reader;
  reader->SetFileName(writer->GetFileName());
  reader->Update();
  for (const char* const unit : { "VerticalUnit", "HorizontalUnit", "VerticalDomain" })
  {
    CHECK(!GetHorizon(reader->GetOutput(), 0)->GetFieldData()->GetAbstractArray(unit));
  }
  const auto addText = [&mesh](const char* name, const char* text)
  {
    vtkNew<vtkStringArray> array;
    array->SetName(name);
    array->InsertNextValue(text);
    mesh->GetFieldData()->AddArray(array);
  };
  addText("VerticalUnit", "ms");
  addText("HorizontalUnit", "ft");
  addText("CoordinateSystem", "UTM 31N");
  CHECK(Has(Write(writer), "NAME UTM 31N\nAXIS_NAME \"X\" \"Y\" \"Z\"\nAXIS_UNIT \"ft\" \"ft\" \"ms\"\n"));
  writer->SetVerticalUnit("s");
  writer->SetHorizontalUnit("km");
  writer->SetCoordinateSystemName("local");
  writer->SetWriteAttributesToNoArrays();
  const std::string text = Write(writer);
  CHECK(Has(text, "NAME local\nAXIS_NAME \"X\" \"Y\" \"Z\"\nAXIS_UNIT \"km\" \"km\" \"s\"\n"));
  CHECK(!Has(text, "PROPERTIES") && !Has(text, "PVRTX") && !Has(text, "BSTONE") && !Has(text, "BORDER"));
}

/// What stages keep for themselves stays out, and without attributes lines are as RMS has them.
void OnlyAttributesOfPicksAreWritten()
{
  const auto mesh = MakeMesh(0);
  const std::string withAttributes = Write(MakeWriter(mesh, "picks.ts"));
  CHECK(Has(withAttributes, "PROPERTIES \"Mean Amplitude\" normal\n") && !Has(withAttributes, "CNXYZ"));
  mesh->GetPointData()->Initialize();
  for (const char* const name : { "SurfaceId", "Column", "Elevation", "VerticalIndex", "RealZ", "PatchId", "Boundary",
         "PointCount", "CellOrigin", "Flatness", "Distance", "VerticalDistance", "Filled", "Spike" })
  {
    AddPointArray<vtkDoubleArray>(mesh, name, { 7, 8, 9, 10 }, 1);
  }
  const auto writer = MakeWriter(mesh, "own.ts");
  const std::string text = Write(writer);
  CHECK(Has(text, "END_ORIGINAL_COORDINATE_SYSTEM\nTFACE\nVRTX 1 0 0.1 -10 CNXYZ\nVRTX 2 "));
  CHECK(Has(text, "CNXYZ\nTRGL 1 2 3\nTRGL 1 3 4\nEND\n"));
  writer->SetWriteAttributesToAllArrays();
  CHECK(Has(Write(writer), "PROPERTIES SurfaceId Column Elevation "));
}

void HorizonsShareAFile()
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(0, MakeMesh(1));
  blocks->SetBlock(0, inner);
  blocks->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "top: A");
  blocks->SetBlock(1, vtkNew<vtkPolyData>());
  blocks->SetBlock(2, MakeMesh(2));
  const auto third = MakeMesh(3);
  third->GetPointData()->RemoveArray("SurfaceId");
  blocks->SetBlock(3, third);
  blocks->SetBlock(4, MakeMesh(4));
  Write(MakeWriter(blocks, "several.ts"));
  const auto back = ReadBack(Folder + "/several.ts");
  CHECK_EQUAL(back->GetNumberOfPartitionedDataSets(), 4u);
  const std::vector<std::string> names = { "top: A", "Horizon 7", "several", "Horizon 7 (2)" };
  for (unsigned int n = 0; n < 4; ++n)
  {
    CHECK_EQUAL(GetName(back, n), names[n]);
    CHECK_EQUAL(GetHorizon(back, n)->GetPoint(0)[0], n + 1.0);
  }
}

/// A point that no triangle has, ghosts, text, arrays of cells, and numbers that are not finite.
void OnlyWhatBelongsToTrianglesIsWritten()
{
  const auto mesh = MakeMesh(0);
  mesh->GetPoints()->InsertNextPoint(std::nan(""), 0, 0);
  mesh->GetPointData()->Initialize();
  const double infinite = std::numeric_limits<double>::infinity();
  AddPointArray<vtkDoubleArray>(mesh, "a", { infinite, 1, 2, -infinite, 3 }, 1);
  AddPointArray<vtkUnsignedCharArray>(mesh, "vtkGhostType", { 0, 0, 0, 0, 0 }, 1);
  vtkNew<vtkStringArray> labels;
  labels->SetName("labels");
  labels->SetNumberOfValues(5);
  mesh->GetPointData()->AddArray(labels);
  const std::string text = Write(MakeWriter(mesh, "used.ts"));
  CHECK(Has(text, "PROPERTIES a\n") && Has(text, "TFACE\nPVRTX 1 0 0.1 -10 -99999\n"));
  CHECK(Has(text, "PVRTX 4 ") && !Has(text, "PVRTX 5 ") && !Has(text, "nan"));
}

void PartsComeBack()
{
  const auto mesh = MakeMesh(0);
  vtkNew<vtkIntArray> parts; // of the vertex cell, the line, and the triangles
  parts->SetName("Part");
  for (const int part : { 5, 5, 1, 0 })
  {
    parts->InsertNextValue(part);
  }
  mesh->GetCellData()->AddArray(parts);
  const std::string text = Write(MakeWriter(mesh, "parts.ts"));
  CHECK(Has(text, "TRGL 1 2 3\nTFACE\nATOM 4 1\nPVRTX 5 0.3333333333333333 ") && Has(text, "ATOM 6 2\nTRGL 4 5 6\n"));
  const auto back = ReadBack(Folder + "/parts.ts");
  auto* const read = vtkIntArray::SafeDownCast(GetHorizon(back, 0)->GetCellData()->GetArray("Part"));
  CHECK(read && read->GetValue(0) == 0 && read->GetValue(1) == 1);
  Write(MakeWriter(back, "parts again.ts")); // without atoms, as these are points of their own now
  const auto again = ReadBack(Folder + "/parts again.ts");
  CheckSamePoints(GetHorizon(back, 0), GetHorizon(again, 0));
  CheckSameTriangles(GetHorizon(back, 0), GetHorizon(again, 0));
}

void CheckError(
  vtkGOCADTSurfWriter* writer, const std::string& message, unsigned long code = vtkErrorCode::UnknownError)
{
  const Errors errors(writer);
  CHECK_EQUAL(writer->Write(), 0);
  CHECK_EQUAL(writer->GetErrorCode(), code);
  CHECK_EQUAL(errors.Count(), 1u);
  CHECK(errors.FirstContains(message));
  if (!errors.FirstContains(message))
  {
    std::cerr << errors.First() << '\n';
  }
}

void WrongInputGivesOneErrorEach()
{
  const std::string path = WriteText(Folder + "/kept.ts", "as it was");
  const auto check = [&path](vtkDataObject* input, const std::string& message)
  {
    CheckError(MakeWriter(input, "kept.ts"), path + ": " + message);
    CHECK_EQUAL(ReadText(path), "as it was");
  };
  check(vtkNew<vtkPolyData>(), "no horizon with points, expected something to write");
  check(vtkNew<vtkPartitionedDataSetCollection>(), "no horizon with points, expected something to write");
  const auto points = MakeMesh(0);
  points->SetPolys(nullptr);
  check(points,
    "Horizon 7: 4 points without triangles, expected a mesh, as the triangulation makes it; leave out horizons "
    "of one line");
  vtkNew<vtkMultiBlockDataSet> blocks; // one without triangles beside one that has them
  blocks->SetBlock(0, MakeMesh(0));
  blocks->SetBlock(1, points);
  blocks->GetMetaData(1u)->Set(vtkCompositeDataSet::NAME(), "thin");
  check(blocks, "thin: 4 points without triangles, expected a mesh");
  const auto quads = MakeMesh(0);
  quads->GetPolys()->InsertNextCell({ 0, 1, 2, 3 });
  check(quads, "Horizon 7: polygon 2 with 4 corners, expected triangles: apply Triangulate first");
  const auto strips = MakeMesh(0);
  vtkNew<vtkCellArray> strip;
  strip->InsertNextCell({ 0, 1, 2, 3 });
  strips->SetStrips(strip);
  check(strips, "Horizon 7: 1 triangle strips, expected triangles: apply Triangulate first");
  const auto wild = MakeMesh(0);
  wild->GetPolys()->InsertNextCell({ 0, 1, 4 });
  check(wild, "Horizon 7: triangle 2 has the corner 4, expected points from 0 to 3");
  const auto nowhere = MakeMesh(std::nan(""));
  check(nowhere, "Horizon 7: coordinate nan of point 0, expected a finite number");
}

void WrongPlacesGiveOneErrorEach()
{
  const auto mesh = MakeMesh(0);
  vtkNew<vtkGOCADTSurfWriter> nameless;
  nameless->SetInputData(mesh);
  CheckError(nameless, "no FileName, expected the path of a file", vtkErrorCode::NoFileNameError);
  CheckError(MakeWriter(mesh, "none/x.ts"), "/none\" does not exist", vtkErrorCode::CannotOpenFileError);
  const auto full = MakeWriter(mesh, "x");
  full->SetFileName("/dev/full");
  CheckError(full, "/dev/full: Horizon 7: writing failed after 0 bytes, expected disk space for the rest of the file",
    vtkErrorCode::OutOfDiskSpaceError);
  full->SetFileName((Folder + "/x.ts").c_str());
  Write(full); // works after an error
  CHECK_EQUAL(full->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
}

void AllIsPrinted()
{
  vtkNew<vtkGOCADTSurfWriter> writer;
  writer->SetFileName("file");
  writer->SetVerticalPositiveToDepth();
  writer->SetVerticalUnit("vu");
  writer->SetHorizontalUnit("hu");
  writer->SetCoordinateSystemName("cs");
  writer->WriteBordersOn();
  std::ostringstream text;
  writer->Print(text);
  for (const char* const line : { "FileName: file", "VerticalPositive: Depth", "VerticalUnit: vu", "HorizontalUnit: hu",
         "CoordinateSystemName: cs", "WriteAttributes: PickArrays", "WriteBorders: on" })
  {
    CHECK(Has(text.str(), line));
  }
}
}

int TestGOCADTSurfWriter(int argc, char* argv[])
{
  Folder = MakeFolder(argc, argv, "TestGOCADTSurfWriter");
  MeshesComeBack();
  ParametersAreObeyed();
  OnlyAttributesOfPicksAreWritten();
  HorizonsShareAFile();
  OnlyWhatBelongsToTrianglesIsWritten();
  PartsComeBack();
  WrongInputGivesOneErrorEach();
  WrongPlacesGiveOneErrorEach();
  AllIsPrinted();
  return Check::Result();
}
