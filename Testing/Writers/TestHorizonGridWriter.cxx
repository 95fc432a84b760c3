// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The writer of grids: what is written is read again as the same horizon, also from a mesh.

#include "Filters/HorizonFixtures.h"
#include "Readers/FileFixtures.h"
#include "Tools/Check.h"
#include "WriterFixtures.h"

#include "vtkHorizonExteriorBoundary.h"
#include "vtkHorizonGridReader.h"
#include "vtkHorizonGridWriter.h"
#include "vtkHorizonTextReader.h"
#include "vtkHorizonTextWriter.h"
#include "vtkHorizonTriangulation.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"

#include <cmath>

using namespace WriterFixtures;
using HorizonFixtures::Errors;

namespace
{
vtkSmartPointer<vtkPolyData> Mesh(vtkPolyData* points)
{
  vtkNew<vtkHorizonExteriorBoundary> boundary;
  boundary->SetInputDataObject(points);
  vtkNew<vtkHorizonTriangulation> triangulation;
  triangulation->SetInputConnection(boundary->GetOutputPort());
  triangulation->Update();
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->ShallowCopy(triangulation->GetOutputDataObject(0));
  return mesh;
}

void GridsComeBack()
{
  const auto picks = ReadPicks(MakePicks("Top", false));
  vtkNew<vtkHorizonGridWriter> writer;
  writer->SetInputDataObject(picks->GetOutput());
  writer->SetFileName((Folder + "/out.irap").c_str());
  CHECK_EQUAL(writer->Write(), 1);
  vtkNew<vtkHorizonGridReader> reader;
  reader->SetFileName((Folder + "/out.irap").c_str());
  reader->Update();
  CheckSamePoints(GetHorizon(picks->GetOutput(), 0), GetHorizon(reader->GetOutput(), 0));
}

/// The horizon as it is read from a file into which it was written, with a warning where one is expected.
vtkSmartPointer<vtkPolyData> WriteAndRead(vtkDataObject* horizon, const std::string& file, const std::string& warning)
{
  vtkNew<vtkHorizonGridWriter> writer;
  const Errors warnings(writer, vtkCommand::WarningEvent);
  writer->SetInputDataObject(horizon);
  writer->SetFileName((Folder + '/' + file).c_str());
  CHECK_EQUAL(writer->Write(), 1);
  CHECK_EQUAL(warnings.Count(), std::size_t(warning.empty() ? 0 : 1));
  CHECK(warning.empty() || warnings.FirstContains(warning));
  vtkNew<vtkHorizonGridReader> reader;
  reader->SetFileName((Folder + '/' + file).c_str());
  reader->Update();
  return GetHorizon(reader->GetOutput(), 0);
}

/// The turned plane with the missing column: nodes between columns lie on it, fewer than there are columns.
void TurnedLatticesAreResampledForZmap()
{
  const auto picks = ReadPicks(MakePicks("Top", false));
  const auto found = WriteAndRead(picks->GetOutput(), "turned.zmap",
    "turned.zmap: Top: the format has no rotation: resampled on a lattice along the axes of 8 x 8 nodes; IRAP keeps "
    "the "
    "lattice");
  CHECK(found->GetNumberOfPoints() > 10 && found->GetNumberOfPoints() < 35);
  for (vtkIdType point = 0; point < found->GetNumberOfPoints(); ++point)
  {
    const double* const place = found->GetPoint(point);
    const double x = place[0] - 604321.25;
    const double y = place[1] - 6079543.5;
    const double i = (12.0 * x + 9.0 * y) / 225.0;
    const double j = (-9.0 * x + 12.0 * y) / 225.0;
    CHECK(i > -1e-6 && i < 5.0 + 1e-6 && j > -1e-6 && j < 5.0 + 1e-6);
    CHECK(std::abs(i - 3.0) > 1.0 - 1e-6 || std::abs(j - 2.0) > 1.0 - 1e-6);
    CHECK(std::abs(place[2] + 1500.0 + 2.0 * i + 0.5 * j) < 1e-6);
  }
}

/// Places in the millions are rounded to half a metre, which is told; small ones and values are not.
void BinaryGridsComeBack()
{
  const auto picks = ReadPicks(MakePicks("Top", false));
  const auto exact = WriteAndRead(picks->GetOutput(), "out.gri", ""); // quarters of a metre, and halves
  CheckSamePlaces(GetHorizon(picks->GetOutput(), 0), exact, 1e-3);
  CHECK_EQUAL(ReadText(Folder + "/out.gri").substr(0, 8), std::string("\0\0\0\x20\xFF\xFF\xFC\x1C", 8));
  vtkPolyData* const horizon = GetHorizon(picks->GetOutput(), 0);
  horizon->GetFieldData()->GetArray("LatticeToWorld")->SetComponent(0, 7, 6079543.7); // y of column (0, 0)
  horizon->GetPoints()->GetData()->FillComponent(2, -1.0);
  auto moved = vtkSmartPointer<vtkPolyData>::New();
  moved->DeepCopy(horizon);
  for (vtkIdType point = 0; point < moved->GetNumberOfPoints(); ++point)
  {
    const double* const place = moved->GetPoint(point);
    moved->GetPoints()->SetPoint(point, place[0], place[1] + 0.2, place[2]);
  }
  CheckSamePlaces(
    moved, WriteAndRead(moved, "rounded.gri", "coordinates are rounded to single precision, by up to 0.2"), 0.25);
  WriteAndRead(moved, "kept.irap", "");
}

/// ZMAP+ holds what is along the axes.
void ExtensionsTellTheFormat()
{
  const auto picks = ReadPicks("X Y Z\n0 0 5\n10 0 6\n0 20 7\n10 20 8\n");
  for (const std::string file : { "axes.ZMAP", "axes.irap" })
  {
    vtkNew<vtkHorizonGridWriter> writer;
    writer->SetInputDataObject(picks->GetOutput());
    writer->SetFileName((Folder + '/' + file).c_str());
    CHECK_EQUAL(writer->Write(), 1);
    CHECK_EQUAL(ReadText(Folder + '/' + file).substr(0, 4) == "-996", file == "axes.irap");
    vtkNew<vtkHorizonGridReader> reader;
    reader->SetFileName((Folder + '/' + file).c_str());
    reader->Update();
    CheckSamePoints(GetHorizon(picks->GetOutput(), 0), GetHorizon(reader->GetOutput(), 0));
  }
}

/// A mesh covers the column that the points lack.
void MeshesAreSampled()
{
  const auto picks = ReadPicks(MakePicks("Top", false));
  const auto complete = ReadPicks(MakePicks("Top", true));
  vtkNew<vtkHorizonGridWriter> writer;
  writer->SetInputDataObject(Mesh(GetHorizon(picks->GetOutput(), 0)));
  writer->SetFileName((Folder + "/mesh.irap").c_str());
  writer->SetVerticalPositiveToElevation();
  CHECK_EQUAL(writer->Write(), 1);
  vtkNew<vtkHorizonGridReader> reader;
  reader->SetFileName((Folder + "/mesh.irap").c_str());
  reader->SetVerticalDirectionToUp();
  reader->Update();
  CheckSamePoints(GetHorizon(complete->GetOutput(), 0), GetHorizon(reader->GetOutput(), 0));
}

/// A file for each, by their names.
void GridsHaveFilesOfTheirOwn()
{
  const auto picks = ReadPicks(MakePicks("\"Top/Reek\"", true) + MakePicks("\"Top:Reek\"", false));
  vtkNew<vtkHorizonGridWriter> writer;
  writer->SetInputDataObject(picks->GetOutput());
  writer->SetFileName((Folder + "/two.irap").c_str());
  CHECK_EQUAL(writer->Write(), 1);
  CHECK(!std::filesystem::exists(Folder + "/two.irap"));
  CHECK(std::filesystem::exists(Folder + "/two_Top_Reek.irap"));
  CHECK(std::filesystem::exists(Folder + "/two_Top_Reek (2).irap"));
}

/// Here the second of two cannot be written.
void SeveralFilesAreWrittenAllOrNone()
{
  const auto picks = ReadPicks(MakePicks("Good", true) + MakePicks("Bad", true));
  GetHorizon(picks->GetOutput(), 1)->GetFieldData()->RemoveArray("LatticeToWorld");
  const std::string folder = Folder + "/several";
  std::filesystem::create_directory(folder);
  vtkNew<vtkHorizonGridWriter> writer;
  const Errors errors(writer);
  writer->SetInputDataObject(picks->GetOutput());
  writer->SetFileName((folder + "/two.irap").c_str());
  CHECK_EQUAL(writer->Write(), 0);
  CHECK(errors.FirstContains("two_Bad.irap: no field data array LatticeToWorld"));
  CHECK(std::filesystem::is_empty(folder));
}

/// One error that has the text, and no file.
void CheckRefused(vtkHorizonWriter* writer, vtkDataObject* input, const std::string& message)
{
  const Errors errors(writer);
  const std::string file = Folder + "/refused";
  writer->SetInputDataObject(input);
  writer->SetFileName(file.c_str());
  CHECK_EQUAL(writer->Write(), 0);
  CHECK_EQUAL(errors.Count(), std::size_t(1));
  CHECK(errors.FirstContains(message));
  CHECK(!std::filesystem::exists(file));
}

void WhatCanNotBeIsRefused()
{
  const auto picks = ReadPicks(MakePicks("Top", true));
  vtkPolyData* const horizon = GetHorizon(picks->GetOutput(), 0);
  vtkNew<vtkHorizonGridWriter> empty;
  CheckRefused(empty, vtkSmartPointer<vtkPolyData>::New(), "no horizon with points, expected something to write");
  auto quads = Mesh(horizon);
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell({ 0, 1, 7, 6 });
  quads->SetPolys(polygons);
  quads->GetCellData()->Initialize();
  vtkNew<vtkHorizonTextWriter> text;
  CheckRefused(text, quads, "polygon 0 with 4 corners, expected triangles");
  auto bare = vtkSmartPointer<vtkPolyData>::New();
  bare->ShallowCopy(horizon);
  bare->SetFieldData(vtkSmartPointer<vtkFieldData>::New());
  vtkNew<vtkHorizonTextWriter> placeless;
  CheckRefused(placeless, bare, "no field data array LatticeDimensions, expected");
  auto huge = vtkSmartPointer<vtkPolyData>::New();
  huge->DeepCopy(horizon);
  huge->GetPointData()->GetArray("Attribute 1")->SetTuple1(0, 2e30);
  vtkNew<vtkHorizonTextWriter> tooLarge;
  CheckRefused(tooLarge, huge, "Attribute 1 of 1e30 or more, which means no value; expected less");
}

/// What breaks the rules of VTK, or of the data model.
void BrokenHorizonsAreRefused()
{
  const auto picks = ReadPicks(MakePicks("Top", true));
  vtkPolyData* const horizon = GetHorizon(picks->GetOutput(), 0);
  const auto check = [&](const auto& spoil, const std::string& message)
  {
    auto broken = vtkSmartPointer<vtkPolyData>::New();
    broken->DeepCopy(horizon);
    spoil(broken.Get());
    vtkNew<vtkHorizonTextWriter> writer;
    CheckRefused(writer, broken, message);
  };
  check([](vtkPolyData* data) { data->GetPointData()->GetArray("Attribute 1")->SetNumberOfTuples(3); },
    "array Attribute 1 of 3 tuples, expected one for each of the 36 points");
  check(
    [](vtkPolyData* data)
    {
      vtkNew<vtkCellArray> triangles;
      triangles->InsertNextCell({ 0, 1, 36 });
      data->SetPolys(triangles);
    },
    "point ids 0 to 36 in triangle 0, expected 0 to 35");
  check([](vtkPolyData* data) { data->GetFieldData()->GetArray("LineNumbers")->FillComponent(1, 0.0); },
    "LineNumbers (100, 0, 7, 1), expected finite numbers, and steps other than 0");
}

/// A grid would have a value for each of 10^10 columns; text has a line for each point, and the same as in a small
/// lattice.
void FarColumnsAreOnlyListed()
{
  const auto picks = ReadPicks(MakePicks("Top", false));
  vtkPolyData* const horizon = GetHorizon(picks->GetOutput(), 0);
  auto far = vtkSmartPointer<vtkPolyData>::New();
  far->DeepCopy(horizon);
  far->GetFieldData()->GetArray("LatticeDimensions")->Fill(100000.0);
  vtkNew<vtkHorizonGridWriter> grid;
  CheckRefused(grid, far,
    "lattice of 100000 x 100000 columns, expected less than 2^31 in all for a file that lists them; "
    "the horizon has 35 points");
  const auto wide = vtkSmartPointer<vtkPolyData>::New();
  wide->DeepCopy(horizon);
  wide->GetFieldData()->GetArray("LatticeDimensions")->Fill(3000.0);
  CheckRefused(grid, wide,
    "lattice of 3000 x 3000 columns, of which the horizon has 35, expected at least one in 10000 for a grid file");
  for (const bool isFar : { false, true })
  {
    vtkNew<vtkHorizonTextWriter> text;
    text->SetInputDataObject(isFar ? far.Get() : horizon);
    text->SetFileName((Folder + (isFar ? "/far.dat" : "/near.dat")).c_str());
    CHECK_EQUAL(text->Write(), 1);
  }
  CHECK_EQUAL(ReadText(Folder + "/far.dat"), ReadText(Folder + "/near.dat"));
}

/// What cannot be printed has no place in a name, and would not be read again.
void NamesCanBePrinted()
{
  const auto picks = ReadPicks(MakePicks("A", true) + MakePicks("B", false));
  picks->GetOutput()->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "A\x01\n\"B\"");
  vtkNew<vtkHorizonTextWriter> writer;
  writer->SetInputDataObject(picks->GetOutput());
  writer->SetFileName((Folder + "/names.dat").c_str());
  CHECK_EQUAL(writer->Write(), 1);
  vtkNew<vtkHorizonTextReader> reader;
  reader->SetFileName((Folder + "/names.dat").c_str());
  reader->Update();
  CHECK_EQUAL(GetName(reader->GetOutput(), 0), std::string("A  'B'"));
}
}

int TestHorizonGridWriter(int argc, char* argv[])
{
  Folder = MakeFolder(argc, argv, "HorizonGridWriter");
  GridsComeBack();
  TurnedLatticesAreResampledForZmap();
  BinaryGridsComeBack();
  ExtensionsTellTheFormat();
  MeshesAreSampled();
  GridsHaveFilesOfTheirOwn();
  SeveralFilesAreWrittenAllOrNone();
  WhatCanNotBeIsRefused();
  BrokenHorizonsAreRefused();
  FarColumnsAreOnlyListed();
  NamesCanBePrinted();
  return Check::Result();
}
