// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkFaultLinesReader.h"

#include "Common/Horizon/DataModel.h"
#include "Common/Text/FileErrors.h"
#include "Common/Text/InputFile.h"
#include "Common/VTK/PipelineRequest.h"
#include "FaultLineFile.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <istream>
#include <memory>
#include <string>
#include <vector>

using namespace SeismicHorizons;

namespace
{
bool AreNegative(const std::vector<SpacePoint>& places)
{
  return std::none_of(places.begin(), places.end(), [](const SpacePoint& place) { return place.Z > 0.0; }) &&
    std::any_of(places.begin(), places.end(), [](const SpacePoint& place) { return place.Z < 0.0; });
}

void WriteLines(const FaultLineFile& file, double upwards, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const SpacePoint& place : file.Places)
  {
    points->InsertNextPoint(place.X, place.Y, file.IsUpright ? place.Z : upwards * place.Z);
  }
  vtkNew<vtkCellArray> cells;
  std::size_t start = 0;
  for (const std::size_t end : file.Ends)
  {
    cells->InsertNextCell(int(end - start));
    for (; start < end; ++start)
    {
      cells->InsertCellPoint(vtkIdType(start));
    }
  }
  output->SetPoints(points);
  output->SetLines(cells);
  if (std::any_of(file.Names.begin(), file.Names.end(), [](const std::string& name) { return !name.empty(); }))
  {
    vtkNew<vtkStringArray> names;
    names->SetName(CellArray::FaultName);
    for (const std::string& name : file.Names)
    {
      names->InsertNextValue(name);
    }
    output->GetCellData()->AddArray(names);
  }
}
}

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
          const bool isUp =
            this->VerticalDirection == Up || (this->VerticalDirection == Automatic && AreNegative(file.Places));
          WriteLines(file, isUp ? 1.0 : -1.0, output);
        });
      this->Files.Mark(info);
    },
    Ranks(), &this->ErrorCode);
}
