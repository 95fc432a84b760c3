// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The reader of SEG-Y cubes: the image it makes, its windows, its parameters, and its errors.

#include "ReaderFixtures.h"
#include "SEGYCube/SEGYSample.h"
#include "Tools/Check.h"

#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSEGYCubeReader.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <cstring>

using namespace ReaderFixtures;
using namespace SEGYSample;

namespace
{
std::string Folder;

vtkSmartPointer<vtkSEGYCubeReader> MakeReader(const std::string& bytes, const std::string& name = "cube.sgy")
{
  auto reader = vtkSmartPointer<vtkSEGYCubeReader>::New();
  reader->SetFileName(WriteText(Folder + '/' + name, bytes).c_str());
  return reader;
}

vtkSmartPointer<vtkSEGYCubeReader> MakeReader(const File& file)
{
  return MakeReader(Make(file));
}

template <typename Array>
Array* Get(vtkFieldData* data, const char* name)
{
  auto* const array = Array::SafeDownCast(data->GetAbstractArray(name));
  CHECK(array);
  return array;
}

std::string GetText(vtkFieldData* data, const char* name)
{
  auto* const array = vtkStringArray::SafeDownCast(data->GetAbstractArray(name));
  return array ? std::string(array->GetValue(0)) : std::string("(none)");
}

float AmplitudeAt(vtkImageData* image, int i, int j, int k)
{
  int ijk[3] = { i, j, k };
  return Get<vtkFloatArray>(image->GetPointData(), "Amplitude")->GetValue(image->ComputePointId(ijk));
}

/// A turned cube of which a trace is missing.
File TurnedFile()
{
  File file;
  file.X = [](const Trace& t) { return 450000.0 + 20.0 * (t.Crossline - 100) - 7.5 * (t.Inline - 10); };
  file.Y = [](const Trace& t) { return 6700000.0 + 15.0 * (t.Crossline - 100) + 10.0 * (t.Inline - 10); };
  for (Trace& trace : file.Traces)
  {
    trace.Delay = 20;
  }
  file.Traces.erase(file.Traces.begin() + 6);
  return file;
}

/// Amplitudes are those of the traces, and points where the traces are.
void ImagesAreInTheirPlace()
{
  const File file = TurnedFile();
  const auto reader = MakeReader(file);
  reader->Update();
  vtkImageData* const image = reader->GetOutput();
  CHECK_EQUAL(image->GetNumberOfPoints(), 60);
  CHECK(image->GetPointData()->GetScalars() == image->GetPointData()->GetArray("Amplitude"));
  auto* const map = Get<vtkDoubleArray>(image->GetFieldData(), "LatticeToWorld");
  for (const Trace& trace : file.Traces)
  {
    for (int k = 0; k < 5; ++k)
    {
      int ijk[3] = { trace.Crossline - 100, (trace.Inline - 10) / 2, k };
      CHECK_EQUAL(AmplitudeAt(image, ijk[0], ijk[1], k), float(Value(trace.Inline, trace.Crossline, k)));
      double point[3];
      image->GetPoint(image->ComputePointId(ijk), point);
      const double expected[3] = { file.X(trace), file.Y(trace), -20.0 - 4.0 * k };
      for (int axis = 0; axis < 3; ++axis)
      {
        CHECK(std::abs(point[axis] - expected[axis]) < 1e-6);
        const double* const row = map->GetPointer(4 * axis);
        const double mapped = row[0] * ijk[0] + row[1] * ijk[1] + row[2] * k + row[3];
        CHECK(std::abs(mapped - expected[axis]) < 1e-6);
      }
    }
  }
}

void MissingTracesAreHidden()
{
  const auto reader = MakeReader(TurnedFile());
  reader->Update();
  vtkImageData* const image = reader->GetOutput();
  auto* const ghosts = Get<vtkUnsignedCharArray>(image->GetPointData(), "vtkGhostType");
  for (vtkIdType point = 0; point < 60; ++point)
  {
    const bool isMissing = point % 12 == 6;
    CHECK_EQUAL(int(ghosts->GetValue(point)), isMissing ? int(vtkDataSetAttributes::HIDDENPOINT) : 0);
    CHECK_EQUAL(AmplitudeAt(image, 2, 1, 0), 0.0f);
  }
  reader->SetInlineRange(10, 11); // where nothing is missing
  reader->Update();
  CHECK(!image->GetPointData()->GetArray("vtkGhostType"));
}

void FieldDataDescribeTheSurvey()
{
  const auto reader = MakeReader(TurnedFile());
  reader->Update();
  vtkFieldData* const data = reader->GetOutput()->GetFieldData();
  auto* const dimensions = Get<vtkIntArray>(data, "LatticeDimensions");
  CHECK(dimensions->GetValue(0) == 4 && dimensions->GetValue(1) == 3 && dimensions->GetValue(2) == 5);
  auto* const lines = Get<vtkDoubleArray>(data, "LineNumbers");
  CHECK(lines->GetValue(0) == 10 && lines->GetValue(1) == 2 && lines->GetValue(2) == 100 && lines->GetValue(3) == 1);
  CHECK_EQUAL(Get<vtkIntArray>(data, "VerticalDirection")->GetValue(0), -1);
  CHECK(Get<vtkDoubleArray>(data, "ImageDeviation")->GetValue(0) < 1e-6);
  CHECK_EQUAL(GetText(data, "VerticalUnit"), std::string("ms"));
  CHECK_EQUAL(GetText(data, "VerticalDomain"), std::string("time"));
  CHECK_EQUAL(GetText(data, "HorizontalUnit"), std::string("m"));
  CHECK_EQUAL(GetText(data, "CoordinateSystem"), std::string("(none)"));
  CHECK_EQUAL(Get<vtkStringArray>(data, "TextHeader")->GetNumberOfValues(), 40);
  CHECK_EQUAL(GetText(data, "TextHeader"), std::string("C1 LINE OF TEXT"));
  reader->SetVerticalUnit("feet");
  reader->SetHorizontalUnit("ft");
  reader->SetCoordinateSystem("UTM31");
  reader->SetVerticalDirectionToUp();
  reader->Update();
  CHECK_EQUAL(GetText(data, "VerticalUnit"), std::string("ft"));
  CHECK_EQUAL(GetText(data, "VerticalDomain"), std::string("depth"));
  CHECK_EQUAL(GetText(data, "HorizontalUnit"), std::string("ft"));
  CHECK_EQUAL(GetText(data, "CoordinateSystem"), std::string("UTM31"));
  CHECK_EQUAL(reader->GetOutput()->GetPoint(59)[2], 36.0);
}

void TheDescriptionTellsWhatWasFound()
{
  const auto reader = MakeReader(TurnedFile());
  CHECK_EQUAL(std::string(reader->GetDescription()), std::string());
  reader->UpdateInformation();
  const std::string text = reader->GetDescription();
  for (const char* part :
    { "SEG-Y revision 1, IBM float, big-endian, text in EBCDIC\n11 traces of 5 samples\n",
      "3 inlines 10 to 14 in steps of 2 (byte 189)\n4 crosslines 100 to 103 in steps of 1 (byte 193)\n",
      "sorted by inlines; 1 traces missing, 0 dead\nx and y at bytes 181 and 185: from (450000, 6700000) in steps of "
      "(20, 15) along crosslines' numbers and (-15, 20) along inlines'",
      "5 vertical indices from 20 in steps of 4" })
  {
    CHECK(text.find(part) != std::string::npos || (std::cerr << text, false));
  }
}

/// Windows are in the indices of the whole cube, and so are parts that are asked for downstream.
void WindowsArePartsOfTheCube()
{
  const auto reader = MakeReader(TurnedFile());
  reader->SetInlineRange(11, 14);
  reader->SetCrosslineRange(101, 102);
  reader->SetSampleRange(2, 3);
  reader->Update();
  vtkImageData* const image = reader->GetOutput();
  const int* const extent = image->GetExtent();
  const int expected[6] = { 1, 2, 1, 2, 2, 3 };
  CHECK(std::equal(extent, extent + 6, expected));
  CHECK_EQUAL(AmplitudeAt(image, 2, 2, 3), float(Value(14, 102, 3)));
  CHECK(std::abs(image->GetPoint(0)[0] - (450000.0 + 20.0 - 15.0)) < 1e-6);
  CHECK_EQUAL(Get<vtkIntArray>(image->GetFieldData(), "LatticeDimensions")->GetValue(2), 5);

  const auto whole = MakeReader(TurnedFile());
  whole->UpdateInformation();
  const int part[6] = { 2, 3, 0, 1, 1, 1 };
  whole->UpdateExtent(part);
  const int* const got = whole->GetOutput()->GetExtent();
  CHECK(std::equal(got, got + 6, part));
  CHECK_EQUAL(AmplitudeAt(whole->GetOutput(), 3, 1, 1), float(Value(12, 103, 1)));
}

void ThreadsDoNotMatter()
{
  const auto read = [](int threads)
  {
    const auto reader = MakeReader(TurnedFile());
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads, "STDThread", false }, [&]() { reader->Update(); });
    vtkSmartPointer<vtkImageData> image = reader->GetOutput();
    return image;
  };
  const auto one = read(1);
  const auto two = read(2);
  const auto* const a = Get<vtkFloatArray>(one->GetPointData(), "Amplitude")->GetPointer(0);
  const auto* const b = Get<vtkFloatArray>(two->GetPointData(), "Amplitude")->GetPointer(0);
  CHECK_EQUAL(std::memcmp(a, b, 60 * sizeof(float)), 0);
}

