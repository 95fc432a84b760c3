// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonTextReader.h"

#include "Common/Base/Monitor.h"
#include "Common/Text/FileErrors.h"
#include "Common/Text/InputFile.h"
#include "HorizonTextParser.h"

#include "vtkObjectFactory.h"
#include "vtkTimeStamp.h"

#include <cstdint>
#include <istream>
#include <memory>
#include <optional>
#include <utility>

using namespace SeismicHorizons;

// ---- The class ---------------------------------------------------------------------------------------------------
struct vtkHorizonTextReader::FileContent
{
  FileStamp Stamp;
  vtkTimeStamp Time;
  TextOptions Options;
  TextLayout Layout;
  std::vector<std::string> Names;
  std::vector<std::int64_t> Sizes;
  std::int64_t OtherLines = 0;
  std::optional<PickTable> Picks; // Picks that were read for the names, kept until they are used.
};

vtkStandardNewMacro(vtkHorizonTextReader);

//----------------------------------------------------------------------------------------------------------------------
vtkHorizonTextReader::vtkHorizonTextReader()
{
  this->SetNullValues(DefaultNulls);
}

//----------------------------------------------------------------------------------------------------------------------
vtkHorizonTextReader::~vtkHorizonTextReader()
{
  this->SetColumns(nullptr);
  this->SetNullValues(nullptr);
  this->SetWhere(nullptr);
}

//----------------------------------------------------------------------------------------------------------------------
int vtkHorizonTextReader::CanReadFile(const char* fileName)
{
  return IsRecognised(fileName, [fileName](std::istream& stream) { return ArePicks(stream, ExtensionOf(fileName)); });
}

//----------------------------------------------------------------------------------------------------------------------
void vtkHorizonTextReader::UpdateContent(const Monitor& monitor)
{
  RequireFileName(this->Files.GetCurrent());
  if (this->Columns && *this->Columns)
  {
    ParseColumnList(this->Columns); // Refuses lists that no file can match.
  }
  PrefixFileErrors(this->Files.GetCurrent(),
    [&]()
    {
      const TextOptions options = { this->Columns ? this->Columns : "", this->NullValues ? this->NullValues : "",
        this->HeaderLines, this->Where ? this->Where : "" };
      const FileStamp stamp = MakeFileStamp(this->Files.GetCurrent());
      if (this->Content && this->Content->Stamp == stamp && this->Content->Options == options)
      {
        return;
      }
      this->Content.reset();
      auto content = std::make_unique<FileContent>();
      content->Stamp = stamp;
      content->Options = options;
      const std::unique_ptr<std::istream> stream = OpenInputFile(this->Files.GetCurrent());
      content->Layout = ReadTextLayout(*stream, options);
      content->Names = { content->Layout.HorizonName };
      if (content->Layout.HasNames())
      {
        content->Picks = SeismicHorizons::ReadPicks(*stream, content->Layout, monitor);
        content->Names = content->Picks->Names;
        content->OtherLines = content->Picks->OtherLines;
        content->Sizes = content->Picks->CountPicks();
      }
      for (std::string& name : content->Names)
      {
        name = name.empty() ? StemOf(this->Files.GetCurrent()) : name;
      }
      content->Time.Modified();
      this->Content = std::move(content);
    });
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::string> vtkHorizonTextReader::ListNames(const Monitor& monitor)
{
  this->UpdateContent(monitor);
  return this->Content->Names;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::int64_t> vtkHorizonTextReader::CountPicks()
{
  return this->Content->Sizes;
}

//----------------------------------------------------------------------------------------------------------------------
vtkMTimeType vtkHorizonTextReader::GetPickTime()
{
  return this->Content->Time.GetMTime();
}

//----------------------------------------------------------------------------------------------------------------------
PickTable vtkHorizonTextReader::ReadPicks(const Monitor& monitor)
{
  if (std::optional<PickTable> picks = std::exchange(this->Content->Picks, std::nullopt))
  {
    return std::move(*picks);
  }
  return PrefixFileErrors(this->Files.GetCurrent(),
    [&]()
    {
      const std::unique_ptr<std::istream> stream = OpenInputFile(this->Files.GetCurrent());
      PickTable picks = SeismicHorizons::ReadPicks(*stream, this->Content->Layout, monitor);
      this->Content->OtherLines = picks.OtherLines;
      return picks;
    });
}

//----------------------------------------------------------------------------------------------------------------------
std::string vtkHorizonTextReader::DescribeFormat()
{
  return this->Content->Layout.Describe(this->Content->OtherLines);
}
