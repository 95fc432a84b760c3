// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The reader of SEG-Y cubes: what it makes of files that contradict themselves, and the second output.

#include "ReaderFixtures.h"
#include "SEGYCube/SEGYSample.h"
#include "Tools/Check.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSEGYCubeReader.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStructuredGrid.h"

#include <algorithm>
#include <cmath>

using namespace ReaderFixtures;
using namespace SEGYSample;

namespace
{
std::string Folder;

vtkSmartPointer<vtkSEGYCubeReader> MakeReader(const std::string& bytes)
{
  auto reader = vtkSmartPointer<vtkSEGYCubeReader>::New();
  reader->SetFileName(WriteText(Folder + "/odd.sgy", bytes).c_str());
  return reader;
}

float Amplitude(vtkDataSet* data, vtkIdType point)
{
  auto* const amplitude = vtkFloatArray::SafeDownCast(data->GetPointData()->GetArray("Amplitude"));
  return CHECK(amplitude) ? amplitude->GetValue(point) : 0.0f;
}

float AmplitudeAt(vtkImageData* image, int i, int j, int k)
{
  int ijk[3] = { i, j, k };
  return Amplitude(image, image->ComputePointId(ijk));
}

/// Each trace of a bent line is where it says, in the second output.
void BentLinesAreTheSecondOutput()
{
  File file;
  file.Traces.clear();
  for (int n = 0; n < 20; ++n)
  {
    file.Traces.push_back({ 7, 100 + n, 1, 8 });
  }
  file.X = [](const Trace& t) { return 1000.0 + 10.0 * (t.Crossline - 100); };
  file.Y = [](const Trace& t) { return 9000.0 + 10.0 * std::max(0, t.Crossline - 110); };
  const auto reader = MakeReader(Make(file));
  reader->SetCrosslineRange(105, 119);
  reader->SetSampleRange(1, 3);
  Messages warnings(reader, vtkCommand::WarningEvent);
  reader->Update();
  CHECK(warnings.WasOne("the second output has the traces of the line at their true positions"));
  auto* const line = vtkStructuredGrid::SafeDownCast(reader->GetOutputDataObject(1));
  if (!CHECK(line && line->GetNumberOfPoints() == 45))
  {
    return;
  }
  for (int i = 5; i < 20; ++i)
  {
    for (int k = 1; k <= 3; ++k)
    {
      const vtkIdType point = i - 5 + 15 * (k - 1);
      const double* const place = line->GetPoint(point);
      const Trace& trace = file.Traces[std::size_t(i)];
      CHECK(std::abs(place[0] - file.X(trace)) < 1e-6 && std::abs(place[1] - file.Y(trace)) < 1e-6);
      CHECK_EQUAL(place[2], -8.0 - 4.0 * k);
      CHECK_EQUAL(Amplitude(line, point), float(Value(7, 100 + i, k)));
    }
  }
  const auto parts = MakeReader(Make(file)); // a part of the second output alone
  const int part[6] = { 3, 8, 0, 0, 2, 2 };
  vtkNew<vtkInformation> request;
  request->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), part, 6);
  vtkNew<vtkInformationVector> requests;
  requests->SetInformationObject(0, vtkNew<vtkInformation>());
  requests->SetInformationObject(1, request);
  parts->Update(1, requests);
  line->ShallowCopy(parts->GetOutputDataObject(1));
  CHECK_EQUAL(line->GetNumberOfPoints(), 6);
  CHECK(std::abs(line->GetPoint(5)[0] - 1080.0) < 1e-6);
  MakeReader(Make(File()))->Update();
  reader->Modified(); // the same file name, now of a cube
  reader->SetCrosslineRange(0, -1);
  reader->SetSampleRange(0, -1);
  reader->Update();
  CHECK_EQUAL(reader->GetOutput()->GetNumberOfPoints(), 60);
  CHECK_EQUAL(vtkStructuredGrid::SafeDownCast(reader->GetOutputDataObject(1))->GetNumberOfPoints(), 0);
}

/// Each is passed on, and makes the file be read again.
void RemediesAreProperties()
{
  File file;
  file.Traces[5].Delay = 3;
  file.Traces.push_back(file.Traces[6]);
  file.Traces.back().Extra = 4;
  const std::string bytes = Make(file);
  const auto reader = MakeReader(bytes.substr(0, bytes.size() - 7) + std::string(260, '\0'));
  Messages errors(reader);
  const auto refuses = [&](const char* text)
  {
    reader->Update();
    CHECK(errors.WasOne(text));
  };
  refuses("NumberOfSamples");
  reader->SetIgnoreIncompleteTrace(true);
  reader->SetInlineByte(189);
  reader->SetCrosslineByte(193);
  refuses("set DuplicatePolicy");
  Messages warnings(reader, vtkCommand::WarningEvent);
  const auto middle = [&]()
  {
    reader->Update();
    CHECK_EQUAL(reader->GetOutput()->GetDimensions()[2], 5); // an interpolated trace has one less
    return AmplitudeAt(reader->GetOutput(), 2, 1, 2) - float(Value(12, 102, 2));
  };
  reader->SetDuplicatePolicyToFirst();
  CHECK_EQUAL(middle(), 0.0f);
  reader->SetDuplicatePolicyToLast();
  CHECK_EQUAL(middle(), 4.0f);
  reader->SetDuplicatePolicyToMean();
  CHECK_EQUAL(middle(), 2.0f);
  reader->SetDelayPolicyToNearest();
  reader->Update();
  CHECK_EQUAL(reader->GetOutput()->GetDimensions()[2], 6);
  CHECK_EQUAL(AmplitudeAt(reader->GetOutput(), 1, 1, 2), float(Value(12, 101, 1)));
  reader->SetNumberOfSamples(-1);
  refuses("NumberOfSamples -1, expected at least 1");
}
}

int TestSEGYCubeRemedies(int argc, char* argv[])
{
  Folder = MakeFolder(argc, argv, "TestSEGYCubeRemedies");
  BentLinesAreTheSecondOutput();
  RemediesAreProperties();
  return Check::Result();
}
