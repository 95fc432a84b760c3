// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The writer of picks: what is written is read again as the same horizon.

#include "WriterFixtures.h"

#include "vtkHorizonTextWriter.h"

#include "vtkFieldData.h"
#include "vtkPointData.h"

using namespace WriterFixtures;

namespace
{
void TextComesBack()
{
  const auto picks = ReadPicks(MakePicks("\"Top Reek\"", true) + MakePicks("Base", false));
  vtkNew<vtkHorizonTextWriter> writer;
  writer->SetInputDataObject(picks->GetOutput());
  writer->SetFileName((Folder + "/out.dat").c_str());
  CHECK_EQUAL(writer->Write(), 1);
  const std::string text = ReadText(Folder + "/out.dat");
  CHECK_EQUAL(
    text.substr(0, text.find('\n')), std::string("# \"Inline\"\t\"Crossline\"\t\"X\"\t\"Y\"\t\"Z\"\t\"Attribute 1\""));
  vtkNew<vtkHorizonTextReader> reader;
  reader->SetFileName((Folder + "/out.dat").c_str());
  reader->Update();
  for (unsigned int horizon = 0; horizon < 2; ++horizon)
  {
    vtkPolyData* const before = GetHorizon(picks->GetOutput(), horizon);
    vtkPolyData* const after = GetHorizon(reader->GetOutput(), horizon);
    CHECK_EQUAL(GetName(reader->GetOutput(), horizon), GetName(picks->GetOutput(), horizon));
    CheckSamePoints(before, after);
    for (vtkIdType point = 0; point < before->GetNumberOfPoints(); ++point)
    {
      CHECK_EQUAL(before->GetPointData()->GetArray("Attribute 1")->GetTuple1(point),
        after->GetPointData()->GetArray("Attribute 1")->GetTuple1(point));
    }
  }
  writer->WriteAttributesOff();
  writer->SetVerticalPositiveToElevation();
  CHECK_EQUAL(writer->Write(), 1);
  CHECK(ReadText(Folder + "/out.dat").find("\"Top Reek\"\t100\t7\t604321.25\t6079543.5\t-1500\n") != std::string::npos);
}

/// The header says what the reader would not know.
void DirectionAndUnitsComeBack()
{
  const auto picks = ReadPicks("0.5 0 -5\n10.5 0 6\n0.5 20 7\n10.5 20 8\n");
  picks->SetVerticalDirectionToUp();
  picks->SetVerticalUnit("ft");
  picks->SetHorizontalUnit("m");
  picks->Update();
  vtkNew<vtkHorizonTextWriter> writer;
  writer->SetInputConnection(picks->GetOutputPort());
  writer->SetFileName((Folder + "/up.dat").c_str());
  CHECK_EQUAL(writer->Write(), 1);
  CHECK(ReadText(Folder + "/up.dat").find("\"X (m)\"\t\"Y (m)\"\t\"Elevation (ft)\"\n") != std::string::npos);
  vtkNew<vtkHorizonTextReader> reader;
  reader->SetFileName((Folder + "/up.dat").c_str());
  reader->Update();
  CheckSamePoints(GetHorizon(picks->GetOutput(), 0), GetHorizon(reader->GetOutput(), 0));
}

/// Without line numbers there are places alone, and values that are missing are 1e30.
void TextOfOneWithoutLines()
{
  const auto picks = ReadPicks("0.5 0 5 7\n10.5 0 6 1e30\n0.5 20 7 9\n10.5 20 8 11\n");
  CHECK_EQUAL(GetHorizon(picks->GetOutput(), 0)->GetNumberOfPoints(), 4);
  vtkPolyData* const horizon = GetHorizon(picks->GetOutput(), 0);
  horizon->GetFieldData()->RemoveArray("LineNumbers");
  vtkNew<vtkHorizonTextWriter> writer;
  writer->SetInputDataObject(horizon);
  writer->SetFileName((Folder + "/one.dat").c_str());
  CHECK_EQUAL(writer->Write(), 1);
  const std::string text = ReadText(Folder + "/one.dat");
  CHECK(text.find("# \"X\"\t\"Y\"\t\"Z\"\t") == 0);
  CHECK(text.find("\t6\t1e30\n") != std::string::npos);
}
}

int TestHorizonTextWriter(int argc, char* argv[])
{
  Folder = MakeFolder(argc, argv, "HorizonTextWriter");
  TextComesBack();
  DirectionAndUnitsComeBack();
  TextOfOneWithoutLines();
  return Check::Result();
}
