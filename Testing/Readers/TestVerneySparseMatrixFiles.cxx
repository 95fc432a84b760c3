// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The reader of sparse-matrix files: those that it takes, those that are wrong or change, and its end by the user.

#include "SparseMatrixFixtures.h"
#include "Tools/Check.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkVerneySparseMatrixReader.h"

#include <filesystem>
#include <string>

using namespace SparseMatrixFixtures;

namespace
{
void CanReadFileLooksAtTheHeader()
{
  vtkNew<vtkVerneySparseMatrixReader> reader;
  CHECK(reader->CanReadFile(WriteFile("header.txt", "2 2 10\n\n3 1 1 5 6.5\n").c_str()) == 1);
  CHECK(reader->CanReadFile(WriteFile("header.txt", "2 2 10\n\n3 1 1 5 6.5 4 1 1\n3 1").c_str()) == 0);
  CHECK(reader->CanReadFile(WriteFile("header.txt", "2 2 10\n\n3 1 1 5 6.5 4 1 1 2 2\n3 1").c_str()) == 1);
  CHECK(reader->CanReadFile(WriteFile("header.txt", "2 2 10\nwhatever").c_str()) == 0);
  CHECK(reader->CanReadFile(WriteFile("header.txt", "2 2 10\n10 1 1 5 6.5\n").c_str()) == 0); // no such index
  CHECK(reader->CanReadFile(WriteFile("header.txt", "\xEF\xBB\xBF 2 2 10\n3 1 1 5 6.5\n").c_str()) == 1);
  CHECK(reader->CanReadFile(WriteFile("header.txt", "2 2 10 4\n").c_str()) == 0);
  // Picks in whole metres and milliseconds, and by whole line numbers.
  CHECK(reader->CanReadFile(WriteFile("header.txt", "600000 6000000 1500\n600025 6000000 1501\n").c_str()) == 0);
  CHECK(reader->CanReadFile(WriteFile("header.txt", "100 200 1500\r\n100 201 1501.5\r\n").c_str()) == 0);
  CHECK(reader->CanReadFile(WriteFile("header.txt", "2 2\n").c_str()) == 0);
  CHECK(reader->CanReadFile(WriteFile("header.txt", "").c_str()) == 0);
  CHECK(reader->CanReadFile(Folder.c_str()) == 0);
  CHECK(reader->CanReadFile((Folder + "/missing.txt").c_str()) == 0);
  CHECK(reader->CanReadFile("vsm") == 0);
  CHECK(reader->CanReadFile(nullptr) == 0);
}

/// So that it is the reader that says what is wrong with them.
void CanReadFileTakesAllFilesOfItsName()
{
  vtkNew<vtkVerneySparseMatrixReader> reader;
  CHECK(reader->CanReadFile(WriteFile("empty.vsm", "").c_str()) == 1);
  CHECK(reader->CanReadFile(WriteFile("zipped.VSM", "\x1F\x8B\x08").c_str()) == 1);
  CHECK(reader->CanReadFile((Folder + "/missing.vSm").c_str()) == 1);
}

/// Checks that a path gives one error with its name, at each attempt, and takes the last result away.
void CheckRefused(const std::string& path, const std::string& message)
{
  vtkNew<vtkVerneySparseMatrixReader> reader;
  Messages errors(reader);
  reader->SetFileName(WriteFile("good.vsm", Small).c_str());
  reader->Update();
  CHECK(!IsEmpty(reader));
  reader->SetFileName(path.c_str());
  for (int attempt = 0; attempt < 2; ++attempt)
  {
    reader->Update();
    CHECK(errors.WasOne("): " + path + ": " + message));
    CHECK(IsEmpty(reader));
  }
}

void WrongFilesGiveOneErrorEach()
{
  CheckRefused(Folder + "/missing.vsm", "no such file");
  CheckRefused(Folder, "a directory, expected a file");
  CheckRefused(WriteFile("wrong.vsm", ""), "line 1: empty file, expected three positive integers \"nX nY nZ\"");
  CheckRefused(WriteFile("wrong.vsm", "1 1\n\n"), "line 1: header \"1 1\", expected three positive integers");
  CheckRefused(WriteFile("wrong.vsm", "1 1 5\n1 1 1 1 x\n"), "line 2: real z \"x\", expected a number");
  CheckRefused(
    WriteFile("wrong.vsm", "1 1 5\n5 1 1 1 1\n"), "line 2: vertical index \"5\", expected an integer from 0 to 4");
  CheckRefused(WriteFile("wrong.vsm", "1 1 5\n5 1 1\n"), "line 2: vertical index \"5\"");
  CheckRefused(WriteFile("wrong.vsm", "1 1 5\n4 1 1\n"), "line 2: 3 values, expected a multiple of 5");
  CheckRefused(WriteFile("wrong.vsm", "2 2 5\n\n\n"), "line 4: end of file after 3 columns, expected 4");
}

void MissingFileNameIsAnError()
{
  vtkNew<vtkVerneySparseMatrixReader> reader;
  Messages errors(reader);
  reader->Update();
  CHECK(errors.WasOne("no FileName, expected the path of a file"));
}

void FileThatTurnsWrongIsAnError()
{
  vtkNew<vtkVerneySparseMatrixReader> reader;
  Messages errors(reader);
  const std::string path = WriteFile("turning.vsm", Small);
  reader->SetFileName(path.c_str());
  reader->UpdateInformation();
  std::filesystem::remove(path);
  reader->Update();
  CHECK(errors.WasOne(path + ": no such file"));
  CHECK(IsEmpty(reader));
}

void FileIsScannedOnlyOnce()
{
  vtkNew<vtkVerneySparseMatrixReader> reader;
  const std::string path = WriteFile("once.vsm", Small);
  reader->SetFileName(path.c_str());
  reader->Update();
  CHECK(reader->GetOutput()->GetNumberOfPartitionedDataSets() == 2);
  int scans = 0;
  vtkNew<vtkCallbackCommand> counter;
  counter->SetClientData(&scans);
  counter->SetCallback([](vtkObject*, unsigned long, void* count, void*) { ++*static_cast<int*>(count); });
  reader->AddObserver(vtkCommand::ProgressEvent, counter);
  reader->Modified();
  reader->UpdateInformation();
  CHECK(scans == 0);
  WriteFile("once.vsm", "1 1 5\n1 33 1 1 1\n"); // another size, should the clock be coarse
  reader->Modified();
  reader->UpdateInformation();
  CHECK(scans > 0);
  CHECK(reader->GetNumberOfHorizons() == 1 && std::string(reader->GetHorizonName(0)) == "Horizon 33");
}

void AbortLeavesTheOutputEmpty()
{
  vtkNew<vtkVerneySparseMatrixReader> reader;
  Messages errors(reader);
  reader->SetFileName(WriteFile("small.vsm", Small).c_str());
  reader->Update();
  vtkNew<vtkCallbackCommand> aborter;
  aborter->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { vtkVerneySparseMatrixReader::SafeDownCast(caller)->SetAbortExecute(1); });
  const unsigned long tag = reader->AddObserver(vtkCommand::ProgressEvent, aborter);
  reader->Modified();
  reader->Update();
  CHECK(IsEmpty(reader));
  reader->SetFileName(WriteFile("other.vsm", "1 1 9\n1 7 1 1 1 2 8 1 1 1\n").c_str()); // to be scanned as well
  reader->Update();
  CHECK(IsEmpty(reader));
  reader->RemoveObserver(tag);
  reader->SetAbortExecute(0);
  reader->Modified();
  reader->Update();
  CHECK(reader->GetOutput()->GetNumberOfPartitionedDataSets() == 2);
}
}

int TestVerneySparseMatrixFiles(int argc, char* argv[])
{
  Folder = MakeFolder(argc, argv, "TestVerneySparseMatrixFiles");
  FileIsScannedOnlyOnce();
  WrongFilesGiveOneErrorEach();
  MissingFileNameIsAnError();
  FileThatTurnsWrongIsAnError();
  CanReadFileLooksAtTheHeader();
  CanReadFileTakesAllFilesOfItsName();
  AbortLeavesTheOutputEmpty();
  std::filesystem::remove_all(Folder);
  return Check::Result();
}
