// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkSEGYCubeReader.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Monitor.h"
#include "Common/Base/Parameters.h"
#include "Common/Survey/Units.h"
#include "Common/Text/InputFile.h"
#include "Common/VTK/HorizonConversion.h"
#include "Common/VTK/ImageConversion.h"
#include "Common/VTK/PipelineRequest.h"
#include "SEGYImage.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStructuredGrid.h"

#include <algorithm>
#include <tuple>

using namespace SeismicHorizons;

namespace
{
void Announce(const CubeView& view, const CubeExtent& extent, vtkInformation* info)
{
  AnnounceImage(extent, view.Image, info);
  vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_FLOAT, 1);
}

/// The extent is empty unless the cube is a single line.
void AnnounceLine(const SEGYCube& cube, const CubeExtent& extent, vtkInformation* info)
{
  AnnounceExtent(cube.Places.empty() ? CubeExtent{ 0, -1, 0, -1, 0, -1 } : extent, info);
}

/// The line stays empty unless the cube is a single line.
void FillLine(
  const SEGYCube& cube, const CubeView& view, const CubeExtent& extent, vtkImageData* image, vtkStructuredGrid* line)
{
  if (cube.Places.empty() || image->GetNumberOfPoints() == 0)
  {
    return;
  }
  vtkNew<vtkPoints> points;
  points->SetData(vtkDataArray::SafeDownCast(ToVTK(PlaceLineSamples(cube, view.Frame, extent))));
  line->SetExtent(image->GetExtent());
  line->SetPoints(points);
  line->GetPointData()->ShallowCopy(image->GetPointData());
  line->GetFieldData()->ShallowCopy(image->GetFieldData());
}

bool AreSameOptions(const SEGYOptions& a, const SEGYOptions& b)
{
  const auto values = [](const SEGYOptions& o)
  {
    return std::tie(o.FormatCode, o.LineFields.First, o.LineFields.Second, o.PlaceFields.First, o.PlaceFields.Second,
      o.Tolerance, o.VerticalStep, o.Samples, o.IgnoreIncompleteTrace, o.Duplicates, o.Delays);
  };
  return values(a) == values(b);
}

std::string NoMemory(const char* fileName)
{
  return FilePrefix(fileName) + "more data than memory, expected a smaller InlineRange, CrosslineRange or SampleRange";
}
}

// ---- The class ------------------------------------------------------------------------------------------------------
struct vtkSEGYCubeReader::FileContent
{
  FileStamp Stamp;
  SEGYOptions Options;
  SEGYCube Cube;
};

vtkStandardNewMacro(vtkSEGYCubeReader);

//----------------------------------------------------------------------------------------------------------------------
vtkSEGYCubeReader::vtkSEGYCubeReader()
{
  this->SetNumberOfInputPorts(0);
  this->SetNumberOfOutputPorts(2);
}

//----------------------------------------------------------------------------------------------------------------------
vtkSEGYCubeReader::~vtkSEGYCubeReader()
{
  this->SetVerticalUnit(nullptr);
  this->SetVerticalDomain(nullptr);
  this->SetHorizontalUnit(nullptr);
  this->SetCoordinateSystem(nullptr);
}

//----------------------------------------------------------------------------------------------------------------------
int vtkSEGYCubeReader::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkImageData" : "vtkStructuredGrid");
  return 1;
}

//----------------------------------------------------------------------------------------------------------------------
int vtkSEGYCubeReader::CanReadFile(const char* fileName)
{
  return IsSEGYFile(fileName ? fileName : "");
}

//----------------------------------------------------------------------------------------------------------------------
SEGYOptions vtkSEGYCubeReader::MakeOptions() const
{
  SEGYOptions options;
  options.FormatCode = this->SampleFormat;
  options.LineFields = { this->InlineByte, this->CrosslineByte };
  options.PlaceFields = { this->XByte, this->YByte };
  options.Tolerance = this->LatticeTolerance;
  options.VerticalStep = this->VerticalStep;
  options.Samples = this->NumberOfSamples;
  options.IgnoreIncompleteTrace = this->IgnoreIncompleteTrace;
  options.Duplicates = DuplicateRule(this->DuplicatePolicy);
  options.Delays = DelayRule(this->DelayPolicy);
  return options;
}

//----------------------------------------------------------------------------------------------------------------------
SurveyDescription vtkSEGYCubeReader::MakeSurvey() const
{
  SurveyDescription survey = this->Content->Cube.Survey;
  OverrideSurvey(survey, this->VerticalUnit, this->VerticalDomain, this->HorizontalUnit, this->CoordinateSystem);
  return survey;
}

