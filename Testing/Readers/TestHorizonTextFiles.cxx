// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which files the reader of text files takes, and what it says to wrong ones.

#include "ReaderFixtures.h"
#include "Tools/Check.h"

#include "vtkHorizonTextReader.h"

#include <cstdlib>
#include <filesystem>
#include <string>

using namespace ReaderFixtures;

namespace
{
std::string Folder;

std::string WriteFile(const std::string& name, const std::string& text)
{
  return WriteText(Folder + "/" + name, text);
}

void WrongFilesGiveOneErrorEach()
{
  vtkNew<vtkHorizonTextReader> reader;
  Messages errors(reader);
  reader->Update();
  CHECK(errors.WasOne("no FileName, expected the path of a file"));
  reader->SetFileName((Folder + "/nothing.dat").c_str());
  reader->Update();
  CHECK(errors.WasOne("nothing.dat: no such file"));
  reader->SetFileName(Folder.c_str());
  reader->Update();
  CHECK(errors.WasOne(Folder + ": a directory, expected a file"));
  reader->SetFileName(WriteFile("wrong.dat", "1 2 3.5\n1 3 x\n").c_str());
  reader->Update();
  CHECK(errors.WasOne("wrong.dat: line 2: \"x\" as Z, expected a number"));
  CHECK(IsEmpty(reader));
  reader->SetFileName(WriteFile("line.dat", "1.5 2 3.5\n2.5 2 3.5\n3.5 2 4.5\n").c_str());
  reader->Update();
  CHECK(errors.WasOne("line.dat: "));
  reader->SetFileName(
    WriteFile("off.dat", "Name X Y IL XL Z\na 0 0 1 1 1\na 10 0 1 2 1\na 0 10 2 1 1\na 15 10 2 2 1\n").c_str());
  reader->Update();
  CHECK(errors.WasOne("off.dat: 1 of 4 picks off the lattice"));
}

void CanReadFileLooksInside()
{
  vtkNew<vtkHorizonTextReader> reader;
  const auto can = [&](const std::string& text)
  { return reader->CanReadFile(WriteFile("some.dat", text).c_str()) == 1; };
  CHECK(can("Name,X,Y,Inline,Crossline,Z\nTop,501250,6000200,100,8,10.5\nTop,501250,6000250,100,10,9\n"));
  CHECK(can("1 2 3.5\n1 3 4.5\n"));
  CHECK(can("1.5 2 3.5\n1.5 3 4.5\n2.5 2 3.5\n2.5 3 1\n"));
  CHECK(can("Float Dip\n1.5 2 3.5 4\n"));
  CHECK(!can(""));
  CHECK(!can("Dear all,\nsee you at 10 o'clock\n"));
  CHECK(!can("2 2 10\n3 2 1.5 10 12.5 5 2 2.5 -20 20.5\n4 2 1 1 16\n")); // a sparse matrix
  CHECK(
    !can("-996 2 50.0 50.0\n1000.0 1100.0 5000.0 5050.0\n3 30.0 1000.0 5000.0\n0 0 0 0 0 0 0\n1 2 3 4 5 6\n")); // IRAP
  CHECK(!can("@top HEADER , GRID, 5\n15, -99999.0, , 4, 1\n3, 2, 0.0, 100.0, 0.0, 200.0\n0.0, 0.0, 0.0\n@\n 1 2 3\n"));
  CHECK(!can("DSAA\n3 2\n0 100\n0 50\n1 6\n1 2 3\n4 5 6\n"));
  CHECK(!can("FSASCI 0 1 COMPUTED 0 1.0E+30\nFSATTR 0 0\n1 2 3\n"));
  CHECK(!can("ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 10\n1 2 3\n4 5 6\n"));
  CHECK(!can("GOCAD TSurf 1\nHEADER {\nname: a\n}\nTFACE\nVRTX 1 0 0 0\n"));
  CHECK(!can("temperature,pressure,day\n1,2,3\n2,3,4\n"));
  const std::string scatter = "0.1 0.7 3\n0.35 0.2 4\n0.93 0.11 5\n0.42 0.87 1\n0.66 0.45 1\n0.71 0.93 2\n";
  CHECK(can(scatter)); // so that it says what is wrong
  CHECK(!reader->CanReadFile(WriteFile("some.txt", scatter).c_str())); // which may be any table
  CHECK(!reader->CanReadFile(nullptr) && !reader->CanReadFile(Folder.c_str()));
  CHECK(!reader->CanReadFile((Folder + "/nothing").c_str()));
}

/// Files of other programs, where there are any: by their extensions, which tell the formats of these.
void CanReadFileTakesRealFiles()
{
  const char* const folder = std::getenv("SEISMICHORIZONS_REAL_DATA");
  if (!folder || !std::filesystem::is_directory(folder))
  {
    return;
  }
  vtkNew<vtkHorizonTextReader> reader;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
  {
    const std::string extension = entry.path().extension().string();
    const bool isText = extension == ".ijz" || extension == ".dat" || extension == ".map";
    if (entry.is_regular_file() && !CHECK_EQUAL(reader->CanReadFile(entry.path().c_str()) == 1, isText))
    {
      std::cerr << entry.path() << '\n';
    }
  }
}
}

int TestHorizonTextFiles(int argc, char* argv[])
{
  Folder = MakeFolder(argc, argv, "TestHorizonTextFiles");
  WrongFilesGiveOneErrorEach();
  CanReadFileLooksInside();
  CanReadFileTakesRealFiles();
  std::filesystem::remove_all(Folder);
  return Check::Result();
}
