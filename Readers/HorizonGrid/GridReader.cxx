// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GridReader.h"

#include "Common/Text/LineErrors.h"
#include "GridBytes.h"
#include "GridParsers.h"
#include "GridText.h"
#include "HeaderFields.h"
#include "Readers/HorizonText/FieldGuess.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace SeismicHorizons
{
namespace
{
using namespace std::string_view_literals;

constexpr std::size_t RecognitionBytes = 16 * 1024;

struct GridFormat
{
  const char* Name;
  HorizonGrid (*ReadText)(GridText&); // Null for binary formats.
  HorizonGrid (*ReadBinary)(GridBytes&) = nullptr;
  ByteOrder Order = ByteOrder::BigEndian;
  std::string_view Signature = {}; // First bytes of the file; formats without are recognised by their lines.
};

constexpr GridFormat IrapText = { "IRAP classic ASCII grid", ReadIrapText };
constexpr GridFormat Zmap = { "ZMAP+ grid", ReadZmap };
constexpr GridFormat Cps3 = { "CPS-3 grid", ReadCps3 };
constexpr GridFormat EarthVision = { "EarthVision grid", ReadEarthVision };
constexpr GridFormat Gxf = { "GXF grid", ReadGxf };
constexpr GridFormat EsriGrid = { "Esri ASCII grid", ReadEsriGrid };

// An IRAP file begins with a Fortran record of 32 bytes whose first number is -996.
constexpr std::array<GridFormat, 5> SignedFormats = { {
  { "IRAP binary grid", nullptr, ReadIrapBinary, ByteOrder::BigEndian, "\0\0\0\x20\xFF\xFF\xFC\x1C"sv },
  { "STORM binary grid", nullptr, ReadStorm, ByteOrder::BigEndian, "STORMGRID_BINARY"sv },
  { "Surfer 6 text grid", ReadSurferText, nullptr, ByteOrder::BigEndian, "DSAA"sv },
  { "Surfer 6 binary grid", nullptr, ReadSurferBinary, ByteOrder::LittleEndian, "DSBB"sv },
  { "Surfer 7 grid", nullptr, ReadSurfer7, ByteOrder::LittleEndian, "DSRB"sv },
} };

const GridFormat* RecogniseFirstLine(std::string_view line)
{
  const std::vector<std::string> words = SplitAtBlanks(line);
  if (words[0] == "-996")
  {
    return &IrapText;
  }
  if (words[0] == "FSASCI")
  {
    return &Cps3;
  }
  // Longer lines are names of fields.
  if (words.size() <= 2 && (IsSameWord(words[0], "ncols") || IsSameWord(words[0], "nrows")))
  {
    return &EsriGrid;
  }
  const std::vector<std::string> fields = SplitAtCommas(line);
  const auto isGrid = [](const std::string& field) { return IsSameWord(field, "GRID"); };
  return line.front() == '@' && std::any_of(fields.begin(), fields.end(), isGrid) ? &Zmap : nullptr;
}

/// Points without column and row are no EarthVision grid.
const GridFormat* RecogniseLabels(const std::vector<std::string_view>& lines)
{
  bool hasColumn = false;
  bool hasRow = false;
  for (const std::string_view line : lines)
  {
    if (IsSameWord(line, "#POINTS") || IsSameWord(line, "#GRID"))
    {
      return &Gxf;
    }
    const std::vector<std::string> words = SplitAtBlanks(line);
    const bool isField = words.size() > 3 && words[0] == "#" && words[1] == "Field:";
    hasColumn = hasColumn || (isField && IsSameWord(words[3], "column"));
    hasRow = hasRow || (isField && IsSameWord(words[3], "row"));
  }
  return hasColumn && hasRow ? &EarthVision : nullptr;
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

const GridFormat* Recognise(std::string_view firstBytes)
{
  for (const GridFormat& format : SignedFormats)
  {
    if (StartsWith(firstBytes, format.Signature))
    {
      return &format;
    }
  }
  const std::vector<std::string_view> lines = FindLines(WithoutByteOrderMark(firstBytes));
  const GridFormat* const format = lines.empty() ? nullptr : RecogniseFirstLine(lines.front());
  return format ? format : RecogniseLabels(lines);
}

/// Throws InputError if the commas may separate thousands.
bool BeginsWithDecimalCommas(std::string_view beginning)
{
  TextLines lines = SplitLines(beginning.substr(0, beginning.rfind('\n') + 1));
  const auto isWithout = [](std::string_view line) { return line.find(',') == std::string_view::npos; };
  const auto first = std::find_if_not(lines.begin(), lines.end(), isWithout) - lines.begin();
  lines.erase(std::remove_if(lines.begin(), lines.end(), isWithout), lines.end());
  return !lines.empty() && beginning.find('.') == std::string_view::npos &&
    HaveDecimalCommas(lines, std::int64_t(first) + 1, 1);
}

const GridFormat& RequireFormat(const std::string& firstBytes)
{
  if (firstBytes.empty())
  {
    throw InputError("empty file, expected a grid");
  }
  if (const GridFormat* const format = Recognise(firstBytes))
  {
    return *format;
  }
  throw InputError("a file that begins with " + Quote(firstBytes.substr(0, firstBytes.find('\n'))) +
    ", expected a grid of IRAP, STORM, ZMAP+, CPS-3, EarthVision, Surfer, GXF or Esri");
}
}

//----------------------------------------------------------------------------------------------------------------------
bool IsGrid(std::istream& stream)
{
  return Recognise(PeekBytes(stream)) != nullptr;
}

//----------------------------------------------------------------------------------------------------------------------
HorizonGrid ReadHorizonGrid(
  std::istream& stream, const Monitor& monitor, std::size_t bufferSize, const NullValues& nulls)
{
  const std::string beginning = PeekBytes(stream);
  const GridFormat& format = RequireFormat(beginning);
  HorizonGrid grid;
  if (format.ReadText)
  {
    // Commas separate numbers in the other formats.
    const bool mayHaveCommas = format.ReadText != ReadZmap && format.ReadText != ReadCps3 && format.ReadText != ReadGxf;
    GridText text(stream, monitor, bufferSize, nulls, mayHaveCommas && BeginsWithDecimalCommas(beginning));
    grid = format.ReadText(text);
  }
  else
  {
    GridBytes bytes(stream, monitor, format.Order);
    grid = format.ReadBinary(bytes);
    bytes.ReadRest();
  }
  grid.Format = format.Name;
  return grid;
}
}