//----------------------------------------------------------------------------------------------------------------------
CubeView vtkSEGYCubeReader::MakeView() const
{
  using Direction = SeismicHorizons::VerticalDirection;
  return PrefixFileErrors(this->Files.GetCurrent(),
    [&]()
    {
      return MakeCubeView(this->Content->Cube, this->MakeSurvey(),
        this->VerticalDirection == Up ? Direction::Up : Direction::Down, this->ImageTolerance);
    });
}

//----------------------------------------------------------------------------------------------------------------------
void vtkSEGYCubeReader::UpdateContent(const Monitor& monitor)
{
  CheckSEGYOptions(this->MakeOptions());
  CheckAtLeast("ImageTolerance", this->ImageTolerance, 0.0, " columns");
  RequireFileName(this->Files.GetCurrent());
  PrefixFileErrors(this->Files.GetCurrent(),
    [&]()
    {
      const FileStamp stamp = MakeFileStamp(this->Files.GetCurrent());
      const SEGYOptions options = this->MakeOptions();
      if (this->Content && this->Content->Stamp == stamp && AreSameOptions(this->Content->Options, options))
      {
        return;
      }
      this->Content.reset();
      auto content = std::make_unique<FileContent>();
      content->Stamp = stamp;
      content->Options = options;
      content->Cube = ReadSEGYCube(this->Files.GetCurrent(), options, monitor);
      this->Content = std::move(content);
      if (!this->Content->Cube.Warnings.empty())
      {
        vtkWarningMacro(<< this->Files.GetCurrent() << ": " << WarningText(this->Content->Cube));
      }
    });
  this->Description = Describe(this->Content->Cube, this->MakeSurvey());
}

//----------------------------------------------------------------------------------------------------------------------
vtkTypeBool vtkSEGYCubeReader::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  // In a file series the request may be for another cube.
  return IsForTime(request) ? this->RequestInformation(request, inputVector, outputVector)
                            : this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

//----------------------------------------------------------------------------------------------------------------------
int vtkSEGYCubeReader::RequestInformation(
  vtkInformation* request, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* const info = outputVector->GetInformationObject(0);
  this->Files.Announce(info);
  return RunRequest(this, { vtkDataObject::GetData(outputVector) }, NoMemory(this->Files.GetCurrent()),
    AnnounceLater(request,
      WatchInformation(this, this->IsInformationStopped,
        [&](std::string&, const Monitor& monitor)
        {
          this->UpdateContent(monitor);
          const SEGYRanges ranges = { { this->InlineRange[0], this->InlineRange[1] },
            { this->CrosslineRange[0], this->CrosslineRange[1] }, { this->SampleRange[0], this->SampleRange[1] } };
          const CubeExtent extent =
            PrefixErrors(this->Files.GetCurrent(), [&]() { return FindExtent(this->Content->Cube, ranges); });
          Announce(this->MakeView(), extent, info);
          AnnounceLine(this->Content->Cube, extent, outputVector->GetInformationObject(1));
        })),
    Ranks(), &this->ErrorCode);
}

//----------------------------------------------------------------------------------------------------------------------
int vtkSEGYCubeReader::RequestData(vtkInformation* request, vtkInformationVector**, vtkInformationVector* outputVector)
{
  // Both outputs share the extent of the requested port.
  const int port = std::max(0, request->Get(vtkExecutive::FROM_OUTPUT_PORT()));
  vtkImageData* const output = vtkImageData::GetData(outputVector);
  vtkStructuredGrid* const line = vtkStructuredGrid::GetData(outputVector, 1);
  vtkInformation* const info = outputVector->GetInformationObject(0);
  this->Files.Choose(info);
  return RunRequest(
    this, { output, line }, NoMemory(this->Files.GetCurrent()),
    [&](std::string&, const Monitor& monitor)
    {
      StopLikeInformation(this, this->IsInformationStopped);
      line->Initialize();
      output->Initialize(); // Otherwise an image keeps its scalars besides the new scalars.
      // The file may have changed since RequestInformation.
      this->UpdateContent(monitor.Step(0.0, 0.1));
      CubeExtent extent;
      outputVector->GetInformationObject(port)->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent.data());
      const CubeView view = this->MakeView();
      const CubeImage read = PrefixFileErrors(this->Files.GetCurrent(),
        [&]() { return ReadCubeImage(this->Content->Cube, view, extent, monitor.Step(0.1, 1.0)); });
      ToVTK(read.Image, output);
      FillLine(this->Content->Cube, view, extent, output, line);
      if (read.Nulls > 0)
      {
        vtkWarningMacro(<< this->Files.GetCurrent() << ": " << NullsText(read.Nulls));
      }
      this->Files.Mark(info);
    },
    Ranks(), &this->ErrorCode);
}
