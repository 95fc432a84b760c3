// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkFaultLinesReader.h"

#include "Common/Text/FileErrors.h"
#include "Common/Text/InputFile.h"
#include "Common/VTK/HorizonConversion.h"
#include "Common/VTK/PipelineRequest.h"
#include "FaultLineFile.h"
#include "FaultLineHorizon.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <istream>
#include <memory>
#include <optional>
#include <string>

using namespace SeismicHorizons;

vtkStandardNewMacro(vtkFaultLinesReader);

//----------------------------------------------------------------------------------------------------------------------
vtkFaultLinesReader::vtkFaultLinesReader()
{
  this->SetNumberOfInputPorts(0);
}

//----------------------------------------------------------------------------------------------------------------------
vtkFaultLinesReader::~vtkFaultLinesReader() = default;

//----------------------------------------------------------------------------------------------------------------------
int vtkFaultLinesReader::CanReadFile(const char* fileName)
{
  const std::string extension = ExtensionOf(fileName ? fileName : "");
  const bool isOwn = extension == "pl" || extension == "pol" || extension == "flt";
  return IsRecognised(fileName, [isOwn](std::istream& stream) { return isOwn || BeginsAsFaultLines(stream); });
}

//----------------------------------------------------------------------------------------------------------------------
int vtkFaultLinesReader::RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  this->Files.Announce(outputVector->GetInformationObject(0));
  return 1;
}

//----------------------------------------------------------------------------------------------------------------------
int vtkFaultLinesReader::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkPolyData* const output = vtkPolyData::GetData(outputVector);
  vtkInformation* const info = outputVector->GetInformationObject(0);
  this->Files.Choose(info);
  return RunRequest(
    this, { output }, FilePrefix(this->Files.GetCurrent()) + "more data than memory, expected a smaller file",
    [&](std::string&, const Monitor& monitor)
    {
      RequireFileName(this->Files.GetCurrent());
      PrefixFileErrors(this->Files.GetCurrent(),
        [&]()
        {
          MakeFileStamp(this->Files.GetCurrent());
          const std::unique_ptr<std::istream> stream = OpenInputFile(this->Files.GetCurrent());
          const FaultLineFile file = ReadFaultLines(*stream, monitor);
          using Direction = SeismicHorizons::VerticalDirection;
          const auto direction = this->VerticalDirection == Automatic
            ? std::nullopt
            : std::optional<Direction>(this->VerticalDirection == Up ? Direction::Up : Direction::Down);
          ToVTK(MakeFaultLines(file, direction), output);
        });
      this->Files.Mark(info);
    },
    Ranks(), &this->ErrorCode);
}
