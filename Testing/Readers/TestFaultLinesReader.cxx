// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The reader of fault lines: its dataset, and errors. The formats are checked in TestFaultLineFile.

#include "FileFixtures.h"
#include "Tools/Check.h"

#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkExecutive.h"
#include "vtkFaultLinesReader.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <sstream>

namespace
{
/// The error of an update; empty when there is none.
std::string UpdateError(vtkFaultLinesReader* reader)
{
  std::string message;
  vtkNew<vtkCallbackCommand> collect;
  collect->SetClientData(&message);
  collect->SetCallback([](vtkObject*, unsigned long, void* text, void* data)
    { *static_cast<std::string*>(text) = static_cast<const char*>(data); });
  vtkNew<vtkCallbackCommand> ignore;
  ignore->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  reader->AddObserver(vtkCommand::ErrorEvent, collect);
  reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, ignore);
  reader->Modified();
  reader->Update();
  reader->RemoveObserver(collect);
  return message;
}

bool Contains(const std::string& text, const std::string& part)
{
  const bool found = text.find(part) != std::string::npos;
  if (!found)
  {
    std::cerr << text << '\n';
  }
  return found;
}
}

int TestFaultLinesReader(int argc, char* argv[])
{
  const std::string folder = FileFixtures::MakeFolder(argc, argv, "TestFaultLinesReader");
  vtkNew<vtkFaultLinesReader> reader;
  CHECK(Contains(UpdateError(reader), "no FileName, expected the path of a file"));
  const std::string path = FileFixtures::WriteText(
    folder + "/faults.txt", "604321.25 6079543.5 1850 F1\n604400 6079600 1851 F1\n1 2 3 F2\n4 5 6 F2\n1 2 3 F2\n");
  reader->SetFileName(path.c_str());
  CHECK_EQUAL(UpdateError(reader), "");
  vtkPolyData* const lines = reader->GetOutput();
  CHECK_EQUAL(lines->GetNumberOfLines(), 2);
  CHECK_EQUAL(lines->GetNumberOfPoints(), 5);
  CHECK_EQUAL(lines->GetPoint(0)[0], 604321.25);
  CHECK_EQUAL(lines->GetPoint(0)[2], -1850.0);
  auto* const names = vtkStringArray::SafeDownCast(lines->GetCellData()->GetAbstractArray("FaultName"));
  CHECK(names && names->GetValue(0) == "F1" && names->GetValue(1) == "F2");
  std::ostringstream text;
  reader->Print(text);
  CHECK(Contains(text.str(), "FileName: " + path));
  CHECK(Contains(text.str(), "VerticalDirection: Automatic"));
  reader->SetVerticalDirectionToUp();
  reader->Update();
  CHECK_EQUAL(lines->GetPoint(0)[2], 1850.0);
  reader->SetFileName(FileFixtures::WriteText(folder + "/up.txt", "1 2 -3 F1\n4 5 0 F1\n").c_str());
  for (const bool isDown : { false, true })
  {
    reader->SetVerticalDirection(isDown ? 0 : 2); // no z is positive
    CHECK_EQUAL(UpdateError(reader), "");
    CHECK_EQUAL(lines->GetPoint(0)[2], isDown ? 3.0 : -3.0);
  }

  reader->SetFileName(FileFixtures::WriteText(folder + "/plain.txt", "1 2 3\n4 5 6\n").c_str());
  CHECK_EQUAL(UpdateError(reader), "");
  CHECK_EQUAL(lines->GetCellData()->GetNumberOfArrays(), 0);
  const std::string wrong = FileFixtures::WriteText(folder + "/wrong.txt", "1 2 3\n4 5 six\n");
  reader->SetFileName(wrong.c_str());
  CHECK(Contains(UpdateError(reader), wrong + ": line 2: \"six\", expected a finite number, z"));
  CHECK_EQUAL(lines->GetNumberOfPoints(), 0);
  reader->SetFileName((folder + "/missing.txt").c_str());
  CHECK(Contains(UpdateError(reader), "/missing.txt: "));
  return Check::Result();
}