void FilesThatChangeAreReadAgain()
{
  File file;
  const auto reader = MakeReader(file);
  reader->Update();
  CHECK_EQUAL(reader->GetOutput()->GetNumberOfPoints(), 60);
  file.Traces.resize(8);
  MakeReader(file);
  reader->Modified();
  reader->Update();
  CHECK_EQUAL(reader->GetOutput()->GetNumberOfPoints(), 40);
  reader->SetInlineByte(193);
  reader->SetCrosslineByte(189);
  reader->Update();
  CHECK_EQUAL(reader->GetOutput()->GetDimensions()[0], 2);
}

void CanReadFileLooksInside()
{
  vtkNew<vtkSEGYCubeReader> reader;
  CHECK_EQUAL(reader->CanReadFile(WriteText(Folder + "/any.dat", Make(File())).c_str()), 1);
  CHECK_EQUAL(reader->CanReadFile(WriteText(Folder + "/text.sgy", std::string(9999, 'A')).c_str()), 0);
  CHECK_EQUAL(reader->CanReadFile(WriteText(Folder + "/empty.sgy", "").c_str()), 0);
  CHECK_EQUAL(reader->CanReadFile((Folder + "/absent.sgy").c_str()), 0);
  CHECK_EQUAL(reader->CanReadFile(Folder.c_str()), 0);
  CHECK_EQUAL(reader->CanReadFile(nullptr), 0);
}

