// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonGridReader.h"

#include "Common/Base/Monitor.h"
#include "Common/Survey/GridPlacement.h"
#include "Common/Survey/NullValues.h"
#include "Common/Text/FileErrors.h"
#include "Common/Text/InputFile.h"
#include "GridReader.h"

#include "vtkObjectFactory.h"

#include <filesystem>
#include <istream>
#include <memory>
#include <optional>
#include <utility>

using namespace SeismicHorizons;

namespace
{
/// Some programs write the file name as the name of the horizon.
bool IsNameOf(const std::string& name, const std::string& fileName)
{
  return name == std::filesystem::u8path(fileName).filename().u8string();
}
}

// ---- The class ------------------------------------------------------------------------------------------------------
struct vtkHorizonGridReader::FileContent
{
  FileStamp Stamp;
  std::string NullValues;
  std::string Name;
  std::string Format;
  std::optional<HorizonGrid> Grid;
};

vtkStandardNewMacro(vtkHorizonGridReader);

//----------------------------------------------------------------------------------------------------------------------
vtkHorizonGridReader::vtkHorizonGridReader() = default;

//----------------------------------------------------------------------------------------------------------------------
vtkHorizonGridReader::~vtkHorizonGridReader()
{
  this->SetNullValues(nullptr);
}

//----------------------------------------------------------------------------------------------------------------------
int vtkHorizonGridReader::CanReadFile(const char* fileName)
{
  return IsRecognised(fileName, IsGrid);
}

//----------------------------------------------------------------------------------------------------------------------
/// The name may be anywhere in a file, so that listing horizons reads the whole file and keeps it.
std::vector<std::string> vtkHorizonGridReader::ListHorizons(const Monitor& monitor)
{
  RequireFileName(this->Files.GetCurrent());
  PrefixFileErrors(this->Files.GetCurrent(),
    [&]()
    {
      const FileStamp stamp = MakeFileStamp(this->Files.GetCurrent());
      const std::string nulls = this->NullValues ? this->NullValues : "";
      if (this->Content && this->Content->Stamp == stamp && this->Content->NullValues == nulls)
      {
        return;
      }
      this->Content.reset();
      auto content = std::make_unique<FileContent>();
      content->Stamp = stamp;
      content->NullValues = nulls;
      const std::unique_ptr<std::istream> stream = OpenInputFile(this->Files.GetCurrent());
      content->Grid = ReadHorizonGrid(*stream, monitor, GridBufferSize, SeismicHorizons::NullValues(nulls));
      const std::string& name = content->Grid->Name;
      content->Name =
        name.empty() || IsNameOf(name, this->Files.GetCurrent()) ? StemOf(this->Files.GetCurrent()) : name;
      content->Format = content->Grid->Format;
      this->Content = std::move(content);
    });
  return { this->Content->Name };
}

//----------------------------------------------------------------------------------------------------------------------
SurveyHorizons vtkHorizonGridReader::ReadSurvey(const Monitor& monitor)
{
  return PrefixFileErrors(this->Files.GetCurrent(),
    [&]()
    {
      const SeismicHorizons::NullValues nulls(this->Content->NullValues);
      if (std::optional<HorizonGrid> grid = std::exchange(this->Content->Grid, std::nullopt))
      {
        return PlaceGrid(std::move(*grid), nulls);
      }
      const std::unique_ptr<std::istream> stream = OpenInputFile(this->Files.GetCurrent());
      return PlaceGrid(ReadHorizonGrid(*stream, monitor, GridBufferSize, nulls), nulls);
    });
}

//----------------------------------------------------------------------------------------------------------------------
std::string vtkHorizonGridReader::DescribeFormat()
{
  return this->Content->Format;
}
