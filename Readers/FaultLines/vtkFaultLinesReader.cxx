// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkFaultLinesReader.h"

#include "Common/Text/FileErrors.h"
#include "Common/Text/InputFile.h"
#include "Common/VTK/HorizonConversion.h"
#include "Common/VTK/PipelineRequest.h"
#include "FaultLineFile.h"
#include "FaultLineHorizon.h"
#include "Readers/HorizonText/HorizonTextParser.h"

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
vtkFaultLinesReader::~vtkFaultLinesReader()
{
  this->SetColumns(nullptr);
  this->SetNullValues(nullptr);
}

//----------------------------------------------------------------------------------------------------------------------
int vtkFaultLinesReader::CanReadFile(const char* fileName)
{
  const std::string extension = ExtensionOf(fileName ? fileName : "");
  const bool isOwn = extension == "pl" || extension == "pol" || extension == "flt" || extension == "dufault";
  return IsRecognised(fileName,
    [isOwn, &extension](std::istream& stream)
    { return isOwn || BeginsAsFaultLines(stream) || (IsFaultTable(stream) && !ArePicks(stream, extension)); });
}

//----------------------------------------------------------------------------------------------------------------------
int vtkFaultLinesReader::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkPolyData* const output = vtkPolyData::GetData(outputVector);
  this->Description.clear();
  return RunRequest(
    this, { output }, FilePrefix(this->Files.GetName(0)) + "more data than memory, expected a smaller file",
    [&](std::string&, const Monitor& monitor)
    {
      RequireFileName(this->Files.GetName(0));
      std::vector<std::string> paths;
      for (int n = 0; n < this->Files.GetSize(); ++n)
      {
        paths.emplace_back(this->Files.GetName(n));
      }
      const FaultTextOptions options = { this->Columns ? this->Columns : "", this->NullValues ? this->NullValues : "",
        this->HeaderLines };
      using Direction = SeismicHorizons::VerticalDirection;
      const auto direction = this->VerticalDirection == Automatic
        ? std::nullopt
        : std::optional<Direction>(this->VerticalDirection == Up ? Direction::Up : Direction::Down);
      const FaultLineData data = LoadFaultLines(paths, options, direction, monitor);
      ToVTK(data.Lines, output);
      this->Description = data.Description;
    },
    Ranks(), &this->ErrorCode);
}