// ---- Errors and warnings -----------------------------------------------------------------------------------------
template <typename Change>
void Refuses(const File& file, const std::string& text, Change&& change)
{
  const auto reader = MakeReader(file);
  reader->Update();
  Messages errors(reader);
  change(reader.Get());
  reader->Update();
  CHECK(errors.WasOne(text));
  CHECK_EQUAL(reader->GetOutput()->GetNumberOfPoints(), 0);
}

void WrongParametersAreErrors()
{
  using Reader = vtkSEGYCubeReader*;
  const File file;
  Refuses(file, "no FileName, expected the path of a file", [](Reader r) { r->SetFileName(nullptr); });
  Refuses(file, "absent.sgy: no such file", [](Reader r) { r->SetFileName("absent.sgy"); });
  Refuses(file, "InlineByte 5 with CrosslineByte 0", [](Reader r) { r->SetInlineByte(5); });
  Refuses(file, "ImageTolerance -1, expected at least 0 columns", [](Reader r) { r->SetImageTolerance(-1.0); });
  Refuses(file, "LatticeTolerance 0, expected", [](Reader r) { r->SetLatticeTolerance(0.0); });
  Refuses(file, "VerticalStep -4, expected", [](Reader r) { r->SetVerticalStep(-4.0); });
  Refuses(file, "format code 9, expected", [](Reader r) { r->SetSampleFormat(9); });
  Refuses(file, "cube.sgy: InlineRange 1 to 2, expected some", [](Reader r) { r->SetInlineRange(1, 2); });
  Refuses(file, "cube.sgy: SampleRange 9 to -1, expected", [](Reader r) { r->SetSampleRange(9, -1); });
}

