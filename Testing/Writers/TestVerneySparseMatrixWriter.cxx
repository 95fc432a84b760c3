// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The writer of sparse-matrix files: that files come back from the reader, what it makes up, and its errors.

#include "Filters/HorizonFixtures.h"
#include "Readers/FileFixtures.h"
#include "Tools/Check.h"

#include "vtkHorizonExteriorBoundary.h"
#include "vtkVerneySparseMatrixReader.h"
#include "vtkVerneySparseMatrixWriter.h"

#include <cmath>

using namespace FileFixtures;
using HorizonFixtures::Errors;

namespace
{
constexpr const char* Small = "2 2 10\n"
                              "3 2 1.5 10 12.5 8 7 1 1 32\n"
                              "4 2 1 1 16\n"
                              "\n"
                              "6 7 3 -3 24.25\n";

/// The folder for files of this test.
std::string Folder;

vtkSmartPointer<vtkVerneySparseMatrixReader> MakeReader(const std::string& text)
{
  auto reader = vtkSmartPointer<vtkVerneySparseMatrixReader>::New();
  reader->SetFileName(WriteText(Folder + "/in.vsm", text).c_str());
  return reader;
}

vtkSmartPointer<vtkVerneySparseMatrixWriter> MakeWriter(vtkDataObject* input)
{
  auto writer = vtkSmartPointer<vtkVerneySparseMatrixWriter>::New();
  writer->SetInputData(input);
  writer->SetFileName((Folder + "/out.vsm").c_str());
  return writer;
}

std::string Write(vtkDataObject* input)
{
  CHECK_EQUAL(MakeWriter(input)->Write(), 1);
  return ReadText(Folder + "/out.vsm");
}

vtkPartitionedDataSetCollection* Read(vtkVerneySparseMatrixReader* reader)
{
  reader->Update();
  return reader->GetOutput();
}

/// Whatever the survey, and wherever z comes from.
void NormalFilesStayAsTheyAre()
{
  const auto reader = MakeReader(Small);
  CHECK_EQUAL(Write(Read(reader)), Small);
  reader->SetOrigin(604321.25, 6079543.5, -100);
  reader->SetColumnStep(10.8, 6.25);
  reader->SetRowStep(-12.5, 21.6);
  reader->SetVerticalStep(4);
  CHECK_EQUAL(Write(Read(reader)), Small);
  reader->SetZFromToRealZ();
  CHECK_EQUAL(Write(Read(reader)), Small);
  reader->SetVerticalDirectionToUp();
  CHECK_EQUAL(Write(Read(reader)), Small);
}

void BoundariesDoNotMatter()
{
  const auto reader = MakeReader(Small);
  vtkNew<vtkHorizonExteriorBoundary> boundary;
  boundary->SetInputConnection(reader->GetOutputPort());
  boundary->Update();
  CHECK_EQUAL(Write(boundary->GetOutputDataObject(0)), Small);
}

void SingleHorizonsAreWritten()
{
  const auto reader = MakeReader(Small);
  CHECK_EQUAL(Write(GetHorizon(Read(reader), 1)), "2 2 10\n8 7 1 1 32\n\n\n6 7 3 -3 24.25\n");
}

void WhatIsMissingIsMadeUp()
{
  const auto reader = MakeReader(Small);
  reader->SetOrigin(0, 0, 100);
  reader->SetVerticalStep(5);
  vtkPartitionedDataSetCollection* const horizons = Read(reader);
  GetHorizon(horizons, 0)->GetPointData()->Initialize();
  CHECK_EQUAL(Write(horizons), "2 2 10\n3 1 1 0 -85 8 7 1 1 32\n4 1 1 0 -80\n\n6 7 3 -3 24.25\n");
  reader->SetVerticalDirectionToUp();
  vtkPartitionedDataSetCollection* const risen = Read(reader);
  GetHorizon(risen, 0)->GetPointData()->Initialize();
  GetHorizon(risen, 1)->GetPointData()->Initialize();
  CHECK_EQUAL(Write(risen), "2 2 10\n3 1 1 0 115 8 2 1 0 140\n4 1 1 0 120\n\n6 2 1 0 130\n");
}

/// Positions of doubles, and of what Clip and others make of them in single precision.
void FloatPointsStandOnTheirColumns()
{
  const auto reader = MakeReader(Small);
  reader->SetOrigin(604321.25, 6079543.5, -100);
  reader->SetColumnStep(25, 0);
  reader->SetRowStep(0, 25);
  vtkPolyData* const horizon = GetHorizon(Read(reader), 0);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  for (vtkIdType point = 0; point < horizon->GetNumberOfPoints(); ++point)
  {
    points->InsertNextPoint(horizon->GetPoint(point));
  }
  horizon->SetPoints(points);
  CHECK_EQUAL(Write(horizon), "2 2 10\n3 2 1.5 10 12.5\n4 2 1 1 16\n\n\n");
}

void CheckRefused(vtkDataObject* input, const std::string& message)
{
  const std::string path = WriteText(Folder + "/out.vsm", "as it was");
  const auto writer = MakeWriter(input);
  const Errors errors(writer);
  CHECK_EQUAL(writer->Write(), 0);
  CHECK_EQUAL(errors.Count(), 1u);
  CHECK(errors.FirstContains(path + ": " + message));
  if (!errors.FirstContains(message))
  {
    std::cerr << errors.First() << '\n';
  }
  CHECK_EQUAL(ReadText(path), "as it was");
}

void WrongHorizonsGiveOneErrorEach()
{
  const auto refuse = [](auto&& change, const std::string& message)
  {
    const auto reader = MakeReader(Small);
    vtkPartitionedDataSetCollection* const horizons = Read(reader);
    change(GetHorizon(horizons, 0), GetHorizon(horizons, 1));
    CheckRefused(horizons, message);
  };
  refuse([](vtkPolyData* first, vtkPolyData*) { first->GetPoints()->SetPoint(1, 0.5, 0, -4); },
    "Horizon 2: point 1 at (0.5");
  refuse([](vtkPolyData* first, vtkPolyData*) { first->GetFieldData()->RemoveArray("LatticeToWorld"); },
    "Horizon 2: no field data array LatticeToWorld, expected 16 values");
  refuse([](vtkPolyData*, vtkPolyData* second)
    { vtkIntArray::SafeDownCast(second->GetFieldData()->GetArray("LatticeDimensions"))->SetValue(1, 3); },
    "Horizon 7: a lattice of 2 x 3 x 10 cells, expected 2 x 2 x 10 as in Horizon 2");
  refuse([](vtkPolyData*, vtkPolyData* second)
    { vtkDoubleArray::SafeDownCast(second->GetFieldData()->GetArray("LatticeToWorld"))->SetValue(11, -7.0); },
    "Horizon 7: vertical indices from -7 in steps of -1, expected from 0 in steps of -1 as in Horizon 2; with "
    "VerticalStep");
  refuse([](vtkPolyData*, vtkPolyData* second) { second->GetPointData()->GetArray("SurfaceId")->Fill(2); },
    "two horizons with the surface ID 2, expected one ID for each");
  refuse([](vtkPolyData*, vtkPolyData* second) { second->GetPointData()->GetArray("SurfaceId")->SetTuple1(0, 3); },
    "Horizon 7: points with surface IDs from 3 to 7, expected one ID in a horizon");
  refuse([](vtkPolyData*, vtkPolyData* second) { second->GetPointData()->GetArray("VerticalIndex")->SetTuple1(0, 3); },
    "two voxels in the cell (0, 0, 3), of the surface IDs");
  refuse([](vtkPolyData*, vtkPolyData* second) { second->GetPointData()->GetArray("VerticalIndex")->SetTuple1(0, 10); },
    "k = 10 of voxel 0 of the horizon with the surface ID 7, expected 0 to 9");
  refuse(
    [](vtkPolyData* first, vtkPolyData*)
    {
      vtkNew<vtkDoubleArray> averaged;
      averaged->SetName("VerticalIndex");
      averaged->InsertNextValue(3);
      averaged->InsertNextValue(3.5);
      first->GetPointData()->AddArray(averaged);
    },
    "Horizon 2: VerticalIndex 3.500000 at point 1, expected an integer of 32 bits");
  refuse([](vtkPolyData* first, vtkPolyData*) { first->GetPointData()->GetArray("RealZ")->SetTuple1(0, HUGE_VAL); },
    "inf as thickness, amplitude or real z");
  refuse(
    [](vtkPolyData* first, vtkPolyData*)
    {
      vtkNew<vtkDoubleArray> pairs;
      pairs->SetName("Amplitude");
      pairs->SetNumberOfComponents(2);
      pairs->SetNumberOfTuples(2);
      first->GetPointData()->AddArray(pairs);
    },
    "Horizon 2: point array Amplitude with 2 components, expected 1");
  refuse(
    [](vtkPolyData* first, vtkPolyData*)
    {
      vtkNew<vtkDoubleArray> none;
      none->SetName("Mine");
      first->GetPointData()->AddArray(none);
    },
    "Horizon 2: array Mine of 0 tuples, expected one for each of the 2 points");
}
}

int TestVerneySparseMatrixWriter(int argc, char* argv[])
{
  Folder = MakeFolder(argc, argv, "TestVerneySparseMatrixWriter");
  NormalFilesStayAsTheyAre();
  BoundariesDoNotMatter();
  SingleHorizonsAreWritten();
  WhatIsMissingIsMadeUp();
  FloatPointsStandOnTheirColumns();
  WrongHorizonsGiveOneErrorEach();
  return Check::Result();
}
