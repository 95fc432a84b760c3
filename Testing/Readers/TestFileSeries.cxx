// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Series of files, one for each time: what comes out of the readers at times, and their horizons, extents and errors.

#include "ReaderFixtures.h"
#include "SEGYCube/SEGYSample.h"
#include "Tools/Check.h"

#include "vtkCellData.h"
#include "vtkFaultLinesReader.h"
#include "vtkGOCADTSurfReader.h"
#include "vtkHorizonGridReader.h"
#include "vtkHorizonTextReader.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSEGYCubeReader.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"
#include "vtkVerneySparseMatrixReader.h"

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

using namespace ReaderFixtures;
using Pipeline = vtkStreamingDemandDrivenPipeline;

namespace
{
std::string Folder;

std::string Write(const std::string& name, const std::string& text)
{
  return WriteText(Folder + '/' + name, text);
}

/// A file of one horizon on 3 x 2 columns at a depth.
std::string Picks(const std::string& horizon, double z)
{
  std::string text = "Name,Inline,Crossline,Z\n";
  for (int line = 0; line < 6; ++line)
  {
    text += horizon + ',' + std::to_string(line / 3) + ',' + std::to_string(line % 3) + ',' + std::to_string(z) + '\n';
  }
  return text;
}

std::vector<double> TimesOf(vtkAlgorithm* reader)
{
  vtkInformation* const info = reader->GetOutputInformation(0);
  const double* const times = info->Get(Pipeline::TIME_STEPS());
  return times ? std::vector<double>(times, times + info->Length(Pipeline::TIME_STEPS())) : std::vector<double>();
}

double HeightOf(vtkHorizonTextReader* reader)
{
  return GetHorizon(reader, 0)->GetBounds()[4];
}

/// The last file whose time is not later; the first before all of them, and where the time is no number.
void OutputsAreThoseOfTheirTimes()
{
  vtkNew<vtkHorizonTextReader> reader;
  for (const int n : { 0, 1, 2 })
  {
    reader->AddFileName(Write("top" + std::to_string(n) + ".csv", Picks("Top", 10.0 * n + 5.0)).c_str());
  }
  reader->Update();
  CHECK(TimesOf(reader) == std::vector<double>({ 0.0, 1.0, 2.0 }));
  CHECK_EQUAL(HeightOf(reader), -5.0);
  const double huge = std::numeric_limits<double>::max();
  for (const auto& [time, height] : std::vector<std::pair<double, double>>(
         { { 2, -25 }, { 0, -5 }, { 1, -15 }, { 1.999, -15 }, { 7, -25 }, { -3, -5 }, { huge, -25 }, { -huge, -5 } }))
  {
    CHECK(reader->UpdateTimeStep(time));
    CHECK_EQUAL(HeightOf(reader), height);
  }
  reader->UpdateTimeStep(1.0);
  const vtkMTimeType made = reader->GetOutput()->GetMTime();
  reader->UpdateTimeStep(1.0);
  CHECK_EQUAL(reader->GetOutput()->GetMTime(), made);
  reader->UpdateTimeStep(vtkMath::Nan());
  CHECK_EQUAL(HeightOf(reader), -5.0);
}

/// A single file has no time, whatever there was before.
void NamesAreKept()
{
  vtkNew<vtkHorizonTextReader> reader;
  CHECK(reader->GetFileName() == nullptr);
  const std::string first = Write("first.csv", Picks("First", 1.0));
  const std::string second = Write("second.csv", Picks("Second", 2.0));
  reader->AddFileName(first.c_str());
  reader->AddFileName(nullptr);
  reader->AddFileName(second.c_str());
  CHECK_EQUAL(reader->GetNumberOfFileNames(), 2);
  CHECK_EQUAL(std::string(reader->GetFileName()), first);
  CHECK_EQUAL(std::string(reader->GetFileName(1)), second);
  CHECK(reader->GetFileName(2) == nullptr && reader->GetFileName(-1) == nullptr);
  reader->UpdateTimeStep(1.0);
  reader->SetFileName(first.c_str());
  CHECK_EQUAL(reader->GetNumberOfFileNames(), 1);
  const vtkMTimeType changed = reader->GetMTime();
  reader->SetFileName(first.c_str());
  CHECK_EQUAL(reader->GetMTime(), changed);
  reader->Update();
  CHECK(TimesOf(reader).empty());
  CHECK_EQUAL(HeightOf(reader), -1.0);
  Messages errors(reader);
  reader->ClearFileNames();
  reader->Update();
  CHECK(errors.WasOne("no FileName, expected the path of a file"));
  CHECK(IsEmpty(reader));
}

/// Each file has its own horizons, and a choice holds for all files that have the name.
void HorizonsAreThoseOfTheFile()
{
  vtkNew<vtkHorizonTextReader> reader;
  reader->AddFileName(Write("two.csv", Picks("Top", 1.0) + Picks("Base", 9.0).substr(24)).c_str());
  reader->AddFileName(Write("other.csv", Picks("Other", 3.0) + Picks("Base", 7.0).substr(24)).c_str());
  reader->UpdateTimeStep(0.0);
  CHECK_EQUAL(reader->GetNumberOfHorizons(), 2);
  CHECK_EQUAL(GetName(reader, 1), std::string("Base"));
  reader->SetHorizonStatus("Base", 0);
  reader->UpdateTimeStep(1.0);
  CHECK_EQUAL(reader->GetOutput()->GetNumberOfPartitionedDataSets(), 1u);
  CHECK_EQUAL(GetName(reader, 0), std::string("Other"));
  CHECK_EQUAL(std::string(reader->GetHorizonName(0)), std::string("Other"));
  reader->UpdateTimeStep(0.0);
  CHECK_EQUAL(reader->GetOutput()->GetNumberOfPartitionedDataSets(), 1u);
  CHECK_EQUAL(GetName(reader, 0), std::string("Top"));
}

/// A file that is wrong is one error at its time, and no other time suffers.
void WrongFileIsAnErrorAtItsTime()
{
  vtkNew<vtkHorizonTextReader> reader;
  reader->AddFileName(Write("right.csv", Picks("Top", 1.0)).c_str());
  reader->AddFileName((Folder + "/missing.csv").c_str());
  Messages errors(reader);
  reader->UpdateTimeStep(0.0);
  CHECK_EQUAL(errors.Number(), 0);
  CHECK(!reader->UpdateTimeStep(1.0));
  CHECK(errors.WasOne("missing.csv: no such file"));
  CHECK(IsEmpty(reader));
  CHECK(reader->UpdateTimeStep(0.0));
  CHECK_EQUAL(errors.Number(), 0);
  CHECK_EQUAL(HeightOf(reader), -1.0);
}

/// The cubes of a series may have extents of their own.
void ExtentsFollowTime()
{
  vtkNew<vtkSEGYCubeReader> cubes;
  SEGYSample::File file;
  cubes->AddFileName(Write("small.sgy", SEGYSample::Make(file)).c_str());
  file.Samples = 9;
  cubes->AddFileName(Write("deep.sgy", SEGYSample::Make(file)).c_str());
  for (const auto& [time, samples] : std::vector<std::pair<double, int>>({ { 0, 5 }, { 1, 9 }, { 0, 5 } }))
  {
    CHECK(cubes->UpdateTimeStep(time));
    CHECK_EQUAL(cubes->GetOutput()->GetDimensions()[2], samples);
    CHECK(cubes->GetOutput()->GetPointData()->GetScalars() != nullptr);
  }
}

/// Also where the time before was an error, and where horizons came as something else.
void VolumesFollowTime()
{
  vtkNew<vtkVerneySparseMatrixReader> reader;
  reader->AddFileName(Write("a.vsm", "2 1 4\n0 7 1 1 0\n\n").c_str());
  reader->AddFileName(Write("b.vsm", "3 1 4\n0 7 1 1 0\n\n\n").c_str());
  reader->AddFileName((Folder + "/missing.vsm").c_str());
  Messages errors(reader);
  const auto width = [&reader](double time)
  {
    CHECK(reader->UpdateTimeStep(time));
    return vtkImageData::SafeDownCast(reader->GetOutputDataObject(0))->GetDimensions()[0];
  };
  reader->SetOutputTypeToVolume();
  CHECK_EQUAL(width(1.0), 3);
  CHECK_EQUAL(width(0.0), 2);
  CHECK_EQUAL(width(1.0), 3);
  CHECK(!reader->UpdateTimeStep(2.0));
  CHECK(errors.WasOne("missing.vsm: no such file"));
  CHECK_EQUAL(width(0.0), 2);
  reader->SetOutputTypeToPoints();
  CHECK(reader->UpdateTimeStep(1.0));
  reader->SetOutputTypeToVolume();
  CHECK_EQUAL(width(1.0), 3);
}

/// Two files, of which the second is the one to get at time 1.
template <typename Reader>
void TakesSeries(const std::string& first, const std::string& second)
{
  vtkNew<Reader> reader;
  reader->AddFileName(first.c_str());
  reader->AddFileName(second.c_str());
  std::vector<double> highest;
  for (const double time : { 0.0, 1.0 })
  {
    CHECK(reader->UpdateTimeStep(time));
    vtkDataObject* const output = reader->GetOutputDataObject(0);
    auto* const horizons = vtkPartitionedDataSetCollection::SafeDownCast(output);
    auto* const data = vtkPolyData::SafeDownCast(horizons ? horizons->GetPartitionAsDataObject(0, 0) : output);
    highest.push_back(data->GetBounds()[5]);
  }
  CHECK(TimesOf(reader) == std::vector<double>({ 0.0, 1.0 }));
  CHECK_EQUAL(highest[0], -1.0);
  CHECK_EQUAL(highest[1], -2.0);
}

std::string Grid(const std::string& z)
{
  return "-996 2 25.0 25.0\n0 25 0 25\n2 0.0 0.0 0.0\n0 0 0 0 0 0 0\n" + z + ' ' + z + ' ' + z + ' ' + z + '\n';
}

std::string Surface(const std::string& z)
{
  return "GOCAD TSurf 1\nHEADER {\nname:Top\n}\nTFACE\nVRTX 1 0 0 " + z + "\nVRTX 2 1 0 " + z + "\nVRTX 3 0 1 " + z +
    "\nTRGL 1 2 3\nEND\n";
}

/// Fault lines of all files are read at once.
void JoinsFaultFiles()
{
  vtkNew<vtkFaultLinesReader> reader;
  reader->AddFileName(Write("1.txt", "0 0 1\n1 0 1\n").c_str());
  reader->AddFileName(Write("2.txt", "0 0 2 A\n1 0 2 A\n").c_str());
  reader->Update();
  CHECK(TimesOf(reader).empty());
  CHECK_EQUAL(reader->GetOutput()->GetNumberOfLines(), 2);
  auto* const names = vtkStringArray::SafeDownCast(reader->GetOutput()->GetCellData()->GetAbstractArray("FaultName"));
  CHECK(names && names->GetValue(0) == "1" && names->GetValue(1) == "A");
  CHECK_EQUAL(std::string(reader->GetDescription()),
    "1: X, Y, Z: 1 line, z 1 to 1 down\n2: X, Y, Z, Fault: 1 fault, 1 line, z 2 to 2 down");
}

void OtherReadersTakeSeries()
{
  TakesSeries<vtkHorizonGridReader>(Write("1.irap", Grid("1")), Write("2.irap", Grid("2")));
  TakesSeries<vtkGOCADTSurfReader>(Write("1.ts", Surface("-1")), Write("2.ts", Surface("-2")));
  TakesSeries<vtkVerneySparseMatrixReader>(Write("1.vsm", "1 1 4\n1 7 1 1 0\n"), Write("2.vsm", "1 1 4\n2 7 1 1 0\n"));
}
}

int TestFileSeries(int argc, char* argv[])
{
  Folder = MakeFolder(argc, argv, "TestFileSeries");
  OutputsAreThoseOfTheirTimes();
  NamesAreKept();
  HorizonsAreThoseOfTheFile();
  WrongFileIsAnErrorAtItsTime();
  ExtentsFollowTime();
  VolumesFollowTime();
  OtherReadersTakeSeries();
  JoinsFaultFiles();
  std::filesystem::remove_all(Folder);
  return Check::Result();
}
