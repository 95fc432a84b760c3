// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GridReader.h"

#include "Common/Text/LineErrors.h"
#include "GridParsers.h"
#include "HeaderFields.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace SeismicHorizons
{
namespace
{
using namespace std::string_view_literals;

constexpr std::array<std::pair<std::string_view, GridFormat>, 5> Signatures = { {
  { "\0\0\0\x20\xFF\xFF\xFC\x1C"sv, GridFormat::IrapBinary }, // A Fortran record of 32 bytes that begins with -996.
  { "STORMGRID_BINARY"sv, GridFormat::Storm },
  { "DSAA"sv, GridFormat::SurferText },
  { "DSBB"sv, GridFormat::SurferBinary },
  { "DSRB"sv, GridFormat::Surfer7 },
} };

bool IsZmapHeader(std::string_view line)
{
  if (line.front() != '@')
  {
    return false;
  }
  for (const std::string& field : SplitAtCommas(line))
  {
    if (IsSameWord(field, "GRID"))
    {
      return true;
    }
  }
  return false;
}

std::optional<GridFormat> RecogniseFirstLine(std::string_view line)
{
  const std::vector<std::string> words = SplitAtBlanks(line);
  if (words[0] == "-996")
  {
    return GridFormat::IrapText;
  }
  if (words[0] == "FSASCI")
  {
    return GridFormat::Cps3;
  }
  // Longer lines are names of fields.
  if (words.size() <= 2 && (IsSameWord(words[0], "ncols") || IsSameWord(words[0], "nrows")))
  {
    return GridFormat::EsriGrid;
  }
  return IsZmapHeader(line) ? std::optional(GridFormat::Zmap) : std::nullopt;
}

std::optional<GridFormat> RecogniseLabels(const std::vector<std::string_view>& lines)
{
  bool hasColumn = false;
  bool hasRow = false;
  for (const std::string_view line : lines)
  {
    if (IsSameWord(line, "#POINTS") || IsSameWord(line, "#GRID"))
    {
      return GridFormat::Gxf;
    }
    const std::vector<std::string> words = SplitAtBlanks(line);
    const bool isField = words.size() > 3 && words[0] == "#" && words[1] == "Field:";
    hasColumn = hasColumn || (isField && IsSameWord(words[3], "column"));
    hasRow = hasRow || (isField && IsSameWord(words[3], "row"));
  }
  return hasColumn && hasRow ? std::optional(GridFormat::EarthVision) : std::nullopt;
}

std::vector<std::string_view> FindLines(std::string_view text)
{
  std::vector<std::string_view> lines;
  for (std::size_t first = 0; first < text.size();)
  {
    const std::size_t last = std::min(text.find('\n', first), text.size());
    const std::string_view line = Trim(text.substr(first, last - first));
    if (!line.empty() && line.front() != '!')
    {
      lines.push_back(line);
    }
    first = last + 1;
  }
  return lines;
}

/// The first bytes; the stream is where it was.
std::string PeekBytes(std::istream& stream)
{
  const std::istream::pos_type start = stream.tellg();
  std::string bytes(RecognitionBytes, '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  stream.clear(stream.rdstate() & std::ios::badbit);
  stream.seekg(start);
  if (!stream)
  {
    throw InputError("reading failed, expected a grid");
  }
  return bytes;
}

GridFormat RequireFormat(const std::string& firstBytes)
{
  if (firstBytes.empty())
  {
    throw InputError("empty file, expected a grid");
  }
  if (const std::optional<GridFormat> format = RecogniseGrid(firstBytes))
  {
    return *format;
  }
  throw InputError("a file that begins with " + Quote(firstBytes.substr(0, firstBytes.find('\n'))) +
    ", expected a grid of IRAP, STORM, ZMAP+, CPS-3, EarthVision, Surfer, GXF or Esri");
}

HorizonGrid ReadFormat(GridFormat format, std::istream& stream, const Monitor& monitor, std::size_t bufferSize)
{
  const auto text = [&](auto read)
  {
    GridText lines(stream, monitor, bufferSize);
    return read(lines);
  };
  const auto binary = [&](ByteOrder order, auto read)
  {
    GridBytes bytes(stream, monitor, order);
    HorizonGrid grid = read(bytes);
    bytes.ReadRest();
    return grid;
  };
  switch (format)
  {
    case GridFormat::IrapText:
      return text(ReadIrapText);
    case GridFormat::IrapBinary:
      return binary(ByteOrder::BigEndian, ReadIrapBinary);
    case GridFormat::Storm:
      return binary(ByteOrder::BigEndian, ReadStorm);
    case GridFormat::Zmap:
      return text(ReadZmap);
    case GridFormat::Cps3:
      return text(ReadCps3);
    case GridFormat::EarthVision:
      return text(ReadEarthVision);
    case GridFormat::SurferText:
      return text(ReadSurferText);
    case GridFormat::SurferBinary:
      return binary(ByteOrder::LittleEndian, ReadSurferBinary);
    case GridFormat::Surfer7:
      return binary(ByteOrder::LittleEndian, ReadSurfer7);
    case GridFormat::Gxf:
      return text(ReadGxf);
    case GridFormat::EsriGrid:
      return text(ReadEsriGrid);
  }
  return {};
}
}

//----------------------------------------------------------------------------------------------------------------------
const char* FormatName(GridFormat format)
{
  switch (format)
  {
    case GridFormat::IrapText:
      return "IRAP classic ASCII grid";
    case GridFormat::IrapBinary:
      return "IRAP binary grid";
    case GridFormat::Storm:
      return "STORM binary grid";
    case GridFormat::Zmap:
      return "ZMAP+ grid";
    case GridFormat::Cps3:
      return "CPS-3 grid";
    case GridFormat::EarthVision:
      return "EarthVision grid";
    case GridFormat::SurferText:
      return "Surfer 6 text grid";
    case GridFormat::SurferBinary:
      return "Surfer 6 binary grid";
    case GridFormat::Surfer7:
      return "Surfer 7 grid";
    case GridFormat::Gxf:
      return "GXF grid";
    default:
      return "Esri ASCII grid";
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::optional<GridFormat> RecogniseGrid(std::string_view firstBytes)
{
  for (const auto& [signature, format] : Signatures)
  {
    if (firstBytes.substr(0, signature.size()) == signature)
    {
      return format;
    }
  }
  const std::vector<std::string_view> lines = FindLines(WithoutByteOrderMark(firstBytes));
  const std::optional<GridFormat> format = lines.empty() ? std::nullopt : RecogniseFirstLine(lines.front());
  return format ? format : RecogniseLabels(lines);
}

//----------------------------------------------------------------------------------------------------------------------
std::optional<GridFormat> RecogniseGrid(std::istream& stream)
{
  return RecogniseGrid(PeekBytes(stream));
}

//----------------------------------------------------------------------------------------------------------------------
HorizonGrid ReadHorizonGrid(std::istream& stream, const Monitor& monitor, std::size_t bufferSize)
{
  const GridFormat format = RequireFormat(PeekBytes(stream));
  HorizonGrid grid = ReadFormat(format, stream, monitor, bufferSize);
  grid.Format = FormatName(format);
  return grid;
}
}