/// Lines at 80 degrees: an image of 4 x 3 columns is a tenth of one off.
void ShearedSurveysAreRefusedBeyondTheTolerance()
{
  File file;
  file.X = [](const Trace& t) { return 25.0 * (t.Crossline - 99) + 10.0 * (t.Inline - 10); };
  const auto reader = MakeReader(file);
  reader->Update();
  const double deviation = Get<vtkDoubleArray>(reader->GetOutput()->GetFieldData(), "ImageDeviation")->GetValue(0);
  CHECK(deviation > 0.1 && deviation < 0.5);
  Refuses(file, "that are not perpendicular, so that an image is up to 0.",
    [](vtkSEGYCubeReader* r) { r->SetImageTolerance(0.1); });
}

void WhatUsersShouldKnowIsAWarning()
{
  File file;
  file.X = [](const Trace& t) { return 25.0 * std::pow(t.Crossline - 99, 5.0); };
  const auto reader = MakeReader(file);
  Messages warnings(reader, vtkCommand::WarningEvent);
  reader->Update();
  CHECK(warnings.WasOne("line numbers stand for x and y"));
  CHECK_EQUAL(reader->GetOutput()->GetPoint(0)[0], 100.0);
  file = File();
  file.Format = SEGYFormat::IeeeFloat;
  std::string bytes = Make(file);
  bytes.replace(3600 + 240, 4, std::string("\x7f\xc0\0\0", 4));
  const auto damaged = MakeReader(bytes, "nan.sgy");
  Messages ofDamaged(damaged, vtkCommand::WarningEvent);
  damaged->Update();
  CHECK(ofDamaged.WasOne(
    "nan.sgy: 1 samples of 1e30 or more, or nan, are read as missing; if they are valid, set SampleFormat"));
}

void WorkStopsOnRequest()
{
  const auto reader = MakeReader(File());
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback(
    [](vtkObject* caller, unsigned long, void*, void*) { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
  reader->UpdateInformation();
  reader->AddObserver(vtkCommand::ProgressEvent, stop);
  Messages errors(reader);
  reader->Update();
  CHECK_EQUAL(reader->GetOutput()->GetNumberOfPoints(), 0);
}
}

int TestSEGYCubeReader(int argc, char* argv[])
{
  Folder = MakeFolder(argc, argv, "TestSEGYCubeReader");
  ImagesAreInTheirPlace();
  MissingTracesAreHidden();
  FieldDataDescribeTheSurvey();
  TheDescriptionTellsWhatWasFound();
  WindowsArePartsOfTheCube();
  ThreadsDoNotMatter();
  FilesThatChangeAreReadAgain();
  CanReadFileLooksInside();
  WrongParametersAreErrors();
  ShearedSurveysAreRefusedBeyondTheTolerance();
  WhatUsersShouldKnowIsAWarning();
  WorkStopsOnRequest();
  return Check::Result();
}
